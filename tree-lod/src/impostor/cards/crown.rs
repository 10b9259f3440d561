//! How much sky reaches the places of a crown: leaves as a medium of even density in each cell of a grid.
//!
//! Light falls off by e^(−k·s) along a way s through leaves of extinction k (Beer, Lambert). Leaves that
//! look anywhere have k = half their area in a cubic metre (Ross 1981, "The radiation regime and architecture
//! of plant stands", G = 1/2).

use crate::element::Elements;
use crate::preview::hemisphere;
use glam::Vec3;
use rayon::prelude::*;
use tree_mesh::Mesh;

/// Cells along the longest side. More are sharper, and noisier.
const CELLS: f32 = 20.0;
/// Directions of the sky.
const DIRECTIONS: u32 = 24;
/// Half of the area of leaves hides, on average over directions.
const HIDES: f32 = 0.5;
/// Light that comes from leaves around rather than from the sky, where no sky is seen.
const SCATTERED: f32 = 0.35;

/// The density of the leaves of a tree.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Crown {
    min: Vec3,
    /// Side of a cell in metres.
    cell: f32,
    n: [usize; 3],
    /// Extinction of each cell, x first, in 1/m.
    hides: Vec<f32>,
}

/// The light at the middle of each cell of a [`Crown`].
pub(super) struct Light<'a> {
    crown: &'a Crown,
    values: Vec<f32>,
}

impl Crown {
    /// `drawn` is the share of each surface's area that is drawn at all.
    ///
    /// # Complexity
    /// O(leaves + cells).
    pub(super) fn new(mesh: &Mesh, elements: &Elements, drawn: &dyn Fn(u32) -> f32) -> Self {
        let bounds = tree_core::Aabb::of_points(&elements.centers);
        let cell = (bounds.size().max_element() / CELLS).max(1e-6);
        // A cell more on each side: leaves are larger than points.
        let min = bounds.min - 0.5 * cell;
        let n = (bounds.size() / cell).to_array().map(|n| n as usize + 2);
        let mut this = Self { min, cell, n, hides: vec![0.0; n[0] * n[1] * n[2]] };
        let shares: Vec<f32> = (0..mesh.surfaces.len() as u32).map(drawn).collect();
        let per_area = HIDES / (cell * cell * cell);
        for (leaf, &center) in elements.centers.iter().enumerate() {
            let share = shares.get(elements.surface[leaf] as usize).copied().unwrap_or(1.0);
            let at = (center - this.min) / cell;
            let cell = this.number(at.to_array().map(|t| t as usize));
            this.hides[cell] += elements.areas[leaf] * share * per_area;
        }
        this
    }

    fn number(&self, at: [usize; 3]) -> usize {
        let [x, y, z] = [0, 1, 2].map(|axis| at[axis].min(self.n[axis] - 1));
        (z * self.n[1] + y) * self.n[0] + x
    }

    /// The light of an even sky: 1 outside the crown, less inside.
    ///
    /// # Complexity
    /// O(cells × directions × cells along a side), in parallel.
    pub(super) fn light(&self) -> Light<'_> {
        let sky = hemisphere(DIRECTIONS);
        let at = |cell: usize| {
            let [nx, ny, _] = self.n;
            let middle = [cell % nx, cell / nx % ny, cell / (nx * ny)].map(|i| i as f32 + 0.5);
            let sum: f32 = sky.iter().map(|&way| self.through(middle.into(), way)).sum();
            SCATTERED + (1.0 - SCATTERED) * sum / sky.len() as f32
        };
        Light { crown: self, values: (0..self.hides.len()).into_par_iter().map(at).collect() }
    }

    /// Share of light that comes along a way to a place, both in cells.
    fn through(&self, mut at: Vec3, way: Vec3) -> f32 {
        let mut depth = 0.0;
        let end = Vec3::from(self.n.map(|n| n as f32));
        // Its own cell counts by half: what is seen lies on its sunny side as often as on the other.
        let mut share = 0.5;
        while at.cmpge(Vec3::ZERO).all() && at.cmplt(end).all() {
            depth += share * self.hides[self.number(at.to_array().map(|t| t as usize))];
            share = 1.0;
            at += way;
        }
        // No transcendental of the standard library: the same bits everywhere.
        libm::expf(-depth * self.cell)
    }
}

impl Light<'_> {
    /// Between the middles of cells; 1 far outside.
    pub(super) fn at(&self, p: Vec3) -> f32 {
        let crown = self.crown;
        let at = (p - crown.min) / crown.cell - 0.5;
        let low = at.floor();
        let f = at - low;
        let value = |x: i32, y: i32, z: i32| {
            let at = [low.x as i32 + x, low.y as i32 + y, low.z as i32 + z];
            let at = at.map(|t| t.max(0) as usize);
            self.values.get(crown.number(at)).copied().unwrap_or(1.0)
        };
        let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
        let row = |y, z| mix(value(0, y, z), value(1, y, z), f.x);
        let face = |z| mix(row(0, z), row(1, z), f.y);
        mix(face(0), face(1), f.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::{Grain, LeafSurfaces};
    use crate::impostor::tests::leaves;
    use tree_core::{Control, Seed, seed};

    /// Leaves in a ball of 2 m.
    fn ball(n: usize) -> Crown {
        let mut rng = Seed(8).rng();
        let at: Vec<Vec3> = (0..n).map(|_| 2.0 * seed::in_unit_ball(&mut rng)).collect();
        let mesh = leaves(&at, 0.05);
        let control = Control::default();
        let elements =
            Elements::of_mesh(&mesh, &LeafSurfaces::Found, Grain::Leaf, &control).unwrap();
        Crown::new(&mesh, &elements, &|_| 1.0)
    }

    #[test]
    fn less_light_comes_deeper_into_a_crown_and_into_a_denser_one() {
        let (thin, dense) = (ball(500), ball(5000));
        let (thin, dense) = (thin.light(), dense.light());
        let down: Vec<f32> = [1.9, 1.0, 0.0, -1.0].iter().map(|&y| dense.at(Vec3::Y * y)).collect();
        assert!(down.windows(2).all(|pair| pair[0] > pair[1]), "{down:?}");
        assert!(thin.at(Vec3::ZERO) > dense.at(Vec3::ZERO));
        assert!(down.iter().all(|light| (SCATTERED..=1.0).contains(light)));
        assert!(dense.at(Vec3::Y * 50.0) > 0.5);
    }

    #[test]
    fn light_falls_off_as_through_an_even_medium() {
        let (crown, k) =
            (ball(4000), HIDES * 4000.0 * 0.01 / (4.0 / 3.0 * std::f32::consts::PI * 8.0));
        let middle = Vec3::from(crown.n.map(|n| n as f32)) * 0.5;
        let found = crown.through(middle, Vec3::Y);
        let wanted = libm::expf(-2.0 * k);
        assert!((found - wanted).abs() < 0.15 * wanted, "{found} {wanted}");
    }
}
