//! What an occurrence looks like, apart from where it stands.

use super::cut::Cut;
use glam::{Mat3, Quat, Vec3};
use rayon::prelude::*;
use tree_core::Tree;

/// Cells of the coarse picture of the leaves along each axis.
const GRID: usize = 3;
/// Leaf kinds that are told apart.
const KINDS: usize = 4;
/// Numbers besides: size, leaves, thickness, direction, middle and spread.
const MEASURES: usize = 8;
/// Length of a descriptor.
pub(super) const LENGTH: usize = MEASURES + GRID * GRID * GRID + KINDS;

/// A descriptor: occurrences look alike where it is alike.
pub(super) type Descriptor = [f32; LENGTH];

/// Place and look of an occurrence.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    pub(super) origin: Vec3,
    /// From its own frame to the tree's: +Y out along its leaves, +Z as near to the sky as can be.
    pub(super) rotation: Quat,
    /// Root mean square distance of nodes and leaves from the origin, in metres.
    pub(super) size: f32,
    pub(super) n_leaves: u32,
    middle: Vec3,
    spread: Vec3,
    pub(super) descriptor: Descriptor,
}

impl Form {
    /// How far the middle and spread of its leaves are off a twig's at this size, in metres.
    pub(super) fn distance(&self, twig: &Self) -> f32 {
        let apart = (self.middle - twig.middle).length_squared()
            + (self.spread - twig.spread).length_squared();
        self.size * apart.sqrt()
    }
}

/// One form for each occurrence. O(nodes + leaves).
pub(super) fn describe(tree: &Tree, cut: &Cut) -> Vec<Form> {
    (0..cut.roots.len()).into_par_iter().map(|number| form(tree, cut, number)).collect()
}

fn form(tree: &Tree, cut: &Cut, number: usize) -> Form {
    let (skeleton, foliage) = (tree.skeleton(), tree.foliage());
    let (nodes, leaves) = (cut.nodes(number), cut.leaves(number));
    let origin = skeleton.positions()[cut.bearer(skeleton, number) as usize];
    // The middle of a leaf counts, not its base.
    let leaf = |&leaf: &u32| {
        let i = leaf as usize;
        foliage.positions()[i] + foliage.rotations()[i] * (Vec3::Y * (0.5 * foliage.sizes()[i]))
            - origin
    };
    let node = |&node: &u32| skeleton.positions()[node as usize] - origin;
    let points: Vec<Vec3> = if leaves.is_empty() {
        nodes.iter().map(node).collect()
    } else {
        leaves.iter().map(leaf).collect()
    };
    let n = points.len().max(1) as f32;
    let middle = points.iter().sum::<Vec3>() / n;
    let all = nodes.iter().map(node).chain(leaves.iter().map(leaf));
    let squares: f32 = all.map(|p| p.length_squared()).sum();
    let size = (squares / (nodes.len() + leaves.len()).max(1) as f32).sqrt().max(1e-5);
    let frame = frame(middle);
    let own = |p: &Vec3| frame.transpose() * *p / size;
    let middle = own(&middle);
    let squares: Vec3 = points.iter().map(|p| (own(p) - middle) * (own(p) - middle)).sum();
    let spread = (squares / n).map(f32::sqrt);
    let root = cut.roots.get(number).copied().unwrap_or(0) as usize;
    let mut descriptor = [0.0; LENGTH];
    let thickness = (skeleton.radii()[root] / size).max(1e-4);
    let measures = [
        2.0 * libm::logf(size),
        libm::logf(1.0 + leaves.len() as f32),
        0.3 * libm::logf(thickness),
        frame.y_axis.y,
        middle.y,
        1.5 * spread.x,
        1.5 * spread.y,
        1.5 * spread.z,
    ];
    descriptor[..MEASURES].copy_from_slice(&measures);
    let share = 1.0 / n;
    for p in &points {
        let cell = (own(p) - Vec3::Y * 0.9) * (0.5 * GRID as f32) / 1.2 + 0.5 * GRID as f32;
        let cell = cell.clamp(Vec3::ZERO, Vec3::splat(GRID as f32 - 0.5));
        let at = cell.x as usize + GRID * (cell.y as usize + GRID * cell.z as usize);
        descriptor[MEASURES + at] += share;
    }
    for &leaf in leaves {
        let kind = usize::from(foliage.kinds()[leaf as usize]).min(KINDS - 1);
        descriptor[LENGTH - KINDS + kind] += share;
    }
    Form {
        origin,
        rotation: Quat::from_mat3(&frame).normalize(),
        size,
        n_leaves: leaves.len() as u32,
        middle,
        spread,
        descriptor,
    }
}

/// +Y along `out`, +Z towards the sky; towards the north (-Z) for what stands or hangs upright.
fn frame(out: Vec3) -> Mat3 {
    let y = out.normalize_or(Vec3::Y);
    let up = if y.y.abs() > 0.97 { Vec3::NEG_Z } else { Vec3::Y };
    let z = (up - y * up.dot(y)).normalize_or(y.any_orthonormal_vector());
    Mat3::from_cols(y.cross(z), y, z)
}
