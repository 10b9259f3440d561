//! Pruning: level of detail by measured quality (Neubert 2012, chapters 6 and 7).

mod anova;
mod billboard;
mod modelled;
mod models;
mod scene;
mod simplify;
mod views;

use crate::table::{Aim, Row, Table};
use std::error::Error;
use tree_core::Seed;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// Billboards of Fig. 7.16.
const BILLBOARDS: usize = 209;
/// Texels along the longer side of a billboard.
const TEXELS: u32 = 128;

/// All of it; see the rows.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    let peers = models::of_peers()?;
    for model in &peers {
        clouds(table, model)?;
        simplified(table, model)?;
        simplified(table, &models::with_modelled_leaves(model)?)?;
    }
    for model in models::imported()?.iter().chain(&models::ours()?).chain(&models::large()?) {
        let mut figure = |metric, ours| information(table, &model.name, metric, ours);
        figure("vertices", model.mesh.n_vertices() as f64);
        figure("elements", model.elements.len() as f64);
        figure("leaf triangles", model.elements.n_triangles() as f64);
        figure("height", f64::from(model.height()));
    }
    Ok(())
}

fn information(table: &mut Table, case: &str, metric: &str, ours: f64) {
    table.row(&Row { case, metric, paper: None, peer: None, ours, unit: "", aim: Aim::None });
}

fn clouds(table: &mut Table, model: &models::Model) -> Outcome {
    let views = views::around(&model.mesh, 36, 0.0, 0.1, 512);
    let reference = views::Reference::new(&model.mesh, views)?;
    let planes = billboard::decoret(&model.mesh, &model.elements, BILLBOARDS);
    let clusters = billboard::behrendt(&model.mesh, &model.elements, BILLBOARDS, Seed(1));
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
