// Branches that grow in (multiresolution trees, after Lluch et al. 2010): WGSL.
//
// Vertex buffer: one more attribute of 4 floats, `branch` (MultiMesh::branches, `_TREE_BRANCH` in glTF).
//   @location(5) branch: vec4<f32>
// Per instance: level, the fractional number of levels. Draw the prefix of each index buffer that
// MultiMesh::draws gives for it.

// Where a vertex is drawn, in the model's own space: call it before wind and the instance's transform.
fn tree_grow_position(position: vec3<f32>, branch: vec4<f32>, level: f32) -> vec3<f32> {
    let size: f32 = clamp(level - branch.w, 0.0, 1.0);
    return branch.xyz + size * (position - branch.xyz);
}
