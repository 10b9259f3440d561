/* What goes into a sketch: drawings, plans, crowns and templates. */
#include "check.h"
#include <math.h>

static int near(float a, float b) { return fabsf(a - b) < 1e-3f; }

static int says(tree_str text, const char *expected) {
    return text.len == strlen(expected) && memcmp(text.data, expected, text.len) == 0;
}

/* Whether one of the lines has `part` in it. */
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

enum { ROUND = 40 };

/* A trunk drawn from its top, a branch, one that ends shortly before it, and a crown with a gap at its foot. */
static tree_drawing *a_drawing(void) {
    static const float trunk[] = {50, 20, 50, 60, 50, 100}, left[] = {20, 40, 50, 70},
                       right[] = {52, 60, 80, 35};
    static float round[2 * ROUND];
    for (int i = 0; i < ROUND; i++) {
        float angle = 1.7f + 6.1f * (float)i / (ROUND - 1);
        round[2 * i] = 50 + 40 * cosf(angle);
        round[2 * i + 1] = 40 + 40 * sinf(angle);
    }
    tree_sketch_stroke strokes[] = {
        {.struct_size = sizeof *strokes, .n_points = 3, .points = trunk, .role = TREE_ROLE_TRUNK,
         .name = {"stem", 4}},
        {.struct_size = sizeof *strokes, .n_points = 2, .points = left},
        {.struct_size = sizeof *strokes, .n_points = 2, .points = right, .role = TREE_ROLE_BRANCH},
        {.struct_size = sizeof *strokes, .n_points = ROUND, .points = round, .role = TREE_ROLE_CROWN}};
    tree_drawing *drawing;
    OK(tree_drawing_new(strokes, 4, NULL, &drawing));
    return drawing;
}

static tree_drawing *from_json(const char *text) {
    tree_drawing *drawing;
    OK(tree_drawing_from_json(text, TREE_NUL_TERMINATED, NULL, &drawing));
    return drawing;
}

static void strokes(void) {
    tree_drawing *drawing = a_drawing(), *more, *bad;
    tree_sketch_stroke stroke = {.struct_size = sizeof stroke};
    size_t n;
    OK(tree_drawing_count(drawing, &n));
    CHECK(n == 4);
    OK(tree_drawing_stroke(drawing, 1, &stroke));
    CHECK(stroke.n_points == 2 && stroke.points[1] == 40 && stroke.points[3] == 70);
    CHECK(stroke.name.len == 0 && stroke.role == TREE_ROLE_UNKNOWN && !stroke.closed);
    OK(tree_drawing_stroke(drawing, 0, &stroke));
    CHECK(stroke.role == TREE_ROLE_TRUNK && says(stroke.name, "stem"));
    FAILS(TREE_ERROR_PARAMETER, "there are 4 strokes", tree_drawing_stroke(drawing, 4, &stroke));

    static const float dot[] = {1, 2, NAN, 3};
    tree_sketch_stroke added[2] = {{.struct_size = sizeof *added},
                                   {.struct_size = sizeof *added, .n_points = 2, .points = dot,
                                    .closed = 1, .filled = 7, .name = {"dot", 3}}};
    OK(tree_drawing_with_strokes(drawing, added, 2, NULL, &more));
    OK(tree_drawing_count(more, &n));
    CHECK(n == 6);
    OK(tree_drawing_count(drawing, &n));
    CHECK(n == 4);
    OK(tree_drawing_stroke(more, 5, &stroke));
    CHECK(stroke.closed == 1 && stroke.filled == 1 && isnan(stroke.points[2]));
    tree_bytes *bytes;
    FAILS(TREE_ERROR_INVALID, "strokes[5] 'dot': points[1]", tree_drawing_to_json(more, &bytes));
    OK(tree_drawing_free(more));

    added[1].role = 9;
    FAILS(TREE_ERROR_ENUM, "strokes[1].role is 9", tree_drawing_new(added, 2, NULL, &bad));
    CHECK(bad == NULL);
    added[0].n_points = 1;
    FAILS(TREE_ERROR_NULL, "strokes[0].points", tree_drawing_new(added, 1, NULL, &bad));
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.nodes = 1;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "2", tree_drawing_new(added + 1, 1, &control, &bad));
    OK(tree_drawing_free(drawing));
}

