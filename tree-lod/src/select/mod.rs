//! Which trees of a scene are drawn in a frame, and how finely (Neubert 2012, §7.2.5 and §7.4).
//!
//! Once: a [`Scene`] of [`Model`]s and [`Instance`]s, and a [`State`] for each view. In each frame:
//! [`Scene::select`], then [`Scene::draws`] or [`Scene::batches`] into buffers of the caller. A frame allocates
//! nothing.
//!
//! ```
//! use tree_lod::glam::Vec3;
//! use tree_lod::glam::camera::rh::{proj::directx::perspective_infinite_reverse, view::look_at_mat4};
//! use tree_lod::select::*;
//! use tree_lod::tree_core::Control;
//!
//! let level = |lambda, index_count| {
//!     let draw = Draw { index_count, ..Draw::default() };
//!     Level { lambda, scale: 1.0 / lambda, fade: 0.0, draws: vec![draw] }
//! };
//! let levels = vec![level(0.1, 300), level(0.5, 1500), level(1.0, 3000)];
//! let model = Model { center: Vec3::Y * 4.0, radius: 5.0, levels, ..Model::default() };
//! let tree = |x| Instance { position: Vec3::X * x, ..Instance::default() };
//! let instances = [tree(0.0), tree(10.0), tree(20.0)];
//!
//! let control = Control::default();
//! let scene = Scene::new(&[model], &instances, &control)?;
//! let mut state = State::new(&scene, &control)?;
//! let mut draws = vec![DrawIndexed::default(); scene.most_draws()];
//! let mut rows = vec![InstanceLod::default(); scene.len()];
//!
//! let eye = Eye {
//!     view: look_at_mat4(Vec3::new(10.0, 2.0, 60.0), Vec3::new(10.0, 4.0, 0.0), Vec3::Y),
//!     projection: perspective_infinite_reverse(1.0, 16.0 / 9.0, 0.1),
//! };
//! let frame = Frame { eye, occlusion: Occlusion::None, seconds: 0.016, cut: false };
//! let params = SceneParams::default();
//! let selected = scene.select(&frame, &params, &mut state)?;
//! let written = scene.draws(&state, &mut draws, &mut rows)?;
//! assert_eq!((selected.n_drawn, written.draws), (3, 3));
//! # Ok::<(), tree_lod::LodError>(())
//! ```

#[cfg(test)]
mod bad_tests;
mod eye;
mod frame;
mod model;
mod occlude;
mod output;
mod scene;
mod state;
#[cfg(test)]
mod tests;
mod visible;
mod write;

pub use eye::Eye;
pub use frame::{Frame, Occlusion, SceneParams, Selected};
pub use model::{Draw, Level, MAX_LEVELS, MAX_PARTS, MAX_SAMPLES, Model, Occluder};
pub use output::{DrawIndexed, InstanceLod, Written};
pub use scene::{Instance, Scene};
pub use state::{Shown, State};
pub use visible::DepthBuffer;
