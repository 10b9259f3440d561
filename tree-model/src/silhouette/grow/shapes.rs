//! Shapes that branches are made of, with what is asked of them often.

use crate::silhouette::branch::Shape;
use crate::silhouette::place::revolve::{Revolved, Section};
use crate::silhouette::plan::System;
use crate::silhouette::{Line, Outline};
use glam::{Vec2, Vec3};

/// A branch's form in the frame of its span: its axis, and how far its foliage reaches to all sides.
pub(super) struct Form {
    /// From (0, 0) to (0, 1).
    pub(super) line: Line,
    /// The angle from the span to the direction it leaves in, towards the outer side.
    pub(super) leaving: f32,
    /// How far its outline reaches along the span, in spans.
    pub(super) reach: f32,
    surface: Revolved,
}

impl Form {
    pub(super) fn of(shape: &Shape) -> Self {
        let section = Section { azimuth: 0.0, outline: &shape.outline };
        Self::new(&shape.line, &shape.outline, Revolved::of(&shape.line, &[section]))
    }

    /// Of a system in the frame of its span.
    pub(super) fn of_system(system: &System) -> Self {
        Self::new(&system.axis, &system.outline, surface_of(system))
    }

    fn new(line: &Line, outline: &Outline, surface: Revolved) -> Self {
        let foot = line.foot();
        Self {
            line: line.clone(),
            leaving: libm::atan2f(foot.x, foot.y),
            reach: outline.bounds().1.y.max(1.0),
            surface,
        }
    }

    /// How far it is from a point of the axis along a direction in space to the surface, where the direction stands at
    /// `azimuth` round the axis. `None` from outside.
    pub(super) fn room(&self, base: Vec2, way: Vec3, azimuth: f32) -> Option<f32> {
        let (sin, cos) = libm::sincosf(azimuth);
        let across = way.x * cos + way.z * sin;
        let within = Vec2::new(across, way.y);
        let share = within.length();
        let exit = self.surface.exit(Vec2::new(base.x * cos, base.y), within / share, azimuth)?;
        let room = exit / share;
        room.is_finite().then_some(room)
    }

    /// Its outline as seen from the side at an azimuth, in (distance from the axis, along the span).
    pub(super) fn profile(&self, azimuth: f32) -> Option<Outline> {
        self.surface.profile(azimuth)
    }
}

/// The pseudo-surface of revolution of a system.
pub(super) fn surface_of(system: &System) -> Revolved {
    let mut sections = vec![Section { azimuth: 0.0, outline: &system.outline }];
    sections.extend(
        system
            .sections
            .iter()
            .map(|section| Section { azimuth: section.azimuth, outline: &section.outline }),
    );
    Revolved::of(&system.axis, &sections)
}
