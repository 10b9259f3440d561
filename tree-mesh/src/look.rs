//! What a species looks like: one material for the bark, one for each leaf kind.

use crate::error::{MeshError, Result};
use crate::leaf::{self, LeafForm, LeafModel};
use crate::mesh::{Alpha, Material};
use crate::texture;
use std::sync::Arc;
use tree_core::{ParameterError, Species};

/// Linear colour of plain bark: a grey brown.
const BARK_COLOR: [f32; 4] = [0.13, 0.09, 0.06, 1.0];
/// Darkens bark textures: drawn to be judged on a screen, they reflect too much beside leaves.
const BARK_TINT: [f32; 4] = [0.6, 0.6, 0.6, 1.0];
/// Linear colour of plain leaves: a dull green.
const LEAF_COLOR: [f32; 4] = [0.09, 0.2, 0.04, 1.0];
/// Narrowest picture in lengths of the leaf: longer needles than nature grows.
const WIDTH_MIN: f64 = 0.001;
/// Widest picture in lengths of the leaf, by symmetry.
const WIDTH_MAX: f64 = 1000.0;
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
///
/// ```
/// use tree_mesh::{LeafForm, LeafLook, Look};
/// let mut look = Look::built_in(&Default::default())?;
/// // A polygon around each leaf instead of a card, slightly folded and bent.
/// look.leaves[0].form = LeafForm::Outline { max_vertices: 8 };
/// look.leaves[0].bend = 0.6;
/// let model = look.leaves[0].model()?;
/// assert!(model.drawn < 0.8, "less is drawn than of a card");
/// # Ok::<(), tree_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LeafLook {
    /// Goes on the leaves. Should be double-sided, with an alpha mask where the texture has one.
    pub material: Material,
    /// Width of the picture in lengths of the leaf, 0.001 to 1000; 1 is square. Unused by
    /// [`LeafForm::Mesh`], which has its own.
    pub width: f32,
    /// What a leaf is cut out of. Default a card.
    pub form: LeafForm,
    /// Copies of the leaf turned about its midrib, evenly over half a turn, 1 to 8. Two or three
    /// make clusters and needles look full from all sides. Default 1.
    pub sheets: u32,
    /// Angle in radians by which each half of a leaf stands up along the midrib, 0 to 1.4. Default 0.
    pub fold: f32,
    /// Angle in radians by which the midrib bends down from base to apex, evenly, 0 to π. Default 0.
    pub bend: f32,
    /// Rows of triangles that a bent leaf has at least, 1 to 16. Default 2.
    pub rows: u32,
    /// Width of petioles in lengths of the leaf, 0 to 0.2: a prism of three sides from the shoot to the
    /// base of the leaf, eight vertices and six triangles a leaf. Default 0, none.
    pub petiole: f32,
}

impl Default for LeafLook {
    fn default() -> Self {
        Self {
            material: Material::default(),
            width: 1.0,
            form: LeafForm::Card,
            sheets: 1,
            fold: 0.0,
            bend: 0.0,
            rows: 2,
            petiole: 0.0,
        }
    }
}

impl LeafLook {
    /// The mesh of one leaf (one sheet, without petiole), for engines that instance leaves and to
    /// see how much of its triangles is visible.
    ///
    /// # Errors
    /// As [`LeafLook::check`], and [`MeshError::Texture`].
    ///
    /// # Complexity
    /// One pass over the picture; up to 0.3 million steps for the polygon.
    pub fn model(&self) -> Result<LeafModel> {
        self.check()?;
        leaf::model(self)
    }

    /// Checks every number against its range, and a leaf of your own.
    ///
    /// # Errors
    /// [`MeshError::Parameter`] or [`MeshError::LeafMesh`], naming what is wrong.
    pub fn check(&self) -> Result<()> {
        let vertices = match &self.form {
            LeafForm::Card => 4,
            LeafForm::Outline { max_vertices } | LeafForm::Modelled { max_vertices } => {
                *max_vertices
            }
            LeafForm::Mesh(mesh) => {
                mesh.check()?;
                4
            }
        };
        for (field, found, min, max) in [
            ("look.leaves.width", f64::from(self.width), WIDTH_MIN, WIDTH_MAX),
            ("look.leaves.form.max_vertices", f64::from(vertices), 4.0, 64.0),
            ("look.leaves.sheets", f64::from(self.sheets), 1.0, 8.0),
            ("look.leaves.fold", f64::from(self.fold), 0.0, 1.4),
            ("look.leaves.bend", f64::from(self.bend), 0.0, std::f64::consts::PI),
            ("look.leaves.rows", f64::from(self.rows), 1.0, 16.0),
            ("look.leaves.petiole", f64::from(self.petiole), 0.0, 0.2),
        ] {
            // A field given the decimal of a bound as f32 may lie half a step outside.
            let slack = f64::from(f32::EPSILON);
            if !(min * (1.0 - slack)..=max * (1.0 + slack)).contains(&found) {
                return Err(ParameterError { field: field.into(), found, min, max }.into());
            }
        }
        Ok(())
    }
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
            Ok(LeafLook { material, width: leaf.width, ..Default::default() })
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
            ..Default::default()
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

    /// Checks that every leaf kind of `species` has its look, and the looks themselves.
    ///
    /// # Errors
    /// [`MeshError::LeafMaterials`], or as [`LeafLook::check`].
    pub fn check(&self, species: &Species) -> Result<()> {
        let (found, expected) = (self.leaves.len(), species.leaf_kinds.len());
        if found != expected {
            return Err(MeshError::LeafMaterials { found, expected });
        }
        self.leaves.iter().try_for_each(LeafLook::check)
    }
}
