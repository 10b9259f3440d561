// Octahedral impostors of whole trees (Brucks 2018): GLSL 3.00 ES or 1.30 and later.
//
// The pictures are read by two functions of yours, declared before this text. A place is in texels of the
// picture of colours, from its top left:
//   vec4 tree_octa_color(vec2 place);   // linear colour and alpha, between four texels: color, sRGB
//   vec4 tree_octa_detail(vec2 place);  // the nearest texel: detail, not sRGB; place / side * detail_side
// such as
//   vec4 tree_octa_color(vec2 place) { return textureLod(color, place / side, 0.0); }
// `shape` is (grid, 1 if hemi, tile, 0) and `size` (radius, wide, high, 0) of Meta.
// Fragment shader on a box around the tree, all in its own space, relative to Meta::center:
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

// Follows a ray through the depths of a view: place, distance, 1 where it met something.
vec4 tree_octa_trace(vec2 frame, vec3 origin, vec3 direction, vec2 ends, vec4 shape, vec4 size) {
    vec3 toward = tree_octa_decode(frame / (shape.x - 1.0), shape.y);
    vec3 right = vec3(1.0, 0.0, 0.0);
    float level = toward.x * toward.x + toward.z * toward.z;
    if (level >= 1e-6) {
        right = vec3(toward.z, 0.0, -toward.x) / sqrt(level);
    }
    vec3 up = cross(toward, right);
    float sink = -dot(toward, direction);
    vec4 met = vec4(0.0, 0.0, 0.0, 0.0);
    if (sink < 0.1) {
        return met;
    }
    level = sqrt(max(1.0 - toward.y * toward.y, 0.0));
    vec2 half_size = vec2(size.y, size.z * level + size.y * abs(toward.y));
    float deep = size.y * level + size.z * abs(toward.y);
    vec2 start = vec2(dot(right, origin), dot(up, origin)) / half_size;
    vec2 along = vec2(dot(right, direction), dot(up, direction)) / half_size;
    float height = dot(toward, origin);
    float nigh = max(ends.x, (height - deep) / sink);
    float afar = min(ends.y, (height + deep) / sink);
    if (nigh >= afar) {
        return met;
    }
    float stride = (afar - nigh) / 32.0;
    float slab = 0.5 * stride * sink;
    float s = nigh + 0.5 * stride;
    for (int i = 0; i < 32; i = i + 1) {
        vec2 here = tree_octa_place(frame, start + along * s, shape.z);
        float depth = (2.0 * tree_octa_detail(here).w - 1.0) * size.x;
        float above = height - sink * s - depth;
        if (above <= slab && above >= -slab - 0.17 * size.x) {
            float alpha = tree_octa_color(here).w;
            if (alpha >= 0.25) {
                // To where the ray crosses the depth that was found.
                float crossing = clamp(s + above / sink, nigh, afar);
                vec2 there = tree_octa_place(frame, start + along * crossing, shape.z);
                met = vec4(there.x, there.y, crossing, 1.0);
                return met;
            }
        }
        s = s + stride;
    }
    return met;
}

// What a ray sees: linear colour and alpha, or with `detail` of 1 normal and distance.
vec4 tree_octa_view(vec3 origin, vec3 direction, vec4 shape, vec4 size, float detail) {
    vec4 sum = vec4(0.0, 0.0, 0.0, 0.0);
    float total = 0.0;
    float most = 0.0;
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
    for (int i = 0; i < 3; i = i + 1) {
        vec3 frame = tree_octa_frame(-direction, shape, i);
        if (frame.z > 0.0) {
            // Nearer views count more than in proportion: outlines stay sharper.
            float weight = frame.z * sqrt(frame.z);
            most = most + weight;
            vec4 met = tree_octa_trace(frame.xy, origin, direction, ends, shape, size);
            if (met.w > 0.5) {
                vec4 texel = tree_octa_color(met.xy);
                float share = weight * texel.w;
                if (detail > 0.5) {
                    vec4 found = 2.0 * tree_octa_detail(met.xy) - vec4(1.0, 1.0, 1.0, 1.0);
                    texel = vec4(found.x, found.y, found.z, met.z);
                }
                sum = sum + share * vec4(texel.x, texel.y, texel.z, 0.0);
                sum.w = sum.w + share * met.z;
                total = total + share;
            }
        }
    }
    if (total <= 0.0) {
        return vec4(0.0, 0.0, 0.0, 0.0);
    }
    sum = sum / total;
    if (detail > 0.5) {
        vec3 normal = normalize(vec3(sum.x, sum.y, sum.z));
        return vec4(normal.x, normal.y, normal.z, sum.w);
    }
    return vec4(sum.x, sum.y, sum.z, total / most);
}
