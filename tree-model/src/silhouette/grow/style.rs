//! What others may copy of a system that was drawn (section 4.2).

use super::params::{GrowParams, Leaves, LevelParams};
use super::shapes::Form;
use crate::silhouette::branch::BranchingAngles;
use crate::silhouette::place::Arrangement;
use crate::silhouette::plan::{Lateral, Origin, Plan, System};

/// Spacing of leaves in leaf lengths where nothing tells.
const LEAF_SPACING: f32 = 0.25;
/// Bare share of a branch below its first leaf where nothing tells.
const LEAF_BARE: f32 = 0.1;
/// Angle of leaves where nothing tells.
const LEAF_ANGLE: f32 = 1.0;
/// Length of a leaf over that of the branch that bears it, where nothing tells.
const LEAF_LENGTH: f32 = 0.3;
/// So many sketched branches or fewer tell nothing about spacing.
const FEW: usize = 2;

/// The distances of branching points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spacing {
    /// In metres, whatever the length of the branch: mean and standard deviation.
    Absolute { mean: f32, sd: f32 },
    /// So many on every branch.
    Count(u32),
}

/// A branch that may be copied.
#[derive(Clone, Debug)]
pub(super) struct Exemplar {
    /// Where it was on its parent.
    pub(super) t: f32,
    /// Its form, an index into [`Styles::forms`].
    pub(super) form: u32,
    /// The style of its own branches, an index into [`Styles::styles`].
    pub(super) style: u32,
    /// Its span over the length of its parent.
    pub(super) ratio: f32,
}

/// What stands on an axis.
#[derive(Clone, Debug)]
pub(super) enum Bears {
    /// Copies of branches.
    Branches(Vec<Exemplar>),
    /// Leaves of so many metres.
    Leaves { length: f32 },
}

/// A style of branching.
#[derive(Clone, Debug)]
pub(super) struct Style {
    /// Share of the axis before the first branch.
    pub(super) bare: f32,
    pub(super) spacing: Spacing,
    pub(super) angles: BranchingAngles,
    /// Branches in space for each one that the spacing gives.
    pub(super) density: f32,
    pub(super) arrangement: Arrangement,
    pub(super) jitter: f32,
    pub(super) spiral: f32,
    pub(super) bears: Bears,
}

/// All forms and styles of a plan.
pub(super) struct Styles {
    pub(super) forms: Vec<Form>,
    pub(super) styles: Vec<Style>,
    /// Of each drawn system, by the branch that bears it: its style.
    of_branches: Vec<(u32, u32)>,
    /// Of each level of axes, the trunk's first: drawn systems by their place on their parent, and what stands in
    /// where none was drawn.
    levels: Vec<(Vec<(f32, u32)>, u32)>,
}

impl Styles {
    /// Measures a plan. `depth` is the number of levels of branches.
    pub(super) fn of(plan: &Plan, depth: u32, params: &GrowParams) -> Self {
        let mut styles = Self {
            forms: Vec::new(),
            styles: Vec::new(),
            of_branches: Vec::new(),
            levels: vec![(Vec::new(), 0); depth as usize + 1],
        };
        // From the finest level up: exemplars name the styles of their own branches.
        for level in (0..=depth).rev() {
            let mut drawn = Vec::new();
            drawn_at(plan, level, &mut drawn);
            styles.fallback(plan, level, depth, params);
            for (branch, system) in drawn {
                let style = styles.measure(plan, system, level, depth, params);
                let number = styles.add(style);
                if let Some(branch) = branch {
                    styles.of_branches.push((branch.id, number));
                    styles.levels[level as usize].0.push((branch.t, number));
                }
            }
        }
        styles
    }

    /// Length of leaves in metres; `None` where no style bears any.
    pub(super) fn leaf_length(&self) -> Option<f32> {
        self.styles.iter().find_map(|style| match style.bears {
            Bears::Leaves { length } => Some(length),
            Bears::Branches(_) => None,
        })
    }

