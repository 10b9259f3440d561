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
use glam::{Vec2, Vec3};
use kurbo::{Affine, BezPath, Circle, Ellipse, PathEl, Point, Rect, Shape};
use roxmltree::{Document, Node, ParsingOptions};
use std::str::FromStr;
use tree_core::Volume;

/// Heights at which an outline's width is taken.
const ROWS: usize = 160;

/// Deviation allowed when curves become polylines, as a share of the drawing's size.
const FLATNESS: f64 = 5e-4;

/// Ends closer than this share of the drawing's size close a contour.
const CLOSED_GAP: f64 = 0.01;

/// Deepest nesting of SVG groups followed: a drawing program makes a dozen, a hostile file
/// thousands.
const MAX_DEPTH: u32 = 64;

/// Largest coordinate: beyond that, curves cannot be cut into a sensible number of lines.
const MAX_NUMBER: f64 = 1e7;

/// Most elements and texts in a drawing: a traced picture has tens of thousands.
const MAX_NODES: u32 = 1_000_000;

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
        // Drawing programs write a document type; entities in it are expanded within roxmltree's
        // own bounds.
        let parsing =
            ParsingOptions { allow_dtd: true, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
        let document = Document::parse_with_options(text, parsing)
            .map_err(|error| ModelError::Svg(error.to_string()))?;
        let mut drawing = Drawing::default();
        drawing.collect(document.root_element(), Affine::IDENTITY, 0)?;
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

struct Contour {
    points: Vec<Point>,
    closed: bool,
}

impl Drawing {
    fn collect(&mut self, node: Node<'_, '_>, outer: Affine, depth: u32) -> Result<()> {
        const SKIPPED: [&str; 9] = [
            "defs", "clipPath", "mask", "marker", "metadata", "pattern", "symbol", "style", "title",
        ];
        if depth > MAX_DEPTH {
            return Err(ModelError::Svg(format!("groups nest deeper than {MAX_DEPTH}")));
        }
        let name = node.tag_name().name();
        if SKIPPED.contains(&name) || is_hidden(node) {
            return Ok(());
        }
        let affine = outer * transform(node)?;
        if let Some(path) = outline(node)? {
            self.add(node, &(affine * path));
        }
        node.children()
            .filter(Node::is_element)
            .try_for_each(|child| self.collect(child, affine, depth + 1))
    }

    fn add(&mut self, node: Node<'_, '_>, path: &BezPath) {
        let bounds = path.bounding_box();
        let size = bounds.width().max(bounds.height());
        let corner = bounds.x0.abs().max(bounds.y0.abs());
        if !(size > 0.0 && size <= MAX_NUMBER && corner <= MAX_NUMBER) {
            return;
        }
        if node.attribute("id").is_some_and(|id| id.eq_ignore_ascii_case("axis")) {
            self.axis = Some(bounds.center().x);
            return;
        }
        let mut contour = Contour { points: Vec::new(), closed: false };
        let mut finished = Vec::new();
        kurbo::flatten(path.iter(), FLATNESS * size, |element| match element {
            PathEl::MoveTo(point) => {
                let next = Contour { points: vec![point], closed: false };
                finished.push(std::mem::replace(&mut contour, next));
            }
            PathEl::LineTo(point) => contour.points.push(point),
            PathEl::ClosePath => contour.closed = true,
            // Flattening leaves no curves.
            PathEl::QuadTo(..) | PathEl::CurveTo(..) => {}
        });
        finished.push(contour);
        for mut contour in finished.into_iter().filter(|contour| contour.points.len() > 1) {
            if let (Some(first), Some(last)) = (contour.points.first(), contour.points.last()) {
                contour.closed |=
                    contour.points.len() > 2 && first.distance(*last) < CLOSED_GAP * size;
            }
            self.contours.push(contour);
        }
    }

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

fn is_hidden(node: Node<'_, '_>) -> bool {
    node.attribute("display") == Some("none")
        || node.attribute("visibility") == Some("hidden")
        || node
            .attribute("style")
            .is_some_and(|style| style.replace(' ', "").contains("display:none"))
}

fn transform(node: Node<'_, '_>) -> Result<Affine> {
    let Some(text) = node.attribute("transform") else {
        return Ok(Affine::IDENTITY);
    };
    let t = svgtypes::Transform::from_str(text)
        .map_err(|error| ModelError::Svg(format!("transform '{text}': {error}")))?;
    Ok(Affine::new([t.a, t.b, t.c, t.d, t.e, t.f]))
}

/// The shape an element draws, before its transform.
fn outline(node: Node<'_, '_>) -> Result<Option<BezPath>> {
    let number = |name: &str| number(node, name);
    Ok(match node.tag_name().name() {
        "path" => {
            let data = node.attribute("d").unwrap_or("");
            let path = BezPath::from_svg(data)
                .map_err(|error| ModelError::Svg(format!("path data: {error}")))?;
            Some(path)
        }
        "polyline" => polyline(node, false)?,
        "polygon" => polyline(node, true)?,
        "line" => {
            let mut path = BezPath::new();
            path.move_to((number("x1")?, number("y1")?));
            path.line_to((number("x2")?, number("y2")?));
            Some(path)
        }
        "rect" => {
            let (x, y) = (number("x")?, number("y")?);
            let rect = Rect::new(x, y, x + number("width")?, y + number("height")?);
            Some(rect.to_path(1.0))
        }
        "circle" => {
            let (centre, r) = (Point::new(number("cx")?, number("cy")?), number("r")?.abs());
            Some(Circle::new(centre, r).to_path(FLATNESS * r))
        }
        "ellipse" => {
            let centre = Point::new(number("cx")?, number("cy")?);
            let radii = (number("rx")?.abs(), number("ry")?.abs());
            Some(Ellipse::new(centre, radii, 0.0).to_path(FLATNESS * radii.0.max(radii.1)))
        }
        _ => None,
    })
}

/// A length in user units; 0 where the attribute is missing, as SVG has it.
fn number(node: Node<'_, '_>, name: &str) -> Result<f64> {
    let Some(text) = node.attribute(name) else { return Ok(0.0) };
    match text.trim().trim_end_matches("px").parse::<f64>() {
        Ok(number) if number.abs() <= MAX_NUMBER => Ok(number),
        _ => Err(ModelError::Svg(format!(
            "{name}='{text}' is no length in user units of at most {MAX_NUMBER}"
        ))),
    }
}

fn polyline(node: Node<'_, '_>, close: bool) -> Result<Option<BezPath>> {
    let text = node.attribute("points").unwrap_or("");
    let numbers = text
        .split(|c: char| c.is_ascii_whitespace() || c == ',')
        .filter(|word| !word.is_empty())
        .map(|word| {
            word.parse::<f64>()
                .map_err(|_| ModelError::Svg(format!("points: '{word}' is no number")))
        })
        .collect::<Result<Vec<_>>>()?;
    let mut path = BezPath::new();
    for (i, pair) in numbers.chunks_exact(2).enumerate() {
        let point = Point::new(pair[0], pair[1]);
        if i == 0 { path.move_to(point) } else { path.line_to(point) }
    }
    if close && !path.is_empty() {
        path.close_path();
    }
    Ok((!path.is_empty()).then_some(path))
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
        assert!(matches!(error, ModelError::Parameter { .. }));
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
