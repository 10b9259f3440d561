//! Round trip: exemplars are drawn from views the database does not hold, and reconstructed from the drawing.
//!
//! How often an exemplar is the best choice for its own drawing, and whether inferred depths give the divergence angles and
//! length ratios it has in space. Beside it what depths drawn at random, and none, would give.

use crate::measure::of_each;
use crate::statistics::{kolmogorov_smirnov, median};
use crate::table::{Aim, Row, Table};
use std::error::Error;
use tree_model::sketch::clean::{CleanParams, clean};
use tree_model::sketch::infer::{InferParams, infer};
use tree_model::sketch::template::{
    DrawnShape, EXEMPLAR_SEED, EXEMPLARS, Exemplar, MainBranchParams, SelectParams, Template,
    main_branches, project, seen_from, select,
};
use tree_model::sketch::{Branches, Label, Plan};
use tree_model::tree_core::glam::{Vec2, Vec3};
use tree_model::tree_core::{Control, NO_PARENT, Seed, seed};

/// Views on each exemplar, and how far the first is from any of the database, in radians.
const VIEWS: u32 = 8;
const FIRST: f32 = 0.19;

/// Why single exemplars miss.
const SCATTER: &str = "a drawing fixes the projection; depths come of the template's distribution alone, about which the few \
                       segments of one tree scatter";

/// Values of one quantity in the exemplar and in three reconstructions.
#[derive(Default)]
struct Values {
    exemplar: Vec<f64>,
    ours: Vec<f64>,
    random: Vec<f64>,
    flat: Vec<f64>,
}

/// Divergence angles in degrees of apical segments and laterals, and length ratios.
#[derive(Default)]
struct Trip {
    apical: Values,
    lateral: Values,
    ratio: Values,
    apical_ratio: Values,
    lateral_ratio: Values,
}

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let mut ranks = Vec::new();
    let trips = of_each(&EXEMPLARS, of_exemplar)?;
    for (exemplar, (mut trip, of_views)) in EXEMPLARS.iter().zip(trips) {
        trip.print(exemplar.name(), table);
        ranks.extend(of_views);
    }
    for (at, case) in ["selection, with crown", "selection, branches alone"].into_iter().enumerate()
    {
        let share = |within: usize| {
            let found = ranks.iter().filter(|rank| rank[at] < within).count();
            100.0 * found as f64 / ranks.len() as f64
        };
        row(table, case, "itself first", None, share(1), "%", Aim::AtLeast(90.0));
        row(table, case, "itself among three", None, share(3), "%", Aim::AtLeast(100.0));
    }
    Ok(())
}

/// Which choice an exemplar is for its own drawings, with a crown and without.
type Ranks = Vec<[usize; 2]>;

/// What comes back of an exemplar, and for each view which choice it is for its own drawing, with a crown and without.
fn of_exemplar(exemplar: &Exemplar) -> Result<(Trip, Ranks), Box<dyn Error>> {
    let control = Control::default();
    let templates = Template::builtin()?;
    let tree = exemplar.tree(EXEMPLAR_SEED, &control)?;
    let branches = main_branches(tree.skeleton(), &MainBranchParams::default())?;
    let own = templates.iter().position(|template| template.name == exemplar.name());
    let own = own.ok_or("an exemplar is not in the database")?;
    let (mut trip, mut ranks) = (Trip::default(), Vec::new());
    for view in 0..VIEWS {
        let yaw = FIRST + view as f32 * std::f32::consts::TAU / VIEWS as f32;
        let drawing = project(&branches, yaw, &super::crown_of(&tree, yaw));
        let params = CleanParams { merge: 0.0, snap: 0.004, ..CleanParams::default() };
        let cleaned = clean(&drawing, &params, &control)?;
        let rank = |crown: &[_]| -> Result<usize, Box<dyn Error>> {
            let drawn = DrawnShape::measure(&cleaned.plan, crown);
            let choices = select(&drawn, templates, &SelectParams::default())?;
            Ok(choices.iter().position(|choice| choice.template == own).unwrap_or(usize::MAX))
        };
        ranks.push([rank(&cleaned.crown.concat())?, rank(&[])?]);
        let plan = plan_of(&branches, yaw)?;
        trip.add(&branches, &plan, &templates[own], Seed(u64::from(view)))?;
    }
    Ok((trip, ranks))
}

