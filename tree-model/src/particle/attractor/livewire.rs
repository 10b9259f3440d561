//! Livewire: main branches as least-cost paths through a photograph.
//!
//! After Mortensen & Barrett (1998, *Interactive segmentation with intelligent scissors*) and Chodorowski
//! et al. (2005), whom Neubert (2012, section 3.2.2) uses: paths from seeds on the silhouette to the
//! foot of the tree through the visual structures of the picture.
//!
//! 1. The tree's part of the picture, about 256 rows high.
//! 2. Evidence of branches (`cost`, `ridge`): elongated ridges of matte, wood colour and luminance.
//! 3. Paths (`search`) over 16 neighbours, outside the matte at high cost, so that gaps are bridged.
//! 4. Stubs off, smoothing, fewer nodes (`tidy`).
//!
//! The source leaves the cost open and gives each seed its own search. Here a search from the base
//! serves all seeds; it is done three times, for the leader, for main seeds, for all, and earlier paths
//! attract later ones, so that something like a tree comes out even where a closed crown shows no branch.
//! Costs depend on the direction of a step.
//!
//! Costs 40 to 80 ms on one core for any picture, and a pass over its pixels.

use super::AttractorGraph;
use super::cost::rate;
use super::search::{NONE, union};
use super::tidy::Draft;
use super::trunk::Trunk;
use super::working::Working;
use crate::error::{ModelError, Result, check};
use crate::particle::{Matte, Photo};
use glam::Vec2;
use tree_core::{Control, NO_PARENT, Resource};

/// How livewire finds paths.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct LivewireParams {
    /// Rows of pixels over the height of the tree at which paths are sought, 16 to 1024. Default 256.
    /// Time and memory (120 bytes a pixel at most) grow with the square.
    pub rows: u32,
    /// How closely paths follow visible structures, 0 (not at all) to 0.98. Default 0.88: a step along the
    /// clearest branch costs 12 % of one through leaves.
    pub follow: f32,
    /// Cost of a step outside the tree, in steps inside, 1 to 100. Default 12.
    pub outside: f32,
    /// How much more a step at the silhouette costs than one in the middle, 0 to 10. Default 4.
    pub center: f32,
    /// How much more a step costs that leads back towards the base and down than one that leads away from
    /// it and up, 0 to 10. Default 0.6.
    pub outwards: f32,
    /// How much less than a step through leaves one costs along a path found before, 0 (paths do not attract
    /// each other) to 0.9. Default 0.3: without visible structures, side branches meet a main one at about
    /// arccos 0.7 = 45°. A visible branch attracts more than that.
    pub join: f32,
    /// Passes of smoothing over paths of working pixels, 0 to 1000. Default 12.
    pub smoothing: u32,
    /// Distance between nodes as a share of the tree's height, 0.001 to 0.5. Default 0.02.
    pub spacing: f32,
    /// Side branches shorter than this share of the tree's height are left out, 0 to 0.5. Default 0.05.
    pub stub: f32,
}

impl Default for LivewireParams {
    fn default() -> Self {
        Self {
            rows: 256,
            follow: 0.88,
            outside: 12.0,
            center: 4.0,
            outwards: 0.6,
            join: 0.3,
            smoothing: 12,
            spacing: 0.02,
            stub: 0.05,
        }
    }
}

impl LivewireParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("livewire.rows", self.rows, 16, 1024)?;
        check("livewire.follow", self.follow, 0.0_f32, 0.98_f32)?;
        check("livewire.outside", self.outside, 1.0_f32, 100.0_f32)?;
        check("livewire.center", self.center, 0.0_f32, 10.0_f32)?;
        check("livewire.outwards", self.outwards, 0.0_f32, 10.0_f32)?;
        check("livewire.join", self.join, 0.0_f32, 0.9_f32)?;
        check("livewire.smoothing", self.smoothing, 0, 1000)?;
        check("livewire.spacing", self.spacing, 0.001_f32, 0.5_f32)?;
        check("livewire.stub", self.stub, 0.0_f32, 0.5_f32)
    }
}

/// What livewire found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LivewireReport {
    /// Seeds that were not finite and left out.
    pub n_bad_seeds: u32,
    /// Seeds outside the picture, moved to its border.
    pub n_moved_seeds: u32,
    /// Side branches left out as stubs.
    pub n_stubs: u32,
    /// Tips of the graph.
    pub n_tips: u32,
    /// Share of the paths' length that runs outside the tree, 0 to 1: gaps that were bridged.
    pub outside: f32,
    /// How clearly the picture shows branches along the paths, 0 (arbitrary) to 1.
    pub evidence: f32,
    /// Width of the trunk at its foot in pixels; 0 where no trunk is seen.
    pub trunk_width: f32,
}

