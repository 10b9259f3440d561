//! The models of the evaluation: imported ones that nobody here made, and trees of ours.

use super::{Outcome, modelled};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tree_core::{Control, Seed};
use tree_lod::{Elements, Grain, LeafSurfaces};
use tree_mesh::io::{self, ImportOptions};
use tree_mesh::{Alpha, LeafForm, LeafLook, Look, Mesh, MeshParams, build};
use tree_model::path::Preset;

/// Trees of ours grow from this seed.
const SEED: Seed = Seed(8);
/// Width of a modelled leaf of ours, in lengths.
const LEAF_WIDTH: f32 = 0.62;
/// Metres per unit of the ez-tree models, which are tens of units tall: trees of 8 to 14 m.
const EZ_TREE_UNIT: f32 = 0.2;

/// What the leaves of a model are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Leaves {
    /// Pictures with a mask on quads.
    Cards,
    /// Pictures with a mask on polygons.
    Outlines,
    /// Triangles along the margin, opaque.
    Modelled,
}

/// A tree, ready to be pruned.
pub(super) struct Model {
    pub(super) name: String,
    pub(super) mesh: Mesh,
    pub(super) elements: Elements,
    pub(super) leaves: Leaves,
    /// Whether nobody here made it.
    pub(super) imported: bool,
    /// Whether it is of the table in PEERS.md.
    pub(super) of_peers: bool,
}

impl Model {
    fn new(name: &str, mesh: Mesh, leaves: Leaves, imported: bool) -> Outcome<Self> {
        let elements =
            Elements::of_mesh(&mesh, &LeafSurfaces::Found, Grain::Blade, &Control::default())?;
        let of_peers = IMPORTED[..OF_PEERS].iter().any(|row| name.starts_with(row.0));
        Ok(Self { name: name.into(), mesh, elements, leaves, imported, of_peers })
    }

    /// Height in metres.
    #[cfg(test)]
    pub(super) fn height(&self) -> f32 {
        self.mesh.bounds().max.y
    }
}

/// Models of other people: file, metres per unit, leaves. The first three are those of the table in
/// PEERS.md.
const IMPORTED: [(&str, f32, Leaves); 4] = [
    ("eztree_oak_medium", EZ_TREE_UNIT, Leaves::Cards),
    ("eztree_pine_small", EZ_TREE_UNIT, Leaves::Cards),
    ("eztree_aspen_medium", EZ_TREE_UNIT, Leaves::Cards),
    ("appletree_amap", 1.0, Leaves::Modelled),
];
/// How many of them are of the table in PEERS.md.
const OF_PEERS: usize = 3;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/meshes")
}

/// The imported models that are there; a notice for those that are not.
pub(super) fn imported() -> Outcome<Vec<Model>> {
    IMPORTED.iter().filter_map(|row| read(row).transpose()).collect()
}

/// The ez-tree models of the table in PEERS.md, that are there.
pub(super) fn of_peers() -> Outcome<Vec<Model>> {
    IMPORTED[..OF_PEERS].iter().filter_map(|row| read(row).transpose()).collect()
}

/// A model of cards with modelled leaves in their place.
pub(super) fn with_modelled_leaves(model: &Model) -> Outcome<Model> {
    let mesh = modelled::instead_of_cards(&model.mesh, &model.elements)?;
    let name = format!("{}, modelled leaves", model.name);
    Model::new(&name, mesh, Leaves::Modelled, model.imported)
}

fn read(&(name, unit, leaves): &(&str, f32, Leaves)) -> Outcome<Option<Model>> {
    let path = folder().join(name).with_extension("glb");
    if !path.exists() {
        eprintln!("{name}: not there, left out");
        return Ok(None);
    }
    let mut mesh = io::read(&path, &ImportOptions::default(), &Control::default())?.mesh;
    for surface in &mut mesh.surfaces {
        surface.positions.iter_mut().for_each(|p| *p *= unit);
    }
    Model::new(name, mesh, leaves, true).map(Some)
}

/// A tree of ours: a preset with other leaves.
#[derive(Clone, Copy)]
struct Recipe {
    name: &'static str,
    preset: &'static str,
    leaves: Leaves,
    /// Copies of each card or outline, turned about the midrib.
    sheets: u32,
    /// Factor on the distance between leaves along a shoot.
    spacing: f32,
    /// Length of a leaf in metres.
    size: f32,
}

