//! Leaf clusters in the light's way.

use super::sky::{Bins, Weights};
use glam::Vec3;

/// A ball that lets a share of the light through: a leaf cluster, or a solid ball.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ball {
    /// Its middle.
    pub center: Vec3,
    /// Metres.
    pub radius: f32,
    /// Share of the light that comes through, 0 to 1.
    pub translucency: f32,
}

/// Sine and cosine of the angle at which the ball is seen. From inside it covers more than half of the sky, all of it from its
/// middle: Eq. 3 says nothing of this; so nothing jumps where a point enters a ball.
fn half_angle(distance: f32, radius: f32) -> (f32, f32) {
    if distance > radius {
        let sin = radius / distance;
        (sin, (1.0 - sin * sin).max(0.0).sqrt())
    } else {
        let sin = distance / radius;
        (sin, -(1.0 - sin * sin).max(0.0).sqrt())
    }
}

/// At most this share of the sky's light is kept from `point` by the ball; its shadow volume is where this is not tiny.
pub(in crate::plastic) fn influence(ball: &Ball, offset: Vec3, bins: &Bins) -> f32 {
    let squared = offset.length_squared();
    let dark = 1.0 - ball.translucency;
    let radius = ball.radius;
    if squared <= 4.0 * radius * radius {
        return dark;
    }
    let distance = squared.sqrt();
    let sin = radius / distance;
    if offset.dot(bins.up) <= -(sin + Bins::reach()) * distance {
        return 0.0;
    }
    let bright = (offset.dot(bins.brightest) / distance + sin).clamp(0.0, 1.0);
    // The cap's share of the lobe's light: 3 (1 - cos) / 2 · 2 / … is at most this.
    1.7 * sin * sin * bright * bright * dark
}

/// Whether the ball may keep more than `least` of the sky's light from any point in `around`; `brightest` in their frame.
pub(in crate::plastic) fn may_shade(
    ball: &Ball,
    around: &Ball,
    brightest: Vec3,
    least: f32,
) -> bool {
    if ball.radius <= 0.0 {
        return false;
    }
    let offset = ball.center - around.center;
    let gap = offset.length() - around.radius;
    if gap <= 2.0 * ball.radius {
        return true;
    }
    let high = offset.dot(brightest) + around.radius + ball.radius + Bins::reach() * gap;
    let high = (high * ball.radius).max(0.0);
    let squared = gap * gap;
    1.7 * (1.0 - ball.translucency) * high * high > least * squared * squared
}

/// Draws the ball before the sky as seen from `offset` away from its middle.
pub(in crate::plastic) fn veil(ball: &Ball, offset: Vec3, bins: &Bins, through: &mut Weights) {
    let distance = offset.length();
    let reach = Bins::reach();
    let (sin, cos) = half_angle(distance, ball.radius);
    let mut dark = 1.0 - ball.translucency;
    let (mut edge_sin, mut edge_cos) = (sin.max(0.2 * reach), cos);
    if cos > 0.0 && sin < reach {
        // Smaller than a direction's share: spread over one, by what it covers.
        edge_sin = reach;
        edge_cos = (1.0 - reach * reach).sqrt();
        dark *= sin * sin / (1.0 + cos) / (1.0 - edge_cos);
    }
    let steep = 1.0 / (2.0 * edge_sin * reach);
    let u = if distance > 0.0 { offset * (steep / distance) } else { Vec3::ZERO };
    let start = if distance > 0.0 { 0.5 - edge_cos * steep } else { 1.0 };
    for (k, through) in through.iter_mut().enumerate() {
        let cover = start + u.x * bins.x[k] + u.y * bins.y[k] + u.z * bins.z[k];
        *through *= 1.0 - dark * cover.clamp(0.0, 1.0);
    }
}
