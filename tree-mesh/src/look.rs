//! What a species looks like: one material for the bark, one for each leaf kind.

use crate::error::{MeshError, Result};
use crate::mesh::{Alpha, Material};
use tree_core::Species;

/// Linear colour of plain bark: a grey brown.
const BARK_COLOR: [f32; 4] = [0.13, 0.09, 0.06, 1.0];
/// Linear colour of plain leaves: a dull green.
const LEAF_COLOR: [f32; 4] = [0.09, 0.2, 0.04, 1.0];
/// Share of light that plain leaves let through; measured broad leaves have 0.3 to 0.5.
const LEAF_TRANSLUCENCY: f32 = 0.4;

/// The materials a tree is dressed in.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Goes on all wood.
    pub bark: Material,
    /// One for each of [`Species::leaf_kinds`], in that order. They should be double-sided.
    pub leaves: Vec<Material>,
}

impl Look {
    /// Plain colours without textures: for previews, tests and engines that bring their own
    /// materials. Leaf cards show as whole rectangles.
    #[must_use]
    pub fn plain(species: &Species) -> Self {
        let leaf = |kind: &String| Material {
            name: format!("{kind} leaf"),
            base_color: LEAF_COLOR,
            roughness: 0.7,
            alpha: Alpha::Opaque,
            double_sided: true,
            translucency: LEAF_TRANSLUCENCY,
            texture: None,
        };
        Self {
            bark: Material {
                name: format!("{} bark", species.bark),
                base_color: BARK_COLOR,
                ..Default::default()
            },
            leaves: species.leaf_kinds.iter().map(leaf).collect(),
        }
    }

    /// Checks that every leaf kind of `species` has its material.
    ///
    /// # Errors
    /// [`MeshError::LeafMaterials`].
    pub fn check(&self, species: &Species) -> Result<()> {
        let (found, expected) = (self.leaves.len(), species.leaf_kinds.len());
        if found == expected { Ok(()) } else { Err(MeshError::LeafMaterials { found, expected }) }
    }
}
