//! The reference: vertices moved by the wind on the CPU, with nothing but what vertices carry.

use super::{Branch, sway, vertices};
use crate::error::Result;
use crate::mesh::Mesh;
use glam::{Affine3A, Mat3, Quat, Vec3};
use std::f32::consts::TAU;
use tree_core::check_parameter;

/// A steady wind with gusts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wind {
    /// Where it blows to; its length does not matter.
    pub direction: Vec3,
    /// Turn of a branch without any stiffness, in radians. Default 0.5.
    pub strength: f32,
    /// Share of the turn that swings to and fro, 0 to 1. Default 0.4.
    pub gusts: f32,
    /// Swings in a second. Default 0.5.
    pub frequency: f32,
    /// How far leaves turn to and fro at their anchors, in radians. Default 0.3.
    pub flutter: f32,
}

impl Default for Wind {
    fn default() -> Self {
        Self { direction: Vec3::X, strength: 0.5, gusts: 0.4, frequency: 0.5, flutter: 0.3 }
    }
}

impl Wind {
    /// Checks every field against its range. [`bend`] does without: it gives numbers that are not finite
    /// for a wind that is not.
    ///
    /// # Errors
    /// [`MeshError::Parameter`](crate::MeshError::Parameter), naming the first field at fault and its range.
    pub fn validate(&self) -> Result<()> {
        let [x, y, z] = self.direction.to_array();
        for (field, found, min, max) in [
            ("direction", x, -1e6, 1e6),
            ("direction", y, -1e6, 1e6),
            ("direction", z, -1e6, 1e6),
            ("strength", self.strength, -10.0, 10.0),
            ("gusts", self.gusts, 0.0, 1.0),
            ("frequency", self.frequency, 0.0, 100.0),
            ("flutter", self.flutter, -10.0, 10.0),
        ] {
            check_parameter(field, found, min, max)?;
        }
        Ok(())
    }

    /// Turn of a branch at its tip, in radians.
    fn angle(&self, branch: &Branch, seconds: f32) -> f32 {
        let swing = libm::sinf(TAU * (self.frequency * seconds + branch.phase));
        self.strength * branch.give() * (1.0 - self.gusts + self.gusts * swing)
    }

    /// The axis that turns a branch towards where the wind blows to.
    fn about(&self, branch: &Branch) -> Option<Vec3> {
        branch.axis.cross(self.direction).try_normalize()
    }
}

/// The turn that a branch makes at a point.
struct Turn {
    pivot: Vec3,
    about: Option<Vec3>,
    angle: f32,
}

impl Turn {
    fn at(&self, reach: f32) -> Affine3A {
        match self.about {
            Some(about) if reach > 0.0 => turn(self.pivot, about, self.angle * sway(reach)),
            _ => Affine3A::IDENTITY,
        }
    }
}

fn turn(pivot: Vec3, about: Vec3, angle: f32) -> Affine3A {
    // By hand, since Quat::from_axis_angle is not under our libm in every build of glam.
    let (sin, cos) = libm::sincosf(0.5 * angle);
    let turned = Mat3::from_quat(Quat::from_xyzw(about.x * sin, about.y * sin, about.z * sin, cos));
    Affine3A::from_mat3_translation(turned, pivot - turned * pivot)
}

/// Positions of all surfaces, moved by the wind, `seconds` after it began.
///
/// A vertex whose branch is unknown stays where it is.
///
/// # Errors
/// As [`vertices`].
///
/// # Complexity
/// O(branches + vertices), whatever the depth of the hierarchy.
pub fn bend(mesh: &Mesh, wind: &Wind, seconds: f32) -> Result<Vec<Vec<Vec3>>> {
    let motion = Motion::new(mesh, wind, seconds);
    (0..mesh.surfaces.len()).map(|number| motion.surface(mesh, number)).collect()
}

/// As [`bend`], of one surface only.
///
/// # Errors
/// As [`vertices`].
///
/// # Complexity
/// O(branches + vertices of the surface).
pub fn bend_surface(mesh: &Mesh, wind: &Wind, seconds: f32, number: usize) -> Result<Vec<Vec3>> {
    Motion::new(mesh, wind, seconds).surface(mesh, number)
}

/// What all branches do at one moment.
struct Motion<'a> {
    wind: &'a Wind,
    seconds: f32,
    turns: Vec<Turn>,
    /// How each branch is carried by those below it.
    carried: Vec<Affine3A>,
}

impl<'a> Motion<'a> {
    fn new(mesh: &Mesh, wind: &'a Wind, seconds: f32) -> Self {
        let turns: Vec<Turn> = mesh
            .branches
            .iter()
            .map(|branch| Turn {
                pivot: branch.pivot,
                about: wind.about(branch),
                angle: wind.angle(branch, seconds),
            })
            .collect();
        // Parents come first.
        let mut carried: Vec<Affine3A> = Vec::with_capacity(turns.len());
        for (number, branch) in mesh.branches.iter().enumerate() {
            let parent = branch.parent as usize;
            carried.push(match (mesh.branches.get(parent), carried.get(parent)) {
                (Some(below), Some(&carry)) if parent < number => {
                    carry * turns[parent].at(below.reach(branch.pivot))
                }
                _ => Affine3A::IDENTITY,
            });
        }
        Self { wind, seconds, turns, carried }
    }

    fn surface(&self, mesh: &Mesh, number: usize) -> Result<Vec<Vec3>> {
        let surface = mesh.surface(number)?;
        let moved = |(&position, at): (&Vec3, super::VertexWind)| {
            let branch = at.branch as usize;
            let (Some(turn), Some(&carry)) = (self.turns.get(branch), self.carried.get(branch))
            else {
                return position;
            };
            let fluttered = flutter(position, &at, self.wind, self.seconds);
            (carry * turn.at(at.reach)).transform_point3(fluttered)
        };
        Ok(surface.positions.iter().zip(vertices(mesh, number)?).map(moved).collect())
    }
}

/// A leaf's vertex, turned to and fro about the horizontal through its anchor.
fn flutter(position: Vec3, at: &super::VertexWind, wind: &Wind, seconds: f32) -> Vec3 {
    let stem = position - at.anchor;
    let Some(about) = stem.cross(Vec3::Y).try_normalize() else { return position };
    if at.flutter <= 0.0 {
        return position;
    }
    // Leaves flutter several times as fast as branches swing.
    let swing = libm::sinf(TAU * (5.0 * wind.frequency * seconds + at.leaf_phase));
    turn(at.anchor, about, wind.flutter * at.flutter * swing).transform_point3(position)
}
