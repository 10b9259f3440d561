/* What goes into a tree from outlines: outlines, leaves, drawings, bumps, branches, and arrangements. */
#include "check.h"
#include <math.h>

#define PI 3.14159265f

static int near(float a, float b) { return fabsf(a - b) < 1e-3f; }

static int says(tree_str text, const char *expected) {
    return text.len == strlen(expected) && memcmp(text.data, expected, text.len) == 0;
}

/* Whether one of n lines has `part` in it; without a part, that there are n. */
static int one_says(tree_lines *lines, size_t n, const char *part) {
    const tree_str *texts;
    size_t n_texts;
    OK(tree_lines_view(lines, &texts, &n_texts));
    CHECK(n_texts == n);
    int found = 0;
    for (size_t i = 0; i < n_texts; i++) {
        char text[256] = "";
        memcpy(text, texts[i].data, texts[i].len < 255 ? texts[i].len : 255);
        found |= strstr(text, part) != NULL;
    }
    OK(tree_lines_free(lines));
    return found;
}

/* Corners (0, 0) and (4, 2). */
static const float box[] = {0, 0, 4, 0, 4, 2, 0, 2};

static tree_outline *a_box(void) {
    tree_outline *outline;
    OK(tree_outline_from_points(box, 4, NULL, &outline));
    return outline;
}

enum { ROUND = 200 };

/* Five round lobes about a point, about 3 m large. */
static tree_outline *a_flower(float x, float y) {
    float points[2 * ROUND];
    for (int i = 0; i < ROUND; i++) {
        float angle = 2 * PI * (float)i / ROUND, far = 1 + 0.45f * cosf(5 * angle);
        points[2 * i] = x + far * cosf(angle);
        points[2 * i + 1] = y + far * sinf(angle);
    }
    tree_outline *outline;
    OK(tree_outline_from_points(points, ROUND, NULL, &outline));
    return outline;
}

static tree_outline_columns columns_of(const tree_outline *outline) {
    tree_outline_columns columns = {.struct_size = sizeof columns};
    OK(tree_outline_view(outline, &columns));
    return columns;
}

static void outlines(void) {
    tree_outline_close_params params;
    OK(tree_outline_close_params_init(&params, sizeof params));
    CHECK(near(params.gap, 0.15f) && params.corners == 2000);
    OK(tree_outline_close_params_check(&params));
    params.corners = 7;
    FAILS(TREE_ERROR_PARAMETER, "outline.corners", tree_outline_close_params_check(&params));

    /* With the clock, open, with a point that is none. */
    static const float drawn[] = {0, 0, 0, 1, NAN, 1, 0, 2, 2, 2, 4, 2, 4, 1};
    tree_outline *outline, *bad;
    OK(tree_outline_close(drawn, 7, "crown", 5, NULL, NULL, &outline));
    tree_outline_columns columns = columns_of(outline);
    CHECK(columns.n_points == 6 && near(columns.area, 6) && near(columns.perimeter, 7 + sqrtf(17)));
    CHECK(columns.low[0] == 0 && columns.low[1] == 0 && columns.high[0] == 4 && columns.high[1] == 2);
    const tree_outline_repair *repairs;
    size_t n;
    OK(tree_outline_repairs(outline, &repairs, &n));
    CHECK(n == 3 && repairs[0].kind == TREE_OUTLINE_POINTS_DROPPED && repairs[0].count == 1);
    CHECK(repairs[1].kind == TREE_OUTLINE_WIDE_GAP_CLOSED && near(repairs[1].gap, sqrtf(17)));
    CHECK(repairs[2].kind == TREE_OUTLINE_TURNED);
    tree_lines *lines;
    OK(tree_outline_repairs_text(outline, &lines));
    CHECK(one_says(lines, 3, "with the clock"));
    OK(tree_outline_free(outline));

    FAILS(TREE_ERROR_INVALID, "crown: it has 2 different",
          tree_outline_close(drawn, 2, "crown", TREE_NUL_TERMINATED, NULL, NULL, &bad));
    CHECK(bad == NULL);
    FAILS(TREE_ERROR_INVALID, "stroke: ", tree_outline_close(drawn, 1, NULL, 0, NULL, NULL, &bad));
    FAILS(TREE_ERROR_PARAMETER, "outline.corners",
          tree_outline_close(drawn, 7, NULL, 0, &params, NULL, &bad));
    static const float crossed[] = {0, 0, 4, 2, 4, 0, 0, 2};
    FAILS(TREE_ERROR_INVALID, "crosses", tree_outline_from_points(crossed, 4, NULL, &bad));
    FAILS(TREE_ERROR_INVALID, "points[2]", tree_outline_from_points(drawn, 7, NULL, &bad));

    tree_outline *whole = a_box(), *even, *turned;
    OK(tree_outline_repairs(whole, &repairs, &n));
    CHECK(n == 0 && repairs == NULL);
    OK(tree_outline_resampled(whole, 12, NULL, &even));
    columns = columns_of(even);
    CHECK(columns.n_points == 12 && near(columns.area, 8) && columns.points[2] == 1);
    /* Mirrored and moved up by 3. */
    static const float map[] = {-1, 0, 0, 1, 0, 3}, flat[] = {1, 0, 0, 0, 0, 0};
    OK(tree_outline_transformed(whole, map, &turned));
    columns = columns_of(turned);
    CHECK(columns.low[0] == -4 && columns.high[0] == 0 && columns.low[1] == 3 && near(columns.area, 8));
    FAILS(TREE_ERROR_NO_RESULT, "encloses", tree_outline_transformed(whole, flat, &bad));
    OK(tree_outline_free(turned));
    OK(tree_outline_free(even));
    OK(tree_outline_free(whole));
}

