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
// ---
fn tree_octa_sign(v: f32) -> f32 {
    var s: f32 = 1.0;
    if (v < 0.0) {
        s = -1.0;
    }
    return s;
}

// The place of a direction to the viewer on the unit square.
fn tree_octa_encode(direction: vec3<f32>, hemi: f32) -> vec2<f32> {
    var d: vec3<f32> = direction;
    if (hemi > 0.5) {
        d.y = max(d.y, 0.0);
    }
    d = d / max(abs(d.x) + abs(d.y) + abs(d.z), 1e-20);
    var p: vec2<f32> = vec2(d.x, d.z);
    if (hemi > 0.5) {
        p = vec2(d.x + d.z, d.x - d.z);
    } else if (d.y < 0.0) {
        p = vec2((1.0 - abs(d.z)) * tree_octa_sign(d.x), (1.0 - abs(d.x)) * tree_octa_sign(d.z));
    }
    return 0.5 * p + vec2(0.5, 0.5);
}

// The direction of a place on the unit square.
fn tree_octa_decode(place: vec2<f32>, hemi: f32) -> vec3<f32> {
    var p: vec2<f32> = 2.0 * place - vec2(1.0, 1.0);
    var d: vec3<f32> = vec3(p.x, 1.0 - abs(p.x) - abs(p.y), p.y);
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
fn tree_octa_frame(direction: vec3<f32>, shape: vec4<f32>, number: i32) -> vec3<f32> {
    var last: f32 = shape.x - 1.0;
    var at: vec2<f32> = tree_octa_encode(direction, shape.y) * last;
    var cell: vec2<f32> = clamp(floor(at), vec2(0.0, 0.0), vec2(last - 1.0, last - 1.0));
    var f: vec2<f32> = clamp(at - cell, vec2(0.0, 0.0), vec2(1.0, 1.0));
    var frame: vec3<f32> = vec3(cell.x, cell.y, 1.0 - max(f.x, f.y));
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
fn tree_octa_place(frame: vec2<f32>, at: vec2<f32>, tile: f32) -> vec2<f32> {
    var inside: vec2<f32> = vec2(0.5 + 0.5 * at.x, 0.5 - 0.5 * at.y) * tile;
    return frame * tile + clamp(inside, vec2(0.5, 0.5), vec2(tile - 0.5, tile - 0.5));
}

// Follows a ray through the depths of a view: place, distance, 1 where it met something.
fn tree_octa_trace(frame: vec2<f32>, origin: vec3<f32>, direction: vec3<f32>, ends: vec2<f32>, shape: vec4<f32>, size: vec4<f32>) -> vec4<f32> {
    var toward: vec3<f32> = tree_octa_decode(frame / (shape.x - 1.0), shape.y);
    var right: vec3<f32> = vec3(1.0, 0.0, 0.0);
    var level: f32 = toward.x * toward.x + toward.z * toward.z;
    if (level >= 1e-6) {
        right = vec3(toward.z, 0.0, -toward.x) / sqrt(level);
    }
    var up: vec3<f32> = cross(toward, right);
    var sink: f32 = -dot(toward, direction);
    var met: vec4<f32> = vec4(0.0, 0.0, 0.0, 0.0);
    if (sink < 0.1) {
        return met;
    }
    level = sqrt(max(1.0 - toward.y * toward.y, 0.0));
    var half_size: vec2<f32> = vec2(size.y, size.z * level + size.y * abs(toward.y));
    var deep: f32 = size.y * level + size.z * abs(toward.y);
    var start: vec2<f32> = vec2(dot(right, origin), dot(up, origin)) / half_size;
    var along: vec2<f32> = vec2(dot(right, direction), dot(up, direction)) / half_size;
    var height: f32 = dot(toward, origin);
    var nigh: f32 = max(ends.x, (height - deep) / sink);
    var afar: f32 = min(ends.y, (height + deep) / sink);
    if (nigh >= afar) {
        return met;
    }
    var stride: f32 = (afar - nigh) / 32.0;
    var slab: f32 = 0.5 * stride * sink;
    var s: f32 = nigh + 0.5 * stride;
    for (var i: i32 = 0; i < 32; i = i + 1) {
        var here: vec2<f32> = tree_octa_place(frame, start + along * s, shape.z);
        var depth: f32 = (2.0 * tree_octa_detail(here).w - 1.0) * size.x;
        var above: f32 = height - sink * s - depth;
        if (above <= slab && above >= -slab - 0.17 * size.x) {
            var alpha: f32 = tree_octa_color(here).w;
            if (alpha >= 0.25) {
                // To where the ray crosses the depth that was found.
                var crossing: f32 = clamp(s + above / sink, nigh, afar);
                var there: vec2<f32> = tree_octa_place(frame, start + along * crossing, shape.z);
                met = vec4(there.x, there.y, crossing, 1.0);
                return met;
            }
        }
        s = s + stride;
    }
    return met;
}

// What a ray sees: linear colour and alpha, or with `detail` of 1 normal and distance.
fn tree_octa_view(origin: vec3<f32>, direction: vec3<f32>, shape: vec4<f32>, size: vec4<f32>, detail: f32) -> vec4<f32> {
    var sum: vec4<f32> = vec4(0.0, 0.0, 0.0, 0.0);
    var total: f32 = 0.0;
    var most: f32 = 0.0;
    // The part of the ray within the ball, in front of the eye.
    var middle: f32 = -dot(origin, direction);
    var nearest: vec3<f32> = origin + direction * middle;
    var inside: f32 = size.x * size.x - dot(nearest, nearest);
    if (inside <= 0.0) {
        return sum;
    }
    var reach: f32 = sqrt(inside);
    if (middle + reach <= 0.0) {
        return sum;
    }
    var ends: vec2<f32> = vec2(max(middle - reach, 0.0), middle + reach);
    for (var i: i32 = 0; i < 3; i = i + 1) {
        var frame: vec3<f32> = tree_octa_frame(-direction, shape, i);
        if (frame.z > 0.0) {
            // Nearer views count more than in proportion: outlines stay sharper.
            var weight: f32 = frame.z * sqrt(frame.z);
            most = most + weight;
            var met: vec4<f32> = tree_octa_trace(frame.xy, origin, direction, ends, shape, size);
            if (met.w > 0.5) {
                var texel: vec4<f32> = tree_octa_color(met.xy);
                var share: f32 = weight * texel.w;
                if (detail > 0.5) {
                    var found: vec4<f32> = 2.0 * tree_octa_detail(met.xy) - vec4(1.0, 1.0, 1.0, 1.0);
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
        var normal: vec3<f32> = normalize(vec3(sum.x, sum.y, sum.z));
        return vec4(normal.x, normal.y, normal.z, sum.w);
    }
    return vec4(sum.x, sum.y, sum.z, total / most);
}
