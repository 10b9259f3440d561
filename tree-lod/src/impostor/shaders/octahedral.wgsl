// Octahedral impostors of whole trees (Brucks 2018): WGSL.
//
// The pictures are read by two functions of yours, declared before this text. A place is in texels of the
// picture of colours, from its top left:
//   fn tree_octa_color(place: vec2<f32>) -> vec4<f32>   // linear colour and alpha, between four texels
//   fn tree_octa_detail(place: vec2<f32>) -> vec4<f32>  // the nearest texel: detail, not sRGB
// such as
//   { return textureSampleLevel(color, linear_clamp, place / side, 0.0); }
// `shape` is (grid, 1 if hemi, tile, 0) and `size` (radius, wide, high, 0) of OctahedralMeta.
// Fragment shader on a box around the tree, all in its own space, relative to OctahedralMeta::center:
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

// Towards the viewer of a view.
fn tree_octa_toward(frame: vec2<f32>, shape: vec4<f32>) -> vec3<f32> {
    return tree_octa_decode(frame / (shape.x - 1.0), shape.y);
}

// A point or direction in a view: right and up, -1 to 1, and metres towards the viewer.
fn tree_octa_seen(toward: vec3<f32>, v: vec3<f32>, size: vec4<f32>) -> vec3<f32> {
    var right: vec3<f32> = vec3(1.0, 0.0, 0.0);
    var level: f32 = toward.x * toward.x + toward.z * toward.z;
    if (level >= 1e-6) {
        right = vec3(toward.z, 0.0, -toward.x) / sqrt(level);
    }
    var up: vec3<f32> = cross(toward, right);
    level = sqrt(max(1.0 - toward.y * toward.y, 0.0));
    var high: f32 = size.z * level + size.y * abs(toward.y);
    return vec3(dot(right, v) / size.y, dot(up, v) / high, dot(toward, v));
}

// The part of a ray that is within the depth of the tree, seen from a view.
fn tree_octa_ends(frame: vec3<f32>, origin: vec3<f32>, direction: vec3<f32>, ends: vec2<f32>, shape: vec4<f32>, size: vec4<f32>) -> vec2<f32> {
    var toward: vec3<f32> = tree_octa_toward(frame.xy, shape);
    var sink: f32 = -dot(toward, direction);
    if (frame.z <= 0.0 || sink < 0.1) {
        return ends;
    }
    var level: f32 = sqrt(max(1.0 - toward.y * toward.y, 0.0));
    var deep: f32 = size.y * level + size.z * abs(toward.y);
    var height: f32 = dot(toward, origin);
    return vec2(max(ends.x, (height - deep) / sink), min(ends.y, (height + deep) / sink));
}

// The weight of a view; nothing for one too far aside.
fn tree_octa_weight(frame: vec3<f32>, direction: vec3<f32>, shape: vec4<f32>) -> f32 {
    var weight: f32 = frame.z;
    if (-dot(tree_octa_toward(frame.xy, shape), direction) < 0.1) {
        weight = 0.0;
    }
    return weight;
}

// What a view, of column, row and weight, knows of a point of a ray. `start` and `along` are the ray as the view sees it.
// Where the ray crosses the depth that is there: place and distance; and weight times alpha, less than 0 where the point
// is hidden, 0 where the view sees through it.
fn tree_octa_look(frame: vec3<f32>, start: vec3<f32>, along: vec3<f32>, s: f32, stride: f32, shape: vec4<f32>, size: vec4<f32>) -> vec4<f32> {
    var look: vec4<f32> = vec4(0.0, 0.0, 0.0, 0.0);
    if (frame.z <= 0.0) {
        return look;
    }
    var here: vec2<f32> = tree_octa_place(frame.xy, start.xy + along.xy * s, shape.z);
    var depth: f32 = (2.0 * tree_octa_detail(here).w - 1.0) * size.x;
    var above: f32 = start.z + along.z * s - depth;
    var slab: f32 = -0.5 * stride * along.z;
    if (above > slab + 0.005 * size.x) {
        return look;
    }
    look.w = frame.z * tree_octa_color(here).w;
    if (above < -slab - 0.05 * size.x) {
        look.w = -look.w;
        return look;
    }
    look.z = s - above / along.z;
    var there: vec2<f32> = tree_octa_place(frame.xy, start.xy + along.xy * look.z, shape.z);
    return vec4(there.x, there.y, look.z, look.w);
}

