// Pruned foliage (Neubert 2012, chapter 7; Cook et al. 2007): WGSL.
//
// Vertex buffer: one more attribute of 4 floats, `center_rank` (Part::centers, `_TREE_CENTER` in glTF).
//   @location(5) center_rank: vec4<f32>
// Per instance: growth, lambda, fade, contrast (Level or InstanceLod), from a storage or vertex buffer.
// Per part: mean (Part::mean), linear, from the material's uniform buffer.
// Draw the window of the level: draw_indexed(first_index .. first_index + index_count, ...).

// Where a vertex is drawn, in the model's own space: call it before wind and the instance's transform.
fn tree_prune_position(position: vec3<f32>, center_rank: vec4<f32>, growth: f32, lambda: f32, fade: f32) -> vec3<f32> {
    var size: f32 = growth;
    if (fade > 0.0) {
        size = size * clamp((lambda - center_rank.w) / fade, 0.0, 1.0);
    }
    return center_rank.xyz + size * (position - center_rank.xyz);
}

// Linear colour of a leaf, before light: call it in the fragment shader.
fn tree_prune_color(color: vec3<f32>, mean: vec3<f32>, contrast: f32) -> vec3<f32> {
    return mean + contrast * (color - mean);
}
