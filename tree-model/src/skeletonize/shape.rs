//! The shape of a piece of surface: its main directions, how flat, closed and solid it is.

use glam::{DMat3, DVec3, Vec3};

/// Rotations of the Jacobi eigenvalue method; it converges quadratically, so few do.
const SWEEPS: usize = 12;

/// What can be said of a piece of surface as a whole.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    /// Unit directions of greatest, middle and least spread.
    pub(super) axes: [Vec3; 3],
    /// Full widths along them.
    pub(super) widths: [f32; 3],
    pub(super) area: f32,
    /// Length of the summed area vectors as a share of the area: 0 for closed surfaces and tubes,
    /// 1 for flat cards.
    pub(super) open: f32,
    /// Share of its box that its volume fills. Meaningless for open surfaces.
    pub(super) solid: f32,
    pub(super) n_triangles: usize,
}

impl Shape {
    /// Measures triangles.
    pub(super) fn of(triangles: impl Iterator<Item = [Vec3; 3]> + Clone) -> Self {
        let (mut area, mut sum, mut mean, mut n_triangles) = (0.0, DVec3::ZERO, DVec3::ZERO, 0);
        for corners in triangles.clone() {
            let [a, b, c] = corners.map(|p| p.as_dvec3());
            let across = 0.5 * (b - a).cross(c - a);
            n_triangles += 1;
            area += across.length();
            sum += across;
            mean += across.length() * (a + b + c) / 3.0;
        }
        let center = if area > 0.0 { mean / area } else { DVec3::ZERO };
        let (mut spread, mut volume) = (DMat3::ZERO, 0.0);
        for corners in triangles.clone() {
            let [a, b, c] = corners.map(|p| p.as_dvec3() - center);
            let weight = 0.5 * (b - a).cross(c - a).length();
            volume += a.dot(b.cross(c)) / 6.0;
            // The second moment of a triangle about the centre, times 12 (exact).
            for p in [a, b, c, a + b + c] {
                spread += weight * DMat3::from_cols(p * p.x, p * p.y, p * p.z);
            }
        }
        let axes = main_axes(spread);
        let mut bounds = [(f64::INFINITY, f64::NEG_INFINITY); 3];
        for p in triangles.flatten() {
            for (axis, (low, high)) in axes.iter().zip(&mut bounds) {
                let along = axis.dot(p.as_dvec3() - center);
                (*low, *high) = (low.min(along), high.max(along));
            }
        }
        let widths = bounds.map(|(low, high)| (high - low).max(0.0));
        let filled = f64::abs(volume) / widths.iter().product::<f64>();
        Self {
            axes: axes.map(DVec3::as_vec3),
            widths: widths.map(|w| w as f32),
            area: area as f32,
            open: if area > 0.0 { (sum.length() / area) as f32 } else { 1.0 },
            solid: if filled.is_finite() { filled as f32 } else { 0.0 },
            n_triangles,
        }
    }

    /// Length against breadth.
    pub(super) fn slenderness(&self) -> f32 {
        self.widths[0] / self.widths[1].max(f32::MIN_POSITIVE)
    }
}

/// Unit eigenvectors of a symmetric matrix, by falling eigenvalue (Jacobi's method).
fn main_axes(matrix: DMat3) -> [DVec3; 3] {
    let mut m = matrix.to_cols_array_2d();
    let mut axes = DMat3::IDENTITY;
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if m[p][q] == 0.0 {
                continue;
            }
            let theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
            let (c, s) = (1.0 / (t * t + 1.0).sqrt(), t / (t * t + 1.0).sqrt());
            if !(c.is_finite() && s.is_finite()) {
                continue;
            }
            let mut turn = [[0.0; 3]; 3];
            (0..3).for_each(|i| turn[i][i] = 1.0);
            (turn[p][p], turn[q][q], turn[p][q], turn[q][p]) = (c, c, -s, s);
            // Columns first: turn[p][q] is row q of column p.
            let turn = DMat3::from_cols_array_2d(&turn);
            m = (turn.transpose() * DMat3::from_cols_array_2d(&m) * turn).to_cols_array_2d();
            axes *= turn;
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&a: &usize, &b: &usize| m[b][b].total_cmp(&m[a][a]));
    order.map(|i| axes.col(i))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quad(a: Vec3, b: Vec3) -> [[Vec3; 3]; 2] {
        [[Vec3::ZERO, a, a + b], [Vec3::ZERO, a + b, b]]
    }

    #[test]
    fn a_slanted_card_is_flat_and_open() {
        let (a, b) = (Vec3::new(3.0, 3.0, 0.0), Vec3::new(0.0, 0.0, 1.0));
        let shape = Shape::of(quad(a, b).into_iter());
        assert!(shape.open > 0.999 && shape.widths[2] < 1e-5, "{shape:?}");
        assert!((shape.area - a.length()).abs() < 1e-5);
        assert!(shape.axes[0].dot(a.normalize()).abs() > 0.9, "{shape:?}");
        assert!(shape.axes[2].dot(a.cross(b).normalize()).abs() > 0.999);
    }

    #[test]
    fn a_box_is_closed_and_fills_its_box() {
        let sides = Vec3::new(1.0, 2.0, 5.0);
        let mut triangles = Vec::new();
        for axis in 0..3 {
            let mut a = Vec3::ZERO;
            let mut b = Vec3::ZERO;
            a[(axis + 1) % 3] = sides[(axis + 1) % 3];
            b[(axis + 2) % 3] = sides[(axis + 2) % 3];
            let mut up = Vec3::ZERO;
            up[axis] = sides[axis];
            triangles.extend(quad(b, a));
            triangles.extend(quad(a, b).map(|corners| corners.map(|p| p + up)));
        }
        let shape = Shape::of(triangles.into_iter());
        assert!(shape.open < 1e-6 && (shape.solid - 1.0).abs() < 1e-3, "{shape:?}");
        assert!((shape.slenderness() - 2.5).abs() < 1e-3, "{shape:?}");
    }

    #[test]
    fn points_and_lines_have_finite_shapes() {
        for corners in [[Vec3::ZERO; 3], [Vec3::ZERO, Vec3::X, 2.0 * Vec3::X]] {
            let shape = Shape::of([corners].into_iter());
            assert!(shape.axes.iter().all(|axis| axis.is_normalized()), "{shape:?}");
            assert!(shape.solid.is_finite() && shape.open.is_finite());
        }
    }
}
