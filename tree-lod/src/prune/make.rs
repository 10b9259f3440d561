//! A mesh to a pruned model in one call.

use super::model::{PruneParams, PrunedModel};
use super::plan::plan;
use crate::element::{Elements, Grain, LeafSurfaces};
use crate::error::Result;
use crate::order::{CoverageParams, coverage};
use crate::outline::{OutlineParams, Tier, tiers};
use crate::quality::{Subject, Table, TableParams};
use tree_core::Control;
use tree_mesh::Mesh;

/// Parameters of every step from a mesh to a [`PrunedModel`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MakeParams {
    /// Which surfaces are pruned.
    pub foliage: LeafSurfaces,
    /// What an element is.
    pub grain: Grain,
    /// How outlines become simpler.
    pub outlines: OutlineParams,
    /// How the order is found. Default none: [`CoverageParams::for_triangles`].
    pub order: Option<CoverageParams>,
    /// How scales are measured. Default none: [`TableParams::for_triangles`].
    pub table: Option<TableParams>,
    /// How the model is pruned.
    pub prune: PruneParams,
}

/// Triangles of an element from which on the order is found with simpler outlines: it changes little,
/// and takes a fraction of the time.
const FINE: usize = 6;

impl PrunedModel {
    /// All steps: elements, tiers, order by coverage, plan, table and model.
    ///
    /// # Errors
    /// Those of [`Elements::of_mesh`], [`tiers`], [`coverage`], [`plan`], [`Table::measure`] and
    /// [`PrunedModel::new`].
    ///
    /// # Complexity
    /// Dominated by [`coverage`]: some seconds for half a million triangles.
    pub fn make(mesh: &Mesh, params: &MakeParams, control: &Control) -> Result<Self> {
        let elements =
            Elements::of_mesh(mesh, &params.foliage, params.grain, &control.part(0.0, 0.05))?;
        let tiers = tiers(mesh, &elements, &params.outlines, &control.part(0.05, 0.15))?;
        let n = elements.n_triangles();
        let shape = fine_enough(&tiers, elements.len());
        let order = params.order.clone().unwrap_or_else(|| CoverageParams::for_triangles(n));
        let ranking = coverage(mesh, &elements, shape, &order, &control.part(0.15, 0.7))?;
        let subject =
            Subject { mesh, elements: &elements, tiers: &tiers, ranking: &ranking, kept: &[] };
        let kept = plan(&subject, &control.part(0.7, 0.8))?;
        let subject = Subject { kept: &kept, ..subject };
        let table = params.table.clone().unwrap_or_else(|| TableParams::for_triangles(n));
        let table = Table::measure(&subject, &table, &control.part(0.8, 0.95))?;
        Self::new(&subject, table, &params.prune, &control.part(0.95, 1.0))
    }
}

/// The coarsest tier whose elements still have some triangles.
fn fine_enough(tiers: &[Tier], n: usize) -> &Tier {
    let enough = |tier: &&Tier| 2 * tier.triangles.len() >= FINE * n;
    // `tiers` always has the full model.
    tiers.iter().rev().find(enough).unwrap_or(&tiers[0])
}
