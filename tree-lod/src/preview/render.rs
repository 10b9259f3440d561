//! The whole way from a mesh to a picture or a mask.

use super::View;
use super::camera::Projector;
use super::picture::{Mask, Picture, Tone};
use super::project::project_all;
use super::raster::Band;
use super::scene::Scene;
use super::shade::{Shader, SkyLight};
use super::shadow::{DepthMap, hemisphere};
use super::style::Style;
use super::visibility::{Bins, Stage};
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};
use tree_core::{Control, Seed};
use tree_mesh::Mesh;

/// Samples that one thread draws at a time: depth and triangle of each fit its cache.
const SAMPLES_PER_BAND: usize = 1 << 16;
/// Width in pixels of the blocks in which a band is shaded.
const BLOCK: usize = 16;
/// Directions of sky light where no depth maps are wanted.
const OPEN_SKY: u32 = 16;
/// Colour of what the ground throws back, relative to light on it, where there is no ground.
const NO_GROUND: Vec3 = Vec3::new(0.12, 0.12, 0.11);

/// What a sample sees besides triangles.
const NOTHING: u32 = u32::MAX;
const GROUND: u32 = u32::MAX - 1;

/// Draws a picture of `mesh`.
///
/// Back faces are drawn too; their normals are turned over. An empty mesh gives the ground alone.
/// Progress is reported in the stages `textures`, `light` and `picture`.
///
/// # Errors
/// [`LodError::Parameter`](crate::LodError::Parameter) or [`LodError::Camera`](crate::LodError::Camera)
/// for bad parameters, [`LodError::Mesh`](crate::LodError::Mesh) if [`Mesh::check`] finds fault,
/// [`LodError::Limit`](crate::LodError::Limit) if samples and depth maps together are more than
/// [`Limits::pixels`](tree_core::Limits::pixels) (before they are allocated),
/// [`LodError::Cancelled`](crate::LodError::Cancelled).
///
/// # Complexity
/// O((2 + sky directions) × triangles + samples × depth complexity). Memory: 12 bytes per vertex and
/// thread, 4 to 8 per triangle of a tree in view (never above 32, or 256 KiB for a small mesh), 4 per
/// texel of the depth maps and pixel of the picture; samples are held only for the bands at work.
pub fn render(mesh: &Mesh, view: &View, style: &Style, control: &Control) -> Result<Picture> {
    view.validate()?;
    style.validate()?;
    view.check_pixels(style.map_texels(), &control.limits)?;
    control.report("textures", 0.0)?;
    let scene = Scene::new(mesh, true, control)?;
    control.report("light", 0.05)?;
    let shader = light(&scene, style, control)?;
    control.report("picture", 0.5)?;
    let projector = projector(&scene, view)?;
    let tone = Tone::new(style.exposure);
    let ground = style.ground.and_then(|height| Some((height, projector.plane_depth(height)?)));
    let samples = view.samples as f32;
    let pixel_angle = samples / projector.scale;
    let mut pixels = vec![0_u8; 4 * view.width as usize * view.height as usize];
    let clear = |x: i32, y: i32| match ground {
        Some((_, [start, right, down])) => {
            let depth = start + (x as f32 + 0.5) * right + (y as f32 + 0.5) * down;
            let seen = depth > 0.0 || !projector.perspective;
            if seen { (depth, GROUND) } else { (f32::NEG_INFINITY, NOTHING) }
        }
        None => (f32::NEG_INFINITY, NOTHING),
    };
    let shade = |seen: &[(u32, u32, u32, u32)], x: u32, y: u32| {
        let mut light = Vec3::ZERO;
        for &(id, count, dx, dy) in seen {
            let n = count as f32;
            let ray = projector.ray(
                (x * view.samples) as f32 + dx as f32 / n + 0.5,
                (y * view.samples) as f32 + dy as f32 / n + 0.5,
            );
            let color = match (id, ground) {
                (GROUND, Some((height, _))) => shader.ground(height, ray, pixel_angle),
                (NOTHING | GROUND, _) => style.backdrop(ray.1.normalize(), shader.sun),
                _ => shader.triangle(id, ray, &projector, 1.0 / (samples * samples)),
            };
            light += color * n;
        }
        tone.bytes(light / (samples * samples), x, y)
    };
    let finish = |ids: &[u32], top: u32, out: &mut [u8]| {
        let mut seen = Vec::new();
        let width = view.width as usize;
        let n_rows = out.len() / (4 * width);
        let stride = view.samples as usize * view.samples as usize * width;
        // Block by block: neighbours look up the same triangles and the same part of each map.
        for left in (0..width).step_by(BLOCK) {
            for row in 0..n_rows {
                let ids = &ids[row * stride..][..stride];
                for x in left..width.min(left + BLOCK) {
                    gather(ids, x, view, &mut seen);
                    let bytes = shade(&seen, x as u32, top + row as u32);
                    out[4 * (row * width + x)..][..4].copy_from_slice(&bytes);
                }
            }
        }
    };
    draw(&scene, view, &projector, control, &mut pixels, 4, &clear, &finish)?;
    control.report("picture", 1.0)?;
    Ok(Picture { width: view.width, height: view.height, pixels })
}