static void measures(void) {
    tree_outline *outline = a_box(), *other;
    static const float spots[] = {1, 1, 5, 1};
    uint8_t inside[2] = {7, 7};
    OK(tree_outline_contains(outline, spots, 2, NULL, inside, 2));
    CHECK(inside[0] == 1 && inside[1] == 0);
    FAILS(TREE_ERROR_BUFFER, "inside has room for 1", tree_outline_contains(outline, spots, 2, NULL, inside, 1));

    static const float rays[] = {1, 1, 1, 0, 5, 1, -1, 0, 5, 1, 1, 0};
    float exits[3];
    OK(tree_outline_exits(outline, rays, 3, NULL, exits, 3));
    CHECK(near(exits[0], 3) && near(exits[1], 1) && isinf(exits[2]));

    float lengths[2], distances[2];
    static const float off[] = {5, 1, 1, 0.5f};
    OK(tree_outline_nearest(outline, off, 2, NULL, lengths, distances, 2));
    CHECK(near(lengths[0], 5) && near(distances[0], 1) && near(lengths[1], 1) && near(distances[1], 0.5f));
    OK(tree_outline_nearest(outline, off, 2, NULL, NULL, distances, 2));

    static const float at[] = {5, -1};
    float points[4], tangents[4];
    OK(tree_outline_along(outline, at, 2, NULL, points, tangents, 4));
    CHECK(near(points[0], 4) && near(points[1], 1) && near(points[2], 0) && near(points[3], 1));
    CHECK(near(tangents[0], 0) && near(tangents[1], 1) && near(tangents[3], -1));
    OK(tree_outline_along(outline, at, 2, NULL, NULL, tangents, 4));

    float part[12];
    size_t n;
    OK(tree_outline_part(outline, 3, 7, part, 12, &n));
    CHECK(n == 4 && part[0] == 3 && part[2] == 4 && part[5] == 2 && near(part[6], 3));
    FAILS(TREE_ERROR_BUFFER, "8 are needed", tree_outline_part(outline, 3, 7, part, 7, &n));

    static const float aside[] = {2, 0, 6, 0, 6, 2, 2, 2};
    OK(tree_outline_from_points(aside, 4, NULL, &other));
    float area, iou;
    OK(tree_outline_overlap(outline, other, &area, &iou));
    CHECK(fabsf(area - 4) < 0.04f && fabsf(iou - 1.0f / 3) < 0.01f);

    static const float low[] = {-1, -1}, high[] = {5, 3};
    uint8_t cells[6];
    OK(tree_outline_mask(outline, low, high, 3, 2, NULL, cells, 6));
    /* Centres at x 0, 2, 4 and y 0, 2: on the sides counts once. */
    CHECK(cells[1] + cells[4] == 1);
    OK(tree_outline_mask(outline, low, high, 6, 1, NULL, cells, 6));
    CHECK(!cells[0] && cells[1] && cells[2] && cells[3] && cells[4] && !cells[5]);
    FAILS(TREE_ERROR_PARAMETER, "high", tree_outline_mask(outline, high, low, 3, 2, NULL, cells, 6));
    FAILS(TREE_ERROR_LIMIT, "pixels",
          tree_outline_mask(outline, low, high, UINT32_MAX, UINT32_MAX, NULL, cells, 6));
    OK(tree_outline_free(other));
    OK(tree_outline_free(outline));
}

