//! Patterns: what stands on an axis, in the frame of its span.

use super::frame::{Around, Frame};
use super::shapes::Form;
use super::style::{Bears, Exemplar, Spacing, Style};
use crate::silhouette::Line;
use crate::silhouette::place::Site;
use glam::{Quat, Vec2, Vec3};
use tree_core::Seed;
use tree_core::seed::{Rng, normal, uniform};

/// Branches on one axis, at most.
pub(super) const MOST: u32 = 4000;
/// Nodes of an axis that are nearer than this share of its length are one.
const SAME_PLACE: f32 = 2e-3;
/// Branches shorter than this share of their parent's span are left out.
const SHORTEST: f32 = 0.01;
/// A copy is at most so many times longer, over its parent, than what it was copied from.
const LONGEST: f32 = 1.6;
/// Foliage that reaches further beyond a branch's end than this, in spans, does not shorten copies.
const REACH: f32 = 1.3;
/// Deviation of azimuths from their arrangement, in radians.
const LOOSE_AZIMUTH: f32 = 0.15;
/// Deviation of distances where only the number of branches is known, as a share of their mean.
const LOOSE: f32 = 0.2;

/// A branch of a pattern.
pub(super) struct Child {
    /// The node it stands on, an index into the pattern's line.
    pub(super) node: u32,
    /// Its frame in the frame of the pattern.
    pub(super) frame: Frame,
    pub(super) form: u32,
    pub(super) inner: Inner,
    /// Whether it was sketched: it is as long as it was drawn.
    pub(super) is_sketched: bool,
    /// Whether it, and all on it, may leave the outlines: it was drawn from elsewhere.
    pub(super) is_free: bool,
}

/// Where the pattern of a branch comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Inner {
    /// It was made for the branch.
    Pattern(u32),
    /// It is made of a style.
    Style(u32),
}

/// A leaf of a pattern.
pub(super) struct Spot {
    /// The end of the stretch it stands on.
    pub(super) node: u32,
    pub(super) at: Vec3,
    pub(super) turn: Quat,
    /// Its length over the usual.
    pub(super) size: f32,
}

/// An axis and what stands on it.
#[derive(Default)]
pub(super) struct Pattern {
    /// The axis' nodes; the first is its base.
    pub(super) line: Vec<Vec3>,
    pub(super) children: Vec<Child>,
    pub(super) leaves: Vec<Spot>,
    pub(super) n_without_room: u32,
}

/// Number of branches of a style on an axis of so many metres.
pub(super) fn count(style: &Style, length: f32) -> u32 {
    let in_plane = match style.spacing {
        Spacing::Count(count) => count as f32,
        Spacing::Absolute { mean, .. } => (1.0 - style.bare) * length / mean,
    };
    // The cast saturates.
    ((in_plane * (1.0 + style.density) + 0.5) as u32).clamp(1, MOST)
}

/// The pattern of a style on a form: branches at `sites`, which are in order along the axis.
pub(super) fn of_style(
    (form, points): (&Form, usize),
    style: &Style,
    (forms, styles): (&[Form], &[Style]),
    sites: &[Site],
    seed: Seed,
) -> Pattern {
    let mut rng = seed.rng();
    let places = places(style, sites, &mut rng);
    let line = form.line.resampled(points);
    let mut pattern = Pattern::default();
    match &style.bears {
        Bears::Leaves { .. } => {
            let axis = Nodes::of(&line, &[]);
            for (site, &t) in sites.iter().zip(&places) {
                let angle = vary(style.angles.at(t), 0.5 * style.jitter, &mut rng);
                pattern.leaves.push(spot(&line, &axis, t, site.azimuth, angle, style, &mut rng));
            }
            let azimuth = uniform(&mut rng, 0.0, std::f32::consts::TAU);
            pattern.leaves.push(spot(&line, &axis, 1.0, azimuth, 0.1, style, &mut rng));
            pattern.line = axis.points(style.spiral);
        }
        Bears::Branches(exemplars) => {
            let axis = Nodes::of(&line, &places);
            let ends = sites.iter().map(|site| site.azimuth).zip(places.iter().copied());
            for (azimuth, t) in ends.chain([(0.0, 1.0)]) {
                let azimuth = vary(azimuth, LOOSE_AZIMUTH, &mut rng);
                let Some(exemplar) = pick(exemplars, t, &mut rng) else { break };
                let copied = &forms[exemplar.form as usize];
                let angle = if t < 1.0 { style.angles.at(t) } else { copied.leaving };
                let angle = vary(angle, 0.5 * style.jitter, &mut rng) - copied.leaving;
                let scale = vary(1.0 - 0.5 * style.jitter, 0.5 * style.jitter, &mut rng);
                let around = Around::new(line.tangent(t), azimuth);
                let turn = around.turn(angle);
                let base = line.at(t);
                let room = form.room(base, turn * Vec3::Y, azimuth).unwrap_or(0.0);
                let most = LONGEST * exemplar.ratio * form.line.length();
                // Of the last branches nothing grows beyond their ends but leaves.
                let is_last = matches!(styles[exemplar.style as usize].bears, Bears::Leaves { .. });
                let reach = if is_last { 1.0 } else { copied.reach.min(REACH) };
                let length = (scale * room / reach).min(most);
                if length < SHORTEST {
                    pattern.n_without_room += 1;
                    continue;
                }
                let frame = Frame { origin: base.extend(0.0), turn, scale: length };
                let inner = Inner::Style(exemplar.style);
                let node = axis.nearest(t);
                pattern.children.push(Child {
                    node,
                    frame,
                    form: exemplar.form,
                    inner,
                    is_sketched: false,
                    is_free: false,
                });
            }
            pattern.line = axis.points(style.spiral);
            let nodes = &pattern.line;
            pattern.children.iter_mut().for_each(|child| {
                child.frame.origin = nodes[child.node as usize];
            });
        }
    }
    pattern
}

