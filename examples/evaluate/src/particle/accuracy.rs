//! How exact density and matting are: against dense least squares, and against an alpha that is known.

use super::pictures::{Behind, compose, known_matte, known_tree, paint, photo_folder, trimap};
use crate::table::{Aim, Row, Table};
use nalgebra::{DMatrix, DVector};
use std::error::Error;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};
use std::path::{Path, PathBuf};
use std::process::Command;
use tree_core::{Control, Limits, Seed};
use tree_model::glam::Vec2;
use tree_model::particle::density::{DensityParams, Equations, carve, solve};
use tree_model::particle::matting::{Level, NaturalParams, Trimap, alpha_of, natural};
use tree_model::particle::{Camera, Matte, Photo, Projection, View};

/// Percent by which a density may differ from the dense solution.
const DENSITY_ERROR: f64 = 1.0;
/// Largest share of the peer's error.
const MATTING_RATIO: f64 = 1.1;
/// Cut-out photographs of the shared data.
const CUT_OUTS: [&str; 3] =
    ["cutout_holm_oak.png", "cutout_birch_winter.png", "cutout_pinnate_tree.png"];
/// Side in pixels of the picture that takes no shared data.
const KNOWN_PIXELS: f32 = 400.0;
/// What the peer's script ends with when there is no pymatting.
const NO_PEER: i32 = 3;

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    density(table)?;
    matting(table)
}

fn density(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let control = Control::default();
    let (quarter, eighth) = (FRAC_PI_2, FRAC_PI_4);
    for (resolution, yaws, evenness, rounding) in [
        (6, &[0.0, quarter][..], 0.1, 0.0),
        (6, &[0.0, quarter, eighth], 0.1, 1.0),
        (6, &[0.3, 2.0], 0.03, 0.5),
        (8, &[0.0, quarter], 0.7, 1.0),
    ] {
        let views = (1..).zip(yaws).map(|(seed, &yaw)| random_view(yaw, seed));
        let views = views.collect::<Result<Vec<_>, _>>()?;
        let params = DensityParams { resolution, evenness, rounding, ..DensityParams::default() };
        let carved = carve(&views, &params, &control)?;
        let (grid, _) = solve(&carved, &views, &params, &control)?;
        let (a, b) = dense(&Equations::new(&carved, &views, &params, &control)?);
        let wanted = lawson_hanson(&a, &b).ok_or("the dense solution failed")?;
        let found = carved.voxels().iter().map(|&i| f64::from(grid.values()[i as usize]));
        let found = DVector::from_iterator(wanted.len(), found);
        let ours = 100.0 * (&found - &wanted).norm() / wanted.norm();
        let case = format!("density, {} voxels, {} views, λ {evenness}", wanted.len(), views.len());
        let (metric, unit, aim) = ("off dense solution, l2", "%", Aim::AtMost(DENSITY_ERROR));
        table.row(&Row { case: &case, metric, paper: None, peer: None, ours, unit, aim });
    }
    Ok(())
}

/// A view of nothing in particular.
fn random_view(yaw: f32, seed: u64) -> Result<View, Box<dyn Error>> {
    let alpha = (0..12 * 12).map(|i| Seed(seed).unit(i)).collect();
    let camera = Camera {
        yaw,
        pitch: 0.0,
        projection: Projection::Orthographic,
        size: Vec2::splat(12.0),
        base: Vec2::new(6.0, 12.0),
        scale: 0.5,
    };
    Ok(View { matte: Matte::new(12, 12, alpha)?, photo: None, camera })
}

/// The system with its Tikhonov rows, as a dense one.
fn dense(system: &Equations) -> (DMatrix<f64>, DVector<f64>) {
    let (m, n) = (system.n_rays(), system.n_voxels());
    let mut a = DMatrix::zeros(m + n, n);
    let mut b = DVector::zeros(m + n);
    for ray in 0..m {
        let (columns, lengths) = system.row(ray);
        columns.iter().zip(lengths).for_each(|(&j, &l)| a[(ray, j as usize)] += f64::from(l));
        b[ray] = f64::from(system.targets()[ray]);
    }
    for (j, &weight) in system.weights().iter().enumerate() {
        a[(m + j, j)] = f64::from(system.lambda()) / f64::from(weight);
    }
    (a, b)
}