    fn add(&mut self, style: Style) -> u32 {
        self.styles.push(style);
        self.styles.len() as u32 - 1
    }

    pub(super) fn add_form(&mut self, form: Form) -> u32 {
        self.forms.push(form);
        self.forms.len() as u32 - 1
    }

    /// The style for the branches on a lateral of a level: the one chosen for it, its own, or the nearest drawn.
    pub(super) fn for_lateral(&self, lateral: &Lateral, level: u32) -> u32 {
        let of = |id: u32| self.of_branches.iter().find(|&&(branch, _)| branch == id);
        let own = lateral.system.as_ref().and(of(lateral.id));
        let chosen = own.or(lateral.style.and_then(of));
        chosen.map_or_else(|| self.nearest(lateral.t, level), |&(_, style)| style)
    }

    /// The style of a level that was drawn nearest to a place on the parent.
    fn nearest(&self, t: f32, level: u32) -> u32 {
        let Some((drawn, fallback)) = self.levels.get(level as usize) else { return 0 };
        let nearest = drawn.iter().min_by(|a, b| (a.0 - t).abs().total_cmp(&(b.0 - t).abs()));
        nearest.map_or(*fallback, |&(_, style)| style)
    }

    /// What stands in where no system of a level was drawn: the branches of the next coarser level that was, or leaves.
    fn fallback(&mut self, plan: &Plan, level: u32, depth: u32, params: &GrowParams) {
        let rules = params.level(level);
        let style = if level == depth {
            leaf_style(plan, None, level, params)
        } else {
            let mut source = Vec::new();
            for coarser in (0..level).rev() {
                drawn_at(plan, coarser, &mut source);
                if !source.is_empty() {
                    break;
                }
            }
            let exemplars = source
                .iter()
                .flat_map(|(_, system)| {
                    system.laterals.iter().map(move |lateral| (system, lateral))
                })
                .filter_map(|(system, lateral)| self.exemplar(system, lateral, level + 1))
                .collect();
            undrawn_style(&rules, exemplars)
        };
        let number = self.add(style);
        self.levels[level as usize].1 = number;
    }

    /// The style of a drawn system.
    fn measure(
        &mut self,
        plan: &Plan,
        system: &System,
        level: u32,
        depth: u32,
        params: &GrowParams,
    ) -> Style {
        if level == depth {
            return leaf_style(plan, Some(system), level, params);
        }
        let rules = params.level(level);
        let exemplars: Vec<Exemplar> = system
            .laterals
            .iter()
            .filter_map(|lateral| self.exemplar(system, lateral, level + 1))
            .collect();
        let undrawn = undrawn_style(&rules, exemplars);
        Style {
            bare: bare(system).unwrap_or(undrawn.bare),
            spacing: spacing(system, |_| true).unwrap_or(undrawn.spacing),
            angles: system.angles.clone(),
            ..undrawn
        }
    }

    fn exemplar(&mut self, system: &System, lateral: &Lateral, level: u32) -> Option<Exemplar> {
        let form = Form::of(&lateral.shape()?);
        let style = self.for_lateral(lateral, level);
        let ratio = lateral.line.span().length() / system.axis.length();
        Some(Exemplar { t: lateral.t, form: self.add_form(form), style, ratio })
    }
}

/// All systems of a level that may be copied, with the branches that bear them.
fn drawn_at<'a>(plan: &'a Plan, level: u32, out: &mut Vec<(Option<&'a Lateral>, &'a System)>) {
    systems_at(&plan.system, None, level, out);
    for lender in &plan.lenders {
        if let (Some(inner), 1..) = (&lender.system, level) {
            systems_at(inner, Some(lender), level - 1, out);
        }
    }
}

