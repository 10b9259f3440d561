//! A mesh to frames.

use super::map::axes;
use super::meta::OctahedralMeta;
use super::{Octahedral, OctahedralReport};
use crate::error::{LodError, Result, check_range};
use crate::impostor::texel::{Atlas, Bytes, Grid, Samples, Window, bake};
use crate::preview::{Part, Picture, Scene};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, Resource};
use tree_mesh::Mesh;

/// How a whole tree is baked.
#[derive(Clone, Debug, PartialEq)]
pub struct OctahedralParams {
    /// Views along each side of the square of directions, 2 to 64. Default 12: 144 views, 8° apart at
    /// the horizon, up to 22° in between.
    pub grid: u32,
    /// Whether only views from the horizon up are baked, which halves the angle between them. Trees are
    /// seldom seen from below. Default true.
    pub hemi: bool,
    /// Side of the pictures in texels, 64 to 16,384, at least 16 for each view. Default 2048.
    pub side: u32,
    /// Samples of a texel in each direction, 1 to 8. Default 4.
    pub samples: u32,
    /// Empty texels around each view, 1 to 8: so that filters do not mix views. Default 2.
    pub gutter: u32,
    /// Whether the picture of normals and depths has half the side. Memory goes from 33.6 MB to
    /// 21 MB at the default side, at some loss of quality. Default false.
    pub half_detail: bool,
}

impl Default for OctahedralParams {
    fn default() -> Self {
        Self { grid: 12, hemi: true, side: 2048, samples: 4, gutter: 2, half_detail: false }
    }
}

impl OctahedralParams {
    /// Checks every field.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("octahedral.grid", self.grid.into(), 2.0, 64.0)?;
        check_range("octahedral.side", self.side.into(), 64.0, 16_384.0)?;
        check_range("octahedral.side / grid", (self.side / self.grid).into(), 16.0, 8192.0)?;
        check_range("octahedral.samples", self.samples.into(), 1.0, 8.0)?;
        check_range("octahedral.gutter", self.gutter.into(), 1.0, 8.0)?;
        if self.gutter * 4 > self.side / self.grid {
            let (found, max) = (f64::from(self.gutter), f64::from(self.side / self.grid) / 4.0);
            check_range("octahedral.gutter", found, 1.0, max)?;
        }
        Ok(())
    }
}

