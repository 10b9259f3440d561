//! Alpha of a photograph with a trimap: closed-form matting (Levin, Lischinski and Weiss 2008).
//!
//! 1. The photograph is shrunk to working size.
//! 2. Unknown pixels that clearly look like one side are marked ([`palette`](super::palette)); not in the
//!    paper, it makes up for strokes that know little.
//! 3. The matting Laplacian's quadratic form is minimised over the unknown pixels, from coarse to fine:
//!    each size starts from the one below, so that few iterations are left. (The paper coarsens too, but
//!    then solves at full size only where alpha is not clear.)
//! 4. Alpha is brought to full size by its local linear model ([`blend`](super::blend)).
//!
//! Cost: O(pixels) for the photograph, O(working pixels · iterations) for the solution.

use super::super::{Matte, Photo};
use super::blend::{between, to_full_size};
use super::colors::{Colors, working_size};
use super::laplacian::{Laplacian, Layout};
use super::palette::mark_clear;
use super::solve::{Solved, Stop, solve};
use super::trimap::{Level, Trimap};
use crate::error::{ModelError, Result, check};
use tree_core::Control;

/// How [`natural`] works.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct NaturalParams {
    /// Longer side in pixels at which alpha is solved for, 16 to 4096. Default 768. Cost and memory grow
    /// with its square.
    pub max_side: u32,
    /// How far alpha may depart from a linear function of colour within a window, 1e-9 to 1: a variance
    /// of colours 0 to 1. Low keeps fine structure, high is smooth. Default
    /// 1e-7, as in the paper.
    pub epsilon: f32,
    /// Share of the right side's size at which the solution is good enough, 1e-8 to 0.1. Default 2e-4.
    pub tolerance: f32,
    /// Most iterations at each size, 1 to 100,000. Default 400.
    pub max_iterations: u32,
    /// Whether unknown pixels that clearly look like the known ones of one side count as known. Default
    /// true; helps strokes much, full trimaps a little.
    pub mark_clear: bool,
}

impl Default for NaturalParams {
    fn default() -> Self {
        Self {
            max_side: 768,
            epsilon: 1e-7,
            tolerance: 2e-4,
            max_iterations: 400,
            mark_clear: true,
        }
    }
}

impl NaturalParams {
    /// Checks ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check("max_side", self.max_side, 16, 4096)?;
        check("epsilon", self.epsilon, 1e-9_f32, 1.0_f32)?;
        check("tolerance", self.tolerance, 1e-8_f32, 0.1_f32)?;
        check("max_iterations", self.max_iterations, 1, 100_000)
    }
}

/// What [`natural`] did.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct NaturalReport {
    /// Width and height at which alpha was solved for, in pixels.
    pub size: [u32; 2],
    /// Pixels at that size that the trimap leaves unknown.
    pub n_unknown: u64,
    /// Of them, pixels marked by their colour.
    pub n_marked: u64,
    /// Iterations at that size; coarser ones cost little.
    pub iterations: u32,
    /// What is left of the right side, as a share.
    pub residual: f32,
    /// What the result may suffer from.
    pub warnings: Vec<String>,
}

/// Coarsening ends at this longer side: a few milliseconds of solving.
const COARSEST_SIDE: usize = 48;
/// Residual above which the report warns.
const POOR_RESIDUAL: f32 = 0.05;
/// Share of known pixels below which the report warns.
const FEW_KNOWN: f64 = 0.005;

