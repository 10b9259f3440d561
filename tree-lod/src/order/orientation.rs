//! Elements that lie along the hull stay longest.
//!
//! Source: Neubert 2012, §7.3.3. The silhouette priority of an element is |cos α|, α being the angle
//! between its normal and that of the hull where it is nearest. Leaves are seen from both sides, so the
//! sign does not count. An element without a normal (a closed blade) has [`NEUTRAL`].

use super::{OrderParams, by_priority};
use crate::Elements;
use crate::error::{LodError, Result};
use crate::implicit::{Hull, check_columns};
use rayon::prelude::*;
use tree_core::{Control, Seed};

/// Priority of an element without a normal: the mean of |cos α| over all directions.
const NEUTRAL: f32 = 0.5;
/// Elements in one part of the work.
const PART: usize = 256;

/// An order in which elements whose normal is far from the hull's go first, with
/// [`OrderParams::randomness`].
///
/// # Errors
/// [`LodError::Parameter`](crate::LodError::Parameter); [`LodError::Foliage`](crate::LodError::Foliage)
/// when there are no elements; [`LodError::Cancelled`](crate::LodError::Cancelled).
///
/// # Complexity
/// O(n · search on the hull), in parallel.
pub fn orientation(
    elements: &Elements,
    hull: &Hull,
    params: &OrderParams,
    seed: Seed,
    control: &Control,
) -> Result<Vec<u32>> {
    params.validate()?;
    check_columns(elements)?;
    if elements.is_empty() {
        return Err(LodError::Foliage("there are no elements"));
    }
    let along = alignment(elements, hull, control)?;
    let chance = seed.stream("orientation order");
    Ok(by_priority(elements, |i| along[i as usize] + params.randomness * chance.unit(i.into())))
}

/// |cos α| of every element, 0 to 1.
pub(super) fn alignment(elements: &Elements, hull: &Hull, control: &Control) -> Result<Vec<f32>> {
    control.report("orientation", 0.0)?;
    let one = |(&center, &normal): (&glam::Vec3, &glam::Vec3)| {
        control.check()?;
        let out = hull.nearest_normal(center);
        let known = normal != glam::Vec3::ZERO && normal.is_finite() && out != glam::Vec3::ZERO;
        Ok(if known { normal.dot(out).abs().min(1.0) } else { NEUTRAL })
    };
    elements.centers.par_iter().zip(&elements.normals).with_min_len(PART).map(one).collect()
}
