//! What a scene has to know of a tree model.

use crate::error::{LodError, Result};
use crate::quality::Distance;
use glam::Vec3;

/// Most levels of a model.
pub const MAX_LEVELS: usize = 1024;
/// Most points that the visibility of a model is sampled with: their answers are kept as bits of a word.
pub const MAX_SAMPLES: usize = 64;
/// Most parts, and most occluders, of a model.
pub const MAX_PARTS: usize = 64;
/// Largest coordinate or size of a model, in metres.
const LARGEST: f32 = 1e5;

/// A tree model as a scene draws it. Lengths in metres, in the model's own space.
///
/// ```
/// use tree_lod::glam::Vec3;
/// use tree_lod::select::{Draw, Level, Model};
/// let wood = Draw { first_index: 0, index_count: 900, base_vertex: 0 };
/// let leaves = |n| Draw { first_index: 900, index_count: n, base_vertex: 0 };
/// let level = |lambda, n| Level { lambda, scale: 1.0 / lambda, fade: 0.0, draws: vec![wood, leaves(n)] };
/// let model = Model {
///     center: Vec3::Y * 4.0,
///     radius: 5.0,
///     levels: vec![level(0.1, 300), level(0.5, 1500), level(1.0, 3000)],
///     ..Model::default()
/// };
/// model.validate()?;
/// # Ok::<(), tree_lod::LodError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Centre of a sphere around the whole model, at its largest scale.
    pub center: Vec3,
    /// Radius of that sphere, more than 0, at most 100,000.
    pub radius: f32,
    /// Points on the crown's iso-surface, evenly spread, at most 64; 32 do well. None: the model is never
    /// taken for occluded (§7.4).
    pub samples: Vec<Vec3>,
    /// What hides other trees in the built-in occlusion pass: a few ellipsoids that are opaque for
    /// certain, such as the inner crown and the trunk. None: the model hides nothing there.
    pub occluders: Vec<Occluder>,
    /// λ for each distance, 0 at `near` and 1 at `far`. Default Cook's.
    pub distance: Distance,
    /// Distance in metres up to which the full model is drawn, for an instance of scale 1 in a field
    /// of view of 60° from top to bottom. What counts is the size on the screen: in other fields of view
    /// distances are multiplied by tan(fov / 2) / tan 30°, and divided by the instance's scale. They are
    /// measured from the eye to the mean of the samples, or to the centre where there are none. 0 or
    /// more. Default 10.
    pub near: f32,
    /// Distance from which on the least is drawn, more than `near`. Default 500.
    pub far: f32,
    /// What can be drawn, with rising λ, 1 to 1024. The more, the smoother.
    pub levels: Vec<Level>,
}

impl Default for Model {
    /// A sphere of 1 m without levels: give it some.
    fn default() -> Self {
        Self {
            center: Vec3::ZERO,
            radius: 1.0,
            samples: Vec::new(),
            occluders: Vec::new(),
            distance: Distance::cook(),
            near: 10.0,
            far: 500.0,
            levels: Vec::new(),
        }
    }
}

/// One step of the geometry of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Level {
    /// Share of the foliage's triangles, more than 0, at most 1.
    pub lambda: f32,
    /// Factor on the area of each element, more than 0.
    pub scale: f32,
    /// Width in λ over which the last elements fade in, 0 (they pop; nothing fades in the full model) to 1.
    pub fade: f32,
    /// What is drawn of each part of the model (bark, leaves, fruit), as many in every level. A part that
    /// is always drawn whole has the same draw in every level; a part that is not drawn has no indices.
    pub draws: Vec<Draw>,
}

/// A window of an index buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Draw {
    /// First index.
    pub first_index: u32,
    /// Number of indices.
    pub index_count: u32,
    /// Added to each index.
    pub base_vertex: i32,
}

/// An ellipsoid along the axes of the model that nothing is seen through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Occluder {
    /// Its centre.
    pub center: Vec3,
    /// Half its size along each axis, more than 0.
    pub radii: Vec3,
}

impl Model {
    /// Checks every number. The model's own place in a scene is 0 in errors.
    ///
    /// # Errors
    /// [`LodError::Scene`] that tells what is at fault and what would be right.
    pub fn validate(&self) -> Result<()> {
        self.validate_as(0)
    }

    /// As [`validate`](Self::validate); `row` is the model's place for errors.
    pub(super) fn validate_as(&self, row: usize) -> Result<()> {
        let check = |right: bool, problem| match right {
            true => Ok(()),
            false => Err(LodError::Scene { what: "model", row, problem }),
        };
        check(within(self.center), "center must be finite, within 100,000 m")?;
        check(positive(self.radius), "radius must be more than 0, at most 100,000 m")?;
        check(self.samples.len() <= MAX_SAMPLES, "samples: at most 64 points")?;
        check(self.samples.iter().all(|&p| within(p)), "samples must be finite, within 100,000 m")?;
        check(self.occluders.len() <= MAX_PARTS, "occluders: at most 64")?;
        let solid = |o: &Occluder| within(o.center) && o.radii.to_array().into_iter().all(positive);
        check(self.occluders.iter().all(solid), "occluders must be finite with radii above 0")?;
        check(
            self.near >= 0.0 && self.far > self.near && self.far <= 1e9,
            "near and far must be 0 or more, far above near, at most 10⁹ m",
        )?;
        self.validate_levels().or_else(|problem| check(false, problem))
    }

    fn validate_levels(&self) -> Result<(), &'static str> {
        if !(1..=MAX_LEVELS).contains(&self.levels.len()) {
            return Err("levels: 1 to 1024 of them");
        }
        let parts = self.parts();
        if !(1..=MAX_PARTS).contains(&parts) {
            return Err("levels: 1 to 64 draws in each");
        }
        let mut last = 0.0;
        for level in &self.levels {
            if !(level.lambda > last && level.lambda <= 1.0) {
                return Err("levels: lambda must rise from above 0 to at most 1");
            }
            if !(level.scale > 0.0 && level.scale < 1e6) {
                return Err("levels: scale must be more than 0, less than 10⁶");
            }
            if !(0.0..=1.0).contains(&level.fade) {
                return Err("levels: fade must be 0 to 1");
            }
            if level.draws.len() != parts {
                return Err("levels: as many draws in every level");
            }
            if level.draws.iter().any(|d| d.first_index.checked_add(d.index_count).is_none()) {
                return Err("levels: draws must end within 2³² indices");
            }
            last = level.lambda;
        }
        Ok(())
    }

    /// Draws in each level.
    pub(super) fn parts(&self) -> usize {
        self.levels.first().map_or(0, |level| level.draws.len())
    }
}

/// Whether a point is finite and not absurdly far off.
fn within(p: Vec3) -> bool {
    p.to_array().into_iter().all(|x| x.abs() <= LARGEST)
}

fn positive(length: f32) -> bool {
    length > 0.0 && length <= LARGEST
}
