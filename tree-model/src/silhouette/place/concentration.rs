//! The stated test of an arrangement: do azimuths gather at the privileged positions?
//!
//! Sites are taken in their order by node, then azimuth. Each with the one after it gives an angle
//! x = (Δθ − Δnode · φ) mod γ, which is 0 at a privileged position. For [`Arrangement::Spread`], which has none, x
//! is the azimuth itself and must not gather anywhere.
//!
//! Rayleigh's test: under "anywhere alike" the mean resultant length R of the angles 2π x/γ is as great as found with
//! probability p ≈ exp(√(1 + 4m + 4(m² − m²R²)) − (1 + 2m)) for m angles (Zar 1999). The arrangement passes when
//! p is below 0.001, and the fullest of twelve bins is the one about 0. O(N log N).

use super::arrangement::Arrangement;
use super::domain::Site;
use std::f32::consts::TAU;

/// Bins of the histogram over γ; the first is centred on the privileged position.
pub const BINS: usize = 12;

/// Angles gather when chance gives as much with less than this probability.
const SIGNIFICANT: f32 = 1e-3;

/// Sites keep apart from a pattern when chance gives as much gathering with at least this probability.
const INSIGNIFICANT: f32 = 0.05;

/// How closely sites gather at privileged positions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Concentration {
    /// Angles tested.
    pub pairs: u32,
    /// Mean resultant length R, 0 (evenly about) to 1 (all alike).
    pub resultant: f32,
    /// Where they gather, as an angle from the privileged position in radians, −γ/2 to γ/2.
    pub offset: f32,
    /// The probability that chance alone gathers them so closely.
    pub p_value: f32,
    /// Angles by twelfths of γ, the first bin centred on the privileged position.
    pub histogram: [u32; BINS],
    /// Whether there is a pattern to keep to.
    pub has_pattern: bool,
}

impl Concentration {
    /// The stated test: angles gather significantly (p < 0.001) and the fullest bin of the histogram is that of the
    /// privileged position. Without a pattern: they do not gather (p ≥ 0.05).
    #[must_use]
    pub fn passes(&self) -> bool {
        let fullest = self.histogram.iter().all(|&count| count <= self.histogram[0]);
        if self.has_pattern {
            self.p_value < SIGNIFICANT && fullest
        } else {
            self.p_value >= INSIGNIFICANT
        }
    }
}

/// Tests sites of one parent for an arrangement. Nodes must be numbered ([`Site::node`]).
#[must_use]
pub fn privileged(sites: &[Site], arrangement: &Arrangement) -> Concentration {
    let mut order: Vec<&Site> = sites.iter().collect();
    order.sort_by(|a, b| a.node.cmp(&b.node).then(a.azimuth.total_cmp(&b.azimuth)));
    let angles: Vec<f64> = if arrangement.has_pattern() {
        order.windows(2).map(|pair| angle(pair[0], pair[1], arrangement)).collect()
    } else {
        order.iter().map(|site| f64::from(site.azimuth / TAU)).collect()
    };
    let mut out = Concentration {
        pairs: angles.len() as u32,
        p_value: 1.0,
        has_pattern: arrangement.has_pattern(),
        ..Concentration::default()
    };
    let (mut x, mut y) = (0.0, 0.0);
    for &share in &angles {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * share);
        (x, y) = (x + cos, y + sin);
        out.histogram[(share * BINS as f64).round().rem_euclid(BINS as f64) as usize % BINS] += 1;
    }
    if angles.is_empty() {
        return out;
    }
    let m = angles.len() as f64;
    let resultant = (x * x + y * y).sqrt();
    out.resultant = (resultant / m).min(1.0) as f32;
    out.offset = libm::atan2f(y as f32, x as f32) / TAU * arrangement.spacing();
    let under = (1.0 + 4.0 * m + 4.0 * (m * m - resultant * resultant)).max(0.0);
    out.p_value = libm::exp(under.sqrt() - (1.0 + 2.0 * m)).min(1.0) as f32;
    out
}

/// The angle from a site to the next, less what the pattern turns it, as a share of γ.
fn angle(a: &Site, b: &Site, arrangement: &Arrangement) -> f64 {
    let nodes = f64::from(b.node) - f64::from(a.node);
    let turned =
        f64::from(b.azimuth) - f64::from(a.azimuth) - nodes * f64::from(arrangement.turn());
    (turned / f64::from(arrangement.spacing())).rem_euclid(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_core::Seed;

    fn random(n: u64, seed: Seed) -> Vec<Site> {
        let site = |i| Site { azimuth: TAU * seed.unit(i), node: i as u32 / 2, along: 0.0 };
        (0..n).map(site).collect()
    }

    #[test]
    fn sites_on_the_pattern_pass() {
        let arrangement = Arrangement::Decussate;
        let turn = |i: u32| TAU / 4.0 * (i / 2) as f32 + TAU / 2.0 * (i % 2) as f32 + 1.0;
        let sites: Vec<Site> = (0..20)
            .map(|i| Site { along: 0.0, azimuth: turn(i).rem_euclid(TAU), node: i / 2 })
            .collect();
        let found = privileged(&sites, &arrangement);
        assert!(found.passes() && found.resultant > 0.999 && found.histogram[0] == 19, "{found:?}");
        // The same sites are no whorls.
        assert!(!privileged(&sites, &Arrangement::whorl(3)).passes());
    }

    #[test]
    fn random_sites_do_not_pass_except_as_spread() {
        let failed = (0..200)
            .filter(|&i| privileged(&random(40, Seed(i)), &Arrangement::Decussate).passes());
        assert_eq!(failed.count(), 0);
        let spread =
            (0..200).filter(|&i| privileged(&random(40, Seed(i)), &Arrangement::Spread).passes());
        assert!((180..=199).contains(&spread.count()));
    }

    #[test]
    fn no_sites_pass_no_test() {
        assert!(!privileged(&[], &Arrangement::spiral()).passes());
        assert_eq!(privileged(&[Site::default()], &Arrangement::Opposite).pairs, 0);
    }
}
