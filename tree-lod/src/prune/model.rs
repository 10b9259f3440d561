//! A mesh whose foliage can be drawn at any level.

use super::layout::Layout;
use super::mean::mean;
use super::schedule::Schedule;
use super::size::Sizes;
use super::vertices::{Rows, append, rows};
use crate::element::Elements;
use crate::error::{LodError, Result, check_range};
use crate::outline::Tier;
use crate::quality::{Subject, Table};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, LimitError, Resource};
use tree_mesh::{Mesh, MeshError};

/// Largest coordinate of foliage, in metres: scaled about far centres, vertices lose their place.
const LARGEST: f64 = 1e6;

/// How a model is pruned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PruneParams {
    /// Share of λ over which the last elements fade, 0 to 1. More is smoother in motion, but shows fewer of
    /// the triangles that are drawn. 0: they pop. Default 0.1.
    pub fade: f32,
}

impl Default for PruneParams {
    fn default() -> Self {
        Self { fade: 0.1 }
    }
}

impl PruneParams {
    /// Checks every field.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("fade", self.fade.into(), 0.0, 1.0)
    }
}

/// A surface that is pruned.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its number in the mesh.
    pub surface: u32,
    /// Of each vertex: the point that its element is scaled about, in metres, and the λ from which on it is
    /// drawn (0: always). Vertices of no element have themselves as centre.
    pub centers: Vec<[f32; 4]>,
    /// Mean linear colour of what is seen of the full model: texture times base colour.
    pub mean: Vec3,
    pub(super) layout: Layout,
}

/// A mesh whose foliage can be drawn at any level: windows of its index buffers.
#[derive(Clone, Debug, PartialEq)]
pub struct PrunedModel {
    pub(super) mesh: Mesh,
    pub(super) parts: Vec<Part>,
    pub(super) schedule: Schedule,
    pub(super) table: Table,
    pub(super) fade: f32,
    pub(super) sizes: Sizes,
}

impl PrunedModel {
    /// Arranges a mesh. Wood is left as it is. Surfaces of foliage keep their vertices and
    /// columns, their index buffers hold the triangles of all tiers; vertices that several elements share
    /// are doubled, and such a surface loses its anchors. What is in no element of the first tier is
    /// never drawn. `table` has the scale for each λ.
    ///
    /// # Errors
    /// As [`PruneParams::validate`], [`Schedule::new`] and [`Mesh::check`]; [`LodError::Mesh`] for elements, pivots or
    /// tiers that do not fit the mesh, or pivots that are not finite; [`LodError::Parameter`] for foliage
    /// further than 1000 km from the origin; [`LodError::Limit`] when the tiers have more triangles
    /// than allowed, or than an index buffer holds; [`LodError::Cancelled`].
    ///
    /// # Complexity
    /// O(vertices + triangles of all tiers), in parallel over surfaces.
    pub fn new(
        subject: &Subject<'_>,
        table: Table,
        params: &PruneParams,
        control: &Control,
    ) -> Result<Self> {
        params.validate()?;
        let mesh = subject.mesh;
        let schedule = Schedule::new(subject.tiers, &subject.ranking.order, subject.kept)?;
        mesh.check()?;
        check_elements(mesh, subject.elements, subject.tiers, &subject.ranking.pivots)?;
        check_room(mesh, subject.tiers, control)?;
        control.report("prune", 0.1)?;
        let made: Vec<_> = subject
            .elements
            .surfaces
            .par_iter()
            .map(|&surface| part(subject, &schedule, surface))
            .collect();
        control.report("prune", 0.8)?;
        let mut pruned = mesh.clone();
        let mut parts = Vec::with_capacity(made.len());
        for (part, rows) in made {
            let surface = &mut pruned.surfaces[part.surface as usize];
            surface.indices = rows.indices;
            append(surface, &rows.copies);
            parts.push(part);
        }
        let sizes = Sizes::of(mesh, &pruned, &parts);
        control.report("prune", 1.0)?;
        Ok(Self { mesh: pruned, parts, schedule, table, fade: params.fade, sizes })
    }

