//! Shapes from SVG drawings, as polylines: for profiles, for strokes over photographs and for sketches.
//!
//! Paths, lines, polylines, polygons, rectangles, circles and ellipses with all transforms. `defs`, clip
//! paths and hidden elements are skipped. What a shape is painted with and the names of the groups it is in come
//! with it; style sheets (`<style>`) are not read.

mod paint;

pub(crate) use paint::{Ink, Paint};

use crate::error::{ModelError, Result};
use crate::sketch::{Role, read::role_named};
use kurbo::{Affine, BezPath, Circle, Ellipse, PathEl, Point, Rect, RoundedRect, Shape as _};
use paint::{Inks, property};
use roxmltree::{Document, Node, ParsingOptions};
use std::str::FromStr;

/// Deviation allowed when curves become polylines, as a share of the shape's size.
const FLATNESS: f64 = 5e-4;

/// Ends closer than this share of the shape's size close a contour.
const CLOSED_GAP: f64 = 0.01;

/// Deepest nesting of SVG groups followed: a drawing program makes a dozen, a hostile file
/// thousands.
const MAX_DEPTH: u32 = 64;

/// Largest coordinate: beyond that, curves cannot be cut into a sensible number of lines.
const MAX_NUMBER: f64 = 1e7;

/// Most elements and texts in a drawing: a traced picture has tens of thousands.
const MAX_NODES: u32 = 1_000_000;

/// What a drawing shows, in its own units, y downwards.
#[derive(Default)]
pub(crate) struct Drawing {
    pub(crate) shapes: Vec<Shape>,
    /// Every element but the outermost: shapes, and the groups they are in.
    pub(crate) elements: Vec<Element>,
    /// What the drawing shows of its plane: its view box, or its width and height.
    pub(crate) view: Option<Rect>,
}

/// What one element draws.
pub(crate) struct Shape {
    pub(crate) id: Option<String>,
    pub(crate) bounds: Rect,
    pub(crate) contours: Vec<Contour>,
    pub(crate) paint: Paint,
    /// What it shows in a sketch, by a name (id, class, label, name) of its own or of the innermost group that has
    /// such a name.
    pub(crate) role: Option<Role>,
    /// Whether it is filled by the even-odd rule.
    pub(crate) even_odd: bool,
    /// Index of its element.
    pub(crate) element: Option<usize>,
}

/// A named place in a drawing.
pub(crate) struct Element {
    /// Its id, class, label and name, those that it has.
    pub(crate) names: Vec<String>,
    /// Whether it is a group.
    pub(crate) is_group: bool,
    /// Index of the element it is in; `None` in the outermost.
    pub(crate) outer: Option<usize>,
}

/// The attributes that name an element, the first first.
const NAMING: [&str; 4] = ["id", "class", "label", "name"];

/// What an element has from the groups it is in.
#[derive(Clone, Copy)]
struct Inherited {
    affine: Affine,
    paint: Paint,
    role: Option<Role>,
    even_odd: bool,
    element: Option<usize>,
}

/// A polyline of at least two points.
pub(crate) struct Contour {
    pub(crate) points: Vec<Point>,
    pub(crate) closed: bool,
}

/// Reads a drawing.
///
/// # Errors
/// [`ModelError::Svg`] when the text is no SVG, or nests too deep, or holds numbers that cannot be read.
pub(crate) fn read(text: &str) -> Result<Drawing> {
    // Drawing programs write a document type; entities in it are expanded within roxmltree's
    // own bounds.
    let parsing =
        ParsingOptions { allow_dtd: true, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, parsing)
        .map_err(|error| ModelError::Svg(error.to_string()))?;
    let root = document.root_element();
    let mut drawing = Drawing { view: view(root), ..Drawing::default() };
    let outer = Inherited {
        affine: Affine::IDENTITY,
        paint: Paint::default(),
        role: None,
        even_odd: false,
        element: None,
    };
    drawing.collect(root, &outer, &Inks::of(root), 0)?;
    Ok(drawing)
}

/// The view box of a drawing, or else its size; `None` where it has neither.
fn view(root: Node<'_, '_>) -> Option<Rect> {
    if let Some(text) = root.attribute("viewBox") {
        let view = svgtypes::ViewBox::from_str(text).ok()?;
        return usable(Rect::new(view.x, view.y, view.x + view.w, view.y + view.h));
    }
    let length = |name: &str| root.attribute(name)?.trim().trim_end_matches("px").parse().ok();
    usable(Rect::new(0.0, 0.0, length("width")?, length("height")?))
}

