//! Triangles needed for a given silhouette error, against the plain tubes of issue 1.
//!
//! Each way of meshing is held against its own mesh at a very small error: so what is compared is how many
//! triangles it takes to come near a shape, not which shape it is. The error is the area in which the
//! masks differ as a share of the finest one's area, mean of several views.

use super::{Outcome, plain};
use crate::table::{Aim, Row, Table};
use tree_core::{Control, Seed, Skeleton, Species, Tree};
use tree_lod::preview::{self, Camera, Framing, Mask, View};
use tree_mesh::{ErrorBound, Look, Mesh, MeshParams, build};
use tree_model::path::Preset;

/// Errors in metres, coarse to fine; the last is the reference.
const ERRORS: [f32; 9] = [0.03, 0.01, 0.004, 0.0015, 0.0007, 0.0003, 0.00015, 0.00007, 0.00002];
const YAWS: [f32; 2] = [0.3, 1.9];
/// Pixels of a side; with 4 × 4 samples each a sample is about a millimetre of a tree of 10 m.
const PIXELS: u32 = 2048;
/// Shares of the silhouette at which triangles are compared.
const WANTED: [f64; 2] = [0.01, 0.003];

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    for name in ["oak", "c", "e"] {
        let preset = Preset::find(name)?;
        let grown = preset.params()?.grow(Seed(3), &Control::default())?;
        let skeleton = grown.tree.skeleton();
        let ours = curve(|error| bark(skeleton, error))?;
        let theirs = curve(|error| Ok(plain::tubes(skeleton, error)))?;
        let case = format!("preset {name}; plain tubes");
        for wanted in WANTED {
            let metric = format!("triangles, {} % of outline", 100.0 * wanted);
            let (Some(ours), Some(theirs)) = (needed(&ours, wanted), needed(&theirs, wanted))
            else {
                continue;
            };
            table.row(&Row {
                case: &case,
                metric: &metric,
                paper: None,
                peer: Some(theirs.round()),
                ours: ours.round(),
                unit: "triangles",
                aim: Aim::AtMost(theirs.round()),
            });
        }
    }
    Ok(())
}

/// Our bark within `error` metres.
fn bark(skeleton: &Skeleton, error: f32) -> Outcome<Mesh> {
    let tree = Tree::bare(skeleton.clone(), Species::default());
    let params = MeshParams {
        error: ErrorBound::Metres(error),
        // Rings for the wind do not belong to the outline.
        max_strip: 1000.0,
        max_sides: 128,
        flare: 0.0,
        ..MeshParams::default()
    };
    let look = Look::plain(tree.species());
    Ok(build(&tree, &look, &params, &Control::default())?.mesh)
}

/// Triangles and silhouette error for each of [`ERRORS`] but the last.
fn curve(mesh: impl Fn(f32) -> Outcome<Mesh>) -> Outcome<Vec<(f64, f64)>> {
    let meshes = ERRORS.iter().map(|&error| mesh(error)).collect::<Outcome<Vec<Mesh>>>()?;
    let Some((finest, coarser)) = meshes.split_last() else {
        return Ok(Vec::new());
    };
    let mut errors = vec![0.0; coarser.len()];
    for yaw in YAWS {
        let framing = Framing { yaw, orthographic: true, ..Framing::default() };
        let pose = Camera::Framed(framing).pose(finest, 1.0)?;
        let camera = Camera::Placed(pose);
        let view = View { width: PIXELS, height: PIXELS, samples: 4, camera };
        let mask = |mesh: &Mesh| preview::mask(mesh, &view, &Control::default());
        let reference = mask(finest)?;
        for (error, mesh) in errors.iter_mut().zip(coarser) {
            *error += difference(&mask(mesh)?, &reference) / YAWS.len() as f64;
        }
    }
    let counts = coarser.iter().map(|mesh| mesh.n_triangles() as f64);
    Ok(counts.zip(errors).collect())
}

fn difference(mask: &Mask, reference: &Mask) -> f64 {
    let pairs = mask.coverage.iter().zip(&reference.coverage);
    let sum: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    sum as f64 / 255.0 / reference.area().max(1.0)
}

/// Triangles at which the error falls to `wanted`, by interpolation of logarithms.
fn needed(curve: &[(f64, f64)], wanted: f64) -> Option<f64> {
    curve.windows(2).find(|pair| pair[0].1 > wanted && pair[1].1 <= wanted).map(|pair| {
        let [(n0, e0), (n1, e1)] = [pair[0], pair[1]].map(|(n, e)| (libm::log(n), libm::log(e)));
        let t = (e0 - libm::log(wanted)) / (e0 - e1);
        libm::exp(n0 + t * (n1 - n0))
    })
}
