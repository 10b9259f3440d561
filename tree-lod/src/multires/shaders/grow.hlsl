// Branches that grow in (multiresolution trees, after Lluch et al. 2010): HLSL, any shader model.
//
// Vertex buffer: one more attribute of 4 floats, `branch` (MultiMesh::branches, `_TREE_BRANCH` in glTF).
//   float4 branch : TEXCOORD5;
// Per instance: level, the fractional number of levels. Draw the prefix of each index buffer that
// MultiMesh::draws gives for it.

// Where a vertex is drawn, in the model's own space: call it before wind and the instance's transform.
float3 tree_grow_position(float3 position, float4 branch, float level) {
    float size = clamp(level - branch.w, 0.0, 1.0);
    return branch.xyz + size * (position - branch.xyz);
}
