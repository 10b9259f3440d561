//! A template is measured from a tree.
//!
//! 1. Its [main branches](super::main_branches) are what a person would draw of it; Ω is fitted to them.
//! 2. They are projected to views all round. A view from behind is the mirror image of that from the front, so half
//!    a turn of views is kept.
//! 3. For each view: the [branching shape](super::BranchShape), the footprints of the crown and of the branches, and the
//!    outline of the crown.
//!
//! Departures: the thesis compares drawings without a crown by their branching shape alone; here the hull of the branches
//! has a footprint too. It takes in the trunk, which tells a palm from a bush. And [which way the branches
//! go](super::Directions) is measured, which forks that are joined in another way do not change.
//!
//! Some milliseconds for each tree, most of it for outlines.

use super::main_branches::{MainBranchParams, main_branches};
use super::project::{flat, seen_from};
use super::shape::{BranchShape, Directions, Flat};
use super::{Template, TemplateView};
use crate::error::{ModelError, Result, check};
use crate::sketch::crown::{OutlineParams, outline_of};
use crate::sketch::{Branches, Footprint, Omega, Plan, convex_hull};
use glam::Vec2;
use std::f32::consts::PI;
use tree_core::{Control, Tree};

/// Most corners of a view's silhouette: enough to know the tree by, few enough to ship.
const SILHOUETTE_CORNERS: u32 = 28;

/// How a template is measured.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct TemplateParams {
    /// Views over half a turn, 1 to 180. Default 8, so with mirror images one every 22.5°.
    pub views: u32,
    /// Which branches are main ones.
    pub main: MainBranchParams,
}

impl Default for TemplateParams {
    fn default() -> Self {
        Self { views: 8, main: MainBranchParams::default() }
    }
}

impl TemplateParams {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the field.
    pub fn validate(&self) -> Result<()> {
        check("template.views", self.views, 1, 180)?;
        self.main.validate()
    }
}

impl Template {
    /// Measures a template of any tree: one's own exemplar. `species` names its leaves, in
    /// [`SPECIES`](crate::foliage::SPECIES) best.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming a field of `params`; [`ModelError::Template`] for names with line breaks, trees
    /// without extent, height or branches; [`ModelError::Cancelled`].
    ///
    /// # Complexity
    /// O(views · (nodes + leaves) · log).
    pub fn of_tree(
        name: &str,
        species: &str,
        tree: &Tree,
        params: &TemplateParams,
        control: &Control,
    ) -> Result<Self> {
        params.validate()?;
        let branches = main_branches(tree.skeleton(), &params.main)?;
        let base = tree.skeleton().positions()[0].y;
        let height = tree.skeleton().bounds().max.y - base;
        if height.is_nan() || height <= 0.0 {
            let problem = format!("'{name}' does not rise above its base: trees grow along +Y");
            return Err(ModelError::Template { problem });
        }
        let mut views = Vec::new();
        for number in 0..params.views {
            control.report("templates", number as f32 / params.views as f32)?;
            let yaw = PI * number as f32 / params.views as f32;
            views.push(view(name, tree, &branches, yaw)?);
        }
        let template = Self {
            name: name.into(),
            species: species.into(),
            height,
            slenderness: tree.skeleton().radii()[0] / height,
            omega: Omega::fit(&branches),
            views,
        };
        template.validate()?;
        Ok(template)
    }
}

fn view(name: &str, tree: &Tree, branches: &Branches, yaw: f32) -> Result<TemplateView> {
    let flat = flat(branches, yaw);
    let no_area = |what: &str| ModelError::Template {
        problem: format!(
            "the {what} of '{name}' has no area seen from {yaw} rad: a tree needs branches"
        ),
    };
    let mut crown = crown_points(tree, yaw);
    crown.extend(flat.above_root_branch());
    let all = Footprint::of(&flat.positions).ok_or_else(|| no_area("branching"))?;
    Ok(TemplateView {
        yaw,
        shape: BranchShape::of(&flat),
        directions: Directions::of(&flat),
        crown: Footprint::of(&crown).unwrap_or_else(|| all.clone()),
        branches: all,
        silhouette: silhouette(tree, &crown),
    })
}

/// The outline of a crown as a person would draw it round: of leaves its [outline](outline_of), of bare branches their
/// hull.
fn silhouette(tree: &Tree, crown: &[Vec2]) -> Vec<Vec2> {
    let params = OutlineParams { corners: SILHOUETTE_CORNERS, ..OutlineParams::default() };
    let outlines = if tree.foliage().is_empty() {
        None
    } else {
        outline_of(crown, &params).into_iter().next()
    };
    outlines.unwrap_or_else(|| convex_hull(crown))
}

/// Where a tree's leaves show from `yaw`; empty for bare trees.
#[must_use]
pub fn crown_points(tree: &Tree, yaw: f32) -> Vec<Vec2> {
    tree.foliage().positions().iter().map(|&point| seen_from(yaw, point)).collect()
}

/// What a drawing shows of a tree's kind.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnShape {
    /// Its branching shape.
    pub shape: BranchShape,
    /// Which way its branches go.
    pub directions: Directions,
    /// Of the drawn crown and all branches but the root branch, where a crown is drawn.
    pub crown: Option<Footprint>,
    /// Of all branches; `None` where they have no area, as a single straight stroke.
    pub branches: Option<Footprint>,
}

impl DrawnShape {
    /// Measures a plan, and the outline of its crown in metres where one is drawn (empty otherwise).
    ///
    /// # Complexity
    /// O(n log n).
    #[must_use]
    pub fn measure(plan: &Plan, crown: &[Vec2]) -> Self {
        Self::of_flat(&Flat::of_plan(plan), crown)
    }

    /// Measures branches as they are seen from `yaw`.
    #[must_use]
    pub fn of_branches(branches: &Branches, yaw: f32, crown: &[Vec2]) -> Self {
        Self::of_flat(&flat(branches, yaw), crown)
    }

    fn of_flat(flat: &Flat, crown: &[Vec2]) -> Self {
        let drawn_crown = (!crown.is_empty()).then(|| {
            let mut points = flat.above_root_branch();
            points.extend_from_slice(crown);
            Footprint::of(&points)
        });
        Self {
            shape: BranchShape::of(flat),
            directions: Directions::of(flat),
            crown: drawn_crown.flatten(),
            branches: Footprint::of(&flat.positions),
        }
    }
}
