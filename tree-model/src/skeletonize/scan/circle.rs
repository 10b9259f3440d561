//! Circles through points in a plane that belong to one in part only.
//!
//! Three points give a circle (Fischler and Bolles 1981, RANSAC); the one near most points is
//! bettered by weighted algebraic fits (V. Pratt, *Direct least-squares fitting of algebraic
//! surfaces*, 1987, in the linear form of Kåsa) with weights that forget points far off (Tukey).

use glam::{DMat3, DVec2, DVec3, Vec2};

/// Triples tried.
const TRIPLES: u32 = 48;
/// Rounds of the fit.
const ROUNDS: usize = 6;
/// Fewest points of a fit.
pub(super) const POINTS_MIN: usize = 7;
/// Sectors round the centre...
const SECTORS: usize = 12;
/// ...of which this many must hold points: a third of the circle is seen.
const SECTORS_MIN: u32 = 4;
/// Share of the points that must lie near the circle.
const NEAR_MIN: f32 = 0.5;
/// Scans see surfaces: within this share of the radius...
const HOLLOW: f32 = 0.6;
/// ...lie at most this share of the points in and near the circle; leaves fill a third.
const HOLLOW_MAX: f32 = 0.12;

/// A circle and how well it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Circle {
    pub(super) center: Vec2,
    pub(super) radius: f32,
    /// Share of the directions in which points lie on it.
    pub(super) seen: f32,
    /// Root mean square distance of the points near it.
    pub(super) error: f32,
    /// Share of the points near it.
    pub(super) near: f32,
}

/// Fits a circle of a radius within `range` to points that scatter by about `noise`.
pub(super) fn fit(points: &[Vec2], range: [f32; 2], noise: f32, mut seed: u64) -> Option<Circle> {
    if points.len() < POINTS_MIN {
        return None;
    }
    let mut best: Option<(f32, DVec2, f64)> = None;
    for _ in 0..TRIPLES {
        let pick = |seed: &mut u64| {
            *seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            points[((*seed >> 33) as usize) % points.len()].as_dvec2()
        };
        let [a, b, c] = [pick(&mut seed), pick(&mut seed), pick(&mut seed)];
        let Some((center, radius)) = through(a, b, c) else { continue };
        if !(f64::from(range[0])..=f64::from(range[1])).contains(&radius) {
            continue;
        }
        let tolerance = band(radius as f32, noise);
        // Near points count by how near (MSAC), so that of two circles the truer wins.
        let score = points.iter().map(|p| {
            let off = (p.distance(center.as_vec2()) - radius as f32) / tolerance;
            (1.0 - off * off).max(0.0)
        });
        let score: f32 = score.sum();
        if best.is_none_or(|(least, ..)| score > least) {
            best = Some((score, center, radius));
        }
    }
    let (_, mut center, mut radius) = best?;
    for _ in 0..ROUNDS {
        let (next, r) = weighted(points, center, radius, 1.5 * band(radius as f32, noise))?;
        (center, radius) = (next, r);
    }
    if !(range[0]..=range[1]).contains(&(radius as f32)) {
        return None;
    }
    judge(points, center.as_vec2(), radius as f32, noise)
}

/// How far off a circle its points lie.
fn band(radius: f32, noise: f32) -> f32 {
    (0.15 * radius).max(noise)
}

fn judge(points: &[Vec2], center: Vec2, radius: f32, noise: f32) -> Option<Circle> {
    let tolerance = 1.5 * band(radius, noise);
    let (mut sectors, mut n, mut sum, mut n_inside, mut n_hollow) = (0_u32, 0_usize, 0.0, 0, 0);
    for point in points {
        let away = *point - center;
        let off = away.length() - radius;
        n_inside += usize::from(off <= tolerance);
        n_hollow += usize::from(off <= (HOLLOW - 1.0) * radius);
        if off.abs() <= tolerance {
            let turn = libm::atan2f(away.y, away.x) / std::f32::consts::TAU + 0.5;
            sectors |= 1 << ((turn * SECTORS as f32) as usize).min(SECTORS - 1);
            n += 1;
            sum += off * off;
        }
    }
    let near = n as f32 / points.len() as f32;
    if sectors.count_ones() < SECTORS_MIN
        || near < NEAR_MIN
        || n < POINTS_MIN
        || n_hollow as f32 > HOLLOW_MAX * n_inside as f32
    {
        return None;
    }
    let seen = sectors.count_ones() as f32 / SECTORS as f32;
    Some(Circle { center, radius, seen, error: (sum / n as f32).sqrt(), near })
}

