//! Xu & Mould 2012: Table 1 (time against nodes and endpoints), Table 2 (twelve trees), the search
//! against petgraph's, growth of time with size, memory.

use crate::measure::{fastest, peak_bytes};
use crate::table::{Aim, Row, Table};
use petgraph::algo::dijkstra;
use petgraph::graph::{NodeIndex, UnGraph};
use std::error::Error;
use tree_core::glam::Vec3;
use tree_core::{Control, Seed, Volume};
use tree_model::path::graph::{Graph, Terrain};
use tree_model::path::nodes::strew;
use tree_model::path::search::{Routes, Scratch, search_with};
use tree_model::path::{Endpoints, Level, LinkParams, PRESETS, PathParams, PathTree};

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

const SEED: Seed = Seed(2012);

/// How many times faster than printed the issue asks for.
const SPEEDUP: f64 = 100.0;

/// A row of Table 1, and branchings that make as many endpoints.
struct Measured {
    case: &'static str,
    nodes: u64,
    endpoints: u64,
    seconds: f64,
    /// Endpoints of level 1, then of each subgraph level by level.
    branching: &'static [u32],
    /// Nodes of a subgraph.
    graph_nodes: u32,
}

const TABLE_1: [Measured; 3] = [
    // 15 + 135 + 1,080 + 8,640 + 25,920 = 35,790 endpoints of 9,871 graphs.
    Measured {
        case: "Fig. 12 (top left)",
        nodes: 351_810,
        endpoints: 34_740,
        seconds: 32.4,
        branching: &[15, 9, 8, 8, 3],
        graph_nodes: 36,
    },
    // 12 + 120 + 600 + 3,000 = 3,732 endpoints of 733 graphs.
    Measured {
        case: "Fig. 16",
        nodes: 84_755,
        endpoints: 3_732,
        seconds: 4.5,
        branching: &[12, 10, 5, 5],
        graph_nodes: 115,
    },
    // 6 + 36 + 216 + 1,296 + 7,776 = 9,330 endpoints of 1,555 graphs.
    Measured {
        case: "Fig. 18",
        nodes: 207_458,
        endpoints: 9_330,
        seconds: 20.0,
        branching: &[6, 6, 6, 6, 6],
        graph_nodes: 133,
    },
];

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    for row in &TABLE_1 {
        table_1(table, row)?;
    }
    table_2(table)?;
    scaling(table)?;
    for row in &TABLE_1 {
        let case = format!("{}: graphs of {} nodes", row.case, row.graph_nodes);
        search_against_petgraph(table, &case, row.graph_nodes, 64)?;
    }
    for row in &TABLE_1 {
        let case = format!("{}: one graph of {} nodes", row.case, row.nodes);
        search_against_petgraph(table, &case, row.nodes as u32, 1)?;
    }
    Ok(())
}

/// A dome on a trunk with the given branchings. `scale` multiplies the endpoints of level 1.
fn tree(branching: &[u32], graph_nodes: u32, scale: u32) -> Outcome<PathParams> {
    let trunk = Volume::cylinder(Vec3::ZERO, 2.2 * Vec3::Y, 0.4)?;
    let crown = Volume::sector(2.0 * Vec3::Y, Vec3::Y, 1.5, 4.0)?;
    let levels = branching[1..]
        .iter()
        .map(|&branching| Level { branching, graph_nodes, ..Level::default() })
        .collect();
    Ok(PathParams {
        volume: trunk.union(&crown)?,
        graph_nodes: 4000 * scale,
        endpoints: Endpoints {
            random: scale * branching[0],
            candidates: 1,
            ..Endpoints::default()
        },
        levels,
        leaves: None,
        ..PathParams::oak()?
    })
}

/// A tree of level 1 only, in one graph.
fn one_graph(graph_nodes: u32) -> Outcome<PathParams> {
    Ok(PathParams { graph_nodes, levels: Vec::new(), ..tree(TABLE_1[0].branching, 8, 1)? })
}