static void documents(void) {
    tree_drawing *drawing = a_drawing(), *again, *bad;
    tree_bytes *bytes;
    const uint8_t *data;
    size_t len, n;
    OK(tree_drawing_to_json(drawing, &bytes));
    OK(tree_bytes_view(bytes, &data, &len));
    OK(tree_drawing_from_json((const char *)data, len, NULL, &again));
    tree_sketch_stroke one = {.struct_size = sizeof one}, other = {.struct_size = sizeof other};
    for (size_t i = 0; i < 4; i++) {
        OK(tree_drawing_stroke(drawing, i, &one));
        OK(tree_drawing_stroke(again, i, &other));
        CHECK(one.n_points == other.n_points && one.role == other.role);
        CHECK(memcmp(one.points, other.points, 2 * sizeof(float) * one.n_points) == 0);
    }
    OK(tree_bytes_free(bytes));
    OK(tree_drawing_free(again));
    OK(tree_drawing_free(drawing));

    FAILS(TREE_ERROR_FORMAT, "strokes[1]: points[1]",
          tree_drawing_from_json("[[[0,0]],[[0,0],[1,2,3]]]", TREE_NUL_TERMINATED, NULL, &bad));
    CHECK(bad == NULL);
    FAILS(TREE_ERROR_FORMAT, "no JSON", tree_drawing_from_json("{", 1, NULL, &bad));
    FAILS(TREE_ERROR_TEXT, "json", tree_drawing_from_json("[\xff]", 3, NULL, &bad));

    tree_drawings *drawings;
    static const char lines[] = "[[[0,9],[0,0]]]\n\n{\"drawing\": [[[1, 3], [2, 4]], [[0], [5]]]}\n";
    OK(tree_drawings_from_ndjson(lines, sizeof lines - 1, NULL, &drawings));
    OK(tree_drawings_count(drawings, &n));
    CHECK(n == 2);
    OK(tree_drawings_at(drawings, 1, &drawing));
    FAILS(TREE_ERROR_PARAMETER, "2 drawings", tree_drawings_at(drawings, 2, &bad));
    OK(tree_drawings_free(drawings));
    OK(tree_drawing_count(drawing, &n));
    OK(tree_drawing_stroke(drawing, 0, &one));
    CHECK(n == 2 && one.points[0] == 1 && one.points[1] == 2 && one.points[3] == 4);
    OK(tree_drawing_free(drawing));
    FAILS(TREE_ERROR_FORMAT, "line 2, strokes[0]",
          tree_drawings_from_ndjson("[]\n[7]", TREE_NUL_TERMINATED, NULL, &drawings));

    static const char svg[] = "<svg xmlns='http://www.w3.org/2000/svg'>"
                              "<path id='trunk-1' d='M50 100 V20' stroke='#000'/>"
                              "<circle cx='50' cy='40' r='30' stroke='#0a0' fill='none'/></svg>";
    OK(tree_drawing_from_svg(svg, sizeof svg - 1, NULL, &drawing));
    OK(tree_drawing_count(drawing, &n));
    OK(tree_drawing_stroke(drawing, 0, &one));
    CHECK(n == 2 && one.role == TREE_ROLE_TRUNK && says(one.name, "trunk-1"));
    CHECK(one.points[0] == 50 && one.points[1] == 100);
    OK(tree_drawing_stroke(drawing, 1, &one));
    CHECK(one.role == TREE_ROLE_CROWN && one.closed && !one.filled && one.n_points > 8);
    OK(tree_drawing_free(drawing));
    FAILS(TREE_ERROR_FORMAT, "", tree_drawing_from_svg("<svg", 4, NULL, &bad));
}

/* The first repair of this kind of this stroke. */
static const tree_clean_repair *repair(const tree_plan *plan, uint32_t stroke, uint32_t kind) {
    const tree_clean_repair *repairs;
    size_t n;
    OK(tree_plan_repairs(plan, &repairs, &n));
    for (size_t i = 0; i < n; i++)
        if (repairs[i].stroke == stroke && repairs[i].kind == kind) return &repairs[i];
    return NULL;
}

