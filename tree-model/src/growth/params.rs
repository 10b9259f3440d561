//! One tree and its world.

use super::finish::Grown;
use super::habit::Habit;
use super::simulation::{Plant, grow_stand};
use super::surroundings::World;
use crate::error::{Result, check};
use glam::Vec3;
use tree_core::{Control, ParameterError, Seed};

/// Most iterations of one growth.
pub const MAX_ITERATIONS: u32 = 10_000;

/// Most trees in one stand.
pub const MAX_PLANTS: usize = 100_000;

/// Everything that shapes a solitary tree by Palubicki's method. For several see
/// [`grow_stand`].
///
/// ```
/// use tree_model::growth::{GrowthParams, Preset};
/// use tree_model::tree_core::{Control, Seed};
/// let params = GrowthParams { iterations: 8, ..Preset::find("birch")?.params() };
/// let grown = params.grow(Seed(1), &Control::default())?;
/// assert!(grown.ages.iter().all(|&age| age <= 8));
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct GrowthParams {
    /// Iterations, usually years, 0 to [`MAX_ITERATIONS`]; after 0 there is the seedling's one internode.
    /// Default 18.
    pub iterations: u32,
    /// Where it grows.
    pub world: World,
    /// What kind of tree it is.
    pub habit: Habit,
    /// Where it stands, in metres. Default the origin.
    pub base: Vec3,
}

impl Default for GrowthParams {
    fn default() -> Self {
        Self { iterations: 18, world: World::default(), habit: Habit::default(), base: Vec3::ZERO }
    }
}

impl GrowthParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) or [`ModelError::NotFinite`](crate::ModelError::NotFinite), naming the field.
    pub fn validate(&self) -> Result<()> {
        check("iterations", self.iterations, 0, MAX_ITERATIONS)?;
        self.world.validate()?;
        self.planting().validate()
    }

    /// The tree as one of a stand.
    #[must_use]
    pub fn planting(&self) -> Plant {
        Plant { habit: self.habit.clone(), base: self.base, direction: Vec3::Y }
    }

    /// Grows the tree. The same seed gives the same bits for any number of threads.
    ///
    /// # Errors
    /// What [`validate`](Self::validate) finds; [`ModelError::RootBlocked`](crate::ModelError::RootBlocked) where the base or the first
    /// internode is in the obstacle; [`ModelError::Limit`](crate::ModelError::Limit) before more nodes, voxels or leaves are made than
    /// allowed; [`ModelError::Core`](crate::ModelError::Core) where a tree is too large for an f32; [`ModelError::Cancelled`](crate::ModelError::Cancelled).
    ///
    /// # Complexity
    /// Linear in nodes times iterations, and the leaves.
    pub fn grow(&self, seed: Seed, control: &Control) -> Result<Grown> {
        self.validate()?;
        let grown = grow_stand(&self.world, &[self.planting()], self.iterations, seed, control)?;
        let max = MAX_PLANTS as f64;
        let no_tree = || ParameterError { field: "plants.len()".into(), found: 0.0, min: 1.0, max };
        Ok(grown.into_iter().next().ok_or_else(no_tree)?)
    }
}
