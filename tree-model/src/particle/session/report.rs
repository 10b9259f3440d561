//! What a tree from photographs came of.

use crate::particle::AlignWarning;
use crate::particle::attractor::{LivewireReport, StrokeReport};
use crate::particle::density::{DensityReport, DensityWarning};
use crate::particle::finish::CrownReport;
use crate::particle::flow::FlowReport;
use tree_core::Tree;

/// Fewer leaves than this make no crown.
const FEW_LEAVES: f64 = 100.0;

/// A tree from photographs and how it came about.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PhotoTree {
    /// The tree.
    pub tree: Tree,
    /// What was found, repaired and left out.
    pub report: PhotoReport,
}

/// What was found, repaired and left out on the way to a tree.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct PhotoReport {
    /// One entry a view.
    pub views: Vec<ViewReport>,
    /// Where the views do not agree with each other.
    pub disagreements: Vec<AlignWarning>,
    /// How well the density gives the mattes.
    pub density: DensityReport,
    /// What became of the particles.
    pub flow: FlowReport,
    /// Twigs and leaves.
    pub crown: CrownReport,
    /// Radius of the trunk that the views show, in metres; `None` where they show no bare trunk.
    pub trunk_radius: Option<f32>,
    /// Height in metres below which no view shows more than the trunk.
    pub crown_base: f32,
}

/// What one view gave.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ViewReport {
    /// What its alignment is doubtful about; empty where the caller placed the camera.
    pub warnings: Vec<AlignWarning>,
    /// What livewire found, where it was asked.
    pub livewire: Option<LivewireReport>,
    /// How drawn strokes were joined, where there are some.
    pub strokes: Option<StrokeReport>,
    /// Whether the view gives directions: not without an attractor.
    pub attracts: bool,
}

impl PhotoReport {
    /// Everything doubtful, a line each, for a person to read. Empty where all went well.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let mut lines = Vec::new();
        for (view, report) in self.views.iter().enumerate() {
            for warning in &report.warnings {
                lines.push(format!("views[{view}]: {warning}"));
            }
        }
        lines.extend(self.disagreements.iter().map(ToString::to_string));
        lines.extend(self.density.warnings.iter().map(|warning| match warning {
            DensityWarning::Contradiction { view, residual } if *view >= self.views.len() => format!(
                "the imagined side contradicts the photographs by {:.0} %: add one from another side, or \
                 switch `imagine` off",
                100.0 * residual
            ),
            other => other.to_string(),
        }));
        let asked = self.crown.leaves_asked;
        if asked > 0.0 && asked < FEW_LEAVES {
            lines.push(format!(
                "about {asked:.0} leaves cover the whole crown: they are large for so small a tree; lower \
                 `finish.leaves.size` or raise `height`"
            ));
        }
        if self.flow.n_steered > 0 {
            lines.push(format!(
                "{} of {} particles were still on their way after all steps and were steered to the base: \
                 raise `flow.steps` or `flow.step`",
                self.flow.n_steered, self.flow.n_particles
            ));
        }
        if self.flow.n_led > 0 {
            lines.push(format!(
                "{} particles were lost and led to the nearest branch",
                self.flow.n_led
            ));
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leaves_too_large_for_the_tree_are_warned_of() {
        let with = |leaves_asked| {
            let crown = CrownReport { leaves_asked, ..CrownReport::default() };
            PhotoReport { crown, ..PhotoReport::default() }.warnings()
        };
        assert!(with(4.0)[0].contains("finish.leaves.size"));
        // A full crown, and a bare tree.
        assert!(with(5000.0).is_empty() && with(0.0).is_empty());
    }
}