/// The matte of a photograph of which a trimap is known.
///
/// A trimap of another size is sampled when its proportions agree within 2 %. Known pixels keep their
/// alpha. An alpha channel of the photograph is ignored.
///
/// # Errors
/// [`ModelError::Parameter`]; [`ModelError::Picture`] when the trimap does not fit, or knows no tree or
/// no background; [`ModelError::Limit`] for a photograph above [`Limits::pixels`](tree_core::Limits);
/// [`ModelError::Cancelled`].
///
/// # Complexity
/// O(pixels + working pixels · iterations); 90 bytes for each working pixel, 4 for each pixel.
pub fn natural(
    photo: &Photo,
    trimap: &Trimap,
    params: &NaturalParams,
    control: &Control,
) -> Result<(Matte, NaturalReport)> {
    params.validate()?;
    photo.check_limit(&control.limits)?;
    trimap.check_fits(photo.width(), photo.height())?;
    for (level, side) in [(Level::Foreground, "tree"), (Level::Background, "background")] {
        if !trimap.levels().contains(&level) {
            let problem = format!("the trimap marks no {side}; mark at least a few of its pixels");
            return Err(ModelError::Picture { problem });
        }
    }
    control.report("matting", 0.0)?;
    let (width, height) = working_size(photo.width(), photo.height(), params.max_side);
    let colors = Colors::shrunk(photo, width, height);
    let mut levels = Vec::with_capacity(width * height);
    for y in 0..height {
        levels.extend((0..width).map(|x| trimap.under(x, y, width, height)));
    }
    let n_unknown = levels.iter().filter(|&&level| level == Level::Unknown).count();
    let n_marked = if params.mark_clear { mark_clear(&colors, &mut levels) } else { 0 };
    control.report("matting", 0.1)?;
    let known = Known::new(&levels);
    let (alpha, solved) = coarse_to_fine(&colors, &known, params, &control.part(0.1, 0.9))?;
    let alpha = to_full_size(photo, trimap, &colors, &alpha);
    control.report("matting", 1.0)?;
    let report = NaturalReport {
        size: [width as u32, height as u32],
        n_unknown: n_unknown as u64,
        n_marked: n_marked as u64,
        iterations: solved.iterations,
        residual: solved.residual,
        warnings: warnings(n_unknown, levels.len(), &solved),
    };
    Ok((Matte::new(photo.width(), photo.height(), alpha)?, report))
}

fn warnings(n_unknown: usize, n: usize, solved: &Solved) -> Vec<String> {
    let mut warnings = Vec::new();
    let known = 1.0 - n_unknown as f64 / n as f64;
    if known < FEW_KNOWN {
        warnings.push(format!("only {:.2} % of the pixels are known", 100.0 * known));
    }
    if solved.residual > POOR_RESIDUAL {
        warnings.push(format!(
            "the solution is rough: {:.1} % of the right side is left after {} iterations",
            100.0 * solved.residual,
            solved.iterations
        ));
    }
    warnings
}

/// What is known at one size: alpha and how much of the pixel it is known for (0 or 1).
struct Known {
    alpha: Vec<f32>,
    known: Vec<bool>,
}

/// Solves at a small size, then at twice that, up to the size of `colors`.
fn coarse_to_fine(
    colors: &Colors,
    known: &Known,
    params: &NaturalParams,
    control: &Control,
) -> Result<(Vec<f32>, Solved)> {
    let (mut guess, width, height) = if colors.width.max(colors.height) > COARSEST_SIDE {
        let coarse = colors.halved();
        let known = known.halved(colors.width, colors.height);
        let (guess, _) = coarse_to_fine(&coarse, &known, params, &control.part(0.0, 0.25))?;
        (guess, coarse.width, coarse.height)
    } else {
        (vec![0.5], 1, 1)
    };
    guess = enlarged(&guess, width, height, colors);
    let solved = solve_at(colors, known, &mut guess, params, control)?;
    control.report("matting", 1.0)?;
    Ok((guess, solved))
}

impl Known {
    fn new(levels: &[Level]) -> Self {
        Self {
            alpha: levels.iter().map(|&l| f32::from(u8::from(l == Level::Foreground))).collect(),
            known: levels.iter().map(|&level| level != Level::Unknown).collect(),
        }
    }