/// Lawson, Hanson 1974: dense least squares without negative values. `None` where the free columns depend on
/// each other.
fn lawson_hanson(a: &DMatrix<f64>, b: &DVector<f64>) -> Option<DVector<f64>> {
    let n = a.ncols();
    let mut x = DVector::zeros(n);
    let mut free = vec![false; n];
    for _ in 0..3 * n {
        let w = a.transpose() * (b - a * &x);
        let next = (0..n).filter(|&j| !free[j]).max_by(|&i, &j| w[i].total_cmp(&w[j]));
        let Some(next) = next.filter(|&j| w[j] > 1e-9) else { break };
        free[next] = true;
        loop {
            let set: Vec<usize> = (0..n).filter(|&j| free[j]).collect();
            let columns = a.select_columns(&set);
            let normal = columns.transpose() * &columns;
            let s = normal.cholesky()?.solve(&(columns.transpose() * b));
            if s.iter().all(|&value| value > 0.0) {
                x.fill(0.0);
                set.iter().zip(s.iter()).for_each(|(&j, &value)| x[j] = value);
                break;
            }
            let blocked = set.iter().zip(s.iter()).filter(|(_, s)| **s <= 0.0);
            let step = blocked.map(|(&j, s)| x[j] / (x[j] - s)).fold(1.0, f64::min);
            for (&j, &value) in set.iter().zip(s.iter()) {
                x[j] += step * (value - x[j]);
                free[j] = x[j] > 1e-12;
            }
        }
    }
    Some(x)
}

fn matting(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let mut peer = Peer::find();
    let known = paint(&known_matte(&known_tree()?, 0.0, KNOWN_PIXELS)?)?;
    let mut cut_outs = vec![("rendered oak".to_owned(), known)];
    for name in CUT_OUTS {
        let path = photo_folder().join(name);
        if path.exists() {
            cut_outs.push((name.to_owned(), Photo::open(path, &Limits::default())?));
        } else {
            eprintln!("{name}: not there, left out");
        }
    }
    for (name, cut_out) in &cut_outs {
        let truth = alpha_of(cut_out)?;
        let trimap = trimap(&truth)?;
        for behind in [Behind::Sky, Behind::Hedge] {
            let photo = compose(cut_out, behind)?;
            let params = NaturalParams::default();
            let (matte, _) = natural(&photo, &trimap, &params, &Control::default())?;
            let ours = error(matte.alpha(), &truth, &trimap);
            let peer = peer.alpha(&photo, &trimap)?.map(|alpha| error(&alpha, &truth, &trimap));
            let case = format!("matting, {name} before {}", behind.name());
            let mut row = |metric, peer, ours, aim| {
                table.row(&Row { case: &case, metric, paper: None, peer, ours, unit: "", aim });
            };
            row("mean abs. error, unknown", peer, ours, Aim::None);
            if let Some(peer) = peer {
                row("error against peer's", None, ours / peer, Aim::AtMost(MATTING_RATIO));
            }
        }
    }
    Ok(())
}

/// Mean distance to the truth where the trimap does not know.
fn error(alpha: &[f32], truth: &Matte, trimap: &Trimap) -> f64 {
    let (mut sum, mut n) = (0.0, 0.0);
    for ((&found, &wanted), &level) in alpha.iter().zip(truth.alpha()).zip(trimap.levels()) {
        if level == Level::Unknown {
            sum += f64::from((found - wanted).abs());
            n += 1.0;
        }
    }
    sum / f64::max(n, 1.0)
}

/// Pymatting's closed-form matting, in Python if there is one that has it.
struct Peer {
    python: String,
    folder: PathBuf,
    absent: bool,
}

impl Peer {
    fn find() -> Self {
        let python = std::env::var("TREE_PYTHON").unwrap_or_else(|_| "python3".into());
        let has = |python: &str| {
            let run = Command::new(python).args(["-c", "import pymatting"]).output();
            run.is_ok_and(|output| output.status.success())
        };
        let absent = !has(&python);
        if absent {
            eprintln!(
                "{python} has no pymatting, no peer for matting (set TREE_PYTHON to one that has)"
            );
        }
        let folder = std::env::temp_dir().join(format!("evaluate-matting-{}", std::process::id()));
        Self { python, folder, absent }
    }

    fn alpha(
        &mut self,
        photo: &Photo,
        trimap: &Trimap,
    ) -> Result<Option<Vec<f32>>, Box<dyn Error>> {
        if self.absent {
            return Ok(None);
        }
        std::fs::create_dir_all(&self.folder)?;
        let [image, known, out] =
            ["image.png", "trimap.png", "alpha.png"].map(|name| self.folder.join(name));
        photo.save_png(&image)?;
        let levels = trimap.levels().iter().map(|level| match level {
            Level::Background => 0.0,
            Level::Unknown => 0.5,
            Level::Foreground => 1.0,
        });
        Matte::new(trimap.width(), trimap.height(), levels.collect())?.save_png(&known)?;
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("matting_peer.py");
        let run =
            Command::new(&self.python).arg(script).args([image, known, out.clone()]).output()?;
        if run.status.code() == Some(NO_PEER) {
            eprintln!("{}", String::from_utf8_lossy(&run.stderr).trim());
            self.absent = true;
            return Ok(None);
        }
        if !run.status.success() {
            return Err(format!("matting_peer.py: {}", String::from_utf8_lossy(&run.stderr)).into());
        }
        let alpha = Photo::open(out, &Limits::default())?;
        Ok(Some(alpha.pixels().iter().map(|pixel| f32::from(pixel[0]) / 255.0).collect()))
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        // Nothing hangs on a folder of temporary files that stays.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}