static void cleaning(void) {
    tree_drawing *drawing = a_drawing(), *far;
    tree_clean_params params;
    OK(tree_clean_params_init(&params, sizeof params));
    CHECK(params.height == 10 && params.guess == 1 && !params.has_root);
    OK(tree_clean_params_check(&params));
    tree_plan *plan, *bad;
    OK(tree_drawing_clean(drawing, &params, NULL, &plan));
    tree_plan_columns view = {.struct_size = sizeof view};
    OK(tree_plan_view(plan, &view));
    CHECK(near(view.base[0], 50) && near(view.base[1], 100) && near(view.scale, 0.1f));
    CHECK(view.n_nodes > 60 && view.positions[0] == 0 && view.positions[1] == 0);
    CHECK(view.parents[0] == TREE_NO_PARENT && view.strokes[0] == 0);
    int n_forks = 0, seen[4] = {0};
    for (size_t i = 1; i < view.n_nodes; i++) {
        CHECK(view.parents[i] < i && view.strokes[i] < 3);
        seen[view.strokes[i]] = 1;
        n_forks += view.parents[i] != i - 1;
    }
    CHECK(seen[0] && seen[1] && seen[2] && n_forks == 2);

    CHECK(repair(plan, 0, TREE_REPAIR_TURNED_ROUND));
    const tree_clean_repair *gap = repair(plan, 2, TREE_REPAIR_SNAPPED);
    CHECK(gap && gap->share > 0.01f && gap->share < 0.03f);
    CHECK(!repair(plan, 0, TREE_REPAIR_EMPTY));
    const tree_clean_repair *repairs;
    size_t n_repairs, n;
    OK(tree_plan_repairs(plan, &repairs, &n_repairs));
    tree_lines *lines;
    OK(tree_plan_repairs_text(plan, &lines));
    CHECK(one_says(lines, n_repairs, "strokes[0] 'stem' was drawn towards the base"));

    tree_strokes_columns crown = {.struct_size = sizeof crown};
    OK(tree_plan_crown(plan, &crown));
    CHECK(crown.n_strokes == 1 && crown.starts[1] == crown.n_points);
    const uint32_t *numbers;
    OK(tree_plan_crown_strokes(plan, &numbers, &n));
    CHECK(n == 1 && numbers[0] == 3);

    static const float spots[] = {0, 0, 1, 2};
    float drawn[4], back[4];
    OK(tree_plan_points_to_drawing(plan, spots, 2, NULL, drawn, 4));
    CHECK(near(drawn[0], 50) && fabsf(drawn[2] - 60) < 0.1f && fabsf(drawn[3] - 80) < 0.1f);
    OK(tree_plan_points_from_drawing(plan, drawn, 2, NULL, back, 4));
    for (int i = 0; i < 4; i++) CHECK(near(back[i], spots[i]));
    FAILS(TREE_ERROR_BUFFER, "drawn",
          tree_plan_points_to_drawing(plan, spots, 2, NULL, drawn, 3));

    tree_plan *twice, *bare;
    tree_plan_columns large = {.struct_size = sizeof large};
    OK(tree_plan_scaled(plan, 2, &twice));
    OK(tree_plan_view(twice, &large));
    CHECK(near(large.scale, 0.2f) && large.positions[9] == 2 * view.positions[9]);
    FAILS(TREE_ERROR_INVALID, "not finite", tree_plan_scaled(plan, NAN, &bad));
    OK(tree_plan_from_columns(&view, NULL, &bare));
    OK(tree_plan_view(bare, &large));
    CHECK(large.n_nodes == view.n_nodes);
    OK(tree_plan_repairs(bare, &repairs, &n));
    CHECK(n == 0 && repairs == NULL);
    large.base[0] = INFINITY;
    FAILS(TREE_ERROR_INVALID, "base", tree_plan_from_columns(&large, NULL, &bad));
    OK(tree_plan_free(bare));
    OK(tree_plan_free(twice));
    OK(tree_plan_free(plan));

    static const float there[] = {-60, 90, -70, 20};
    tree_sketch_stroke stroke = {.struct_size = sizeof stroke, .n_points = 2, .points = there,
                                 .role = TREE_ROLE_BRANCH, .name = {"far", 3}};
    OK(tree_drawing_with_strokes(drawing, &stroke, 1, NULL, &far));
    params.isolated = TREE_ISOLATED_REFUSE;
    FAILS(TREE_ERROR_INVALID, "strokes[4] 'far'", tree_drawing_clean(far, &params, NULL, &bad));
    CHECK(bad == NULL);
    params.isolated = TREE_ISOLATED_DROP;
    OK(tree_drawing_clean(far, &params, NULL, &plan));
    CHECK(repair(plan, 4, TREE_REPAIR_ISOLATED));
    OK(tree_plan_free(plan));
    params.isolated = 3;
    FAILS(TREE_ERROR_ENUM, "clean.isolated", tree_drawing_clean(far, &params, NULL, &bad));
    params.isolated = TREE_ISOLATED_BRIDGE;
    params.has_root = 1;
    params.root[0] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "clean.root", tree_clean_params_check(&params));
    params.root[0] = params.root[1] = 0;
    params.snap = 1;
    FAILS(TREE_ERROR_PARAMETER, "clean.snap", tree_clean_params_check(&params));
    OK(tree_drawing_free(far));
    OK(tree_drawing_free(drawing));

    /* A dot is no tree; points that are none are left out. */
    drawing = from_json("[[[3, 3]]]");
    FAILS(TREE_ERROR_INVALID, "", tree_drawing_clean(drawing, NULL, NULL, &bad));
    OK(tree_drawing_free(drawing));
    static const float hurt[] = {0, 9, NAN, 5, 0, 0};
    stroke = (tree_sketch_stroke){.struct_size = sizeof stroke, .n_points = 3, .points = hurt};
    OK(tree_drawing_new(&stroke, 1, NULL, &drawing));
    OK(tree_drawing_clean(drawing, NULL, NULL, &plan));
    const tree_clean_repair *points = repair(plan, 0, TREE_REPAIR_BAD_POINTS);
    CHECK(points && points->count == 1);
    OK(tree_plan_free(plan));
    OK(tree_drawing_free(drawing));
}

