//! What a shader does with a pruned model.

use crate::border::{Failure, call, floats, out_value, tree_status, tree_str};
use tree_lod::prune::{GLSL, HLSL, WGSL, color, position};

/// Language of a shader: one of the `TREE_SHADER_` constants.
pub type tree_shader = u32;

/// WGSL.
pub const TREE_SHADER_WGSL: u32 = 0;
/// GLSL, from version 1.30 (desktop) or 3.00 (ES) on.
pub const TREE_SHADER_GLSL: u32 = 1;
/// HLSL, any shader model.
pub const TREE_SHADER_HLSL: u32 = 2;

/// The functions `tree_prune_position` and `tree_prune_color` for a shader: text to be put into your own. It tells
/// what they take and where it comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_prune_shader(
    language: tree_shader,
    text: *mut tree_str,
) -> tree_status {
    call(|| {
        let found = match language {
            TREE_SHADER_WGSL => WGSL,
            TREE_SHADER_GLSL => GLSL,
            TREE_SHADER_HLSL => HLSL,
            other => return Err(Failure::not_one_of("language", other, "TREE_SHADER_")),
        };
        unsafe { out_value(text, tree_str::of(found), "text") }
    })
}

/// Where a shader draws a vertex: `vertex`, three floats, moved from the centre of its element by `growth` (a factor on
/// length), and towards it where the element fades. `center_rank` is four floats of `tree_pruned_part.centers`, the
/// rest is of a level. For shaders of your own, and for checking them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_prune_position(
    vertex: *const f32,
    center_rank: *const f32,
    growth: f32,
    lambda: f32,
    fade: f32,
    drawn: *mut [f32; 3],
) -> tree_status {
    call(|| {
        let vertex: [f32; 3] = unsafe { floats(vertex, "vertex") }?;
        let center_rank = unsafe { floats(center_rank, "center_rank") }?;
        let found = position(vertex.into(), center_rank, growth, lambda, fade);
        unsafe { out_value(drawn, found.to_array(), "drawn") }
    })
}

/// The linear colour that a shader gives a leaf, before light: `rgb`, three floats, with its contrast lowered, so that
/// few large leaves look no more mottled than many small ones. `mean` is that of the part.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_prune_color(
    rgb: *const f32,
    mean: *const f32,
    contrast: f32,
    drawn: *mut [f32; 3],
) -> tree_status {
    call(|| {
        let rgb: [f32; 3] = unsafe { floats(rgb, "rgb") }?;
        let mean: [f32; 3] = unsafe { floats(mean, "mean") }?;
        let found = color(rgb.into(), mean.into(), contrast);
        unsafe { out_value(drawn, found.to_array(), "drawn") }
    })
}
