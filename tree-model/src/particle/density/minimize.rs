//! Least squares without negative values: MPRGP, conjugate gradients with a bound (Dostál, *Optimal
//! Quadratic Programming Algorithms*, 2009, algorithm 5.8).
//!
//! Conjugate gradients run in the values that are free, above 0. A step that would go below ends at the
//! bound, and a projected gradient step then fixes many values there at once. Values at the bound are let
//! go when what they would gain outweighs what the free ones have left to gain.
//!
//! The unknowns are x = W y, so that the Hessian is H = W Aᵀ A W + λ² I. All that the rays cannot tell
//! apart has the one eigenvalue λ², which conjugate gradients settle in one step. Scaling by the
//! diagonal (Jacobi) pulls that eigenvalue apart; it took more iterations to the same stopping rule in the
//! cases tried.
//!
//! H ≥ λ² I also tells when to stop: the distance to the solution is at most ‖projected gradient‖ / λ².

use super::system::Equations;
use crate::error::Result;
use rayon::prelude::*;
use tree_core::Control;

/// Numbers added up by one thread, so that sums are the same for any number of threads.
const CHUNK: usize = 4096;
/// Γ: values at the bound are let go when their gain is more than this beside that of free ones.
const PROPORTION: f64 = 1.0;
/// The projected step as a share of 2/‖H‖, the longest that surely goes down.
const STEP: f32 = 0.95;

/// What the minimisation came to.
pub(super) struct Minimum {
    /// x ≥ 0, for each voxel.
    pub(super) x: Vec<f32>,
    pub(super) n_iterations: u32,
    pub(super) converged: bool,
}

/// ½ yᵀ H y − fᵀ y with x = W y.
struct Problem<'a> {
    system: &'a Equations,
    on_rays: Vec<f32>,
    on_voxels: Vec<f32>,
}

/// Minimises ‖A x − b‖² + λ² ‖W⁻¹ x‖² over x ≥ 0.
pub(super) fn minimize(
    system: &Equations,
    n_most: u32,
    tolerance: f32,
    control: &Control,
) -> Result<Minimum> {
    let n = system.n_voxels();
    let mut problem = Problem::new(system);
    let mut f = vec![0.0; n];
    system.turned.times(system.targets(), &mut f);
    f.par_iter_mut().zip(system.weights()).for_each(|(f, w)| *f *= w);
    let mut y = vec![0.0_f32; n];
    // The gradient for each unit of distance to the solution.
    let steepness = f64::from(system.lambda() * system.lambda());
    let mut g: Vec<f32> = f.iter().map(|f| -f).collect();
    let longest = STEP * 2.0 / problem.norm();
    let mut p = free_gradient(&y, &g);
    let mut h_p = vec![0.0; n];
    let mut n_iterations = 0;
    let mut converged = false;
    while n_iterations < n_most {
        control.report("density", n_iterations as f32 / n_most as f32)?;
        let gain = Gain::of(&y, &g, longest);
        converged = gain.total.sqrt() <= f64::from(tolerance) * steepness * dot(&y, &y).sqrt();
        if converged {
            break;
        }
        n_iterations += 1;
        if gain.chopped > PROPORTION * PROPORTION * gain.reduced {
            let down = chopped_gradient(&y, &g);
            problem.apply(&down, &mut h_p);
            let step = step_along(&g, &down, &h_p);
            advance(&mut y, &down, -step);
            advance(&mut g, &h_p, -step);
            clamp(&mut y);
            p = free_gradient(&y, &g);
            continue;
        }
        problem.apply(&p, &mut h_p);
        let step = step_along(&g, &p, &h_p);
        let feasible = farthest(&y, &p);
        if step <= feasible {
            advance(&mut y, &p, -step);
            advance(&mut g, &h_p, -step);
            clamp(&mut y);
            let free = free_gradient(&y, &g);
            let along = dot(&p, &h_p);
            let back = if along > 0.0 { (dot(&free, &h_p) / along) as f32 } else { 0.0 };
            p.par_iter_mut().zip(&free).for_each(|(p, free)| *p = free - back * *p);
        } else {
            advance(&mut y, &p, -feasible);
            advance(&mut g, &h_p, -feasible);
            clamp(&mut y);
            let free = free_gradient(&y, &g);
            advance(&mut y, &free, -longest);
            clamp(&mut y);
            problem.apply(&y, &mut g);
            advance(&mut g, &f, -1.0);
            p = free_gradient(&y, &g);
        }
    }
    y.par_iter_mut().zip(system.weights()).for_each(|(y, w)| *y *= w);
    Ok(Minimum { x: y, n_iterations, converged })
}