static void crowns(void) {
    tree_drawing *drawing = a_drawing();
    tree_plan *plan;
    OK(tree_drawing_clean(drawing, NULL, NULL, &plan));
    OK(tree_drawing_free(drawing));
    tree_strokes_columns drawn = {.struct_size = sizeof drawn}, view = {.struct_size = sizeof view};
    tree_plan_columns nodes = {.struct_size = sizeof nodes};
    OK(tree_plan_crown(plan, &drawn));
    OK(tree_plan_view(plan, &nodes));
    tree_crown_params params;
    OK(tree_crown_params_init(&params, sizeof params));
    OK(tree_crown_params_check(&params));
    CHECK(params.depth == 1 && params.refuse == 0);
    tree_crown *crown, *bad, *flat;
    OK(tree_crown_close(&drawn, nodes.positions, nodes.n_nodes, &params, NULL, &crown));
    tree_crown_measures measures = {.struct_size = sizeof measures};
    OK(tree_crown_measure(crown, &measures));
    CHECK(measures.area > 49 && measures.area < 51 && measures.volume > 250 && measures.volume < 270);
    CHECK(near(measures.high[1], 10) && fabsf(measures.low[0] + 4) < 0.02f);
    CHECK(measures.outside > 0 && measures.outside < 0.3f);
    OK(tree_crown_polygons(crown, &view));
    CHECK(view.n_strokes == 1 && view.n_points > 20);
    const tree_crown_repair *repairs;
    size_t n;
    OK(tree_crown_repairs(crown, &repairs, &n));
    CHECK(n == 2 && repairs[0].kind == TREE_CROWN_CLOSED && repairs[0].gap > 0.3f);
    CHECK(repairs[1].kind == TREE_CROWN_BRANCHES_OUTSIDE && repairs[1].share == measures.outside);
    tree_lines *lines;
    OK(tree_crown_repairs_text(crown, &lines));
    CHECK(one_says(lines, 2, "stick out of the crown"));

    static const float spots[] = {0, 6, 3.9f, 6, 4.1f, 6, 0, 1, NAN, 6};
    uint8_t inside[5];
    OK(tree_crown_contains(crown, spots, 5, NULL, inside, 5));
    CHECK(inside[0] == 1 && inside[1] == 1 && !inside[2] && !inside[3] && !inside[4]);
    FAILS(TREE_ERROR_BUFFER, "inside", tree_crown_contains(crown, spots, 5, NULL, inside, 4));
    static const float points[] = {0, 6, 0, 0, 6, 2, 0, 6, 5, 0, 20, 0};
    float levels[4];
    OK(tree_crown_levels(crown, points, 4, NULL, levels, 4));
    CHECK(levels[0] < 0.01f && fabsf(levels[1] - 0.5f) < 0.01f && levels[2] > 1 && isinf(levels[3]));
    static const float ways[] = {0, 6, 0, 0, 6, 8, 0, 6, 0, 1, 6, 1, 9, 6, 0, 0, 6, 0};
    float exits[3];
    OK(tree_crown_exits(crown, ways, 3, NULL, exits, 3));
    CHECK(fabsf(exits[0] - 0.5f) < 0.01f && isinf(exits[1]) && exits[2] == 0);

    params.refuse = 1;
    static const float off[] = {30, 3};
    FAILS(TREE_ERROR_INVALID, "no branch touches the crown",
          tree_crown_close(&drawn, off, 1, &params, NULL, &bad));
    CHECK(bad == NULL);
    params.depth = 0;
    FAILS(TREE_ERROR_PARAMETER, "crown.depth", tree_crown_params_check(&params));
    static const float line[] = {0, 0, 1, 1};
    static const uint64_t starts[] = {0, 2};
    tree_strokes_columns open = {sizeof open, 1, starts, 2, line};
    FAILS(TREE_ERROR_INVALID, "enclose no area",
          tree_crown_close(&open, NULL, 0, NULL, NULL, &bad));
    OK(tree_crown_from_polygons(&view, 0.5f, NULL, &flat));
    OK(tree_crown_measure(flat, &measures));
    CHECK(measures.volume > 120 && measures.volume < 140);
    FAILS(TREE_ERROR_PARAMETER, "crown.depth", tree_crown_from_polygons(&view, 99, NULL, &bad));
    OK(tree_crown_free(flat));
    OK(tree_crown_free(crown));
    OK(tree_plan_free(plan));
}

