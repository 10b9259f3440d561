//! World points to pixels and back, and the camera for a renderer.

use super::camera::{fov, tree_particle_camera};
use super::fill_some;
use crate::border::{Result, Versioned, call, tree_status, vec2s, vec3s, write};
use crate::control::{limits, tree_control};
use crate::preview::tree_view;
use glam::{Vec2, Vec3};
use tree_lod::preview;
use tree_model::particle::{Projection, Projector};
use tree_model::tree_core::Resource;

/// Asks a camera about every point.
unsafe fn ask<R>(
    camera: *const tree_particle_camera,
    points: *const f32,
    n: usize,
    control: *const tree_control,
    answer: impl Fn(&Projector, Vec3) -> R,
) -> Result<Vec<R>> {
    let projector = unsafe { tree_particle_camera::get(camera) }?.projector();
    let limits = unsafe { limits(control) }?;
    let points = unsafe { vec3s(points, n, &limits, Resource::Nodes, "points") }?;
    Ok(points.iter().map(|&point| answer(&projector, point)).collect())
}

/// Writes the pixels that `n_points` points of the world fall on, of three floats each in metres: two floats
/// for each, in pixels from the top left; NaN behind the camera or beside it. `capacity`, in floats, must be
/// `2 * n_points` or more. `control` may be NULL; `nodes` of its limits caps the points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_camera_project(
    camera: *const tree_particle_camera,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    spots: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let answer = |projector: &Projector, point| projector.project(point).unwrap_or(Vec2::NAN);
        let found = unsafe { ask(camera, points, n_points, control, answer) }?;
        unsafe { fill_some(spots, capacity, bytemuck::cast_slice(&found), "spots") }
    })
}

/// Writes for each of `n_points` points of the world, three floats each in metres, how many metres a pixel
/// is at its depth. `capacity` must be `n_points` or more. `control` as for `tree_particle_camera_project`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_camera_pixel_sizes(
    camera: *const tree_particle_camera,
    points: *const f32,
    n_points: usize,
    control: *const tree_control,
    sizes: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let found = unsafe { ask(camera, points, n_points, control, Projector::pixel_size) }?;
        unsafe { fill_some(sizes, capacity, &found, "sizes") }
    })
}

/// Writes the rays through `n_spots` points of the picture, two floats each in pixels from the top left: six
/// floats for each, a point on it in metres and its unit direction. In perspective the point is where the
/// camera stands, in parallel projection it lies on the plane through the base. `capacity`, in floats, must
/// be `6 * n_spots` or more. `control` as for `tree_particle_camera_project`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_camera_rays(
    camera: *const tree_particle_camera,
    spots: *const f32,
    n_spots: usize,
    control: *const tree_control,
    rays: *mut f32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let projector = unsafe { tree_particle_camera::get(camera) }?.projector();
        let limits = unsafe { limits(control) }?;
        let spots = unsafe { vec2s(spots, n_spots, &limits, Resource::Nodes, "spots") }?;
        let ray = |&spot| {
            let (on, along) = projector.ray(spot);
            [on, along]
        };
        let found: Vec<[Vec3; 2]> = spots.iter().map(ray).collect();
        unsafe { fill_some(rays, capacity, bytemuck::cast_slice(found.as_flattened()), "rays") }
    })
}

/// A camera as renderers want it: what it shows is what `tree_particle_camera_project` gives.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_particle_stand {
    /// `sizeof(tree_particle_stand)`.
    pub struct_size: usize,
    /// Where it stands, in metres. A parallel one stands far enough off.
    pub eye: [f32; 3],
    /// What is in the middle of the picture.
    pub target: [f32; 3],
    /// Which way is up.
    pub up: [f32; 3],
    /// Vertical field of view in radians; 0 for parallel projection.
    pub fov: f32,
    /// Height of the picture in metres, at the target.
    pub height: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_particle_stand {
    const NAME: &'static str = "tree_particle_stand";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            eye: [0.0; 3],
            target: [0.0; 3],
            up: [0.0; 3],
            fov: 0.0,
            height: 0.0,
            reserved: 0,
        }
    }
}

/// The camera for a renderer, to draw the tree as the photograph shows it. Set `stand->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_camera_stand(
    camera: *const tree_particle_camera,
    stand: *mut tree_particle_stand,
) -> tree_status {
    call(|| {
        let camera = unsafe { tree_particle_camera::get(camera) }?;
        let found = camera.stand();
        let value = tree_particle_stand {
            eye: found.eye.to_array(),
            target: found.target.to_array(),
            up: found.up.to_array(),
            fov: fov(camera.projection),
            height: found.height,
            ..tree_particle_stand::default_value()
        };
        unsafe { write(stand, "stand", &value) }
    })
}

/// The same as a view for `tree_render` and `tree_render_mask`: of the photograph's size, with the camera
/// placed; everything else is the default. Set `view->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_particle_camera_view(
    camera: *const tree_particle_camera,
    view: *mut tree_view,
) -> tree_status {
    call(|| {
        let camera = unsafe { tree_particle_camera::get(camera) }?;
        let stand = camera.stand();
        let lens = match camera.projection {
            Projection::Perspective { fov } => preview::Lens::Perspective { fov },
            Projection::Orthographic => preview::Lens::Orthographic { height: stand.height },
        };
        let pose = preview::Pose { eye: stand.eye, target: stand.target, up: stand.up, lens };
        let made = preview::View {
            width: camera.size.x as u32,
            height: camera.size.y as u32,
            camera: preview::Camera::Placed(pose),
            ..preview::View::default()
        };
        unsafe { write(view, "view", &tree_view::of(&made)) }
    })
}
