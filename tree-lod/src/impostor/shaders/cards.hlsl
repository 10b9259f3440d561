// Planes of boxes of leaves (Lluch et al. 2010, §4.2): HLSL.
//
// Vertex buffer: `_TREE_CENTER` (box centre, number of the plane), `_TREE_HALF` (half sides), `_TREE_TURN`
// (quaternion from the box's axes to those of the tree), 4 floats each.
// Vertex shader, eye in the space of the tree (all four vertices of a plane give the same):
//   nointerpolation float2 interval =
//       tree_card_interval(half.xyz, tree_card_local(turn, eye - center.xyz), center.w);
// Pixel shader: discard unless
//   cards.Sample(s, uv).a >= 0.5 && tree_card_kept(interval, tree_card_noise(position.xy)) > 0.5
// ---
// A direction of the tree along the axes of a box.
float3 tree_card_local(float4 turn, float3 direction) {
    float3 t = 2.0 * cross(direction, turn.xyz);
    return direction + turn.w * t + cross(t, turn.xyz);
}

// The part of 0 to 1 that belongs to a plane, for a direction to the viewer along the axes of the box.
float2 tree_card_interval(float3 half_sides, float3 direction, float plane) {
    float3 v = normalize(direction);
    float3 side = half_sides / max(half_sides.x, max(half_sides.y, half_sides.z));
    float3 span = sqrt(side.yzx * side.yzx + side.zxy * side.zxy);
    float3 p = side.yzx * v.zxy / span;
    float3 q = side.zxy * v.yzx / span;
    float3 a = abs(p - q);
    float3 b = abs(p + q);
    float3 m = max(a, b);
    float most = max(m.x, max(m.y, m.z));
    a = a / most;
    b = b / most;
    a = a * a * a * a * a * a * a * a;
    b = b * b * b * b * b * b * b * b;
    float3 both = a + b;
    float low = 0.0;
    float share = a.x;
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
    return float2(low, low + share) / (both.x + both.y + both.z);
}

// A pattern over pixels, 0 to 1 (Jimenez 2014).
float tree_card_noise(float2 pixel) {
    float wave = dot(pixel, float2(0.06711056, 0.00583715));
    wave = 52.982918 * (wave - floor(wave));
    return wave - floor(wave);
}

// 1 where a pixel draws the plane, 0 where it draws another one of the box.
float tree_card_kept(float2 interval, float value) {
    return step(interval.x, value) * (1.0 - step(interval.y, value));
}