static void shapes(void) {
    static float spots[2 * 400];
    for (int i = 0; i < 400; i++) {
        spots[2 * i] = (float)(i % 20) / 19;
        spots[2 * i + 1] = (float)(i / 20) / 19 * 2;
    }
    tree_sketch_outline_params outline;
    OK(tree_sketch_outline_params_init(&outline, sizeof outline));
    CHECK(outline.corners == 120);
    tree_strokes *outlines, *bad;
    tree_strokes_columns view = {.struct_size = sizeof view};
    OK(tree_strokes_outline(spots, 400, &outline, NULL, &outlines));
    OK(tree_strokes_view(outlines, &view));
    CHECK(view.n_strokes == 1 && view.n_points >= 4 && view.n_points <= 120);
    outline.corners = 3;
    FAILS(TREE_ERROR_PARAMETER, "outline.corners",
          tree_strokes_outline(spots, 400, &outline, NULL, &bad));

    tree_midline_params params;
    OK(tree_midline_params_init(&params, sizeof params));
    CHECK(params.spur == 1 && params.rule == TREE_FILL_NON_ZERO);
    tree_midlines *midlines, *none;
    OK(tree_midlines_of(&view, &params, NULL, &midlines));
    tree_strokes_columns middle = {.struct_size = sizeof middle};
    OK(tree_midlines_view(midlines, &middle));
    const float *half_widths;
    size_t n;
    OK(tree_midlines_half_widths(midlines, &half_widths, &n));
    CHECK(middle.n_strokes == 1 && n == middle.n_points);
    CHECK(fabsf(middle.points[2 * (n / 2)] - 0.5f) < 0.1f && fabsf(half_widths[n / 2] - 0.5f) < 0.1f);
    OK(tree_midlines_free(midlines));
    params.rule = 2;
    FAILS(TREE_ERROR_ENUM, "midline.rule", tree_midlines_of(&view, &params, NULL, &none));
    params.rule = TREE_FILL_EVEN_ODD;
    params.spur = -1;
    FAILS(TREE_ERROR_PARAMETER, "midline.spur", tree_midlines_of(&view, &params, NULL, &none));
    OK(tree_strokes_free(outlines));

    float tall[TREE_FOOTPRINT_DIRECTIONS], wide[TREE_FOOTPRINT_DIRECTIONS], difference;
    OK(tree_footprint_of(spots, 400, NULL, tall, TREE_FOOTPRINT_DIRECTIONS));
    CHECK(near(tall[0], 0.25f) && near(tall[16], 0.5f));
    for (int i = 0; i < TREE_FOOTPRINT_DIRECTIONS; i++) wide[i] = tall[(i + 16) % 64];
    OK(tree_footprint_difference(tall, 64, tall, 64, &difference));
    CHECK(difference == 0);
    OK(tree_footprint_difference(tall, 64, wide, 64, &difference));
    CHECK(difference > 0.1f);
    FAILS(TREE_ERROR_INVALID, "64", tree_footprint_difference(tall, 64, wide, 63, &difference));
    FAILS(TREE_ERROR_NO_RESULT, "hull", tree_footprint_of(spots, 2, NULL, tall, 64));
    FAILS(TREE_ERROR_BUFFER, "distances", tree_footprint_of(spots, 400, NULL, tall, 63));
    float corners[800];
    OK(tree_convex_hull(spots, 400, NULL, corners, 800, &n));
    CHECK(n == 4 && corners[0] == 0 && corners[1] == 0 && corners[2] == 1 && corners[5] == 2);
}

