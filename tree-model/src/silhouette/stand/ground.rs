//! Where trees stand, and their scale.
//!
//! A pinhole camera at height H over level ground, looking level: what stands at distance Z has its ground point v = f H / Z below
//! the horizon, and a unit of the drawing is Z / f = H / v metres there. So scales follow from the horizon alone up to H, which
//! the height of the tallest tree gives; f, which only distances need, follows from the angle of view.

use super::params::{Perspective, StandParams};
use super::report::StandNote;
use crate::error::{ModelError, Result};
use crate::silhouette::read::TreeStrokes;
use crate::silhouette::session::{Ground, stand};
use glam::{Vec2, Vec3};
use tree_core::Seed;

/// A tree this many times as large or small as the median is a slip of the pen.
const ODD_SIZE: f32 = 1e3;
/// And so is one this many median heights away from the median place.
const ODD_PLACE: f32 = 1e4;
/// Ground points that spread over less than this share of the median height are on one line.
const ONE_LINE: f32 = 0.25;
/// Sizes tell the horizon when their correlation with the ground's height is at least this.
const TELLING: f32 = 0.5;
/// Fewer trees than this tell no horizon.
const FEW: usize = 3;
/// No tree is nearer to the horizon than this share of the nearest tree's distance to it.
const FARTHEST: f32 = 0.08;
/// The eye is no higher than this many heights of the tallest tree; that high where sizes do not tell.
const HIGHEST_EYE: f32 = 4.0;

/// From where a drawing in perspective was seen: looking level along −Z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandView {
    /// The eye, in metres.
    pub eye: Vec3,
    /// The point of the drawing that the eye looks at: on the horizon, in units of the drawing.
    pub center: Vec2,
    /// Distance of the drawing from the eye, in units of the drawing.
    pub focal: f32,
}

/// A tree of the drawing that stands somewhere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stance {
    /// Its place among the trees of the drawing.
    pub(super) index: usize,
    base: Vec2,
    height: f32,
}

/// Where a tree stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) ground: Ground,
    pub(super) position: Vec3,
}

/// The trees that have an extent and are of the size and place of the others.
pub(super) fn stances(
    trees: &[TreeStrokes],
    names: &[String],
    notes: &mut Vec<StandNote>,
) -> Vec<Stance> {
    let all: Vec<Option<Stance>> = trees
        .iter()
        .enumerate()
        .map(|(index, tree)| stand(tree).map(|(base, height)| Stance { index, base, height }))
        .map(|stance| stance.filter(|stance| stance.base.is_finite()))
        .collect();
    let good = || all.iter().flatten();
    let height = median(good().map(|s| s.height));
    let middle = Vec2::new(median(good().map(|s| s.base.x)), median(good().map(|s| s.base.y)));
    let why = |stance: &Option<Stance>| match stance {
        None => Some("level 0 has no extent; draw the crown's outline there".into()),
        Some(s) if s.height > ODD_SIZE * height || height > ODD_SIZE * s.height => {
            let factor = s.height / height;
            Some(format!("it is {factor:.1e} times as high as the others"))
        }
        Some(s) if (s.base - middle).abs().max_element() > ODD_PLACE * height => {
            Some("it is too far away from the others".into())
        }
        Some(_) => None,
    };
    let mut kept = Vec::new();
    for (stance, name) in all.iter().zip(names) {
        match (why(stance), stance) {
            (Some(why), _) => notes.push(StandNote::LeftOut { tree: name.clone(), why }),
            (None, stance) => kept.extend(*stance),
        }
    }
    kept
}

