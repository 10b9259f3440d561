//! What a step of livewire costs: little along branches, much outside the tree.
//!
//! Evidence of branches comes from ridges of three planes: the matte (bare twigs, trunks), the likeness
//! to the trunk's colours (learned from the trunk in this picture, as Mortensen & Barrett 1998 train
//! their wire and Chodorowski et al. 2005 theirs on colours), and the luminance. Each is rated
//! against the rest of this tree: what most of the crown shows is leaf texture.

use super::LivewireParams;
use super::plane::Plane;
use super::ridge::{DIRECTIONS, Sign, ridges};
use super::trunk::Trunk;
use super::working::Working;

/// Blurs in working pixels at which ridges are sought: half the widths of twigs, limbs and trunks at
/// 256 rows. Scaled with the rows.
const SIGMAS: [f32; 3] = [0.9, 1.8, 3.6];

/// Length over which a ridge is averaged along its direction to either side, in working pixels at 256
/// rows.
const REACH: f32 = 7.0;

/// Share of the tree whose ridges count as texture: evidence begins above it.
const TEXTURE: f32 = 0.6;

/// Share of the tree below the strongest ridges, whose evidence is full.
const STRONG: f32 = 0.985;

/// Least rise from texture to full evidence: a picture without ridges has no evidence, however it is
/// rated. In units of the plane, 0 to 1.
const LEAST_RISE: f32 = 0.05;

/// How far evidence from luminance alone is trusted: bright and dark lines are often leaves or gaps.
const TRUST_LIGHT: f32 = 0.7;

/// Blur that fills colours in where the tree does not cover, in working pixels.
const FILL: f32 = 3.0;

/// Blur for the depth inside the crown, as a share of the working picture's height.
const DEPTH: f32 = 0.06;

/// Smallest variance of a colour, so that even colours of a trunk do not exclude its shadow.
const LEAST_VARIANCE: f32 = 0.0025;

/// Half a trunk's width around its axis that is sampled for colours, as a share of its width.
const TRUNK_CORE: f32 = 0.4;

/// What livewire knows about each working pixel.
pub(super) struct Costs {
    /// Cost of a pixel's length in any direction, without evidence.
    pub(super) plain: Vec<f32>,
    /// Evidence of a branch along each direction, 0 to 255.
    pub(super) evidence: Vec<[u8; DIRECTIONS]>,
}

/// Rates every working pixel.
///
/// O(pixels) with some hundreds of operations each.
pub(super) fn rate(working: &Working, trunk: &Trunk, params: &LivewireParams) -> Costs {
    let alpha = &working.alpha;
    let fine = alpha.height as f32 / 256.0;
    let sigmas = SIGMAS.map(|sigma| (sigma * fine).max(0.7));
    let reach = (REACH * fine).max(2.0);
    let mut evidence = vec![[0; DIRECTIONS]; alpha.values.len()];
    // One after the other, so that only one set of planes is in memory.
    let mut see = |plane: &Plane, sign: Sign, trust: f32| {
        let found = relative(ridges(plane, &sigmas, reach, sign), alpha, trust);
        strengthen(&mut evidence, &found, alpha);
    };
    see(alpha, Sign::Bright, 1.0);
    if !working.colors.is_empty() {
        see(&filled(&luminance(&working.colors), alpha), Sign::Either, TRUST_LIGHT);
        if let Some(wood) = likeness(working, trunk) {
            see(&wood.zip(alpha, |wood, alpha| wood * alpha), Sign::Bright, 1.0);
        }
    }
    Costs { plain: plain(alpha, params), evidence }
}

/// Cost without evidence: high outside, a little higher near the silhouette than in the middle.
fn plain(alpha: &Plane, params: &LivewireParams) -> Vec<f32> {
    let depth = alpha.blur((DEPTH * alpha.height as f32).max(1.0));
    let inside = alpha.values.iter().zip(&depth.values);
    inside
        .map(|(&alpha, &depth)| {
            let middle = 1.0 + params.center * (1.0 - depth) * (1.0 - depth);
            // Half covered is tree: twigs are thinner than a working pixel.
            let outside = 1.0 - (2.0 * alpha).min(1.0);
            middle * (1.0 + (params.outside - 1.0) * outside)
        })
        .collect()
}

