//! Strokes of a drawing of outlines.

use crate::border::{Failure, Result, TREE_ERROR_INVALID, Versioned, tree_str, vec2s};
use crate::mesh::column;
use glam::Vec2;
use tree_model::silhouette::read::{Kind, Level, LevelStroke};
use tree_model::tree_core::{Limits, Resource};

/// What a stroke belongs to: a branching order, 0 for the trunk and the crown, 1 for its branches, and so on; or
/// `TREE_LEVEL_OF_LEAF`.
pub type tree_drawn_level = u32;

/// A leaf.
pub const TREE_LEVEL_OF_LEAF: u32 = 0xFFFF_FFFF;

/// What a stroke shows: a `TREE_DRAWN_KIND_` constant.
pub type tree_drawn_kind = u32;

/// An open line: a trunk or a branch, from either end.
pub const TREE_DRAWN_KIND_AXIS: u32 = 0;
/// The outline of a crown, of a branch's foliage or of a leaf. Its first point is not repeated.
pub const TREE_DRAWN_KIND_OUTLINE: u32 = 1;

/// A stroke of a drawing of outlines: as input, or as a view of a `tree_outline_drawing`. Zeros are its defaults: an axis of
/// level 0 in the plane of the drawing. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_drawn_stroke {
    /// `sizeof(tree_drawn_stroke)`.
    pub struct_size: usize,
    /// Number of points.
    pub n_points: usize,
    /// Two floats for each point, in units of the drawing, y downwards. All are finite.
    pub points: *const f32,
    /// Its name in the drawing; empty where it has none.
    pub name: tree_str,
    /// What it belongs to. Default 0.
    pub level: tree_drawn_level,
    /// What it shows. Default `TREE_DRAWN_KIND_AXIS`.
    pub kind: tree_drawn_kind,
    /// By how much the plane it is drawn in is turned about the trunk, in radians. Default 0, the plane of the drawing.
    pub azimuth: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_drawn_stroke {
    const NAME: &'static str = "tree_drawn_stroke";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_points: 0,
            points: std::ptr::null(),
            name: tree_str::EMPTY,
            level: 0,
            kind: TREE_DRAWN_KIND_AXIS,
            azimuth: 0.0,
            reserved: 0,
        }
    }
}

impl tree_drawn_stroke {
    /// A view of `stroke`.
    pub(super) fn of(stroke: &LevelStroke) -> Self {
        Self {
            n_points: stroke.points.len(),
            points: column(&stroke.points).cast(),
            name: tree_str::of(&stroke.name),
            level: match stroke.level {
                Level::Number(level) => level.min(TREE_LEVEL_OF_LEAF - 1),
                Level::Leaf => TREE_LEVEL_OF_LEAF,
            },
            kind: match stroke.kind {
                Kind::Axis => TREE_DRAWN_KIND_AXIS,
                Kind::Outline => TREE_DRAWN_KIND_OUTLINE,
            },
            azimuth: stroke.azimuth,
            ..Self::default_value()
        }
    }
}

/// The stroke, copied; `argument` is what it is called by.
///
/// # Safety
/// What it points at is as long as it says.
pub(super) unsafe fn from_drawn(
    row: &tree_drawn_stroke,
    limits: &Limits,
    argument: &str,
) -> Result<LevelStroke> {
    let part = |field: &str| format!("{argument}.{field}");
    let (n, nodes) = (row.n_points, Resource::Nodes);
    let found: &[Vec2] = unsafe { vec2s(row.points, n, limits, nodes, &part("points")) }?;
    let bad = found.iter().position(|point| !point.is_finite()).map(|at| format!("points[{at}]"));
    let bad = bad.or_else(|| (!row.azimuth.is_finite()).then(|| "azimuth".to_owned()));
    if let Some(bad) = bad {
        return Err(Failure::new(TREE_ERROR_INVALID, format!("{} is not finite", part(&bad))));
    }
    let mut points = found.to_vec();
    points.dedup();
    Ok(LevelStroke {
        level: match row.level {
            TREE_LEVEL_OF_LEAF => Level::Leaf,
            level => Level::Number(level),
        },
        kind: match row.kind {
            TREE_DRAWN_KIND_AXIS => Kind::Axis,
            TREE_DRAWN_KIND_OUTLINE => Kind::Outline,
            other => return Err(Failure::not_one_of(&part("kind"), other, "TREE_DRAWN_KIND_")),
        },
        azimuth: row.azimuth,
        points,
        name: unsafe { row.name.get(&part("name")) }?.to_owned(),
    })
}
