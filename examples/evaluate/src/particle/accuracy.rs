//! How exact density and matting are: against dense least squares, and against an alpha that is known.

use super::pictures::{Behind, compose, known_matte, known_tree, paint, photo_folder, trimap};
use crate::peers::{CLOSED_FORM, ask_for_alpha as ask};
use crate::table::{Aim, Row, Table};
use nalgebra::{DMatrix, DVector};
use std::error::Error;
use std::f32::consts::{FRAC_PI_2, FRAC_PI_4};
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

/// A picture whose alpha is known.
pub(crate) struct Known {
    /// What is cut out, and what it stands before.
    pub(crate) name: String,
    pub(crate) photo: Photo,
    pub(crate) trimap: Trimap,
    truth: Matte,
}

impl Known {
    fn new(name: &str, cut_out: &Photo, behind: Behind) -> Result<Self, Box<dyn Error>> {
        let truth = alpha_of(cut_out)?;
        let trimap = trimap(&truth)?;
        let photo = compose(cut_out, behind)?;
        Ok(Self { name: format!("{name} before {}", behind.name()), photo, trimap, truth })
    }

    /// Mean distance to the truth where the trimap does not know.
    pub(crate) fn error(&self, alpha: &[f32]) -> f64 {
        let (mut sum, mut n) = (0.0, 0.0);
        for ((&found, &wanted), &level) in
            alpha.iter().zip(self.truth.alpha()).zip(self.trimap.levels())
        {
            if level == Level::Unknown {
                sum += f64::from((found - wanted).abs());
                n += 1.0;
            }
        }
        sum / f64::max(n, 1.0)
    }
}

/// A rendered oak, and the cut-out photographs that are there, before a sky and before a hedge.
pub(crate) fn known_pictures() -> Result<Vec<Known>, Box<dyn Error>> {
    let oak = paint(&known_matte(&known_tree()?, 0.0, KNOWN_PIXELS)?)?;
    let mut cut_outs = vec![("rendered oak".to_owned(), oak)];
    for name in CUT_OUTS {
        let path = photo_folder().join(name);
        if path.exists() {
            cut_outs.push((name.to_owned(), Photo::open(path, &Limits::default())?));
        } else {
            eprintln!("{name}: not there, left out");
        }
    }
    let both = [Behind::Sky, Behind::Hedge];
    cut_outs.iter().flat_map(|(name, cut_out)| both.map(|b| Known::new(name, cut_out, b))).collect()
}

fn matting(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let mut absent = false;
    for known in known_pictures()? {
        let params = NaturalParams::default();
        let (matte, _) = natural(&known.photo, &known.trimap, &params, &Control::default())?;
        let ours = known.error(matte.alpha());
        let told =
            if absent { None } else { Some(ask(&known.photo, &known.trimap, CLOSED_FORM, 0.0)) };
        let peer = match told {
            Some(Ok(alpha)) => Some(known.error(&alpha.values)),
            Some(Err(absence)) => {
                eprintln!("no peer for matting: {absence}");
                absent = true;
                None
            }
            None => None,
        };
        let case = format!("matting, {}", known.name);
        let mut row = |metric, peer, ours, aim| {
            table.row(&Row { case: &case, metric, paper: None, peer, ours, unit: "", aim });
        };
        row("mean abs. error, unknown", peer, ours, Aim::None);
        if let Some(peer) = peer {
            row("error against peer's", None, ours / peer, Aim::AtMost(MATTING_RATIO));
        }
    }
    Ok(())
}
