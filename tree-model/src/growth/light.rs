//! Shadow propagation (Palubicki et al. 2009, section 4.1): leaves shade a pyramid of voxels below them.
//!
//! A metamer in voxel (i, j, k) adds a·b^-q to all voxels (i ± p, j - q, k ± p) with p up to q, for q from 0
//! to a depth. A point has the light C - s, where s is the shadow of its voxel without its own.
//!
//! Shadows are kept as whole numbers of 2⁻¹⁴: sums do not depend on the order, and what is taken away
//! again leaves no trace.

use super::lattice::Lattice;
use crate::error::{Result, check};
use glam::{IVec3, Vec3};
use tree_core::Limits;

/// Deepest pyramid: 2,870 × 2 voxels for each metamer already at 20.
const MAX_DEPTH: u32 = 32;
/// Units of shadow in 1.
const UNITS: f32 = 16_384.0;
/// Pyramids lean at most so many voxels for each they go down: light from 14° above the horizon.
const MAX_LEAN: f32 = 4.0;
/// Coordinates of voxels stay this far from the end of an i32.
const MAX_CELL: f32 = 1e9;

/// How leaves shade what is below them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Shadow {
    /// Edge of a voxel in metres, 0.001 to 100. About one and a half internodes. Default 0.2.
    pub voxel: f32,
    /// Shadow in the metamer's own voxel (a), 0 to 4; the open sky gives a light of 1. Default 0.12.
    pub strength: f32,
    /// What divides the shadow with each layer down (b), 1 to 10. Default 1.4.
    pub falloff: f32,
    /// Layers below the metamer's own that it shades, 0 to 32; cost grows with the cube. Default 7.
    pub depth: u32,
    /// How many voxels a bud looks around for the brighter side, 1 to 8; cost grows with the cube.
    /// Default 3.
    pub reach: u32,
}

impl Default for Shadow {
    fn default() -> Self {
        Self { voxel: 0.2, strength: 0.12, falloff: 1.4, depth: 7, reach: 3 }
    }
}

impl Shadow {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check("shadow.voxel", self.voxel, 0.001_f32, 100)?;
        check("shadow.strength", self.strength, 0, 4)?;
        check("shadow.falloff", self.falloff, 1, 10)?;
        check("shadow.depth", self.depth, 0, MAX_DEPTH)?;
        check("shadow.reach", self.reach, 1, 8)
    }
}

/// The shadows of all leaves.
#[derive(Clone, Debug)]
pub(crate) struct ShadowGrid {
    shadow: Shadow,
    cells: Lattice<u64>,
    /// Shadow and shift of each layer.
    layers: Vec<(u64, IVec3)>,
    /// Offsets within reach, with the direction to each over its distance.
    around: Vec<(IVec3, Vec3)>,
}

impl ShadowGrid {
    /// Without any shadow. `light` points to the brightest part of the sky; from lower than 14° above the
    /// horizon pyramids lean as if it were 14°.
    ///
    /// # Errors
    /// As [`Shadow::validate`].
    pub(crate) fn new(shadow: &Shadow, light: Vec3) -> Result<Self> {
        shadow.validate()?;
        let reach = shadow.reach as i32;
        let side = move || -reach..=reach;
        let around = side()
            .flat_map(|x| side().flat_map(move |y| side().map(move |z| IVec3::new(x, y, z))))
            .filter(|offset| *offset != IVec3::ZERO && offset.length_squared() <= reach * reach)
            .map(|offset| {
                let away = offset.as_vec3();
                (offset, away / away.length_squared())
            })
            .collect();
        Ok(Self { shadow: *shadow, cells: Lattice::new(), layers: layers(shadow, light), around })
    }

    /// The parameters.
    #[must_use]
    pub(crate) fn shadow(&self) -> &Shadow {
        &self.shadow
    }

