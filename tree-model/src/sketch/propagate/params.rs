//! Parameters of propagation.

use crate::error::{Result, check};

/// How a sketch is filled up with branches.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct PropagateParams {
    /// Generations of new segments where no crown is drawn, 0 (none) to 32. Default 5, as in the thesis.
    pub generations: u32,
    /// Most generations where a crown is drawn: its surface mostly ends growth before, 0 to 32. Default 7.
    pub generations_in_crown: u32,
    /// A sketched segment longer than this many times its natural length gets new laterals, 1 to 1e6. Default 1.5;
    /// 1e6 for none.
    pub long: f32,
    /// Longest natural length of a segment from fork to fork, as a share of the tree's height, 1e-3 to 1. Default
    /// 0.045. Smaller gives more laterals along sketched branches.
    pub internode: f32,
    /// Segments shorter than this share of the tree's height do not grow, 1e-4 to 1. Default 0.009.
    pub shortest: f32,
    /// Share of a trunk without drawn branches that stays bare where no crown is drawn, 0 to 1. Default 0.25.
    pub bare: f32,
    /// Whether a trunk with drawn branches gets new laterals below the first of them too. Default false.
    pub below_first: bool,
    /// Highest Gravelius order of new axes, 0 to 32. Default 8. A palm has 1: its fronds do not branch.
    pub orders: u32,
    /// Most segments, sketched and new, 1 to 100 million. Default 20,000. The last generation is thinned evenly where
    /// there would be more.
    pub max_segments: u32,
    /// How far each new segment turns down: so many times straight down is added to its direction, -1 to 1. Negative
    /// turns up. Default 0.
    pub gravitropism: f32,
    /// Random deviation of angles from those of the block, in radians, 0 to π. Default 0.12.
    pub jitter: f32,
    /// Distance in metres that new segments keep from obstacles, 0 to 1e6. Default 0.1.
    pub clearance: f32,
}

impl Default for PropagateParams {
    fn default() -> Self {
        Self {
            generations: 5,
            generations_in_crown: 7,
            long: 1.5,
            internode: 0.045,
            shortest: 0.009,
            bare: 0.25,
            below_first: false,
            orders: 8,
            max_segments: 20_000,
            gravitropism: 0.0,
            jitter: 0.12,
            clearance: 0.1,
        }
    }
}

impl PropagateParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self) -> Result<()> {
        check("propagate.generations", self.generations, 0, 32)?;
        check("propagate.generations_in_crown", self.generations_in_crown, 0, 32)?;
        check("propagate.long", self.long, 1.0, 1e6)?;
        check("propagate.internode", self.internode, 1e-3_f32, 1.0)?;
        check("propagate.shortest", self.shortest, 1e-4_f32, 1.0)?;
        check("propagate.bare", self.bare, 0.0, 1.0)?;
        check("propagate.orders", self.orders, 0, 32)?;
        check("propagate.max_segments", self.max_segments, 1, 100_000_000)?;
        check("propagate.gravitropism", self.gravitropism, -1.0, 1.0)?;
        check("propagate.jitter", self.jitter, 0.0, std::f32::consts::PI)?;
        check("propagate.clearance", self.clearance, 0.0, 1e6)
    }
}
