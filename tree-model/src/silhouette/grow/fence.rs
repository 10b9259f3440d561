//! What the drawing lets grow: outlines from the front and from the side.

use super::shapes::surface_of;
use crate::silhouette::Outline;
use crate::silhouette::plan::{Plan, System};
use glam::{Vec2, Vec3};
use std::f32::consts::FRAC_PI_2;

/// Cells along the longer side of an outline.
const CELLS: usize = 256;

/// The outline of a view as cells.
pub(super) struct View {
    /// Whether it is seen from the side: then z is to the right.
    pub(super) is_side: bool,
    pub(super) low: Vec2,
    pub(super) cell: f32,
    pub(super) size: [usize; 2],
    pub(super) inside: Vec<bool>,
}

impl View {
    /// What several outlines cover together, in `cells` along the longer side of the first; the rows reach over `heights`.
    fn of(outlines: &[&Outline], heights: (f32, f32), is_side: bool, cells: usize) -> Option<Self> {
        let (mut low, mut high) = outlines.first()?.bounds();
        let cell = (high - low).max_element() / cells as f32;
        for outline in outlines {
            let (a, b) = outline.bounds();
            (low, high) = (low.min(a), high.max(b));
        }
        (low.y, high.y) = (low.y.min(heights.0), high.y.max(heights.1));
        let count = |length: f32| ((length / cell).ceil() as usize).clamp(1, 4 * cells);
        let size = [count(high.x - low.x), count(high.y - low.y)];
        let high = low + cell * Vec2::new(size[0] as f32, size[1] as f32);
        let mut inside = vec![false; size[0] * size[1]];
        for outline in outlines {
            let mask = outline.mask(low, high, size[0], size[1]);
            inside.iter_mut().zip(mask).for_each(|(cell, more)| *cell |= more);
        }
        (cell > 0.0 && cell.is_finite()).then_some(Self { is_side, low, cell, size, inside })
    }

    /// A point in space as it is seen.
    pub(super) fn seen(&self, point: Vec3) -> Vec2 {
        if self.is_side { Vec2::new(point.z, point.y) } else { Vec2::new(point.x, point.y) }
    }

    /// A point seen at a depth, in space.
    pub(super) fn at_depth_of(&self, seen: Vec2, point: Vec3) -> Vec3 {
        if self.is_side {
            Vec3::new(point.x, seen.y, seen.x)
        } else {
            Vec3::new(seen.x, seen.y, point.z)
        }
    }

    /// The cell of a point; `None` outside all.
    pub(super) fn cell_of(&self, point: Vec3) -> Option<usize> {
        let place = (self.seen(point) - self.low) / self.cell;
        let (x, y) = (place.x.floor() as i64, place.y.floor() as i64);
        let within = x >= 0 && y >= 0 && x < self.size[0] as i64 && y < self.size[1] as i64;
        within.then(|| y as usize * self.size[0] + x as usize)
    }

    fn contains(&self, point: Vec3) -> bool {
        self.cell_of(point).is_some_and(|cell| self.inside[cell])
    }

    /// Opens rows that hold nothing about the axis: what the front shows at that height has to be somewhere.
    fn with_open_rows(mut self) -> Self {
        /// Half of what is opened, as a share of the longer side.
        const OPEN: f32 = 0.03;
        let [width, height] = self.size;
        let half = OPEN * self.cell * CELLS as f32;
        let column = |z: f32| ((z - self.low.x) / self.cell).clamp(0.0, width as f32) as usize;
        let open = column(-half)..column(half).max(column(-half));
        for y in 0..height {
            let row = &mut self.inside[y * width..(y + 1) * width];
            if !row.contains(&true) {
                row[open.clone()].fill(true);
            }
        }
        self
    }

    /// The point of the same height inside that is nearest, moved across the view; `None` where all of that height is
    /// outside.
    fn drawn_in(&self, point: Vec3) -> Option<Vec3> {
        let place = (self.seen(point) - self.low) / self.cell;
        let [width, height] = self.size;
        if place.y < 0.0 || place.y >= height as f32 {
            return None;
        }
        let row = place.y as usize * width;
        let here = (place.x.clamp(0.0, width as f32 - 1.0)) as usize;
        let is_inside = |x: &usize| self.inside[row + x];
        let before = (0..=here).rev().find(is_inside);
        let after = (here..width).find(is_inside);
        let nearest = match (before, after) {
            (Some(a), Some(b)) if here - a > b - here => b,
            (a, b) => a.or(b)?,
        };
        if nearest == here {
            return Some(point);
        }
        let across = self.low.x + self.cell * (nearest as f32 + 0.5);
        Some(self.at_depth_of(Vec2::new(across, self.seen(point).y), point))
    }
}

/// The views of a plan.
pub(super) struct Fence {
    views: Vec<View>,
}

impl Fence {
    pub(super) fn of(plan: &Plan) -> Self {
        let open = |view: View| if view.is_side { view.with_open_rows() } else { view };
        Self { views: views(plan, CELLS).into_iter().map(open).collect() }
    }

    /// Whether a point is inside as seen from the side.
    pub(super) fn is_in_profile(&self, point: Vec3) -> bool {
        self.views.iter().filter(|view| view.is_side).all(|view| view.contains(point))
    }

    /// A point that is inside from all sides, at the same height and near; `None` where there is none.
    pub(super) fn drawn_in(&self, point: Vec3) -> Option<Vec3> {
        self.views.iter().try_fold(point, |point, view| view.drawn_in(point))
    }

    /// Whether a point is inside from all sides.
    pub(super) fn contains(&self, point: Vec3) -> bool {
        self.views.iter().all(|view| view.contains(point))
    }
}

/// The front and the side of a plan. From the front also what of branches' outlines was drawn beyond the crown.
pub(super) fn views(plan: &Plan, cells: usize) -> Vec<View> {
    let system = &plan.system;
    let in_plane = system.laterals.iter().filter(|lateral| lateral.azimuth.is_none());
    let drawn = in_plane.filter_map(|lateral| lateral.system.as_deref());
    let mut front = vec![&system.outline];
    front.extend(drawn.map(|inner| &inner.outline));
    let side = side_of(system);
    let (low, high) = system.outline.bounds();
    let heights = (low.y, high.y);
    let views = [
        View::of(&front, heights, false, cells),
        side.and_then(|side| View::of(&[&side], heights, true, cells)),
    ];
    views.into_iter().flatten().collect()
}

/// The interpolated profile as seen from the side, in the plan's metres.
fn side_of(system: &System) -> Option<Outline> {
    let surface = surface_of(system);
    let (origin, up) = (surface.origin(), surface.up());
    surface.profile(FRAC_PI_2)?.transformed(|point| Vec2::new(point.x, origin.y + point.y * up.y))
}
