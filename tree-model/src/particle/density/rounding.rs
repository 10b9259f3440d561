//! The crown's horizontal sections as ellipses: what two silhouettes leave open.
//!
//! For every height each view tells how far the crown reaches to its left and right: a strip. The ellipse
//! dᵀ M d = w² touches strips of half width w across the directions d. M is found by least squares with a
//! pull towards a circle, its centre by least squares with a pull towards the axis; so one view gives a
//! circle, two at a right angle an ellipse along their axes, and opposite views agree on a circle.
//!
//! Not in the thesis, which takes boxes as they are.

use super::super::camera::{Camera, Projector};
use super::coverage::Coverage;
use glam::{DMat3, DVec3, Mat2, Vec2, Vec3};

/// Pull of ellipses towards a circle, beside 1 for each view. Small, so that two views decide.
const ROUND: f64 = 0.01;
/// Pull of centres towards the axis, beside 1 for each view.
const CENTRED: f32 = 0.01;
/// Least ratio of an ellipse's axes: narrower ones come from views that contradict each other.
const NARROWEST: f32 = 0.2;
/// Least half axis in voxels, so that trunks thinner than a voxel stay.
const THINNEST: f32 = 0.6;
/// Half width of the edge in voxels over which the weight falls.
const EDGE: f32 = 0.75;
/// Rows of voxels over which widths are averaged, to either side.
const ROWS: f32 = 1.0;

/// How far a view shows the tree to reach sideways, at one height or altogether.
#[derive(Clone, Copy, Debug)]
pub(super) struct Strip {
    /// Across the view, in x and z.
    pub(super) along: Vec2,
    /// Middle along it in metres from the axis.
    pub(super) middle: f32,
    /// Half width in metres.
    pub(super) half: f32,
    /// It reaches the picture's border, so that it may be wider.
    pub(super) open: bool,
}

impl Strip {
    /// The strip from `left` to `right`, in metres from the axis.
    pub(super) fn new(camera: &Camera, left: f32, right: f32, open: bool) -> Self {
        let right_hand = camera.frame().right;
        let mut half = 0.5 * (right - left);
        if let Some(eye) = camera.eye() {
            // Lines from the eye touch a circle before its widest place.
            let distance = Vec2::new(eye.x, eye.z).length().max(1e-6);
            half /= (1.0 + (half / distance) * (half / distance)).sqrt();
        }
        let along = Vec2::new(right_hand.x, right_hand.z);
        Self { along, middle: 0.5 * (left + right), half, open }
    }
}

/// A horizontal ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ellipse {
    center: Vec2,
    /// M: the squared half width across a unit vector d is dᵀ M d.
    shape: Mat2,
    /// M⁻¹.
    inverse: Mat2,
}

impl Ellipse {
    /// 1 inside, 0 outside, a soft edge about a voxel wide between.
    pub(super) fn weight(&self, point: Vec2, voxel: f32) -> f32 {
        let off = point - self.center;
        let distance = off.length();
        let share = off.dot(self.inverse * off).max(0.0).sqrt();
        if share <= 1e-6 {
            return 1.0;
        }
        let beyond = (distance - distance / share) / voxel;
        (0.5 - 0.5 * beyond / EDGE).clamp(0.0, 1.0)
    }

    /// Centre in x and z.
    pub(super) fn center(&self) -> Vec2 {
        self.center
    }

    /// The box around it, in x and z.
    #[cfg(test)]
    fn bounds(&self) -> (Vec2, Vec2) {
        let half = Vec2::new(self.shape.x_axis.x, self.shape.y_axis.y).max(Vec2::ZERO);
        let half = Vec2::new(half.x.sqrt(), half.y.sqrt());
        (self.center - half, self.center + half)
    }
}

/// The ellipse of the row of voxels at height `y`; `None` where no view sees it.
pub(super) fn ellipse(
    cameras: &[(&Camera, Projector)],
    coverages: &[Coverage],
    y: f32,
    voxel: f32,
) -> Option<Ellipse> {
    let strips: Vec<Strip> = cameras
        .iter()
        .zip(coverages)
        .filter_map(|((camera, projector), coverage)| strip(camera, projector, coverage, y, voxel))
        .collect();
    let closed: Vec<Strip> = strips.iter().copied().filter(|strip| !strip.open).collect();
    fit(if closed.is_empty() { &strips } else { &closed }, THINNEST * voxel)
}

fn strip(
    camera: &Camera,
    projector: &Projector,
    coverage: &Coverage,
    y: f32,
    voxel: f32,
) -> Option<Strip> {
    let axis = Vec3::new(0.0, y, 0.0);
    let at = projector.project(axis)?;
    let scale = projector.pixel_size(axis);
    let (left, right) = coverage.reach(at.y, ROWS * voxel / scale)?;
    let open = left <= 0.0 || right >= coverage.size().x;
    Some(Strip::new(camera, (left - at.x) * scale, (right - at.x) * scale, open))
}