    /// The mesh to upload. Foliage must be drawn by windows: its index buffers hold leaves several
    /// times.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The surfaces that are pruned; all others are drawn whole.
    #[must_use]
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// What is drawn for each λ.
    #[must_use]
    pub fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    /// The scale for each λ.
    #[must_use]
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Memory of the buffers, before and after.
    #[must_use]
    pub fn sizes(&self) -> Sizes {
        self.sizes
    }
}

/// A part and its rows. The subject is checked.
fn part(subject: &Subject<'_>, schedule: &Schedule, number: u32) -> (Part, Rows) {
    let Subject { mesh, elements, tiers, ranking, .. } = *subject;
    let ranked = ranking.order.iter().zip(0_u32..);
    let of_part = |&(&element, _): &(&u32, u32)| elements.surface[element as usize] == number;
    let (own, ranks): (Vec<u32>, Vec<u32>) = ranked.filter(of_part).unzip();
    let center = |(&element, &rank): (&u32, &u32)| {
        ranking.pivots[element as usize].extend(schedule.lambda_of_rank(rank)).to_array()
    };
    let element_centers: Vec<_> = own.iter().zip(&ranks).map(center).collect();
    let layout = Layout::new(ranks, &own, tiers, schedule.kept());
    let surface = &mesh.surfaces[number as usize];
    let rows = rows(surface, &layout, tiers, &own, &element_centers);
    let mean = mean(surface, &mesh.materials[surface.material as usize], &surface.indices);
    let centers = rows.centers.clone();
    (Part { surface: number, centers, mean, layout }, rows)
}

fn check_elements(mesh: &Mesh, elements: &Elements, tiers: &[Tier], pivots: &[Vec3]) -> Result<()> {
    let n = tiers.first().map_or(0, |tier| tier.starts.len() - 1);
    let length = |field, found| match found == n {
        true => Ok(()),
        false => Err(MeshError::Length { surface: None, field, found, expected: n }),
    };
    length("elements", elements.surface.len())?;
    length("pivots", pivots.len())?;
    let rising = elements.surfaces.windows(2).all(|pair| pair[0] < pair[1]);
    if !rising || elements.surfaces.last().is_some_and(|&s| s as usize >= mesh.surfaces.len()) {
        return Err(LodError::Foliage("surfaces of elements must rise and be in the mesh"));
    }
    for (element, (&surface, pivot)) in elements.surface.iter().zip(pivots).enumerate() {
        if elements.surfaces.binary_search(&surface).is_err() {
            return Err(LodError::Foliage("an element is on a surface that is not foliage"));
        }
        let surface = surface as usize;
        if !pivot.is_finite() {
            let field = "pivots";
            return Err(
                MeshError::NotFinite { surface: Some(surface), field, index: element }.into()
            );
        }
        check_range("pivots", pivot.abs().max_element().into(), 0.0, LARGEST)?;
        let count = mesh.surfaces[surface].positions.len();
        for tier in tiers {
            let mut corners = tier.of(element).as_flattened().iter();
            if let Some(&found) = corners.find(|&&corner| corner as usize >= count) {
                return Err(MeshError::Dangling {
                    surface: Some(surface),
                    what: "vertex",
                    found,
                    count,
                }
                .into());
            }
        }
    }
    for &surface in &elements.surfaces {
        for p in &mesh.surfaces[surface as usize].positions {
            check_range("positions", p.abs().max_element().into(), 0.0, LARGEST)?;
        }
    }
    Ok(())
}

/// Indices, and the vertices that copies may add, must have 32 bits.
fn check_room(mesh: &Mesh, tiers: &[Tier], control: &Control) -> Result<()> {
    let requested = tiers.iter().map(|tier| tier.triangles.len() as u64).sum();
    control.limits.check(Resource::Triangles, requested)?;
    let vertices = mesh.surfaces.iter().map(|s| s.positions.len() as u64).max().unwrap_or(0);
    let cap = u64::from(u32::MAX).saturating_sub(vertices) / 3;
    if requested > cap {
        return Err(LimitError { resource: Resource::Triangles, requested, cap }.into());
    }
    Ok(())
}
