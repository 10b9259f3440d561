//! A mesh prepared for several views.

use super::bits::Bits;
use super::triangle::runs;
use crate::error::{Result, check_range};
use crate::preview::{Camera, Filter, Pattern, Projector, Scene, clip_loose};
use crate::quality::Score;
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::ops::Range;
use tree_core::{Control, Resource};
use tree_mesh::Mesh;

/// A mesh, its prepared textures, and the views it is looked at from.
#[derive(Debug)]
pub struct Stage<'a> {
    scene: Scene<'a>,
    shots: Vec<Shot>,
}

/// One view: where it is taken from, and what is seen of the full mesh.
#[derive(Debug)]
pub(crate) struct Shot {
    projector: Projector,
    /// All surfaces.
    pub(crate) full: Bits,
    /// Surfaces that are never pruned.
    pub(crate) kept: Bits,
}

/// Triangles of one surface that are scaled as one, for drawing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece<'a> {
    pub(crate) surface: u32,
    /// Rows of vertices.
    pub(crate) triangles: &'a [[u32; 3]],
    pub(crate) center: Vec3,
    /// Factor on length.
    pub(crate) growth: f32,
}

impl<'a> Stage<'a> {
    /// Prepares `mesh` for square views of `size` pixels. `pruned` are the surfaces that may be
    /// pruned.
    ///
    /// # Errors
    /// What [`Mesh::check`] finds, [`LodError::Parameter`](crate::LodError::Parameter) or
    /// [`LodError::Camera`](crate::LodError::Camera) for a size or camera outside its range,
    /// [`LodError::Limit`](crate::LodError::Limit) over the limits of pixels (of all views) or
    /// triangles, [`LodError::Cancelled`](crate::LodError::Cancelled).
    ///
    /// # Complexity
    /// O(views × triangles), in parallel over views.
    pub fn new(
        mesh: &'a Mesh,
        cameras: &[Camera],
        size: u32,
        pruned: &[u32],
        control: &Control,
    ) -> Result<Self> {
        check_range("around.size", size.into(), 8.0, 4096.0)?;
        check_range("cameras", cameras.len() as f64, 1.0, 4096.0)?;
        let pixels = u64::from(size) * u64::from(size);
        control.limits.check(Resource::Pixels, pixels.saturating_mul(cameras.len() as u64))?;
        let scene = Scene::new(mesh, false, control)?;
        let shots = cameras
            .par_iter()
            .map(|camera| {
                control.check()?;
                let pose = camera.pose(mesh, 1.0)?;
                let projector = Projector::new(&pose, size, size, scene.size);
                let mut shot =
                    Shot { projector, full: Bits::new(size, size), kept: Bits::new(size, size) };
                shot.fill(&scene, pruned);
                Ok(shot)
            })
            .collect::<Result<Vec<_>>>()?;
        Ok(Self { scene, shots })
    }

    /// Number of views.
    #[must_use]
    pub fn n_views(&self) -> usize {
        self.shots.len()
    }

    /// What is seen of the whole mesh; none when there is no such view.
    #[must_use]
    pub fn full(&self, view: usize) -> Option<&Bits> {
        self.shots.get(view).map(|shot| &shot.full)
    }

    /// What is seen of the surfaces that are never pruned; none when there is no such view.
    #[must_use]
    pub fn kept(&self, view: usize) -> Option<&Bits> {
        self.shots.get(view).map(|shot| &shot.kept)
    }

    /// Calls `run` with row, first column and end of the runs of pixels that some triangles of a surface cover in a
    /// view. Runs overlap where triangles do. There are none for a view, a surface or triangles that are not there.
    ///
    /// # Complexity
    /// O(triangles + covered pixels).
    pub fn runs_of(
        &self,
        view: usize,
        surface: usize,
        triangles: Range<usize>,
        run: impl FnMut(u32, u32, u32),
    ) {
        let (Some(shot), Some(mesh)) = (self.shots.get(view), self.mesh().surfaces.get(surface))
        else {
            return;
        };
        let rows = mesh.indices.as_chunks::<3>().0.get(triangles).unwrap_or_default();
        let surface = surface as u32;
        self.runs(shot, Piece { surface, triangles: rows, center: Vec3::ZERO, growth: 1.0 }, run);
    }

