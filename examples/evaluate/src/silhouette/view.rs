//! Windows on the plane of a view, and what is seen there of a drawing and of its tree.

use tree_lod::preview::{self, Camera, Lens, Pose, View};
use tree_mesh::Mesh;
use tree_model::silhouette::Outline;
use tree_model::silhouette::place::revolve::{Revolved, Section};
use tree_model::silhouette::plan::Plan;
use tree_model::tree_core::Control;
use tree_model::tree_core::glam::{Vec2, Vec3};

/// Cells along the longer side of what was drawn.
pub(super) const CELLS: usize = 64;
/// Cells all round, so that a tree beyond the drawing counts against it.
pub(super) const MARGIN: usize = 8;

/// A trunk flares to so many of its radii at its base.
const FLARE: f32 = 1.6;
/// And no more than this share of the crown's width is left out on either side of its line: what is wider was no trunk.
const WIDEST: f32 = 0.25;

/// Where the eye stands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// As drawn, on +Z.
    Front,
    /// A quarter turn away, on -X: +Z, the right side of the plane of azimuth π/2, is to the right.
    Side,
}

impl Side {
    /// What was drawn as this side sees it: the crown, or what is interpolated between its halves (or was drawn in that
    /// plane), and the trunk.
    pub(super) fn drawn(self, plan: &Plan) -> Option<(Outline, Vec<Vec2>)> {
        let system = &plan.system;
        let trunk = system.axis.points();
        if self == Self::Front {
            return Some((system.outline.clone(), trunk.to_vec()));
        }
        let others = system.sections.iter().map(|s| (s.azimuth, &s.outline));
        let sections: Vec<Section<'_>> = std::iter::once((0.0, &system.outline))
            .chain(others)
            .map(|(azimuth, outline)| Section { azimuth, outline })
            .collect();
        let surface = Revolved::of(&system.axis, &sections);
        let (origin, up) = (surface.origin(), surface.up());
        let profile = surface.profile(std::f32::consts::FRAC_PI_2)?;
        let seen = profile.transformed(|p| Vec2::new(p.x, origin.y + up.y * p.y))?;
        Some((seen, trunk.iter().map(|p| Vec2::new(0.0, p.y)).collect()))
    }
}

/// A square window of a view.
#[derive(Clone, Copy)]
pub(super) struct Window {
    side: Side,
    low: Vec2,
    /// Its side in metres.
    size: f32,
}

/// What a window shows, by cells, row by row from the lowest, each from the left.
pub(super) struct Seen {
    pub(super) n: usize,
    pub(super) outline: Vec<bool>,
    pub(super) tree: Vec<bool>,
    /// Trunk below the crown: counts neither for nor against.
    pub(super) trunk: Vec<bool>,
}

impl Window {
    /// Round a drawn crown and its trunk.
    fn around(side: Side, crown: &Outline, trunk: &[Vec2]) -> Self {
        let (mut low, mut high) = crown.bounds();
        for &point in trunk {
            (low, high) = (low.min(point), high.max(point));
        }
        let size = (high - low).max_element() * (CELLS + 2 * MARGIN) as f32 / CELLS as f32;
        Self { side, low: 0.5 * (low + high) - 0.5 * size, size }
    }

    fn view(&self, n: usize) -> View {
        let center = self.low + 0.5 * self.size;
        let (target, away) = match self.side {
            Side::Front => (Vec3::new(center.x, center.y, 0.0), Vec3::Z),
            Side::Side => (Vec3::new(0.0, center.y, center.x), -Vec3::X),
        };
        let lens = Lens::Orthographic { height: self.size };
        let eye = target + 20.0 * self.size * away;
        let pose = Pose { eye, target, up: Vec3::Y, lens };
        View { width: n as u32, height: n as u32, samples: 4, camera: Camera::Placed(pose) }
    }
}

/// What is seen of a plan and its tree in `n` by `n` cells; `None` where the side has no profile. Half the trunk's width
/// in metres.
pub(super) fn seen(
    side: Side,
    plan: &Plan,
    mesh: &Mesh,
    half_width: f32,
    n: usize,
) -> Result<Option<Seen>, Box<dyn std::error::Error>> {
    let Some((crown, line)) = side.drawn(plan) else { return Ok(None) };
    // The trunk up to where it comes into the crown.
    let below = line.iter().position(|&p| crown.contains(p)).unwrap_or(line.len());
    let stem = &line[..(below + 1).min(line.len())];
    let window = Window::around(side, &crown, stem);
    let cell = window.size / n as f32;
    let mask = preview::mask(mesh, &window.view(n), &Control::default())?;
    let bits: Vec<bool> = mask.bits().collect();
    let tree = (0..n * n).map(|at| bits[(n - 1 - at / n) * n + at % n]).collect();
    let outline = crown.mask(window.low, window.low + window.size, n, n);
    let (low, high) = crown.bounds();
    let reach = (FLARE * half_width).min(WIDEST * (high - low).x) + cell;
    let on_stem = |point: Vec2| {
        stem.windows(2).enumerate().any(|(i, pair)| {
            let (from, way) = (pair[0], pair[1] - pair[0]);
            let part = (point - from).dot(way) / way.length_squared().max(1e-12);
            // Beyond its end it is no longer below the crown.
            let is_beyond = i + 2 == stem.len() && part > 1.0;
            !is_beyond && point.distance(from + part.clamp(0.0, 1.0) * way) <= reach
        })
    };
    let center =
        |at: usize| window.low + cell * Vec2::new((at % n) as f32 + 0.5, (at / n) as f32 + 0.5);
    let trunk = (0..n * n).map(|at| !outline[at] && on_stem(center(at))).collect();
    Ok(Some(Seen { n, outline, tree, trunk }))
}

impl Seen {
    /// Cells in both over cells in either.
    pub(super) fn iou(&self) -> f64 {
        let [both, bare, over] = self.counts();
        f64::from(both) / f64::from((both + bare + over).max(1))
    }

    /// Cells of both, of the outline only, of the tree only.
    pub(super) fn counts(&self) -> [u32; 3] {
        let mut counts = [0; 3];
        for at in (0..self.n * self.n).filter(|&at| !self.trunk[at]) {
            match (self.outline[at], self.tree[at]) {
                (true, true) => counts[0] += 1,
                (true, false) => counts[1] += 1,
                (false, true) => counts[2] += 1,
                (false, false) => {}
            }
        }
        counts
    }
}