/// Where trees stand; and from where they are seen, in perspective.
///
/// # Errors
/// [`ModelError::Silhouette`] for a horizon below all trees.
pub(super) fn places(
    stances: &[Stance],
    names: &[String],
    params: &StandParams,
    seed: Seed,
    notes: &mut Vec<StandNote>,
) -> Result<(Vec<Place>, Option<StandView>)> {
    let horizon = match params.perspective {
        Perspective::Flat => None,
        Perspective::Horizon(y) => Some(y),
        Perspective::Estimated => estimated(stances, notes),
    };
    let Some(horizon) = horizon else { return Ok((on_a_line(stances, params, seed), None)) };
    let nearest = stances.iter().map(|s| s.base.y - horizon).fold(0.0, f32::max);
    if nearest <= 0.0 {
        let problem = "it lies below all trees; y runs downwards".into();
        return Err(ModelError::Silhouette { what: "horizon".into(), problem });
    }
    let below: Vec<f32> = stances
        .iter()
        .map(|stance| {
            let below = stance.base.y - horizon;
            if below < FARTHEST * nearest {
                notes.push(StandNote::BroughtNearer { tree: names[stance.index].clone() });
            }
            below.max(FARTHEST * nearest)
        })
        .collect();
    let sizes = stances.iter().zip(&below).map(|(stance, below)| stance.height / below);
    let eye = params.silhouette.height / sizes.fold(0.0, f32::max);
    let (left, right) = range(stances.iter().map(|stance| stance.base.x));
    let widest = stances.iter().map(|stance| stance.height).fold(0.0, f32::max);
    // Crowns reach beyond their trunks.
    let focal = 0.5 * (right - left + widest) / libm::tanf(0.5 * params.fov);
    let center = Vec2::new(0.5 * (left + right), horizon);
    let places = stances.iter().zip(&below).map(|(stance, below)| {
        let scale = eye / below;
        let far = focal * (scale - eye / nearest);
        let position = Vec3::new((stance.base.x - center.x) * scale, 0.0, -far);
        Place { ground: Ground { base: stance.base, scale }, position }
    });
    let view = StandView { eye: Vec3::new(0.0, eye, focal * eye / nearest), center, focal };
    Ok((places.collect(), Some(view)))
}

/// The horizon that ground points and sizes tell; `None` where all stand on about one line.
///
/// Trees of one height would shrink linearly towards the horizon: it is where a line fitted to heights over ground points
/// comes to nothing. Trees of many heights scatter about that line.
fn estimated(stances: &[Stance], notes: &mut Vec<StandNote>) -> Option<f32> {
    let (top, bottom) = range(stances.iter().map(|stance| stance.base.y));
    if bottom - top < ONE_LINE * median(stances.iter().map(|stance| stance.height)) {
        return None;
    }
    let tallest = stances.iter().map(|stance| stance.height).fold(0.0, f32::max);
    let highest = bottom - HIGHEST_EYE * tallest;
    let lowest = (top - FARTHEST * bottom) / (1.0 - FARTHEST);
    if let Some(horizon) = fitted(stances) {
        return Some(horizon.max(highest).min(lowest));
    }
    let horizon = highest.min(lowest);
    notes.push(StandNote::HorizonAssumed { y: horizon });
    Some(horizon)
}

/// Where a line fitted to heights over ground points comes to nothing, by least squares.
fn fitted(stances: &[Stance]) -> Option<f32> {
    let n = stances.len() as f64;
    let mean = |of: fn(&Stance) -> f32| stances.iter().map(|s| f64::from(of(s))).sum::<f64>() / n;
    let (mean_y, mean_height) = (mean(|s| s.base.y), mean(|s| s.height));
    let (mut yy, mut yh, mut hh) = (0.0, 0.0, 0.0);
    for stance in stances {
        let y = f64::from(stance.base.y) - mean_y;
        let height = f64::from(stance.height) - mean_height;
        yy += y * y;
        yh += y * height;
        hh += height * height;
    }
    let correlation = yh / (yy * hh).sqrt();
    let tells = stances.len() >= FEW && correlation >= f64::from(TELLING);
    tells.then(|| (mean_y - mean_height * yy / yh) as f32).filter(|y| y.is_finite())
}

/// All on one line, a little off it.
fn on_a_line(stances: &[Stance], params: &StandParams, seed: Seed) -> Vec<Place> {
    let tallest = stances.iter().map(|stance| stance.height).fold(0.0, f32::max);
    let scale = params.silhouette.height / tallest;
    let (left, right) = range(stances.iter().map(|stance| stance.base.x));
    let mean = scale * (right - left) / stances.len().saturating_sub(1).max(1) as f32;
    let depth = seed.stream("depth");
    let place = |stance: &Stance| {
        let off = params.jitter * mean * (2.0 * depth.unit(stance.index as u64) - 1.0);
        let position = Vec3::new(scale * (stance.base.x - 0.5 * (left + right)), 0.0, off);
        Place { ground: Ground { base: stance.base, scale }, position }
    };
    stances.iter().map(place).collect()
}

fn range(values: impl Iterator<Item = f32>) -> (f32, f32) {
    values.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

fn median(values: impl Iterator<Item = f32>) -> f32 {
    let mut values: Vec<f32> = values.collect();
    values.sort_by(f32::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
