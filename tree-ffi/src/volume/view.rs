//! What a volume is made of.

use super::tree_volume;
use crate::border::{Failure, TREE_ERROR_PARAMETER, Versioned, call, get, out, tree_status, write};
use crate::mesh::column;
use tree_model::tree_core::Volume;
use tree_model::tree_core::volume::Solid;

/// What kind of solid a volume is: one of the `TREE_SOLID_` constants.
pub type tree_solid_kind = u32;
/// None of those below: newer than this header.
pub const TREE_SOLID_OTHER: u32 = 0;
/// A ball.
pub const TREE_SOLID_SPHERE: u32 = 1;
/// An axis-aligned ellipsoid.
pub const TREE_SOLID_ELLIPSOID: u32 = 2;
/// A round cylinder.
pub const TREE_SOLID_CYLINDER: u32 = 3;
/// A cone, whole or truncated.
pub const TREE_SOLID_FRUSTUM: u32 = 4;
/// All within a distance of a segment.
pub const TREE_SOLID_CAPSULE: u32 = 5;
/// An axis-aligned box.
pub const TREE_SOLID_BOX: u32 = 6;
/// All on one side of a plane.
pub const TREE_SOLID_HALF_SPACE: u32 = 7;
/// The points of a ball within an angle of an axis.
pub const TREE_SOLID_SECTOR: u32 = 8;
/// What a profile sweeps.
pub const TREE_SOLID_REVOLUTION: u32 = 9;
/// What a closed mesh bounds.
pub const TREE_SOLID_MESH: u32 = 10;
/// What lies in any part.
pub const TREE_SOLID_UNION: u32 = 11;
/// What lies in all parts.
pub const TREE_SOLID_INTERSECTION: u32 = 12;
/// What lies in part 0 but not in part 1.
pub const TREE_SOLID_DIFFERENCE: u32 = 13;
/// Part 0, transformed.
pub const TREE_SOLID_TRANSFORMED: u32 = 14;

/// A view of what a volume is made of. What its kind does not use is 0 or NULL.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_solid {
    /// `sizeof(tree_solid)`.
    pub struct_size: usize,
    /// Columns of points: a profile's distance and height, two floats each; a mesh's positions, three
    /// floats each.
    pub points: *const f32,
    /// Number of points.
    pub n_points: usize,
    /// Three for each triangle of a mesh.
    pub indices: *const u32,
    /// Number of triangles.
    pub n_triangles: usize,
    /// Number of parts of a combination: 2 for a difference, 1 for a transformed volume. See
    /// `tree_volume_part`.
    pub n_parts: usize,
    /// Which solid it is.
    pub kind: tree_solid_kind,
    /// Centre, base, start, lower corner, point on the plane or apex.
    pub a: [f32; 3],
    /// Top, end, upper corner, radii of an ellipsoid, normal, or the axis of a sector or revolution.
    pub b: [f32; 3],
    /// Radius; that at the base of a frustum.
    pub radius: f32,
    /// Radius at the top of a frustum.
    pub top_radius: f32,
    /// Angle of a sector, in radians.
    pub angle: f32,
    /// Map of a transformed volume, column by column as for `tree_volume_transformed`.
    pub columns: [f32; 12],
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_solid {
    const NAME: &'static str = "tree_solid";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            points: std::ptr::null(),
            n_points: 0,
            indices: std::ptr::null(),
            n_triangles: 0,
            n_parts: 0,
            kind: TREE_SOLID_OTHER,
            a: [0.0; 3],
            b: [0.0; 3],
            radius: 0.0,
            top_radius: 0.0,
            angle: 0.0,
            columns: [0.0; 12],
        }
    }
}

impl tree_solid {
    fn of(solid: &Solid) -> Self {
        let view = Self { n_parts: parts(solid).len(), ..Self::default_value() };
        match solid {
            Solid::Sphere { center, radius } => {
                Self { kind: TREE_SOLID_SPHERE, a: (*center).into(), radius: *radius, ..view }
            }
            Solid::Ellipsoid { center, radii } => {
                view.between(TREE_SOLID_ELLIPSOID, *center, *radii, 0.0)
            }
            Solid::Cylinder { base, top, radius } => {
                view.between(TREE_SOLID_CYLINDER, *base, *top, *radius)
            }
            Solid::Frustum { base, top, base_radius, top_radius } => Self {
                top_radius: *top_radius,
                ..view.between(TREE_SOLID_FRUSTUM, *base, *top, *base_radius)
            },
            Solid::Capsule { start, end, radius } => {
                view.between(TREE_SOLID_CAPSULE, *start, *end, *radius)
            }
            Solid::Box { min, max } => view.between(TREE_SOLID_BOX, *min, *max, 0.0),
            Solid::HalfSpace { point, normal } => {
                view.between(TREE_SOLID_HALF_SPACE, *point, *normal, 0.0)
            }
            Solid::Sector { apex, axis, angle, radius } => {
                Self { angle: *angle, ..view.between(TREE_SOLID_SECTOR, *apex, *axis, *radius) }
            }
            Solid::Revolution { base, axis, profile } => Self {
                points: column(profile).cast(),
                n_points: profile.len(),
                ..view.between(TREE_SOLID_REVOLUTION, *base, *axis, 0.0)
            },
            Solid::Mesh { positions, triangles } => Self {
                kind: TREE_SOLID_MESH,
                points: column(positions).cast(),
                n_points: positions.len(),
                indices: column(triangles).cast(),
                n_triangles: triangles.len(),
                ..view
            },
            Solid::Union(_) => Self { kind: TREE_SOLID_UNION, ..view },
            Solid::Intersection(_) => Self { kind: TREE_SOLID_INTERSECTION, ..view },
            Solid::Difference { .. } => Self { kind: TREE_SOLID_DIFFERENCE, ..view },
            Solid::Transformed { world_from_local, .. } => Self {
                kind: TREE_SOLID_TRANSFORMED,
                columns: world_from_local.to_cols_array(),
                ..view
            },
            _ => view,
        }
    }

    fn between(self, kind: tree_solid_kind, a: glam::Vec3, b: glam::Vec3, radius: f32) -> Self {
        Self { kind, a: a.into(), b: b.into(), radius, ..self }
    }
}

/// The volumes that a solid combines, in order.
fn parts(solid: &Solid) -> Vec<&Volume> {
    match solid {
        Solid::Union(parts) | Solid::Intersection(parts) => parts.iter().collect(),
        Solid::Difference { from, without } => vec![from, without],
        Solid::Transformed { volume, .. } => vec![volume],
        _ => Vec::new(),
    }
}

/// Views what a volume is made of. Set `solid->struct_size` first; what it points at is valid until the
/// volume is freed. A cone is a frustum; combinations are as the library keeps them, a union of unions as
/// one union.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_view(
    volume: *const tree_volume,
    solid: *mut tree_solid,
) -> tree_status {
    call(|| {
        let volume = unsafe { get(volume, "volume") }?.rust();
        unsafe { write(solid, "solid", &tree_solid::of(volume.solid())) }
    })
}

/// A part of a combination, `index` below `tree_solid.n_parts`. Free it with `tree_volume_free`; it may
/// outlive the combination.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_part(
    volume: *const tree_volume,
    index: usize,
    part: *mut *mut tree_volume,
) -> tree_status {
    call(|| {
        let place = unsafe { out(part, "part") }?;
        let parts = parts(unsafe { get(volume, "volume") }?.rust().solid());
        let Some(&found) = parts.get(index) else {
            let text = format!("index is {index}, but there are {} parts", parts.len());
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        place.put(tree_volume::new(found.clone()));
        Ok(())
    })
}