    pub(crate) fn shots(&self) -> &[Shot] {
        &self.shots
    }

    pub(crate) fn mesh(&self) -> &'a Mesh {
        self.scene.mesh
    }

    /// Runs of pixels that a piece covers in a view.
    #[inline]
    pub(crate) fn runs(&self, shot: &Shot, piece: Piece<'_>, mut run: impl FnMut(u32, u32, u32)) {
        shot.projector.piece(&self.scene, piece, &mut Each(&mut run));
    }

    /// Adds what a piece covers in a view to a mask.
    #[inline]
    pub(crate) fn draw(&self, shot: &Shot, piece: Piece<'_>, bits: &mut Bits) {
        shot.projector.piece(&self.scene, piece, bits);
    }
}

/// What becomes of runs of pixels.
pub(crate) trait Sink {
    /// Takes the pixels `first..end` of a row.
    fn run(&mut self, row: u32, first: u32, end: u32);

    /// Whether these pixels are of no interest: the texture need not be asked.
    fn skips(&self, row: u32, first: u32, end: u32) -> bool;
}

/// Every run, for a closure.
struct Each<'a, F>(&'a mut F);

impl<F: FnMut(u32, u32, u32)> Sink for Each<'_, F> {
    #[inline]
    fn run(&mut self, row: u32, first: u32, end: u32) {
        (self.0)(row, first, end);
    }

    #[inline]
    fn skips(&self, _: u32, _: u32, _: u32) -> bool {
        false
    }
}

impl Sink for Bits {
    #[inline]
    fn run(&mut self, row: u32, first: u32, end: u32) {
        self.set_span(row, first, end);
    }

    #[inline]
    fn skips(&self, row: u32, first: u32, end: u32) -> bool {
        let mut all = true;
        self.words_of(row, first, end, |word, bits| all &= self.words()[word] & bits == bits);
        all
    }
}

impl Shot {
    fn fill(&mut self, scene: &Scene<'_>, pruned: &[u32]) {
        for number in 0..scene.mesh.surfaces.len() as u32 {
            let (triangles, _) = scene.surface(number as usize).indices.as_chunks::<3>();
            let piece = Piece { surface: number, triangles, center: Vec3::ZERO, growth: 1.0 };
            self.projector.piece(scene, piece, &mut self.full);
            if !pruned.contains(&number) {
                self.projector.piece(scene, piece, &mut self.kept);
            }
        }
    }
}

impl Projector {
    #[inline]
    fn piece(&self, scene: &Scene<'_>, piece: Piece<'_>, sink: &mut impl Sink) {
        let Some(pattern) = scene.pattern(piece.surface as usize) else {
            return;
        };
        let surface = scene.surface(piece.surface as usize);
        for rows in piece.triangles {
            let corners = rows.map(|row| {
                let p = surface.positions[row as usize];
                piece.center + (p - piece.center) * piece.growth
            });
            let masked = pattern.pyramid.is_some();
            let uvs =
                if masked { rows.map(|row| surface.uvs[row as usize]) } else { [Vec2::ZERO; 3] };
            let views = corners.map(|corner| self.view(corner));
            if views.iter().all(|&v| self.shows(v)) {
                let spots = views.map(|v| self.on_picture(v));
                self.triangle(spots, views.map(|v| v.z), uvs, pattern, sink);
            } else {
                // Rare: the camera stands within the tree.
                let (polygon, n) = clip_loose(corners, uvs, self);
                for i in 2..n {
                    let [a, b, c] = [polygon[0], polygon[i - 1], polygon[i]];
                    self.triangle([a.0, b.0, c.0], [a.1, b.1, c.1], [a.2, b.2, c.2], pattern, sink);
                }
            }
        }
    }

