//! Triangles a second on one core, over sizes; memory; what memory alone would allow.

use super::Outcome;
use crate::measure::{fastest, peak_bytes};
use crate::table::{Aim, Row, Table};
use rayon::ThreadPoolBuilder;
use std::hint::black_box;
use tree_core::glam::{EulerRot, Quat, Vec3};
use tree_core::{Control, Foliage, Leaf, Skeleton, Species, Tree};
use tree_mesh::{Built, Look, Mesh, MeshError, MeshParams, Surface, build};

/// What the issue asks for.
const BARK_PER_SECOND: f64 = 1e7;
const SMALL_MILLISECONDS: f64 = 0.3;
const PEAK_BYTES: f64 = 1e9;
const CARDS: u32 = 1_300_000;
const CARDS_SECONDS: f64 = 0.2;
/// How much dearer a triangle of the largest tree may be than one of 100,000: "linear".
const GROWTH: f64 = 1.3;
/// How a case of [`peak_bytes`] that is ours starts; the number of whorls follows.
const CASE: &str = "mesh:";

/// A size, and what PEERS.md tells of a peer at about that size.
struct Size {
    triangles: u32,
    runs: u32,
    peer: &'static str,
    peer_per_second: f64,
}

const SIZES: [Size; 4] = [
    // 22,566 triangles in 17.1 ms.
    Size { triangles: 5_000, runs: 200, peer: "ez-tree", peer_per_second: 1.3e6 },
    // Pine, 146,016 triangles in 21.8 ms.
    Size { triangles: 100_000, runs: 20, peer: "modular-tree", peer_per_second: 6.7e6 },
    // bevy_procedural_tree, 333,184 triangles in 12.4 ms: open tubes without tangents.
    Size { triangles: 1_000_000, runs: 5, peer: "bevy", peer_per_second: 27e6 },
    // 9,633,296 triangles in 2.2 s and 1.6 GB.
    Size { triangles: 10_000_000, runs: 3, peer: "modular-tree", peer_per_second: 4.4e6 },
];
const PEER_PEAK_BYTES: f64 = 1.6e9;

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    // "On one core": one thread, whatever the machine has.
    let one = ThreadPoolBuilder::new().num_threads(1).build()?;
    let calibration = 40;
    let n = bark(&tree(calibration, 0)?)?.report.n_triangles as f64;
    let per_whorl = n / f64::from(calibration);
    let mut per_triangle = Vec::new();
    for size in &SIZES {
        let whorls = (f64::from(size.triangles) / per_whorl).round().max(1.0) as u32;
        // In a fresh process, and before this one has taken the machine's memory.
        let peak = peak_bytes(&format!("{CASE}{whorls}"));
        let tree = tree(whorls, 0)?;
        let (seconds, built) = one.install(|| fastest(size.runs, || bark(&tree)))?;
        per_triangle.push(size_rows(table, size, seconds, &built, peak)?);
    }
    if let [_, middle, .., large] = per_triangle[..] {
        let case = "bark of 10 million and of 100,000 triangles";
        let metric = "time per triangle, ratio";
        let aim = Aim::AtMost(GROWTH);
        let ours = large / middle;
        table.row(&Row { case, metric, paper: None, peer: None, ours, unit: "×", aim });
    }
    let tree = tree(0, CARDS)?;
    let (seconds, built) = one.install(|| fastest(5, || bark(&tree)))?;
    let leaves = built.mesh.surfaces.get(1).ok_or("no leaves")?;
    let case = format!("{CARDS} leaf cards, one core");
    let mut figure = |metric, ours, unit, aim| {
        table.row(&Row { case: &case, metric, paper: None, peer: None, ours, unit, aim });
    };
    figure("time", seconds, "s", Aim::AtMost(CARDS_SECONDS));
    figure("triangles per second", leaves.n_triangles() as f64 / seconds, "1/s", Aim::None);
    figure("bytes per vertex", bytes_per_vertex(leaves), "bytes", Aim::None);
    Ok(())
}

/// Prints the rows of one size; nanoseconds per triangle.
fn size_rows(
    table: &mut Table,
    size: &Size,
    seconds: f64,
    built: &Built,
    peak: Option<u64>,
) -> Outcome<f64> {
    let surface = built.mesh.surfaces.first().ok_or("no bark")?;
    let n = surface.n_triangles() as f64;
    let case = format!("bark of {n} triangles; {}", size.peer);
    let mut figure = |metric, peer, ours, unit, aim| {
        table.row(&Row { case: &case, metric, paper: None, peer, ours, unit, aim });
    };
    figure(
        "triangles per second",
        Some(size.peer_per_second),
        n / seconds,
        "1/s",
        Aim::AtLeast(BARK_PER_SECOND),
    );
    if size.triangles <= 5_000 {
        figure("time", None, 1e3 * seconds, "ms", Aim::AtMost(SMALL_MILLISECONDS));
    }
    // Smaller ones fit the caches: no limit.
    if size.triangles >= 1_000_000 {
        let (fresh, held) = memory_seconds(bytes(&built.mesh))?;
        figure("limit of new memory", None, n / fresh, "1/s", Aim::None);
        figure("limit of held memory", None, n / held, "1/s", Aim::None);
    }
    figure("bytes per vertex", None, bytes_per_vertex(surface), "bytes", Aim::None);
    if let Some(peak) = peak {
        let large = size.triangles >= 10_000_000;
        let aim = if large { Aim::AtMost(PEAK_BYTES) } else { Aim::None };
        let peer = large.then_some(PEER_PEAK_BYTES);
        figure("peak memory with skeleton", peer, peak as f64, "bytes", aim);
    }
    Ok(1e9 * seconds / n)
}

