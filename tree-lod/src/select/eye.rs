//! Where a scene is looked at from: a view and a projection matrix, as engines have them at hand.

use crate::error::{LodError, Result};
use glam::{DMat3, DMat4, DVec3, DVec4, Mat4, Vec3, Vec4};

/// Farthest an eye may be from the origin, in metres.
const FARTHEST: f64 = 1e8;
/// How far the view's turn may be from a pure one: its determinant from 1.
const RIGID: f64 = 1e-2;
/// tan 30°: [`near`](super::Model::near) and [`far`](super::Model::far) are meant for 60° from top to bottom.
const REFERENCE: f64 = 0.577_350_269_189_625_8;
/// A distance no plane excludes.
const ENDLESS: f32 = 1e30;

/// A camera: two matrices, right-handed, the eye looks along −Z of the view, depth from 0 to 1.
///
/// The projection may be perspective or orthographic, its far end finite or infinite, its depth reversed
/// or not, off centre (jitter, stereo) and upside down (Vulkan): all this is read from the matrix.
///
/// ```
/// use tree_lod::glam::Vec3;
/// use tree_lod::glam::camera::rh::{proj::directx::perspective_infinite_reverse, view::look_at_mat4};
/// use tree_lod::select::Eye;
/// let eye = Eye {
///     view: look_at_mat4(Vec3::new(0.0, 2.0, 9.0), Vec3::Y * 4.0, Vec3::Y),
///     projection: perspective_infinite_reverse(1.0, 16.0 / 9.0, 0.1),
/// };
/// eye.validate()?;
/// # Ok::<(), tree_lod::LodError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// From the world to the eye's space; turns and moves only.
    pub view: Mat4,
    /// From the eye's space to clip space.
    pub projection: Mat4,
}

impl Eye {
    /// Checks both matrices.
    ///
    /// # Errors
    /// [`LodError::Camera`], naming the matrix.
    pub fn validate(&self) -> Result<()> {
        self.lens().map(|_| ())
    }

    /// Whether near things have the greater depth.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    pub fn is_reversed(&self) -> Result<bool> {
        self.lens().map(|lens| lens.reversed)
    }

    /// The matrices, taken apart.
    pub(super) fn lens(&self) -> Result<Lens> {
        let (turn, position) = turn_and_position(&self.view.as_dmat4())?;
        let rows = self.projection.as_dmat4().transpose();
        let rows = [rows.x_axis, rows.y_axis, rows.z_axis, rows.w_axis];
        let perspective = is_perspective(&rows)?;
        let depth = depth_range(rows[2], rows[3], perspective)?;
        // Lengths of the picture's half height: at 1 m in perspective, everywhere otherwise.
        let half =
            rows[1].truncate().truncate().length() / if perspective { -rows[3].z } else { 1.0 };
        let to_world = turn.transpose();
        let relative = |row: DVec4| (to_world * row.truncate()).extend(row.w);
        let rows = rows.map(relative);
        let forward = to_world * DVec3::NEG_Z;
        let mut planes = [DVec4::ZERO; 6];
        for (plane, side) in planes.iter_mut().zip([rows[0], -rows[0], rows[1], -rows[1]]) {
            let sum = rows[3] + side;
            let length = sum.truncate().length();
            let proper = (1e-12..1e12).contains(&length) && (1e-9..1e12).contains(&half);
            if !proper {
                return camera("projection", "must map to a picture with an area");
            }
            *plane = sum / length;
        }
        planes[4] = forward.extend(-depth.near);
        planes[5] = (-forward).extend(depth.far);
        Ok(Lens {
            position: position.as_vec3(),
            forward: forward.as_vec3(),
            rows: rows.map(|row| row.as_vec4()),
            planes: planes.map(|plane| plane.as_vec4()),
            perspective,
            reversed: depth.reversed,
            per_metre: (1.0 / (half * REFERENCE)) as f32,
        })
    }
}