/// A rectangle that has an area.
fn usable(rect: Rect) -> Option<Rect> {
    let sound = rect.is_finite() && rect.width() > 0.0 && rect.height() > 0.0;
    (sound && rect.x1.abs().max(rect.y1.abs()) <= MAX_NUMBER).then_some(rect)
}

impl Drawing {
    fn collect(
        &mut self,
        node: Node<'_, '_>,
        outer: &Inherited,
        inks: &Inks,
        depth: u32,
    ) -> Result<()> {
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
        // The whole drawing's name says nothing about a part of it.
        let (own, element) = if depth > 0 {
            let names = names(node).map(String::from).collect();
            self.elements.push(Element { names, is_group: name == "g", outer: outer.element });
            (role(node), Some(self.elements.len() - 1))
        } else {
            (None, None)
        };
        let even_odd = property(node, "fill-rule").map_or(outer.even_odd, |rule| rule == "evenodd");
        let here = Inherited {
            affine: outer.affine * transform(node)?,
            paint: outer.paint.within(node, inks),
            role: own.or(outer.role),
            even_odd,
            element,
        };
        if let Some(path) = outline(node)? {
            self.add(node, &(here.affine * path), &here);
        }
        node.children()
            .filter(Node::is_element)
            .try_for_each(|child| self.collect(child, &here, inks, depth + 1))
    }

    fn add(&mut self, node: Node<'_, '_>, path: &BezPath, here: &Inherited) {
        let bounds = path.bounding_box();
        let size = bounds.width().max(bounds.height());
        let corner = bounds.x0.abs().max(bounds.y0.abs());
        if !(size > 0.0 && size <= MAX_NUMBER && corner <= MAX_NUMBER) {
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
        finished.retain(|contour| contour.points.len() > 1);
        for contour in &mut finished {
            if let (Some(first), Some(last)) = (contour.points.first(), contour.points.last()) {
                contour.closed |=
                    contour.points.len() > 2 && first.distance(*last) < CLOSED_GAP * size;
            }
        }
        let id = node.attribute("id").map(String::from);
        let Inherited { paint, role, even_odd, element, .. } = *here;
        self.shapes.push(Shape { id, bounds, contours: finished, paint, role, even_odd, element });
    }
}

/// What the attributes that name an element say that it shows.
fn role(node: Node<'_, '_>) -> Option<Role> {
    names(node).find_map(role_named)
}

/// What an element is named: in the order of the list, not of the file.
fn names<'a>(node: Node<'a, 'a>) -> impl Iterator<Item = &'a str> {
    // Attributes are few.
    NAMING.iter().flat_map(move |name| {
        node.attributes().filter(move |a| a.name() == *name).map(|a| a.value())
    })
}

fn is_hidden(node: Node<'_, '_>) -> bool {
    property(node, "display") == Some("none")
        || matches!(property(node, "visibility"), Some("hidden" | "collapse"))
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
            let radius = |name: &str, other: &str| {
                number(if node.has_attribute(name) { name } else { other })
            };
            let (rx, ry) = (radius("rx", "ry")?.abs(), radius("ry", "rx")?.abs());
            Some(rounded(rect, rx, ry))
        }
        "circle" => {
            let (center, r) = (Point::new(number("cx")?, number("cy")?), number("r")?.abs());
            Some(Circle::new(center, r).to_path(FLATNESS * r))
        }
        "ellipse" => {
            let center = Point::new(number("cx")?, number("cy")?);
            let radii = (number("rx")?.abs(), number("ry")?.abs());
            Some(Ellipse::new(center, radii, 0.0).to_path(FLATNESS * radii.0.max(radii.1)))
        }
        _ => None,
    })
}

/// A rectangle with elliptic corners.
fn rounded(rect: Rect, rx: f64, ry: f64) -> BezPath {
    let (rx, ry) = (rx.min(0.5 * rect.width().abs()), ry.min(0.5 * rect.height().abs()));
    if !(rx > 0.0 && ry > 0.0) {
        return rect.to_path(1.0);
    }
    // kurbo knows round corners only: round ones are stretched.
    let stretch = Affine::scale_non_uniform(1.0, ry / rx);
    let round = RoundedRect::from_rect(stretch.inverse().transform_rect_bbox(rect), rx);
    stretch * round.to_path(FLATNESS * rx)
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
