//! Leaves in columns: a tree with a million of them stays cheap (38 bytes each).

use crate::error::{CoreError, Result, check_finite, check_range};
use glam::{Quat, Vec3};

/// One leaf, as it goes into and comes out of a [`Foliage`]: one blade (lamina). Each leaflet of a
/// compound leaf and each needle of a fascicle is a leaf of its own.
///
/// The petiole is not stored. It runs from the point of the bearing segment (from the parent of
/// [`node`](Self::node) to `node`) that is nearest to [`position`](Self::position), out to `position`;
/// who draws leaves may draw it, and the part of it that is inside the wood does not show. Where
/// petioles and rachises are branches of the skeleton, `node` is the stalk's, and nothing is left to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Leaf {
    /// Skeleton node that bears the leaf.
    pub node: u32,
    /// Base of the blade in metres: where the petiole ends, off the shoot by the petiole's length.
    pub position: Vec3,
    /// Turns the leaf's own frame into the tree's. In its own frame a leaf starts at the origin,
    /// its midrib runs along +Y and its upper face looks along +Z.
    pub rotation: Quat,
    /// Length from base to apex in metres, 0 or more.
    pub size: f32,
    /// Index into [`Species::leaf_kinds`](crate::Species::leaf_kinds).
    pub kind: u16,
}

/// Rounding that a unit quaternion's length may have.
const UNIT_TOLERANCE: f32 = 1e-6;

/// The leaves of a tree, in columns. Positions and sizes are finite, rotations are unit quaternions.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Vec<Leaf>", into = "Vec<Leaf>")
)]
pub struct Foliage {
    nodes: Vec<u32>,
    positions: Vec<Vec3>,
    rotations: Vec<Quat>,
    sizes: Vec<f32>,
    kinds: Vec<u16>,
}

impl Foliage {
    /// Room for `n_leaves` leaves.
    #[must_use]
    pub fn with_capacity(n_leaves: usize) -> Self {
        Self {
            nodes: Vec::with_capacity(n_leaves),
            positions: Vec::with_capacity(n_leaves),
            rotations: Vec::with_capacity(n_leaves),
            sizes: Vec::with_capacity(n_leaves),
            kinds: Vec::with_capacity(n_leaves),
        }
    }

    /// Adds a leaf. The rotation is brought to unit length; one that has it keeps its bits, so that a leaf
    /// comes out of a file as it went in.
    ///
    /// # Errors
    /// [`CoreError::NotFinite`] or [`CoreError::OutOfRange`], naming the column and the row the
    /// leaf would have had; nothing is added then.
    pub fn push(&mut self, leaf: Leaf) -> Result<()> {
        let index = self.len();
        check_finite("foliage positions", &[leaf.position])
            .map_err(|_| CoreError::NotFinite { field: "foliage positions", index })?;
        check_range("foliage sizes", index, leaf.size, 0.0, f32::MAX)?;
        let length = leaf.rotation.length();
        if !length.is_finite() || length < 1e-6 {
            return Err(CoreError::NotFinite { field: "foliage rotations", index });
        }
        self.nodes.push(leaf.node);
        self.positions.push(leaf.position);
        let is_unit = (length - 1.0).abs() <= UNIT_TOLERANCE;
        self.rotations.push(if is_unit { leaf.rotation } else { leaf.rotation / length });
        self.sizes.push(leaf.size);
        self.kinds.push(leaf.kind);
        Ok(())
    }

    /// Number of leaves.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is no leaf.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// One leaf; `None` past the end.
    #[must_use]
    pub fn get(&self, index: usize) -> Option<Leaf> {
        Some(Leaf {
            node: *self.nodes.get(index)?,
            position: *self.positions.get(index)?,
            rotation: *self.rotations.get(index)?,
            size: *self.sizes.get(index)?,
            kind: *self.kinds.get(index)?,
        })
    }

    /// All leaves in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Leaf> + '_ {
        (0..self.len()).map(|i| Leaf {
            node: self.nodes[i],
            position: self.positions[i],
            rotation: self.rotations[i],
            size: self.sizes[i],
            kind: self.kinds[i],
        })
    }

    /// The node that bears each leaf.
    #[must_use]
    pub fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    /// The base of each leaf's blade, in metres.
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Each leaf's turn from its own frame into the tree's.
    #[must_use]
    pub fn rotations(&self) -> &[Quat] {
        &self.rotations
    }

    /// Length of each leaf in metres.
    #[must_use]
    pub fn sizes(&self) -> &[f32] {
        &self.sizes
    }

    /// Kind of each leaf.
    #[must_use]
    pub fn kinds(&self) -> &[u16] {
        &self.kinds
    }
}

impl TryFrom<Vec<Leaf>> for Foliage {
    type Error = CoreError;

    fn try_from(leaves: Vec<Leaf>) -> Result<Self> {
        let mut foliage = Self::with_capacity(leaves.len());
        for leaf in leaves {
            foliage.push(leaf)?;
        }
        Ok(foliage)
    }
}

impl From<Foliage> for Vec<Leaf> {
    fn from(foliage: Foliage) -> Self {
        foliage.iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEAF: Leaf =
        Leaf { node: 3, position: Vec3::Y, rotation: Quat::IDENTITY, size: 0.1, kind: 0 };

    #[test]
    fn a_leaf_comes_out_as_it_went_in() {
        let foliage = Foliage::try_from(vec![LEAF, Leaf { kind: 1, ..LEAF }]).unwrap();
        assert_eq!(foliage.get(0), Some(LEAF));
        assert_eq!(foliage.get(2), None);
        assert_eq!(Vec::from(foliage)[1].kind, 1);
    }

    #[test]
    fn rotations_are_normalised_and_zero_ones_refused() {
        let mut foliage = Foliage::default();
        foliage.push(Leaf { rotation: Quat::from_xyzw(0.0, 0.0, 0.0, 5.0), ..LEAF }).unwrap();
        assert_eq!(foliage.rotations()[0], Quat::IDENTITY);
        let zero = Leaf { rotation: Quat::from_xyzw(0.0, 0.0, 0.0, 0.0), ..LEAF };
        assert!(foliage.push(zero).is_err());
        assert!(foliage.push(Leaf { size: f32::NAN, ..LEAF }).is_err());
        assert!(foliage.push(Leaf { position: Vec3::INFINITY, ..LEAF }).is_err());
        assert_eq!(foliage.len(), 1);
    }
}
