//! Pruning: level of detail by measured quality (Neubert 2012, chapters 6 and 7).

// The rows of §7.2.4 come with the scorer.
#[cfg_attr(not(test), expect(dead_code))]
mod anova;
mod billboard;
mod modelled;
mod models;
mod scene;
mod simplify;
mod views;

use crate::table::{Aim, Row, Table};
use scene::Forest;
use std::error::Error;
use tree_core::Seed;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// Billboards of Fig. 7.16.
const BILLBOARDS: usize = 209;
/// Texels along the longer side of a billboard.
const TEXELS: u32 = 128;

/// Least distance of trees in metres.
const SPACING: f32 = 5.0;
/// All scenes and clusters come from this seed.
const SEED: Seed = Seed(1);

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    let peers = models::of_peers()?;
    for model in &peers {
        clouds(table, model)?;
        simplified(table, model)?;
        simplified(table, &models::with_modelled_leaves(model)?)?;
    }
    let (imported, ours, large) = (models::imported()?, models::ours()?, models::large()?);
    for model in imported.iter().chain(&ours).chain(&large) {
        let mut figure = |metric, ours| information(table, &model.name, metric, ours);
        figure("vertices", model.mesh.n_vertices() as f64);
        figure("elements", model.elements.len() as f64);
        figure("leaf triangles", model.elements.n_triangles() as f64);
        figure("height", f64::from(model.height()));
    }
    scenes(table, (imported.len() + ours.len()) as u32, &large)
}

fn scenes(table: &mut Table, n_models: u32, large: &[models::Model]) -> Outcome {
    let standard = Forest::new(scene::STANDARD, n_models, SPACING, SEED)?;
    information(table, "standard scene", "side", f64::from(standard.side));
    information(table, "standard scene", "far", f64::from(standard.far()));
    information(table, "standard scene", "frames", standard.path(80).len() as f64);
    let forest = Forest::new(scene::LARGE, large.len() as u32, SPACING, SEED)?;
    let vertices: u64 =
        forest.instances.iter().map(|i| large[i.model as usize].mesh.n_vertices() as u64).sum();
    table.row(&Row {
        case: "large scene",
        metric: "vertices of full models",
        paper: Some(scene::LARGE_VERTICES as f64),
        peer: None,
        ours: vertices as f64,
        unit: "vertices",
        aim: Aim::AtLeast(scene::LARGE_VERTICES as f64),
    });
    let size = forest.instances.iter().map(|i| i.matrix().determinant()).sum::<f32>();
    information(table, "large scene", "mean volume scale", f64::from(size) / 5000.0);
    information(table, "large scene", "views", forest.overviews(12).len() as f64);
    Ok(())
}

fn information(table: &mut Table, case: &str, metric: &str, ours: f64) {
    table.row(&Row { case, metric, paper: None, peer: None, ours, unit: "", aim: Aim::None });
}

fn clouds(table: &mut Table, model: &models::Model) -> Outcome {
    let views = views::around(&model.mesh, 36, 0.0, 0.1, 512);
    let reference = views::Reference::new(&model.mesh, views)?;
    let planes = billboard::decoret(&model.mesh, &model.elements, BILLBOARDS);
    let clusters = billboard::behrendt(&model.mesh, &model.elements, BILLBOARDS, SEED);
    for (name, billboards) in [("Décoret", planes), ("Behrendt", clusters)] {
        let baked = billboard::bake(&model.mesh, &model.elements, &billboards, TEXELS)?;
        let scores = reference.scores(&baked)?;
        let qualities: Vec<f64> = scores.iter().map(|score| score.quality()).collect();
        let case = format!("{}, {name}", model.name);
        information(table, &case, "billboards", billboards.len() as f64);
        information(table, &case, "Q", views::mean(&qualities));
        information(table, &case, "spread of Q", views::spread(&qualities));
    }
    Ok(())
}

fn simplified(table: &mut Table, model: &models::Model) -> Outcome {
    let reference =
        views::Reference::new(&model.mesh, views::around(&model.mesh, 8, 0.5, 0.1, 512))?;
    let foliage = &model.elements.surfaces;
    for how in [simplify::How::Simplify, simplify::How::Prune, simplify::How::Sloppy] {
        for share in [0.5, 0.2, 0.1, 0.05] {
            let made = simplify::simplify(&model.mesh, foliage, share, how);
            let restored = simplify::restore_area(&made.mesh, &model.mesh, foliage);
            let case = format!("{}, {how:?} {share}", model.name);
            information(table, &case, "share", made.share);
            information(table, &case, "Q", reference.quality(&made.mesh)?);
            information(table, &case, "Q, area restored", reference.quality(&restored)?);
        }
    }
    Ok(())
}
