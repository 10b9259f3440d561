// Planes of boxes of leaves (Lluch et al. 2010, §4.2): GLSL 1.30 or ES 3.00 and later.
//
// Vertex buffer: `_TREE_CENTER` (box centre, number of the plane), `_TREE_HALF` (half sides), `_TREE_TURN`
// (quaternion from the box's axes to those of the tree), 4 floats each.
// Vertex shader, eye in the space of the tree (all four vertices of a plane give the same):
//   flat vec2 interval = tree_card_interval(half.xyz, tree_card_local(turn, eye - center.xyz), center.w);
// Fragment shader: discard unless
//   texture(cards, uv).a >= 0.5 && tree_card_kept(interval, tree_card_noise(gl_FragCoord.xy)) > 0.5
// ---
// A direction of the tree along the axes of a box.
vec3 tree_card_local(vec4 turn, vec3 direction) {
    vec3 t = 2.0 * cross(direction, turn.xyz);
    return direction + turn.w * t + cross(t, turn.xyz);
}

// The part of 0 to 1 that belongs to a plane, for a direction to the viewer along the axes of the box.
vec2 tree_card_interval(vec3 half_sides, vec3 direction, float plane) {
    vec3 v = normalize(direction);
    vec3 side = half_sides / max(half_sides.x, max(half_sides.y, half_sides.z));
    vec3 span = sqrt(side.yzx * side.yzx + side.zxy * side.zxy);
    vec3 p = side.yzx * v.zxy / span;
    vec3 q = side.zxy * v.yzx / span;
    vec3 a = abs(p - q);
    vec3 b = abs(p + q);
    vec3 m = max(a, b);
    float most = max(m.x, max(m.y, m.z));
    a = a / most;
    b = b / most;
    a = a * a * a * a * a * a * a * a;
    b = b * b * b * b * b * b * b * b;
    vec3 both = a + b;
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
    return vec2(low, low + share) / (both.x + both.y + both.z);
}

// A pattern over pixels, 0 to 1 (Jimenez 2014).
float tree_card_noise(vec2 pixel) {
    float wave = dot(pixel, vec2(0.06711056, 0.00583715));
    wave = 52.982918 * (wave - floor(wave));
    return wave - floor(wave);
}

// 1 where a pixel draws the plane, 0 where it draws another one of the box.
float tree_card_kept(vec2 interval, float value) {
    return step(interval.x, value) * (1.0 - step(interval.y, value));
}