impl<'a> Problem<'a> {
    fn new(system: &'a Equations) -> Self {
        let (on_rays, on_voxels) = (vec![0.0; system.n_rays()], vec![0.0; system.n_voxels()]);
        Self { system, on_rays, on_voxels }
    }

    /// `to` = H × `from`.
    fn apply(&mut self, from: &[f32], to: &mut [f32]) {
        let Self { system, on_rays, on_voxels } = self;
        let weights = system.weights();
        let ridge = system.lambda() * system.lambda();
        on_voxels.par_iter_mut().zip(from).zip(weights).for_each(|((x, y), w)| *x = w * y);
        system.rows.times(on_voxels, on_rays);
        system.turned.times(on_rays, to);
        (to.par_iter_mut().zip(from).zip(weights))
            .for_each(|((to, y), w)| *to = *to * w + ridge * y);
    }

    /// At least ‖H‖: its largest row sum, as no entry is negative.
    fn norm(&mut self) -> f32 {
        let n = self.system.n_voxels();
        let (ones, mut sums) = (vec![1.0; n], vec![0.0; n]);
        self.apply(&ones, &mut sums);
        sums.into_iter().fold(f32::MIN_POSITIVE, f32::max)
    }
}

/// How much there is to gain: squared lengths of the gradient's parts.
#[derive(Clone, Copy, Debug, Default)]
struct Gain {
    /// Of values at the bound that want to rise.
    chopped: f64,
    /// Of free values, no more than a step of `longest` can use.
    reduced: f64,
    /// Of both, in full.
    total: f64,
}

impl Gain {
    fn of(y: &[f32], g: &[f32], longest: f32) -> Self {
        let parts: Vec<Self> = y
            .par_chunks(CHUNK)
            .zip(g.par_chunks(CHUNK))
            .map(|(y, g)| {
                let mut part = Self::default();
                for (&y, &g) in y.iter().zip(g) {
                    let square = f64::from(g) * f64::from(g);
                    if y > 0.0 {
                        part.reduced += f64::from((y / longest).min(g)) * f64::from(g);
                        part.total += square;
                    } else if g < 0.0 {
                        part.chopped += square;
                        part.total += square;
                    }
                }
                part
            })
            .collect();
        parts.iter().fold(Self::default(), |sum, part| Self {
            chopped: sum.chopped + part.chopped,
            reduced: sum.reduced + part.reduced,
            total: sum.total + part.total,
        })
    }
}

fn free_gradient(y: &[f32], g: &[f32]) -> Vec<f32> {
    y.par_iter().zip(g).map(|(&y, &g)| if y > 0.0 { g } else { 0.0 }).collect()
}

fn chopped_gradient(y: &[f32], g: &[f32]) -> Vec<f32> {
    y.par_iter().zip(g).map(|(&y, &g)| if y > 0.0 { 0.0 } else { g.min(0.0) }).collect()
}

/// The step against `p` that goes down farthest.
fn step_along(g: &[f32], p: &[f32], h_p: &[f32]) -> f32 {
    let curvature = dot(p, h_p);
    if curvature > 0.0 { (dot(g, p) / curvature) as f32 } else { 0.0 }
}

/// The longest step against `p` that leaves no value negative.
fn farthest(y: &[f32], p: &[f32]) -> f32 {
    y.par_iter()
        .zip(p)
        .map(|(&y, &p)| if p > 0.0 { y / p } else { f32::MAX })
        .reduce(|| f32::MAX, f32::min)
}

fn advance(values: &mut [f32], along: &[f32], step: f32) {
    values.par_iter_mut().zip(along).for_each(|(value, along)| *value += step * along);
}

fn clamp(values: &mut [f32]) {
    values.par_iter_mut().for_each(|value| *value = value.max(0.0));
}

fn dot(a: &[f32], b: &[f32]) -> f64 {
    let parts: Vec<f64> = a
        .par_chunks(CHUNK)
        .zip(b.par_chunks(CHUNK))
        .map(|(a, b)| a.iter().zip(b).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum())
        .collect();
    parts.iter().sum()
}
