//! Seeds: points on the silhouette of the crown, where livewire starts (Neubert 2012, section 3.2.2).
//!
//! 1. The crown's envelope: the matte blurred, so that gaps between twigs close, above a threshold.
//! 2. Its outer contour: envelope pixels beside what can be reached from the picture's border.
//! 3. From each the nearest covered pixel: the outermost leaf, or the tip of a twig.
//! 4. Without those near the trunk.
//! 5. The best candidates (Mitchell 1991): each of the `n` is the farthest from those before it among a few
//!    drawn at random. That spreads evenly, and every prefix too.

use super::plane::Plane;
use super::trunk::Trunk;
use super::working::Working;
use crate::error::{ModelError, Result, check};
use crate::particle::Matte;
use glam::Vec2;
use rand::RngExt;
use tree_core::{Control, Resource, Seed};

/// Rows of the working picture: seeds need no more detail.
const ROWS: u32 = 200;

/// Blur that closes the gaps between twigs, as a share of the working picture's height.
const CLOSE: f32 = 0.02;

/// Blurred coverage from which on a pixel belongs to the envelope.
const ENVELOPE: f32 = 0.2;

/// Coverage of a pixel that can be a seed. Lower than one half: fine twigs are thinner than a pixel.
const COVERED: f32 = 0.35;

/// How far from the envelope's contour a covered pixel is looked for, in blurs.
const SNAP: f32 = 4.0;

/// Blur of the matte whose gradient says which way the silhouette faces, as a share of the working
/// picture's height.
const FACING: f32 = 0.05;

/// Candidates drawn for each seed.
const CANDIDATES: u32 = 12;

/// Which points of the silhouette may be seeds.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct SeedParams {
    /// Distance that seeds keep from the trunk as a share of the tree's height, 0 to 1. Default 0.08.
    pub from_trunk: f32,
    /// Lowest height of a seed over the base as a share of the tree's height, -1 to 1. Default 0.05: what
    /// hangs lower is left out.
    pub lowest: f32,
    /// How far the silhouette may face down at a seed, 0 (aside) to 1 (straight down). Default 0.8: main
    /// branches end above and beside, and what hangs down hangs from them.
    pub downwards: f32,
}

impl Default for SeedParams {
    fn default() -> Self {
        Self { from_trunk: 0.08, lowest: 0.05, downwards: 0.8 }
    }
}

impl SeedParams {
    /// Checks every range.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] naming the first field out of range.
    pub fn validate(&self) -> Result<()> {
        check("seeds.from_trunk", self.from_trunk, 0.0_f32, 1.0_f32)?;
        check("seeds.lowest", self.lowest, -1.0_f32, 1.0_f32)?;
        check("seeds.downwards", self.downwards, 0.0_f32, 1.0_f32)
    }
}

/// Up to `n` points on the crown's silhouette, in pixels, evenly spread, other ones for every `seed`.
/// Fewer where the silhouette has fewer pixels.
///
/// # Errors
/// [`ModelError::Parameter`] for parameters out of range or `n` over 100,000;
/// [`ModelError::NotFinite`] for the base; [`ModelError::Attractor`] where the matte is empty;
/// [`ModelError::Limit`]; [`ModelError::Cancelled`].
///
/// # Complexity
/// O(pixels + n²).
pub fn silhouette_seeds(
    matte: &Matte,
    base: Vec2,
    n: u32,
    params: &SeedParams,
    seed: Seed,
    control: &Control,
) -> Result<Vec<Vec2>> {
    params.validate()?;
    check("seeds.n", n, 0, 100_000)?;
    if !base.is_finite() {
        return Err(ModelError::NotFinite { field: "base".into() });
    }
    let pixels = u64::from(matte.width()) * u64::from(matte.height());
    control.limits.check(Resource::Pixels, pixels)?;
    control.report("silhouette", 0.0)?;
    let Some(working) = Working::new(matte, None, &[base], ROWS) else {
        let problem =
            "the matte covers no pixel by a quarter or more: there is no silhouette".to_string();
        return Err(ModelError::Attractor { problem });
    };
    let contour = outermost(&working);
    let candidates = away_from_trunk(&working, contour, base, params);
    control.report("silhouette", 0.8)?;
    Ok(spread(candidates, n as usize, seed))
}

