//! That what is drawn is kept: branches project onto the strokes, growth stays in the crown, branches do not run through each other.

use crate::measure::of_each;
use crate::table::{Aim, Row, Table};
use std::error::Error;
use tree_model::sketch::propagate::{PropagateParams, propagate};
use tree_model::sketch::session::{Session, SketchParams};
use tree_model::sketch::template::{
    EXEMPLAR_SEED, EXEMPLARS, MainBranchParams, main_branches, project,
};
use tree_model::sketch::{Branches, Drawing, Role, Stroke};
use tree_model::tree_core::glam::{Vec2, Vec3};
use tree_model::tree_core::{Control, Seed, Skeleton};

/// Where the exemplars are drawn from: between the views of the database.
const YAW: f32 = 0.2;

/// The worst over all drawings.
#[derive(Default)]
struct Worst {
    off_strokes: f64,
    off_branches: f64,
    through: u32,
    /// Of each drawing with a crown, the share of new length that is in it.
    inside: Vec<f64>,
}

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let of_all = of_each(&EXEMPLARS, |exemplar| {
        let tree = exemplar.tree(EXEMPLAR_SEED, &control)?;
        let branches = main_branches(tree.skeleton(), &MainBranchParams::default())?;
        let drawing = project(&branches, YAW, &super::crown_of(&tree, YAW));
        Worst::of(&drawing, &control)
    })?;
    let worst = of_all.into_iter().fold(Worst::default(), Worst::or);
    let mut row = |case: &str, metric: &str, ours: f64, unit: &str, aim: Aim| {
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit, aim });
    };
    let case = "drawings of all exemplars, worst";
    row(case, "branches off strokes", worst.off_strokes, "% height", Aim::AtMost(0.5));
    // What is drawn twice is merged, and ends that stick out are trimmed.
    row(case, "strokes off branches", worst.off_branches, "% height", Aim::None);
    row(case, "branches through others", f64::from(worst.through), "pairs", Aim::AtMost(0.0));
    let least = worst.inside.iter().copied().fold(f64::INFINITY, f64::min);
    let most = worst.inside.iter().copied().fold(0.0, f64::max);
    row(case, "new length in the crown", 100.0 * least, "%, least", Aim::AtLeast(99.0));
    row(case, "new length in the crown", 100.0 * most, "%, most", Aim::None);
    crosses(table, &control)
}

impl Worst {
    fn or(mut self, other: Self) -> Self {
        self.inside.extend(other.inside);
        Self {
            off_strokes: self.off_strokes.max(other.off_strokes),
            off_branches: self.off_branches.max(other.off_branches),
            through: self.through + other.through,
            inside: self.inside,
        }
    }

    fn of(drawing: &Drawing, control: &Control) -> Result<Self, Box<dyn Error>> {
        let mut session = Session::new(drawing.clone(), SketchParams::default(), Seed(1))?;
        let plan = session.cleaned(control)?.plan.clone();
        let inferred = session.inferred(control)?.clone();
        let grown = session.propagated(control)?.clone();
        let wood = session.wood(control)?.clone();
        let height = height_of(drawing);
        let lines: Vec<[Vec2; 2]> = drawing
            .strokes
            .iter()
            .filter(|stroke| stroke.role != Some(Role::Crown))
            .flat_map(|stroke| stroke.points.windows(2).map(|pair| [pair[0], pair[1]]))
            .collect();
        let segments = |branches: &Branches| {
            let first = usize::from(branches.has_imagined_root());
            (first..branches.len())
                .flat_map(|i| {
                    branches.points(i).windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()
                })
                .map(|line| line.map(|point| plan.to_drawing(point.truncate())))
                .collect::<Vec<[Vec2; 2]>>()
        };
        let ours = segments(&inferred.branches);
        let off = |points: &[Vec2], lines: &[[Vec2; 2]]| {
            let nearest = |&at: &Vec2| {
                lines.iter().map(|line| distance(at, line)).fold(f32::INFINITY, f32::min)
            };
            f64::from(100.0 * points.iter().map(nearest).fold(0.0, f32::max) / height)
        };
        let mut found = Self {
            off_strokes: off(&ours.concat(), &lines),
            off_branches: off(&lines.concat(), &ours),
            through: through_each_other(&inferred.branches, &wood),
            inside: Vec::new(),
        };
        if let Some(crown) = session.crown(control)? {
            let (mut inside, mut all) = (0.0, 0.0);
            for i in grown.n_sketched..grown.branches.len() {
                for pair in grown.branches.points(i).windows(2) {
                    /// Pieces in which a line is looked at.
                    const PIECES: u32 = 8;
                    for piece in 0..PIECES {
                        let at = pair[0].lerp(pair[1], (piece as f32 + 0.5) / PIECES as f32);
                        let length = f64::from(pair[0].distance(pair[1])) / f64::from(PIECES);
                        all += length;
                        inside += if crown.contains(at.truncate()) && crown.contains_3d(at) {
                            length
                        } else {
                            0.0
                        };
                    }
                }
            }
            if all > 0.0 {
                found.inside.push(inside / all);
            }
        }
        Ok(found)
    }
}

