//! Building a skeleton node by node.

use super::{NO_PARENT, Skeleton};
use crate::error::{CoreError, Result, check_finite, check_range};
use glam::Vec3;

/// Grows a skeleton from its root. The root and every [`add`](Self::add) are checked, so
/// [`finish`](Self::finish) has nothing left to refuse.
#[derive(Clone, Debug)]
pub struct SkeletonBuilder {
    positions: Vec<Vec3>,
    radii: Vec<f32>,
    parents: Vec<u32>,
}

impl SkeletonBuilder {
    /// Starts at the root.
    ///
    /// # Errors
    /// [`CoreError::NotFinite`] or [`CoreError::OutOfRange`] for its position or radius.
    pub fn new(root_position: Vec3, root_radius: f32) -> Result<Self> {
        check_finite("positions", &[root_position])?;
        check_range("radii", 0, root_radius, 0.0, f32::MAX)?;
        Ok(Self {
            positions: vec![root_position],
            radii: vec![root_radius],
            parents: vec![NO_PARENT],
        })
    }

    /// Adds a node above `parent` and returns its index.
    ///
    /// # Errors
    /// [`CoreError::ParentOrder`] when there is no such parent yet, [`CoreError::NotFinite`] or
    /// [`CoreError::OutOfRange`] for the position or radius; nothing is added then.
    pub fn add(&mut self, parent: u32, position: Vec3, radius: f32) -> Result<u32> {
        let node = self.parents.len();
        if parent as usize >= node || node >= NO_PARENT as usize {
            return Err(CoreError::ParentOrder { node, parent });
        }
        check_finite("positions", &[position])
            .map_err(|_| CoreError::NotFinite { field: "positions", index: node })?;
        check_range("radii", node, radius, 0.0, f32::MAX)?;
        self.positions.push(position);
        self.radii.push(radius);
        self.parents.push(parent);
        Ok(node as u32)
    }

    /// Number of nodes so far, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "the root is always there")]
    pub fn len(&self) -> usize {
        self.parents.len()
    }

    /// The finished skeleton.
    #[must_use]
    pub fn finish(self) -> Skeleton {
        Skeleton { positions: self.positions, radii: self.radii, parents: self.parents }
    }
}
