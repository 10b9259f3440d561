//! What propagation needs to know of the sketched segments.

use super::frame::{Course, Frame};
use super::params::PropagateParams;
use crate::error::{ModelError, Result, check};
use crate::sketch::{Branches, Habit, Label, Omega};
use glam::Vec3;
use tree_core::{NO_PARENT, Seed};

/// Natural lengths are at least this share of the longest: a template may ask for laterals far shorter than a stroke.
const LEAST_NATURAL: f32 = 0.5;
/// Coordinates beyond this many metres are no tree's.
const FARTHEST: f32 = 1e6;
/// New segments stay this share of the height above the base: leaves hang from them.
const ABOVE_GROUND: f32 = 0.03;
/// An apical segment with at least so many laterals about it, of an order that does not branch, is as those are: a
/// palm's fronds.
const ROSETTE: usize = 4;
/// Smallest and largest length of a new segment against the one below: growth must slow down, but not stop at once.
pub(super) const RATIO: [f32; 2] = [0.35, 0.9];

/// Sketched segments with their frames, lengths and names.
pub(super) struct Drawn<'a> {
    pub(super) branches: &'a Branches,
    pub(super) courses: Vec<Course<'a>>,
    pub(super) orders: Vec<u32>,
    /// Length that a segment would have, had the user drawn all forks.
    pub(super) natural: Vec<f32>,
    /// Frame where a segment begins, before it turns off its parent.
    pub(super) below: Vec<Frame>,
    /// Frame at its end.
    pub(super) ends: Vec<Frame>,
    /// Stream named by the way from the root: a hash of the labels on it.
    pub(super) keys: Vec<Seed>,
    /// Length of its axis beyond its end.
    pub(super) beyond: Vec<f32>,
    /// Where the children of each segment begin in `children`.
    child_starts: Vec<u32>,
    children: Vec<u32>,
    /// Height of the highest point over the lowest, in metres.
    pub(super) height: f32,
}

impl<'a> Drawn<'a> {
    pub(super) fn new(
        branches: &'a Branches,
        omega: &Omega,
        params: &PropagateParams,
        seed: Seed,
    ) -> Result<Self> {
        validate(branches, omega)?;
        let n = branches.len();
        let courses: Vec<_> = (0..n).map(|s| Course::new(branches.points(s))).collect();
        let (child_starts, children) = children_of(branches);
        let mut drawn = Self {
            branches,
            orders: branches.orders(),
            natural: vec![0.0; n],
            below: vec![Frame::UP; n],
            ends: vec![Frame::UP; n],
            keys: vec![seed; n],
            beyond: vec![0.0; n],
            child_starts,
            children,
            height: height(branches),
            courses,
        };
        for segment in 0..n {
            drawn.measure(segment, omega, params);
        }
        for segment in (1..n).rev() {
            if branches.labels()[segment] == Label::Apical {
                let parent = branches.parents()[segment] as usize;
                drawn.beyond[parent] = drawn.courses[segment].length() + drawn.beyond[segment];
            }
        }
        Ok(drawn)
    }

    fn measure(&mut self, segment: usize, omega: &Omega, params: &PropagateParams) {
        let longest = params.internode * self.height;
        let label = self.branches.labels()[segment];
        let own = self.courses[segment].length();
        let parent = self.branches.parents()[segment];
        let (mut natural, mut below) = (longest, Frame::UP);
        if parent != NO_PARENT {
            let parent = parent as usize;
            below = self.ends[parent];
            self.keys[segment] = match self.branches.names().get(segment) {
                Some(&name) => self.keys[0].child(name),
                None => self.keys[parent].child(code(label)),
            };
            if !self.is_stem(segment) {
                let habit = habit(omega, self.orders[parent]);
                let scale = if label == Label::Apical { habit.scale } else { habit.lateral_scale };
                natural = self.natural[parent] * libm::expf(scale.mean.min(0.0));
            }
        }
        self.natural[segment] = natural.clamp(LEAST_NATURAL * longest, longest).min(own);
        let natural = self.natural[segment];
        self.below[segment] = below;
        self.ends[segment] =
            below.carried(self.courses[segment].heading(own - natural, own, below.along));
    }

    /// Whether a segment rises from the ground.
    pub(super) fn is_stem(&self, segment: usize) -> bool {
        let parent = self.branches.parents()[segment];
        parent == NO_PARENT || (parent == 0 && self.branches.has_imagined_root())
    }

