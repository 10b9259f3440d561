//! Strokes from an SVG drawing made over a photograph.

use crate::error::{ModelError, Result, check};
use crate::svg;
use glam::Vec2;
use kurbo::Rect;

/// The strokes of a drawing, in pixels of a picture of `picture_size`: every path, line and polyline with
/// its transforms, a closed shape as a loop that [`from_strokes`](super::from_strokes) cuts open. The
/// drawing's view box (or its width and height) is stretched to the picture, as when it was drawn over it;
/// without either its units are pixels.
///
/// # Errors
/// [`ModelError::Svg`] when the text is no SVG or draws nothing; [`ModelError::Parameter`] for a picture
/// below one pixel or over 1e6.
pub fn strokes_from_svg(text: &str, picture_size: Vec2) -> Result<Vec<Vec<Vec2>>> {
    check("picture_size.x", picture_size.x, 1.0_f32, 1e6_f32)?;
    check("picture_size.y", picture_size.y, 1.0_f32, 1e6_f32)?;
    let (x, y) = (f64::from(picture_size.x), f64::from(picture_size.y));
    let drawing = svg::read(text)?;
    let view = drawing.view.unwrap_or(Rect::new(0.0, 0.0, x, y));
    let pixel = |p: &kurbo::Point| {
        let (u, v) = ((p.x - view.x0) / view.width(), (p.y - view.y0) / view.height());
        Vec2::new((u * x) as f32, (v * y) as f32)
    };
    let contours = drawing.shapes.iter().flat_map(|shape| &shape.contours);
    let strokes: Vec<Vec<Vec2>> =
        contours.map(|contour| contour.points.iter().map(pixel).collect()).collect();
    if strokes.is_empty() {
        return Err(ModelError::Svg("no path, polyline or line found".into()));
    }
    Ok(strokes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_view_box_is_stretched_to_the_picture() {
        let text = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='10 0 100 50'>\
                    <g transform='translate(10 0)'><line x1='0' y1='50' x2='50' y2='0'/></g>\
                    <path d='M 60 50 L 60 25'/></svg>";
        let strokes = strokes_from_svg(text, Vec2::new(400.0, 300.0)).unwrap();
        assert_eq!(strokes[0], [Vec2::new(0.0, 300.0), Vec2::new(200.0, 0.0)]);
        assert_eq!(strokes[1], [Vec2::new(200.0, 300.0), Vec2::new(200.0, 150.0)]);
    }

    #[test]
    fn without_a_view_units_are_pixels() {
        let text = "<svg xmlns='http://www.w3.org/2000/svg'><polyline points='1,2 3,4'/></svg>";
        let strokes = strokes_from_svg(text, Vec2::new(400.0, 300.0)).unwrap();
        assert_eq!(strokes, [[Vec2::new(1.0, 2.0), Vec2::new(3.0, 4.0)]]);
    }

    #[test]
    fn drawings_without_strokes_and_bad_sizes_are_errors() {
        let empty = "<svg xmlns='http://www.w3.org/2000/svg'/>";
        assert!(matches!(strokes_from_svg(empty, Vec2::ONE), Err(ModelError::Svg(_))));
        assert!(matches!(strokes_from_svg("<svg", Vec2::ONE), Err(ModelError::Svg(_))));
        assert!(strokes_from_svg(empty, Vec2::NAN).is_err());
        let flat = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 0 0'>\
                    <polyline points='1,2 3,4'/></svg>";
        assert_eq!(strokes_from_svg(flat, Vec2::splat(9.0)).unwrap()[0][0], Vec2::new(1.0, 2.0));
    }
}