    /// The same at half the size: known where half of the pixels are.
    fn halved(&self, from_width: usize, from_height: usize) -> Self {
        let (width, height) = ((from_width / 2).max(1), (from_height / 2).max(1));
        let (mut alpha, mut known) = (Vec::new(), Vec::new());
        for y in 0..height {
            for x in 0..width {
                let (mut sum, mut n) = (0.0, 0.0);
                for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                    let column = (2 * x + dx).min(from_width - 1);
                    let i = (2 * y + dy).min(from_height - 1) * from_width + column;
                    if self.known[i] {
                        sum += self.alpha[i];
                        n += 1.0;
                    }
                }
                known.push(n >= 2.0);
                alpha.push(if n > 0.0 { sum / n } else { 0.0 });
            }
        }
        Self { alpha, known }
    }
}

/// A picture of numbers at the size of `colors`, between pixel centres.
fn enlarged(values: &[f32], width: usize, height: usize, colors: &Colors) -> Vec<f32> {
    let mut out = Vec::with_capacity(colors.rgb.len());
    for y in 0..colors.height {
        let (top, bottom, down) = between(y, colors.height, height);
        for x in 0..colors.width {
            let (left, right, across) = between(x, colors.width, width);
            let row = |y: usize| {
                let (a, b) = (values[y * width + left], values[y * width + right]);
                a + across * (b - a)
            };
            let (a, b) = (row(top), row(bottom));
            out.push(a + down * (b - a));
        }
    }
    out
}

