//! All parameters of the way from a drawing to a tree.

use crate::error::{Result, check};
use crate::sketch::clean::CleanParams;
use crate::sketch::crown::CrownParams;
use crate::sketch::finish::FinishParams;
use crate::sketch::infer::InferParams;
use crate::sketch::propagate::PropagateParams;
use crate::sketch::template::SelectParams;

/// All parameters of the way from a drawing to a tree.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct SketchParams {
    /// Height of the drawing, branches and crown, in metres, 0.01 to 1000. `None`, the default: the template's.
    pub height: Option<f32>,
    /// Name of the template. `None`, the default: the one that suits the drawing best.
    pub template: Option<String>,
    /// Species whose twigs and leaves the tree bears, a name in [`SPECIES`](crate::foliage::SPECIES). `None`, the
    /// default: the template's.
    pub species: Option<String>,
    /// How strokes are cleaned and joined. Its `height` is not used here.
    pub clean: CleanParams,
    /// How the crown is closed.
    pub crown: CrownParams,
    /// How templates are compared with the drawing.
    pub select: SelectParams,
    /// How depths are inferred. Its `slenderness` is not used here.
    pub infer: InferParams,
    /// How branches are propagated.
    pub propagate: PropagateParams,
    /// How branches become a tree. Its `species` is not used here, its `slenderness` counts relative to the default: the
    /// template has its own.
    pub finish: FinishParams,
}

impl SketchParams {
    /// Checks all ranges. Names are looked up when they are needed.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter) naming the field, or as the parts do.
    pub fn validate(&self) -> Result<()> {
        if let Some(height) = self.height {
            check("height", height, 0.01_f32, 1000.0_f32)?;
        }
        self.clean.validate()?;
        self.crown.validate()?;
        self.select.validate()?;
        self.infer.validate()?;
        self.propagate.validate()?;
        self.finish.validate()
    }
}
