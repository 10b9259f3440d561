//! A model, prepared for pruning: in our way, or in an order of the literature.

use super::Outcome;
use super::models::{Leaves, Model};
use tree_core::Control;
use tree_lod::cover::Around;
use tree_lod::order::{CoverageParams, Ranking, coverage};
use tree_lod::outline::{OutlineParams, Tier, tiers};
use tree_lod::prune::{Schedule, plan};
use tree_lod::quality::{Scale, Score, Subject, Table, TableParams, mean_quality, scores_at};
use tree_lod::{Elements, Grain, LeafSurfaces};
use tree_mesh::{Mesh, Surface};

/// Rows of the tables: so fine that the λ of a quality is not a matter of interpolation.
pub(super) const LAMBDAS: [f32; 16] =
    [0.01, 0.015, 0.02, 0.03, 0.05, 0.08, 0.125, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];

/// Rows of the tables of orders of the literature, which are looked at as a mean over many models.
const FEW_LAMBDAS: [f32; 10] = [0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.45, 0.6, 0.8, 1.0];

/// How a table of the evaluation is measured: the views of the library's default.
pub(super) fn table_params(scale: Scale) -> TableParams {
    TableParams { lambdas: LAMBDAS.to_vec(), scale, ..TableParams::default() }
}

/// How tables of orders of the literature are measured: fewer rows, and half the views.
pub(super) fn few_params(scale: Scale) -> TableParams {
    let params = table_params(scale);
    let around = Around { azimuths: params.around.azimuths / 2, ..params.around };
    TableParams { around, lambdas: FEW_LAMBDAS.to_vec(), ..params }
}

/// Views that neither orders nor tables have seen: eight azimuths, whole tree.
pub(super) fn held_out(size: u32) -> Around {
    Around { azimuths: 8, turn: 0.3, size, ..Around::default() }
}

/// The tier that the order is found with, as in [`PrunedModel::make`](tree_lod::prune::PrunedModel::make):
/// the coarsest whose elements have three triangles on average.
pub(super) fn fine_enough(tiers: &[Tier], n: usize) -> &Tier {
    let enough = |tier: &&Tier| tier.triangles.len() >= 3 * n;
    tiers.iter().rev().find(enough).unwrap_or(&tiers[0])
}

/// Everything that a share of geometry is drawn with.
pub(super) struct Pruned<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) elements: Elements,
    pub(super) tiers: Vec<Tier>,
    pub(super) ranking: Ranking,
    pub(super) kept: Vec<u32>,
    pub(super) table: Table,
}

impl<'a> Pruned<'a> {
    /// Our best, as [`PrunedModel::make`](tree_lod::prune::PrunedModel::make) does it: elements and tiers by the kind of leaves, the order by coverage, a plan, a measured table.
    pub(super) fn ours(model: &'a Model) -> Outcome<Self> {
        let params = CoverageParams::default();
        Self::ours_with(model, &params, &table_params(Scale::Best))
    }

    /// As [`ours`](Self::ours), with these parameters.
    pub(super) fn ours_with(
        model: &'a Model,
        coverage_params: &CoverageParams,
        table_params: &TableParams,
    ) -> Outcome<Self> {
        let (mesh, control) = (&model.mesh, Control::default());
        let grain = if model.leaves == Leaves::Cards { Grain::Triangle } else { Grain::Blade };
        let elements = Elements::of_mesh(mesh, &LeafSurfaces::Found, grain, &control)?;
        let tiers = match model.leaves {
            Leaves::Cards => vec![Tier::full(mesh, &elements)],
            _ => tiers(mesh, &elements, &OutlineParams::default(), &control)?,
        };
        let fine = fine_enough(&tiers, elements.len());
        let ranking = coverage(mesh, &elements, fine, coverage_params, &control)?;
        let subject =
            Subject { mesh, elements: &elements, tiers: &tiers, ranking: &ranking, kept: &[] };
        let kept = plan(&subject, &control)?;
        let table = Table::measure(&Subject { kept: &kept, ..subject }, table_params, &control)?;
        Ok(Self { mesh, elements, tiers, ranking, kept, table })
    }

    /// Whole leaves in an order of the literature, scaled about their centres, with a table of [`few_params`].
    pub(super) fn ordered(model: &'a Model, order: Vec<u32>, scale: Scale) -> Outcome<Self> {
        Self::ordered_with(model, model.elements.clone(), order, &few_params(scale))
    }

