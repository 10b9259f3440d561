//! What a shader does between two levels.

use crate::border::{Failure, call, floats, out_value, tree_status, tree_str};
use crate::lod::{TREE_SHADER_GLSL, TREE_SHADER_HLSL, TREE_SHADER_WGSL, tree_shader};
use tree_lod::multires::grow::{GLSL, HLSL, WGSL, position};

/// The function `tree_grow_position` for a shader: text to be put into your own. It tells what it takes and where that
/// comes from. `language` is a `TREE_SHADER_` constant. The text is never freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_shader(
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

/// Where a shader draws a vertex at a level: `vertex`, three floats, drawn together about its fork while its path grows
/// in. `branch` is four floats of `tree_multi_mesh_column.branches`. For shaders of your own, and for checking them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_mesh_position(
    vertex: *const f32,
    branch: *const f32,
    level: f32,
    drawn: *mut [f32; 3],
) -> tree_status {
    call(|| {
        let vertex: [f32; 3] = unsafe { floats(vertex, "vertex") }?;
        let branch: [f32; 4] = unsafe { floats(branch, "branch") }?;
        let found = position(vertex.into(), branch, level);
        unsafe { out_value(drawn, found.to_array(), "drawn") }
    })
}
