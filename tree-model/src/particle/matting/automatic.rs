//! A tree against sky, in one call.
//!
//! Not in the thesis, whose trimaps are drawn by hand.
//!
//! 1. [`sky`](super::sky): what is smooth and connected to the top is sky; what differs from it is not.
//! 2. [`scene`](super::scene): the tree is the peak of the skyline nearest the middle, down to where it
//!    is lowest on both sides. Below this horizon, where trees, hedges and lawn stand behind it, colours
//!    decide: those of the crown above against those beside the tree in the same rows. A trunk is the
//!    path downwards of most contrast to both sides.
//! 3. Out of both comes a trimap, and [`natural`] does the rest.
//!
//! Cost: O(1) for the scene (it is looked at small), then as [`natural`].

use super::super::{Matte, Photo};
use super::alpha::alpha_of;
use super::colors::{Colors, working_size};
use super::natural::{NaturalParams, NaturalReport, natural};
use super::scene::{Scene, largest};
use super::sky::{LEAST_SHARE, Sky};
use super::trimap::{Level, Trimap};
use crate::error::{ModelError, Result};
use tree_core::Control;

/// How [`automatic`] works.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct AutomaticParams {
    /// How the alpha of the pixels left unknown is found.
    pub natural: NaturalParams,
}

impl AutomaticParams {
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
#[non_exhaustive]
pub struct AutomaticReport {
    /// Whether the photograph's own alpha was taken.
    pub has_alpha: bool,
    /// The trimap that was made, at a size of its own; none where the photograph has alpha.
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
/// [`ModelError::Picture`] when no sky or nothing that could be a tree is found, or the photograph is fully
/// transparent; otherwise as [`natural`].
///
/// # Complexity
/// As [`natural`].
pub fn automatic(
    photo: &Photo,
    params: &AutomaticParams,
    control: &Control,
) -> Result<(Matte, AutomaticReport)> {
    params.validate()?;
    photo.check_limit(&control.limits)?;
    control.report("finding the tree", 0.0)?;
    if photo.has_alpha() {
        let report = AutomaticReport { has_alpha: true, confidence: 1.0, ..Default::default() };
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
    let scale = photo.width() as f32 / width as f32;
    let mut report = AutomaticReport {
        base: scene.base_point().map(|base| scale * base),
        natural,
        ..AutomaticReport::default()
    };
    judge(&mut report, &trimap, &sky);
    report.trimap = Some(trimap);
    Ok((matte, report))
}

/// Fills in how sure the result is, and warns.
fn judge(report: &mut AutomaticReport, trimap: &Trimap, sky: &Sky) {
    /// Share of sky from which on it is as clear as can be.
    const MUCH_SKY: f32 = 0.1;
    /// Share of the tree's pixels that are known beforehand in a clear case.
    const MUCH_KNOWN: f32 = 0.5;
    /// What is left of the confidence when the tree is cut off at the border.
    const CUT_OFF: f32 = 0.8;
    /// The same without a trunk.
    const NO_TRUNK: f32 = 0.8;
    let known = trimap.count(Level::Foreground) as f32;
    let known = known / (known + trimap.count(Level::Unknown) as f32).max(1.0);
    report.confidence = (sky.share / MUCH_SKY).min(1.0) * (known / MUCH_KNOWN).min(1.0);
    report.warnings = report.natural.warnings.clone();
    let (w, h) = (trimap.width() as usize, trimap.height() as usize);
    let tree = |i: usize| trimap.levels()[i] != Level::Background;
    if (0..w).any(tree) || (0..h).any(|y| tree(y * w) || tree(y * w + w - 1)) {
        report.confidence *= CUT_OFF;
        report.warnings.push("the tree touches the picture's border".into());
    }
    if report.base.is_none() {
        report.confidence *= NO_TRUNK;
        report.warnings.push("no trunk was found below the crown".into());
    }
    if report.confidence < 0.5 {
        report.warnings.push(format!(
            "low confidence ({:.2}): look at the matte, or give a trimap or strokes",
            report.confidence
        ));
    }
}

/// What is known of each pixel.
fn levels(colors: &Colors, sky: &Sky, scene: &Scene) -> Vec<Level> {
    /// Log likelihood ratio at which a neighbourhood is clear.
    const CLEAR: f32 = 2.0;
    /// The picture's height over how far below the horizon there may still be sky: it is a guess.
    const HAZE: usize = 10;
    let (w, h) = (colors.width, colors.height);
    let unlike = unlike(sky, scene, w);
    let mut levels = vec![Level::Unknown; w * h];
    for (i, level) in levels.iter_mut().enumerate() {
        let (x, y) = (i % w, i / w);
        let beside = x < scene.left || x > scene.right || y > scene.base();
        let gap = sky.is_sky(i) && y < scene.horizon[x] + h / HAZE;
        *level = match () {
            () if beside || gap => Level::Background,
            () if y < scene.horizon[x] && sky.difference[i] > unlike => Level::Foreground,
            () if y < scene.horizon[x] => Level::Unknown,
            () if y > scene.crown_end || scene.ratio[i] < -CLEAR => Level::Background,
            () if scene.ratio[i] > CLEAR => Level::Foreground,
            () => Level::Unknown,
        };
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
    // What hangs together with nothing, such as bits of clouds, is not the tree.
    let maybe: Vec<bool> = levels.iter().map(|&level| level != Level::Background).collect();
    for (level, kept) in levels.iter_mut().zip(largest(&maybe, w, h)) {
        if !kept {
            *level = Level::Background;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A round crown on a trunk, before a blue gradient above a lawn of noise.
    fn scene() -> (Photo, Vec<bool>) {
        let (w, h) = (160_u32, 200_u32);
        let mut state = 1_u32;
        let mut noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8 / 8
        };
        let mut pixels = Vec::new();
        let mut tree = Vec::new();
        for y in 0..h {
            for x in 0..w {
                let (dx, dy) = (i64::from(x) - 80, i64::from(y) - 75);
                let crown = dx * dx + dy * dy < 50 * 50;
                let trunk = dx.abs() < 5 && (110..175).contains(&y);
                let n = noise();
                pixels.push(match () {
                    () if crown => [40 + n, 70 + 2 * n, 20 + n, 255],
                    () if trunk => [60 + n / 2, 45 + n / 2, 35, 255],
                    () if y < 150 => [120 + (y / 4) as u8, 160 + (y / 4) as u8, 235, 255],
                    () => [120 + n, 165 + n, 80 + n, 255],
                });
                tree.push(crown || trunk);
            }
        }
        (Photo::new(w, h, pixels).unwrap(), tree)
    }

    #[test]
    fn a_tree_before_sky_and_lawn_is_found() {
        let (photo, tree) = scene();
        let (matte, report) = automatic(&photo, &Default::default(), &Default::default()).unwrap();
        let wrong = matte.alpha().iter().zip(&tree).filter(|(a, t)| (**a > 0.5) != **t).count();
        assert!(wrong < tree.len() / 100, "{wrong} of {} pixels are wrong", tree.len());
        let base = report.base.unwrap();
        assert!((base - glam::Vec2::new(80.0, 175.0)).length() < 8.0, "{base}");
        assert!(report.confidence > 0.5 && report.warnings.is_empty(), "{report:?}");
    }

    #[test]
    fn alpha_is_taken_where_there_is_some() {
        let photo = Photo::new(2, 1, vec![[1, 2, 3, 255], [1, 2, 3, 0]]).unwrap();
        let (matte, report) = automatic(&photo, &Default::default(), &Default::default()).unwrap();
        assert_eq!(matte.alpha(), [1.0, 0.0]);
        assert!(report.has_alpha);
    }

    #[test]
    fn pictures_of_nothing_are_refused() {
        let noise = |i: u32| (i.wrapping_mul(2_654_435_761) >> 24) as u8;
        for (w, h) in [(1, 1), (2, 3), (40, 1), (1, 40), (64, 64)] {
            let flat = vec![[128, 128, 200, 255]; (w * h) as usize];
            let rough = (0..w * h).map(|i| [noise(i), noise(i + 7), noise(i + 31), 255]).collect();
            for pixels in [flat, rough] {
                let photo = Photo::new(w, h, pixels).unwrap();
                let error = automatic(&photo, &Default::default(), &Default::default());
                assert!(matches!(error, Err(ModelError::Picture { .. })), "{w} × {h}: {error:?}");
            }
        }
    }
}
