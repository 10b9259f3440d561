//! Where something stands.

use crate::border::Result;
use glam::{Quat, Vec3};
use tree_model::plastic::Pose;

/// Where something stands and how it is turned: a point p of its own frame is at rotation · p + position in the world.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_pose {
    /// In metres, at most 1,000 km from the origin along each axis.
    pub position: [f32; 3],
    /// A quaternion, x, y, z, w, of any length but 0. 0, 0, 0, 1 is not turned.
    pub rotation: [f32; 4],
}

impl tree_pose {
    pub(super) fn of(pose: Pose) -> Self {
        Self { position: pose.position.to_array(), rotation: pose.rotation.to_array() }
    }

    /// NULL is the origin, not turned.
    ///
    /// # Safety
    /// `pose` is NULL or points at a pose.
    pub(super) unsafe fn read(pose: *const Self) -> Result<Pose> {
        if pose.is_null() {
            return Ok(Pose::default());
        }
        // SAFETY: not NULL, and there by contract.
        let Self { position, rotation } = unsafe { pose.read_unaligned() };
        Ok(Pose { position: Vec3::from(position), rotation: Quat::from_array(rotation) })
    }
}