/// The share of each pixel that `mesh` covers, by samples. There is no ground.
///
/// # Errors
/// As [`render`].
///
/// # Complexity
/// O(triangles + samples × depth complexity).
pub fn mask(mesh: &Mesh, view: &View, control: &Control) -> Result<Mask> {
    view.validate()?;
    view.check_pixels(0, &control.limits)?;
    let scene = Scene::new(mesh, false, control)?;
    let projector = projector(&scene, view)?;
    let mut coverage = vec![0; view.width as usize * view.height as usize];
    let clear = |_, _| (f32::NEG_INFINITY, NOTHING);
    let per_pixel = view.samples * view.samples;
    let finish = |ids: &[u32], _: u32, out: &mut [u8]| {
        let (s, width) = (view.samples as usize, view.width as usize);
        for (i, pixel) in out.iter_mut().enumerate() {
            let at = i / width * s * s * width + i % width * s;
            let rows = (0..s).map(|row| &ids[at + row * s * width..][..s]);
            let covered = rows.flatten().filter(|&&id| id != NOTHING).count() as u32;
            *pixel = ((covered * 255 + per_pixel / 2) / per_pixel) as u8;
        }
    };
    draw(&scene, view, &projector, control, &mut coverage, 1, &clear, &finish)?;
    control.report("picture", 1.0)?;
    Ok(Mask { width: view.width, height: view.height, coverage })
}

/// The [`mask`] of a mesh in black on white.
///
/// # Errors
/// As [`render`].
///
/// # Complexity
/// As [`mask`].
pub fn silhouette(mesh: &Mesh, view: &View, control: &Control) -> Result<Picture> {
    Ok(mask(mesh, view, control)?.to_picture())
}

fn projector(scene: &Scene<'_>, view: &View) -> Result<Projector> {
    let pose = view.camera.pose(scene.mesh, view.width as f32 / view.height as f32)?;
    let (width, height) = (view.width * view.samples, view.height * view.samples);
    Ok(Projector::new(&pose, width, height, scene.size))
}

