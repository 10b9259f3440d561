//! Strokes of an SVG drawing.

use crate::error::{ModelError, Result};
use crate::sketch::{Drawing, Role, Stroke};
use crate::svg::{self, Ink, Paint, Shape};
use glam::Vec2;

/// Green: it outweighs red and blue by at least this many of 255.
const GREEN: u8 = 16;

/// Reads the strokes of an SVG drawing: paths, lines, polylines, polygons, rectangles, circles and ellipses with
/// all transforms, one stroke for each subpath, in units of the drawing. What is not seen (no fill and no stroke,
/// `display: none`, `visibility: hidden`, no opacity) is left out; so is a fill that fades out to nothing, as shadows
/// do.
///
/// * **Role**, the first that holds: by a whole word, in any case, in the id, class, layer label or name of the
///   element, or else of the groups around it from the inside out: *trunk*, *stem*; *branch*, *limb*, *twig*;
///   *crown*, *outline*, *foliage*, *leaves*, *canopy*. By colour: what is green is the crown. Anything else is left
///   to clean-up.
/// * **Filled** is what has a fill and no stroke, and what has both and is closed.
/// * **Name** is the element's id.
///
/// Style sheets (`<style>`), `<use>` and texts are not read.
///
/// # Errors
/// [`ModelError::Svg`] when the text is no SVG or draws nothing.
///
/// # Complexity
/// O(bytes + points).
pub fn from_svg(text: &str) -> Result<Drawing> {
    let mut drawing = Drawing::default();
    for shape in svg::read(text)?.shapes {
        if shape.paint.is_seen() {
            drawing.strokes.extend(strokes(&shape));
        }
    }
    if drawing.strokes.is_empty() {
        return Err(ModelError::Svg("no line or shape that is seen was found".into()));
    }
    Ok(drawing)
}

fn strokes(shape: &Shape) -> impl Iterator<Item = Stroke> + '_ {
    let Paint { fill, stroke, .. } = shape.paint;
    let role = shape.role.or_else(|| role_of(stroke.or(fill)?));
    shape.contours.iter().map(move |contour| Stroke {
        points: contour.points.iter().map(|p| Vec2::new(p.x as f32, p.y as f32)).collect(),
        role,
        closed: contour.closed,
        filled: fill.is_some() && (stroke.is_none() || contour.closed),
        name: shape.id.clone().unwrap_or_default(),
    })
}

