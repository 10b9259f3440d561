//! Levels 2 and on.

use crate::border::{Failure, Result, Versioned, call, get, init, register_for_ever, tree_status};
use crate::volume::tree_volume;
use glam::Vec3;
use tree_model::path::{Level, LevelAxis, Placing, SubShape};
use tree_model::tree_core::Volume;

/// Where random endpoints may lie: one of the `TREE_PATH_PLACING_` constants.
pub type tree_path_placing = u32;
/// Anywhere in the volume.
pub const TREE_PATH_PLACING_VOLUME: u32 = 0;
/// Within one separation of the volume's surface.
pub const TREE_PATH_PLACING_SURFACE: u32 = 1;

/// Shape of a subgraph, pointing along its axis from its root: one of the `TREE_PATH_SHAPE_` constants.
pub type tree_path_shape = u32;
/// The part of a ball round the root that lies within an angle of the axis.
pub const TREE_PATH_SHAPE_SECTOR: u32 = 0;
/// A cone that stands on the root and narrows outwards.
pub const TREE_PATH_SHAPE_CONE: u32 = 1;
/// A cone with its tip on the root that widens outwards.
pub const TREE_PATH_SHAPE_INVERTED_CONE: u32 = 2;
/// Any volume.
pub const TREE_PATH_SHAPE_CUSTOM: u32 = 3;

/// Which way the subgraphs of a level point, before the turn: one of the `TREE_PATH_AXIS_` constants.
pub type tree_path_axis = u32;
/// From the root of the graph before through the endpoint.
pub const TREE_PATH_AXIS_OUTWARD: u32 = 0;
/// Straight down.
pub const TREE_PATH_AXIS_DOWN: u32 = 1;
/// One direction for all.
pub const TREE_PATH_AXIS_FIXED: u32 = 2;
/// A random direction for each.
pub const TREE_PATH_AXIS_RANDOM: u32 = 3;

/// Subgraphs grown round the endpoints of the level before. Begin with `tree_path_level_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_path_level {
    /// `sizeof(tree_path_level)`.
    pub struct_size: usize,
    /// Custom: any volume, drawn for a root at the origin, axis +Y and radius 1. Default NULL.
    pub custom: *const tree_volume,
    /// Endpoints in each subgraph, 1 to 10,000. Default 4.
    pub branching: u32,
    /// Shape of the subgraphs. Default `TREE_PATH_SHAPE_SECTOR`.
    pub shape: tree_path_shape,
    /// Sector: angle from the axis in radians, 0.05 to pi (the whole ball). Default 0.3 pi.
    pub angle: f32,
    /// Cones: base radius as a share of the height, 0.05 to 5. No default: 0, which is refused.
    pub width: f32,
    /// Nodes of each subgraph, 8 to `tree_limits.graph_nodes`. Default 110.
    pub graph_nodes: u32,
    /// Which way subgraphs point. Default `TREE_PATH_AXIS_OUTWARD`.
    pub axis: tree_path_axis,
    /// Fixed axis: its direction, of any length but 0. Default 0, 0, 0, which is refused.
    pub direction: [f32; 3],
    /// Turn of the axis about the horizontal in radians, -pi to pi: positive bends branches down,
    /// negative up. Default 0.
    pub turn: f32,
    /// Radius of the subgraphs in metres. Default 0: the one that follows from `size` and `shrink` of the
    /// `tree_path_params`.
    pub size: f32,
    /// Where endpoints may lie. Default `TREE_PATH_PLACING_VOLUME`.
    pub placing: tree_path_placing,
    /// Whether subgraphs grow round the endpoints of all levels before, not only the last. Default 0.
    pub from_all_levels: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_path_level {
    const NAME: &'static str = "tree_path_level";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Level::default())
    }
}

