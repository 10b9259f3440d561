//! Does the process keep what the paper says of it? Costs never rise, a move is O(N), branches gather where their
//! arrangement has them, and stay where they were drawn.

use crate::measure::fastest;
use crate::table::{Aim, Row, Table};
use rayon::prelude::*;
use std::error::Error;
use std::f32::consts::PI;
use tree_model::ModelError;
use tree_model::silhouette::place::{
    Arranged, Arrangement, Domain, GibbsParams, arrange, privileged,
};
use tree_model::tree_core::{Control, Seed};

const ARRANGEMENTS: [(&str, Arrangement); 8] = [
    ("spread", Arrangement::Spread),
    ("spiral of 144", Arrangement::spiral()),
    ("spiral of 137.5", Arrangement::golden()),
    ("opposite", Arrangement::Opposite),
    ("decussate", Arrangement::Decussate),
    ("whorls of 3", Arrangement::Whorled { per_node: 3, turn: PI / 3.0 }),
    ("horizontal decussate", Arrangement::horizontal()),
    ("4 at a node, turned by 17", Arrangement::Custom { per_node: 4, turn: 0.3 }),
];
/// Branches: added ones only, and with a third drawn.
const NUMBERS: [usize; 6] = [12, 20, 40, 51, 80, 120];
const SEEDS: u64 = 10;
/// N of the times per move.
const SIZES: [usize; 4] = [50, 100, 200, 400];

/// Over all runs.
#[derive(Default)]
struct Sum {
    runs: u32,
    rises: u32,
    drawn: u32,
    outside: u32,
}

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    times(table)?;
    let mut sum = Sum::default();
    for (name, arrangement) in ARRANGEMENTS {
        for (what, share) in [("added branches", 0.0), ("a third drawn", 1.0 / 3.0)] {
            let (mut n_passed, mut n_tried) = (0_u32, 0_u32);
            let runs: Vec<(usize, u64)> =
                NUMBERS.iter().flat_map(|&n| (0..SEEDS).map(move |seed| (n, seed))).collect();
            let done = runs.par_iter().map(|&(n, seed)| {
                let domains = domains(n, (share * n as f32) as usize, Seed(seed));
                let arranged = run(&domains, &arrangement, GibbsParams::default(), seed);
                arranged.map(|arranged| (domains, arranged))
            });
            for (domains, arranged) in done.collect::<Result<Vec<_>, _>>()? {
                sum.take(&arranged, &domains);
                n_tried += 1;
                n_passed += u32::from(privileged(&arranged.sites, &arrangement).passes());
            }
            // What was drawn at places of its own has no pattern, nor is it even.
            let spread_drawn = !arrangement.has_pattern() && share > 0.0;
            table.row(&Row {
                case: &format!("{name}, {what}"),
                metric: if arrangement.has_pattern() {
                    "at privileged positions"
                } else {
                    "gather nowhere"
                },
                paper: None,
                peer: None,
                ours: 100.0 * f64::from(n_passed) / f64::from(n_tried),
                unit: "% of runs",
                aim: if spread_drawn { Aim::None } else { Aim::AtLeast(100.0) },
            });
        }
    }
    let mut row = |case: &str, metric: &str, ours: u32| {
        let aim = Aim::AtMost(0.0);
        table.row(&Row { case, metric, paper: None, peer: None, ours: ours.into(), unit: "", aim });
    };
    row(&format!("{} runs of all arrangements", sum.runs), "cost rises", sum.rises);
    row(&format!("{} sketched branches", sum.drawn), "outside their domain", sum.outside);
    Ok(())
}

impl Sum {
    fn take(&mut self, arranged: &Arranged, domains: &[Domain]) {
        self.runs += 1;
        self.rises += arranged.trace.windows(2).filter(|pair| pair[1] > pair[0]).count() as u32;
        for (site, domain) in arranged.sites.iter().zip(domains) {
            if *domain != Domain::default() {
                self.drawn += 1;
                self.outside += u32::from(!domain.contains(site.along, site.azimuth));
            }
        }
    }
}

/// `n` branches, of which so many were drawn, on either side.
fn domains(n: usize, n_drawn: usize, seed: Seed) -> Vec<Domain> {
    let drawn = (0..n_drawn as u64).map(|i| Domain::drawn(seed.stream("t").unit(i), i % 2 == 0));
    drawn.chain((n_drawn..n).map(|_| Domain::default())).collect()
}

fn run(
    domains: &[Domain],
    arrangement: &Arrangement,
    params: GibbsParams,
    seed: u64,
) -> Result<Arranged, ModelError> {
    arrange(domains, arrangement, &params, Seed(seed), &Control::default())
}

/// Time of a move: that of many moves, less that of none.
fn times(table: &mut Table) -> Result<(), Box<dyn Error>> {
    const MOVES: u32 = 20_000;
    let mut per_branch = Vec::new();
    for n in SIZES {
        let domains = domains(n, n / 3, Seed(1));
        let time = |moves: u32| {
            let params = GibbsParams { moves, quiet: 0.0, ..GibbsParams::default() };
            fastest(15, || run(&domains, &Arrangement::Decussate, params, 1))
        };
        let (many, arranged) = time(MOVES)?;
        let (none, _) = time(0)?;
        let nanoseconds = 1e9 * (many - none) / f64::from(arranged.moves);
        per_branch.push(nanoseconds / n as f64);
        table.row(&Row {
            case: &format!("Gibbs process of {n} branches"),
            metric: "time per move",
            paper: None,
            peer: None,
            ours: nanoseconds,
            unit: "ns",
            aim: Aim::None,
        });
    }
    table.row(&Row {
        case: "Gibbs process, 400 branches over 50",
        metric: "time per move and branch",
        paper: None,
        peer: None,
        ours: per_branch[SIZES.len() - 1] / per_branch[0],
        unit: "times",
        aim: Aim::AtMost(1.5),
    });
    Ok(())
}
