//! Details borrowed of other trees: branches with their systems, and the leaf (section 4.2's style transfer, between trees).

use crate::silhouette::Line;
use crate::silhouette::plan::{DrawnLeaf, Lateral, Plan};
use std::collections::BTreeMap;

/// What a difference in size counts for against one in proportion, when crowns are compared.
const SIZE_WEIGHT: f32 = 0.25;
/// What a lender's branches are moved along the axis where the borrower has branches of its own of that level: beyond the tip, so
/// that its own are always nearer.
const BEYOND: f32 = 2.0;

/// Whether one plan has details that another lacks.
pub(super) fn has_more(lender: &Plan, borrower: &Plan) -> bool {
    lender.n_levels() > borrower.n_levels() || (lender.leaf.is_some() && borrower.leaf.is_none())
}

/// The tree of the most similar crown of those with the most details; `None` where none has details that the borrower lacks.
pub(super) fn nearest(plans: &[Option<&Plan>], borrower: &Plan) -> Option<usize> {
    let detail = |plan: &Plan| (plan.n_levels(), plan.leaf.is_some());
    let most = plans.iter().flatten().map(|plan| detail(plan)).max()?;
    let difference = |lender: &Plan| {
        let proportion = libm::logf(slenderness(lender) / slenderness(borrower)).abs();
        proportion + SIZE_WEIGHT * libm::logf(size(lender) / size(borrower)).abs()
    };
    let lenders = plans.iter().enumerate().filter_map(|(i, plan)| plan.map(|plan| (i, plan)));
    lenders
        .filter(|(_, plan)| detail(plan) == most && has_more(plan, borrower))
        .min_by(|a, b| difference(a.1).total_cmp(&difference(b.1)))
        .map(|(i, _)| i)
}

/// By how much what is borrowed is scaled: as the crowns are, within a factor.
pub(super) fn scale(lender: &Plan, borrower: &Plan, most: f32) -> f32 {
    (size(borrower) / size(lender)).clamp(1.0 / most, most)
}

/// What the borrower lacks and the lender has, scaled; ids do not meet those of the borrower.
pub(super) fn loan(
    lender: &Plan,
    borrower: &Plan,
    scale: f32,
) -> (Vec<Lateral>, Option<DrawnLeaf>) {
    let leaf = match (&borrower.leaf, &lender.leaf) {
        (None, Some(leaf)) => Some(DrawnLeaf { length: scale * leaf.length, ..leaf.clone() }),
        _ => None,
    };
    if lender.n_levels() <= borrower.n_levels() {
        return (Vec::new(), leaf);
    }
    let drawn = |lateral: &&Lateral| lateral.system.is_some();
    let mut branches: Vec<Lateral> = lender.system.laterals.iter().filter(drawn).cloned().collect();
    let has_own = borrower.system.laterals.iter().any(|lateral| lateral.system.is_some());
    let mut ids = Vec::new();
    each_id(&borrower.system.laterals, &mut |id| ids.push(id));
    let mut next = ids.into_iter().max().unwrap_or(0);
    let mut names = BTreeMap::new();
    each_id(&branches, &mut |id| {
        next += 1;
        names.insert(id, next);
    });
    for branch in &mut branches {
        let scaled = branch.line.points().iter().map(|&point| scale * point).collect();
        if let Some(line) = Line::new(scaled) {
            branch.reshape(line, branch.left);
        }
        branch.outline = branch
            .outline
            .transformed(|point| scale * point)
            .unwrap_or_else(|| branch.outline.clone());
        branch.t += if has_own { BEYOND } else { 0.0 };
        adapt(branch, scale, &names);
    }
    (branches, leaf)
}

/// New names and scaled radii, of a branch and all on it.
fn adapt(branch: &mut Lateral, scale: f32, names: &BTreeMap<u32, u32>) {
    branch.id = names.get(&branch.id).copied().unwrap_or(branch.id);
    branch.style = branch.style.and_then(|id| names.get(&id).copied());
    branch.radius *= scale;
    branch.stretch = branch.stretch.map(|ends| ends.map(|end| scale * end));
    for inner in branch.system.iter_mut().flat_map(|system| &mut system.laterals) {
        adapt(inner, scale, names);
    }
}

fn each_id(branches: &[Lateral], with: &mut impl FnMut(u32)) {
    for branch in branches {
        with(branch.id);
        if let Some(system) = &branch.system {
            each_id(&system.laterals, with);
        }
    }
}

/// Side of a square as large as the crown.
fn size(plan: &Plan) -> f32 {
    plan.system.outline.area().abs().sqrt().max(f32::MIN_POSITIVE)
}

/// Height of the crown over its width.
fn slenderness(plan: &Plan) -> f32 {
    let (low, high) = plan.system.outline.bounds();
    let extent = (high - low).max(glam::Vec2::splat(f32::MIN_POSITIVE));
    extent.y / extent.x
}