impl tree_path_level {
    /// The level in C's form. A custom volume becomes one of the library's own, for ever: presets only.
    pub(super) fn of(level: &Level) -> Self {
        let sector = match Level::default().shape {
            SubShape::Sector { angle } => angle,
            _ => 0.0,
        };
        let (shape, angle, width, custom) = match &level.shape {
            SubShape::Sector { angle } => (TREE_PATH_SHAPE_SECTOR, *angle, 0.0, None),
            SubShape::Cone { width } => (TREE_PATH_SHAPE_CONE, sector, *width, None),
            SubShape::InvertedCone { width } => {
                (TREE_PATH_SHAPE_INVERTED_CONE, sector, *width, None)
            }
            SubShape::Custom(volume) => (TREE_PATH_SHAPE_CUSTOM, sector, 0.0, Some(volume)),
        };
        let (axis, direction) = match level.axis {
            LevelAxis::Outward => (TREE_PATH_AXIS_OUTWARD, Vec3::ZERO),
            LevelAxis::Down => (TREE_PATH_AXIS_DOWN, Vec3::ZERO),
            LevelAxis::Fixed(direction) => (TREE_PATH_AXIS_FIXED, direction),
            LevelAxis::Random => (TREE_PATH_AXIS_RANDOM, Vec3::ZERO),
        };
        let keep = |volume: &Volume| register_for_ever(tree_volume::new(volume.clone()));
        Self {
            struct_size: size_of::<Self>(),
            custom: custom.map_or(std::ptr::null(), keep),
            branching: level.branching,
            shape,
            angle,
            width,
            graph_nodes: level.graph_nodes,
            axis,
            direction: direction.to_array(),
            turn: level.turn,
            size: level.size.unwrap_or(0.0),
            placing: placing_of(level.placing),
            from_all_levels: level.from_all_levels.into(),
            reserved: 0,
        }
    }

    /// The level in Rust's form, not yet checked against its ranges; `name` is what it is called by.
    pub(super) unsafe fn rust(&self, name: &str) -> Result<Level> {
        let shape = match self.shape {
            TREE_PATH_SHAPE_SECTOR => SubShape::Sector { angle: self.angle },
            TREE_PATH_SHAPE_CONE => SubShape::Cone { width: self.width },
            TREE_PATH_SHAPE_INVERTED_CONE => SubShape::InvertedCone { width: self.width },
            TREE_PATH_SHAPE_CUSTOM => {
                let volume = unsafe { get(self.custom, &format!("{name}.custom")) }?;
                SubShape::Custom(volume.rust().clone())
            }
            other => {
                return Err(Failure::not_one_of(
                    &format!("{name}.shape"),
                    other,
                    "TREE_PATH_SHAPE_",
                ));
            }
        };
        let axis = match self.axis {
            TREE_PATH_AXIS_OUTWARD => LevelAxis::Outward,
            TREE_PATH_AXIS_DOWN => LevelAxis::Down,
            TREE_PATH_AXIS_FIXED => LevelAxis::Fixed(self.direction.into()),
            TREE_PATH_AXIS_RANDOM => LevelAxis::Random,
            other => {
                return Err(Failure::not_one_of(&format!("{name}.axis"), other, "TREE_PATH_AXIS_"));
            }
        };
        Ok(Level {
            branching: self.branching,
            shape,
            graph_nodes: self.graph_nodes,
            axis,
            turn: self.turn,
            size: (self.size != 0.0).then_some(self.size),
            placing: placing(self.placing, &format!("{name}.placing"))?,
            from_all_levels: self.from_all_levels != 0,
        })
    }
}

pub(super) fn placing_of(placing: Placing) -> tree_path_placing {
    match placing {
        Placing::Volume => TREE_PATH_PLACING_VOLUME,
        Placing::Surface => TREE_PATH_PLACING_SURFACE,
    }
}

pub(super) fn placing(found: tree_path_placing, name: &str) -> Result<Placing> {
    match found {
        TREE_PATH_PLACING_VOLUME => Ok(Placing::Volume),
        TREE_PATH_PLACING_SURFACE => Ok(Placing::Surface),
        other => Err(Failure::not_one_of(name, other, "TREE_PATH_PLACING_")),
    }
}

/// Makes `level`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_path_level_init(
    level: *mut tree_path_level,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(level, size) })
}
