//! What must hold of whatever comes out.

use super::dice::Dice;
use tree_core::{Control, Tree};
use tree_lod::LodError;
use tree_lod::multires::stream::{self, StreamParams};
use tree_lod::multires::{Metric, Multires};
use tree_mesh::topology::examine;
use tree_mesh::{ErrorBound, Look, Mesh, MeshError, MeshParams};

/// One in so many trees is sorted, sent and read back.
const SENT: usize = 6;

/// A number that differs where bits do, or what is wrong.
pub(super) fn judge(tree: &Tree, dice: &mut Dice, control: &Control) -> Result<u64, String> {
    let mut print = Print(0xcbf2_9ce4_8422_2325);
    skeleton(tree, &mut print)?;
    foliage(tree, &mut print)?;
    mesh(tree, dice, control, &mut print)?;
    if dice.below(SENT) == 0 {
        sent(tree, control)?;
    }
    Ok(print.0)
}

/// FNV-1a over words.
struct Print(u64);

impl Print {
    fn add(&mut self, word: u32) {
        self.0 = (self.0 ^ u64::from(word)).wrapping_mul(0x100_0000_01b3);
    }

    fn floats(&mut self, floats: impl IntoIterator<Item = f32>) -> bool {
        floats.into_iter().fold(true, |good, float| {
            self.add(float.to_bits());
            good && float.is_finite()
        })
    }
}

fn skeleton(tree: &Tree, print: &mut Print) -> Result<(), String> {
    let skeleton = tree.skeleton();
    skeleton.check().map_err(|error| format!("skeleton: {error}"))?;
    let positions = skeleton.positions().iter().flat_map(|p| p.to_array());
    let finite = print.floats(positions) & print.floats(skeleton.radii().iter().copied());
    skeleton.parents().iter().for_each(|&parent| print.add(parent));
    let negative = skeleton.radii().iter().any(|&radius| radius < 0.0);
    wrong(!finite || negative, "skeleton: a number that is none")
}

fn foliage(tree: &Tree, print: &mut Print) -> Result<(), String> {
    let (n_nodes, n_kinds) = (tree.skeleton().len(), tree.species().leaf_kinds.len());
    for leaf in tree.foliage().iter() {
        let numbers = leaf.position.to_array().into_iter().chain(leaf.rotation.to_array());
        let good = print.floats(numbers.chain([leaf.size]))
            && leaf.size >= 0.0
            && (leaf.node as usize) < n_nodes
            && usize::from(leaf.kind) < n_kinds;
        wrong(
            !good,
            &format!("foliage: a leaf that is none: {leaf:?} of {n_nodes} nodes, {n_kinds} kinds"),
        )?;
    }
    Ok(())
}

fn params(dice: &mut Dice) -> MeshParams {
    let mut params = MeshParams { tangents: dice.chance(0.2), ..MeshParams::default() };
    if dice.chance(0.7) {
        return params;
    }
    let nasty = dice.nasty() as f32;
    match dice.below(14) {
        0 => params.error = ErrorBound::Metres(nasty),
        1 => params.max_strip = nasty,
        2 => params.min_radius = nasty,
        3 => params.bark_width = nasty,
        4 => params.bark_length = nasty,
        5 => params.flare = nasty,
        6 => params.flare_height = nasty,
        7 => params.flare_lobe_depth = nasty,
        8 => params.leaf_scale = nasty,
        9 => params.leaf_width = nasty,
        10 => params.leaf_rounding = nasty,
        11 => params.min_sides = dice.below(200) as u32,
        12 => params.max_sides = dice.below(200) as u32,
        _ => params.lightmap = true,
    }
    params
}

fn mesh(tree: &Tree, dice: &mut Dice, control: &Control, print: &mut Print) -> Result<(), String> {
    let look = Look::plain(tree.species());
    let built = match tree_mesh::build(tree, &look, &params(dice), control) {
        Ok(built) => built.mesh,
        Err(error) => return typed(&error),
    };
    built.check().map_err(|error| format!("mesh: {error}"))?;
    columns(&built, print)?;
    let Some(bark) = built.surfaces.first().filter(|bark| !bark.indices.is_empty()) else {
        return Ok(());
    };
    let found = examine(bark).map_err(|error| format!("bark: {error}"))?;
    wrong(!found.is_closed(), "bark: not a closed manifold")
}

fn columns(mesh: &Mesh, print: &mut Print) -> Result<(), String> {
    for surface in &mesh.surfaces {
        let n = surface.positions.len() as u32;
        wrong(surface.indices.iter().any(|&index| index >= n), "mesh: an index out of range")?;
        wrong(!surface.indices.len().is_multiple_of(3), "mesh: two thirds of a triangle")?;
        surface.indices.iter().for_each(|&index| print.add(index));
        let vectors = surface.positions.iter().chain(&surface.normals).chain(&surface.anchors);
        let mut good = print.floats(vectors.flat_map(|v| v.to_array()));
        good &= print.floats(surface.uvs.iter().chain(&surface.uvs2).flat_map(|v| v.to_array()));
        good &= print.floats(surface.tangents.iter().flat_map(|v| v.to_array()));
        wrong(!good, "mesh: a number that is none")?;
    }
    Ok(())
}

/// Whether an error says what was wrong. None of them is a defect of ours.
fn typed(error: &MeshError) -> Result<(), String> {
    wrong(error.to_string().len() < 8, "an error without words")
}

/// Sorted by branches, sent, and read back.
fn sent(tree: &Tree, control: &Control) -> Result<(), String> {
    let failed = |error: LodError| match error {
        LodError::Limit(_) | LodError::Cancelled(_) | LodError::Parameter(_) => Ok(()),
        other => Err(format!("levels: {other}")),
    };
    let multires = match Multires::new(tree, &Metric::default(), control) {
        Ok(multires) => multires,
        Err(error) => return failed(error),
    };
    let n = multires.n_levels();
    let some = multires.tree_at(n / 2).map_err(|error| format!("levels: {error}"))?;
    some.skeleton().check().map_err(|error| format!("levels: {error}"))?;
    let params = StreamParams::default();
    let bytes = match stream::encode(&multires, usize::MAX, &params) {
        Ok(bytes) => bytes,
        Err(error) => return failed(error),
    };
    let (back, received) =
        stream::decode(&bytes, &control.limits).map_err(|error| format!("stream: {error}"))?;
    wrong(!received.is_complete || back.n_levels() != n, "stream: levels are missing")?;
    wrong(back.tree() != multires.tree(), "stream: another tree")
}

fn wrong(whether: bool, what: &str) -> Result<(), String> {
    if whether { Err(what.into()) } else { Ok(()) }
}
