//! Trees of another size, or of another species.

use tree_core::{CoreError, Foliage, Leaf, Skeleton, Species, Tree};

/// The tree `scale` times as large, leaves and all.
pub(crate) fn scaled(tree: Tree, scale: f32) -> Result<Tree, CoreError> {
    if scale == 1.0 {
        return Ok(tree);
    }
    let parts = tree.into_parts();
    let positions = parts.skeleton.positions().iter().map(|&p| scale * p).collect();
    let radii = parts.skeleton.radii().iter().map(|&r| scale * r).collect();
    let skeleton = Skeleton::from_columns(positions, radii, parts.skeleton.parents().to_vec())?;
    let larger =
        |leaf: Leaf| Leaf { position: scale * leaf.position, size: scale * leaf.size, ..leaf };
    Tree::new(skeleton, foliage(&parts.foliage, larger)?, parts.species)
}

/// The tree as one of this species: its bark, and for each kind of leaf the species' own of that number, or its last.
pub(crate) fn dressed(tree: Tree, species: Species) -> Result<Tree, CoreError> {
    let parts = tree.into_parts();
    if species.leaf_kinds.is_empty() {
        return Ok(Tree::bare(parts.skeleton, species));
    }
    let last = (species.leaf_kinds.len() - 1).min(usize::from(u16::MAX)) as u16;
    let known = |leaf: Leaf| Leaf { kind: leaf.kind.min(last), ..leaf };
    Tree::new(parts.skeleton, foliage(&parts.foliage, known)?, species)
}

/// The tree without leaves.
pub(crate) fn bare(tree: Tree) -> Tree {
    let parts = tree.into_parts();
    Tree::bare(parts.skeleton, parts.species)
}

fn foliage(of: &Foliage, change: impl Fn(Leaf) -> Leaf) -> Result<Foliage, CoreError> {
    let mut foliage = Foliage::with_capacity(of.len());
    of.iter().try_for_each(|leaf| foliage.push(change(leaf)))?;
    Ok(foliage)
}