/// Finds paths from every seed to `base` through what `photo` and `matte` show, and joins them.
///
/// `base` and `seeds` are in pixels of the picture; seeds are for instance
/// [`silhouette_seeds`](super::silhouette_seeds), or what a person clicked on. The root of the graph is at
/// `base`, its tips are at the seeds. Without seeds the graph is the base alone.
///
/// # Errors
/// [`ModelError::Parameter`] for parameters out of range; [`ModelError::NotFinite`] for the base;
/// [`ModelError::Picture`] where the photograph's size is not the matte's;
/// [`ModelError::Attractor`] where the matte is empty; [`ModelError::Limit`];
/// [`ModelError::Cancelled`].
///
/// # Complexity
/// O(pixels + rows²).
pub fn livewire(
    matte: &Matte,
    photo: Option<&Photo>,
    base: Vec2,
    seeds: &[Vec2],
    params: &LivewireParams,
    control: &Control,
) -> Result<(AttractorGraph, LivewireReport)> {
    params.validate()?;
    check_inputs(matte, photo, base, control)?;
    control.report("livewire", 0.0)?;
    let picture = Vec2::new(matte.width() as f32, matte.height() as f32);
    let mut report = LivewireReport::default();
    let mut good = Vec::with_capacity(seeds.len());
    for &seed in seeds {
        let inside = seed.clamp(Vec2::ZERO, picture);
        report.n_bad_seeds += u32::from(!seed.is_finite());
        report.n_moved_seeds += u32::from(seed.is_finite() && inside != seed);
        good.extend(seed.is_finite().then_some(inside));
    }
    let mut near = good.clone();
    near.push(base);
    let Some(working) = Working::new(matte, photo, &near, params.rows) else {
        let problem = "the matte covers no pixel by a quarter or more: there is no tree to follow"
            .to_string();
        return Err(ModelError::Attractor { problem });
    };
    control.report("livewire", 0.1)?;
    let foot = working.pixel(base);
    let (x, y) = working.column_row(foot);
    let trunk = Trunk::find(&working.alpha, x, y);
    report.trunk_width = trunk.width * working.scale;
    let costs = rate(&working, &trunk, params);
    let pixels: Vec<u32> = good.iter().map(|&seed| working.pixel(seed) as u32).collect();
    let union = union(&working, &costs, &trunk, foot as u32, &pixels, params, control)?;
    rate_paths(&mut report, &working, &costs.evidence, &union.pixels);

    let mut nodes: Vec<Vec2> =
        union.pixels.iter().map(|&pixel| working.center(pixel as usize)).collect();
    // Tips are where the seeds are, not at the centres of their pixels.
    let mut has_child = vec![false; nodes.len()];
    for &parent in union.parents.iter().filter(|&&parent| parent != NONE) {
        has_child[parent as usize] = true;
    }
    for (seed, pixel) in good.iter().zip(&pixels) {
        if let Some(row) = union.pixels.iter().position(|other| other == pixel)
            && !has_child[row]
        {
            nodes[row] = *seed;
        }
    }
    nodes[0] = base;
    let parents =
        union.parents.iter().map(|&row| if row == NONE { NO_PARENT } else { row }).collect();
    let mut draft = Draft { nodes, parents };
    report.n_stubs = draft.prune(params.stub * working.tree_height);
    draft.smooth(params.smoothing);
    draft.thin((params.spacing * working.tree_height).max(1.0));
    let graph = draft.finish()?;
    report.n_tips = graph.tips().count() as u32;
    control.report("livewire", 1.0)?;
    Ok((graph, report))
}

fn check_inputs(matte: &Matte, photo: Option<&Photo>, base: Vec2, control: &Control) -> Result<()> {
    if !base.is_finite() {
        return Err(ModelError::NotFinite { field: "base".into() });
    }
    let size = (matte.width(), matte.height());
    if let Some(photo) = photo
        && (photo.width(), photo.height()) != size
    {
        let problem = format!(
            "the photograph is {} × {} pixels, its matte {} × {}; both must be of one size",
            photo.width(),
            photo.height(),
            size.0,
            size.1
        );
        return Err(ModelError::Picture { problem });
    }
    Ok(control.limits.check(Resource::Pixels, u64::from(size.0) * u64::from(size.1))?)
}

/// Fills in how clear the paths are and how much of them lies outside.
fn rate_paths(
    report: &mut LivewireReport,
    working: &Working,
    evidence: &[[u8; super::ridge::DIRECTIONS]],
    pixels: &[u32],
) {
    let n = pixels.len().max(1) as f32;
    for &pixel in pixels {
        let seen = evidence[pixel as usize].iter().copied().max().unwrap_or(0);
        report.evidence += f32::from(seen) / 255.0 / n;
        report.outside += if working.alpha.values[pixel as usize] < 0.25 { 1.0 / n } else { 0.0 };
    }
}