static void leaves(void) {
    /* A rhombus with a stalk. */
    static const float drawn[] = {-0.1f, 0, 0.1f, 0, 0.1f, 2, 2, 5, 0, 10, -2, 5, -0.1f, 2};
    tree_outline *outline;
    OK(tree_outline_from_points(drawn, 7, NULL, &outline));
    float base[2], tip[2];
    OK(tree_leaf_outline_ends(outline, &base, &tip));
    CHECK(base[1] == 0 && tip[1] == 10);
    tree_leaf_outline *leaf, *guessed, *bad;
    static const float foot[] = {0, 0}, top[] = {0, 10};
    OK(tree_leaf_outline_of(outline, foot, top, &leaf));
    FAILS(TREE_ERROR_INVALID, "leaf: its base", tree_leaf_outline_of(outline, foot, foot, &bad));
    CHECK(bad == NULL);
    OK(tree_leaf_outline_guess(outline, &guessed));
    tree_leaf_outline_columns columns = {.struct_size = sizeof columns};
    OK(tree_leaf_outline_view(guessed, &columns));
    CHECK(columns.n_points == 7);
    OK(tree_leaf_outline_view(leaf, &columns));
    CHECK(columns.n_points == 7 && columns.n_indices == 15 && near(columns.high[1], 1));
    /* The stalk 0.2 by 2, two trapezia above, and a triangle, by a hundredth. */
    CHECK(near(columns.low[0], -0.2f) && near(columns.area, 0.004f + 0.5f * (0.02f + 0.4f) * 0.3f + 0.1f));

    /* It becomes what the oak's leaves are. */
    tree_leaf_model *model;
    OK(tree_leaf_outline_model(leaf, &model));
    tree_leaf_mesh mesh = {.struct_size = sizeof mesh};
    OK(tree_leaf_model_view(model, &mesh));
    CHECK(mesh.n_vertices == 7 && mesh.n_indices == 15 && mesh.normals[2] == 1);
    tree_tree *tree = an_oak_twig();
    tree_look *plain, *look, *none;
    OK(tree_look_of_tree(tree, 1, &plain));
    tree_leaf_look own;
    OK(tree_leaf_look_init(&own, sizeof own));
    own.form = TREE_LEAF_MESH;
    own.mesh = &mesh;
    OK(tree_look_with_leaf(plain, 0, &own, NULL, &look));
    FAILS(TREE_ERROR_INVALID, "kind is 9", tree_look_with_leaf(plain, 9, &own, NULL, &none));
    OK(tree_leaf_model_free(model));
    OK(tree_look_leaf_mesh(look, 0, &mesh));
    CHECK(mesh.n_vertices == 7);
    OK(tree_look_leaf_mesh(plain, 0, &mesh));
    CHECK(mesh.n_vertices == 0);
    tree_mesh *dressed;
    OK(tree_mesh_build(tree, look, NULL, NULL, NULL, &dressed));
    tree_surface surface = {.struct_size = sizeof surface};
    OK(tree_mesh_surface(dressed, 1, &surface));
    CHECK(surface.n_vertices == 3 * 7);
    OK(tree_mesh_free(dressed));
    OK(tree_look_free(look));
    OK(tree_look_free(plain));
    OK(tree_tree_free(tree));
    OK(tree_leaf_outline_free(guessed));
    OK(tree_leaf_outline_free(leaf));
    OK(tree_outline_free(outline));
}

