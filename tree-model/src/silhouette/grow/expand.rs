//! Patterns become columns of nodes and leaves, level by level.

use super::explicit::Explicit;
use super::fence::Fence;
use super::fill;
use super::frame::Frame;
use super::params::{GrowParams, Leaves};
use super::pattern::{self, Inner, Pattern};
use super::report::{GrowReport, Grown};
use super::style::{Bears, Styles};
use crate::error::Result;
use crate::silhouette::branch::Span;
use crate::silhouette::place::revolve::section_to_frame;
use crate::silhouette::place::{Site, ready};
use crate::silhouette::plan::Plan;
use glam::{Quat, Vec2, Vec3};
use rayon::prelude::*;
use std::collections::BTreeMap;
use tree_core::allometry::PipeModel;
use tree_core::{
    Control, Foliage, Leaf, NO_PARENT, Resource, Seed, Skeleton, SkeletonColumns, Tree,
};

/// Different patterns of one form, style and number of branches.
const VARIANTS: u64 = 5;
/// Different arrangements of so many branches.
const ARRANGEMENTS: u32 = 4;
/// Points of an axis: of the first level, halved with each further one, and the fewest.
const POINTS: [usize; 2] = [16, 4];
/// Trunks drawn wider than this share of the height, as their radius, are thinner.
const THICKEST: f32 = 0.08;
/// What ends outside the outlines is this share as long, or left out.
const SHORTENED: f32 = 0.65;
/// Levels of branches, at most.
const DEEPEST: u32 = 9;
/// Branches that one task sets down.
const CHUNK: usize = 256;

/// Grows a tree of a plan.
///
/// # Errors
/// [`ModelError::Parameter`](crate::ModelError::Parameter); [`ModelError::Limit`](crate::ModelError::Limit) for more
/// nodes or leaves than the limits allow; [`ModelError::Cancelled`](crate::ModelError::Cancelled);
/// [`ModelError::Core`](crate::ModelError::Core) for coordinates beyond what numbers hold.
///
/// # Complexity
/// O(nodes + leaves), and for each different pattern its number of branches.
pub fn grow(plan: &Plan, params: &GrowParams, seed: Seed, control: &Control) -> Result<Grown> {
    params.validate()?;
    let depth = depth(plan, params);
    let mut styles = Styles::of(plan, depth, params);
    control.report("branches", 0.1)?;
    let mut patterns = Vec::new();
    let axis = &plan.system.axis;
    let Some(span) = Span::new(axis.start(), axis.end(), false) else {
        return Ok(Grown { tree: bare(params)?, report: GrowReport::default() });
    };
    let mut system = plan.system.clone();
    system.carry(&|point: Vec2| span.to_frame(point));
    // Other planes show the axis in another frame.
    for (section, drawn) in system.sections.iter_mut().zip(&plan.system.sections) {
        if let Some(outline) = drawn.outline.transformed(section_to_frame(axis, drawn.azimuth)) {
            section.outline = outline;
        }
    }
    let fence = Fence::of(plan);
    let frame = frame_of(axis.start(), axis.span(), span.length());
    let mut explicit = Explicit {
        styles: &mut styles,
        patterns: &mut patterns,
        params,
        depth,
        fence: &fence,
        trunk: frame,
        control,
    };
    let trunk = explicit.pattern(&system, 0, seed.stream("trunk"))?;
    let mut growth = Growth {
        styles,
        patterns,
        sites: BTreeMap::new(),
        made: BTreeMap::new(),
        params,
        fence,
        seed,
        positions: Vec::new(),
        parents: Vec::new(),
        leaves: Foliage::default(),
        report: GrowReport {
            n_sketched: plan.system.laterals.len() as u64,
            ..GrowReport::default()
        },
    };
    growth.run(trunk, frame, depth, control)?;
    growth.finish(plan, control)
}

/// The number of levels of branches.
fn depth(plan: &Plan, params: &GrowParams) -> u32 {
    let drawn = plan.n_levels();
    let by_drawing = match plan.leaf {
        Some(_) if drawn > 1 => drawn - 1,
        Some(_) => 2,
        None => drawn.max(2),
    };
    params.depth.unwrap_or(by_drawing).clamp(1, DEEPEST)
}