/// Seconds to fill so many bytes, asked of the system anew and held already: the bandwidth limit of a
/// mesh that is handed over in new memory or written where an older one was.
fn memory_seconds(bytes: usize) -> Outcome<(f64, f64)> {
    let (fresh, mut held) = fastest(3, || Ok::<_, std::io::Error>(black_box(vec![1_u8; bytes])))?;
    let (again, ()) = fastest(3, || {
        black_box(&mut held).fill(2);
        Ok::<_, std::io::Error>(())
    })?;
    Ok((fresh, again))
}

/// Bytes of all columns.
fn surface_bytes(s: &Surface) -> usize {
    size_of_val(s.positions.as_slice())
        + size_of_val(s.normals.as_slice())
        + size_of_val(s.uvs.as_slice())
        + size_of_val(s.tangents.as_slice())
        + size_of_val(s.uvs2.as_slice())
        + size_of_val(s.branches.as_slice())
        + size_of_val(s.occlusion.as_slice())
        + size_of_val(s.welds.as_slice())
        + size_of_val(s.anchors.as_slice())
        + size_of_val(s.indices.as_slice())
}

fn bytes(mesh: &Mesh) -> usize {
    mesh.surfaces.iter().map(surface_bytes).sum()
}

/// Without indices, which belong to triangles.
fn bytes_per_vertex(surface: &Surface) -> f64 {
    let indices = size_of_val(surface.indices.as_slice());
    (surface_bytes(surface) - indices) as f64 / surface.positions.len().max(1) as f64
}

pub(super) fn bark(tree: &Tree) -> Result<Built, MeshError> {
    build(tree, &Look::plain(tree.species()), &MeshParams::default(), &Control::default())
}

/// Builds what a case of [`peak_bytes`] names, if it is one of ours.
pub(crate) fn build_case(case: &str) -> Outcome {
    let Some(whorls) = case.strip_prefix(CASE) else {
        return Ok(());
    };
    let tree = tree(whorls.parse()?, 0)?;
    let one = ThreadPoolBuilder::new().num_threads(1).build()?;
    black_box(one.install(|| bark(&tree))?);
    Ok(())
}

/// Whorls after which the trunk goes over to its next column, and columns in a row of columns.
const COLUMN: u32 = 60;
const COLUMNS: u32 = 12;

/// A trunk with `n` whorls of 5 boughs of 10 twigs; and leaves. The trunk goes up and down in columns
/// 8 m apart: a straight one would be kilometres long, beyond what an f32 resolves.
pub(super) fn tree(n: u32, n_leaves: u32) -> Outcome<Tree> {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.4)?;
    let mut trunk = 0;
    for whorl in 0..n {
        let (column, row) = (whorl / COLUMN, whorl % COLUMN);
        let height = if column % 2 == 0 { row } else { COLUMN - 1 - row } as f32;
        let aside = Vec3::new((column % COLUMNS) as f32, 0.0, (column / COLUMNS) as f32);
        let wave = Vec3::new(0.1 * (whorl % 3) as f32, 0.0, 0.1 * (whorl % 2) as f32);
        let foot = Vec3::Y * (1.0 + 0.3 * height) + 8.0 * aside + wave;
        let share = whorl as f32 / n as f32;
        trunk = builder.add(trunk, foot, 0.38 * (1.0 - share) + 0.04)?;
        for bough in 0..5 {
            let turn = Quat::from_rotation_y(1.256 * bough as f32 + whorl as f32);
            let mut node = trunk;
            for step in 1..=10_u32 {
                let s = step as f32;
                let out = turn * Vec3::new(0.5 + 0.3 * s, 0.02 * s * s, 0.05 * (step % 2) as f32);
                node = builder.add(node, foot + out, 0.02 * (1.1 - 0.1 * s))?;
                let mut tip = foot + out;
                let mut twig = node;
                for _ in 0..3 {
                    tip += turn * Vec3::new(0.05, 0.02, if step % 2 == 0 { 0.1 } else { -0.1 });
                    twig = builder.add(twig, tip, 0.003)?;
                }
            }
        }
    }
    let mut foliage = Foliage::with_capacity(n_leaves as usize);
    for i in 0..n_leaves {
        foliage.push(Leaf {
            node: 0,
            position: Vec3::new((i % 97) as f32, (i % 89) as f32, (i % 83) as f32) * 0.1,
            rotation: Quat::from_euler(EulerRot::XYZ, i as f32, 0.7 * i as f32, 0.0),
            size: 0.08,
            kind: 0,
        })?;
    }
    Ok(Tree::new(builder.finish(), foliage, Species::default())?)
}