static void drawings(void) {
    static const char svg[] =
        "<svg xmlns='http://www.w3.org/2000/svg'>"
        "<g id='tree-oak'><g id='L0'><path id='stem' d='M50 100 V40' stroke='#000' fill='none'/>"
        "<path id='crown' d='M20 60 L80 60 L50 0 Z' stroke='#000' fill='none'/></g>"
        "<g id='L1@90'><path d='M50 50 L70 55 L70 35 Z' fill='#000'/></g>"
        "<g id='leaf'><path d='M0 0 L5 5 L0 9 Z' fill='#080'/></g></g>"
        "<path d='M0 0 h9 v9 z' fill='#000'/></svg>";
    tree_outline_drawing *drawing, *bad;
    OK(tree_outline_drawing_from_svg(svg, TREE_NUL_TERMINATED, NULL, &drawing));
    size_t n;
    OK(tree_outline_drawing_count(drawing, &n));
    CHECK(n == 1);
    tree_drawn_tree tree = {.struct_size = sizeof tree};
    OK(tree_outline_drawing_tree(drawing, 0, &tree));
    CHECK(tree.n_strokes == 4 && says(tree.name, "tree-oak") && tree.trunk_width == 0);
    tree_drawn_stroke stroke = {.struct_size = sizeof stroke};
    OK(tree_outline_drawing_stroke(drawing, 0, 0, &stroke));
    CHECK(stroke.level == 0 && stroke.kind == TREE_DRAWN_KIND_AXIS && stroke.n_points == 2);
    CHECK(says(stroke.name, "stem") && stroke.points[1] == 100 && stroke.azimuth == 0);
    OK(tree_outline_drawing_stroke(drawing, 0, 1, &stroke));
    CHECK(stroke.kind == TREE_DRAWN_KIND_OUTLINE && stroke.n_points == 3);
    OK(tree_outline_drawing_stroke(drawing, 0, 2, &stroke));
    CHECK(stroke.level == 1 && near(stroke.azimuth, PI / 2));
    OK(tree_outline_drawing_stroke(drawing, 0, 3, &stroke));
    CHECK(stroke.level == TREE_LEVEL_OF_LEAF && stroke.kind == TREE_DRAWN_KIND_OUTLINE);
    FAILS(TREE_ERROR_PARAMETER, "4 strokes", tree_outline_drawing_stroke(drawing, 0, 4, &stroke));
    FAILS(TREE_ERROR_PARAMETER, "1 trees", tree_outline_drawing_tree(drawing, 1, &tree));
    const tree_drawn_repair *repairs;
    OK(tree_outline_drawing_repairs(drawing, &repairs, &n));
    CHECK(n == 1 && repairs[0].kind == TREE_DRAWN_STRAY_SHAPES && repairs[0].count == 1);
    tree_lines *lines;
    OK(tree_outline_drawing_repairs_text(drawing, &lines));
    CHECK(one_says(lines, 1, "1 shapes outside"));
    OK(tree_outline_drawing_free(drawing));
    FAILS(TREE_ERROR_FORMAT, "", tree_outline_drawing_from_svg("<svg/>", 6, NULL, &bad));
    CHECK(bad == NULL);

    static const float trunk[] = {5, 9, 5, 5}, crown[] = {1, 6, 9, 6, 9, 6, 5, 0};
    tree_drawn_stroke own[] = {
        {.struct_size = sizeof *own, .n_points = 2, .points = trunk, .name = {"stem", 4}},
        {.struct_size = sizeof *own, .n_points = 4, .points = crown, .kind = TREE_DRAWN_KIND_OUTLINE}};
    OK(tree_outline_drawing_new(own, 2, "pine", 4, 0.5f, NULL, &drawing));
    OK(tree_outline_drawing_tree(drawing, 0, &tree));
    CHECK(tree.n_strokes == 2 && says(tree.name, "pine") && tree.trunk_width == 0.5f);
    OK(tree_outline_drawing_stroke(drawing, 0, 1, &stroke));
    CHECK(stroke.n_points == 3 && stroke.points[2] == 9);
    OK(tree_outline_drawing_repairs(drawing, &repairs, &n));
    CHECK(n == 0);
    OK(tree_outline_drawing_free(drawing));
    own[1].kind = 5;
    FAILS(TREE_ERROR_ENUM, "strokes[1].kind is 5", tree_outline_drawing_new(own, 2, NULL, 0, 0, NULL, &bad));
    own[0].azimuth = NAN;
    FAILS(TREE_ERROR_INVALID, "strokes[0].azimuth", tree_outline_drawing_new(own, 1, NULL, 0, 0, NULL, &bad));
    FAILS(TREE_ERROR_INVALID, "one stroke", tree_outline_drawing_new(NULL, 0, NULL, 0, 0, NULL, &bad));
    own[0].azimuth = 0;
    FAILS(TREE_ERROR_PARAMETER, "trunk_width", tree_outline_drawing_new(own, 1, NULL, 0, -1, NULL, &bad));
}

/* A black tree on white: a square crown on a trunk. */
static void pictures(void) {
    enum { SIDE = 60 };
    static uint8_t pixels[4 * SIDE * SIDE];
    static float alpha[SIDE * SIDE];
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            int in = (x > 9 && x < 50 && y > 4 && y < 40) || (x > 26 && x < 33 && y < 55 && y > 4);
            uint8_t *pixel = pixels + 4 * (SIDE * y + x);
            pixel[0] = pixel[1] = pixel[2] = in ? 0 : 255;
            pixel[3] = 255;
            alpha[SIDE * y + x] = in ? 1 : 0;
        }
    }
    tree_photo *photo;
    OK(tree_photo_from_pixels(SIDE, SIDE, pixels, sizeof pixels, NULL, &photo));
    tree_matte *matte, *empty;
    OK(tree_photo_mask(photo, NULL, &matte));
    tree_matte_columns columns = {.struct_size = sizeof columns};
    OK(tree_matte_view(matte, &columns));
    CHECK(columns.area == 40 * 35 + 6 * 15);
    tree_outline_drawing *of_photo, *of_matte, *bad;
    OK(tree_outline_drawing_of_photo(photo, NULL, &of_photo));
    OK(tree_outline_drawing_of_matte(matte, 0.5f, NULL, &of_matte));
    tree_drawn_tree tree = {.struct_size = sizeof tree};
    tree_drawn_stroke one = {.struct_size = sizeof one}, other = {.struct_size = sizeof other};
    OK(tree_outline_drawing_tree(of_photo, 0, &tree));
    CHECK(tree.n_strokes == 2);
    for (size_t i = 0; i < 2; i++) {
        OK(tree_outline_drawing_stroke(of_photo, 0, i, &one));
        OK(tree_outline_drawing_stroke(of_matte, 0, i, &other));
        CHECK(one.kind == other.kind && one.n_points == other.n_points);
        CHECK(memcmp(one.points, other.points, 2 * sizeof(float) * one.n_points) == 0);
    }
    FAILS(TREE_ERROR_PARAMETER, "threshold", tree_outline_drawing_of_matte(matte, 2, NULL, &bad));
    memset(alpha, 0, sizeof alpha);
    OK(tree_matte_from_alpha(SIDE, SIDE, alpha, SIDE * SIDE, NULL, &empty));
    FAILS(TREE_ERROR_INVALID, "", tree_outline_drawing_of_matte(empty, 0.5f, NULL, &bad));
    OK(tree_matte_free(empty));
    OK(tree_outline_drawing_free(of_matte));
    OK(tree_outline_drawing_free(of_photo));
    OK(tree_matte_free(matte));
    OK(tree_photo_free(photo));
}

