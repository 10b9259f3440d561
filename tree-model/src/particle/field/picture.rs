//! A picture of a direction field, to look at.

use super::DirectionField;
use crate::error::Result;
use crate::particle::Photo;
use crate::particle::draw::{Canvas, Color};
use glam::Vec2;

/// Pixels between arrows in a picture of the field, about.
const ARROW_SPACING: f32 = 14.0;

impl DirectionField {
    /// Arrows drawn over a photograph or any other picture of the same size.
    ///
    /// # Errors
    /// None that can happen.
    pub fn draw_over(&self, photo: &Photo, color: Color) -> Result<Photo> {
        let mut canvas = Canvas::over(photo);
        let across = (photo.width() as f32 / ARROW_SPACING).ceil() as u32;
        let down = (photo.height() as f32 / ARROW_SPACING).ceil() as u32;
        for y in 0..down {
            for x in 0..across {
                let at = ARROW_SPACING * (Vec2::new(x as f32, y as f32) + 0.5);
                let arrow = 0.4 * ARROW_SPACING * self.sample(at) * Vec2::new(1.0, -1.0);
                if arrow != Vec2::ZERO {
                    canvas.arrow(at - arrow, at + arrow, 1.0, color);
                }
            }
        }
        canvas.finish()
    }

    /// One pixel for each cell: red is x and green is y, 128 for none.
    ///
    /// # Errors
    /// [`ModelError::Picture`](crate::ModelError::Picture) for a field without cells.
    pub fn to_photo(&self) -> Result<Photo> {
        let channel = |value: f32| (127.5 + 127.0 * value.clamp(-1.0, 1.0) + 0.5) as u8;
        let color = |v: &Vec2| [channel(v.x), channel(v.y), 128, 255];
        Photo::new(self.size[0], self.size[1], self.vectors.iter().map(color).collect())
    }
}
