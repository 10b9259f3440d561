//! Many instances of few models, kept so that those in view are found fast.
//!
//! Instances are put in the order of a Morton curve over the ground and cut into tiles of 64. A tile that
//! is out of view is skipped as a whole. Spheres of a tile are columns, so that the compiler can test
//! several at once; what only visible instances need lies in a row each.

use super::model::{Draw, Model, Occluder};
use crate::error::{LodError, Result};
use crate::quality::{Distance, contrast};
use glam::{Mat3, Quat, Vec3};
use tree_core::{Control, Resource};

/// Instances of a tile.
pub(super) const TILE: usize = 64;
/// Points of a model that are tested at once.
pub(super) const LANES: usize = 4;
/// Largest coordinate of an instance, in metres.
const FARTHEST: f32 = 1e7;
/// Smallest and largest scale of an instance.
const SCALES: (f32, f32) = (1e-3, 1e3);
/// How far a rotation's length may be from 1.
const UNIT: f32 = 1e-2;

/// A tree of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instance {
    /// Which model it is.
    pub model: u32,
    /// Where the model's origin stands, in metres, within 10⁷ of the origin.
    pub position: Vec3,
    /// How it is turned, a unit quaternion.
    pub rotation: Quat,
    /// Factor on its size, 0.001 to 1000.
    pub scale: f32,
}

impl Default for Instance {
    fn default() -> Self {
        Self { model: 0, position: Vec3::ZERO, rotation: Quat::IDENTITY, scale: 1.0 }
    }
}

/// Models, and where they stand.
///
/// [`select`](Self::select) finds what is drawn and how finely; [`draws`](Self::draws) or
/// [`batches`](Self::batches) then write it for the graphics processor. Neither allocates.
#[derive(Clone, Debug)]
pub struct Scene {
    pub(super) models: Vec<Kept>,
    pub(super) tiles: Vec<Tile>,
    pub(super) rows: Vec<Row>,
    /// Number of each row's instance, and row of each instance.
    pub(super) ids: Vec<u32>,
    row_of: Vec<u32>,
}

/// A model as it is used in each frame.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    center: Vec3,
    radius: f32,
    crown: Vec3,
    crown_radius: f32,
    /// Points relative to the crown's centre, by fours; those missing from the last four are repeated.
    pub(super) points: Vec<[[f32; LANES]; 3]>,
    pub(super) occluders: Vec<Occluder>,
    /// Largest radius of an occluder.
    pub(super) widest: f32,
    pub(super) distance: Distance,
    pub(super) near: f32,
    /// 1 / (far − near).
    pub(super) per_range: f32,
    pub(super) levels: Vec<Step>,
    /// Draws of all levels, one after another.
    pub(super) draws: Vec<Draw>,
    pub(super) parts: usize,
    /// First bucket of the model when instances are batched.
    pub(super) bucket: usize,
}

/// A level as it is used in each frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) lambda: f32,
    /// Factor on area.
    pub(super) scale: f32,
    pub(super) contrast: f32,
    pub(super) fade: f32,
    /// Indices of all its draws.
    pub(super) indices: u64,
    /// Its draws with indices.
    pub(super) n_draws: usize,
}

/// 64 instances.
#[derive(Clone, Debug)]
pub(super) struct Tile {
    /// Box around the spheres' centres.
    pub(super) low: Vec3,
    pub(super) high: Vec3,
    /// Largest radius.
    pub(super) largest: f32,
    pub(super) x: [f32; TILE],
    pub(super) y: [f32; TILE],
    pub(super) z: [f32; TILE],
    /// Radius; of rows that are none so low that they are never in view.
    pub(super) radius: [f32; TILE],
}

/// What is needed of an instance in view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// Turn and scale.
    pub(super) linear: Mat3,
    pub(super) position: Vec3,
    /// Centre and radius of the sample points.
    pub(super) crown: Vec3,
    pub(super) crown_radius: f32,
    pub(super) per_scale: f32,
    pub(super) model: u32,
}

/// Radius of rows that are none.
const NONE: f32 = -1e30;