static void lines(void) {
    static const float corner[] = {0, 0, 0, 1, 3, 1}, dot[] = {1, 1, 1, 1};
    float length, points[8], tangents[8], shares[2], distances[2];
    OK(tree_line_length(corner, 3, NULL, &length));
    CHECK(near(length, 4));
    FAILS(TREE_ERROR_INVALID, "line is no line", tree_line_length(dot, 2, NULL, &length));
    static const float places[] = {0.5f, 1};
    OK(tree_line_at(corner, 3, places, 2, NULL, points, tangents, 8));
    CHECK(near(points[0], 1) && near(points[1], 1) && near(points[2], 3) && near(tangents[2], 1));
    static const float spots[] = {2, 5};
    OK(tree_line_nearest(corner, 3, spots, 1, NULL, shares, distances, 2));
    CHECK(near(shares[0], 0.75f) && near(distances[0], 4));
    size_t n;
    OK(tree_line_part(corner, 3, 0.125f, 0.5f, 0, NULL, points, 8, &n));
    CHECK(n == 3 && near(points[1], 0.5f) && near(points[4], 1));
    OK(tree_line_part(corner, 3, 0, 1, 4, NULL, points, 8, &n));
    CHECK(n == 4 && near(points[0], 0) && near(points[6], 3));
    FAILS(TREE_ERROR_PARAMETER, "from is 0.6", tree_line_part(corner, 3, 0.6f, 0.5f, 0, NULL, points, 8, &n));
    FAILS(TREE_ERROR_NO_RESULT, "nothing", tree_line_part(corner, 3, 0.5f, 0.5f, 0, NULL, points, 8, &n));
}

static void bumps(void) {
    tree_bump_params params;
    OK(tree_bump_params_init(&params, sizeof params));
    OK(tree_bump_params_check(&params));
    tree_outline *outline = a_flower(0, 0);
    tree_bumps *bumps, *bad;
    OK(tree_outline_bumps(outline, &params, NULL, &bumps));
    const tree_bump *rows;
    size_t n;
    OK(tree_bumps_view(bumps, &rows, &n));
    CHECK(n == 5);
    float perimeter = columns_of(outline).perimeter;
    for (size_t i = 0; i < n; i++) {
        const tree_bump *bump = &rows[i];
        float far = hypotf(bump->tip[0], bump->tip[1]);
        CHECK(fabsf(far - 1.45f) < 0.05f && bump->radius > 0.05f && bump->radius < 0.6f);
        CHECK((bump->tip[0] * bump->tangent[0] + bump->tip[1] * bump->tangent[1]) / far > 0.9f);
        CHECK(bump->stretch[0] >= 0 && bump->stretch[1] > bump->stretch[0] &&
              bump->stretch[1] < 2 * perimeter);
    }
    OK(tree_bumps_free(bumps));
    params.prominence = 0;
    FAILS(TREE_ERROR_PARAMETER, "bumps.prominence", tree_bump_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "bumps.prominence", tree_outline_bumps(outline, &params, NULL, &bad));
    CHECK(bad == NULL);
    OK(tree_outline_free(outline));
}

static const float trunk[] = {0, 0, 0, 10};

