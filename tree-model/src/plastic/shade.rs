//! Everything that stands between a cluster and the sky.

use super::light::{Ball, Bins, Convex, DIRECTIONS, Light, influence, veil};

/// A caster that keeps less than this share of the sky's light from a point is passed over: where it keeps more is its shadow
/// volume.
pub(super) const LEAST: f32 = 5e-4;

/// What casts shadow on the clusters of a tree in one season, in the tree's own frame.
pub(super) struct Casters<'a> {
    /// The tree's own clusters; one without radius is gone.
    pub own: &'a [Ball],
    /// Those of other trees.
    pub foreign: &'a [Ball],
    /// Obstacles.
    pub solids: &'a [Convex],
}

/// Light on the middle of the tree's own cluster `index`, which does not shade itself. O(casters).
pub(super) fn light_at(index: usize, casters: &Casters<'_>, bins: &Bins) -> Light {
    let at = casters.own[index].center;
    let mut through = [1.0_f32; DIRECTIONS];
    let mut draw = |ball: &Ball| {
        let offset = ball.center - at;
        if ball.radius > 0.0 && influence(ball, offset, bins) > LEAST {
            veil(ball, offset, bins, &mut through);
        }
    };
    casters.own[..index].iter().for_each(&mut draw);
    casters.own[index + 1..].iter().for_each(&mut draw);
    casters.foreign.iter().for_each(&mut draw);
    for solid in casters.solids {
        if solid.influence(at, bins) > LEAST {
            solid.veil(at, bins, &mut through);
        }
    }
    Light::gather(bins, &through)
}