    #[inline]
    fn triangle(
        &self,
        spots: [Vec2; 3],
        depths: [f32; 3],
        uvs: [Vec2; 3],
        pattern: Pattern<'_>,
        sink: &mut impl Sink,
    ) {
        let Some(pyramid) = pattern.pyramid else {
            return runs(spots, self.width, self.height, |row, first, end| {
                sink.run(row, first, end);
            });
        };
        let [a, b, c] = spots;
        let area = (b - a).perp_dot(c - a);
        if area == 0.0 {
            return;
        }
        let mask = pyramid.mask(area.abs(), uvs);
        // Texture coordinates, divided by depth in perspective, are affine on the picture.
        let q = if self.perspective { depths.map(|z| 1.0 / z) } else { [1.0; 3] };
        let gradient = |f: [f32; 3]| {
            let (d1, d2) = (f[1] - f[0], f[2] - f[0]);
            let per_x = (d1 * (c.y - a.y) - d2 * (b.y - a.y)) / area;
            let per_y = (d2 * (b.x - a.x) - d1 * (c.x - a.x)) / area;
            (f[0], per_x, per_y)
        };
        let u = gradient([0, 1, 2].map(|i| uvs[i].x * q[i]));
        let v = gradient([0, 1, 2].map(|i| uvs[i].y * q[i]));
        let w = gradient(q);
        let slopes = Slopes { a, u, v, w, perspective: self.perspective };
        let (level, size) = (mask.level, [self.width, self.height]);
        // Told apart here and not for every pixel.
        match mask.filter {
            Filter::Within => slopes.fill(spots, size, |u, v| level.covers_within(u, v), sink),
            Filter::Repeat => slopes.fill(spots, size, |u, v| level.covers(u, v), sink),
            Filter::Smooth => slopes.fill(spots, size, |u, v| level.covers_smoothly(u, v), sink),
        }
    }
}

/// Texture coordinates over distance, and 1 / distance: value at corner `a`, change right and down.
struct Slopes {
    a: Vec2,
    u: (f32, f32, f32),
    v: (f32, f32, f32),
    w: (f32, f32, f32),
    perspective: bool,
}

impl Slopes {
    /// Runs of pixels in which the texture is drawn.
    #[inline]
    fn fill(
        &self,
        spots: [Vec2; 3],
        [width, height]: [u32; 2],
        covers: impl Fn(f32, f32) -> bool,
        sink: &mut impl Sink,
    ) {
        runs(spots, width, height, |row, first, end| {
            if sink.skips(row, first, end) {
                return;
            }
            let y = row as f32 + 0.5 - self.a.y;
            let [u, v, w] = [self.u, self.v, self.w].map(|s| (s.0 + s.2 * y, s.1));
            let mut from = end;
            for column in first..end {
                let x = column as f32 + 0.5 - self.a.x;
                let far = if self.perspective { 1.0 / (w.0 + w.1 * x) } else { 1.0 };
                if covers((u.0 + u.1 * x) * far, (v.0 + v.1 * x) * far) {
                    from = from.min(column);
                } else if from < column {
                    sink.run(row, from, column);
                    from = end;
                }
            }
            if from < end {
                sink.run(row, from, end);
            }
        });
    }
}

/// The pixels that a mesh covers from a camera.
///
/// # Errors
/// As [`Stage::new`].
///
/// # Complexity
/// O(triangles + covered pixels).
pub fn mask(mesh: &Mesh, camera: &Camera, size: u32, control: &Control) -> Result<Bits> {
    let mut stage = Stage::new(mesh, std::slice::from_ref(camera), size, &[], control)?;
    Ok(stage.shots.swap_remove(0).full)
}

/// Scores of a simplified mesh against the full one, one for each camera; both are framed as the full
/// one is.
///
/// # Errors
/// As [`Stage::new`], for either mesh.
///
/// # Complexity
/// O(cameras × triangles of both), in parallel over cameras.
pub fn score(
    simplified: &Mesh,
    full: &Mesh,
    cameras: &[Camera],
    size: u32,
    control: &Control,
) -> Result<Vec<Score>> {
    let stage = Stage::new(full, cameras, size, &[], control)?;
    let placed = cameras.iter().map(|camera| Ok(Camera::Placed(camera.pose(full, 1.0)?)));
    let other = Stage::new(simplified, &placed.collect::<Result<Vec<_>>>()?, size, &[], control)?;
    Ok(stage
        .shots
        .iter()
        .zip(&other.shots)
        .map(|(full, other)| other.full.score(&full.full))
        .collect())
}