static void branches(void) {
    tree_branching_angles angles;
    OK(tree_branching_angles_init(&angles, sizeof angles));
    CHECK(angles.n_samples == 2);
    static const float places[] = {0, 0.5f, 1};
    float values[3];
    OK(tree_branching_angles_at(&angles, places, 3, NULL, values, 3));
    CHECK(near(values[0], 1.35f) && near(values[1], 0.975f) && near(values[2], 0.6f));
    float samples[8];
    size_t n;
    OK(tree_branching_angles_set(&angles, 0.5f, 0.2f, samples, 8, &n));
    CHECK(n == 3 && samples[2] == 0.5f && near(samples[3], 0.2f));
    angles.samples = samples;
    angles.n_samples = n;
    OK(tree_branching_angles_at(&angles, places, 3, NULL, values, 3));
    CHECK(near(values[1], 0.2f));
    FAILS(TREE_ERROR_PARAMETER, "place is", tree_branching_angles_set(&angles, NAN, 0, samples, 8, &n));
    samples[0] = 2;
    FAILS(TREE_ERROR_PARAMETER, "angles.samples[0][0]",
          tree_branching_angles_at(&angles, places, 3, NULL, values, 3));

    tree_branch_infer_params params;
    OK(tree_branch_infer_params_init(&params, sizeof params));
    OK(tree_branch_infer_params_check(&params));
    CHECK(params.points == 16);
    static const float end[] = {-4, 7}, tangent[] = {-1, 0.5f}, on[] = {0, 0};
    float points[32], share, angle;
    OK(tree_branch_infer(trunk, 2, NULL, NULL, end, tangent, 0, 1, &params, NULL, points, 32, &n, &share));
    CHECK(n == 16 && near(points[0], 0) && near(points[1], 10 * share) && share > 0.1f && share < 0.7f);
    CHECK(near(points[30], -4) && near(points[31], 7));
    /* Where foliage hangs low, the branch keeps to it. */
    static const float low[] = {-5, 0, 1, 0, 1, 4, -3, 4, -3, 8, -5, 8};
    tree_outline *foliage_of;
    OK(tree_outline_from_points(low, 6, NULL, &foliage_of));
    float below;
    OK(tree_branch_infer(trunk, 2, foliage_of, NULL, end, tangent, 0, 1, &params, NULL, points, 32, &n, &below));
    CHECK(below < share);
    OK(tree_outline_free(foliage_of));
    OK(tree_branch_infer(trunk, 2, NULL, NULL, end, tangent, 0, 1, &params, NULL, points, 32, &n, &share));

    uint32_t is_left;
    float again;
    OK(tree_branch_base(trunk, 2, points, n, NULL, &again, &angle, &is_left));
    CHECK(is_left == 1 && near(again, share) && angle > 0.8f && angle < 1.4f);
    FAILS(TREE_ERROR_NO_RESULT, "end lies on",
          tree_branch_infer(trunk, 2, NULL, NULL, on, on, 0, 0, NULL, NULL, points, 32, &n, &share));
    FAILS(TREE_ERROR_PARAMETER, "from is",
          tree_branch_infer(trunk, 2, NULL, NULL, end, tangent, 0.5f, 2, NULL, NULL, points, 32, &n, &share));
    params.places = 1;
    FAILS(TREE_ERROR_PARAMETER, "infer.places", tree_branch_infer_params_check(&params));

    /* From the right side, twice as large, to the left. */
    static const float bent[] = {0, 5, 1, 5, 2, 6};
    static const float foliage[] = {0, 5, 2, 4, 3, 7, 0.5f, 6.5f};
    tree_outline *outline, *carried;
    OK(tree_outline_from_points(foliage, 4, NULL, &outline));
    tree_branch_span span = {{0, 2}, {-4, 4}, 1};
    tree_branch_shape_report report = {.struct_size = sizeof report};
    OK(tree_branch_carry(bent, 3, 0, outline, &span, NULL, &report, points, 32, &n, &carried));
    CHECK(n == 3 && near(points[2], -2) && near(points[3], 2) && near(points[4], -4) && near(points[5], 4));
    CHECK(near(columns_of(carried).area, 4 * columns_of(outline).area));
    CHECK(report.leaving > 0.2f && report.leaving < 0.5f && report.reach > 1);
    OK(tree_outline_free(carried));
    span.end[0] = span.base[0];
    span.end[1] = span.base[1];
    FAILS(TREE_ERROR_INVALID, "span must",
          tree_branch_carry(bent, 3, 0, outline, &span, NULL, NULL, points, 32, &n, &carried));
    CHECK(carried == NULL);
    OK(tree_outline_free(outline));
}

