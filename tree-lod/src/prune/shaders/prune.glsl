// Pruned foliage (Neubert 2012, chapter 7; Cook et al. 2007): GLSL 1.30 or ES 3.00 and later.
//
// Vertex buffer: one more attribute of 4 floats, `center_rank` (Part::centers, `_TREE_CENTER` in glTF).
//   layout(location = 5) in vec4 center_rank;
// Per instance: growth, lambda, fade, contrast (Level or InstanceLod), from attributes with a divisor of 1.
// Per part: mean (Part::mean), linear, a uniform.
// Draw the window of the level: glDrawElements(GL_TRIANGLES, index_count, ..., offset of first_index).

// Where a vertex is drawn, in the model's own space: call it before wind and the instance's transform.
vec3 tree_prune_position(vec3 position, vec4 center_rank, float growth, float lambda, float fade) {
    float size = growth;
    if (fade > 0.0) {
        size = size * clamp((lambda - center_rank.w) / fade, 0.0, 1.0);
    }
    return center_rank.xyz + size * (position - center_rank.xyz);
}

// Linear colour of a leaf, before light: call it in the fragment shader.
vec3 tree_prune_color(vec3 color, vec3 mean, float contrast) {
    return mean + contrast * (color - mean);
}
