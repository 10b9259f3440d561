//! What will be drawn: every ring, every hole, every count, before any vertex exists.
//!
//! 1. Lines of all axes ([`Curves`]).
//! 2. Where each lateral leaves which axis ([`Forest`]).
//! 3. Storeys, holes and rings of each axis ([`Storeys`], [`RingFinder`]).
//! 4. Counts, and from them the place of every axis in the surface.
//!
//! Each step is parallel over axes, but for a few sequential sums.

use super::attach::Exit;
use super::circle::Circles;
use super::curve::{Curve, carry};
use super::curves::{AXES_PER_PART, Curves};
use super::flare::Flare;
use super::frame::Frame;
use super::hosts::{Forest, Leaving, Wishes};
use super::rings::{Fineness, Ring, RingFinder};
use super::storey::{Hole, Storeys, Wall, Wish};
use crate::error::Result;
use crate::params::MeshParams;
use glam::Vec3;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};
use tree_core::{Axes, Control, Resource, Skeleton};

/// Holes keep clear of the wall's ends by this share of its length, or by so many radii.
const MARGIN: f32 = 0.02;
const MARGIN_RADII: f32 = 0.5;
/// No axis.
pub(crate) const NONE: u32 = u32::MAX;

/// How an axis is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Trunk,
    /// A tube set onto a hole of its host's wall.
    Lateral,
    /// A point over a hole: too little of the axis is outside for a ring.
    Stub,
    /// Not at all: it has no length, or lies inside its host's wood.
    Skipped,
}

/// What is drawn of one axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisPlan {
    pub(crate) kind: Kind,
    /// The axis whose wall this one is set onto.
    pub(crate) host: u32,
    /// Number of the host's ring below the hole.
    pub(crate) hole_ring: u32,
    pub(crate) hole: Hole,
    /// First of its rings in the part, and how many.
    rings: (u32, u32),
    /// How often the bark's texture goes round.
    pub(crate) repeats: f32,
    pub(crate) pointed: bool,
    pub(crate) first_vertex: u32,
    pub(crate) n_vertices: u32,
    pub(crate) n_triangles: u32,
}

/// The plan of the whole bark.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) axes: Vec<AxisPlan>,
    /// The axes in the order they lie in the surface: hosts before what stands on them.
    pub(crate) order: Vec<u32>,
    /// Rings of the axes of each part.
    rings: Vec<Vec<Ring>>,
    pub(crate) curves: Curves,
    pub(crate) flare: Flare,
    pub(crate) circles: Circles,
    pub(crate) n_vertices: u64,
    pub(crate) n_triangles: u64,
    pub(crate) n_moved: u64,
}

impl Plan {
    /// The rings of an axis, from base to tip.
    pub(crate) fn rings(&self, axis: u32) -> &[Ring] {
        let (Some(plan), Some(part)) =
            (self.axes.get(axis as usize), self.rings.get(axis as usize / AXES_PER_PART))
        else {
            return &[];
        };
        let (start, len) = plan.rings;
        part.get(start as usize..(start + len) as usize).unwrap_or(&[])
    }

    /// The flare of an axis: only a trunk has one.
    pub(crate) fn flare(&self, axis: u32) -> Flare {
        if axis == 0 { self.flare } else { Flare::NONE }
    }

    /// Plans the bark.
    ///
    /// # Complexity
    /// O(nodes + rings + steps of the laterals' walks), and sorting the laterals of each axis.
    pub(crate) fn new(
        skeleton: &Skeleton,
        axes: &Axes,
        params: &MeshParams,
        control: &Control,
    ) -> Result<Self> {
        let curves = Curves::draw(skeleton, axes, params, control)?;
        let flare = flare(skeleton, &curves, params);
        let circles = Circles::new(params);
        let forest = Forest { skeleton, axes, curves: &curves, flare, circles: &circles };
        let exits = forest.leave_all(control)?;
        let wishes = Wishes::group(&exits);
        control.check()?;

        let cap = control.limits.cap(Resource::Triangles);
        // No axis has fewer rings than its length asks for, nor a ring fewer than three sides.
        let strips: f64 = (0..axes.len() as u32)
            .filter_map(|axis| curves.get(axis))
            .map(|curve| f64::from(curve.length() / params.max_strip).floor())
            .sum();
        // A cast from float saturates.
        control.limits.check(Resource::Triangles, (3.0 * strips) as u64)?;
        let fineness = Fineness {
            error: params.error.metres(),
            longest: params.max_strip,
            max_rings: usize::try_from(cap / 3).unwrap_or(usize::MAX).saturating_add(2),
        };
        let planned = AtomicU64::new(0);
        let planner = Planner { curves: &curves, circles: &circles, flare, params, fineness };
        let parts = (0..axes.len().div_ceil(AXES_PER_PART))
            .into_par_iter()
            .map_init(Scratch::default, |scratch, part| {
                control.check()?;
                let first = part * AXES_PER_PART;
                let mut out = Part::default();
                for (axis, exit) in exits.iter().enumerate().skip(first).take(AXES_PER_PART) {
                    planner.plan(axis as u32, exit, wishes.of(axis), scratch, &mut out);
                }
                // Each side of a ring is a triangle at least: too many are refused before all rings
                // are kept.
                let sides = out.rings.iter().map(|ring| u64::from(ring.n)).sum();
                let sum = planned.fetch_add(sides, Ordering::Relaxed).saturating_add(sides);
                control.limits.check(Resource::Triangles, sum.min(cap.saturating_add(1)))?;
                Ok(out)
            })
            .collect::<Result<Vec<Part>>>()?;
        Ok(Self::join(parts, curves, flare, circles))
    }