/// Grows the tree of a row of Table 1, or one graph of so many nodes, or nothing: for its memory.
pub(crate) fn grow_case(case: &str) -> Outcome {
    if let Some(row) = TABLE_1.iter().find(|row| row.case == case) {
        grow(&tree(row.branching, row.graph_nodes, 1)?)?;
    } else if let Ok(nodes) = case.parse() {
        grow(&one_graph(nodes)?)?;
    }
    Ok(())
}

fn grow(params: &PathParams) -> Outcome<PathTree> {
    Ok(params.grow(SEED, &Control::default())?)
}

fn table_1(table: &mut Table, row: &Measured) -> Outcome {
    let params = tree(row.branching, row.graph_nodes, 1)?;
    let peak = peak_bytes(row.case);
    let (seconds, grown) = fastest(7, || grow(&params))?;
    let graphs = grown.report.graphs();
    let mut figure = |metric, paper: Option<f64>, ours, unit, aim| {
        table.row(&Row { case: row.case, metric, paper, peer: None, ours, unit, aim });
    };
    let (nodes, endpoints) = (row.nodes as f64, row.endpoints as f64);
    figure("graph nodes", Some(nodes), graphs.n_nodes as f64, "nodes", Aim::AtLeast(nodes));
    let ours = grown.report.endpoints() as f64;
    figure("endpoints", Some(endpoints), ours, "endpoints", Aim::AtLeast(endpoints));
    figure(
        "time, graphs included",
        Some(row.seconds),
        seconds,
        "s",
        Aim::AtMost(row.seconds / SPEEDUP),
    );
    let speedup = row.seconds / seconds;
    figure("times faster than printed", None, speedup, "×", Aim::AtLeast(SPEEDUP));
    let per_node = 1e9 * seconds / graphs.n_nodes as f64;
    figure("time per graph node", None, per_node, "ns", Aim::None);
    if let Some(peak) = peak {
        let per_node = peak as f64 / graphs.n_nodes as f64;
        figure("peak memory per graph node", None, per_node, "bytes", Aim::None);
    }
    Ok(())
}

fn table_2(table: &mut Table) -> Outcome {
    for preset in PRESETS {
        let Some(paper) = preset.paper_seconds().map(f64::from) else {
            continue;
        };
        let params = preset.params()?;
        let (seconds, grown) = fastest(5, || grow(&params))?;
        let case = format!("Fig. 14 {}: {}", preset.name(), params.species.name);
        let mut figure = |metric, paper, ours, unit, aim| {
            table.row(&Row { case: &case, metric, paper, peer: None, ours, unit, aim });
        };
        figure("time, leaves included", Some(paper), seconds, "s", Aim::AtMost(paper / SPEEDUP));
        figure("graph nodes", None, grown.report.graphs().n_nodes as f64, "nodes", Aim::None);
        figure("skeleton nodes", None, grown.tree.skeleton().len() as f64, "nodes", Aim::None);
        figure("leaves", None, grown.tree.foliage().len() as f64, "leaves", Aim::None);
    }
    Ok(())
}