/// The frame of the trunk's span.
fn frame_of(base: Vec2, span: Vec2, scale: f32) -> Frame {
    let turn = Quat::from_rotation_arc_2d(Vec2::Y, span / scale);
    Frame { origin: base.extend(0.0), turn, scale }
}

fn bare(params: &GrowParams) -> Result<Tree> {
    Ok(Tree::bare(Skeleton::builder(Vec3::ZERO, 0.0)?.finish(), params.species.clone()))
}

/// A branch to be set down.
#[derive(Clone, Copy)]
struct Instance {
    frame: Frame,
    /// The node it stands on.
    node: u32,
    form: u32,
    inner: Inner,
    /// Whether it may leave the outlines: on branches drawn from elsewhere.
    is_free: bool,
    /// Tells siblings of the same form apart.
    number: u64,
}

/// Names a pattern: form, style, number of branches, variant.
type Key = (u32, u32, u32, u64);

struct Growth<'a> {
    styles: Styles,
    patterns: Vec<Pattern>,
    /// Arrangements by the style whose they are, number of branches and variant.
    sites: BTreeMap<(u32, u32, u32), Vec<Site>>,
    made: BTreeMap<Key, u32>,
    params: &'a GrowParams,
    fence: Fence,
    seed: Seed,
    positions: Vec<Vec3>,
    parents: Vec<u32>,
    leaves: Foliage,
    report: GrowReport,
}