/// A copy's parent place decides which exemplar it is: one of the two nearest.
fn pick<'a>(exemplars: &'a [Exemplar], t: f32, rng: &mut Rng) -> Option<&'a Exemplar> {
    let mut best: [Option<(f32, &Exemplar)>; 2] = [None, None];
    for exemplar in exemplars {
        let distance = (exemplar.t - t).abs();
        if best[0].is_none_or(|(nearest, _)| distance < nearest) {
            best = [Some((distance, exemplar)), best[0]];
        } else if best[1].is_none_or(|(second, _)| distance < second) {
            best[1] = Some((distance, exemplar));
        }
    }
    let second = uniform(rng, 0.0, 1.0) < 0.4;
    let chosen = if second { best[1].or(best[0]) } else { best[0] };
    chosen.map(|(_, exemplar)| exemplar)
}

fn vary(value: f32, by: f32, rng: &mut Rng) -> f32 {
    value + uniform(rng, -by, by)
}

/// Places along the axis: in the order of the sites, their distances as the style has them. Sites at one node stay
/// together.
fn places(style: &Style, sites: &[Site], rng: &mut Rng) -> Vec<f32> {
    let share = match style.spacing {
        Spacing::Absolute { mean, sd } => (sd / mean).min(1.0),
        Spacing::Count(_) => LOOSE,
    };
    let mut place = 0.0;
    let mut out = Vec::with_capacity(sites.len());
    for node in sites.chunk_by(|a, b| a.node == b.node) {
        place += (1.0 + share * normal(rng)).max(0.05);
        out.extend(node.iter().map(|_| place));
    }
    let all = place + 0.5;
    let first = out.first().copied().unwrap_or(0.0);
    out.iter_mut().for_each(|p| *p = style.bare + (1.0 - style.bare) * (*p - first) / all);
    out
}

fn spot(
    line: &Line,
    axis: &Nodes,
    t: f32,
    azimuth: f32,
    angle: f32,
    style: &Style,
    rng: &mut Rng,
) -> Spot {
    Spot {
        node: axis.above(t),
        at: line.at(t).extend(0.0),
        turn: Around::new(line.tangent(t), azimuth).leaf(angle),
        size: vary(1.0 - 0.5 * style.jitter, 0.5 * style.jitter, rng),
    }
}

/// An axis with a node wherever a branch stands.
pub(super) struct Nodes {
    /// Share of the length of each node, rising.
    along: Vec<f32>,
    points: Vec<Vec2>,
}

impl Nodes {
    /// The nodes of a line, and further ones at places along it.
    pub(super) fn of(line: &Line, places: &[f32]) -> Self {
        let mut length = 0.0;
        let mut along = vec![0.0];
        for pair in line.points().windows(2) {
            length += pair[0].distance(pair[1]);
            along.push(length / line.length());
        }
        along.extend(places.iter().map(|place| place.clamp(0.0, 1.0)));
        along.sort_by(f32::total_cmp);
        along.dedup_by(|next, kept| *next - *kept < SAME_PLACE);
        if let Some(last) = along.last_mut() {
            *last = 1.0;
        }
        let points = along.iter().map(|&t| line.at(t)).collect();
        Self { along, points }
    }

    /// The node nearest to a place.
    pub(super) fn nearest(&self, t: f32) -> u32 {
        let above = self.along.partition_point(|&a| a < t).min(self.along.len() - 1);
        let below = above.saturating_sub(1);
        let is_below = t - self.along[below] < self.along[above] - t;
        (if is_below { below } else { above }) as u32
    }

    /// The node at the end of the stretch a place lies on; never the base.
    fn above(&self, t: f32) -> u32 {
        self.along.partition_point(|&a| a < t).clamp(1, self.along.len() - 1) as u32
    }

    /// The nodes in space; turned about the span by up to half of `spiral` either way.
    pub(super) fn points(&self, spiral: f32) -> Vec<Vec3> {
        let turned = |(&point, &t): (&Vec2, &f32)| {
            let (sin, cos) = libm::sincosf(spiral * (t - 0.5));
            Vec3::new(cos * point.x, point.y, sin * point.x)
        };
        if spiral == 0.0 {
            return self.points.iter().map(|point| point.extend(0.0)).collect();
        }
        self.points.iter().zip(&self.along).map(turned).collect()
    }
}