impl Octahedral {
    /// Bakes all of a mesh, leaves and wood. Progress is reported in the stage `views`.
    ///
    /// # Errors
    /// [`LodError::Parameter`]; what [`Mesh::check`] finds; [`LodError::Impostor`] when nothing of the
    /// mesh can be seen or it is a single point; [`LodError::Limit`] over the limits of triangles or
    /// pixels (both pictures, and the samples of a view for each thread); [`LodError::Cancelled`].
    ///
    /// # Complexity
    /// O(views × (triangles + samples)), in parallel over views. Memory: 8 bytes a texel, and for each
    /// thread 8 bytes a sample of one view.
    pub fn bake(mesh: &Mesh, params: &OctahedralParams, control: &Control) -> Result<Self> {
        params.validate()?;
        let tile = params.side / params.grid;
        let n_views = params.grid as usize * params.grid as usize;
        let samples = u64::from(tile * params.samples) * u64::from(tile * params.samples);
        let texels = u64::from(params.side) * u64::from(params.side);
        let threads = rayon::current_num_threads().min(n_views) as u64;
        control.limits.check(Resource::Pixels, 2 * texels + threads * samples)?;
        let scene = Scene::new(mesh, true, control)?;
        let [center, Vec3 { x: wide, y: high, z: radius }] = extent(mesh)?;
        let inner = (tile - 2 * params.gutter) as f32;
        let meta = OctahedralMeta {
            grid: params.grid,
            hemi: params.hemi,
            side: params.side,
            tile,
            detail_side: if params.half_detail { params.side / 2 } else { params.side },
            center,
            radius,
            wide: wide * tile as f32 / inner,
            high: high * tile as f32 / inner,
        };
        let grid = Grid {
            columns: params.grid,
            rows: params.grid,
            tile,
            width: params.side,
            height: params.side,
        };
        let mut atlas = Atlas::new(grid, control)?;
        let part = Part::new(&scene, 0..scene.n_triangles());
        let window = |view: usize| {
            let frame = [view as u32 % params.grid, view as u32 / params.grid];
            let [right, up, toward] = axes(frame, params.grid, params.hemi);
            Window { center, right, up, toward, half: meta.half(toward.y) }
        };
        let mut covered = 0_u64;
        // A row of views at a time, so that tiles do not pile up.
        for row in 0..params.grid as usize {
            control.report("views", row as f32 / params.grid as f32)?;
            let views = row * params.grid as usize..(row + 1) * params.grid as usize;
            let tiles: Vec<Bytes> = views
                .clone()
                .into_par_iter()
                .map_init(Samples::default, |buffers, view| {
                    control.check()?;
                    let mut tile =
                        bake(&scene, &part, &window(view), tile, params.samples, buffers);
                    tile.dilate();
                    Ok(tile.bytes(meta.radius, scene.srgb))
                })
                .collect::<Result<_>>()?;
            for (view, tile) in views.zip(&tiles) {
                covered += tile.covered() as u64;
                atlas.put(view, tile);
            }
        }
        if covered == 0 {
            return Err(LodError::Impostor("nothing of the mesh covers half a texel in any view"));
        }
        let detail = if params.half_detail { nearest_half(&atlas) } else { atlas.detail };
        let bytes = atlas.color.pixels.len() + detail.pixels.len();
        let report = OctahedralReport { n_views, n_triangles: part.len(), covered, bytes };
        control.report("views", 1.0)?;
        Ok(Self { meta, color: atlas.color, detail, report })
    }
}

/// Middle of the tree; and radius and half height of the upright cylinder around it, and radius of the ball.
fn extent(mesh: &Mesh) -> Result<[Vec3; 2]> {
    if mesh.n_triangles() == 0 {
        return Err(LodError::Impostor("there are no triangles to bake"));
    }
    let center = mesh.bounds().center();
    let (mut wide, mut high, mut radius) = (0.0_f32, 0.0_f32, 0.0_f32);
    for p in mesh.surfaces.iter().flat_map(|surface| &surface.positions) {
        let d = *p - center;
        wide = wide.max(d.x * d.x + d.z * d.z);
        high = high.max(d.y.abs());
        radius = radius.max(d.length_squared());
    }
    let (wide, radius) = (wide.sqrt(), radius.sqrt());
    check_range("mesh extent", radius.into(), 0.0, 1e6)?;
    if radius < 1e-6 {
        return Err(LodError::Impostor("all vertices lie at one point: there is nothing to see"));
    }
    // A flat tree still has a width to divide by.
    let least = THINNEST * radius;
    Ok([center, Vec3::new(wide.max(least), high.max(least), radius)])
}

/// Least width and height of a view, as a share of the radius.
const THINNEST: f32 = 0.01;

/// Half the side: of four texels the one whose alpha is largest, since depths must not be mixed.
fn nearest_half(atlas: &Atlas) -> Picture {
    let side = atlas.grid.width as usize;
    let half = side / 2;
    let mut pixels = Vec::with_capacity(4 * half * half);
    for i in 0..half * half {
        let (x, y) = (2 * (i % half), 2 * (i / half));
        let four = [0, 1, side, side + 1].map(|step| 4 * (y * side + x + step));
        let alpha = |at: &usize| atlas.color.pixels[at + 3];
        let best = four.into_iter().reduce(|a, b| if alpha(&b) > alpha(&a) { b } else { a });
        let at = best.unwrap_or(four[0]);
        pixels.extend_from_slice(&atlas.detail.pixels[at..at + 4]);
    }
    Picture { width: half as u32, height: half as u32, pixels }
}