fn role_of(ink: Ink) -> Option<Role> {
    let Ink::Plain([red, green, blue]) = ink else { return None };
    (green >= red.max(blue).saturating_add(GREEN)).then_some(Role::Crown)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(body: &str) -> Vec<Stroke> {
        from_svg(&format!("<svg xmlns='http://www.w3.org/2000/svg'>{body}</svg>")).unwrap().strokes
    }

    const LINE: &str = "x1='0' y1='9' x2='3' y2='0' stroke='#000'";

    #[test]
    fn a_name_on_the_element_or_a_group_says_what_a_line_shows() {
        for (body, role) in [
            (format!("<line id='Trunk' {LINE}/>"), Some(Role::Trunk)),
            (format!("<g class='my main-STEM'><line {LINE}/></g>"), Some(Role::Trunk)),
            (format!("<g id='crown'><g><line id='limb2' {LINE}/></g></g>"), Some(Role::Branch)),
            (format!("<g id='branches'><g id='x'><line {LINE}/></g></g>"), Some(Role::Branch)),
            (format!("<g name='Canopy_left'><line {LINE}/></g>"), Some(Role::Crown)),
            (format!("<line id='branchless' {LINE}/>"), None),
        ] {
            assert_eq!(read(&body)[0].role, role, "{body}");
        }
    }

    #[test]
    fn a_layer_of_inkscape_is_known_by_its_label() {
        let text = "<svg xmlns='http://www.w3.org/2000/svg' xmlns:i='http://www.inkscape.org/'>\
                    <g i:label='Leaves' id='layer1'><path d='M0 0h9' stroke='red'/></g></svg>";
        assert_eq!(from_svg(text).unwrap().strokes[0].role, Some(Role::Crown));
    }

    #[test]
    fn green_is_the_crown_however_it_is_written() {
        for green in
            ["green", "#0a0", "#228b22", "rgb(20,150,60)", "rgb(10%, 60%, 20%)", "hsl(120,50%,40%)"]
        {
            let body = format!("<g style='stroke: {green}'><path d='M0 0h9' fill='none'/></g>");
            assert_eq!(read(&body)[0].role, Some(Role::Crown), "{green}");
        }
        for other in ["brown", "black", "#5c2700", "grey", "blue", "currentColor", "nonsense"] {
            let body = format!("<path d='M0 0h9v3' style='stroke:{other}'/>");
            assert_eq!(read(&body)[0].role, None, "{other}");
        }
        let current = "<g color='lime' stroke='currentColor'><path d='M0 0h9'/></g>";
        assert_eq!(read(current)[0].role, Some(Role::Crown));
    }

    #[test]
    fn gradients_count_by_the_mean_of_their_colours_and_shadows_not_at_all() {
        let defs = "<defs><linearGradient id='a'><stop stop-color='#020'/>\
                    <stop style='stop-color:#4c4'/></linearGradient>\
                    <radialGradient id='b' xmlns:x='http://www.w3.org/1999/xlink' x:href='#a'/>\
                    <linearGradient id='s'><stop/><stop stop-opacity='0'/></linearGradient></defs>";
        let shapes = "<rect width='9' height='5' fill='url(#b)'/><circle r='4' fill='url(#s)'/>\
                      <circle r='4' fill='url(#pattern)'/>";
        let strokes = read(&format!("{defs}{shapes}"));
        assert_eq!(strokes.len(), 2);
        assert_eq!((strokes[0].role, strokes[0].filled), (Some(Role::Crown), true));
        assert_eq!((strokes[1].role, strokes[1].filled), (None, true));
    }

    #[test]
    fn an_area_is_filled_and_a_line_is_not() {
        for (body, filled) in [
            ("<path d='M0 0h9v9z'/>", true),
            ("<path d='M0 0h9v9' fill='none' stroke='red'/>", false),
            ("<path d='M0 0h9v9z' stroke='red'/>", true),
            ("<path d='M0 0h9v9' stroke='red'/>", false),
            ("<g fill='none' stroke='red'><path d='M0 0h9v9z'/></g>", false),
        ] {
            assert_eq!(read(body)[0].filled, filled, "{body}");
        }
    }

    #[test]
    fn what_is_not_seen_is_left_out() {
        for unseen in [
            "fill='none'",
            "style='display : none'",
            "style='visibility:hidden'",
            "opacity='0'",
            "fill-opacity='0%'",
            "fill='none' stroke='red' stroke-width='0px'",
        ] {
            let body = format!("<g {unseen}><path d='M0 0h9v9z'/></g><path d='M0 0h1v1z'/>");
            assert_eq!(read(&body).len(), 1, "{unseen}");
        }
    }

    #[test]
    fn every_subpath_and_shape_is_a_stroke() {
        let body = "<path d='M0 0h9 M3 3v9' stroke='red'/><polygon points='0,0 4,0 4,4'/>\
                    <rect width='8' height='6' rx='2' ry='1'/><ellipse rx='3' ry='2'/>\
                    <polyline points='0 0 1 1' stroke='red'/>";
        let strokes = read(body);
        assert_eq!(strokes.len(), 6);
        let corner = strokes[3].points.iter().any(|p| p.length() < 0.2);
        assert!(!corner, "the corner is round: {:?}", strokes[3].points);
        assert!(strokes[3].points.iter().all(|p| p.x > -0.01 && p.x < 8.01 && p.y < 6.01));
    }

    #[test]
    fn what_draws_nothing_is_an_error() {
        for text in ["", "<svg", "<svg xmlns='http://www.w3.org/2000/svg'/>", "<svg><g/></svg>"] {
            assert!(matches!(from_svg(text), Err(ModelError::Svg(_))), "{text}");
        }
    }
}
