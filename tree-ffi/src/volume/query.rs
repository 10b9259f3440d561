//! What a volume answers.

use super::tree_volume;
use crate::border::{
    Failure, Result, TREE_ERROR_NO_RESULT, call, fill, get, out_value, tree_status, vec3s,
};
use crate::control::{limits, run, tree_control};
use glam::Vec3;
use rayon::prelude::*;
use tree_model::tree_core::{Control, Resource, Rng, Seed, Volume};

/// Steps of questions between looks at the control.
const STEPS: u64 = 4096;

/// Points that one thread answers for between looks at the control.
fn chunk(volume: &Volume) -> usize {
    (STEPS / volume.cost()).max(1) as usize
}

/// Asks `volume` about every point; about many in parallel.
unsafe fn ask<R: Copy + Default + Send>(
    volume: *const tree_volume,
    points: *const f32,
    n: usize,
    control: *const tree_control,
    answer: impl Fn(&Volume, Vec3) -> R + Sync,
) -> Result<Vec<R>> {
    let volume = unsafe { get(volume, "volume") }?.rust();
    let limits = unsafe { limits(control) }?;
    let points = unsafe { vec3s(points, n, &limits, Resource::Nodes, "points") }?;
    let (answer, chunk) = (&answer, chunk(volume));
    let body = |control: &Control| {
        let mut answers = vec![R::default(); points.len()];
        let answer_chunk = |(answers, points): (&mut [R], &[Vec3])| {
            control.check()?;
            for (place, &point) in answers.iter_mut().zip(points) {
                *place = answer(volume, point);
            }
            Ok::<_, Failure>(())
        };
        // A few points are not worth waking other threads.
        if points.len() <= chunk {
            answer_chunk((&mut answers, points))?;
        } else {
            let chunks = answers.par_chunks_mut(chunk).zip(points.par_chunks(chunk));
            chunks.try_for_each(answer_chunk)?;
        }
        Ok(answers)
    };
    unsafe { run(control, body) }
}

/// Says of `n_points` points, three floats each, whether they lie inside: 1 or 0 into `inside`, which has
/// room for as many. 0 for points that are not finite. `control` may be NULL; `nodes` of its limits caps
/// the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_contains(
    volume: *const tree_volume,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    inside: *mut u8,
) -> tree_status {
    call(|| {
        let contains = |volume: &Volume, point| u8::from(volume.contains(point));
        let answers = unsafe { ask(volume, points, n_points, control, contains) }?;
        unsafe { fill_some(inside, &answers, "inside") }
    })
}

/// Writes the signed distance of `n_points` points, three floats each, from the surface into `distances`,
/// which has room for as many: metres, negative inside, NaN for points that are not finite. It is exact,
/// or never too long and of the right sign; see `tree_volume_distance_is_exact`. `control` as for
/// `tree_volume_contains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_distance(
    volume: *const tree_volume,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    distances: *mut f32,
) -> tree_status {
    call(|| {
        let distance = |volume: &Volume, point| volume.distance(point).unwrap_or(f32::NAN);
        let answers = unsafe { ask(volume, points, n_points, control, distance) }?;
        unsafe { fill_some(distances, &answers, "distances") }
    })
}

/// As [`fill`]; for no values there need be no buffer.
unsafe fn fill_some<T: Copy>(first: *mut T, values: &[T], argument: &str) -> Result<()> {
    if values.is_empty() {
        return Ok(());
    }
    unsafe { fill(first, values.len(), values, argument) }
}

/// Whether `tree_volume_distance` is exact everywhere, 1 or 0: 1 for plain solids, turned, moved and
/// uniformly scaled or not, 0 for combinations.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_distance_is_exact(
    volume: *const tree_volume,
    is_exact: *mut u32,
) -> tree_status {
    call(|| {
        let answer = unsafe { get(volume, "volume") }?.rust().distance_is_exact();
        unsafe { out_value(is_exact, u32::from(answer), "is_exact") }
    })
}