/// The outermost covered pixels, in reading order.
fn outermost(working: &Working) -> Vec<usize> {
    let alpha = &working.alpha;
    let (width, height) = (alpha.width as i32, alpha.height as i32);
    let sigma = (CLOSE * height as f32).max(0.8);
    let envelope = alpha.blur(sigma).map(|value| if value > ENVELOPE { 1.0 } else { 0.0 });
    let outside = reached_from_border(&envelope.values, width, height);
    let reach = (SNAP * sigma).ceil() as i32;
    let mut found = vec![false; alpha.values.len()];
    for y in 0..height {
        for x in 0..width {
            let at = |x: i32, y: i32| (y * width + x) as usize;
            if outside[at(x, y)] {
                continue;
            }
            let is_out = |x: i32, y: i32| {
                (0..width).contains(&x) && (0..height).contains(&y) && outside[at(x, y)]
            };
            let on_border = x == 0 || y == 0 || x == width - 1 || y == height - 1;
            let beside = [(1, 0), (-1, 0), (0, 1), (0, -1)];
            if !on_border && !beside.iter().any(|&(dx, dy)| is_out(x + dx, y + dy)) {
                continue;
            }
            let mut best = (i32::MAX, None);
            for v in (y - reach).max(0)..=(y + reach).min(height - 1) {
                for u in (x - reach).max(0)..=(x + reach).min(width - 1) {
                    let distance = (u - x) * (u - x) + (v - y) * (v - y);
                    if distance < best.0 && alpha.values[at(u, v)] > COVERED {
                        best = (distance, Some(at(u, v)));
                    }
                }
            }
            if let Some(pixel) = best.1 {
                found[pixel] = true;
            }
        }
    }
    (0..found.len()).filter(|&pixel| found[pixel]).collect()
}

/// Which pixels outside the envelope can be reached from the border of the picture.
fn reached_from_border(envelope: &[f32], width: i32, height: i32) -> Vec<bool> {
    let mut reached = vec![false; envelope.len()];
    let at = |x: i32, y: i32| (y * width + x) as usize;
    let mut open: Vec<(i32, i32)> = (0..width).flat_map(|x| [(x, 0), (x, height - 1)]).collect();
    open.extend((0..height).flat_map(|y| [(0, y), (width - 1, y)]));
    while let Some((x, y)) = open.pop() {
        let inside = (0..width).contains(&x) && (0..height).contains(&y);
        if !inside || reached[at(x, y)] || envelope[at(x, y)] > 0.5 {
            continue;
        }
        reached[at(x, y)] = true;
        open.extend([(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)]);
    }
    reached
}

/// Candidates in pixels of the picture, without those on or beside the trunk and below the crown.
fn away_from_trunk(
    working: &Working,
    contour: Vec<usize>,
    base: Vec2,
    params: &SeedParams,
) -> Vec<Vec2> {
    let (x, y) = working.column_row(working.pixel(base));
    let trunk = Trunk::find(&working.alpha, x, y);
    let height = working.tree_height / working.scale;
    let keep_off = (params.from_trunk * height).max(1.5 * trunk.width);
    let lowest = y as f32 - params.lowest * height;
    let depth = working.alpha.blur((FACING * working.alpha.height as f32).max(1.0));
    let is_crown = |&pixel: &usize| {
        let (x, y) = working.column_row(pixel);
        y as f32 <= lowest
            && trunk.distance(x, y) > keep_off
            && downwards(&depth, x, y) <= params.downwards
    };
    let kept: Vec<usize> = contour.iter().copied().filter(is_crown).collect();
    // Better a seed on the trunk than none.
    let kept = if kept.is_empty() { contour } else { kept };
    kept.into_iter().map(|pixel| working.center(pixel)).collect()
}

/// How far the silhouette faces down at a pixel: -1 up, 0 aside, 1 down.
fn downwards(depth: &Plane, x: usize, y: usize) -> f32 {
    let at = |x: usize, y: usize| {
        depth.values[y.min(depth.height - 1) * depth.width + x.min(depth.width - 1)]
    };
    let gradient = Vec2::new(
        at(x + 1, y) - at(x.saturating_sub(1), y),
        at(x, y + 1) - at(x, y.saturating_sub(1)),
    );
    // Outwards is where coverage falls.
    -gradient.normalize_or_zero().y
}

/// Up to `n` of the candidates by best candidate.
fn spread(mut candidates: Vec<Vec2>, n: usize, seed: Seed) -> Vec<Vec2> {
    let mut rng = seed.stream("silhouette").rng();
    let mut seeds: Vec<Vec2> = Vec::with_capacity(n.min(candidates.len()));
    while seeds.len() < n && !candidates.is_empty() {
        let mut best = (-1.0, 0);
        for _ in 0..CANDIDATES {
            let row = rng.random_range(0..candidates.len() as u32) as usize;
            let nearest = seeds
                .iter()
                .map(|other| other.distance_squared(candidates[row]))
                .fold(f32::INFINITY, f32::min);
            if nearest > best.0 {
                best = (nearest, row);
            }
        }
        seeds.push(candidates.swap_remove(best.1));
    }
    seeds
}
