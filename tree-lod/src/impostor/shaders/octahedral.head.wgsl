// Octahedral impostors of whole trees (Brucks 2018): WGSL.
//
// The pictures are read by two functions of yours, declared before this text. A place is in texels of the
// picture of colours, from its top left:
//   fn tree_octa_color(place: vec2<f32>) -> vec4<f32>   // linear colour and alpha, between four texels
//   fn tree_octa_detail(place: vec2<f32>) -> vec4<f32>  // the nearest texel: detail, not sRGB
// such as
//   { return textureSampleLevel(color, linear_clamp, place / side, 0.0); }
// `shape` is (grid, 1 if hemi, tile, 0) and `size` (radius, wide, high, 0) of Meta.
// Fragment shader on a box around the tree, all in its own space, relative to Meta::center:
//   tree_octa_view(eye, normalize(position - eye), shape, size, 0.0)  // linear colour, alpha
//   tree_octa_view(eye, normalize(position - eye), shape, size, 1.0)  // normal, distance