    fn cell(&self, point: Vec3) -> IVec3 {
        let cell = (point / self.shadow.voxel).floor();
        cell.clamp(Vec3::splat(-MAX_CELL), Vec3::splat(MAX_CELL)).as_ivec3()
    }

    /// Adds the shadow of leaves at `points`.
    ///
    /// # Errors
    /// [`ModelError::Limit`](crate::ModelError::Limit) when the grid would have too many voxels; nothing is
    /// added then.
    ///
    /// # Complexity
    /// O(points · depth³).
    pub(crate) fn cast(&mut self, points: &[Vec3], limits: &Limits) -> Result<()> {
        if points.is_empty() {
            return Ok(());
        }
        let (mut low, mut high) = (IVec3::MAX, IVec3::MIN);
        for &point in points {
            let cell = self.cell(point);
            (low, high) = (low.min(cell), high.max(cell));
        }
        let (mut under, mut over) = (IVec3::ZERO, IVec3::ZERO);
        for (q, &(_, shift)) in (0..).zip(&self.layers) {
            let wide = IVec3::new(q, 0, q);
            (under, over) = (under.min(shift - wide), over.max(shift + wide));
        }
        self.cells.cover(low + under, high + over, limits)?;
        self.add(points, |cell, shadow| *cell += shadow);
        Ok(())
    }

    /// Takes the shadow of leaves at `points` away again, which must have been cast before.
    ///
    /// # Complexity
    /// As [`cast`](Self::cast).
    pub(crate) fn lift(&mut self, points: &[Vec3]) {
        self.add(points, |cell, shadow| *cell = cell.saturating_sub(shadow));
    }

    fn add(&mut self, points: &[Vec3], change: impl Fn(&mut u64, u64)) {
        for &point in points {
            let apex = self.cell(point);
            for (q, &(shadow, shift)) in (0_i32..).zip(&self.layers) {
                let first = apex + shift - IVec3::new(q, 0, q);
                let last = apex + shift + IVec3::new(q, 0, q);
                if !self.cells.holds(first) || !self.cells.holds(last) {
                    // Only for what was never cast.
                    continue;
                }
                for x in 0..=2 * q {
                    let from = self.cells.place(first + x * IVec3::X);
                    let row = &mut self.cells.cells_mut()[from..=from + 2 * q as usize];
                    row.iter_mut().for_each(|cell| change(cell, shadow));
                }
            }
        }
    }

    /// Shadow at a point, 0 or more.
    #[must_use]
    pub(crate) fn at(&self, point: Vec3) -> f32 {
        self.cells.get(self.cell(point)) as f32 / UNITS
    }

    /// The direction away from the shadows around a point: the mean of all directions within reach, each by
    /// how much darker it is there, turned round. Zero where the shadow is the same on all sides.
    ///
    /// # Complexity
    /// O(reach³).
    #[must_use]
    pub(crate) fn brighter(&self, point: Vec3) -> Vec3 {
        let cell = self.cell(point);
        let reach = IVec3::splat(self.shadow.reach as i32);
        let sum = if self.cells.holds(cell - reach) && self.cells.holds(cell + reach) {
            self.sum_around(|offset| self.cells.cells()[self.cells.place(cell + offset)])
        } else {
            self.sum_around(|offset| self.cells.get(cell + offset))
        };
        (-sum).normalize_or_zero()
    }

    fn sum_around(&self, shadow: impl Fn(IVec3) -> u64) -> Vec3 {
        self.around
            .iter()
            .fold(Vec3::ZERO, |sum, &(offset, weight)| sum + shadow(offset) as f32 * weight)
    }
}