/// Depth maps of sun and sky.
fn light<'a>(scene: &'a Scene<'_>, style: &'a Style, control: &Control) -> Result<Shader<'a>> {
    let sun = style.sun_direction();
    let casts = scene.n_triangles() > 0;
    let sun_map = if casts && style.sun > 0.0 {
        Some(DepthMap::parallel(scene, sun, style.sun_map_px, control)?)
    } else {
        None
    };
    control.report("light", 0.15)?;
    let mapped = casts && style.sky > 0.0 && style.sky_directions > 0;
    let directions = hemisphere(if mapped { style.sky_directions } else { OPEN_SKY });
    let mut maps = if mapped {
        DepthMap::many(scene, &directions, style.sky_map_px, control)?.into_iter()
    } else {
        Vec::new().into_iter()
    };
    // Lambert: 1/π of the light, which is summed over 2π.
    let share = 2.0 / directions.len() as f32;
    let sky: Vec<_> = directions
        .into_iter()
        .map(|direction| {
            let light = style.sky_light(direction) * share;
            SkyLight { direction, light, map: maps.next() }
        })
        .collect();
    let on_ground =
        style.sun_light() * sun.y + sky.iter().map(|sky| sky.light * sky.direction.y).sum::<Vec3>();
    let ground = style.ground.map_or(NO_GROUND, |_| Vec3::from_array(style.ground_color));
    let noise = Seed(0).stream("ground");
    let sky_texel =
        sky.iter().filter_map(|sky| sky.map.as_ref()).map(|map| map.texel).fold(0.0, f32::max);
    Ok(Shader { scene, style, sun, sun_map, sky, sky_texel, bounce: ground * on_ground, noise })
}

/// Turns the samples of rows of pixels into bytes; given the number of the first row.
type Finish<'a> = dyn Fn(&[u32], u32, &mut [u8]) + Sync + 'a;

/// Draws all bands: clears samples by `clear`, finds the nearest triangles, and turns the band's
/// pixels (`bytes` each) over to `finish` with its samples.
#[allow(clippy::too_many_arguments)]
fn draw(
    scene: &Scene<'_>,
    view: &View,
    projector: &Projector,
    control: &Control,
    pixels: &mut [u8],
    bytes: usize,
    clear: &(dyn Fn(i32, i32) -> (f32, u32) + Sync),
    finish: &Finish<'_>,
) -> Result<()> {
    let mut spots = Vec::new();
    project_all(scene, projector, &mut spots);
    let stage = Stage { scene, projector, spots: &spots };
    let (samples, width) = (view.samples as usize, projector.width as usize);
    let rows = (SAMPLES_PER_BAND / (width * samples)).max(1);
    let bins = Bins::new(&stage, (rows * samples) as u32);
    let n_bands = (view.height as usize).div_ceil(rows);
    let done = Mutex::new(0_usize);
    let line = bytes * view.width as usize;
    let work = |(depth, ids): &mut (Vec<f32>, Vec<u32>), (number, out): (usize, &mut [u8])| {
        control.check()?;
        let n_samples = out.len() / line * samples * width;
        let top = (number * rows * samples) as i32;
        depth.clear();
        ids.clear();
        for i in 0..n_samples {
            let (held, id) = clear((i % width) as i32, top + (i / width) as i32);
            depth.push(held);
            ids.push(id);
        }
        let mut band = Band { top, width: width as i32, depth, ids };
        stage.draw_band::<true>(&bins, number, &mut band);
        finish(ids, (number * rows) as u32, out);
        // Reported under the lock, so that progress never falls.
        let mut done = done.lock().unwrap_or_else(PoisonError::into_inner);
        *done += 1;
        control.report("picture", 0.5 + 0.49 * *done as f32 / n_bands as f32)?;
        Ok(())
    };
    pixels
        .par_chunks_mut(rows * line)
        .enumerate()
        .map_init(Default::default, work)
        .collect::<Result<()>>()
}

/// What pixel `x` of a row sees: what, in how many samples, and the sum of their offsets.
#[inline]
fn gather(ids: &[u32], x: usize, view: &View, seen: &mut Vec<(u32, u32, u32, u32)>) {
    seen.clear();
    let samples = view.samples as usize;
    let stride = samples * view.width as usize;
    for dy in 0..samples {
        for dx in 0..samples {
            let id = ids[dy * stride + x * samples + dx];
            let (dx, dy) = (dx as u32, dy as u32);
            match seen.iter_mut().find(|entry| entry.0 == id) {
                Some(entry) => {
                    *entry = (id, entry.1 + 1, entry.2 + dx, entry.3 + dy);
                }
                None => seen.push((id, 1, dx, dy)),
            }
        }
    }
}
