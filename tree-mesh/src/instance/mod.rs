//! A few unique twigs, set down many times: a tree at a tenth of its memory and less.
//!
//! 1. `cut`: the tree is cut into a base and *occurrences*, its terminal subtrees of a limited length.
//! 2. `describe`: each occurrence gets a frame (out along its leaves, rolled to the sky), a size and
//!    a descriptor: leaves, thickness, spread, direction against gravity.
//! 3. `cluster`: occurrences are grouped; of each group the one nearest to its mean becomes a twig.
//! 4. `parts`: base and twigs become meshes; every occurrence is replaced by its group's twig.
//! 5. Several lengths and numbers are tried; of those that make the whole as much smaller than the
//!    flattened tree as asked, the truest is taken.
//!
//! [`InstancedTree::flatten`] makes one plain mesh again.

mod cluster;
mod cut;
mod describe;
mod flatten;
mod of_parts;
mod parts;

use crate::error::Result;
use crate::look::Look;
use crate::mesh::{Mesh, Surface};
use crate::params::MeshParams;
use glam::{Quat, Vec3};
use tree_core::{Control, Seed, Tree, check_parameter};

/// Lengths of subtrees that are tried, as share of the longest path through the tree.
const REACHES: [f32; 9] = [0.03, 0.045, 0.065, 0.09, 0.13, 0.18, 0.25, 0.35, 0.5];
/// Numbers of twigs that are tried, as share of the most, until one is small enough.
const NUMBERS: [f32; 6] = [1.0, 0.7, 0.5, 0.35, 0.2, 0.1];
/// Bytes of an instance: translation, rotation and scale as glTF stores them, and its branch.
const INSTANCE_BYTES: u64 = 12 + 16 + 12 + 4;

/// How a tree is divided into twigs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InstancingParams {
    /// Most unique twigs, 1 to 1000. Default 30.
    pub max_twigs: u32,
    /// How many times smaller than the flattened tree the result should be, 1 to 1000. Default 11: ten,
    /// and some room, for flattened twigs may weigh a little more than those they stand for.
    /// The truest way that reaches it is taken. Small trees may not reach it: see
    /// [`InstancingReport::ratio`].
    pub ratio: f32,
    /// Length of twigs in metres along the longest path in them, 0.001 to 1000, if it shall not be
    /// chosen. Default none.
    pub reach: Option<f32>,
    /// Where the search for groups starts. Default 0.
    pub seed: Seed,
}

impl Default for InstancingParams {
    fn default() -> Self {
        Self { max_twigs: 30, ratio: 11.0, reach: None, seed: Seed(0) }
    }
}

impl InstancingParams {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`MeshError::Parameter`](crate::MeshError::Parameter), naming the first field at fault and its range.
    pub fn validate(&self) -> Result<()> {
        for (field, found, min, max) in [
            ("max_twigs", f64::from(self.max_twigs), 1.0, 1000.0),
            ("ratio", f64::from(self.ratio), 1.0, 1000.0),
            ("reach", self.reach.map_or(1.0, f64::from), 0.000_999, 1000.0),
        ] {
            check_parameter(field, found, min, max)?;
        }
        Ok(())
    }
}

/// A unique twig and all places where it stands, in columns as `EXT_mesh_gpu_instancing` has them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Twig {
    /// The twig, its base at the origin. Surfaces and materials as in the base mesh.
    pub mesh: Mesh,
    /// Where the base of each instance is, in metres.
    pub translations: Vec<Vec3>,
    /// Turn of each instance, unit quaternions.
    pub rotations: Vec<Quat>,
    /// Factor on the size of each instance, the same along all axes.
    pub scales: Vec<Vec3>,
    /// Branch of the base mesh that bears each instance.
    pub branches: Vec<u32>,
}

/// A tree as a base mesh and instances of twigs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InstancedTree {
    /// Wood and leaves that are not part of a twig. Surfaces as [`build`](crate::build) makes them.
    pub base: Mesh,
    /// The twigs; none without instances.
    pub twigs: Vec<Twig>,
    /// Sizes.
    pub report: InstancingReport,
}

/// What an instanced tree weighs and how near it comes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct InstancingReport {
    /// Unique twigs.
    pub n_twigs: usize,
    /// Instances of all twigs.
    pub n_instances: usize,
    /// Length that twigs were limited to, in metres.
    pub reach: f32,
    /// Bytes of the columns of base and twigs, and of the instances.
    pub bytes: u64,
    /// Bytes of the columns of the flattened tree.
    pub bytes_flat: u64,
    /// `bytes_flat / bytes`.
    pub ratio: f32,
    /// Leaves of the tree, and of the instanced one.
    pub n_leaves: (u64, u64),
    /// How far middle and spread of an occurrence's leaves are off its twig's, in metres: root mean
    /// square over all leaves.
    pub deviation: f32,
}