/// Time per node of a ten times larger tree, and of a ten times larger single graph.
fn scaling(table: &mut Table) -> Outcome {
    let row = &TABLE_1[0];
    let mut per_node = [0.0; 2];
    for (scale, per_node) in [1, 10].into_iter().zip(&mut per_node) {
        let params = tree(row.branching, row.graph_nodes, scale)?;
        let (seconds, grown) = fastest(if scale == 1 { 7 } else { 3 }, || grow(&params))?;
        let nodes = grown.report.graphs().n_nodes as f64;
        *per_node = 1e9 * seconds / nodes;
        let case = format!("a tree of {nodes} graph nodes");
        let ours = *per_node;
        table.row(&Row {
            case: &case,
            metric: "time per graph node",
            paper: None,
            peer: None,
            ours,
            unit: "ns",
            aim: Aim::None,
        });
    }
    let ours = per_node[1] / per_node[0];
    table.row(&Row {
        case: "trees of 3.5 million and 350,000",
        metric: "time per node, ratio",
        paper: None,
        peer: None,
        ours,
        unit: "×",
        aim: Aim::AtMost(1.3),
    });

    for (nodes, per_node) in [351_810, 3_518_100].into_iter().zip(&mut per_node) {
        let params = one_graph(nodes)?;
        let peak = peak_bytes(&nodes.to_string());
        let nodes = grow(&params)?.report.graphs().n_nodes as f64;
        let (seconds, _) = fastest(3, || grow(&params))?;
        *per_node = 1e9 * seconds / nodes;
        let case = format!("one graph of {nodes} nodes");
        let mut figure = |metric, ours, unit| {
            table.row(&Row {
                case: &case,
                metric,
                paper: None,
                peer: None,
                ours,
                unit,
                aim: Aim::None,
            });
        };
        figure("time per graph node", *per_node, "ns");
        if let Some(peak) = peak {
            figure("peak memory per graph node", peak as f64 / nodes, "bytes");
        }
    }
    let ours = per_node[1] / per_node[0];
    table.row(&Row {
        case: "graphs of 3.5 million and 350,000",
        metric: "time per node, ratio",
        paper: None,
        peer: None,
        ours,
        unit: "×",
        aim: Aim::AtMost(1.3),
    });
    Ok(())
}

/// Our search against petgraph's Dijkstra, both on one thread, on the same `n_graphs` graphs.
fn search_against_petgraph(table: &mut Table, case: &str, nodes: u32, n_graphs: u64) -> Outcome {
    let crown = Volume::sector(Vec3::ZERO, Vec3::Y, 0.942, 4.0)?;
    let control = Control::default();
    let mut graphs = Vec::new();
    for i in 0..n_graphs {
        let seed = SEED.child(i);
        let nodes = strew(&crown, None, nodes, &[Vec3::ZERO], seed, &control)?;
        let root = nodes.forced[0];
        graphs.push((
            Graph::link(&nodes, &LinkParams::default(), &Terrain::default(), seed, &control)?,
            root,
        ));
    }
    let theirs: Vec<_> = graphs
        .iter()
        .map(|(graph, root)| (petgraph_of(graph), NodeIndex::new(*root as usize)))
        .collect();

    // As the modeler does it: memory is reused from graph to graph.
    let mut routes = vec![Routes::default(); graphs.len()];
    let mut scratch = Scratch::default();
    let (our_seconds, ()) = fastest(7, || -> Outcome {
        for ((graph, root), routes) in graphs.iter().zip(&mut routes) {
            search_with(graph, *root, routes, &mut scratch, &control)?;
        }
        Ok(())
    })?;
    let (their_seconds, costs) = fastest(3, || -> Outcome<_> {
        Ok(theirs
            .iter()
            .map(|(graph, root)| dijkstra(graph, *root, None, |edge| *edge.weight()))
            .collect::<Vec<_>>())
    })?;
    let mut worst = 0.0_f64;
    for (routes, costs) in routes.iter().zip(&costs) {
        for (node, &cost) in costs {
            worst =
                worst.max((f64::from(routes.cost(node.index() as u32)) - f64::from(cost)).abs());
        }
    }
    let mut figure = |metric, peer, ours, unit, aim| {
        table.row(&Row { case, metric, paper: None, peer, ours, unit, aim });
    };
    figure("search", Some(1e3 * their_seconds), 1e3 * our_seconds, "ms", Aim::None);
    figure("times faster than petgraph", None, their_seconds / our_seconds, "×", Aim::AtLeast(5.0));
    figure("largest difference in cost", None, worst, "m", Aim::AtMost(0.0));
    Ok(())
}

fn petgraph_of(graph: &Graph) -> UnGraph<(), f32> {
    let mut theirs = UnGraph::with_capacity(graph.len(), graph.n_arcs() / 2);
    for _ in 0..graph.len() {
        theirs.add_node(());
    }
    for node in 0..graph.len() as u32 {
        for arc in graph.arcs(node).iter().filter(|arc| arc.to > node) {
            theirs.add_edge(
                NodeIndex::new(node as usize),
                NodeIndex::new(arc.to as usize),
                arc.cost,
            );
        }
    }
    theirs
}