impl Scene {
    /// A scene of these models and instances, which are numbered as they come.
    ///
    /// # Errors
    /// [`LodError::Scene`] for the first model or instance that is not right. The limit on nodes counts
    /// instances.
    ///
    /// # Complexity
    /// O(n log n).
    pub fn new(models: &[Model], instances: &[Instance], control: &Control) -> Result<Self> {
        control.limits.check(Resource::Nodes, instances.len() as u64)?;
        for (row, model) in models.iter().enumerate() {
            model.validate_as(row)?;
        }
        let mut bucket = 0;
        let mut kept = Vec::with_capacity(models.len());
        for model in models {
            kept.push(Kept::new(model, bucket));
            bucket += model.levels.len();
        }
        for (row, instance) in instances.iter().enumerate() {
            check(instance, row, kept.len())?;
        }
        control.report("scene", 0.5)?;
        let ids = along_curve(instances);
        let mut row_of = vec![0; instances.len()];
        for (row, &id) in ids.iter().enumerate() {
            row_of[id as usize] = row as u32;
        }
        let mut scene = Self {
            models: kept,
            tiles: vec![Tile::EMPTY; instances.len().div_ceil(TILE)],
            rows: vec![Row::EMPTY; instances.len()],
            ids,
            row_of,
        };
        for (id, instance) in instances.iter().enumerate() {
            scene.place(id, instance);
        }
        control.report("scene", 1.0)?;
        Ok(scene)
    }

    /// Moves an instance, or gives it another model: between frames, for what was selected before holds the old
    /// one. It keeps its place in the order of drawing; when most
    /// instances move far, a new scene is faster to look through.
    ///
    /// # Errors
    /// [`LodError::Scene`] when there is no such instance or it is not right; nothing is changed then.
    ///
    /// # Complexity
    /// O(1).
    pub fn set_instance(&mut self, index: usize, instance: &Instance) -> Result<()> {
        self.set_instances(index, std::slice::from_ref(instance))
    }

    /// The same for many, from `first` on: all, or on an error none.
    ///
    /// # Errors
    /// As [`set_instance`](Self::set_instance).
    pub fn set_instances(&mut self, first: usize, instances: &[Instance]) -> Result<()> {
        let end = first.checked_add(instances.len()).filter(|&end| end <= self.len());
        if end.is_none() {
            let problem = "there are not so many in the scene";
            return Err(LodError::Scene { what: "instance", row: first, problem });
        }
        for (i, instance) in instances.iter().enumerate() {
            check(instance, first + i, self.models.len())?;
        }
        for (i, instance) in instances.iter().enumerate() {
            self.place(first + i, instance);
        }
        Ok(())
    }

    /// Number of instances.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Draws that [`draws`](Self::draws) and [`batches`](Self::batches) write at most: the parts of all instances.
    /// Rows of instances are at most [`len`](Self::len).
    #[must_use]
    pub fn most_draws(&self) -> usize {
        self.rows.iter().map(|row| self.models[row.model as usize].parts).sum()
    }

    /// Index counts of all instances at their finest level: what is drawn without selection.
    #[must_use]
    pub fn most_indices(&self) -> u64 {
        let finest =
            |row: &Row| self.models[row.model as usize].levels.last().map_or(0, |l| l.indices);
        self.rows.iter().map(finest).sum()
    }

    /// Row of an instance.
    pub(super) fn row_of(&self, instance: usize) -> Option<usize> {
        self.row_of.get(instance).map(|&row| row as usize)
    }

    /// Levels of all models together.
    pub(super) fn n_buckets(&self) -> usize {
        self.models.iter().map(|model| model.levels.len()).sum()
    }

    /// Writes columns and row of a checked instance; its tile grows around it.
    fn place(&mut self, id: usize, instance: &Instance) {
        let row = self.row_of[id] as usize;
        let model = &self.models[instance.model as usize];
        let linear = Mat3::from_quat(instance.rotation.normalize()) * instance.scale;
        let center = instance.position + linear * model.center;
        let radius = model.radius * instance.scale;
        let (tile, i) = (&mut self.tiles[row / TILE], row % TILE);
        (tile.x[i], tile.y[i], tile.z[i]) = center.into();
        tile.radius[i] = radius;
        tile.low = tile.low.min(center);
        tile.high = tile.high.max(center);
        tile.largest = tile.largest.max(radius);
        self.rows[row] = Row {
            linear,
            position: instance.position,
            crown: instance.position + linear * model.crown,
            crown_radius: model.crown_radius * instance.scale,
            per_scale: 1.0 / instance.scale,
            model: instance.model,
        };
    }
}

impl Tile {
    const EMPTY: Self = Self {
        low: Vec3::INFINITY,
        high: Vec3::NEG_INFINITY,
        largest: 0.0,
        x: [0.0; TILE],
        y: [0.0; TILE],
        z: [0.0; TILE],
        radius: [NONE; TILE],
    };
}

