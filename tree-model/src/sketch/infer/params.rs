//! Parameters of inference.

use crate::error::{Result, check};

/// How depths, labels and Ω are inferred.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct InferParams {
    /// Whether Ω stays the template's (section 4.6.1) or fits itself to the sketch (section 4.6.2). Default false.
    pub keep_omega: bool,
    /// Rounds of refining depths and, unless `keep_omega`, of estimating Ω, 0 to 100. Default 6; the thesis needed
    /// fewer than 10.
    pub rounds: u32,
    /// Passes of ICM over all segments in each round, at most, 1 to 1000. Default 8.
    pub sweeps: u32,
    /// ICM ends where the depths of a pass changed by less than this share of the drawing's size altogether,
    /// 0 to 1. Default 0.0005; the thesis has 0.01 of its own units.
    pub settled: f32,
    /// How many half-placed trees bottom-up inference keeps at once, 1 to 4096; 1 is the thesis. Large drawings get fewer, so that
    /// time stays linear. Default 64.
    pub beam: u32,
    /// How far angles and ratios spread as Ω says, 0 to 1. At 0 each segment aims at the means, as in the thesis, and all
    /// branches come out alike; at 1 each aims at a draw from Ω of its own. Default 1.
    pub spread: f32,
    /// `k_e` of Eq. 4.22: how strongly branches keep out of each other's space, 0 to 1000. Default 0.2.
    pub competition: f32,
    /// How much likelier, as the logarithm of a ratio, a stroke goes on as the same axis than as a lateral, 0 (the
    /// thesis) to 100. Default 3.
    pub follow: f32,
    /// Standard deviation in radians by which a stroke bends towards or away from the viewer from one segment to the next, 0.01
    /// to 10. Small keeps curvy strokes in their plane; the thesis has none (its Fig. 4.19). Default 0.3.
    pub bending: f32,
    /// Ω counts with so many imagined segments of the template when it is estimated, 0.1 to 1e6. Default 8.
    pub template_weight: f32,
    /// Branches that cross in the drawing keep this multiple of their thickness apart, 0 (off) to 10. Default 1.3.
    pub clearance: f32,
    /// Radius of the trunk as a share of the height, for the branches' thickness, 1e-4 to 0.2. Default 0.02.
    pub slenderness: f32,
}

impl Default for InferParams {
    fn default() -> Self {
        Self {
            keep_omega: false,
            rounds: 6,
            sweeps: 8,
            settled: 5e-4,
            beam: 64,
            spread: 1.0,
            competition: 0.2,
            follow: 3.0,
            bending: 0.3,
            template_weight: 8.0,
            clearance: 1.3,
            slenderness: 0.02,
        }
    }
}

impl InferParams {
    /// The thesis alone: no beam, no spread, no preference for a stroke's own continuation, no bending prior.
    #[must_use]
    pub fn thesis() -> Self {
        Self { beam: 1, spread: 0.0, follow: 0.0, bending: 10.0, ..Self::default() }
    }

    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field.
    pub fn validate(&self) -> Result<()> {
        check("infer.rounds", self.rounds, 0, 100)?;
        check("infer.sweeps", self.sweeps, 1, 1000)?;
        check("infer.settled", self.settled, 0.0, 1.0)?;
        check("infer.beam", self.beam, 1, 4096)?;
        check("infer.spread", self.spread, 0.0, 1.0)?;
        check("infer.competition", self.competition, 0.0, 1000.0)?;
        check("infer.follow", self.follow, 0.0, 100.0)?;
        check("infer.bending", self.bending, 0.01_f32, 10.0)?;
        check("infer.template_weight", self.template_weight, 0.1_f32, 1e6_f32)?;
        check("infer.clearance", self.clearance, 0.0, 10.0)?;
        check("infer.slenderness", self.slenderness, 1e-4_f32, 0.2_f32)
    }
}
