//! Numbers on a regular grid of cubes.

use crate::error::{Result, check, check_finite};
use glam::{IVec3, UVec3, Vec3};
use tree_core::{Aabb, Limits, Resource};

/// Numbers on a regular grid of cubic voxels. The value of a voxel is that at its centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    corner: Vec3,
    voxel: f32,
    size: UVec3,
    values: Vec<f32>,
}

impl Grid {
    /// A grid of zeros with its lowest corner at `corner`, `size` voxels of `voxel` metres.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) or
    /// [`ModelError::NotFinite`](crate::ModelError::NotFinite) for a size of 0 or more than 4096, a voxel
    /// below 1e-6 m or above 1e6 m, a corner that is not finite;
    /// [`ModelError::Limit`](crate::ModelError::Limit) before memory is taken.
    pub fn new(corner: Vec3, voxel: f32, size: UVec3, limits: &Limits) -> Result<Self> {
        check_finite("grid.corner", corner)?;
        check("grid.voxel", voxel, 1e-6_f32, 1e6_f32)?;
        for (axis, n) in ["x", "y", "z"].into_iter().zip(size.to_array()) {
            check(format!("grid.size.{axis}"), n, 1, 4096)?;
        }
        let n = size.to_array().into_iter().map(u64::from).product();
        limits.check(Resource::Voxels, n)?;
        Ok(Self { corner, voxel, size, values: vec![0.0; n as usize] })
    }

    /// Lowest corner in metres.
    #[must_use]
    pub fn corner(&self) -> Vec3 {
        self.corner
    }

    /// Side of a voxel in metres.
    #[must_use]
    pub fn voxel(&self) -> f32 {
        self.voxel
    }

    /// Voxels along each axis.
    #[must_use]
    pub fn size(&self) -> UVec3 {
        self.size
    }

    /// All values, x fastest, then y, then z.
    #[must_use]
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// All values, to be changed.
    #[must_use]
    pub fn values_mut(&mut self) -> &mut [f32] {
        &mut self.values
    }

    /// The box the grid fills.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb::new(self.corner, self.corner + self.voxel * self.size.as_vec3())
    }

    /// Row of a voxel in [`values`](Self::values); `None` outside.
    #[must_use]
    #[inline]
    pub fn index(&self, voxel: IVec3) -> Option<usize> {
        let size = self.size.as_ivec3();
        let inside = voxel.cmpge(IVec3::ZERO).all() && voxel.cmplt(size).all();
        inside.then(|| ((voxel.z * size.y + voxel.y) * size.x + voxel.x) as usize)
    }

    /// The voxel of a row in [`values`](Self::values).
    #[must_use]
    #[inline]
    pub fn voxel_of(&self, index: usize) -> IVec3 {
        let (nx, ny) = (self.size.x as usize, self.size.y as usize);
        IVec3::new((index % nx) as i32, (index / nx % ny) as i32, (index / (nx * ny)) as i32)
    }

    /// Centre of a voxel in metres.
    #[must_use]
    #[inline]
    pub fn center(&self, voxel: IVec3) -> Vec3 {
        self.corner + self.voxel * (voxel.as_vec3() + 0.5)
    }

    /// The voxel that holds a point, which may lie outside the grid.
    #[must_use]
    #[inline]
    pub fn voxel_at(&self, point: Vec3) -> IVec3 {
        ((point - self.corner) / self.voxel).floor().as_ivec3()
    }

    /// The value of the voxel that holds `point`; 0 outside.
    #[must_use]
    #[inline]
    pub fn nearest(&self, point: Vec3) -> f32 {
        self.index(self.voxel_at(point)).map_or(0.0, |i| self.values[i])
    }

    /// The value at `point`, between voxel centres by trilinear interpolation; fades to 0 outside.
    #[must_use]
    pub fn sample(&self, point: Vec3) -> f32 {
        if !point.is_finite() {
            return 0.0;
        }
        let at = (point - self.corner) / self.voxel - 0.5;
        let low = at.floor();
        let share = at - low;
        let low = low.as_ivec3();
        let mut sum = 0.0;
        for corner in 0..8 {
            let step = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
            if let Some(i) = self.index(low.saturating_add(step)) {
                let w = Vec3::select(step.cmpeq(IVec3::ONE), share, 1.0 - share);
                sum += w.x * w.y * w.z * self.values[i];
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> Grid {
        let mut grid =
            Grid::new(Vec3::new(-1.0, 0.0, -1.0), 0.5, UVec3::new(4, 3, 2), &Limits::default())
                .unwrap();
        grid.values_mut().iter_mut().enumerate().for_each(|(i, v)| *v = i as f32);
        grid
    }

    #[test]
    fn rows_voxels_and_points_agree() {
        let grid = grid();
        for i in 0..grid.values().len() {
            let voxel = grid.voxel_of(i);
            assert_eq!(grid.index(voxel), Some(i));
            assert_eq!(grid.voxel_at(grid.center(voxel)), voxel);
            assert_eq!(grid.sample(grid.center(voxel)), i as f32);
        }
    }

    #[test]
    fn outside_there_is_nothing() {
        let grid = grid();
        for far in [1e9, -1e9, f32::NAN, f32::INFINITY] {
            assert_eq!(grid.sample(Vec3::splat(far)), 0.0);
            assert_eq!(grid.nearest(Vec3::new(far, 1e9, 0.0)), 0.0);
        }
    }

    #[test]
    fn too_many_voxels_are_refused_before_they_are_allocated() {
        let limits = Limits { voxels: 10, ..Limits::default() };
        let error = Grid::new(Vec3::ZERO, 1.0, UVec3::splat(4096), &limits).unwrap_err();
        assert!(matches!(error, crate::ModelError::Limit(_)), "{error}");
        assert!(Grid::new(Vec3::ZERO, 1.0, UVec3::ZERO, &Limits::default()).is_err());
    }
}