/// The circle through three points.
fn through(a: DVec2, b: DVec2, c: DVec2) -> Option<(DVec2, f64)> {
    let (ab, ac) = (b - a, c - a);
    let twice = 2.0 * ab.perp_dot(ac);
    let (d, e) = (ab.length_squared(), ac.length_squared());
    let off = DVec2::new(ac.y * d - ab.y * e, ab.x * e - ac.x * d) / twice;
    off.is_finite().then(|| (a + off, off.length()))
}

/// One weighted fit: x² + y² = 2ax + 2by + c, in the frame of the last one.
fn weighted(points: &[Vec2], center: DVec2, radius: f64, scale: f32) -> Option<(DVec2, f64)> {
    let (mut matrix, mut right) = (DMat3::ZERO, DVec3::ZERO);
    for point in points {
        let p = (point.as_dvec2() - center) / radius;
        let off = (p.length() - 1.0) * radius / f64::from(scale);
        let inside = 1.0 - off * off;
        if inside > 0.0 {
            let row = DVec3::new(p.x, p.y, 1.0);
            let weight = inside * inside;
            matrix += weight * DMat3::from_cols(row * row.x, row * row.y, row);
            right += weight * p.length_squared() * row;
        }
    }
    let found = matrix.inverse() * right;
    let middle = 0.5 * found.truncate();
    let r2 = found.z + middle.length_squared();
    (found.is_finite() && r2 > 0.0).then(|| (center + radius * middle, radius * r2.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::TAU;

    fn arc(center: Vec2, radius: f32, share: f32, n: u32) -> Vec<Vec2> {
        let place = |i: u32| {
            let (sin, cos) = libm::sincosf(TAU * share * i as f32 / n as f32);
            center + radius * (1.0 + 0.02 * (i as f32 * 2.1 % 1.0 - 0.5)) * Vec2::new(cos, sin)
        };
        (0..n).map(place).collect()
    }

    #[test]
    fn a_circle_is_found_among_points_of_another_branch() {
        let mut points = arc(Vec2::new(0.3, -0.2), 0.25, 1.0, 40);
        points.extend(arc(Vec2::new(0.8, 0.0), 0.1, 1.0, 15));
        let found = fit(&points, [0.05, 1.0], 0.005, 1).unwrap();
        assert!((found.radius - 0.25).abs() < 0.005, "{found:?}");
        assert!(found.center.distance(Vec2::new(0.3, -0.2)) < 0.01, "{found:?}");
    }

    #[test]
    fn a_side_view_is_enough_and_a_sliver_is_not() {
        let half = fit(&arc(Vec2::ZERO, 0.25, 0.45, 40), [0.05, 1.0], 0.005, 1).unwrap();
        assert!((half.radius - 0.25).abs() < 0.01 && half.center.length() < 0.01, "{half:?}");
        assert!((half.seen - 0.5).abs() < 0.1, "{half:?}");
        assert_eq!(fit(&arc(Vec2::ZERO, 0.25, 0.15, 40), [0.05, 1.0], 0.005, 1), None);
    }

    #[test]
    fn points_at_one_place_or_on_a_line_give_none() {
        assert_eq!(fit(&[Vec2::ONE; 20], [0.01, 1.0], 0.01, 1), None);
        let line: Vec<Vec2> = (0..30).map(|i| Vec2::new(0.01 * i as f32, 0.0)).collect();
        assert_eq!(fit(&line, [0.01, 0.2], 0.001, 1), None);
    }
}
