// Octahedral impostors of whole trees (Brucks 2018): GLSL 3.00 ES or 1.30 and later.
//
// The pictures are read by two functions of yours, declared before this text. A place is in texels of the
// picture of colours, from its top left:
//   vec4 tree_octa_color(vec2 place);   // linear colour and alpha, between four texels: color, sRGB
//   vec4 tree_octa_detail(vec2 place);  // the nearest texel: detail, not sRGB; place / side * detail_side
// such as
//   vec4 tree_octa_color(vec2 place) { return textureLod(color, place / side, 0.0); }
// `shape` is (grid, 1 if hemi, tile, 0) and `size` (radius, wide, high, 0) of OctahedralMeta.
// Fragment shader on a box around the tree, all in its own space, relative to OctahedralMeta::center:
//   vec4 seen = tree_octa_view(eye, normalize(position - eye), shape, size, 0.0);  // linear colour, alpha
//   vec4 where = tree_octa_view(eye, normalize(position - eye), shape, size, 1.0); // normal, distance
// ---
float tree_octa_sign(float v) {
    float s = 1.0;
    if (v < 0.0) {
        s = -1.0;
    }
    return s;
}

// The place of a direction to the viewer on the unit square.
vec2 tree_octa_encode(vec3 direction, float hemi) {
    vec3 d = direction;
    if (hemi > 0.5) {
        d.y = max(d.y, 0.0);
    }
    d = d / max(abs(d.x) + abs(d.y) + abs(d.z), 1e-20);
    vec2 p = vec2(d.x, d.z);
    if (hemi > 0.5) {
        p = vec2(d.x + d.z, d.x - d.z);
    } else if (d.y < 0.0) {
        p = vec2((1.0 - abs(d.z)) * tree_octa_sign(d.x), (1.0 - abs(d.x)) * tree_octa_sign(d.z));
    }
    return 0.5 * p + vec2(0.5, 0.5);
}

// The direction of a place on the unit square.
vec3 tree_octa_decode(vec2 place, float hemi) {
    vec2 p = 2.0 * place - vec2(1.0, 1.0);
    vec3 d = vec3(p.x, 1.0 - abs(p.x) - abs(p.y), p.y);
    if (hemi > 0.5) {
        d = vec3(0.5 * (p.x + p.y), 0.0, 0.5 * (p.x - p.y));
        d.y = 1.0 - abs(d.x) - abs(d.z);
    } else if (d.y < 0.0) {
        d.x = (1.0 - abs(p.y)) * tree_octa_sign(p.x);
        d.z = (1.0 - abs(p.x)) * tree_octa_sign(p.y);
    }
    return normalize(d);
}

// One of the three views around a direction to the viewer: column, row, weight.
vec3 tree_octa_frame(vec3 direction, vec4 shape, int number) {
    float last = shape.x - 1.0;
    vec2 at = tree_octa_encode(direction, shape.y) * last;
    vec2 cell = clamp(floor(at), vec2(0.0, 0.0), vec2(last - 1.0, last - 1.0));
    vec2 f = clamp(at - cell, vec2(0.0, 0.0), vec2(1.0, 1.0));
    vec3 frame = vec3(cell.x, cell.y, 1.0 - max(f.x, f.y));
    if (number == 1) {
        frame = vec3(cell.x, cell.y + 1.0, abs(f.x - f.y));
        if (f.x > f.y) {
            frame = vec3(cell.x + 1.0, cell.y, abs(f.x - f.y));
        }
    }
    if (number == 2) {
        frame = vec3(cell.x + 1.0, cell.y + 1.0, min(f.x, f.y));
    }
    return frame;
}

// Texel coordinates of a point of a view, -1 to 1 right and up.
vec2 tree_octa_place(vec2 frame, vec2 at, float tile) {
    vec2 inside = vec2(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y) * tile;
    return frame * tile + clamp(inside, vec2(0.5, 0.5), vec2(tile - 0.5, tile - 0.5));
}

// Towards the viewer of a view.
vec3 tree_octa_toward(vec2 frame, vec4 shape) {
    return tree_octa_decode(frame / (shape.x - 1.0), shape.y);
}

// A point or direction in a view: right and up, -1 to 1, and metres towards the viewer.
vec3 tree_octa_seen(vec3 toward, vec3 v, vec4 size) {
    vec3 right = vec3(1.0, 0.0, 0.0);
    float level = toward.x * toward.x + toward.z * toward.z;
    if (level >= 1e-6) {
        right = vec3(toward.z, 0.0, -toward.x) / sqrt(level);
    }
    vec3 up = cross(toward, right);
    level = sqrt(max(1.0 - toward.y * toward.y, 0.0));
    float high = size.z * level + size.y * abs(toward.y);
    return vec3(dot(right, v) / size.y, dot(up, v) / high, dot(toward, v));
}

// The part of a ray that is within the depth of the tree, seen from a view.
vec2 tree_octa_ends(vec3 frame, vec3 origin, vec3 direction, vec2 ends, vec4 shape, vec4 size) {
    vec3 toward = tree_octa_toward(frame.xy, shape);
    float sink = -dot(toward, direction);
    if (frame.z <= 0.0 || sink < 0.1) {
        return ends;
    }
    float level = sqrt(max(1.0 - toward.y * toward.y, 0.0));
    float deep = size.y * level + size.z * abs(toward.y);
    float height = dot(toward, origin);
    return vec2(max(ends.x, (height - deep) / sink), min(ends.y, (height + deep) / sink));
}

// The weight of a view; nothing for one too far aside.
float tree_octa_weight(vec3 frame, vec3 direction, vec4 shape) {
    float weight = frame.z;
    if (-dot(tree_octa_toward(frame.xy, shape), direction) < 0.1) {
        weight = 0.0;
    }
    return weight;
}

