//! A volume of revolution from a drawing (Xu & Mould 2012, §3.3.1, Fig. 8): an SVG file with either
//! a curve beside an axis, or the whole outline of a tree.
//!
//! * A closed shape is an outline: at every height, half of its full width becomes the radius.
//! * An open curve is a profile: its distance from the axis becomes the radius. The axis is an
//!   element whose id is `axis`, and otherwise the vertical through the curve's leftmost point.
//!
//! Transforms are honoured; `defs`, clip paths and hidden elements are skipped; colours do not
//! matter.

use crate::error::{ModelError, Result, check};
use crate::svg::{self, Contour};
use glam::{Vec2, Vec3};
use kurbo::Point;
use tree_core::Volume;

/// Heights at which an outline's width is taken.
const ROWS: usize = 160;

/// How a drawing becomes a profile.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileOptions {
    /// Height of the tree in metres, 0.01 to 10,000. Default 10.
    pub height: f32,
    /// Factor on all radii, 0.01 to 100. Default 1.
    pub widen: f32,
}

impl Default for ProfileOptions {
    fn default() -> Self {
        Self { height: 10.0, widen: 1.0 }
    }
}

/// A drawn profile: radius over height, from the ground up.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// Points (radius, height) in metres.
    pub points: Vec<Vec2>,
    /// Whether it was taken from a closed outline.
    pub from_outline: bool,
}

impl Profile {
    /// Reads the drawing.
    ///
    /// # Errors
    /// [`ModelError::Svg`] when the text is no SVG or holds nothing to use,
    /// [`ModelError::Parameter`] for options out of range.
    pub fn from_svg(text: &str, options: &ProfileOptions) -> Result<Self> {
        check("height", options.height, 0.01, 10_000.0)?;
        check("widen", options.widen, 0.01, 100.0)?;
        let mut drawing = Drawing::default();
        for shape in svg::read(text)?.shapes {
            if shape.id.is_some_and(|id| id.eq_ignore_ascii_case("axis")) {
                drawing.axis = Some(shape.bounds.center().x);
            } else {
                drawing.contours.extend(shape.contours);
            }
        }
        drawing.profile(options)
    }

    /// The solid of revolution round a vertical axis through `base`.
    ///
    /// # Errors
    /// [`ModelError::Core`] when the profile encloses nothing.
    pub fn volume(&self, base: Vec3) -> Result<Volume> {
        Ok(Volume::revolution(base, Vec3::Y, self.points.clone())?)
    }
}

/// The contours of a drawing, in its own units, y downwards.
#[derive(Default)]
struct Drawing {
    contours: Vec<Contour>,
    axis: Option<f64>,
}

impl Drawing {
    fn profile(&self, options: &ProfileOptions) -> Result<Profile> {
        let closed: Vec<&Contour> = self.contours.iter().filter(|c| c.closed).collect();
        let (points, from_outline) = if closed.is_empty() {
            (self.beside_axis()?, false)
        } else {
            (half_widths(&closed)?, true)
        };
        let low = points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
        let high = points.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max);
        if low >= high || points.iter().all(|p| p.x <= 0.0) {
            return Err(ModelError::Svg("the drawing has no height or no width".into()));
        }
        let scale = f64::from(options.height) / (high - low);
        let widen = f64::from(options.widen);
        let points = points
            .iter()
            .map(|p| Vec2::new((p.x * scale * widen) as f32, ((p.y - low) * scale) as f32))
            .collect();
        Ok(Profile { points, from_outline })
    }

    /// The longest open curve as (distance from the axis, height).
    fn beside_axis(&self) -> Result<Vec<Point>> {
        let extent = |contour: &&Contour| {
            contour.points.windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>()
        };
        let curve = self
            .contours
            .iter()
            .max_by(|a, b| extent(a).total_cmp(&extent(b)))
            .ok_or_else(|| ModelError::Svg("no path, polyline or other shape found".into()))?;
        let leftmost = curve.points.iter().map(|p| p.x).fold(f64::INFINITY, f64::min);
        let axis = self.axis.unwrap_or(leftmost);
        Ok(curve.points.iter().map(|p| Point::new((p.x - axis).abs(), -p.y)).collect())
    }
}