    /// Puts the parts together, gives laterals their holes, and counts.
    fn join(parts: Vec<Part>, curves: Curves, flare: Flare, circles: Circles) -> Self {
        let mut plan = Self {
            axes: Vec::with_capacity(parts.iter().map(|part| part.axes.len()).sum()),
            order: Vec::new(),
            rings: Vec::with_capacity(parts.len()),
            curves,
            flare,
            circles,
            n_vertices: 0,
            n_triangles: 0,
            n_moved: 0,
        };
        let mut holes = Vec::with_capacity(parts.len());
        for part in parts {
            plan.axes.extend(part.axes);
            plan.rings.push(part.rings);
            plan.n_moved += part.n_moved;
            holes.push(part.holes);
        }
        for (hole, ring) in holes.into_iter().flatten() {
            if let Some(axis) = plan.axes.get_mut(hole.lateral as usize) {
                (axis.hole, axis.hole_ring) = (hole, ring);
            }
        }
        plan.order = hosts_first(&plan.axes);
        for i in 0..plan.order.len() {
            let axis = plan.order[i];
            let (vertices, triangles) = plan.count(axis);
            let counted = &mut plan.axes[axis as usize];
            // Checked against the limits before anything reads it.
            counted.first_vertex = plan.n_vertices as u32;
            (counted.n_vertices, counted.n_triangles) = (vertices as u32, triangles as u32);
            plan.n_vertices += vertices;
            plan.n_triangles += triangles;
        }
        plan
    }

    /// Vertices and triangles of an axis, its bridge to the host included.
    fn count(&self, axis: u32) -> (u64, u64) {
        let plan = &self.axes[axis as usize];
        let rings = self.rings(axis);
        let (mut vertices, mut triangles) = (0_u64, 0_u64);
        for (i, ring) in rings.iter().enumerate() {
            vertices += u64::from(ring.n + 1);
            let above = rings.get(i + 1);
            let strip = |above: &Ring| ring.n + above.n - 2 * ring.mask.count_ones();
            triangles += u64::from(above.map_or(0, strip));
        }
        let sides = |ring: Option<&Ring>| u64::from(ring.map_or(0, |ring| ring.n));
        let (first, last) = (sides(rings.first()), sides(rings.last()));
        let rim = u64::from(2 * (plan.hole.width + 1));
        let copies = u64::from(self.n_copies(axis));
        match plan.kind {
            Kind::Trunk => (vertices + last + first + 1, triangles + last + first),
            Kind::Lateral => {
                let n_rings = u64::from(self.has_feet(axis));
                (
                    vertices + last + copies + first * (1 + n_rings),
                    triangles + last + rim + first * (1 + 2 * n_rings),
                )
            }
            Kind::Stub => (copies + 1, rim),
            Kind::Skipped => (0, 0),
        }
    }

    /// Whether feet stand round a lateral, on the wall ([`bridge`](super::bridge)).
    pub(crate) fn has_feet(&self, axis: u32) -> bool {
        let plan = &self.axes[axis as usize];
        let host = self.rings(plan.host);
        let (Some(ring), Some(low), Some(high)) = (
            self.rings(axis).first(),
            host.get(plan.hole_ring as usize),
            host.get(plan.hole_ring as usize + 1),
        ) else {
            return false;
        };
        let height = high.station.along - low.station.along;
        let width =
            std::f32::consts::TAU * low.station.radius * plan.hole.width as f32 / low.n as f32;
        let radius = ring.station.radius;
        radius > THICK * self.circles.error() || height.max(width) > WIDE * radius
    }

    /// Vertices of the hole's rim that are drawn again because the hole reaches over the seam.
    pub(crate) fn n_copies(&self, axis: u32) -> u32 {
        let plan = &self.axes[axis as usize];
        let n = self.rings(plan.host).get(plan.hole_ring as usize).map_or(0, |ring| ring.n);
        2 * (plan.hole.column + plan.hole.width).saturating_sub(n)
    }
}