/// A camera as it is used: all relative to the eye's position, so that large coordinates cost no precision.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lens {
    /// Where the eye is.
    pub(super) position: Vec3,
    /// Where it looks.
    pub(super) forward: Vec3,
    /// Clip x, y, z and w of a position relative to the eye: dot product with (x, y, z, 1).
    pub(super) rows: [Vec4; 4],
    /// Inside is where (x, y, z, 1) · plane ≥ 0, in metres: left, right, bottom, top, near, far.
    pub(super) planes: [Vec4; 6],
    /// Whether far things are smaller.
    pub(super) perspective: bool,
    /// Whether near things have the greater depth.
    pub(super) reversed: bool,
    /// Distance in a field of view of 60° at which things look as small as here at 1 m in perspective,
    /// and as here everywhere otherwise.
    per_metre: f32,
}

impl Lens {
    /// Distance in metres at which something would look as small in a field of view of 60°.
    #[inline]
    pub(super) fn distance(&self, distance: f32) -> f32 {
        if self.perspective { distance * self.per_metre } else { self.per_metre }
    }

    /// Unit vector from something to the eye; `relative` is its position less the eye's, its length `distance`.
    #[inline]
    pub(super) fn towards(&self, relative: Vec3, distance: f32) -> Vec3 {
        if self.perspective { relative * (-1.0 / distance.max(1e-6)) } else { -self.forward }
    }
}

fn camera<T>(field: &'static str, problem: &'static str) -> Result<T> {
    Err(LodError::Camera { field, problem })
}

/// Turn of the view, and where the eye is.
fn turn_and_position(view: &DMat4) -> Result<(DMat3, DVec3)> {
    if !view.is_finite() {
        return camera("view", "must be finite");
    }
    if view.row(3) != DVec4::W {
        return camera("view", "its last row must be 0, 0, 0, 1");
    }
    let turn = DMat3::from_mat4(*view);
    let error = (turn * turn.transpose() - DMat3::IDENTITY).to_cols_array();
    if error.into_iter().any(|e| e.abs() > RIGID) {
        return camera("view", "must turn and move only");
    }
    let position = -(turn.transpose() * view.w_axis.truncate());
    let near = |x: f64| x.abs() <= FARTHEST;
    if !position.to_array().into_iter().all(near) {
        return camera("view", "the eye must be within 10⁸ m of the origin");
    }
    Ok((turn, position))
}

fn is_perspective(rows: &[DVec4; 4]) -> Result<bool> {
    if rows.iter().any(|row| !row.is_finite()) {
        return camera("projection", "must be finite");
    }
    let w = rows[3];
    if w == DVec4::W {
        return Ok(false);
    }
    if w.x == 0.0 && w.y == 0.0 && w.w == 0.0 && w.z < 0.0 {
        return Ok(true);
    }
    camera(
        "projection",
        "its last row must be 0, 0, −1, 0 (perspective) or 0, 0, 0, 1 (orthographic)",
    )
}

/// What lies between the near and the far plane, in metres ahead of the eye.
struct DepthRange {
    near: f64,
    far: f64,
    reversed: bool,
}

/// Where depth is 0 and 1. At t metres ahead it is (B − A t) / (k t) in perspective, and B − A t otherwise.
fn depth_range(z: DVec4, w: DVec4, perspective: bool) -> Result<DepthRange> {
    let (a, b, k) = (z.z, z.w, -w.z);
    let reversed = if perspective { b > 0.0 } else { a > 0.0 };
    if (perspective && b == 0.0) || (!perspective && a == 0.0) {
        return camera("projection", "must have a depth: near and far may not be the same");
    }
    // An oblique near plane (mirrors): what it cuts off is not culled.
    if z.x != 0.0 || z.y != 0.0 {
        let near = if perspective { 0.0 } else { -f64::from(ENDLESS) };
        return Ok(DepthRange { near, far: ENDLESS.into(), reversed });
    }
    let (zero, one) = if perspective { (b / a, b / (a + k)) } else { (b / a, (b - 1.0) / a) };
    let (near, far) = if reversed { (one, zero) } else { (zero, one) };
    if !near.is_finite() || (perspective && near <= 0.0) {
        return camera("projection", "its near plane must lie ahead of the eye; depth from 0 to 1");
    }
    // An infinite end comes out as infinite, or behind the eye by rounding.
    let far = if far > near { far.min(ENDLESS.into()) } else { ENDLESS.into() };
    Ok(DepthRange { near, far, reversed })
}
