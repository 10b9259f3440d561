//! What growing a tree took.

use crate::border::Versioned;
use tree_model::path::{GraphStats, LevelReport, MAX_LEVELS, PathReport};

/// Rows for levels in a report: as many as there can be.
pub const TREE_PATH_REPORT_LEVELS: usize = 17;
const _: () = assert!(TREE_PATH_REPORT_LEVELS == MAX_LEVELS + 1);

/// What one level took, and what it left out.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_path_level_report {
    /// Graphs searched.
    pub n_graphs: u64,
    /// Nodes in them.
    pub n_graph_nodes: u64,
    /// Arcs in them: two for each edge.
    pub n_graph_arcs: u64,
    /// Nodes no path led to.
    pub n_stray_nodes: u64,
    /// Graphs that fell apart at the linking distance asked for and were linked again with a longer one.
    pub n_widened: u64,
    /// Bytes of the largest single graph.
    pub largest_bytes: u64,
    /// Endpoints reached.
    pub n_endpoints: u64,
    /// Random endpoints asked for that the graphs had no nodes for.
    pub n_missing: u64,
    /// Endpoints of the levels before from which nothing grew, because an obstacle left no room or a
    /// narrow subgraph did not hang together.
    pub n_stunted: u64,
    /// Endpoints of the level before whose lifespan had ended.
    pub n_ended: u64,
}

impl tree_path_level_report {
    fn of(report: &LevelReport) -> Self {
        let LevelReport { graphs, n_endpoints, n_missing, n_stunted, n_ended } = *report;
        Self { n_endpoints, n_missing, n_stunted, n_ended, ..Self::of_graphs(graphs) }
    }

    fn of_graphs(stats: GraphStats) -> Self {
        let GraphStats { n_graphs, n_nodes, n_arcs, n_stray_nodes, n_widened, largest_bytes } =
            stats;
        Self {
            n_graphs,
            n_graph_nodes: n_nodes,
            n_graph_arcs: n_arcs,
            n_stray_nodes,
            n_widened,
            largest_bytes,
            ..Self::default()
        }
    }
}

/// What growing a tree took, and what it left out.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_path_report {
    /// `sizeof(tree_path_report)`.
    pub struct_size: usize,
    /// All levels together, roots included.
    pub total: tree_path_level_report,
    /// Number of levels of the tree.
    pub n_levels: u64,
    /// Number of levels of its root system.
    pub n_root_levels: u64,
    /// A row for each level of the tree, the first for the base volume.
    pub levels: [tree_path_level_report; TREE_PATH_REPORT_LEVELS],
    /// A row for each level of its root system.
    pub root_levels: [tree_path_level_report; TREE_PATH_REPORT_LEVELS],
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_path_report {
    const NAME: &'static str = "tree_path_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            total: Default::default(),
            n_levels: 0,
            n_root_levels: 0,
            levels: [Default::default(); TREE_PATH_REPORT_LEVELS],
            root_levels: [Default::default(); TREE_PATH_REPORT_LEVELS],
        }
    }
}

impl tree_path_report {
    pub(super) fn of(report: &PathReport) -> Self {
        let all = || report.levels.iter().chain(&report.roots);
        let sum = |of: fn(&LevelReport) -> u64| all().map(of).sum();
        Self {
            total: tree_path_level_report {
                n_endpoints: report.endpoints(),
                n_missing: sum(|level| level.n_missing),
                n_stunted: sum(|level| level.n_stunted),
                n_ended: sum(|level| level.n_ended),
                ..tree_path_level_report::of_graphs(report.graphs())
            },
            n_levels: report.levels.len() as u64,
            n_root_levels: report.roots.len() as u64,
            levels: rows(&report.levels),
            root_levels: rows(&report.roots),
            ..Self::default_value()
        }
    }
}

fn rows(levels: &[LevelReport]) -> [tree_path_level_report; TREE_PATH_REPORT_LEVELS] {
    let mut rows = [Default::default(); TREE_PATH_REPORT_LEVELS];
    for (row, level) in rows.iter_mut().zip(levels) {
        *row = tree_path_level_report::of(level);
    }
    rows
}
