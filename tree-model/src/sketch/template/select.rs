//! Which template suits a drawing (Neubert 2012, section 4.8).
//!
//! Every template is compared with the drawing view by view and by the views' mirror images; its best view counts:
//! * `L_c` = −‖f − f'‖ for the footprints of the crown (equation 4.26), where a crown is drawn;
//! * `L_b` = −Σ (μ − μ')² / (σ² + σ'²) for length ratio and angles of the branching shape;
//! * L = `L_c` + `L_b` (equation 4.27).
//!
//! Departures: the terms have weights, since one counts in footprints' distances and the other in deviations. The
//! footprint of the branches counts as a third term, and without a crown it takes the crown's place, where the thesis has
//! `L_b` alone. A fourth compares which way the branches go. Each of `L_b`'s three parts is bounded: one odd fork cannot rule a template out. Norms are root mean
//! squares, so that weights do not depend on `K_f`.
//!
//! O(templates · views · `K_f`): about 50 µs for the built-in ones.

use super::measure::DrawnShape;
use super::shape::BranchShape;
use super::{Template, TemplateView};
use crate::error::{ModelError, Result, check};
use crate::sketch::{Footprint, Normal};
use std::f32::consts::PI;

/// How much the parts of the comparison weigh.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct SelectParams {
    /// Weight of the crown's footprint, 0 to 1000. Default 40.
    pub crown: f32,
    /// Weight of the branches' footprint, 0 to 1000. Default 40.
    pub branches: f32,
    /// Weight of the branching shape, 0 to 1000. Default 1.
    pub shape: f32,
    /// Weight of the directions of branches, 0 to 1000. Default 15.
    pub directions: f32,
    /// Added to every deviation of the branching shape, 0.001 to 10: what the hand adds. Default 0.3.
    pub hand: f32,
    /// What one of the branching shape's three parts can take away at most, 0 to 1000. Default 2.
    pub most: f32,
}

impl Default for SelectParams {
    fn default() -> Self {
        Self { crown: 40.0, branches: 40.0, shape: 1.0, directions: 15.0, hand: 0.3, most: 2.0 }
    }
}

impl SelectParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        check("select.crown", self.crown, 0.0, 1000.0)?;
        check("select.branches", self.branches, 0.0, 1000.0)?;
        check("select.shape", self.shape, 0.0, 1000.0)?;
        check("select.directions", self.directions, 0.0, 1000.0)?;
        check("select.hand", self.hand, 0.001_f32, 10.0)?;
        check("select.most", self.most, 0.0, 1000.0)
    }
}

/// A template, and how well it suits a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// Index of the template.
    pub template: usize,
    /// Where the eye stands round the template in the view that suits best, in radians, 0 to 2π.
    pub yaw: f32,
    /// L: 0 for a perfect match, else below.
    pub score: f32,
    /// The crown's part of it, weighted; 0 where no crown is drawn.
    pub crown: f32,
    /// The part of the branches' footprint, weighted.
    pub branches: f32,
    /// The branching shape's part, weighted: `L_b`.
    pub shape: f32,
    /// The directions' part, weighted.
    pub directions: f32,
}

/// All templates, best first.
///
/// # Errors
/// [`ModelError::Parameter`] naming a field of `params`; [`ModelError::Template`] where there is none to choose from.
pub fn select(
    drawn: &DrawnShape,
    templates: &[Template],
    params: &SelectParams,
) -> Result<Vec<Choice>> {
    params.validate()?;
    if templates.is_empty() {
        let problem = "there are none to choose from: give at least one".into();
        return Err(ModelError::Template { problem });
    }
    let mut choices: Vec<Choice> = templates
        .iter()
        .enumerate()
        .filter_map(|(template, of)| best_view(drawn, template, of, params))
        .collect();
    choices.sort_by(|a, b| b.score.total_cmp(&a.score).then(a.template.cmp(&b.template)));
    Ok(choices)
}

/// The view of a template that suits best.
fn best_view(
    drawn: &DrawnShape,
    template: usize,
    of: &Template,
    params: &SelectParams,
) -> Option<Choice> {
    let both = of.views.iter().flat_map(|view| [(view, false), (view, true)]);
    let choices = both.map(|(view, mirrored)| compare(drawn, template, view, mirrored, params));
    choices.reduce(|best, next| if next.score > best.score { next } else { best })
}

fn compare(
    drawn: &DrawnShape,
    template: usize,
    view: &TemplateView,
    mirrored: bool,
    params: &SelectParams,
) -> Choice {
    let footprint = |drawn: &Option<Footprint>, of: &Footprint| {
        drawn.as_ref().map_or(0.0, |drawn| -distance(drawn, of, mirrored))
    };
    let crown = params.crown * footprint(&drawn.crown, &view.crown);
    let branches = params.branches * footprint(&drawn.branches, &view.branches);
    let shape = params.shape * shape_score(&drawn.shape, &view.shape, params);
    let directions = -params.directions * drawn.directions.distance(&view.directions);
    let score = crown + branches + shape + directions;
    let yaw = if mirrored { view.yaw + PI } else { view.yaw };
    Choice { template, yaw, score, crown, branches, shape, directions }
}

/// Root mean square distance of two footprints, the second mirrored or not.
fn distance(drawn: &Footprint, of: &Footprint, mirrored: bool) -> f32 {
    if !mirrored {
        return drawn.distance(of);
    }
    let (f, g) = (drawn.distances(), of.distances());
    let n = f.len();
    // Direction k is k turns of 2π/n from +x; its mirror image is as far from −x the other way.
    let squares = (0..n).map(|k| (f[k] - g[(n / 2 + n - k) % n]) * (f[k] - g[(n / 2 + n - k) % n]));
    (squares.sum::<f32>() / n as f32).sqrt()
}

/// `L_b`.
fn shape_score(drawn: &BranchShape, of: &BranchShape, params: &SelectParams) -> f32 {
    let part = |drawn: Option<Normal>, of: Option<Normal>| {
        let Some((a, b)) = drawn.zip(of) else { return 0.0 };
        let apart = (a.mean - b.mean) * (a.mean - b.mean);
        let spread = a.deviation * a.deviation + b.deviation * b.deviation;
        (apart / (spread + params.hand * params.hand)).min(params.most)
    };
    let parts = [(drawn.scale, of.scale), (drawn.alpha, of.alpha), (drawn.beta, of.beta)];
    -parts.into_iter().map(|(drawn, of)| part(drawn, of)).sum::<f32>()
}