/// Two bows that cross in the drawing, one after the other: there is room in front and behind.
fn crosses(table: &mut Table, control: &Control) -> Result<(), Box<dyn Error>> {
    let line = |points: &[(f32, f32)]| {
        Stroke::of(Role::Branch, points.iter().map(|&(x, y)| Vec2::new(x, y)).collect())
    };
    let drawing = Drawing {
        strokes: vec![
            Stroke::of(Role::Trunk, vec![Vec2::new(50.0, 100.0), Vec2::new(50.0, 5.0)]),
            line(&[(50.0, 70.0), (70.0, 50.0), (75.0, 20.0)]),
            line(&[(50.0, 45.0), (65.0, 40.0), (90.0, 38.0)]),
            line(&[(50.0, 65.0), (30.0, 50.0), (20.0, 15.0)]),
            line(&[(50.0, 40.0), (30.0, 35.0), (10.0, 30.0)]),
            line(&[(50.0, 30.0), (30.0, 42.0), (12.0, 48.0)]),
        ],
    };
    let mut through = 0;
    for seed in 0..20 {
        let mut session = Session::new(drawing.clone(), SketchParams::default(), Seed(seed))?;
        let branches = session.inferred(control)?.branches.clone();
        through += through_each_other(&branches, &session.wood(control)?.clone());
    }
    let (case, metric) = ("bows that cross, 20 seeds", "branches through others");
    table.row(&Row {
        case,
        metric,
        paper: None,
        peer: None,
        ours: f64::from(through),
        unit: "pairs",
        aim: Aim::AtMost(0.0),
    });
    Ok(())
}

/// Pairs of sketched segments that run through each other away from where they join, as thick as in `wood`, whose
/// nodes begin with those of the sketch.
fn through_each_other(branches: &Branches, wood: &Skeleton) -> u32 {
    let n_drawn: usize = (0..branches.len()).map(|i| branches.points(i).len()).sum();
    let radius = |at: Vec3| {
        let nearest = wood
            .positions()
            .iter()
            .zip(wood.radii())
            .take(n_drawn)
            .min_by(|a, b| a.0.distance(at).total_cmp(&b.0.distance(at)));
        nearest.map_or(0.0, |(_, &radius)| radius)
    };
    let first = usize::from(branches.has_imagined_root());
    let thick: Vec<Vec<(Vec3, f32)>> = (0..branches.len())
        .map(|i| branches.points(i).iter().map(|&point| (point, radius(point))).collect())
        .collect();
    let mut n = 0;
    for a in first..branches.len() {
        for b in a + 1..branches.len() {
            n += u32::from(touch(branches, &thick, a, b));
        }
    }
    n
}

fn touch(branches: &Branches, thick: &[Vec<(Vec3, f32)>], a: usize, b: usize) -> bool {
    let fork = meeting_point(branches, a, b);
    let mut pairs = thick[a].windows(2).flat_map(|p| thick[b].windows(2).map(move |q| (p, q)));
    pairs.any(|(p, q)| {
        let (distance, s, t) = nearest([p[0].0, p[1].0], [q[0].0, q[1].0]);
        let radii = p[0].1.max(p[1].1) + q[0].1.max(q[1].1);
        // About the fork that they come from branches are one.
        let near = |at: Vec3| fork.is_some_and(|fork| at.distance(fork) < 4.0 * radii);
        distance < 0.9 * radii && !(near(p[0].0.lerp(p[1].0, s)) || near(q[0].0.lerp(q[1].0, t)))
    })
}

/// Where the ways from the base to two segments part, or where one bears the other.
fn meeting_point(branches: &Branches, a: usize, b: usize) -> Option<Vec3> {
    let (mut low, mut high) = (a, b);
    while low != high {
        if low < high {
            std::mem::swap(&mut low, &mut high);
        }
        low = *branches.parents().get(low).filter(|&&parent| (parent as usize) < low)? as usize;
    }
    // One above the other on the way: where the upper one's branch leaves the lower's end.
    Some(branches.end(low))
}

/// Distance of two lines, and where on them.
fn nearest(p: [Vec3; 2], q: [Vec3; 2]) -> (f32, f32, f32) {
    let (u, v, w) = (p[1] - p[0], q[1] - q[0], p[0] - q[0]);
    let (a, b, c, d, e) = (u.dot(u), u.dot(v), v.dot(v), u.dot(w), v.dot(w));
    let det = a * c - b * b;
    let mut s = if det > 1e-12 { ((b * e - c * d) / det).clamp(0.0, 1.0) } else { 0.0 };
    let t = if c > 1e-12 { ((b * s + e) / c).clamp(0.0, 1.0) } else { 0.0 };
    s = if a > 1e-12 { ((b * t - d) / a).clamp(0.0, 1.0) } else { 0.0 };
    ((p[0] + s * u).distance(q[0] + t * v), s, t)
}

fn distance(at: Vec2, &[from, to]: &[Vec2; 2]) -> f32 {
    let along = to - from;
    let share = ((at - from).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
    at.distance(from + share * along)
}

fn height_of(drawing: &Drawing) -> f32 {
    let ys = drawing.strokes.iter().flat_map(|stroke| stroke.points.iter().map(|point| point.y));
    let (low, high) =
        ys.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
    high - low
}

/// Kept here so that the rows and the times grow the same way.
pub(super) fn grow(
    session: &mut Session,
    params: &PropagateParams,
    control: &Control,
) -> Result<usize, Box<dyn Error>> {
    let inferred = session.inferred(control)?.clone();
    let crown = session.crown(control)?.cloned();
    let grown = propagate(
        &inferred.branches,
        &inferred.omega,
        crown.as_ref(),
        None,
        params,
        Seed(1),
        control,
    )?;
    Ok(grown.branches.len() - grown.n_sketched)
}
