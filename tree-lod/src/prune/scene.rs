//! The model as a scene draws it.

use super::level::Level;
use super::model::PrunedModel;
use crate::error::{LodError, Result};
use crate::quality::Distance;
use crate::select::{Draw, Level as Step, Model};
use glam::Vec3;
use tree_core::Aabb;

impl PrunedModel {
    /// The model for a [`Scene`](crate::select::Scene), with `n` levels ([`levels`](Self::levels)): a draw for every
    /// surface, wood included, all surfaces one after another in one vertex buffer and one index buffer. Points
    /// for occlusion, `near` and `far` are left at their defaults.
    ///
    /// # Errors
    /// As [`levels`](Self::levels) and [`Model::validate`]: for example more than 64 surfaces;
    /// [`LodError::Scene`] when there are 2³² indices or 2³¹ vertices, or more.
    ///
    /// # Complexity
    /// O(n · surfaces + vertices).
    pub fn to_select_model(&self, n: usize, distance: Distance) -> Result<Model> {
        let levels = self.levels(n)?;
        let whole = self.draws()?;
        let growth = levels.iter().fold(1.0_f32, |most, level| most.max(level.growth));
        let (center, radius) = self.sphere(growth);
        let step = |level: &Level| {
            let mut draws = whole.clone();
            for window in &level.windows {
                let draw = &mut draws[window.surface as usize];
                draw.first_index += window.first_index;
                draw.index_count = window.index_count;
            }
            Step { lambda: level.lambda, scale: level.scale, fade: level.fade, draws }
        };
        let levels = levels.iter().map(step).collect();
        let model = Model { center, radius, distance, levels, ..Model::default() };
        model.validate()?;
        Ok(model)
    }

    /// Every surface with its whole index buffer.
    fn draws(&self) -> Result<Vec<Draw>> {
        let (mut first, mut base) = (0_u32, 0_i32);
        let mut draws = Vec::with_capacity(self.mesh.surfaces.len());
        for (row, surface) in self.mesh.surfaces.iter().enumerate() {
            let problem = "one buffer cannot hold so much: draw surfaces from buffers of their own";
            let full = || LodError::Scene { what: "surface", row, problem };
            let index_count = u32::try_from(surface.indices.len()).map_err(|_| full())?;
            draws.push(Draw { first_index: first, index_count, base_vertex: base });
            first = first.checked_add(index_count).ok_or_else(full)?;
            let n = i32::try_from(surface.positions.len()).map_err(|_| full())?;
            base = base.checked_add(n).ok_or_else(full)?;
        }
        Ok(draws)
    }

    /// Centre and radius of a ball around all vertices, elements grown by anything up to `growth`.
    fn sphere(&self, growth: f32) -> (Vec3, f32) {
        let grown = self.parts.iter().flat_map(|part| {
            let positions = &self.mesh.surfaces[part.surface as usize].positions;
            positions.iter().zip(&part.centers).map(move |(&p, &[x, y, z, _])| {
                let center = Vec3::new(x, y, z);
                center + growth * (p - center)
            })
        });
        let plain = self.mesh.surfaces.iter().flat_map(|surface| surface.positions.iter().copied());
        // Between both a vertex moves on a line, and a ball holds all of it.
        let points: Vec<Vec3> = plain.chain(grown).collect();
        let center = Aabb::of_points(&points).center();
        let far = points.iter().fold(0.0_f32, |far, p| far.max(p.distance_squared(center)));
        // Faded elements shrink to their centres, which a leaf may have outside of itself.
        let pivots = self.parts.iter().flat_map(|part| &part.centers);
        let far = pivots
            .fold(far, |far, &[x, y, z, _]| far.max(Vec3::new(x, y, z).distance_squared(center)));
        (center, far.sqrt())
    }
}