/// Replaces terminal subtrees by instances of at most [`InstancingParams::max_twigs`] twigs.
///
/// # Errors
/// As [`build`](crate::build), and [`MeshError::Parameter`](crate::MeshError::Parameter) for the twigs' parameters.
///
/// # Complexity
/// For each length tried (nine): O(nodes + leaves) and the base mesh; for each number of twigs (six
/// at most) O(occurrences × twigs) for the groups, and the twigs' meshes. Parallel inside.
pub fn twigs(
    tree: &Tree,
    look: &Look,
    params: &MeshParams,
    twig_params: &InstancingParams,
    control: &Control,
) -> Result<InstancedTree> {
    params.validate()?;
    twig_params.validate()?;
    look.check(tree.species())?;
    // Leaves of a twig share its light map; places in it would not be unique.
    let params = MeshParams { lightmap: false, ..*params };
    let to_tip = tree.skeleton().distances_to_tip();
    let longest = to_tip.first().copied().unwrap_or(0.0);
    let reaches: Vec<f32> = match twig_params.reach {
        Some(reach) => vec![reach],
        None => REACHES.iter().map(|share| share * longest).collect(),
    };
    let scene = Scene { tree, look, params: &params };
    let mut best: Option<InstancedTree> = None;
    for (i, &reach) in reaches.iter().enumerate() {
        control.report("twigs", i as f32 / reaches.len() as f32)?;
        let cut = cut::Cut::new(tree, &to_tip, reach);
        let base = parts::base(scene, &cut, control)?;
        let bytes_most = |made: &InstancedTree| made.report.bytes_flat as f32 / twig_params.ratio;
        if best.as_ref().is_some_and(|best| bytes(&base.mesh) as f32 > bytes_most(best)) {
            // The base alone is too large, whatever the twigs are.
            continue;
        }
        let forms = describe::describe(tree, &cut);
        for share in NUMBERS {
            let n_max = ((twig_params.max_twigs as f32 * share) as usize).max(1);
            let groups = cluster::group(&forms, n_max, twig_params.seed, control)?;
            let mut made = parts::assemble(scene, &base, &cut, &forms, &groups, control)?;
            made.report = InstancingReport { reach, ..report(&made, tree, &forms, &groups) };
            let reached = made.report.ratio >= twig_params.ratio;
            if best
                .as_ref()
                .is_none_or(|best| better(&made.report, &best.report, twig_params.ratio))
            {
                best = Some(made);
            }
            if reached {
                break;
            }
        }
    }
    control.report("done", 1.0)?;
    Ok(best.unwrap_or_default())
}

/// What is meshed, and how.
#[derive(Clone, Copy)]
struct Scene<'a> {
    tree: &'a Tree,
    look: &'a Look,
    params: &'a MeshParams,
}

/// Small enough comes first; of two that are, the truer one; of two that are not, the smaller.
fn better(a: &InstancingReport, b: &InstancingReport, ratio: f32) -> bool {
    match (a.ratio >= ratio, b.ratio >= ratio) {
        (true, true) => a.deviation < b.deviation,
        (false, false) => a.ratio > b.ratio,
        (a, _) => a,
    }
}

fn report(
    made: &InstancedTree,
    tree: &Tree,
    forms: &[describe::Form],
    groups: &cluster::Groups,
) -> InstancingReport {
    let (mut sum, mut weight) = (0.0_f64, 0.0_f64);
    for (form, &group) in forms.iter().zip(&groups.of) {
        let Some(twig) = groups.medoids.get(group as usize).and_then(|&m| forms.get(m as usize))
        else {
            continue;
        };
        let (leaves, off) = (f64::from(form.n_leaves), f64::from(form.distance(twig)));
        sum += leaves * off * off;
        weight += leaves;
    }
    let sizes = sizes(made);
    InstancingReport {
        n_leaves: (tree.foliage().len() as u64, sizes.n_leaves.1),
        deviation: if weight > 0.0 { libm::sqrt(sum / weight) as f32 } else { 0.0 },
        ..sizes
    }
}

/// What can be said without the tree that it stands for.
fn sizes(made: &InstancedTree) -> InstancingReport {
    let n_instances: usize = made.twigs.iter().map(|twig| twig.translations.len()).sum();
    let unique: u64 = made.twigs.iter().map(|twig| bytes(&twig.mesh)).sum();
    let repeated = |of: fn(&Mesh) -> u64| -> u64 {
        made.twigs.iter().map(|twig| of(&twig.mesh) * twig.translations.len() as u64).sum()
    };
    let bytes_all = bytes(&made.base) + unique + n_instances as u64 * INSTANCE_BYTES;
    let bytes_flat = bytes(&made.base) + repeated(bytes);
    let n_leaves = n_leaves(&made.base) + repeated(n_leaves);
    InstancingReport {
        n_twigs: made.twigs.len(),
        n_instances,
        bytes: bytes_all,
        bytes_flat,
        ratio: (bytes_flat as f64 / bytes_all.max(1) as f64) as f32,
        n_leaves: (n_leaves, n_leaves),
        ..Default::default()
    }
}

fn n_leaves(mesh: &Mesh) -> u64 {
    mesh.surfaces.iter().map(|surface| surface.anchors.len() as u64).sum()
}

/// Bytes of all columns; textures are shared by both.
fn bytes(mesh: &Mesh) -> u64 {
    let surface = |s: &Surface| {
        12 * (s.positions.len() + s.normals.len() + s.anchors.len())
            + 8 * (s.uvs.len() + s.uvs2.len())
            + 16 * s.tangents.len()
            + 4 * (s.branches.len() + s.occlusion.len() + s.welds.len() + s.indices.len())
    };
    mesh.surfaces.iter().map(|s| surface(s) as u64).sum()
}

#[cfg(test)]
mod tests;
