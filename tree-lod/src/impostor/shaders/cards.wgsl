// Planes of boxes of leaves (Lluch et al. 2010, §4.2): WGSL.
//
// Vertex buffer: `_TREE_CENTER` (box centre, number of the plane), `_TREE_HALF` (half sides), `_TREE_TURN`
// (quaternion from the box's axes to those of the tree), 4 floats each.
// Vertex shader, eye in the space of the tree (all four vertices of a plane give the same):
//   @interpolate(flat) interval =
//       tree_card_interval(half.xyz, tree_card_local(turn, eye - center.xyz), center.w);
// Fragment shader: discard unless
//   textureSample(cards, s, uv).a >= 0.5 && tree_card_kept(interval, tree_card_noise(position.xy)) > 0.5
// ---
// A direction of the tree along the axes of a box.
fn tree_card_local(turn: vec4<f32>, direction: vec3<f32>) -> vec3<f32> {
    var t: vec3<f32> = 2.0 * cross(direction, turn.xyz);
    return direction + turn.w * t + cross(t, turn.xyz);
}

// The part of 0 to 1 that belongs to a plane, for a direction to the viewer along the axes of the box.
fn tree_card_interval(half_sides: vec3<f32>, direction: vec3<f32>, plane: f32) -> vec2<f32> {
    var v: vec3<f32> = normalize(direction);
    var side: vec3<f32> = half_sides / max(half_sides.x, max(half_sides.y, half_sides.z));
    var span: vec3<f32> = sqrt(side.yzx * side.yzx + side.zxy * side.zxy);
    var p: vec3<f32> = side.yzx * v.zxy / span;
    var q: vec3<f32> = side.zxy * v.yzx / span;
    var a: vec3<f32> = abs(p - q);
    var b: vec3<f32> = abs(p + q);
    var m: vec3<f32> = max(a, b);
    var most: f32 = max(m.x, max(m.y, m.z));
    a = a / most;
    b = b / most;
    a = a * a * a * a * a * a * a * a;
    b = b * b * b * b * b * b * b * b;
    var both: vec3<f32> = a + b;
    var low: f32 = 0.0;
    var share: f32 = a.x;
    if (plane > 0.5) {
        low = low + share;
        share = b.x;
    }
    if (plane > 1.5) {
        low = low + share;
        share = a.y;
    }
    if (plane > 2.5) {
        low = low + share;
        share = b.y;
    }
    if (plane > 3.5) {
        low = low + share;
        share = a.z;
    }
    if (plane > 4.5) {
        low = low + share;
        share = b.z + 1.0;
    }
    return vec2(low, low + share) / (both.x + both.y + both.z);
}

// A pattern over pixels, 0 to 1 (Jimenez 2014).
fn tree_card_noise(pixel: vec2<f32>) -> f32 {
    var wave: f32 = dot(pixel, vec2(0.06711056, 0.00583715));
    wave = 52.982918 * (wave - floor(wave));
    return wave - floor(wave);
}

// 1 where a pixel draws the plane, 0 where it draws another one of the box.
fn tree_card_kept(interval: vec2<f32>, value: f32) -> f32 {
    return step(interval.x, value) * (1.0 - step(interval.y, value));
}