/// Axes so that each comes after its host, and near to it.
fn hosts_first(axes: &[AxisPlan]) -> Vec<u32> {
    let mut starts = vec![0_u32; axes.len() + 2];
    let drawn = |axis: &AxisPlan| axis.host != NONE;
    for axis in axes.iter().filter(|axis| drawn(axis)) {
        starts[axis.host as usize + 2] += 1;
    }
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }
    let mut children = vec![0_u32; starts[axes.len() + 1] as usize];
    for (number, axis) in axes.iter().enumerate().filter(|(_, axis)| drawn(axis)) {
        let slot = &mut starts[axis.host as usize + 1];
        children[*slot as usize] = number as u32;
        *slot += 1;
    }
    let mut order = Vec::with_capacity(axes.len());
    let mut open = vec![0_u32];
    while let Some(axis) = open.pop() {
        order.push(axis);
        let (from, to) = (starts[axis as usize], starts[axis as usize + 1]);
        open.extend(children[from as usize..to as usize].iter().rev());
    }
    order
}

/// Laterals thicker than this many errors get feet,
const THICK: f32 = 3.0;
/// and those whose hole is higher or wider than this many of their radii.
const WIDE: f32 = 6.0;

/// Only a lone trunk widens: stems and roots that share the ground do not.
fn flare(skeleton: &Skeleton, curves: &Curves, params: &MeshParams) -> Flare {
    let alone = skeleton.parents().iter().filter(|&&parent| parent == 0).nth(1).is_none();
    match curves.get(0).and_then(|trunk| trunk.nodes.first().copied()) {
        Some(base) if alone && params.flare > 0.0 => Flare::new(params, base.radius),
        _ => Flare::NONE,
    }
}

/// Plans of some axes.
#[derive(Default)]
struct Part {
    axes: Vec<AxisPlan>,
    rings: Vec<Ring>,
    /// Holes in their walls, and the ring below each.
    holes: Vec<(Hole, u32)>,
    n_moved: u64,
}

#[derive(Default)]
struct Scratch {
    frames: Vec<Frame>,
    storeys: Storeys,
    finder: RingFinder,
}

struct Planner<'a> {
    curves: &'a Curves,
    circles: &'a Circles,
    flare: Flare,
    params: &'a MeshParams,
    fineness: Fineness,
}

impl Planner<'_> {
    fn plan(
        &self,
        axis: u32,
        leaving: &Leaving,
        wishes: &[Wish],
        scratch: &mut Scratch,
        out: &mut Part,
    ) {
        let mut plan = AxisPlan {
            kind: match (axis, leaving.exit) {
                (0, _) => Kind::Trunk,
                (_, Some(exit)) if exit.stub => Kind::Stub,
                (_, Some(_)) => Kind::Lateral,
                (_, None) => Kind::Skipped,
            },
            host: leaving.host,
            hole_ring: 0,
            hole: Hole::default(),
            rings: (out.rings.len() as u32, 0),
            repeats: 1.0,
            pointed: false,
            first_vertex: 0,
            n_vertices: 0,
            n_triangles: 0,
        };
        let curve = self.curves.get(axis).filter(|_| leaving.exit.is_none_or(|exit| !exit.stub));
        match curve {
            Some(curve) if plan.kind != Kind::Skipped => {
                self.draw(axis, leaving.exit, curve, wishes, scratch, &mut plan, out);
            }
            None if plan.kind == Kind::Trunk => plan.kind = Kind::Skipped,
            _ => {}
        }
        out.axes.push(plan);
    }

    #[expect(clippy::too_many_arguments, reason = "one step of plan, cut out for its length")]
    fn draw(
        &self,
        axis: u32,
        exit: Option<Exit>,
        curve: Curve<'_>,
        wishes: &[Wish],
        scratch: &mut Scratch,
        plan: &mut AxisPlan,
        out: &mut Part,
    ) {
        // The seam of a lateral lies below it, where it is seen least.
        let (start, hint) = exit.map_or((0.0, Vec3::X), |exit| (exit.start, -exit.up));
        scratch.frames.clear();
        scratch.frames.extend_from_slice(curve.frames);
        carry(curve.nodes, &mut scratch.frames, hint);
        let curve = Curve { frames: &scratch.frames, ..curve };
        let length = curve.length();
        let margin = |end: f32| {
            let radius = curve.at(end).station.radius;
            (MARGIN * (length - start)).min(MARGIN_RADII * radius)
        };
        let wall = Wall {
            curve,
            flare: if axis == 0 { self.flare } else { Flare::NONE },
            circles: self.circles,
            low: start + margin(start),
            high: length - margin(length),
        };
        scratch.storeys.divide(&wall, wishes);
        let rings = scratch.finder.find(&wall, start, &scratch.storeys, self.fineness);
        plan.rings.1 = rings.len() as u32;
        plan.pointed = curve.pointed;
        let around = std::f32::consts::TAU * curve.at(start).station.radius;
        plan.repeats = (around / self.params.bark_width).round().max(1.0);
        out.rings.extend_from_slice(rings);
        out.n_moved += u64::from(scratch.storeys.n_moved);
        let ring_of = &scratch.finder.ring_of_storey;
        out.holes.extend(
            scratch.storeys.holes.iter().map(|&hole| (hole, ring_of[hole.storey as usize])),
        );
    }
}