static void subs(void) {
    tree_sub_params params;
    OK(tree_sub_params_init(&params, sizeof params));
    OK(tree_sub_params_check(&params));
    float angle;
    OK(tree_sub_params_opening(&params, 0, 1, &angle));
    CHECK(near(angle, params.narrow));
    OK(tree_sub_params_opening(NULL, 1, 1, &angle));
    CHECK(near(angle, params.wide));
    tree_outline *parent = a_flower(0, 0), *sub, *bad;
    static const float branch[] = {0, 0, 0.5f, 0, 1, 0};
    tree_sub_report report = {.struct_size = sizeof report};
    OK(tree_outline_sub(parent, branch, 3, 0.3f, NULL, &params, NULL, &report, &sub));
    tree_outline_columns columns = columns_of(sub);
    CHECK(columns.area > 0.1f && columns.area < columns_of(parent).area / 2);
    CHECK(near(columns.high[0], 1.45f) && report.shared[1] > report.shared[0]);
    CHECK(report.curves[0] == 0 && report.curves[12] == 0 && near(report.curves[4], report.join_points[0]));
    CHECK(near(hypotf(report.join_tangents[2], report.join_tangents[3]), 1));
    static const float spot[] = {0.5f, 0};
    uint8_t inside;
    OK(tree_outline_contains(sub, spot, 1, NULL, &inside, 1));
    CHECK(inside);
    OK(tree_outline_free(sub));
    const float stretch[] = {0, 0.2f}, wrong[] = {-1, 2};
    OK(tree_outline_sub(parent, branch, 3, 0.3f, stretch, NULL, NULL, &report, &sub));
    CHECK(report.shared[1] - report.shared[0] < 0.25f);
    OK(tree_outline_free(sub));
    FAILS(TREE_ERROR_PARAMETER, "stretch", tree_outline_sub(parent, branch, 3, 0.3f, wrong, NULL, NULL, NULL, &bad));
    FAILS(TREE_ERROR_PARAMETER, "radius", tree_outline_sub(parent, branch, 3, -1, NULL, NULL, NULL, NULL, &bad));
    params.wide = 4;
    FAILS(TREE_ERROR_PARAMETER, "subs.wide", tree_sub_params_check(&params));
    OK(tree_outline_free(parent));
}

static void arrangements(void) {
    tree_arrangement arrangement;
    OK(tree_arrangement_from_text("2:90", TREE_NUL_TERMINATED, &arrangement));
    CHECK(arrangement.kind == TREE_ARRANGEMENT_CUSTOM && arrangement.per_node == 2 &&
          near(arrangement.angle, PI / 2));
    tree_bytes *bytes;
    const uint8_t *data;
    size_t len, n;
    OK(tree_arrangement_to_text(&arrangement, &bytes));
    OK(tree_bytes_view(bytes, &data, &len));
    CHECK(len == 4 && memcmp(data, "2:90", 4) == 0);
    OK(tree_bytes_free(bytes));
    tree_arrangement_numbers numbers = {.struct_size = sizeof numbers};
    OK(tree_arrangement_from_text("whorl3", 6, &arrangement));
    CHECK(arrangement.kind == TREE_ARRANGEMENT_WHORLED && arrangement.per_node == 3);
    OK(tree_arrangement_measure(&arrangement, &numbers));
    CHECK(numbers.per_node == 3 && near(numbers.turn, PI / 3) && near(numbers.spacing, 2 * PI / 3));
    CHECK(numbers.has_pattern && !numbers.has_fixed);
    OK(tree_arrangement_from_text("horizontal:90", TREE_NUL_TERMINATED, &arrangement));
    OK(tree_arrangement_measure(&arrangement, &numbers));
    CHECK(numbers.has_fixed && near(numbers.fixed, PI / 2));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "decussate", tree_arrangement_from_text("zigzag", 6, &arrangement));
    arrangement = (tree_arrangement){.kind = 99};
    FAILS(TREE_ERROR_ENUM, "arrangement.kind is 99", tree_arrangement_measure(&arrangement, &numbers));
    arrangement = (tree_arrangement){.kind = TREE_ARRANGEMENT_CUSTOM, .per_node = 65};
    FAILS(TREE_ERROR_PARAMETER, "arrangement.per_node", tree_arrangement_measure(&arrangement, &numbers));

    enum { MANY = 40 };
    tree_domain domains[MANY];
    uint32_t inside;
    float angle;
    for (int i = 0; i < MANY; i++) {
        domains[i] = (tree_domain){{0, 1}, {0, 2 * PI}};
        if (i % 4 == 0) OK(tree_domain_drawn((float)i / MANY, 1, &domains[i]));
    }
    OK(tree_domain_contains(&domains[4], 0.1f, PI, &inside));
    CHECK(inside == 1);
    OK(tree_domain_contains(&domains[4], 0.1f, 0, &inside));
    CHECK(inside == 0);
    OK(tree_domain_outside(&domains[4], 0, &angle));
    CHECK(near(angle, 0.75f * PI));
    FAILS(TREE_ERROR_PARAMETER, "along is 2", tree_domain_drawn(2, 0, &domains[0]));

    tree_gibbs_params params;
    OK(tree_gibbs_params_init(&params, sizeof params));
    OK(tree_gibbs_params_check(&params));
    OK(tree_arrangement_from_text("decussate", 9, &arrangement));
    tree_arranged_report report = {.struct_size = sizeof report};
    tree_arranged *arranged, *bad;
    OK(tree_arranged_new(domains, MANY, &arrangement, &params, 7, NULL, &report, &arranged));
    const tree_site *sites;
    const float *costs;
    OK(tree_arranged_sites(arranged, &sites, &n));
    CHECK(n == MANY);
    for (int i = 0; i < MANY; i++) {
        OK(tree_domain_contains(&domains[i], sites[i].along, sites[i].azimuth, &inside));
        CHECK(inside);
    }
    OK(tree_arranged_trace(arranged, &costs, &n));
    CHECK(n == report.accepted + 1 && report.moves <= 3000 && near(costs[n - 1], report.cost));
    for (size_t i = 1; i < n; i++) CHECK(costs[i] <= costs[i - 1]);
    tree_concentration found = {.struct_size = sizeof found};
    OK(tree_arranged_sites(arranged, &sites, &n));
    OK(tree_sites_privileged(sites, n, &arrangement, NULL, &found));
    CHECK(found.passes && found.has_pattern && found.pairs == MANY - 1 && found.resultant > 0.5f);
    OK(tree_arranged_free(arranged));
    OK(tree_arranged_ready(12, &arrangement, 3, 1, NULL, &arranged));
    OK(tree_arranged_sites(arranged, &sites, &n));
    CHECK(n == 12 && sites[0].along <= sites[11].along);
    OK(tree_arranged_free(arranged));
    FAILS(TREE_ERROR_PARAMETER, "n is", tree_arranged_ready(20001, &arrangement, 3, 1, NULL, &bad));
    domains[3].along[0] = 2;
    FAILS(TREE_ERROR_PARAMETER, "domains[3].along[0]",
          tree_arranged_new(domains, MANY, &arrangement, NULL, 7, NULL, NULL, &bad));
    CHECK(bad == NULL);
    params.scatter = 1;
    FAILS(TREE_ERROR_PARAMETER, "gibbs.scatter", tree_gibbs_params_check(&params));
}