static void texts_of_templates(void) {
    tree_templates *templates, *again, *bad;
    OK(tree_templates_builtin(&templates));
    size_t n, index;
    OK(tree_templates_count(templates, &n));
    CHECK(n == tree_exemplar_count());
    tree_template_view view = {.struct_size = sizeof view};
    for (size_t i = 0; i < n; i++) {
        tree_str name, title, species;
        OK(tree_exemplar_name(i, &name, &title, &species));
        OK(tree_templates_find(templates, name.data, name.len, &index));
        OK(tree_templates_view(templates, index, &view));
        CHECK(view.name.len == name.len && memcmp(view.name.data, name.data, name.len) == 0);
        CHECK(view.species.len == species.len && title.len > 5);
        CHECK(view.height > 1 && view.height < 60 && view.slenderness > 0 && view.slenderness < 0.3f);
        CHECK(view.n_orders >= 1 && view.n_views == 8);
    }
    tree_template_side side = {.struct_size = sizeof side};
    OK(tree_templates_side(templates, 0, 2, &side));
    CHECK(fabsf(side.yaw - 0.785f) < 0.01f && side.n_silhouette > 3 && side.beta[0] > 0.2f);
    float sum = 0;
    for (int i = 0; i < TREE_DIRECTION_BINS; i++) sum += side.directions[i];
    CHECK(fabsf(sum - 1) < 0.01f && side.crown[TREE_FOOTPRINT_DIRECTIONS - 1] > 0 && side.branches[0] > 0);
    FAILS(TREE_ERROR_PARAMETER, "8 views", tree_templates_side(templates, 0, 8, &side));
    FAILS(TREE_ERROR_PARAMETER, "templates", tree_templates_view(templates, n, &view));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "known are oak",
          tree_templates_find(templates, "no tree", TREE_NUL_TERMINATED, &index));
    FAILS(TREE_ERROR_INVALID, "'oak'", tree_templates_join(templates, templates, &bad));

    tree_bytes *text, *text_again;
    const uint8_t *data, *data_again;
    size_t len, len_again;
    OK(tree_templates_to_text(templates, &text));
    OK(tree_bytes_view(text, &data, &len));
    OK(tree_templates_from_text((const char *)data, len, NULL, &again));
    OK(tree_templates_to_text(again, &text_again));
    OK(tree_bytes_view(text_again, &data_again, &len_again));
    CHECK(len == len_again && memcmp(data, data_again, len) == 0);
    FAILS(TREE_ERROR_FORMAT, "line 1",
          tree_templates_from_text("forms 1", TREE_NUL_TERMINATED, NULL, &bad));
    FAILS(TREE_ERROR_FORMAT, "line 3",
          tree_templates_from_text("templates 1\ntemplate a\nheight tall", TREE_NUL_TERMINATED, NULL, &bad));
    CHECK(bad == NULL);
    OK(tree_bytes_free(text_again));
    OK(tree_bytes_free(text));
    OK(tree_templates_free(again));
    OK(tree_templates_free(templates));
}