    /// Whether a segment is none: the imagined root.
    pub(super) fn is_imagined(&self, segment: usize) -> bool {
        segment == 0 && self.branches.has_imagined_root()
    }

    /// Height that nothing new grows below.
    pub(super) fn ground(&self) -> f32 {
        let root = usize::from(self.is_imagined(0) && self.branches.len() > 1);
        self.branches.start(root).y + ABOVE_GROUND * self.height
    }

    /// Whether a segment is the end of a rosette.
    pub(super) fn is_in_rosette(&self, segment: usize) -> bool {
        let parent = self.branches.parents()[segment];
        parent != NO_PARENT
            && self.children(segment).is_empty()
            && self.children(parent as usize).len() > ROSETTE
    }

    pub(super) fn children(&self, segment: usize) -> &[u32] {
        let (from, to) = (self.child_starts[segment], self.child_starts[segment + 1]);
        &self.children[from as usize..to as usize]
    }

    /// The frame `way` metres up a segment.
    pub(super) fn frame_at(&self, segment: usize, way: f32) -> Frame {
        let half = 0.5 * self.natural[segment];
        let course = &self.courses[segment];
        let below = self.below[segment];
        below.carried(course.heading(way - half, way + half, below.along))
    }
}

/// The number of a child in the hash of the way to it.
pub(super) fn code(label: Label) -> u64 {
    match label {
        Label::Apical => 0,
        Label::Lateral(number) => u64::from(number) + 1,
    }
}

/// The habit of axes of this order.
pub(super) fn habit(omega: &Omega, order: u32) -> &Habit {
    &omega.orders[(order as usize).min(omega.orders.len() - 1)]
}

/// The usual length of an apical segment against the one below.
pub(super) fn usual_ratio(habit: &Habit) -> f32 {
    libm::expf(habit.scale.mean).clamp(RATIO[0], RATIO[1])
}

/// How far a chain of `n` segments comes whose first has length 1 and each further one `ratio` times the last.
pub(super) fn chain(ratio: f32, n: u32) -> f32 {
    (1.0 - libm::powf(ratio, n as f32)) / (1.0 - ratio)
}

fn children_of(branches: &Branches) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; branches.len() + 1];
    for &parent in &branches.parents()[1..] {
        starts[parent as usize + 1] += 1;
    }
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }
    let mut next = starts.clone();
    let mut children = vec![0_u32; branches.len() - 1];
    for (segment, &parent) in branches.parents().iter().enumerate().skip(1) {
        let slot = &mut next[parent as usize];
        children[*slot as usize] = segment as u32;
        *slot += 1;
    }
    (starts, children)
}

/// Height of the drawn points, or their extent where they lie level.
fn height(branches: &Branches) -> f32 {
    let skipped = usize::from(branches.has_imagined_root() && branches.len() > 1);
    let points = || (skipped..branches.len()).flat_map(|s| branches.points(s));
    let low = points().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = points().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let size = (high - low).max(Vec3::ZERO);
    if size.y > 0.1 * size.max_element() { size.y } else { size.max_element() }
}

fn validate(branches: &Branches, omega: &Omega) -> Result<()> {
    let fail = |problem: String| Err(ModelError::Sketch { problem });
    let far = |p: &Vec3| p.abs().max_element().partial_cmp(&FARTHEST).is_none_or(|o| o.is_gt());
    for segment in 0..branches.len() {
        if let Some(point) = branches.points(segment).iter().find(|point| far(point)) {
            return fail(format!(
                "segment {segment} has a point at {point}: give metres, at most {FARTHEST} from the base"
            ));
        }
    }
    if omega.orders.is_empty() {
        return fail("the parameters Ω have no order: give at least that of the trunk".into());
    }
    for (order, habit) in omega.orders.iter().enumerate() {
        let all = [
            ("scale", habit.scale),
            ("lateral_scale", habit.lateral_scale),
            ("alpha", habit.alpha),
            ("beta", habit.beta),
            ("gamma", habit.gamma),
        ];
        for (name, normal) in all {
            check(format!("omega.orders[{order}].{name}.mean"), normal.mean, -100.0, 100.0)?;
            check(format!("omega.orders[{order}].{name}.deviation"), normal.deviation, 0.0, 100.0)?;
        }
    }
    Ok(())
}
