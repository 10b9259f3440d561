//! Pictures of what the stages did, for people to look at.

use super::stages::Session;
use crate::error::{ModelError, Result};
use crate::particle::draw::{Canvas, Color};
use crate::particle::{Grid, Photo};
use glam::{IVec3, Vec2};
use tree_core::{Control, NO_PARENT};

const RED: Color = [230, 40, 30, 255];
const BLUE: Color = [30, 90, 230, 255];
const YELLOW: Color = [255, 210, 0, 255];
const WHITE: Color = [255, 255, 255, 255];
/// Arrows across a picture of a direction field.
const ARROWS: f32 = 48.0;
/// Slices in a picture of a density.
const SLICES: usize = 12;
/// Slices side by side.
const SLICES_ACROSS: usize = 4;
/// Pixels for a voxel.
const VOXEL_PIXELS: usize = 4;
/// Widths of lines, as shares of the picture's height.
const THIN: f32 = 0.0025;
const THICK: f32 = 0.005;

impl Session {
    /// A view's matte: white where the tree covers.
    ///
    /// # Errors
    /// [`ModelError::View`] for a view that is not there.
    pub fn picture_of_matte(&self, view: usize) -> Result<Photo> {
        let shot = self.shots().get(view).ok_or_else(|| no_view(view, self.shots().len()))?;
        Canvas::of_matte(&shot.matte).finish()
    }

    /// A view's branches over its photograph, the base as a dot.
    ///
    /// # Errors
    /// As [`attractors`](Session::attractors), and [`ModelError::View`].
    pub fn picture_of_attractor(&mut self, view: usize, control: &Control) -> Result<Photo> {
        self.attractors(control)?;
        let mut canvas = self.canvas(view)?;
        let (Some(views), Some(graphs)) = (&self.views, &self.attractors) else {
            return canvas.finish();
        };
        let (size, base) = (views[view].camera.size.y, views[view].camera.base);
        for (a, b) in graphs[view].segments() {
            canvas.line(a, b, THICK * size, RED);
        }
        canvas.dot(base, 2.0 * THICK * size, YELLOW);
        canvas.finish()
    }

    /// A view's direction field as arrows over its matte.
    ///
    /// # Errors
    /// As [`fields`](Session::fields), and [`ModelError::View`].
    pub fn picture_of_field(&mut self, view: usize, control: &Control) -> Result<Photo> {
        self.fields(control)?;
        let mut canvas = Canvas::over(&self.picture_of_matte(view)?);
        let shot = &self.shots()[view];
        let size = Vec2::new(shot.matte.width() as f32, shot.matte.height() as f32);
        let step = size.max_element() / ARROWS;
        let field = &self.fields(control)?[view];
        let (nx, ny) = ((size.x / step) as u32, (size.y / step) as u32);
        for i in 0..nx * ny {
            let at = step * (Vec2::new((i % nx) as f32, (i / nx) as f32) + 0.5);
            let along = field.sample(at);
            let half = 0.45 * step * Vec2::new(along.x, -along.y);
            canvas.arrow(at - half, at + half, THIN * size.y, BLUE);
        }
        canvas.finish()
    }

    /// The particles' traces over a view's photograph, thicker where more went.
    ///
    /// # Errors
    /// As [`traces`](Session::traces), and [`ModelError::View`].
    pub fn picture_of_traces(&mut self, view: usize, control: &Control) -> Result<Photo> {
        self.traces(control)?;
        let mut canvas = self.canvas(view)?;
        let Some(views) = &self.views else { return canvas.finish() };
        let camera = views[view].camera;
        let projector = camera.projector();
        let traces = self.traces(control)?;
        let pixels: Vec<Option<Vec2>> =
            traces.positions().iter().map(|&p| projector.project(p)).collect();
        for (node, &next) in traces.next().iter().enumerate() {
            if next == NO_PARENT {
                continue;
            }
            if let (Some(a), Some(b)) = (pixels[node], pixels[next as usize]) {
                let mass = traces.masses()[node] as f32;
                let width = THIN * camera.size.y * libm::powf(mass, 0.25).max(0.4);
                canvas.line(a, b, width, YELLOW);
            }
        }
        canvas.finish()
    }

    /// Horizontal slices through the density, from the base up: light where it is dense, seen from above with
    /// the front below.
    ///
    /// # Errors
    /// As [`density`](Session::density).
    pub fn picture_of_density(&mut self, control: &Control) -> Result<Photo> {
        slices(self.density(control)?, control)
    }

    fn canvas(&self, view: usize) -> Result<Canvas> {
        let shot = self.shots().get(view).ok_or_else(|| no_view(view, self.shots().len()))?;
        Ok(match &shot.photo {
            Some(photo) => Canvas::over(photo),
            None => Canvas::of_matte(&shot.matte),
        })
    }
}

fn no_view(view: usize, n: usize) -> ModelError {
    ModelError::View { view, problem: format!("there are {n} views, counted from 0") }
}

fn slices(grid: &Grid, control: &Control) -> Result<Photo> {
    let size = grid.size();
    let (nx, nz) = (size.x as usize, size.z as usize);
    let tile = [nx, nz].map(|n| n * VOXEL_PIXELS + 2);
    let rows = SLICES.div_ceil(SLICES_ACROSS);
    let (width, height) = (tile[0] * SLICES_ACROSS, tile[1] * rows);
    let mut canvas = Canvas::blank(width as u32, height as u32, WHITE, &control.limits)?;
    let most = grid.values().iter().copied().fold(f32::MIN_POSITIVE, f32::max);
    for slice in 0..SLICES {
        let y = ((slice as f32 + 0.5) / SLICES as f32 * size.y as f32) as i32;
        let corner = [slice % SLICES_ACROSS * tile[0], slice / SLICES_ACROSS * tile[1]];
        for i in 0..nx * nz {
            let (x, z) = (i % nx, i / nx);
            let value =
                grid.index(IVec3::new(x as i32, y, z as i32)).map_or(0.0, |i| grid.values()[i]);
            let grey = (255.0 * (value / most).sqrt()) as u8;
            let at = Vec2::new(
                (corner[0] + x * VOXEL_PIXELS) as f32,
                (corner[1] + z * VOXEL_PIXELS) as f32,
            );
            let side = VOXEL_PIXELS as f32;
            canvas.fill(at, at + side, [grey, grey, grey, 255]);
        }
    }
    canvas.finish()
}