// What a view sees, times its share: linear colour, or with `detail` of 1 normal and distance.
fn tree_octa_share(look: vec4<f32>, detail: f32) -> vec4<f32> {
    var texel: vec4<f32> = vec4(0.0, 0.0, 0.0, 0.0);
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
fn tree_octa_view(origin: vec3<f32>, direction: vec3<f32>, shape: vec4<f32>, size: vec4<f32>, detail: f32) -> vec4<f32> {
    var sum: vec4<f32> = vec4(0.0, 0.0, 0.0, 0.0);
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
    // Three views around the ray, and the ray as each of them sees it.
    var frame_a: vec3<f32> = tree_octa_frame(-direction, shape, 0);
    var frame_b: vec3<f32> = tree_octa_frame(-direction, shape, 1);
    var frame_c: vec3<f32> = tree_octa_frame(-direction, shape, 2);
    ends = tree_octa_ends(frame_a, origin, direction, ends, shape, size);
    ends = tree_octa_ends(frame_b, origin, direction, ends, shape, size);
    ends = tree_octa_ends(frame_c, origin, direction, ends, shape, size);
    frame_a.z = tree_octa_weight(frame_a, direction, shape);
    frame_b.z = tree_octa_weight(frame_b, direction, shape);
    frame_c.z = tree_octa_weight(frame_c, direction, shape);
    var total: f32 = frame_a.z + frame_b.z + frame_c.z;
    if (ends.x >= ends.y || total <= 0.0) {
        return sum;
    }
    var start_a: vec3<f32> = tree_octa_seen(tree_octa_toward(frame_a.xy, shape), origin, size);
    var along_a: vec3<f32> = tree_octa_seen(tree_octa_toward(frame_a.xy, shape), direction, size);
    var start_b: vec3<f32> = tree_octa_seen(tree_octa_toward(frame_b.xy, shape), origin, size);
    var along_b: vec3<f32> = tree_octa_seen(tree_octa_toward(frame_b.xy, shape), direction, size);
    var start_c: vec3<f32> = tree_octa_seen(tree_octa_toward(frame_c.xy, shape), origin, size);
    var along_c: vec3<f32> = tree_octa_seen(tree_octa_toward(frame_c.xy, shape), direction, size);
    var most: f32 = 0.0;
    var stride: f32 = (ends.y - ends.x) / 32.0;
    var s: f32 = ends.x + 0.5 * stride;
    for (var i: i32 = 0; i < 32; i = i + 1) {
        var a: vec4<f32> = tree_octa_look(frame_a, start_a, along_a, s, stride, shape, size);
        var b: vec4<f32> = tree_octa_look(frame_b, start_b, along_b, s, stride, shape, size);
        var c: vec4<f32> = tree_octa_look(frame_c, start_c, along_c, s, stride, shape, size);
        var seen: f32 = max(a.w, 0.0) + max(b.w, 0.0) + max(c.w, 0.0);
        var hidden: f32 = max(-a.w, 0.0) + max(-b.w, 0.0) + max(-c.w, 0.0);
        var alpha: f32 = (seen + 0.49 * hidden) / total;
        if (seen > 0.0 && alpha > most) {
            // What is nearer hides what comes after as far as it is there.
            var found: vec4<f32> = tree_octa_share(a, detail) + tree_octa_share(b, detail) + tree_octa_share(c, detail);
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
        var normal: vec3<f32> = normalize(vec3(sum.x, sum.y, sum.z));
        return vec4(normal.x, normal.y, normal.z, sum.w);
    }
    return vec4(sum.x, sum.y, sum.z, most);
}
