//! A tree with everything that is drawn of it: levels, their mesh, pictures of its leaves.

use super::Outcome;
use tree_core::{Aabb, Control, Limits, Seed, Species, Tree};
use tree_lod::impostor::boxes::{Bearers, BoxParams, Boxes};
use tree_lod::impostor::cards::{CardParams, Cards};
use tree_lod::multires::{Draw, Metric, MultiMesh, Multires};
use tree_lod::{Elements, Grain, LeafSurfaces};
use tree_mesh::{ErrorBound, Look, MeshParams};
use tree_model::lsystem::LSystem;

/// Boxes of a model: as many as the paper's 4 MB a model leave room for.
pub(super) const BOXES: u32 = 4;
/// Samples of a texel in each direction.
const SAMPLES: u32 = 2;
/// How far wood may leave the round branch: trees of a scene are seen from some metres.
const WOOD_ERROR: ErrorBound = ErrorBound::Metres(0.01);
/// Most sides of a branch in a scene.
const SIDES: u32 = 8;

/// The paper's tree (section 5): a binary tree of 2047 branches and 4085 leaves.
pub(super) const PAPER: &str = "
    /* One internode a branch, eleven generations. B: the leaves of a branch. */
    steps: 12
    trunk_radius = 0.2
    leaf = 0.22
    axiom: A(1.6,0)
    A(l,n) : n < 10 -> F(l*nran(1,0.1))B(n)/(nran(90,15))[+(nran(24,6))A(l*0.82,n+1)][-(nran(30,6))A(l*0.82,n+1)]
    A(l,n) : n >= 10 -> F(l)B(n)
    B(n) : n == 0 || n == 2 -> [&(nran(50,12))~(leaf)]
    B(n) : n == 1 -> ε
    B(n) : n > 2 -> [&(nran(50,12))~(leaf)][^(nran(50,12))~(leaf)]
";
pub(super) const PAPER_BRANCHES: usize = 2047;
pub(super) const PAPER_LEAVES: usize = 4085;

/// The paper's tree.
pub(super) fn of_paper(seed: Seed) -> Outcome<Tree> {
    let mut system = LSystem::parse(PAPER, &Limits::default())?;
    system.species = paper_species();
    Ok(system.grow(seed, &Control::default())?.tree)
}

pub(super) fn paper_species() -> Species {
    Species {
        name: "binary".into(),
        bark: "birch".into(),
        leaf_kinds: vec!["birch-cluster".into()],
    }
}

/// Parameters of meshes in scenes.
pub(super) fn mesh_params() -> MeshParams {
    MeshParams { max_sides: SIDES, error: WOOD_ERROR, ..MeshParams::default() }
}

/// A tree ready to be drawn at any distance.
pub(super) struct Model {
    pub(super) multires: Multires,
    pub(super) mesh: MultiMesh,
    /// Of the mesh, which is too large to look at in each frame.
    pub(super) bounds: Aabb,
    /// None where there are no leaves.
    pub(super) cards: Option<Cards>,
}

impl Model {
    /// Everything of a tree, without pictures.
    pub(super) fn bare(tree: &Tree, look: &Look) -> Outcome<Self> {
        let control = Control::default();
        let multires = Multires::new(tree, &Metric::default(), &control)?;
        let mesh = MultiMesh::new(&multires, look, &mesh_params(), &control)?;
        let bounds = mesh.mesh().bounds();
        Ok(Self { multires, mesh, bounds, cards: None })
    }

    /// Everything of a tree.
    pub(super) fn new(tree: &Tree, look: &Look) -> Outcome<Self> {
        let mut model = Self::bare(tree, look)?;
        if !tree.foliage().is_empty() {
            model.cards = Some(model.baked(BOXES)?);
        }
        Ok(model)
    }

    pub(super) fn multires_again(&self, tree: &Tree) -> Outcome<Multires> {
        Ok(Multires::new(tree, &Metric::default(), &Control::default())?)
    }

    /// The boxes of the leaves.
    pub(super) fn boxes(&self, most_boxes: u32) -> Outcome<(Elements, Boxes)> {
        let (control, mesh) = (Control::default(), self.mesh.mesh());
        let tree = self.multires.tree();
        let leaves = LeafSurfaces::Surfaces((1..mesh.surfaces.len() as u32).collect());
        let elements = Elements::of_mesh(mesh, &leaves, Grain::Leaf, &control)?;
        let bearers = Bearers::of_tree(tree, mesh, &elements)?;
        let params = BoxParams { most_boxes, ..BoxParams::default() };
        let boxes = Boxes::along(tree.skeleton(), mesh, &elements, &bearers, &params, &control)?;
        Ok((elements, boxes))
    }

    /// Their pictures.
    pub(super) fn baked(&self, most_boxes: u32) -> Outcome<Cards> {
        let (elements, boxes) = self.boxes(most_boxes)?;
        let params = CardParams { samples: SAMPLES, ..CardParams::default() };
        Ok(Cards::bake(self.mesh.mesh(), &elements, &boxes, &params, &Control::default())?)
    }

    /// Triangles of wood of a level.
    pub(super) fn wood_triangles(&self, level: usize, draws: &mut [Draw]) -> Outcome<u64> {
        self.mesh.draws(level as f32, draws)?;
        Ok(draws.first().map_or(0, |draw| u64::from(draw.index_count) / 3))
    }

    /// One draw for each surface.
    pub(super) fn draws(&self) -> Vec<Draw> {
        vec![Draw::default(); self.mesh.mesh().surfaces.len()]
    }
}