    /// These elements in an order of the literature, with a table of these parameters.
    pub(super) fn ordered_with(
        model: &'a Model,
        elements: Elements,
        order: Vec<u32>,
        table_params: &TableParams,
    ) -> Outcome<Self> {
        let mesh = &model.mesh;
        let tiers = vec![Tier::full(mesh, &elements)];
        let ranking = Ranking { order, pivots: elements.centers.clone() };
        let subject =
            Subject { mesh, elements: &elements, tiers: &tiers, ranking: &ranking, kept: &[] };
        let table = Table::measure(&subject, table_params, &Control::default())?;
        Ok(Self { mesh, elements, tiers, ranking, kept: Vec::new(), table })
    }

    pub(super) fn subject(&self) -> Subject<'_> {
        let Self { mesh, elements, tiers, ranking, kept, .. } = self;
        Subject { mesh, elements, tiers, ranking, kept }
    }

    pub(super) fn schedule(&self) -> Outcome<Schedule> {
        Ok(Schedule::new(&self.tiers, &self.ranking.order, &self.kept)?)
    }

    /// Scores at a λ, with the scale of the table.
    pub(super) fn scores(&self, lambda: f32, around: &Around) -> Outcome<Vec<Score>> {
        Ok(self.scores_of(&[lambda], around)?.concat())
    }

    /// Scores at each of many λ, with the scales of the table.
    pub(super) fn scores_of(&self, lambdas: &[f32], around: &Around) -> Outcome<Vec<Vec<Score>>> {
        let at: Vec<_> =
            lambdas.iter().map(|&lambda| (lambda, self.table.at(lambda).scale)).collect();
        self.scores_at(&at, around)
    }

    /// Scores at each of many λ and scales (on area).
    pub(super) fn scores_at(&self, at: &[(f32, f32)], around: &Around) -> Outcome<Vec<Vec<Score>>> {
        Ok(scores_at(&self.subject(), at, around, &Control::default())?)
    }

    /// Mean quality at each of many λ, with the scales of the table.
    pub(super) fn qualities(&self, lambdas: &[f32], around: &Around) -> Outcome<Vec<f64>> {
        Ok(self.scores_of(lambdas, around)?.iter().map(|scores| mean_quality(scores)).collect())
    }

    /// Mean quality at a λ, with the scale of the table.
    pub(super) fn quality(&self, lambda: f32, around: &Around) -> Outcome<f64> {
        Ok(mean_quality(&self.scores(lambda, around)?))
    }

    /// The mesh that is drawn at a λ, and the element of each triangle of each surface: `None` for wood.
    pub(super) fn mesh_at(&self, lambda: f32) -> Outcome<(Mesh, Vec<Option<Vec<u32>>>)> {
        let cut = self.schedule()?.at(lambda)?;
        let growth = self.table.at(lambda).scale.sqrt();
        let mut mesh = self.mesh.clone();
        let mut owners = vec![None; mesh.surfaces.len()];
        for &number in &self.elements.surfaces {
            let material = mesh.surfaces[number as usize].material;
            mesh.surfaces[number as usize] = Surface { material, ..Surface::default() };
            owners[number as usize] = Some(Vec::new());
        }
        let coarse = (cut.tier as usize + 1).min(self.tiers.len() - 1);
        for (rank, &element) in self.ranking.order[..cut.end as usize].iter().enumerate() {
            let tier = if rank < cut.fine as usize { cut.tier as usize } else { coarse };
            let number = self.elements.surface[element as usize] as usize;
            let pivot = self.ranking.pivots[element as usize];
            let (from, to) = (&self.mesh.surfaces[number], &mut mesh.surfaces[number]);
            for rows in self.tiers[tier].of(element as usize) {
                for &row in rows {
                    to.indices.push(to.positions.len() as u32);
                    to.positions.push(pivot + growth * (from.positions[row as usize] - pivot));
                    to.normals.push(from.normals[row as usize]);
                    to.uvs.push(from.uvs[row as usize]);
                }
                if let Some(owners) = &mut owners[number] {
                    owners.push(element);
                }
            }
        }
        Ok((mesh, owners))
    }
}