// What a view, of column, row and weight, knows of a point of a ray. `start` and `along` are the ray as the view sees it.
// Where the ray crosses the depth that is there: place and distance; and weight times alpha, less than 0 where the point
// is hidden, 0 where the view sees through it.
vec4 tree_octa_look(vec3 frame, vec3 start, vec3 along, float s, float stride, vec4 shape, vec4 size) {
    vec4 look = vec4(0.0, 0.0, 0.0, 0.0);
    if (frame.z <= 0.0) {
        return look;
    }
    vec2 here = tree_octa_place(frame.xy, start.xy + along.xy * s, shape.z);
    float depth = (2.0 * tree_octa_detail(here).w - 1.0) * size.x;
    float above = start.z + along.z * s - depth;
    float slab = -0.5 * stride * along.z;
    if (above > slab + 0.005 * size.x) {
        return look;
    }
    look.w = frame.z * tree_octa_color(here).w;
    if (above < -slab - 0.05 * size.x) {
        look.w = -look.w;
        return look;
    }
    look.z = s - above / along.z;
    vec2 there = tree_octa_place(frame.xy, start.xy + along.xy * look.z, shape.z);
    return vec4(there.x, there.y, look.z, look.w);
}

// What a view sees, times its share: linear colour, or with `detail` of 1 normal and distance.
vec4 tree_octa_share(vec4 look, float detail) {
    vec4 texel = vec4(0.0, 0.0, 0.0, 0.0);
    if (look.w > 0.0) {
        texel = tree_octa_color(look.xy);
        if (detail > 0.5) {
            texel = 2.0 * tree_octa_detail(look.xy) - vec4(1.0, 1.0, 1.0, 1.0);
        }
        texel = look.w * vec4(texel.x, texel.y, texel.z, look.z);
    }
    return texel;
}

// What a ray sees: linear colour and alpha, or with `detail` of 1 normal and distance.
vec4 tree_octa_view(vec3 origin, vec3 direction, vec4 shape, vec4 size, float detail) {
    vec4 sum = vec4(0.0, 0.0, 0.0, 0.0);
    // The part of the ray within the ball, in front of the eye.
    float middle = -dot(origin, direction);
    vec3 nearest = origin + direction * middle;
    float inside = size.x * size.x - dot(nearest, nearest);
    if (inside <= 0.0) {
        return sum;
    }
    float reach = sqrt(inside);
    if (middle + reach <= 0.0) {
        return sum;
    }
    vec2 ends = vec2(max(middle - reach, 0.0), middle + reach);
    // Three views around the ray, and the ray as each of them sees it.
    vec3 frame_a = tree_octa_frame(-direction, shape, 0);
    vec3 frame_b = tree_octa_frame(-direction, shape, 1);
    vec3 frame_c = tree_octa_frame(-direction, shape, 2);
    ends = tree_octa_ends(frame_a, origin, direction, ends, shape, size);
    ends = tree_octa_ends(frame_b, origin, direction, ends, shape, size);
    ends = tree_octa_ends(frame_c, origin, direction, ends, shape, size);
    frame_a.z = tree_octa_weight(frame_a, direction, shape);
    frame_b.z = tree_octa_weight(frame_b, direction, shape);
    frame_c.z = tree_octa_weight(frame_c, direction, shape);
    float total = frame_a.z + frame_b.z + frame_c.z;
    if (ends.x >= ends.y || total <= 0.0) {
        return sum;
    }
    vec3 start_a = tree_octa_seen(tree_octa_toward(frame_a.xy, shape), origin, size);
    vec3 along_a = tree_octa_seen(tree_octa_toward(frame_a.xy, shape), direction, size);
    vec3 start_b = tree_octa_seen(tree_octa_toward(frame_b.xy, shape), origin, size);
    vec3 along_b = tree_octa_seen(tree_octa_toward(frame_b.xy, shape), direction, size);
    vec3 start_c = tree_octa_seen(tree_octa_toward(frame_c.xy, shape), origin, size);
    vec3 along_c = tree_octa_seen(tree_octa_toward(frame_c.xy, shape), direction, size);
    float most = 0.0;
    float stride = (ends.y - ends.x) / 32.0;
    float s = ends.x + 0.5 * stride;
    for (int i = 0; i < 32; i = i + 1) {
        vec4 a = tree_octa_look(frame_a, start_a, along_a, s, stride, shape, size);
        vec4 b = tree_octa_look(frame_b, start_b, along_b, s, stride, shape, size);
        vec4 c = tree_octa_look(frame_c, start_c, along_c, s, stride, shape, size);
        float seen = max(a.w, 0.0) + max(b.w, 0.0) + max(c.w, 0.0);
        float hidden = max(-a.w, 0.0) + max(-b.w, 0.0) + max(-c.w, 0.0);
        float alpha = (seen + 0.49 * hidden) / total;
        if (seen > 0.0 && alpha > most) {
            // What is nearer hides what comes after as far as it is there.
            vec4 found = tree_octa_share(a, detail) + tree_octa_share(b, detail) + tree_octa_share(c, detail);
            sum = sum + (alpha - most) / seen * found;
            most = alpha;
            if (alpha >= 0.995) {
                break;
            }
        }
        s = s + stride;
    }
    if (most <= 0.0) {
        return vec4(0.0, 0.0, 0.0, 0.0);
    }
    sum = sum / most;
    if (detail > 0.5) {
        vec3 normal = normalize(vec3(sum.x, sum.y, sum.z));
        return vec4(normal.x, normal.y, normal.z, sum.w);
    }
    return vec4(sum.x, sum.y, sum.z, most);
}
