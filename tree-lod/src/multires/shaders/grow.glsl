// Branches that grow in (multiresolution trees, after Lluch et al. 2010): GLSL 1.30, ES 3.00 and later.
//
// Vertex buffer: one more attribute of 4 floats, `branch` (MultiMesh::branches, `_TREE_BRANCH` in glTF).
//   in vec4 branch;
// Per instance: level, the fractional number of levels. Draw the prefix of each index buffer that
// MultiMesh::draws gives for it.

// Where a vertex is drawn, in the model's own space: call it before wind and the instance's transform.
vec3 tree_grow_position(vec3 position, vec4 branch, float level) {
    float size = clamp(level - branch.w, 0.0, 1.0);
    return branch.xyz + size * (position - branch.xyz);
}