/// Shadow and shift of each layer of a pyramid that opens away from the light.
fn layers(shadow: &Shadow, light: Vec3) -> Vec<(u64, IVec3)> {
    let light = light.normalize_or(Vec3::Y);
    let flat = Vec3::new(light.x, 0.0, light.z);
    let lean = match flat.length() / light.y.max(f32::MIN_POSITIVE) {
        steep if steep <= MAX_LEAN => flat / light.y.max(f32::MIN_POSITIVE),
        _ => MAX_LEAN * flat.normalize_or_zero(),
    };
    let (mut layers, mut strength) = (Vec::new(), shadow.strength);
    for q in 0..=shadow.depth {
        let shift = (-(q as f32) * (lean + Vec3::Y)).round().as_ivec3();
        layers.push(((strength * UNITS).round() as u64, shift));
        strength /= shadow.falloff;
    }
    layers
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn grid(light: Vec3) -> ShadowGrid {
        let shadow =
            Shadow { voxel: 1.0, strength: 0.5, falloff: 2.0, depth: 3, ..Default::default() };
        ShadowGrid::new(&shadow, light).unwrap()
    }

    #[test]
    fn a_metamer_shades_a_pyramid_below_it() {
        let mut grid = grid(Vec3::Y);
        grid.cast(&[Vec3::splat(0.5)], &Limits::default()).unwrap();
        let at = |x: f32, y: f32, z: f32| grid.at(Vec3::new(x + 0.5, y + 0.5, z + 0.5));
        assert_eq!(
            [at(0.0, 0.0, 0.0), at(0.0, -1.0, 0.0), at(0.0, -3.0, 0.0)],
            [0.5, 0.25, 0.0625]
        );
        assert_eq!([at(1.0, 0.0, 0.0), at(1.0, -1.0, 1.0), at(2.0, -1.0, 0.0)], [0.0, 0.25, 0.0]);
        assert_eq!([at(0.0, 1.0, 0.0), at(0.0, -4.0, 0.0)], [0.0, 0.0]);
    }

    #[test]
    fn light_from_the_side_leans_the_pyramid_away() {
        let mut grid = grid(Vec3::new(1.0, 1.0, 0.0));
        grid.cast(&[Vec3::splat(0.5)], &Limits::default()).unwrap();
        assert_eq!(grid.at(Vec3::new(-2.5, -2.5, 0.5)), 0.0625);
        assert_eq!(grid.at(Vec3::new(2.5, -2.5, 0.5)), 0.0);
        let low = ShadowGrid::new(grid.shadow(), Vec3::new(1.0, -1.0, 0.0)).unwrap();
        assert_eq!(low.layers[3].1, IVec3::new(-12, -3, 0));
    }

    #[test]
    fn the_brighter_side_is_away_from_the_leaves() {
        let mut grid = grid(Vec3::Y);
        assert_eq!(grid.brighter(Vec3::ZERO), Vec3::ZERO);
        grid.cast(&[Vec3::new(2.5, 0.5, 0.5)], &Limits::default()).unwrap();
        let away = grid.brighter(Vec3::splat(0.5));
        assert!(away.x < -0.7 && away.is_normalized(), "{away}");
    }

    proptest! {
        #[test]
        fn lifting_a_shadow_leaves_what_was_before(
            kept in prop::collection::vec(prop::array::uniform3(-9.0_f32..9.0), 0..20),
            lifted in prop::collection::vec(prop::array::uniform3(-9.0_f32..9.0), 0..20),
        ) {
            let of = |points: &[[f32; 3]]| points.iter().map(|&p| p.into()).collect::<Vec<Vec3>>();
            let (kept, lifted) = (of(&kept), of(&lifted));
            let (mut plain, mut both) = (grid(Vec3::Y), grid(Vec3::Y));
            plain.cast(&kept, &Limits::default()).unwrap();
            both.cast(&lifted, &Limits::default()).unwrap();
            both.cast(&kept, &Limits::default()).unwrap();
            both.lift(&lifted);
            for x in -14..14 {
                for y in -14..14 {
                    let point = Vec3::new(x as f32, y as f32, 0.5);
                    prop_assert_eq!(plain.at(point), both.at(point));
                }
            }
        }
    }
}
