//! What became of a drawing.

use crate::sketch::clean::CleanReport;
use crate::sketch::crown::CrownReport;
use crate::sketch::finish::FinishReport;
use crate::sketch::propagate::PropagateReport;
use tree_core::Tree;

/// A tree of a drawing.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SketchTree {
    /// The tree.
    pub tree: Tree,
    /// How it came about.
    pub report: SketchReport,
}

/// What became of a drawing on the way to a tree.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SketchReport {
    /// Repairs of strokes.
    pub clean: CleanReport,
    /// Repairs of the crown; `None` where none is drawn.
    pub crown: Option<CrownReport>,
    /// Name of the template taken.
    pub template: String,
    /// How well it suits the drawing, 0 for a perfect match; `None` where it was taken by name.
    pub score: Option<f32>,
    /// Segments that were drawn, from fork to fork.
    pub segments: u32,
    /// The posterior's logarithm.
    pub posterior: f64,
    /// Crossings of branches that could not be given room.
    pub interpenetrations: u32,
    /// What propagation did.
    pub propagate: PropagateReport,
    /// What the finish did.
    pub finish: FinishReport,
}

impl SketchReport {
    /// All that was repaired or fell short, in sentences.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let mut out: Vec<String> = self.clean.repairs.iter().map(ToString::to_string).collect();
        if let Some(crown) = &self.crown {
            out.extend(crown.repairs.iter().map(ToString::to_string));
        }
        match self.interpenetrations {
            0 => {}
            1 => out.push("at one crossing of the drawing branches run through each other".into()),
            n => {
                out.push(format!(
                    "at {n} crossings of the drawing branches run through each other"
                ));
            }
        }
        out
    }
}
