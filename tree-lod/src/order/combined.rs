//! Density and orientation together.
//!
//! Source: Neubert 2012, §7.3.4, eq. 7.8: `P = P_silhouette² + P_density`, normalised to 0 to 1, sorted
//! falling with a small amount of randomness.
//!
//! Neubert does not say how `P_density` follows from the field. Taken from the densities at the start, it
//! would empty dense places altogether; so it comes from thinning ([`super::density`]), in which
//! densities are kept up to date: 0 for the element removed first, rising to 1 for the last one
//! removed, and 1 for all that are left when densities have become uniform. Among those, which are what
//! is drawn at small λ, orientation decides, and helps most (§7.3.3); before, density decides, and
//! orientation has the smaller say (§7.3.4).

use super::density::thin;
use super::orientation::alignment;
use super::{OrderParams, by_priority};
use crate::Elements;
use crate::error::Result;
use crate::implicit;
use tree_core::{Control, Seed};

/// The order of eq. 7.8. Builds the field and the hull.
///
/// # Errors
/// As [`OrderParams::field`], [`implicit::surface`] and [`density`](super::density()).
///
/// # Complexity
/// The sum of [`density`](super::density()), [`implicit::surface`] and
/// [`orientation`](super::orientation()).
pub fn combined(
    elements: &Elements,
    params: &OrderParams,
    seed: Seed,
    control: &Control,
) -> Result<Vec<u32>> {
    let field = params.field(elements)?;
    let hull = implicit::surface(&field, &params.hull, &control.part(0.0, 0.4))?;
    let along = alignment(elements, &hull, &control.part(0.4, 0.6))?;
    let thinned = thin(&field, params, seed, &control.part(0.6, 1.0))?;
    let mut density = vec![1.0; elements.len()];
    let n = thinned.removed.len() as f32;
    for (turn, &element) in thinned.removed.iter().enumerate() {
        density[element as usize] = turn as f32 / n;
    }
    let chance = seed.stream("combined order");
    Ok(by_priority(elements, |i| {
        let along = along[i as usize];
        let priority = 0.5 * (along * along + density[i as usize]);
        priority + params.randomness * chance.unit(i.into())
    }))
}
