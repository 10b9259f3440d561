//! The picture of a camera: what the shaders do, pixel by pixel.

use super::{Cards, PLANES, Plane, interval, noise, planes, weights};
use crate::error::{LodError, Result};
use crate::preview::{Camera, Picture, Projector, View};
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use tree_core::{Control, Resource};
use tree_mesh::Mesh;

/// A box ready to be drawn.
struct Drawn {
    number: u32,
    planes: [Plane; PLANES],
    intervals: [[f32; 2]; PLANES],
    radius: f32,
}

impl Cards {
    /// What a placed camera sees of some boxes: sRGB colour without light, alpha 0 or 255. This is the
    /// reference for the shaders.
    ///
    /// # Errors
    /// [`LodError::Parameter`] or [`LodError::Camera`] for a bad camera or a side outside 1 to 16,384;
    /// [`LodError::Impostor`] for a framed camera, a box that does not exist or an eye in the middle of a
    /// box; [`LodError::Limit`] over the limit of pixels.
    ///
    /// # Complexity
    /// O(pixels × boxes), in parallel over rows.
    pub fn view(
        &self,
        boxes: &[u32],
        camera: &Camera,
        [width, height]: [u32; 2],
        control: &Control,
    ) -> Result<Picture> {
        View { width, height, samples: 1, camera: *camera }.validate()?;
        let Camera::Placed(_) = camera else {
            return Err(LodError::Impostor("the camera must be placed: there is no mesh to frame"));
        };
        control.limits.check(Resource::Pixels, u64::from(width) * u64::from(height))?;
        let pose = camera.pose(&Mesh::default(), 1.0)?;
        let projector = Projector::new(&pose, width, height, 1.0);
        let drawn = boxes.iter().map(|&number| self.drawn(number, &projector));
        let drawn = drawn.collect::<Result<Vec<_>>>()?;
        let mut pixels = vec![0_u8; 4 * width as usize * height as usize];
        pixels.par_chunks_mut(4 * width as usize).enumerate().try_for_each(|(y, row)| {
            control.check()?;
            for (x, out) in row.as_chunks_mut::<4>().0.iter_mut().enumerate() {
                let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                *out = self.ray(&drawn, projector.ray(at.x, at.y), noise(at));
            }
            Ok::<_, LodError>(())
        })?;
        Ok(Picture { width, height, pixels })
    }

    fn drawn(&self, number: u32, projector: &Projector) -> Result<Drawn> {
        let leaf_box = self.boxes.get(number)?;
        let toward = if projector.perspective {
            projector.eye - leaf_box.center
        } else {
            -projector.forward
        };
        let weights = weights(leaf_box.half, leaf_box.turn.inverse() * toward)?;
        let intervals = std::array::from_fn(|plane| interval(&weights, plane));
        Ok(Drawn { number, planes: planes(leaf_box), intervals, radius: leaf_box.half.length() })
    }

    /// The nearest texel of the plane that the pixel picks in each box.
    fn ray(&self, drawn: &[Drawn], (origin, direction): (Vec3, Vec3), value: f32) -> [u8; 4] {
        let mut best = (f32::INFINITY, [0; 4]);
        for drawn in drawn {
            let from = drawn.planes[0].center - origin;
            if from.cross(direction).length_squared()
                > drawn.radius * drawn.radius * direction.length_squared()
            {
                continue;
            }
            let picked =
                drawn.intervals.iter().position(|[low, high]| *low <= value && value < *high);
            let Some(number) = picked else { continue };
            let plane = &drawn.planes[number];
            let distance = plane.normal.dot(from) / plane.normal.dot(direction);
            if !(distance > 0.0 && distance < best.0) {
                continue;
            }
            let at = direction * distance - from;
            let at = Vec2::new(plane.right.dot(at), plane.up.dot(at)) / plane.half;
            if at.abs().max_element() > 1.0 {
                continue;
            }
            let texel = self.texel_at(self.place(drawn.number, number, at));
            if texel[3] >= 128 {
                best = (distance, [texel[0], texel[1], texel[2], 255]);
            }
        }
        best.1
    }

    /// Colour of the nearest texel, alpha between the four around.
    fn texel_at(&self, place: Vec2) -> [u8; 4] {
        let (texels, _) = self.color.pixels.as_chunks::<4>();
        let at = |x: i32, y: i32| {
            let x = x.clamp(0, self.color.width as i32 - 1) as usize;
            let y = y.clamp(0, self.color.height as i32 - 1) as usize;
            texels.get(y * self.color.width as usize + x).copied().unwrap_or_default()
        };
        let (low, f) = ((place - 0.5).floor(), place - 0.5 - (place - 0.5).floor());
        let (x, y) = (low.x as i32, low.y as i32);
        let mix =
            |a: [u8; 4], b: [u8; 4]| f32::from(a[3]) + f.x * (f32::from(b[3]) - f32::from(a[3]));
        let (top, bottom) = (mix(at(x, y), at(x + 1, y)), mix(at(x, y + 1), at(x + 1, y + 1)));
        let [r, g, b, _] = at(place.x as i32, place.y as i32);
        [r, g, b, (top + f.y * (bottom - top) + 0.5) as u8]
    }
}
