// Pruned foliage (Neubert 2012, chapter 7; Cook et al. 2007): HLSL.
//
// Vertex buffer: one more attribute of 4 floats, `center_rank` (Part::centers, `_TREE_CENTER` in glTF).
//   float4 center_rank : TEXCOORD3;
// Per instance: growth, lambda, fade, contrast (Level or InstanceLod), from a structured or instance buffer.
// Per part: mean (Part::mean), linear, from the material's constant buffer.
// Draw the window of the level: DrawIndexedInstanced(index_count, n, first_index, ...).
// Unreal, Unity: where the axes of the mesh were turned, the centres must be turned with them.

// Where a vertex is drawn, in the model's own space: call it before wind and the instance's transform.
float3 tree_prune_position(float3 position, float4 center_rank, float growth, float lambda, float fade) {
    float size = growth;
    if (fade > 0.0) {
        size = size * clamp((lambda - center_rank.w) / fade, 0.0, 1.0);
    }
    return center_rank.xyz + size * (position - center_rank.xyz);
}

// Linear colour of a leaf, before light: call it in the fragment shader.
float3 tree_prune_color(float3 color, float3 mean, float contrast) {
    return mean + contrast * (color - mean);
}