static void selection(void) {
    tree_tree *tree, *bad;
    OK(tree_exemplar_grow("palm", TREE_NUL_TERMINATED, TREE_EXEMPLAR_SEED, NULL, &tree));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "palm", tree_exemplar_grow("cactus", 6, 1, NULL, &bad));
    tree_main_branch_params main;
    OK(tree_main_branch_params_init(&main, sizeof main));
    CHECK(main.most == 36 && main.continuation == TREE_CONTINUATION_THICKEST);
    OK(tree_main_branch_params_check(&main));
    tree_template_params params;
    OK(tree_template_params_init(&params, sizeof params));
    params.main = &main;
    params.views = 3;
    OK(tree_template_params_check(&params));
    tree_templates *builtin, *own, *all, *none;
    OK(tree_templates_of_tree("mine", 4, "palm", TREE_NUL_TERMINATED, tree, &params, NULL, &own));
    OK(tree_templates_builtin(&builtin));
    OK(tree_templates_join(builtin, own, &all));
    size_t n, palm, mine;
    OK(tree_templates_count(all, &n));
    OK(tree_templates_find(all, "palm", 4, &palm));
    OK(tree_templates_find(all, "mine", 4, &mine));
    CHECK(n == tree_exemplar_count() + 1 && mine == n - 1);
    tree_template_view view = {.struct_size = sizeof view};
    OK(tree_templates_view(all, mine, &view));
    CHECK(view.n_views == 3 && says(view.species, "palm"));
    FAILS(TREE_ERROR_INVALID, "one line",
          tree_templates_of_tree("a\nb", 3, "palm", 4, tree, NULL, NULL, &none));
    params.views = 0;
    FAILS(TREE_ERROR_PARAMETER, "template.views", tree_template_params_check(&params));

    tree_drawing *drawing;
    tree_plan *plan;
    OK(tree_drawing_of_tree(tree, 0.2f, 1, &main, NULL, NULL, &drawing));
    tree_sketch_stroke stroke = {.struct_size = sizeof stroke};
    size_t n_strokes;
    OK(tree_drawing_count(drawing, &n_strokes));
    OK(tree_drawing_stroke(drawing, 0, &stroke));
    CHECK(stroke.role == TREE_ROLE_TRUNK && n_strokes > 5);
    OK(tree_drawing_stroke(drawing, n_strokes - 1, &stroke));
    CHECK(stroke.role == TREE_ROLE_CROWN && stroke.closed);
    OK(tree_drawing_clean(drawing, NULL, NULL, &plan));
    tree_template_select_params weights;
    OK(tree_template_select_params_init(&weights, sizeof weights));
    CHECK(weights.crown == 40);
    OK(tree_template_select_params_check(&weights));
    tree_template_choice choices[64];
    OK(tree_templates_select(all, plan, NULL, &weights, NULL, choices, 64));
    for (int i = 0; i < 2; i++) CHECK(choices[i].index == palm || choices[i].index == mine);
    for (size_t i = 0; i < n; i++) {
        tree_template_choice it = choices[i];
        CHECK(i == 0 || it.score <= choices[i - 1].score);
        CHECK(near(it.score, it.crown + it.branches + it.shape + it.directions));
        CHECK(it.crown < 0 && it.yaw >= 0 && it.yaw < 6.2832f);
    }
    FAILS(TREE_ERROR_BUFFER, "choices",
          tree_templates_select(all, plan, NULL, NULL, NULL, choices, n - 1));

    /* A crown of its own instead of that which was drawn. */
    tree_strokes_columns lines = {.struct_size = sizeof lines};
    OK(tree_plan_crown(plan, &lines));
    tree_crown *crown;
    OK(tree_crown_close(&lines, NULL, 0, NULL, NULL, &crown));
    OK(tree_templates_select(all, plan, crown, NULL, NULL, choices, 64));
    CHECK(choices[0].index == palm || choices[0].index == mine);
    OK(tree_crown_free(crown));
    weights.hand = 0;
    FAILS(TREE_ERROR_PARAMETER, "select.hand",
          tree_templates_select(all, plan, NULL, &weights, NULL, choices, 64));
    OK(tree_templates_from_text("templates 1", 11, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "at least one",
          tree_templates_select(none, plan, NULL, NULL, NULL, choices, 64));
    OK(tree_templates_free(none));
    main.most = 0;
    FAILS(TREE_ERROR_PARAMETER, "main.most", tree_main_branch_params_check(&main));

    OK(tree_plan_free(plan));
    OK(tree_drawing_free(drawing));
    OK(tree_templates_free(all));
    OK(tree_templates_free(own));
    OK(tree_templates_free(builtin));
    OK(tree_tree_free(tree));
}

void test_sketch_in(void) {
    strokes();
    documents();
    cleaning();
    crowns();
    shapes();
    texts_of_templates();
    selection();
}
