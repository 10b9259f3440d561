// Octahedral impostors of whole trees (Brucks 2018): HLSL.
//
// The pictures are read by two functions of yours, declared before this text. A place is in texels of the
// picture of colours, from its top left:
//   float4 tree_octa_color(float2 place);  // linear colour and alpha, between four texels: color, sRGB
//   float4 tree_octa_detail(float2 place); // the nearest texel: detail, not sRGB
// such as
//   float4 tree_octa_color(float2 place) { return color.SampleLevel(linear_clamp, place / side, 0); }
//   float4 tree_octa_detail(float2 place) { return detail.SampleLevel(point_clamp, place / side, 0); }
// `shape` is (grid, 1 if hemi, tile, 0) and `size` (radius, wide, high, 0) of Meta.
// Fragment shader on a box around the tree, all in its own space, relative to Meta::center:
//   tree_octa_view(eye, normalize(position - eye), shape, size, 0.0)  // linear colour, alpha
//   tree_octa_view(eye, normalize(position - eye), shape, size, 1.0)  // normal, distance