static void surfaces(void) {
    /* 4 m wide from the front, 2 m from the side, and 3 m high. */
    static const float wide[] = {-2, 0, 2, 0, 2, 3, -2, 3}, slim[] = {-1, 0, 1, 0, 1, 3, -1, 3},
                       axis[] = {0, 0, 0, 3}, azimuths[] = {0, PI / 2};
    tree_outline *front, *side, *profile;
    OK(tree_outline_from_points(wide, 4, NULL, &front));
    OK(tree_outline_from_points(slim, 4, NULL, &side));
    const tree_outline *both[] = {front, side};
    tree_revolved *revolved, *bad;
    OK(tree_revolved_of(axis, 2, both, azimuths, 2, NULL, &revolved));
    tree_revolved_frame frame = {.struct_size = sizeof frame};
    OK(tree_revolved_view(revolved, &frame));
    CHECK(frame.origin[0] == 0 && near(frame.up[1], 1));
    static const float spots[] = {1, 2};
    float places[2], half[1024];
    OK(tree_revolved_to_frame(revolved, spots, 1, NULL, places, 2));
    CHECK(near(places[0], 1) && near(places[1], 2));
    size_t n;
    OK(tree_revolved_half(revolved, 0, half, 1024, &n));
    CHECK(n > 20 && near(half[1], 3) && near(half[2 * n - 1], 0));
    FAILS(TREE_ERROR_BUFFER, "room", tree_revolved_half(revolved, 0, half, 1, &n));
    OK(tree_revolved_profile(revolved, PI / 2, &profile));
    tree_outline_columns columns = columns_of(profile);
    CHECK(fabsf(columns.area - 6) < 0.1f && fabsf(columns.high[0] - 1) < 0.01f);
    OK(tree_outline_free(profile));
    static const float rays[] = {0.1f, 1.5f, 1, 0, 0.1f, 1.5f, 1, 0, 9, 1.5f, 1, 0},
                       at[] = {0, PI / 2, 0};
    float exits[3];
    OK(tree_revolved_exits(revolved, rays, at, 3, NULL, exits, 3));
    CHECK(near(exits[0], 1.9f) && near(exits[1], 0.9f) && isinf(exits[2]));
    static const float points[] = {1.5f, 1, 0, 0, 1, 1.5f};
    uint8_t inside[2];
    OK(tree_revolved_contains(revolved, points, 2, NULL, inside, 2));
    CHECK(inside[0] == 1 && inside[1] == 0);
    FAILS(TREE_ERROR_PARAMETER, "n_sections is 0", tree_revolved_of(axis, 2, both, azimuths, 0, NULL, &bad));
    FAILS(TREE_ERROR_PARAMETER, "azimuth is", tree_revolved_profile(revolved, NAN, &profile));
    OK(tree_revolved_free(revolved));
    both[1] = NULL;
    FAILS(TREE_ERROR_NULL, "outlines[1]", tree_revolved_of(axis, 2, both, azimuths, 2, NULL, &bad));
    CHECK(bad == NULL);
    OK(tree_outline_free(side));
    OK(tree_outline_free(front));
}

void test_silhouette_in(void) {
    outlines();
    measures();
    leaves();
    drawings();
    pictures();
    lines();
    bumps();
    branches();
    subs();
    arrangements();
    surfaces();
}