/// A box around the volume: its lower corner, then its upper one, in metres. The smallest for plain
/// solids, else not always. Infinite for half-spaces; lower above upper where it is empty.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_bounds(
    volume: *const tree_volume,
    min_max: *mut [f32; 6],
) -> tree_status {
    call(|| {
        let bounds = unsafe { get(volume, "volume") }?.rust().bounds();
        let [a, b] = [bounds.min, bounds.max];
        unsafe { out_value(min_max, [a.x, a.y, a.z, b.x, b.y, b.z], "min_max") }
    })
}

/// Whether the bounds are finite, 1 or 0, so that the volume can be sampled and trees can grow in it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_is_bounded(
    volume: *const tree_volume,
    is_bounded: *mut u32,
) -> tree_status {
    call(|| {
        let answer = unsafe { get(volume, "volume") }?.rust().is_bounded();
        unsafe { out_value(is_bounded, u32::from(answer), "is_bounded") }
    })
}

/// Cubic metres inside, where there is a closed form: for all plain solids but half-spaces, and these
/// transformed. Otherwise NaN; then there is `tree_volume_estimate_measure`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_measure(
    volume: *const tree_volume,
    measure: *mut f32,
) -> tree_status {
    call(|| {
        let answer = unsafe { get(volume, "volume") }?.rust().measure();
        unsafe { out_value(measure, answer.unwrap_or(f32::NAN), "measure") }
    })
}

/// Cubic metres inside by sampling about `n_samples` points: the same in every run; the error falls a
/// little faster than 1 / sqrt(`n_samples`). Infinite when the bounds are, 0 when they are empty. 20,000
/// samples take some milliseconds.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_estimate_measure(
    volume: *const tree_volume,
    n_samples: u32,
    control: *const tree_control,
    measure: *mut f32,
) -> tree_status {
    call(|| {
        let volume = unsafe { get(volume, "volume") }?.rust();
        let answer =
            unsafe { run(control, |control| Ok(volume.estimate_measure(n_samples, control)?)) }?;
        unsafe { out_value(measure, answer, "measure") }
    })
}

/// Writes `n_points` random points, uniform in the volume, three floats each, into `points`. The same
/// `seed` gives the same points. For each at most `attempts` points of the bounds are drawn; 64 do for
/// any plain solid but very narrow ones. `TREE_ERROR_NO_RESULT`, and nothing is written, when none of them
/// lay inside, or the bounds are infinite or empty. `control` as for `tree_volume_contains`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_volume_sample(
    volume: *const tree_volume,
    n_points: usize,
    attempts: u32,
    seed: u64,
    control: *const tree_control,
    points: *mut f32,
) -> tree_status {
    call(|| {
        let volume = unsafe { get(volume, "volume") }?.rust();
        unsafe { limits(control) }?.check(Resource::Nodes, n_points as u64)?;
        let body = |control: &Control| draw(volume, n_points, attempts, seed, control);
        let drawn = unsafe { run(control, body) }?;
        unsafe { fill_some(points.cast::<[f32; 3]>(), &drawn, "points") }
    })
}

fn draw(
    volume: &Volume,
    n_points: usize,
    attempts: u32,
    seed: u64,
    control: &Control,
) -> Result<Vec<[f32; 3]>> {
    let mut rng = Seed(seed).rng();
    (0..n_points)
        .map(|i| {
            let point = draw_one(volume, attempts, &mut rng, control)?.ok_or_else(|| {
                let text = format!(
                    "points[{i}]: none of {attempts} attempts lay inside; does the volume have an \
                     end and an inside?"
                );
                Failure::new(TREE_ERROR_NO_RESULT, text)
            })?;
            Ok(point.to_array())
        })
        .collect()
}

/// As [`Volume::sample`], with looks at the control: attempts in parts are the same as in one go.
fn draw_one(
    volume: &Volume,
    attempts: u32,
    rng: &mut Rng,
    control: &Control,
) -> Result<Option<Vec3>> {
    let bounds = volume.bounds();
    control.check()?;
    if bounds.is_empty() || !bounds.is_finite() {
        return Ok(None);
    }
    let mut left = attempts;
    while left > 0 {
        let now = left.min(chunk(volume) as u32);
        if let Some(point) = volume.sample(rng, now) {
            return Ok(Some(point));
        }
        control.check()?;
        left -= now;
    }
    Ok(None)
}