/// Six models: cards, crossed cards, outlines and modelled leaves; sparse to dense; two conifers.
const OURS: [Recipe; 6] = [
    Recipe {
        name: "oak, cards",
        preset: "oak",
        leaves: Leaves::Cards,
        sheets: 1,
        spacing: 1.0,
        size: 0.3,
    },
    Recipe {
        name: "spruce, crossed cards",
        preset: "g",
        leaves: Leaves::Cards,
        sheets: 2,
        spacing: 1.0,
        size: 0.3,
    },
    Recipe {
        name: "larch, outlines",
        preset: "j",
        leaves: Leaves::Outlines,
        sheets: 2,
        spacing: 1.0,
        size: 0.3,
    },
    Recipe {
        name: "willow, outlines",
        preset: "c",
        leaves: Leaves::Outlines,
        sheets: 1,
        spacing: 1.0,
        size: 0.3,
    },
    Recipe {
        name: "apple, modelled",
        preset: "i",
        leaves: Leaves::Modelled,
        sheets: 1,
        spacing: 0.5,
        size: 0.13,
    },
    Recipe {
        name: "round crown, modelled, sparse",
        preset: "d",
        leaves: Leaves::Modelled,
        sheets: 1,
        spacing: 1.0,
        size: 0.14,
    },
];

/// Trees of about 270,000 leaf vertices, for the scene of more than 1.3 billion.
const LARGE: [Recipe; 3] = [
    Recipe {
        name: "oak, large",
        preset: "oak",
        leaves: Leaves::Modelled,
        sheets: 1,
        spacing: 0.4,
        size: 0.13,
    },
    Recipe {
        name: "spruce, large",
        preset: "g",
        leaves: Leaves::Cards,
        sheets: 2,
        spacing: 0.4,
        size: 0.2,
    },
    Recipe {
        name: "vase, large",
        preset: "a",
        leaves: Leaves::Modelled,
        sheets: 1,
        spacing: 0.4,
        size: 0.13,
    },
];

/// Trees of ours.
pub(super) fn ours() -> Outcome<Vec<Model>> {
    OURS.iter().map(grow).collect()
}

/// Trees of ours for the scene with the most vertices.
pub(super) fn large() -> Outcome<Vec<Model>> {
    LARGE.iter().map(grow).collect()
}

/// A tree of ours with half a million leaf triangles.
pub(super) fn half_million() -> Outcome<Model> {
    let name = "oak, half a million";
    grow(&Recipe { name, spacing: 0.38, size: 0.1, ..LARGE[0] })
}

fn grow(recipe: &Recipe) -> Outcome<Model> {
    let mut params = Preset::find(recipe.preset)?.params()?;
    let leaves = params.leaves.as_mut().ok_or("a preset without leaves")?;
    leaves.spacing *= recipe.spacing;
    leaves.size = recipe.size;
    let tree = params.grow(SEED, &Control::default())?.tree;
    let mut look = Look::built_in(tree.species())?;
    look.leaves.iter_mut().for_each(|leaf| dress(leaf, recipe));
    let mesh = build(&tree, &look, &MeshParams::default(), &Control::default())?.mesh;
    Model::new(recipe.name, mesh, recipe.leaves, false)
}

fn dress(leaf: &mut LeafLook, recipe: &Recipe) {
    leaf.sheets = recipe.sheets;
    match recipe.leaves {
        Leaves::Cards => {}
        Leaves::Outlines => leaf.form = LeafForm::Outline { max_vertices: 8 },
        Leaves::Modelled => {
            leaf.form = LeafForm::Mesh(Arc::new(modelled::leaf(LEAF_WIDTH)));
            leaf.material = modelled::material();
            debug_assert_eq!(leaf.material.alpha, Alpha::Opaque);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_mesh::Surface;

    #[test]
    fn every_card_of_the_peers_becomes_a_leaf_of_sixteen_triangles() {
        for model in of_peers().unwrap() {
            let made = with_modelled_leaves(&model).unwrap();
            let leaves = &made.mesh.surfaces[made.elements.surfaces[0] as usize];
            assert_eq!(leaves.vertices_per_leaf(), Some(modelled::VERTICES));
            assert_eq!(made.elements.len(), model.elements.len(), "{}", model.name);
            assert_eq!(made.elements.n_triangles(), modelled::TRIANGLES * made.elements.len());
        }
    }

    #[test]
    fn imported_trees_stand_on_the_ground_and_are_as_tall_as_trees() {
        for model in imported().unwrap() {
            assert!((2.0..20.0).contains(&model.height()), "{}: {}", model.name, model.height());
            assert!(model.mesh.bounds().min.y.abs() < 0.1);
        }
    }

    #[test]
    fn a_tree_of_ours_has_the_leaves_of_its_recipe() {
        let model = grow(&Recipe { spacing: 8.0, ..LARGE[0] }).unwrap();
        let per_leaf = model.mesh.surfaces.iter().find_map(Surface::vertices_per_leaf);
        assert_eq!(per_leaf, Some(modelled::VERTICES));
        assert!(!model.imported && model.leaves == Leaves::Modelled);
    }
}