/// All drawn systems of a level within one, with the branches that bear them.
fn systems_at<'a>(
    system: &'a System,
    branch: Option<&'a Lateral>,
    level: u32,
    out: &mut Vec<(Option<&'a Lateral>, &'a System)>,
) {
    if level == 0 {
        out.push((branch, system));
        return;
    }
    for lateral in &system.laterals {
        if let Some(inner) = &lateral.system {
            systems_at(inner, Some(lateral), level - 1, out);
        }
    }
}

fn undrawn_style(rules: &LevelParams, exemplars: Vec<Exemplar>) -> Style {
    Style {
        bare: 0.12,
        spacing: Spacing::Count(rules.count),
        angles: rules.angles.clone(),
        density: rules.density,
        arrangement: rules.arrangement,
        jitter: rules.jitter,
        spiral: rules.spiral,
        bears: Bears::Branches(exemplars),
    }
}

fn leaf_style(plan: &Plan, drawn: Option<&System>, level: u32, params: &GrowParams) -> Style {
    let leaves = params.leaves.clone().unwrap_or_default();
    let length = leaf_length(plan, &leaves);
    // What coverage added tells of gaps, not of leaves.
    let told =
        drawn.and_then(|system| spacing(system, |lateral| lateral.origin != Origin::Coverage));
    let mean = leaves.spacing.unwrap_or(LEAF_SPACING) * length;
    let given = Spacing::Absolute { mean, sd: 0.2 * mean };
    // What was drawn is in the plane; there are leaves all round.
    let density =
        if told.is_some() && leaves.spacing.is_none() { params.level(level).density } else { 0.0 };
    let angles = match (leaves.angle, drawn) {
        (None, Some(system)) => system.angles.clone(),
        (angle, _) => {
            let angle = angle.unwrap_or(LEAF_ANGLE);
            BranchingAngles::between(angle, angle)
        }
    };
    Style {
        bare: leaves.bare.or(drawn.and_then(bare)).unwrap_or(LEAF_BARE),
        spacing: told.filter(|_| leaves.spacing.is_none()).unwrap_or(given),
        angles,
        density,
        arrangement: leaves.arrangement,
        jitter: leaves.jitter,
        spiral: 0.0,
        bears: Bears::Leaves { length },
    }
}

/// Length of leaves: as asked for, as drawn, or a share of the branches that bear them.
fn leaf_length(plan: &Plan, leaves: &Leaves) -> f32 {
    let drawn = plan.leaf.as_ref().map(|leaf| leaf.length);
    leaves.length.or(drawn).unwrap_or_else(|| {
        let outline = &plan.system.outline;
        let (low, high) = outline.bounds();
        // Branches of the second order are about a tenth of the crown long.
        LEAF_LENGTH * 0.1 * (high - low).max_element()
    })
}

/// Share of the axis before the first branch.
fn bare(system: &System) -> Option<f32> {
    // Coverage fills gaps wherever they are.
    let drawn = system.laterals.iter().filter(|lateral| lateral.origin != Origin::Coverage);
    let first = drawn.map(|lateral| lateral.t).min_by(f32::total_cmp);
    first.filter(|first| first.is_finite()).map(|first| first.clamp(0.0, 0.9))
}

/// Mean and deviation of the distances of branching points.
fn spacing(system: &System, counts: impl Fn(&Lateral) -> bool) -> Option<Spacing> {
    let mut places: Vec<f32> =
        system.laterals.iter().filter(|l| counts(l)).map(|l| l.t * system.axis.length()).collect();
    if places.len() <= FEW {
        return None;
    }
    places.sort_by(f32::total_cmp);
    let n = (places.len() - 1) as f32;
    let mean = (places[places.len() - 1] - places[0]) / n;
    let square = |pair: &[f32]| (pair[1] - pair[0] - mean) * (pair[1] - pair[0] - mean);
    let sd = (places.windows(2).map(square).sum::<f32>() / n).sqrt();
    (mean > 0.0).then_some(Spacing::Absolute { mean, sd })
}