impl Row {
    const EMPTY: Self = Self {
        linear: Mat3::IDENTITY,
        position: Vec3::ZERO,
        crown: Vec3::ZERO,
        crown_radius: 0.0,
        per_scale: 1.0,
        model: 0,
    };
}

impl Kept {
    fn new(model: &Model, bucket: usize) -> Self {
        let n = model.samples.len();
        let mean = model.samples.iter().sum::<Vec3>() / n.max(1) as f32;
        let crown = if n > 0 { mean } else { model.center };
        let crown_radius = model.samples.iter().map(|p| p.distance(crown)).fold(0.0, f32::max);
        let groups = n.div_ceil(LANES);
        // Strides through the points, so that each group is spread over the crown.
        let point = |group: usize, lane: usize| model.samples[(group + lane * groups) % n] - crown;
        let group = |g| {
            let points: [Vec3; LANES] = std::array::from_fn(|lane| point(g, lane));
            [points.map(|p| p.x), points.map(|p| p.y), points.map(|p| p.z)]
        };
        let step = |level: &super::Level| Step {
            lambda: level.lambda,
            scale: level.scale,
            contrast: contrast(level.lambda, level.scale),
            fade: level.fade,
            indices: level.draws.iter().map(|draw| u64::from(draw.index_count)).sum(),
            n_draws: level.draws.iter().filter(|draw| draw.index_count > 0).count(),
        };
        Self {
            center: model.center,
            radius: model.radius,
            crown,
            crown_radius,
            points: (0..groups).map(group).collect(),
            occluders: model.occluders.clone(),
            widest: model.occluders.iter().map(|o| o.radii.max_element()).fold(0.0, f32::max),
            distance: model.distance,
            near: model.near,
            per_range: 1.0 / (model.far - model.near),
            levels: model.levels.iter().map(step).collect(),
            draws: model.levels.iter().flat_map(|level| level.draws.iter().copied()).collect(),
            parts: model.parts(),
            bucket,
        }
    }

    /// Draws of a level.
    pub(super) fn draws_of(&self, level: usize) -> &[Draw] {
        self.draws.chunks_exact(self.parts).nth(level).unwrap_or(&[])
    }

    /// The coarsest level that holds a share of λ, or the finest; sought from level `from` on.
    #[inline]
    pub(super) fn level(&self, lambda: f32, from: usize) -> usize {
        let mut level = from.min(self.levels.len() - 1);
        while level > 0 && self.levels[level - 1].lambda >= lambda {
            level -= 1;
        }
        while level + 1 < self.levels.len() && self.levels[level].lambda < lambda {
            level += 1;
        }
        level
    }
}

fn check(instance: &Instance, row: usize, models: usize) -> Result<()> {
    let check = |right: bool, problem| match right {
        true => Ok(()),
        false => Err(LodError::Scene { what: "instance", row, problem }),
    };
    check((instance.model as usize) < models, "there is no such model")?;
    let near = |x: f32| x.abs() <= FARTHEST;
    check(
        instance.position.to_array().into_iter().all(near),
        "position must be finite, within 10⁷ m of the origin",
    )?;
    let unit = (instance.rotation.length() - 1.0).abs() <= UNIT;
    check(unit, "rotation must be a unit quaternion")?;
    let (least, most) = SCALES;
    check((least..=most).contains(&instance.scale), "scale must be 0.001 to 1000")
}

/// Numbers of the instances in the order of a Morton curve over the ground.
fn along_curve(instances: &[Instance]) -> Vec<u32> {
    let low = instances.iter().fold(Vec3::INFINITY, |low, i| low.min(i.position));
    let high = instances.iter().fold(Vec3::NEG_INFINITY, |high, i| high.max(i.position));
    let per_cell = 65535.0 / (high - low).max_element().max(1e-3);
    let mut order: Vec<(u32, u32)> = Vec::with_capacity(instances.len());
    for (id, instance) in instances.iter().enumerate() {
        let cell = (instance.position - low) * per_cell;
        order.push((spread(cell.x as u32) | spread(cell.z as u32) << 1, id as u32));
    }
    order.sort_unstable();
    order.into_iter().map(|(_, id)| id).collect()
}

/// Puts a 0 between the lower 16 bits.
fn spread(x: u32) -> u32 {
    let x = x & 0xffff;
    let x = (x | x << 8) & 0x00ff_00ff;
    let x = (x | x << 4) & 0x0f0f_0f0f;
    let x = (x | x << 2) & 0x3333_3333;
    (x | x << 1) & 0x5555_5555
}
