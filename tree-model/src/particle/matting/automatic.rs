//! A tree against sky, in one call.

use super::super::{Matte, Photo};
use super::alpha::alpha_of;
use super::colors::{Colors, working_size};
use super::natural::{NaturalParams, NaturalReport, natural};
use super::scene::Scene;
use super::sky::{LEAST_SHARE, Sky};
use super::trimap::{Level, Trimap};
use crate::error::{ModelError, Result};
use tree_core::Control;

/// How [`automatic`] works.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct AutoParams {
    /// How the alpha of the pixels left unknown is found.
    pub natural: NaturalParams,
}

impl AutoParams {
    /// Checks ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        self.natural.validate()
    }
}

/// What [`automatic`] found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AutoReport {
    /// Whether the photograph's own alpha was taken.
    pub has_alpha: bool,
    /// The trimap that was made, at its own size; none where the photograph has alpha.
    pub trimap: Option<Trimap>,
    /// Where the trunk meets the ground, in pixels of the photograph, where it was found.
    pub base: Option<glam::Vec2>,
    /// How sure the result is, 0 to 1: below 0.5 look at it before you use it.
    pub confidence: f32,
    /// What the matting did.
    pub natural: NaturalReport,
    /// What the result may suffer from.
    pub warnings: Vec<String>,
}

/// Longer side in pixels at which the scene is looked at: leaves vanish, branches are left.
const SCENE_SIDE: u32 = 400;

/// The matte of a photograph of a tree against sky; of one with alpha, its alpha.
///
/// # Errors
/// [`ModelError::Picture`] when nothing that could be a tree is found, or the photograph is fully
/// transparent; otherwise as [`natural`].
///
/// # Complexity
/// As [`natural`].
pub fn automatic(
    photo: &Photo,
    params: &AutoParams,
    control: &Control,
) -> Result<(Matte, AutoReport)> {
    params.validate()?;
    photo.check_limit(&control.limits)?;
    control.report("finding the tree", 0.0)?;
    if photo.has_alpha() {
        let report = AutoReport { has_alpha: true, confidence: 1.0, ..Default::default() };
        return Ok((alpha_of(photo)?, report));
    }
    let (width, height) = working_size(photo.width(), photo.height(), SCENE_SIDE);
    let colors = Colors::shrunk(photo, width, height);
    let sky = Sky::find(&colors);
    let nothing = || ModelError::Picture {
        problem: "no tree against sky was found; give a trimap, strokes or sampled colours".into(),
    };
    if sky.share < LEAST_SHARE {
        return Err(nothing());
    }
    let scene = Scene::find(&colors, &sky).ok_or_else(nothing)?;
    let levels = levels(&colors, &sky, &scene);
    let trimap = Trimap::new(width as u32, height as u32, levels)?;
    let (matte, natural) = natural(photo, &trimap, &params.natural, &control.part(0.1, 1.0))?;
    let report = AutoReport {
        has_alpha: false,
        base: None,
        confidence: 1.0,
        natural,
        warnings: Vec::new(),
        trimap: Some(trimap),
    };
    Ok((matte, report))
}

/// What is known of each pixel.
fn levels(colors: &Colors, sky: &Sky, scene: &Scene) -> Vec<Level> {
    /// Log likelihood ratio at which a neighbourhood is clear.
    const CLEAR: f32 = 2.0;
    let (w, h) = (colors.width, colors.height);
    let unlike = unlike(sky, scene, w);
    let mut levels = vec![Level::Unknown; w * h];
    for y in 0..h {
        for x in 0..w {
            let i = y * w + x;
            let beside = x < scene.left || x > scene.right;
            levels[i] = if beside || y > scene.base() {
                Level::Background
            } else if sky.is_sky(i) && y < scene.horizon[x] + h / 10 {
                Level::Background
            } else if y < scene.horizon[x] {
                if sky.difference[i] > unlike { Level::Foreground } else { Level::Unknown }
            } else if y > scene.crown_end {
                Level::Background
            } else if scene.ratio[i] > CLEAR {
                Level::Foreground
            } else if scene.ratio[i] < -CLEAR {
                Level::Background
            } else {
                Level::Unknown
            };
        }
    }
    let mut levels = narrowed(&levels, w, h);
    for (row, &(x, half)) in scene.trunk.iter().enumerate() {
        let y = scene.trunk_top + row;
        for column in x.saturating_sub(2 * half + 1)..=(x + 2 * half + 1).min(w - 1) {
            let level = &mut levels[y * w + column];
            if column.abs_diff(x) <= half / 2 {
                *level = Level::Foreground;
            } else if *level == Level::Background {
                *level = Level::Unknown;
            }
        }
    }
    levels
}

/// Difference to the sky from which on a pixel holds none of it: a share of the tree's median.
fn unlike(sky: &Sky, scene: &Scene, w: usize) -> f32 {
    /// The share: leaves in light and shade differ as much.
    const SHARE: f32 = 0.5;
    let tree = (0..sky.difference.len()).filter(|&i| {
        let (x, y) = (i % w, i / w);
        sky.is_not(i) && y < scene.horizon[x] && (scene.left..=scene.right).contains(&x)
    });
    let mut differences: Vec<f32> = tree.map(|i| sky.difference[i]).collect();
    let middle = differences.len() / 2;
    match differences.get(middle) {
        Some(_) => SHARE * *differences.select_nth_unstable_by(middle, f32::total_cmp).1,
        None => 0.0,
    }
}

/// Known pixels next to others become unknown.
fn narrowed(levels: &[Level], w: usize, h: usize) -> Vec<Level> {
    let same = |i: usize| {
        let (x, y) = (i % w, i / w);
        (y.saturating_sub(1)..(y + 2).min(h)).all(|row| {
            let around = &levels[row * w..][x.saturating_sub(1)..(x + 2).min(w)];
            around.iter().all(|&level| level == levels[i])
        })
    };
    (0..levels.len()).map(|i| if same(i) { levels[i] } else { Level::Unknown }).collect()
}