/// Ridges as evidence, 0 to `trust`, against the rest of the tree.
fn relative(mut ridges: Vec<Plane>, alpha: &Plane, trust: f32) -> Vec<Plane> {
    let mut best = Plane::new(alpha.width, alpha.height);
    for plane in &ridges {
        for (best, &value) in best.values.iter_mut().zip(&plane.values) {
            *best = best.max(value);
        }
    }
    let low = best.percentile(alpha, TEXTURE);
    let high = best.percentile(alpha, STRONG);
    let rise = (high - low).max(LEAST_RISE);
    for value in ridges.iter_mut().flat_map(|plane| &mut plane.values) {
        *value = trust * ((*value - low) / rise).clamp(0.0, 1.0);
    }
    ridges
}

/// Raises the evidence to what `planes` show, where the tree covers.
fn strengthen(evidence: &mut [[u8; DIRECTIONS]], planes: &[Plane], alpha: &Plane) {
    for (direction, plane) in planes.iter().enumerate() {
        let values = plane.values.iter().zip(&alpha.values);
        for (into, (&value, &alpha)) in evidence.iter_mut().zip(values) {
            let seen = (255.0 * value * (2.0 * alpha).min(1.0)) as u8;
            into[direction] = into[direction].max(seen);
        }
    }
}

fn luminance(colors: &[Plane]) -> Plane {
    match colors {
        [red, green, blue] => {
            let two = red.zip(green, |red, green| 0.30 * red + 0.59 * green);
            two.zip(blue, |two, blue| two + 0.11 * blue)
        }
        _ => Plane::new(1, 1),
    }
}

/// A plane with what is outside replaced by what is inside nearby, so that the silhouette is no ridge.
fn filled(plane: &Plane, alpha: &Plane) -> Plane {
    let inside = plane.zip(alpha, |value, alpha| value * alpha).blur(FILL);
    let weight = alpha.blur(FILL);
    let near = inside.zip(&weight, |value, weight| value / weight.max(1e-3));
    let outer = plane.zip(alpha, |value, alpha| value * alpha);
    let fill = near.zip(alpha, |near, alpha| near * (1.0 - alpha));
    outer.zip(&fill, |a, b| a + b)
}

/// How much likelier each colour is on the trunk than in the tree as a whole, 0 to 1; `None` where no
/// trunk is seen.
fn likeness(working: &Working, trunk: &Trunk) -> Option<Plane> {
    let (width, alpha) = (working.alpha.width, &working.alpha);
    let colors = opponents(&working.colors)?;
    let mut on_trunk = alpha.map(|_| 0.0);
    for &(row, middle, wide) in &trunk.rows {
        let reach = TRUNK_CORE * wide;
        let (left, right) = ((middle - reach).ceil().max(0.0), (middle + reach).floor());
        for x in left as usize..=(right.max(left) as usize).min(width - 1) {
            on_trunk.values[row * width + x] = alpha.values[row * width + x];
        }
    }
    let mut evidence = alpha.map(|_| 0.0);
    for plane in &colors {
        let (mean, variance) = normal(plane, &on_trunk)?;
        let (all_mean, all_variance) = normal(plane, alpha)?;
        for (sum, &value) in evidence.values.iter_mut().zip(&plane.values) {
            let off = |mean: f32, variance: f32| {
                (value - mean) * (value - mean) / variance + libm::logf(variance)
            };
            *sum += 0.5 * (off(all_mean, all_variance) - off(mean, variance));
        }
    }
    Some(evidence.map(|log_ratio| 1.0 / (1.0 + libm::expf(-log_ratio.clamp(-20.0, 20.0)))))
}

/// Luminance, red against green, and blue against yellow.
fn opponents(colors: &[Plane]) -> Option<[Plane; 3]> {
    let [red, green, blue] = colors else { return None };
    let yellow = red.zip(green, |red, green| 0.5 * (red + green));
    Some([
        luminance(colors),
        red.zip(green, |red, green| red - green),
        blue.zip(&yellow, |blue, yellow| blue - yellow),
    ])
}

/// Weighted mean and variance; `None` without weight.
fn normal(plane: &Plane, weight: &Plane) -> Option<(f32, f32)> {
    let values = || plane.values.iter().zip(&weight.values).map(|(&v, &w)| (v as f64, w as f64));
    let sum: f64 = values().map(|(_, w)| w).sum();
    if sum < 1.0 {
        return None;
    }
    let mean = values().map(|(v, w)| v * w).sum::<f64>() / sum;
    let variance = values().map(|(v, w)| w * (v - mean) * (v - mean)).sum::<f64>() / sum;
    Some((mean as f32, (variance as f32).max(LEAST_VARIANCE)))
}
