//! Ready-made trees: the twelve of Xu & Mould's Table 2, their two root systems, and an oak.
//!
//! Presets are rows of a table. Shapes, branchings, angles and turns of `a` to `l` are those of
//! Table 2; sizes in metres, node counts, bark and leaves are ours, since the paper names none. Node
//! counts follow from the paper's times: at the 10,860 nodes a second of its Table 1, tree `a` with
//! 6.4 s had about 70,000 nodes in 157 graphs, and so on.

mod broadleaved;
mod conifers;
mod rooted;
mod row;

use crate::error::{ModelError, Result};
use crate::foliage::LeafParams;
use crate::path::params::{Endpoints, Level, LevelAxis, Lifespan, PathParams, Placing, SubShape};
use crate::path::{LinkParams, Paint};
use glam::Vec3;
use row::{LevelRow, Part, Row, Shape};
use std::f32::consts::PI;
use tree_core::allometry::{PipeModel, RadiusRule};
use tree_core::{Species, Volume};

/// A named set of parameters.
///
/// ```
/// use tree_model::path::Preset;
/// let willow = Preset::find("c")?.params()?;
/// assert_eq!(willow.species.name, "weeping willow");
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    row: &'static Row,
}

const ROWS: [&Row; 15] = [
    &broadleaved::OAK,
    &broadleaved::A,
    &broadleaved::B,
    &broadleaved::C,
    &broadleaved::D,
    &conifers::E,
    &broadleaved::F,
    &conifers::G,
    &broadleaved::H,
    &broadleaved::I,
    &conifers::J,
    &broadleaved::K,
    &conifers::L,
    &rooted::TAPROOT,
    &rooted::HEARTROOT,
];

/// All presets: `oak`, `a` to `l` as in the paper's Table 2 (Fig. 14), and the root systems of
/// Fig. 15, `taproot` and `heartroot`.
pub const PRESETS: [Preset; ROWS.len()] = {
    let mut presets = [Preset { row: ROWS[0] }; ROWS.len()];
    let mut i = 0;
    while i < ROWS.len() {
        presets[i].row = ROWS[i];
        i += 1;
    }
    presets
};

impl Preset {
    /// The preset of this name.
    ///
    /// # Errors
    /// [`ModelError::UnknownPreset`] that lists the names there are.
    pub fn find(name: &str) -> Result<Self> {
        PRESETS.into_iter().find(|preset| preset.name() == name).ok_or_else(|| {
            let known = PRESETS.map(|preset| preset.name()).join(", ");
            ModelError::UnknownPreset { name: name.into(), known }
        })
    }

    /// Its name: `oak`, `a` to `l`, `taproot`, `heartroot`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.row.name
    }

    /// What the tree looks like, in a few words.
    #[must_use]
    pub const fn title(&self) -> &'static str {
        self.row.title
    }

    /// Seconds the tree took the paper's authors (Table 2), where it is one of theirs.
    #[must_use]
    pub const fn paper_seconds(&self) -> Option<f32> {
        self.row.paper_seconds
    }

    /// Its parameters, to grow or to change.
    ///
    /// # Errors
    /// None for the presets there are; their rows are tested.
    pub fn params(&self) -> Result<PathParams> {
        self.row.params()
    }
}

impl PathParams {
    /// The oak of the quickstart: a good tree to begin with, and the default of every field.
    ///
    /// # Errors
    /// None; its row is tested.
    pub fn oak() -> Result<Self> {
        Preset::find("oak")?.params()
    }
}

impl Row {
    fn params(&self) -> Result<PathParams> {
        let volume = unite(self.base)?;
        let paint = match self.leader {
            Some(leader) => vec![Paint {
                volume: Volume::cylinder(Vec3::ZERO, leader.top.into(), leader.radius)?,
                factor: leader.factor,
            }],
            None => Vec::new(),
        };
        let leaves = self.leaves.map(|row| LeafParams {
            arrangement: row.arrangement,
            spacing: row.spacing,
            bearing: row.bearing,
            size: row.size,
            pitch: row.pitch,
            droop: row.droop,
            phototropism: row.phototropism,
            ..LeafParams::default()
        });
        let leaf_kinds = self.leaves.map(|row| row.kind.to_owned()).into_iter().collect();
        Ok(PathParams {
            volume,
            root: Vec3::ZERO,
            graph_nodes: self.graph_nodes,
            endpoints: Endpoints {
                random: self.branching,
                above: self.above,
                placing: if self.surface { Placing::Surface } else { Placing::Volume },
                placed: self.placed.iter().copied().map(Vec3::from).collect(),
                ..Endpoints::default()
            },
            size: self.size,
            shrink: self.shrink,
            levels: self.levels.iter().flat_map(LevelRow::levels).collect(),
            lifespan: self.lifespan_stop.map_or(Lifespan::Full, |stop| Lifespan::Random { stop }),
            linking: LinkParams { low: self.low, ..LinkParams::default() },
            paint,
            cost: None,
            obstacle: None,
            smoothing: self.smoothing,
            radii: RadiusRule::Pipe(PipeModel {
                exponent: self.pipe_exponent,
                trunk_radius: Some(self.trunk_radius),
                ..PipeModel::default()
            }),
            leaves,
            species: Species { name: self.species.into(), bark: self.bark.into(), leaf_kinds },
            roots: match self.roots {
                Some(roots) => Some(Box::new(roots.params()?)),
                None => None,
            },
        })
    }
}

impl LevelRow {
    /// One level for each of the row's range.
    fn levels(&self) -> impl Iterator<Item = Level> + '_ {
        let shape = match self.shape {
            Shape::Sector(share) => SubShape::Sector { angle: share * PI },
            Shape::Cone(width) => SubShape::Cone { width },
        };
        let level = Level {
            branching: self.branching,
            shape,
            graph_nodes: self.graph_nodes,
            axis: if self.down { LevelAxis::Down } else { LevelAxis::Outward },
            turn: self.turn * PI,
            size: self.size,
            from_all_levels: self.from_all,
            ..Level::default()
        };
        std::iter::repeat_n(level, self.repeat)
    }
}

fn unite(parts: &[Part]) -> Result<Volume> {
    let volumes = parts.iter().map(Part::volume).collect::<Result<Vec<_>>>()?;
    Ok(Volume::union_all(volumes)?)
}

impl Part {
    fn volume(&self) -> Result<Volume> {
        let at = Vec3::from_array;
        Ok(match *self {
            Self::Cylinder { base, top, radius } => Volume::cylinder(at(base), at(top), radius)?,
            Self::Cone { base, top, radius } => Volume::cone(at(base), at(top), radius)?,
            Self::Sector { apex, angle, radius, up } => {
                Volume::sector(at(apex), Vec3::Y * up, angle * PI, radius)?
            }
            Self::Ellipsoid { center, radii } => Volume::ellipsoid(at(center), at(radii))?,
        })
    }
}
