// Planes of boxes of leaves (Lluch et al. 2010, §4.2): WGSL.
//
// Vertex buffer: `_TREE_CENTER` (box centre, number of the plane), `_TREE_HALF` (half sides), `_TREE_TURN`
// (quaternion from the box's axes to those of the tree), 4 floats each.
// Vertex shader, eye in the space of the tree (all four vertices of a plane give the same):
//   @interpolate(flat) interval =
//       tree_card_interval(half.xyz, tree_card_local(turn, eye - center.xyz), center.w);
// Fragment shader: discard unless
//   textureSample(cards, s, uv).a >= 0.5 && tree_card_kept(interval, tree_card_noise(position.xy)) > 0.5
