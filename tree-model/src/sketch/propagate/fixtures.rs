//! Sketches and crowns by hand, for tests.

use crate::sketch::crown::Crown;
use crate::sketch::{Branches, Habit, Label, Normal, Omega};
use glam::{Vec2, Vec3};

/// Segments by hand.
#[derive(Default)]
pub(in crate::sketch) struct Builder {
    parents: Vec<u32>,
    labels: Vec<Label>,
    starts: Vec<u32>,
    points: Vec<Vec3>,
}

impl Builder {
    /// A segment from its parent's end (the origin where there is none) to `end`, a little bowed.
    pub(in crate::sketch) fn add(
        &mut self,
        parent: Option<u32>,
        label: Label,
        end: [f32; 3],
    ) -> u32 {
        let start =
            parent.map_or(Vec3::ZERO, |p| self.points[self.starts[p as usize + 1] as usize - 1]);
        let end = Vec3::from(end);
        if self.starts.is_empty() {
            self.starts.push(0);
        }
        let bow = 0.05 * start.distance(end) * Vec3::new(0.3, 0.5, -0.4);
        for i in 0..=6 {
            let share = i as f32 / 6.0;
            self.points.push(match i {
                0 => start,
                6 => end,
                _ => start.lerp(end, share) + 4.0 * share * (1.0 - share) * bow,
            });
        }
        self.starts.push(self.points.len() as u32);
        self.parents.push(parent.unwrap_or(tree_core::NO_PARENT));
        self.labels.push(label);
        self.parents.len() as u32 - 1
    }

    /// Goes on from a sketch.
    pub(in crate::sketch) fn on(sketch: &Branches) -> Self {
        let Branches { parents, labels, starts, points, .. } = sketch.clone();
        Self { parents, labels, starts, points }
    }

    pub(in crate::sketch) fn build(self) -> Branches {
        Branches::from_columns(self.parents, self.labels, self.starts, self.points, false).unwrap()
    }
}

pub(in crate::sketch) fn omega() -> Omega {
    let habit = Habit {
        scale: Normal::new(-0.2, 0.15),
        lateral_scale: Normal::new(-0.5, 0.2),
        alpha: Normal::new(0.2, 0.1),
        beta: Normal::new(0.8, 0.15),
        gamma: Normal::new(2.4, 0.3),
    };
    Omega { orders: vec![habit] }
}

/// A trunk of ten metres with a few limbs, as eight strokes give it.
pub(in crate::sketch) fn sketch() -> Branches {
    let mut b = Builder::default();
    let lateral = Label::Lateral(0);
    let t0 = b.add(None, Label::Apical, [0.1, 2.5, 0.0]);
    let t1 = b.add(Some(t0), Label::Apical, [0.0, 4.0, 0.2]);
    b.add(Some(t0), lateral, [-3.2, 4.5, 1.0]);
    let t2 = b.add(Some(t1), Label::Apical, [0.2, 5.5, 0.1]);
    let limb = b.add(Some(t1), lateral, [1.6, 5.2, -1.2]);
    b.add(Some(limb), Label::Apical, [3.3, 6.2, -2.0]);
    b.add(Some(limb), lateral, [2.6, 6.4, -0.3]);
    let t3 = b.add(Some(t2), Label::Apical, [0.1, 7.2, 0.0]);
    b.add(Some(t2), lateral, [-1.8, 7.4, -1.5]);
    b.add(Some(t3), Label::Apical, [0.0, 9.8, 0.3]);
    b.add(Some(t3), lateral, [1.7, 8.6, 1.1]);
    b.build()
}

pub(in crate::sketch) fn one_stroke() -> Branches {
    let mut b = Builder::default();
    b.add(None, Label::Apical, [0.3, 8.0, 0.0]);
    b.build()
}

/// The crown of an ellipse, as far as a polygon is one.
pub(in crate::sketch) fn ellipse(center: [f32; 2], radii: [f32; 2]) -> Crown {
    let corner = |i: u8| {
        let (sin, cos) = libm::sincosf(f32::from(i) * std::f32::consts::TAU / 64.0);
        Vec2::from(center) + Vec2::from(radii) * Vec2::new(cos, sin)
    };
    Crown::from_polygons(&[(0..64).map(corner).collect()], 1.0).unwrap()
}

/// A crown for [`sketch`].
pub(in crate::sketch) fn crown() -> Crown {
    ellipse([0.0, 6.5], [4.0, 4.2])
}

/// A palm whose apical segment is a frond as the others are.
pub(in crate::sketch) fn palm() -> Branches {
    let mut b = Builder::default();
    let trunk = b.add(None, Label::Apical, [0.0, 6.0, 0.0]);
    for i in 0..8 {
        let (sin, cos) = libm::sincosf(i as f32);
        let label = if i == 0 { Label::Apical } else { Label::Lateral(i - 1) };
        b.add(Some(trunk), label, [2.0 * cos, 6.5, 2.0 * sin]);
    }
    b.build()
}

/// Parameters of a palm: its fronds have no laterals to speak of.
pub(in crate::sketch) fn palm_omega() -> Omega {
    let mut omega = omega();
    let mut frond = omega.orders[0];
    frond.lateral_scale.mean = -9.0;
    omega.orders.push(frond);
    omega
}
