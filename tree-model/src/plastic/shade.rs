//! Everything that stands between a cluster and the sky.

use super::light::{Ball, Bins, Convex, DIRECTIONS, Weights, veil};
use glam::Vec3;

/// A caster that keeps less than this share of the sky's light from a point is passed over: where it keeps more is its shadow
/// volume.
pub(super) const LEAST: f32 = 2e-3;

/// The share of the sky's light that a ball seen under a small angle keeps away, over the square of the angle's sine.
const CAP: f32 = 1.7;

/// Above 0 within the shadow volume: 1.7 sin² cos² dark > least, where sin is of half the angle under which the ball is seen and
/// cos of that between its highest point and the brightest of the sky; without roots and divisions. `near` and `strength` as
/// [`prepared`].
#[inline(always)]
fn margin(x: f32, y: f32, z: f32, radius: f32, near: f32, strength: f32, brightest: Vec3) -> f32 {
    let squared = x * x + y * y + z * z;
    let high = (x * brightest.x + y * brightest.y + z * brightest.z + radius).max(0.0);
    (strength * (high * high) - squared * squared).max(near - squared)
}

/// The squared distance within which a ball is looked at anyhow, and 1.7 dark r² / least; of one that casts no shadow, such that
/// its margin is never above 0.
fn prepared(ball: &Ball) -> (f32, f32) {
    let squared = ball.radius * ball.radius;
    let dark = 1.0 - ball.translucency;
    if squared * dark > 0.0 { (4.0 * squared, CAP * dark / LEAST * squared) } else { (-1.0, 0.0) }
}

/// Whether a point lies in the shadow volume of a ball.
pub(super) fn reaches(ball: &Ball, at: Vec3, brightest: Vec3) -> bool {
    let (near, strength) = prepared(ball);
    let offset = ball.center - at;
    margin(offset.x, offset.y, offset.z, ball.radius, near, strength, brightest) > 0.0
}

/// Balls that cast shadow, in columns.
#[derive(Clone, Debug, Default)]
pub(super) struct Casters {
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    radius: Vec<f32>,
    near: Vec<f32>,
    strength: Vec<f32>,
    balls: Vec<Ball>,
    margins: Vec<f32>,
}

impl Casters {
    pub(super) fn clear(&mut self) {
        for column in [
            &mut self.x,
            &mut self.y,
            &mut self.z,
            &mut self.radius,
            &mut self.near,
            &mut self.strength,
        ] {
            column.clear();
        }
        self.balls.clear();
    }

    /// One without radius casts none, but keeps its place.
    pub(super) fn push(&mut self, ball: &Ball) {
        let (near, strength) = prepared(ball);
        self.x.push(ball.center.x);
        self.y.push(ball.center.y);
        self.z.push(ball.center.z);
        self.radius.push(ball.radius);
        self.near.push(near);
        self.strength.push(strength);
        self.balls.push(*ball);
    }

    /// How far the point is inside of each shadow volume.
    fn margins(&mut self, at: Vec3, brightest: Vec3) {
        let n = self.balls.len();
        self.margins.resize(n, 0.0);
        let (x, y, z) = (&self.x[..n], &self.y[..n], &self.z[..n]);
        let (radius, near, strength) = (&self.radius[..n], &self.near[..n], &self.strength[..n]);
        for (k, inside) in self.margins[..n].iter_mut().enumerate() {
            let (x, y, z) = (x[k] - at.x, y[k] - at.y, z[k] - at.z);
            *inside = margin(x, y, z, radius[k], near[k], strength[k], brightest);
        }
    }

    /// What all of them but `itself` let through to a point. O(casters).
    pub(super) fn through(&mut self, at: Vec3, itself: usize, bins: &Bins) -> Weights {
        let mut through = [1.0; DIRECTIONS];
        self.margins(at, bins.brightest);
        for (k, (ball, &margin)) in self.balls.iter().zip(&self.margins).enumerate() {
            if margin > 0.0 && k != itself {
                veil(ball, ball.center - at, bins, &mut through);
            }
        }
        through
    }
}

/// Draws the obstacles before what is seen of the sky from a point.
pub(super) fn veil_solids(solids: &[Convex], at: Vec3, bins: &Bins, through: &mut Weights) {
    for solid in solids {
        if solid.influence(at, bins) > LEAST {
            solid.veil(at, bins, through);
        }
    }
}
