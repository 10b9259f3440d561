//! What engines read: attribute streams in their axes and layouts, and a vertex of 32 bytes.
//!
//! | module | for | wind it carries |
//! |---|---|---|
//! | [`speedtree8`] | Unity's SpeedTree 8 shader | one branch, leaves |
//! | [`speedtree9`] | Unity's SpeedTree 9 shader | two branches, leaves |
//! | [`tree_creator`] | Unity's Tree Creator shaders, most vegetation shaders | bend weights, phase |
//! | [`pivot_painter`] | Unreal's Pivot Painter 2 | the hierarchy, at most 4 levels |
//! | [`godot`] | Godot 4, `CUSTOM0` to `CUSTOM3` | own branch in full, parent's part |
//! | [`gltf_wind`] | glTF, attributes `_WIND*` | all of it |
//! | [`vertex`] | own renderers: 32 bytes, quantised | all of it, pivots by table |
//!
//! Each has `pack`, which makes a [`Packed`], and `unpack`, which reads it back as an engine would into
//! an [`Unpacked`] in our axes; their difference is the quantisation stated in each module. Whatever
//! column a surface lacks is filled: tangents square to the normal, no light map, no occlusion.
//!
//! Each costs one pass over the vertices. Nothing here writes files.

mod common;
pub mod direction;
pub mod gltf_wind;
pub mod godot;
pub mod half;
mod indices;
pub mod pivot_painter;
pub mod speedtree8;
pub mod speedtree9;
mod stream;
pub mod tree_creator;
pub mod vertex;

pub use indices::Indices;
pub use stream::{Data, Packed, Stream, Unpacked};

#[cfg(test)]
mod tests;
#[cfg(test)]
mod vertex_tests;