impl Growth<'_> {
    fn run(&mut self, trunk: u32, frame: Frame, depth: u32, control: &Control) -> Result<()> {
        self.positions.push(frame.origin);
        self.parents.push(NO_PARENT);
        let inner = Inner::Pattern(trunk);
        let mut level =
            vec![Instance { frame, node: 0, form: 0, inner, is_free: false, number: 0 }];
        for depth_now in 0..=depth {
            if level.is_empty() {
                break;
            }
            control.report("levels", 0.2 + 0.6 * depth_now as f32 / (depth + 1) as f32)?;
            self.report.branches.push(level.len() as u64);
            let patterns = self.patterns_for(&level, depth_now, control)?;
            level = self.set_down(&level, &patterns, control)?;
        }
        Ok(())
    }

    /// The number of each branch's pattern; makes those that are missing.
    fn patterns_for(
        &mut self,
        level: &[Instance],
        depth: u32,
        control: &Control,
    ) -> Result<Vec<u32>> {
        let keys: Vec<Option<Key>> = level.par_iter().map(|branch| self.key(branch)).collect();
        let mut missing: Vec<Key> = keys.iter().flatten().copied().collect();
        missing.par_sort_unstable();
        missing.dedup();
        missing.retain(|key| !self.made.contains_key(key));
        self.check_patterns(&missing, control)?;
        self.arrange(&missing)?;
        let points = POINTS[0].checked_shr(depth.saturating_sub(1)).unwrap_or(0).max(POINTS[1]);
        let first = self.patterns.len() as u32;
        let new: Vec<Pattern> = missing.par_iter().map(|&key| self.make(key, points)).collect();
        self.made.extend(missing.iter().enumerate().map(|(i, &key)| (key, first + i as u32)));
        self.patterns.extend(new);
        let number = |(branch, key): (&Instance, &Option<Key>)| match (branch.inner, key) {
            (Inner::Pattern(pattern), _) => pattern,
            (_, Some(key)) => self.made.get(key).copied().unwrap_or(0),
            _ => 0,
        };
        Ok(level.iter().zip(&keys).map(number).collect())
    }

    /// Holds patterns that are to be made against the limits.
    fn check_patterns(&self, missing: &[Key], control: &Control) -> Result<()> {
        let (mut branches, mut leaves) = (0, 0);
        for &(_, style, n, _) in missing {
            match self.styles.styles[style as usize].bears {
                Bears::Branches(_) => branches += u64::from(n) + 1,
                Bears::Leaves { .. } => leaves += u64::from(n) + 1,
            }
        }
        control.limits.check(Resource::Nodes, branches)?;
        control.limits.check(Resource::Leaves, leaves)?;
        Ok(control.check()?)
    }

    fn key(&self, branch: &Instance) -> Option<Key> {
        let Inner::Style(style) = branch.inner else { return None };
        let length = branch.frame.scale * self.styles.forms[branch.form as usize].line.length();
        let n = pattern::count(&self.styles.styles[style as usize], length);
        // Large numbers are rounded, so that patterns are shared.
        let n = if n > 24 { n - n % (n / 12) } else { n };
        Some((branch.form, style, n, branch.number % VARIANTS))
    }

    /// Arrangements for patterns that are to be made.
    fn arrange(&mut self, missing: &[Key]) -> Result<()> {
        let mut wanted: Vec<(u32, u32, u32)> = missing
            .iter()
            .map(|&(form, style, n, variant)| (style, n, arrangement(form, variant)))
            .collect();
        wanted.sort_unstable();
        wanted.dedup();
        wanted.retain(|key| !self.sites.contains_key(key));
        let seed = self.seed.stream("arrangements");
        let new: Result<Vec<Vec<Site>>> = wanted
            .par_iter()
            .map(|&(style, n, variant)| {
                let arrangement = self.styles.styles[style as usize].arrangement;
                ready(n, &arrangement, variant.into(), seed)
            })
            .collect();
        self.sites.extend(wanted.into_iter().zip(new?));
        Ok(())
    }

    fn make(&self, key: Key, points: usize) -> Pattern {
        let (form, style, n, variant) = key;
        let sites = self.sites.get(&(style, n, arrangement(form, variant)));
        let name = [form, style, n]
            .into_iter()
            .fold(self.seed.stream("patterns"), |seed, part| seed.child(u64::from(part)));
        pattern::of_style(
            (&self.styles.forms[form as usize], points),
            &self.styles.styles[style as usize],
            (&self.styles.forms, &self.styles.styles),
            sites.map_or(&[], Vec::as_slice),
            name.child(variant),
        )
    }

    /// Sets a level's branches down; returns those that stand on them.
    fn set_down(
        &mut self,
        level: &[Instance],
        patterns: &[u32],
        control: &Control,
    ) -> Result<Vec<Instance>> {
        let of = |i: usize| &self.patterns[patterns[i] as usize];
        let mut first = self.positions.len() as u64;
        let mut n_leaves = self.leaves.len() as u64;
        let mut n_next = 0;
        let mut firsts = Vec::with_capacity(level.len());
        for i in 0..level.len() {
            firsts.push(first as u32);
            first += of(i).line.len() as u64 - 1;
            n_leaves += of(i).leaves.len() as u64;
            n_next += of(i).children.len() as u64;
            self.report.n_without_room += u64::from(of(i).n_without_room);
        }
        // What stands on these branches will have nodes, too.
        control.limits.check(Resource::Nodes, first + n_next)?;
        control.limits.check(Resource::Leaves, n_leaves)?;
        let rows: Vec<Rows> = (0..level.len().div_ceil(CHUNK))
            .into_par_iter()
            .map(|chunk| {
                let mut rows = Rows::default();
                for i in chunk * CHUNK..((chunk + 1) * CHUNK).min(level.len()) {
                    rows.add(&level[i], of(i), firsts[i], self);
                }
                rows
            })
            .collect();
        control.check()?;
        let mut next = Vec::with_capacity(rows.iter().map(|rows| rows.next.len()).sum());
        for rows in rows {
            self.positions.extend(rows.positions);
            self.parents.extend(rows.parents);
            for leaf in rows.leaves {
                self.leaves.push(leaf)?;
            }
            next.extend(rows.next);
            self.report.n_fenced += rows.fenced;
        }
        next.par_iter_mut().enumerate().for_each(|(i, branch): (usize, &mut Instance)| {
            branch.number = self.seed.child(i as u64).0;
        });
        Ok(next)
    }

    fn finish(mut self, plan: &Plan, control: &Control) -> Result<Grown> {
        control.report("gaps", 0.8)?;
        let leaf = self.styles.leaf_length();
        let gaps = fill::Gaps { plan, params: self.params, fence: &self.fence, leaf };
        let wood = (&mut self.positions, &mut self.parents);
        self.report.n_filled =
            gaps.fill(wood, &mut self.leaves, self.seed.stream("gaps"), control)?;
        control.report("wood", 0.85)?;
        self.report.n_leaves = self.leaves.len() as u64;
        self.report.n_patterns = self.patterns.len() as u64;
        let radii = vec![0.0; self.positions.len()];
        let (positions, parents) = (self.positions, self.parents);
        let mut skeleton = Skeleton::try_from(SkeletonColumns { positions, radii, parents })?;
        let (low, high) = plan.system.outline.bounds();
        let height = high.y.max(high.y - low.y).max((high - low).max_element() * 0.25);
        let trunk = self.params.trunk_radius.unwrap_or(self.params.slenderness * height);
        let trunk = trunk.min(THICKEST * height);
        PipeModel {
            exponent: self.params.exponent,
            trunk_radius: Some(trunk.clamp(1e-6, 100.0)),
            ..PipeModel::default()
        }
        .apply(&mut skeleton)?;
        let tree = Tree::new(skeleton, self.leaves, self.params.species.clone())?;
        Ok(Grown { tree, report: self.report })
    }
}

