//! The root flare: how the foot of a trunk widens towards the ground, between buttresses.
//!
//! At height h up to H the radius is multiplied by 1 + F(h)·(1 + D·cos(Lθ)), with
//! F(h) = flare·(1 − h/H)², L lobes and depth D. F and its slope vanish at H, so the flare joins the
//! trunk without a kink. No source: a shape that looks right and costs one cosine a vertex.

use super::frame::Frame;
use crate::params::MeshParams;
use glam::Vec3;

/// Vertices a lobe needs at least to be seen as one.
const SIDES_PER_LOBE: u32 = 4;
/// Depth of lobes, as a share of the radius, under which they need no vertices of their own.
const LOBE_VISIBLE: f32 = 0.02;

/// Where the flare bends most, as shares of its height.
const STOPS: [f32; 6] = [0.07, 0.18, 0.32, 0.5, 0.72, 1.0];

/// Height of a unit tangent under which a trunk lies rather than leans, and keeps its own foot.
const LEVEL_MIN: f32 = 0.5;

/// The flare of one trunk; [`Flare::NONE`] for every other axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flare {
    flare: f32,
    height: f32,
    lobes: u32,
    depth: f32,
}

/// What the flare does to one vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Widened {
    /// Factor on the radius.
    pub(crate) factor: f32,
    /// Derivative of the factor by height, per metre.
    pub(crate) by_height: f32,
    /// Derivative of the factor by angle.
    pub(crate) by_angle: f32,
}

impl Flare {
    pub(crate) const NONE: Self = Self { flare: 0.0, height: 0.0, lobes: 0, depth: 0.0 };

    pub(crate) fn new(params: &MeshParams, trunk_radius: f32) -> Self {
        Self {
            flare: params.flare,
            height: params.flare_height * trunk_radius,
            lobes: params.flare_lobes,
            depth: if params.flare_lobes == 0 { 0.0 } else { params.flare_lobe_depth },
        }
    }

    /// Whether anything is widened at this height.
    pub(crate) fn acts(&self, along: f32) -> bool {
        self.flare > 0.0 && along < self.height
    }

    /// Heights at which rings may be needed.
    pub(crate) fn stops(&self) -> impl Iterator<Item = f32> + '_ {
        STOPS.iter().map(|share| share * self.height).filter(|&height| height > 0.0)
    }

    /// F(h).
    fn share(&self, along: f32) -> f32 {
        let rest = (1.0 - along / self.height).clamp(0.0, 1.0);
        self.flare * rest * rest
    }

    /// The largest factor on the radius at this height.
    pub(crate) fn widest(&self, along: f32) -> f32 {
        if self.acts(along) { 1.0 + self.share(along) * (1.0 + self.depth) } else { 1.0 }
    }

    /// Fewest sides that show the lobes at this height.
    pub(crate) fn min_sides(&self, along: f32) -> u32 {
        if self.acts(along) && self.share(along) * self.depth > LOBE_VISIBLE {
            SIDES_PER_LOBE * self.lobes
        } else {
            0
        }
    }

    /// The frame that the ring at this height stands in. A leaning trunk stands level on the ground:
    /// its lowest ring is horizontal, and rings tilt to the trunk's own frame up to the flare's top.
    pub(crate) fn stance(&self, along: f32, frame: &Frame) -> Frame {
        if !self.acts(along) || frame.tangent.y < LEVEL_MIN {
            return *frame;
        }
        let t = along / self.height;
        let tilt = t * t * (3.0 - 2.0 * t);
        let tangent = Vec3::Y.lerp(frame.tangent, tilt).normalize_or(frame.tangent);
        Frame::new(tangent, frame.normal)
    }

    /// What happens to the vertex at this height and angle (0 to 2π).
    pub(crate) fn at(&self, along: f32, angle: f32) -> Widened {
        if !self.acts(along) {
            return Widened { factor: 1.0, by_height: 0.0, by_angle: 0.0 };
        }
        let share = self.share(along);
        let lobes = self.lobes as f32;
        let lobe = 1.0 + self.depth * libm::cosf(lobes * angle);
        let rest = 1.0 - along / self.height;
        Widened {
            factor: 1.0 + share * lobe,
            by_height: -2.0 * self.flare * rest / self.height * lobe,
            by_angle: -share * self.depth * lobes * libm::sinf(lobes * angle),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_agree_with_differences_and_the_top_is_smooth() {
        let flare = Flare::new(&MeshParams::default(), 0.3);
        for (along, angle) in [(0.1, 0.3), (0.4, 2.0), (0.85, 5.0)] {
            let (at, step) = (flare.at(along, angle), 1e-3);
            let up = (flare.at(along + step, angle).factor - flare.at(along - step, angle).factor)
                / (2.0 * step);
            let round = (flare.at(along, angle + step).factor
                - flare.at(along, angle - step).factor)
                / (2.0 * step);
            assert!((up - at.by_height).abs() < 2e-3, "{up} {at:?}");
            assert!((round - at.by_angle).abs() < 2e-3, "{round} {at:?}");
        }
        assert!(flare.at(0.9, 1.0).factor == 1.0 && flare.at(0.899, 1.0).by_height.abs() < 1e-2);
        assert!(flare.widest(0.0) > 1.4 && flare.widest(1.0) == 1.0);
    }
}
