//! What a species looks like: one material for the bark, one for each leaf kind.

use crate::error::{MeshError, Result};
use crate::mesh::{Alpha, Material};
use crate::texture;
use std::sync::Arc;
use tree_core::Species;

/// Linear colour of plain bark: a grey brown.
const BARK_COLOR: [f32; 4] = [0.13, 0.09, 0.06, 1.0];
/// Darkens bark textures: drawn to be judged on a screen, they reflect too much beside leaves.
const BARK_TINT: [f32; 4] = [0.6, 0.6, 0.6, 1.0];
/// Linear colour of plain leaves: a dull green.
const LEAF_COLOR: [f32; 4] = [0.09, 0.2, 0.04, 1.0];
/// Narrowest card in lengths of the leaf: longer needles than nature grows.
const CARD_WIDTH_MIN: f64 = 0.001;
/// Widest card in lengths of the leaf, by symmetry.
const CARD_WIDTH_MAX: f64 = 1000.0;
/// Share of light that plain leaves let through; measured broad leaves have 0.3 to 0.5.
const LEAF_TRANSLUCENCY: f32 = 0.4;
/// Alpha under which leaf textures are cut away; they are drawn for one half.
const LEAF_CUTOFF: f32 = 0.5;
const LEAF_ROUGHNESS: f32 = 0.7;
const BARK_ROUGHNESS: f32 = 0.95;

/// The materials a tree is dressed in.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Goes on all wood.
    pub bark: Material,
    /// One for each of [`Species::leaf_kinds`], in that order.
    pub leaves: Vec<LeafLook>,
}

/// What leaves of one kind look like.
#[derive(Clone, Debug, PartialEq)]
pub struct LeafLook {
    /// Goes on the cards. Should be double-sided, with an alpha mask where the texture has one.
    pub material: Material,
    /// Width of a card in lengths of the leaf, 0.001 to 1000; 1 is square.
    pub width: f32,
}

impl Look {
    /// The built-in bark and leaf textures that the species names, see [`texture`].
    ///
    /// # Errors
    /// [`MeshError::Unknown`] for a name that is not built in; dress such species with
    /// [`Look::plain`] and textures of your own.
    pub fn built_in(species: &Species) -> Result<Self> {
        let bark = Material {
            name: format!("{} bark", species.bark),
            base_color: BARK_TINT,
            texture: Some(Arc::new(texture::bark(&species.bark)?)),
            roughness: BARK_ROUGHNESS,
            ..Default::default()
        };
        let leaf = |kind: &String| {
            let leaf = texture::leaf(kind)?;
            let material = Material {
                name: format!("{kind} leaf"),
                texture: Some(Arc::new(leaf.texture)),
                roughness: LEAF_ROUGHNESS,
                alpha: Alpha::Mask(LEAF_CUTOFF),
                double_sided: true,
                translucency: LEAF_TRANSLUCENCY,
                ..Default::default()
            };
            Ok(LeafLook { material, width: leaf.width })
        };
        let leaves = species.leaf_kinds.iter().map(leaf).collect::<Result<Vec<_>>>()?;
        Ok(Self { bark, leaves })
    }

    /// Plain colours without textures: for previews, tests and engines that bring their own
    /// materials. Leaf cards show as whole rectangles.
    #[must_use]
    pub fn plain(species: &Species) -> Self {
        let leaf = |kind: &String| LeafLook {
            material: Material {
                name: format!("{kind} leaf"),
                base_color: LEAF_COLOR,
                roughness: LEAF_ROUGHNESS,
                alpha: Alpha::Opaque,
                double_sided: true,
                translucency: LEAF_TRANSLUCENCY,
                texture: None,
            },
            width: 1.0,
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

    /// Checks that every leaf kind of `species` has its material, and cards their widths.
    ///
    /// # Errors
    /// [`MeshError::LeafMaterials`], or [`MeshError::Parameter`] for a width outside its range.
    pub fn check(&self, species: &Species) -> Result<()> {
        let (found, expected) = (self.leaves.len(), species.leaf_kinds.len());
        if found != expected {
            return Err(MeshError::LeafMaterials { found, expected });
        }
        let allowed = CARD_WIDTH_MIN..=CARD_WIDTH_MAX;
        match self.leaves.iter().find(|leaf| !allowed.contains(&f64::from(leaf.width))) {
            Some(leaf) => Err(MeshError::Parameter {
                field: "look.leaves.width",
                found: leaf.width.into(),
                min: CARD_WIDTH_MIN,
                max: CARD_WIDTH_MAX,
            }),
            None => Ok(()),
        }
    }
}