fn arrangement(form: u32, variant: u64) -> u32 {
    (form + variant as u32) % ARRANGEMENTS
}

/// What a few branches come to.
#[derive(Default)]
struct Rows {
    positions: Vec<Vec3>,
    parents: Vec<u32>,
    leaves: Vec<Leaf>,
    next: Vec<Instance>,
    /// What was left out.
    fenced: u64,
}

impl Rows {
    fn add(&mut self, branch: &Instance, pattern: &Pattern, first: u32, growth: &Growth<'_>) {
        // The pattern's first node is the one the branch stands on.
        let node = |local: u32| if local == 0 { branch.node } else { first + local - 1 };
        for (i, &point) in pattern.line.iter().enumerate().skip(1) {
            self.positions.push(branch.frame.point(point));
            self.parents.push(node(i as u32 - 1));
        }
        let fence = (growth.params.fence && !branch.is_free).then_some(&growth.fence);
        for child in &pattern.children {
            let frame = branch.frame.then(&child.frame);
            let frame = with_room_for_leaves(frame, child.inner, &growth.styles);
            let Some(frame) = within(frame, fence.filter(|_| !child.is_sketched)) else {
                self.fenced += 1;
                continue;
            };
            let (node, form, inner) = (node(child.node), child.form, child.inner);
            let is_free = child.is_free || branch.is_free;
            self.next.push(Instance { frame, node, form, inner, is_free, number: 0 });
        }
        let (Some(leaves), Inner::Style(style)) = (&growth.params.leaves, branch.inner) else {
            return;
        };
        let Bears::Leaves { length } = growth.styles.styles[style as usize].bears else { return };
        for spot in &pattern.leaves {
            let turn = facing(branch.frame.turn * spot.turn, leaves);
            let midrib = turn * Vec3::Y;
            let position = branch.frame.point(spot.at) + leaves.petiole * length * midrib;
            let mut size = spot.size * length;
            if let Some(fence) = fence {
                if !fence.contains(position + 0.5 * size * midrib) {
                    self.fenced += 1;
                    continue;
                }
                if !fence.contains(position + size * midrib) {
                    size *= SHORTENED;
                }
            }
            let node = node(spot.node);
            self.leaves.push(Leaf { node, position, rotation: turn, size, kind: 0 });
        }
    }
}

/// A branch's frame, shortened where its end is outside; `None` where that does not help.
fn within(frame: Frame, fence: Option<&Fence>) -> Option<Frame> {
    let Some(fence) = fence else { return Some(frame) };
    let mut frame = frame;
    for _ in 0..3 {
        if fence.contains(frame.point(Vec3::Y)) {
            return Some(frame);
        }
        frame.scale *= SHORTENED;
    }
    None
}

/// A branch that bears leaves ends before its outline, for they stand out.
fn with_room_for_leaves(frame: Frame, inner: Inner, styles: &Styles) -> Frame {
    /// How far leaves stand out, in their lengths.
    const OUT: f32 = 0.6;
    /// What is left of a branch at least.
    const LEAST: f32 = 0.4;
    let Inner::Style(style) = inner else { return frame };
    let Bears::Leaves { length } = styles.styles[style as usize].bears else { return frame };
    Frame { scale: (frame.scale - OUT * length).max(LEAST * frame.scale), ..frame }
}

/// Turns a leaf about its midrib so that its upper face looks up more.
fn facing(turn: Quat, leaves: &Leaves) -> Quat {
    let up = turn.inverse() * Vec3::Y;
    // Upright leaves have no side that could look up.
    let level = up.x * up.x + up.z * up.z;
    if level < 1e-3 || leaves.facing == 0.0 {
        return turn;
    }
    let angle = libm::atan2f(up.x, up.z) * leaves.facing * level.sqrt();
    (turn * Quat::from_rotation_y(angle)).normalize()
}