/// Solves at one size, from and into `guess`.
fn solve_at(
    colors: &Colors,
    known: &Known,
    guess: &mut [f32],
    params: &NaturalParams,
    control: &Control,
) -> Result<Solved> {
    let layout = Layout { width: colors.width, height: colors.height };
    let (mut alpha, mut unknown) = (vec![0.0; layout.len()], vec![0.0; layout.len()]);
    for y in 0..layout.height {
        for x in 0..layout.width {
            let (i, at) = (y * layout.width + x, layout.index(x, y));
            alpha[at] = if known.known[i] { known.alpha[i] } else { guess[i] };
            unknown[at] = f32::from(u8::from(!known.known[i]));
        }
    }
    let laplacian = Laplacian::new(colors, &unknown, params.epsilon);
    let stop = Stop { tolerance: params.tolerance, max_iterations: params.max_iterations };
    let solved = solve(&laplacian, &unknown, &mut alpha, stop, control)?;
    for y in 0..layout.height {
        for x in 0..layout.width {
            guess[y * layout.width + x] = alpha[layout.index(x, y)].clamp(0.0, 1.0);
        }
    }
    Ok(solved)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Leaves (dots of soft edge) over a gradient: photograph, trimap and true alpha.
    fn leafy(w: u32, h: u32) -> (Photo, Trimap, Vec<f32>) {
        let (mut pixels, mut levels, mut truth) = (Vec::new(), Vec::new(), Vec::new());
        for y in 0..h {
            for x in 0..w {
                let (u, v) = (x as f32 / w as f32, y as f32 / h as f32);
                let wave = libm::sinf(40.0 * u + 3.0 * v) * libm::sinf(37.0 * v - 5.0 * u);
                let from_middle = ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)).sqrt();
                let leaves = (2.0 + 3.0 * wave - 12.0 * (from_middle - 0.2)).clamp(0.0, 1.0);
                let alpha = if from_middle < 0.1 { 1.0 } else { leaves };
                let shade = 0.8 + 0.2 * libm::sinf(23.0 * u + 31.0 * v);
                let (tree, sky) = ([0.25, 0.4, 0.12], [0.5 + 0.3 * v, 0.65 + 0.2 * v, 0.95]);
                let mix =
                    |k: usize| 255.0 * (alpha * shade * tree[k] + (1.0 - alpha) * sky[k]) + 0.5;
                pixels.push([mix(0) as u8, mix(1) as u8, mix(2) as u8, 255]);
                levels.push(match from_middle {
                    d if d < 0.1 => Level::Foreground,
                    d if d > 0.45 && alpha == 0.0 => Level::Background,
                    _ => Level::Unknown,
                });
                truth.push(alpha);
            }
        }
        (Photo::new(w, h, pixels).unwrap(), Trimap::new(w, h, levels).unwrap(), truth)
    }

    fn error(matte: &Matte, trimap: &Trimap, truth: &[f32]) -> f32 {
        let unknown = (0..truth.len()).filter(|&i| trimap.levels()[i] == Level::Unknown);
        let errors: Vec<f32> = unknown.map(|i| (matte.alpha()[i] - truth[i]).abs()).collect();
        errors.iter().sum::<f32>() / errors.len() as f32
    }

    #[test]
    fn leaves_over_a_gradient_come_out() {
        let (photo, trimap, truth) = leafy(120, 100);
        for (mark_clear, bound) in [(false, 0.1), (true, 0.06)] {
            let params = NaturalParams { mark_clear, ..Default::default() };
            let (matte, report) = natural(&photo, &trimap, &params, &Control::default()).unwrap();
            let error = error(&matte, &trimap, &truth);
            assert!(error < bound, "{error}, {report:?}");
            assert!(report.residual < 1e-3 && report.warnings.is_empty(), "{report:?}");
        }
    }

    #[test]
    fn a_smaller_working_size_costs_little() {
        let (photo, trimap, truth) = leafy(240, 200);
        let params = NaturalParams { max_side: 120, ..Default::default() };
        let (matte, report) = natural(&photo, &trimap, &params, &Control::default()).unwrap();
        assert_eq!(report.size, [120, 100]);
        let error = error(&matte, &trimap, &truth);
        assert!(error < 0.07, "{error}");
    }

    #[test]
    fn known_pixels_stay_known() {
        let (photo, trimap, _) = leafy(60, 50);
        let params = NaturalParams { max_side: 32, ..Default::default() };
        let (matte, _) = natural(&photo, &trimap, &params, &Control::default()).unwrap();
        for (alpha, level) in matte.alpha().iter().zip(trimap.levels()) {
            match level {
                Level::Background => assert_eq!(*alpha, 0.0),
                Level::Foreground => assert_eq!(*alpha, 1.0),
                Level::Unknown => {}
            }
        }
    }

    #[test]
    fn the_same_bits_on_any_number_of_threads() {
        let (photo, trimap, _) = leafy(100, 90);
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                natural(&photo, &trimap, &Default::default(), &Control::default()).unwrap()
            })
        };
        assert_eq!(run(1), run(3));
    }

    #[test]
    fn a_trimap_of_another_shape_or_of_one_side_is_refused() {
        let (photo, trimap, _) = leafy(60, 50);
        let half = Trimap::new(30, 25, trimap.levels()[..750].to_vec()).unwrap();
        let run =
            |trimap: &Trimap| natural(&photo, trimap, &Default::default(), &Control::default());
        let error = run(&half).unwrap_err();
        assert!(error.to_string().contains("marks no tree"), "{error}");
        let square = Trimap::new(50, 50, trimap.levels()[..2500].to_vec()).unwrap();
        assert!(matches!(run(&square), Err(ModelError::Picture { .. })));
        let mut small = Control::default();
        small.limits.pixels = 100;
        let error = natural(&photo, &trimap, &Default::default(), &small).unwrap_err();
        assert!(matches!(error, ModelError::Limit(_)), "{error}");
    }

    #[test]
    fn pictures_too_small_for_a_window_give_something() {
        let photo = Photo::new(3, 1, vec![[0, 0, 0, 255], [9, 9, 9, 255], [255; 4]]).unwrap();
        let levels = vec![Level::Background, Level::Unknown, Level::Foreground];
        let trimap = Trimap::new(3, 1, levels).unwrap();
        let (matte, _) =
            natural(&photo, &trimap, &Default::default(), &Control::default()).unwrap();
        assert_eq!((matte.alpha()[0], matte.alpha()[2]), (0.0, 1.0));
    }
}