/// The branches as they are seen from `yaw`, without a hand that draws them.
pub(super) fn plan_of(branches: &Branches, yaw: f32) -> Result<Plan, Box<dyn Error>> {
    let (mut positions, mut parents, mut strokes) = (Vec::new(), Vec::new(), Vec::new());
    let base = if branches.has_imagined_root() { branches.end(0) } else { branches.start(0) };
    let seen = |point: Vec3| seen_from(yaw, point) - seen_from(yaw, base);
    positions.push(seen(base));
    parents.push(NO_PARENT);
    strokes.push(0);
    let mut ends = vec![0_u32; branches.len()];
    let mut axes = vec![0_u32; branches.len()];
    for i in usize::from(branches.has_imagined_root())..branches.len() {
        let below = branches.parents()[i];
        let goes_on = branches.labels()[i] == Label::Apical;
        axes[i] = if goes_on && below != NO_PARENT { axes[below as usize] } else { i as u32 };
        let mut node = if below == NO_PARENT { 0 } else { ends[below as usize] };
        for &point in &branches.points(i)[1..] {
            positions.push(seen(point));
            parents.push(node);
            strokes.push(axes[i]);
            node = positions.len() as u32 - 1;
        }
        ends[i] = node;
    }
    Ok(Plan::from_columns(positions, parents, strokes, Vec2::ZERO, 1.0)?)
}

impl Trip {
    fn add(
        &mut self,
        exemplar: &Branches,
        plan: &Plan,
        template: &Template,
        seed: Seed,
    ) -> Result<(), Box<dyn Error>> {
        let params = InferParams { slenderness: template.slenderness, ..InferParams::default() };
        let inferred = infer(plan, &template.omega, &params, seed, &Control::default())?;
        let ours = &inferred.branches;
        let mut rng = seed.stream("random depth").rng();
        let ends: Vec<Vec3> = (0..ours.len()).map(|i| ours.end(i)).collect();
        let flat: Vec<Vec3> = ends.iter().map(|end| end.with_z(0.0)).collect();
        let mut random = flat.clone();
        for i in 1..ours.len() {
            let below = ours.parents()[i] as usize;
            let length = flat[i].distance(flat[below]);
            random[i].z = random[below].z + seed::uniform(&mut rng, -1.0, 1.0) * length;
        }
        self.take(exemplar, |branches, i| branches.end(i), |values| &mut values.exemplar);
        self.take(ours, |_, i| ends[i], |values| &mut values.ours);
        self.take(ours, |_, i| random[i], |values| &mut values.random);
        self.take(ours, |_, i| flat[i], |values| &mut values.flat);
        Ok(())
    }

    /// Measures every segment and its parent, with `end` for where segments end.
    fn take(
        &mut self,
        branches: &Branches,
        end: impl Fn(&Branches, usize) -> Vec3,
        list: impl Fn(&mut Values) -> &mut Vec<f64>,
    ) {
        let vector = |i: usize| {
            let start = if i == 0 {
                branches.start(0)
            } else {
                end(branches, branches.parents()[i] as usize)
            };
            end(branches, i) - start
        };
        for i in 1..branches.len() {
            let parent = branches.parents()[i] as usize;
            if branches.has_imagined_root() && parent == 0 {
                continue;
            }
            let (v, below) = (vector(i), vector(parent));
            if v.length() < 1e-6 || below.length() < 1e-6 {
                continue;
            }
            let angle = f64::from(v.angle_between(below)).to_degrees();
            let apical = branches.labels()[i] == Label::Apical;
            list(if apical { &mut self.apical } else { &mut self.lateral }).push(angle);
            let ratio = f64::from(v.length() / below.length());
            list(&mut self.ratio).push(ratio);
            list(if apical { &mut self.apical_ratio } else { &mut self.lateral_ratio }).push(ratio);
        }
    }

    fn print(&mut self, name: &str, table: &mut Table) {
        for (what, values, unit) in [
            ("apical angle", &mut self.apical, "°"),
            ("lateral angle", &mut self.lateral, "°"),
            ("length ratio", &mut self.ratio, "%"),
            ("apical ratio", &mut self.apical_ratio, "%"),
            ("lateral ratio", &mut self.lateral_ratio, "%"),
        ] {
            if values.exemplar.len() < 8 || values.ours.len() < 8 {
                continue;
            }
            let right = median(&values.exemplar);
            let off = |found: &[f64]| {
                let off = (median(found) - right).abs();
                if unit == "%" { 100.0 * off / right } else { off }
            };
            let (ours, flat, random) = (off(&values.ours), off(&values.flat), off(&values.random));
            let aim = Aim::AtMost(if unit == "%" { 10.0 } else { 5.0 });
            row(table, name, &format!("{what}: median off"), Some(flat), ours, unit, aim);
            row(table, name, &format!("{what}: off at random"), None, random, unit, Aim::None);
            let ks = |found: &[f64]| kolmogorov_smirnov(&values.exemplar, found);
            let (ours, flat, random) = (ks(&values.ours), ks(&values.flat), ks(&values.random));
            row(table, name, &format!("{what}: KS"), Some(flat), ours, "", Aim::AtMost(0.25));
            row(table, name, &format!("{what}: KS at random"), None, random, "", Aim::None);
        }
    }
}

fn row(
    table: &mut Table,
    case: &str,
    metric: &str,
    peer: Option<f64>,
    ours: f64,
    unit: &str,
    aim: Aim,
) {
    table.row_because(&Row { case, metric, paper: None, peer, ours, unit, aim }, SCATTER);
}