/// Half the full width of all contours together, at even heights from the lowest point up.
fn half_widths(contours: &[&Contour]) -> Result<Vec<Point>> {
    let ys = || contours.iter().flat_map(|c| c.points.iter().map(|p| p.y));
    let (top, bottom) =
        (ys().fold(f64::INFINITY, f64::min), ys().fold(f64::NEG_INFINITY, f64::max));
    let mut points = Vec::with_capacity(ROWS + 1);
    for row in 0..=ROWS {
        // The outermost rows lie just inside, where the outline still has a width.
        let share = (row as f64 / ROWS as f64).clamp(1e-4, 1.0 - 1e-4);
        let y = bottom + (top - bottom) * share;
        let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
        for contour in contours {
            let n = contour.points.len();
            for i in 0..n {
                let (a, b) = (contour.points[i], contour.points[(i + 1) % n]);
                // Half open, so that a point on the row counts once.
                if (a.y <= y) != (b.y <= y) {
                    let x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
                    left = left.min(x);
                    right = right.max(x);
                }
            }
        }
        if right > left {
            points.push(Point::new(0.5 * (right - left), -y));
        }
    }
    if points.len() < 2 {
        return Err(ModelError::Svg("the outline encloses nothing".into()));
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn svg(body: &str) -> String {
        format!("<svg xmlns='http://www.w3.org/2000/svg'>{body}</svg>")
    }

    fn radius_at(profile: &Profile, height: f32) -> f32 {
        let by_distance =
            |a: &&Vec2, b: &&Vec2| (a.y - height).abs().total_cmp(&(b.y - height).abs());
        profile.points.iter().min_by(by_distance).unwrap().x
    }

    #[test]
    fn an_outline_gives_half_its_width_at_each_height() {
        // A triangle 4 wide and 8 high, drawn with y downwards and moved aside.
        let text = svg("<g transform='translate(100 50)'><polygon points='0,8 4,8 2,0'/></g>");
        let profile = Profile::from_svg(&text, &ProfileOptions::default()).unwrap();
        assert!(profile.from_outline);
        assert!((radius_at(&profile, 0.0) - 2.5).abs() < 0.01, "base");
        assert!((radius_at(&profile, 5.0) - 1.25).abs() < 0.02, "middle");
        assert!(radius_at(&profile, 10.0) < 0.01, "top");
    }

    #[test]
    fn a_curve_gives_its_distance_from_the_axis() {
        let text = svg("<line id='axis' x1='10' y1='0' x2='10' y2='9'/>\
                        <path fill='none' d='M12 10 L15 5 L11 0'/>");
        let profile =
            Profile::from_svg(&text, &ProfileOptions { height: 10.0, widen: 2.0 }).unwrap();
        assert_eq!(
            profile.points,
            [Vec2::new(4.0, 0.0), Vec2::new(10.0, 5.0), Vec2::new(2.0, 10.0)]
        );
    }

    #[test]
    fn without_an_axis_the_leftmost_point_is_on_it() {
        let text = svg("<polyline points='3,10 7,5 3,0'/>");
        // Ends apart, so it is open although the axis would close it.
        let profile = Profile::from_svg(&text, &ProfileOptions::default()).unwrap();
        assert!(!profile.from_outline);
        assert!((radius_at(&profile, 5.0) - 4.0).abs() < 1e-4);
    }

    #[test]
    fn drawings_that_cannot_be_used_say_why() {
        let fails = |text: &str| {
            let error = Profile::from_svg(text, &ProfileOptions::default()).unwrap_err();
            assert!(matches!(error, ModelError::Svg(_)), "{error}");
        };
        fails("");
        fails("<svg");
        fails(&svg(""));
        fails(&svg("<path d='M0 0 L nonsense'/>"));
        fails(&svg("<path d='M0 0 L 10 0 Z'/>"));
        fails(&svg("<polyline points='1,x'/>"));
        fails(&svg("<circle r='1e300'/>"));
        fails(&svg("<circle r='inf'/>"));
        fails(&svg("<rect width='50%' height='3'/>"));
        fails(&svg("<path d='M0 0 A 1e300 1e300 0 0 1 1e300 5 Z'/>"));
        fails(&svg("<g transform='wobble(1)'><circle r='3'/></g>"));
        fails(&svg(&format!("{}{}", "<g>".repeat(100), "</g>".repeat(100))));
        let options = ProfileOptions { height: f32::NAN, ..Default::default() };
        let error = Profile::from_svg(&svg("<circle r='3'/>"), &options).unwrap_err();
        assert!(matches!(error, ModelError::Parameter(_)));
    }

    #[test]
    fn hidden_things_and_definitions_do_not_count() {
        let text = svg("<defs><circle r='50'/></defs><circle r='90' style='display: none'/>\
                        <circle cx='5' cy='5' r='2'/>");
        let profile = Profile::from_svg(&text, &ProfileOptions::default()).unwrap();
        let widest = profile.points.iter().map(|p| p.x).fold(0.0, f32::max);
        assert!((widest - 5.0).abs() < 0.05, "{widest}");
    }
}
