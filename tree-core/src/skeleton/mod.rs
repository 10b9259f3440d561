//! The skeleton: a rooted tree of nodes with positions and radii, stored in columns.
//!
//! Invariants, checked once when a skeleton is made and relied upon everywhere after:
//! node 0 is the only root, every parent comes before its children, positions and radii are finite
//! and radii are not negative. So one pass forwards visits parents first, one pass backwards visits
//! children first, and no algorithm on a skeleton needs recursion.
//!
//! A *segment* (internode) joins a node to its parent; it is named by the node at its upper end.

mod axes;
mod builder;
mod children;
mod measures;
mod reorder;

pub use axes::{Axes, Axis, Continuation};
pub use builder::SkeletonBuilder;
pub use children::Children;
pub use reorder::Reordered;

use crate::bounds::Aabb;
use crate::error::{CoreError, Result, check_finite, check_range};
use glam::Vec3;

/// Parent entry of the root.
pub const NO_PARENT: u32 = u32::MAX;

/// A rooted tree of nodes in columns: 20 bytes a node, never empty, never invalid.
///
/// ```
/// use tree_core::{Skeleton, glam::Vec3};
/// let mut builder = Skeleton::builder(Vec3::ZERO, 0.3)?;
/// let fork = builder.add(0, Vec3::Y, 0.2)?;
/// builder.add(fork, Vec3::new(1.0, 2.0, 0.0), 0.1)?;
/// builder.add(fork, Vec3::new(-1.0, 2.0, 0.0), 0.1)?;
/// let skeleton = builder.finish();
/// assert_eq!(skeleton.children().of(fork), [2, 3]);
/// # Ok::<(), tree_core::CoreError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "SkeletonColumns", into = "SkeletonColumns")
)]
pub struct Skeleton {
    positions: Vec<Vec3>,
    radii: Vec<f32>,
    parents: Vec<u32>,
}

/// The bare columns of a skeleton, not yet checked. `parents[0]` is [`NO_PARENT`].
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SkeletonColumns {
    /// Node positions in metres.
    pub positions: Vec<Vec3>,
    /// Node radii in metres, 0 or more.
    pub radii: Vec<f32>,
    /// Index of each node's parent, which comes before the node; [`NO_PARENT`] for node 0.
    pub parents: Vec<u32>,
}

impl TryFrom<SkeletonColumns> for Skeleton {
    type Error = CoreError;

    fn try_from(columns: SkeletonColumns) -> Result<Self> {
        Self::from_columns(columns.positions, columns.radii, columns.parents)
    }
}

impl From<Skeleton> for SkeletonColumns {
    fn from(skeleton: Skeleton) -> Self {
        Self { positions: skeleton.positions, radii: skeleton.radii, parents: skeleton.parents }
    }
}

impl Skeleton {
    /// Starts a skeleton at its root.
    ///
    /// # Errors
    /// As [`SkeletonBuilder::new`].
    pub fn builder(root_position: Vec3, root_radius: f32) -> Result<SkeletonBuilder> {
        SkeletonBuilder::new(root_position, root_radius)
    }

    /// Makes a skeleton of columns whose parents already come first. For any other order see
    /// [`Skeleton::from_unordered`].
    ///
    /// # Errors
    /// [`CoreError::Empty`], [`CoreError::Length`], [`CoreError::NotFinite`],
    /// [`CoreError::OutOfRange`] (a negative radius), [`CoreError::RootHasParent`],
    /// [`CoreError::SecondRoot`] or [`CoreError::ParentOrder`], each naming the row.
    pub fn from_columns(positions: Vec<Vec3>, radii: Vec<f32>, parents: Vec<u32>) -> Result<Self> {
        check_columns(&positions, &radii, parents.len())?;
        match parents[0] {
            NO_PARENT => {}
            parent => return Err(CoreError::RootHasParent { parent }),
        }
        for (node, &parent) in parents.iter().enumerate().skip(1) {
            if parent == NO_PARENT {
                return Err(CoreError::SecondRoot { node });
            }
            if parent as usize >= node {
                return Err(CoreError::ParentOrder { node, parent });
            }
        }
        Ok(Self { positions, radii, parents })
    }

    /// Checks the invariants anew. A `Skeleton` always passes; tests and fuzz targets call this.
    ///
    /// # Errors
    /// As [`Skeleton::from_columns`].
    pub fn check(&self) -> Result<()> {
        Self::from_columns(self.positions.clone(), self.radii.clone(), self.parents.clone())
            .map(|_| ())
    }

    /// Number of nodes, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a skeleton is never empty")]
    pub fn len(&self) -> usize {
        self.parents.len()
    }

    /// Node positions in metres.
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Node radii in metres.
    #[must_use]
    pub fn radii(&self) -> &[f32] {
        &self.radii
    }

    /// Parent of each node; [`NO_PARENT`] for node 0.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// Parent of one node; `None` for the root and for a node that does not exist.
    #[must_use]
    pub fn parent(&self, node: u32) -> Option<u32> {
        self.parents.get(node as usize).copied().filter(|&parent| parent != NO_PARENT)
    }

    /// Every segment as (parent, node), in node order.
    pub fn segments(&self) -> impl ExactSizeIterator<Item = (u32, u32)> + '_ {
        (1..self.len()).map(|node| (self.parents[node], node as u32))
    }

    /// The box around all nodes, radii not counted.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb::of_points(&self.positions)
    }

    /// Replaces all radii.
    ///
    /// # Errors
    /// [`CoreError::Length`], [`CoreError::NotFinite`] or [`CoreError::OutOfRange`]; the skeleton
    /// is unchanged then.
    pub fn set_radii(&mut self, radii: Vec<f32>) -> Result<()> {
        check_columns(&self.positions, &radii, self.parents.len())?;
        self.radii = radii;
        Ok(())
    }

    /// Replaces all positions.
    ///
    /// # Errors
    /// [`CoreError::Length`] or [`CoreError::NotFinite`]; the skeleton is unchanged then.
    pub fn set_positions(&mut self, positions: Vec<Vec3>) -> Result<()> {
        check_columns(&positions, &self.radii, self.parents.len())?;
        self.positions = positions;
        Ok(())
    }
}

/// Lengths agree, at least one row, coordinates finite, radii finite and not negative.
fn check_columns(positions: &[Vec3], radii: &[f32], n_nodes: usize) -> Result<()> {
    if n_nodes == 0 {
        return Err(CoreError::Empty { what: "skeleton" });
    }
    for (field, found) in [("positions", positions.len()), ("radii", radii.len())] {
        if found != n_nodes {
            return Err(CoreError::Length { field, found, expected: n_nodes });
        }
    }
    if n_nodes >= NO_PARENT as usize {
        return Err(CoreError::OutOfRange {
            field: "nodes",
            index: 0,
            found: n_nodes as f64,
            min: 1.0,
            max: f64::from(NO_PARENT - 1),
        });
    }
    check_finite("positions", positions)?;
    for (index, &radius) in radii.iter().enumerate() {
        check_range("radii", index, radius, 0.0, f32::MAX)?;
    }
    Ok(())
}

#[cfg(test)]
pub(crate) mod tests;
