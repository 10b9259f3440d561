//! A whole tree: skeleton, foliage and species.

use crate::error::{CoreError, Result};
use crate::foliage::Foliage;
use crate::skeleton::Skeleton;

/// What kind of tree it is. Names are looked up by the mesher, which has textures for the built-in
/// ones and takes the user's for all others.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Species {
    /// Name for people and files.
    pub name: String,
    /// Name of the bark.
    pub bark: String,
    /// Names of the leaf kinds; [`Leaf::kind`](crate::Leaf::kind) is an index into them.
    pub leaf_kinds: Vec<String>,
}

impl Default for Species {
    fn default() -> Self {
        Self { name: "oak".into(), bark: "oak".into(), leaf_kinds: vec!["oak".into()] }
    }
}

/// A botanical tree. Every leaf sits on a node that exists and has a kind that exists.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "TreeParts", into = "TreeParts")
)]
pub struct Tree {
    skeleton: Skeleton,
    foliage: Foliage,
    species: Species,
}

/// The parts of a tree, not yet checked against each other.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TreeParts {
    /// The branches.
    pub skeleton: Skeleton,
    /// The leaves.
    pub foliage: Foliage,
    /// The kind of tree.
    pub species: Species,
}

impl Tree {
    /// Joins the parts.
    ///
    /// # Errors
    /// [`CoreError::Dangling`] when a leaf names a node or a kind that is not there.
    pub fn new(skeleton: Skeleton, foliage: Foliage, species: Species) -> Result<Self> {
        let dangling = |what, count: usize, column: &mut dyn Iterator<Item = u32>| match column
            .enumerate()
            .find(|&(_, found)| found as usize >= count)
        {
            Some((leaf, found)) => Err(CoreError::Dangling { leaf, what, found, count }),
            None => Ok(()),
        };
        dangling("node", skeleton.len(), &mut foliage.nodes().iter().copied())?;
        dangling(
            "kind",
            species.leaf_kinds.len(),
            &mut foliage.kinds().iter().map(|&kind| u32::from(kind)),
        )?;
        Ok(Self { skeleton, foliage, species })
    }

    /// A tree without leaves.
    #[must_use]
    pub fn bare(skeleton: Skeleton, species: Species) -> Self {
        Self { skeleton, foliage: Foliage::default(), species }
    }

    /// The branches.
    #[must_use]
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// The leaves.
    #[must_use]
    pub fn foliage(&self) -> &Foliage {
        &self.foliage
    }

    /// The kind of tree.
    #[must_use]
    pub fn species(&self) -> &Species {
        &self.species
    }

    /// The parts, to be changed and joined again.
    #[must_use]
    pub fn into_parts(self) -> TreeParts {
        TreeParts { skeleton: self.skeleton, foliage: self.foliage, species: self.species }
    }
}

impl TryFrom<TreeParts> for Tree {
    type Error = CoreError;

    fn try_from(parts: TreeParts) -> Result<Self> {
        Self::new(parts.skeleton, parts.foliage, parts.species)
    }
}

impl From<Tree> for TreeParts {
    fn from(tree: Tree) -> Self {
        tree.into_parts()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::foliage::Leaf;
    use glam::{Quat, Vec3};

    #[test]
    fn leaves_must_sit_on_nodes_and_have_kinds_that_exist() {
        let leaf =
            Leaf { node: 0, position: Vec3::ZERO, rotation: Quat::IDENTITY, size: 1.0, kind: 0 };
        let join = |leaf: Leaf| {
            let foliage = Foliage::try_from(vec![leaf]).unwrap();
            Tree::new(
                Skeleton::builder(Vec3::ZERO, 1.0).unwrap().finish(),
                foliage,
                Species::default(),
            )
        };
        assert!(join(leaf).is_ok());
        let far = join(Leaf { node: 1, ..leaf }).unwrap_err();
        assert!(matches!(far, CoreError::Dangling { leaf: 0, what: "node", found: 1, count: 1 }));
        let odd = join(Leaf { kind: 7, ..leaf }).unwrap_err();
        assert!(matches!(odd, CoreError::Dangling { leaf: 0, what: "kind", found: 7, count: 1 }));
    }
}