/// The ellipse that best touches the strips; half axes at least `thinnest`.
pub(super) fn fit(strips: &[Strip], thinnest: f32) -> Option<Ellipse> {
    let largest = strips.iter().map(|strip| strip.half).fold(0.0, f32::max);
    if strips.is_empty() || !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    // Unknowns a, b, c of M = [[a, b], [b, c]], in units of the largest width.
    let mut normal = DMat3::ZERO;
    let mut right = DVec3::ZERO;
    let (mut pull, mut toward) = (Mat2::from_diagonal(Vec2::splat(CENTRED)), Vec2::ZERO);
    for strip in strips {
        let d = strip.along.as_dvec2();
        let row = DVec3::new(d.x * d.x, 2.0 * d.x * d.y, d.y * d.y);
        let half = f64::from(strip.half / largest);
        normal += DMat3::from_cols(row * row.x, row * row.y, row * row.z);
        right += row * (half * half);
        pull += Mat2::from_cols(strip.along * strip.along.x, strip.along * strip.along.y);
        toward += strip.along * strip.middle;
    }
    for row in [DVec3::new(1.0, 0.0, -1.0), DVec3::new(0.0, 2.0, 0.0)] {
        normal += ROUND * DMat3::from_cols(row * row.x, row * row.y, row * row.z);
    }
    let found = normal.inverse() * right;
    let center = pull.inverse() * toward;
    let (shape, inverse) = bounded(found.as_vec3(), thinnest / largest);
    let unit = largest * largest;
    let ellipse = Ellipse { center, shape: shape * unit, inverse: inverse * (1.0 / unit) };
    (center.is_finite() && ellipse.inverse.is_finite()).then_some(ellipse)
}

/// M with half axes of `thinnest` at least, none much shorter than the other; and its inverse.
fn bounded(m: Vec3, thinnest: f32) -> (Mat2, Mat2) {
    let (mean, lean) = (0.5 * (m.x + m.z), 0.5 * (m.x - m.z));
    let spread = (lean * lean + m.y * m.y).sqrt();
    let high = (mean + spread).max(thinnest * thinnest);
    let low = (mean - spread).max(NARROWEST * NARROWEST * high).max(thinnest * thinnest);
    // The unit matrix turned by the double angle of the longer axis.
    let turn = if spread > 0.0 { Vec2::new(lean, m.y) / spread } else { Vec2::X };
    let matrix = |high: f32, low: f32| {
        let (mean, half) = (0.5 * (high + low), 0.5 * (high - low));
        let (c, s) = (half * turn.x, half * turn.y);
        Mat2::from_cols(Vec2::new(mean + c, s), Vec2::new(s, mean - c))
    };
    (matrix(high, low), matrix(1.0 / high, 1.0 / low))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(angle: f32, middle: f32, half: f32) -> Strip {
        let (sin, cos) = libm::sincosf(angle);
        Strip { along: Vec2::new(cos, -sin), middle, half, open: false }
    }

    fn bounds(strips: &[Strip]) -> [f32; 4] {
        let (low, high) = fit(strips, 0.01).unwrap().bounds();
        [low.x, low.y, high.x, high.y]
    }

    fn close(found: [f32; 4], wanted: [f32; 4]) {
        let near = found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 0.05);
        assert!(near, "{found:?} {wanted:?}");
    }

    #[test]
    fn one_view_gives_a_circle_around_the_axis() {
        close(bounds(&[strip(0.0, 1.0, 2.0)]), [-1.0, -2.0, 3.0, 2.0]);
        close(bounds(&[strip(0.8, 0.0, 2.0)]), [-2.0, -2.0, 2.0, 2.0]);
    }

    #[test]
    fn two_views_at_a_right_angle_give_their_widths() {
        let views = [strip(0.0, 1.0, 2.0), strip(std::f32::consts::FRAC_PI_2, 0.5, 1.0)];
        close(bounds(&views), [-1.0, -1.5, 3.0, 0.5]);
    }

    #[test]
    fn opposite_views_give_a_circle() {
        let views = [strip(0.0, 0.5, 2.0), strip(std::f32::consts::PI, -0.5, 2.0)];
        close(bounds(&views), [-1.5, -2.0, 2.5, 2.0]);
    }

    #[test]
    fn contradicting_views_give_a_narrow_but_true_ellipse() {
        let views = [strip(0.0, 0.0, 0.0), strip(0.1, 0.0, 2.0), strip(1.5, 0.0, 0.1)];
        let ellipse = fit(&views, 0.01).unwrap();
        assert!(ellipse.inverse.determinant() > 0.0);
        assert!(fit(&[strip(0.0, 0.0, 0.0)], 0.01).is_none());
    }

    #[test]
    fn the_weight_falls_over_the_edge() {
        let ellipse = fit(&[strip(0.0, 0.0, 2.0)], 0.01).unwrap();
        let weight = |x| ellipse.weight(Vec2::new(x, 0.0), 0.1);
        assert_eq!((weight(0.0), weight(1.8), weight(2.2)), (1.0, 1.0, 0.0));
        assert!((weight(2.0) - 0.5).abs() < 0.05);
    }
}
