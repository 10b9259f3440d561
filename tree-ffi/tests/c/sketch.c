/* From strokes to a tree: inference, propagation, finish, sessions with edits. */
#include "check.h"
#include <math.h>

enum { TRUNK, LEFT, RIGHT, TOP, STROKES };

static const float trunk_points[] = {100, 200, 100, 165, 102, 120, 101, 80, 103, 30};
static const float left_points[] = {101, 140, 85, 125, 65, 112, 45, 90};
static const float right_points[] = {102, 110, 120, 98, 140, 88, 158, 64};
static const float top_points[] = {101, 84, 92, 68, 84, 50, 80, 36};
static const float more_points[] = {102, 70, 112, 58, 124, 50};

static tree_sketch_stroke a_line(const float *points, size_t n, tree_role role) {
    tree_sketch_stroke stroke = {.struct_size = sizeof stroke, .n_points = n, .points = points};
    stroke.role = role;
    return stroke;
}

static tree_drawing *four_strokes(void) {
    tree_sketch_stroke strokes[STROKES];
    strokes[TRUNK] = a_line(trunk_points, 5, TREE_ROLE_TRUNK);
    strokes[LEFT] = a_line(left_points, 4, TREE_ROLE_BRANCH);
    strokes[RIGHT] = a_line(right_points, 4, TREE_ROLE_BRANCH);
    strokes[TOP] = a_line(top_points, 4, TREE_ROLE_BRANCH);
    tree_drawing *drawing = NULL;
    OK(tree_drawing_new(strokes, STROKES, NULL, &drawing));
    return drawing;
}

/* Little work. */
static const tree_sketch_params *small(void) {
    static tree_sketch_params params;
    static tree_sketch_propagate_params propagate;
    static tree_sketch_finish_params finish;
    OK(tree_sketch_params_init(&params, sizeof params));
    OK(tree_sketch_propagate_params_init(&propagate, sizeof propagate));
    OK(tree_sketch_finish_params_init(&finish, sizeof finish));
    CHECK(propagate.generations == 5 && finish.leaves == 1);
    CHECK(finish.species.len == 3 && memcmp(finish.species.data, "oak", 3) == 0);
    propagate.generations = 2;
    finish.fullness = 0.1f;
    params.propagate = &propagate;
    params.finish = &finish;
    params.height = 8;
    OK(tree_sketch_params_check(&params));
    return &params;
}

static tree_sketch_session *a_session(void) {
    tree_drawing *drawing = four_strokes();
    tree_sketch_session *session = NULL;
    OK(tree_sketch_session_new(drawing, small(), 5, &session));
    OK(tree_drawing_free(drawing));
    return session;
}

/* A number for all positions of a tree. */
static double sum_of(const tree_tree *tree) {
    tree_skeleton *skeleton = NULL;
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_view(skeleton, &columns));
    double sum = 0;
    for (size_t i = 0; i < 3 * columns.n_nodes; i++) sum += columns.positions[i] * (double)(i % 7 + 1);
    OK(tree_skeleton_free(skeleton));
    return sum;
}

static void test_in_one_call(void) {
    tree_drawing *drawing = four_strokes();
    tree_tree *tree = NULL;
    tree_sketch_report report = {.struct_size = sizeof report};
    OK(tree_from_sketch(drawing, NULL, NULL, small(), 5, NULL, &report, &tree));
    /* Three forks: four pieces of trunk, three branches. */
    CHECK(report.n_segments == 7 && report.has_score == 1 && report.score < 0);
    CHECK(report.grown_new > 20 && report.grown_generations == 2 && report.finish_leaves > 10);
    CHECK(report.has_crown == 0 && isfinite(report.posterior) && report.n_interpenetrations == 0);
    tree_foliage foliage = {.struct_size = sizeof foliage};
    OK(tree_tree_foliage(tree, &foliage));
    CHECK(foliage.n_leaves == report.finish_leaves);

    /* The same through a session, on one thread. */
    tree_pool_options one = {.struct_size = sizeof one, .n_threads = 1};
    tree_pool *pool = NULL;
    tree_control control;
    OK(tree_pool_new(&one, &pool));
    OK(tree_control_init(&control, sizeof control));
    control.pool = pool;
    tree_sketch_session *session = NULL;
    tree_tree *same = NULL;
    OK(tree_sketch_session_new(drawing, small(), 5, &session));
    OK(tree_sketch_session_tree(session, &control, &report, &same));
    CHECK(sum_of(same) == sum_of(tree));
    OK(tree_tree_free(same));
    OK(tree_sketch_session_set_seed(session, 6));
    uint64_t seed = 0;
    OK(tree_sketch_session_seed(session, &seed));
    OK(tree_sketch_session_tree(session, &control, NULL, &same));
    CHECK(seed == 6 && sum_of(same) != sum_of(tree));
    OK(tree_tree_free(same));
    OK(tree_sketch_session_free(session));
    OK(tree_pool_free(pool));
    OK(tree_tree_free(tree));

    /* With templates of one's own and a name. */
    tree_templates *templates = NULL;
    tree_sketch_params params = *small();
    OK(tree_templates_builtin(&templates));
    tree_sketch_omega omega = {.struct_size = sizeof omega};
    OK(tree_templates_omega(templates, 0, &omega));
    OK(tree_sketch_omega_check(&omega));
    FAILS(TREE_ERROR_PARAMETER, "index is 1000", tree_templates_omega(templates, 1000, &omega));
    params.template_name = (tree_str){"no such tree", TREE_NUL_TERMINATED};
    FAILS(TREE_ERROR_UNKNOWN_NAME, "no such tree",
          tree_from_sketch(drawing, templates, NULL, &params, 5, NULL, NULL, &tree));
    CHECK(tree == NULL);
    params.template_name.data = NULL;
    params.template_name.len = 0;
    params.species = (tree_str){"birch", 5};
    OK(tree_from_sketch(drawing, templates, NULL, &params, 5, NULL, NULL, &tree));
    tree_species species = {.struct_size = sizeof species};
    OK(tree_tree_species(tree, &species));
    CHECK(species.name.len == 5 && memcmp(species.name.data, "birch", 5) == 0);
    OK(tree_tree_free(tree));
    OK(tree_templates_free(templates));
    OK(tree_drawing_free(drawing));
}

static void test_omega(void) {
    tree_sketch_omega omega, whole = {.struct_size = sizeof whole};
    OK(tree_sketch_omega_init(&omega, sizeof omega));
    CHECK(omega.n_orders == 1 && omega.orders[0].gamma.mean > 2);
    OK(tree_sketch_omega_check(&omega));
    omega.n_orders = 2;
    omega.orders[1] = omega.orders[0];
    omega.orders[1].beta.mean = 0.25f;
    omega.orders[0].beta.mean = 0.75f;
    OK(tree_sketch_omega_without_orders(&omega, &whole));
    CHECK(whole.n_orders == 1 && whole.orders[0].beta.mean == 0.5f);
    omega.orders[1].alpha.deviation = 0;
    FAILS(TREE_ERROR_PARAMETER, "omega.orders[1].alpha.deviation", tree_sketch_omega_check(&omega));
    omega.n_orders = TREE_SKETCH_ORDERS + 1;
    FAILS(TREE_ERROR_PARAMETER, "n_orders", tree_sketch_omega_check(&omega));
}

/* A flat fork: a trunk of 3 m, one branch that goes on, and one lateral. */
static tree_sketch_branches *a_flat_fork(void) {
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 0}, starts[] = {0, 2, 4, 6};
    static const tree_sketch_label labels[] = {TREE_SKETCH_APICAL, TREE_SKETCH_APICAL, 0};
    static const float points[] = {0, 0, 0, 0, 3, 0, 0, 3, 0, 0.3f, 5, 0, 0, 3, 0, -1.2f, 4.5f, 0};
    tree_sketch_branches_columns columns = {.struct_size = sizeof columns};
    columns.n_segments = 3;
    columns.n_points = 6;
    columns.parents = parents;
    columns.labels = labels;
    columns.starts = starts;
    columns.points = points;
    tree_sketch_branches *branches = NULL;
    OK(tree_sketch_branches_from_columns(&columns, NULL, &branches));
    static const tree_sketch_label wrong[] = {TREE_SKETCH_APICAL, 70000, 0};
    tree_sketch_branches *none = NULL;
    columns.labels = wrong;
    FAILS(TREE_ERROR_ENUM, "labels[1] is 70000",
          tree_sketch_branches_from_columns(&columns, NULL, &none));
    columns.labels = labels;
    columns.n_points = 5;
    FAILS(TREE_ERROR_INVALID, "5 points", tree_sketch_branches_from_columns(&columns, NULL, &none));
    CHECK(none == NULL);
    return branches;
}

static void test_branches(void) {
    tree_sketch_branches *branches = a_flat_fork();
    uint32_t orders[3];
    OK(tree_sketch_branches_orders(branches, orders, 3));
    CHECK(orders[0] == 0 && orders[1] == 0 && orders[2] == 1);
    FAILS(TREE_ERROR_BUFFER, "3 are needed", tree_sketch_branches_orders(branches, orders, 2));

    tree_sketch_relation relations[2];
    size_t n_relations = 0;
    OK(tree_sketch_branches_relations(branches, NULL, 0, &n_relations));
    CHECK(n_relations == 2);
    OK(tree_sketch_branches_relations(branches, relations, 2, &n_relations));
    CHECK(relations[0].segment == 1 && relations[0].label == TREE_SKETCH_APICAL);
    CHECK(relations[1].label == 0 && relations[1].order == 0 && !relations[1].has_roll);
    /* The lateral leans by atan(1.2 / 1.5). */
    CHECK(fabs(relations[1].divergence - 0.6747) < 1e-3);
    tree_sketch_omega fitted = {.struct_size = sizeof fitted}, of = {.struct_size = sizeof of};
    OK(tree_sketch_omega_fit(branches, &fitted));
    OK(tree_sketch_omega_of_relations(relations, 2, NULL, &of));
    CHECK(memcmp(&fitted, &of, sizeof of) == 0 && fabsf(of.orders[0].beta.mean - 0.6747f) < 1e-3f);
    relations[1].scale = NAN;
    FAILS(TREE_ERROR_PARAMETER, "relations[1].scale",
          tree_sketch_omega_of_relations(relations, 2, NULL, &of));

    /* Nothing grows into a wall close behind it. */
    static const float low[] = {-20, -1, -20}, high[] = {20, 20, -0.4f};
    tree_volume *wall = NULL;
    tree_sketch_branches *grown = NULL, *free_grown = NULL;
    tree_sketch_propagate_report report = {.struct_size = sizeof report}, open = report;
    OK(tree_volume_box(low, high, &wall));
    OK(tree_sketch_branches_propagate(branches, &fitted, NULL, NULL, NULL, 3, NULL, &open,
                                      &free_grown));
    OK(tree_sketch_branches_propagate(branches, &fitted, NULL, wall, NULL, 3, NULL, &report, &grown));
    tree_sketch_branches_columns columns = {.struct_size = sizeof columns};
    for (int with_wall = 0; with_wall < 2; with_wall++) {
        OK(tree_sketch_branches_view(with_wall ? grown : free_grown, &columns));
        CHECK(columns.n_sketched == 3 && columns.generations[2] == 0 && columns.generations[3] == 1);
        CHECK(columns.n_segments == 3 + (with_wall ? report.n_new : open.n_new));
        size_t n_inside = 0;
        uint8_t *inside = malloc(columns.n_points);
        OK(tree_volume_contains(wall, columns.points, columns.n_points, NULL, inside));
        for (size_t i = 0; i < columns.n_points; i++) n_inside += inside[i];
        CHECK(with_wall ? n_inside == 0 : n_inside > 0);
        free(inside);
    }
    CHECK(report.n_blocked + report.n_turned_aside + report.n_shortened > open.n_turned_aside);
    tree_sketch_branches *again = NULL;
    FAILS(TREE_ERROR_INVALID, "before propagation",
          tree_sketch_branches_propagate(grown, NULL, NULL, NULL, NULL, 3, NULL, NULL, &again));

    /* A crown keeps growth in; wood, twigs and leaves of what grew. */
    static const float outline[] = {-2, 2, 2, 2, 2, 6, -2, 6, -2, 2};
    static const uint64_t outline_starts[] = {0, 5};
    tree_strokes_columns polygons = {.struct_size = sizeof polygons, 1, outline_starts, 5, outline};
    tree_crown *crown = NULL;
    OK(tree_crown_from_polygons(&polygons, 1, NULL, &crown));
    OK(tree_sketch_branches_free(grown));
    OK(tree_sketch_branches_propagate(branches, NULL, crown, NULL, NULL, 3, NULL, &report, &grown));
    OK(tree_sketch_branches_view(grown, &columns));
    float farthest = 0;
    for (size_t i = 0; i < columns.n_points; i++)
        farthest = fmaxf(farthest, hypotf(columns.points[3 * i], columns.points[3 * i + 2]));
    CHECK(report.n_new > 20 && farthest <= 2.001f);
    tree_skeleton *wood = NULL;
    tree_skeleton_columns nodes = {.struct_size = sizeof nodes};
    tree_sketch_finish_params bare;
    OK(tree_sketch_finish_params_init(&bare, sizeof bare));
    bare.leaves = bare.twigs = 0;
    OK(tree_sketch_branches_wood(grown, &bare, NULL, &wood));
    OK(tree_skeleton_view(wood, &nodes));
    CHECK(nodes.n_nodes > report.n_new && nodes.radii[0] > 0.05f);
    tree_tree *tree = NULL;
    tree_sketch_finish_report finish = {.struct_size = sizeof finish};
    OK(tree_sketch_grow_crown(wood, crown, &bare, 3, NULL, &finish, &tree));
    CHECK(finish.n_wood_nodes == nodes.n_nodes && finish.n_leaves == 0 && finish.n_twig_nodes == 0);
    OK(tree_tree_free(tree));
    OK(tree_sketch_grow_crown(wood, NULL, NULL, 3, NULL, &finish, &tree));
    CHECK(finish.n_leaves > 100 && finish.n_twig_nodes > 0);
    OK(tree_tree_free(tree));
    bare.species = (tree_str){"no tree", 7};
    FAILS(TREE_ERROR_UNKNOWN_NAME, "no tree",
          tree_sketch_grow_crown(wood, NULL, &bare, 3, NULL, NULL, &tree));
    OK(tree_skeleton_free(wood));
    OK(tree_crown_free(crown));
    OK(tree_volume_free(wall));
    OK(tree_sketch_branches_free(free_grown));
    OK(tree_sketch_branches_free(grown));
    OK(tree_sketch_branches_free(branches));
}

static void test_inference(void) {
    tree_drawing *drawing = four_strokes();
    tree_plan *plan = NULL;
    OK(tree_drawing_clean(drawing, NULL, NULL, &plan));
    tree_plan_columns plane = {.struct_size = sizeof plane};
    OK(tree_plan_view(plan, &plane));
    tree_inferred *inferred = NULL;
    OK(tree_sketch_infer(plan, NULL, NULL, 0, NULL, NULL, 5, NULL, &inferred));
    tree_inferred_columns found = {.struct_size = sizeof found};
    OK(tree_inferred_view(inferred, &found));
    CHECK(found.n_segments == 7 && found.n_factors == 6 && found.n_trace > 1);
    CHECK(found.trace[0].step == TREE_SKETCH_STEP_BOTTOM_UP);
    for (size_t i = 1; i < found.n_trace; i++)
        CHECK(found.trace[i].posterior.total >= found.trace[i - 1].posterior.total - 1e-9);
    tree_sketch_posterior parts = found.posterior;
    CHECK(fabs(parts.branches + parts.competition + parts.crossings + parts.omega - parts.total) <
          1e-9);
    CHECK(parts.total == found.trace[found.n_trace - 1].posterior.total);

    /* x and y are those of the plan, and some depth is not 0. */
    tree_sketch_branches *branches = NULL;
    tree_sketch_branches_columns segments = {.struct_size = sizeof segments};
    OK(tree_inferred_branches(inferred, &branches));
    OK(tree_sketch_branches_view(branches, &segments));
    CHECK(segments.n_segments == 7 && segments.n_points == found.n_nodes && segments.names != NULL);
    float deepest = 0;
    for (size_t i = 0; i < found.n_nodes; i++) {
        const float *point = segments.points + 3 * i, *drawn = plane.positions + 2 * found.nodes[i];
        CHECK(point[0] == drawn[0] && point[1] == drawn[1]);
        deepest = fmaxf(deepest, fabsf(point[2]));
    }
    CHECK(deepest > 0.3f && found.node_starts[7] == found.n_nodes);

    /* The graph says the same of these depths as inference did, and less of flat ones. */
    tree_factor_graph *graph = NULL;
    tree_sketch_omega omega = {.struct_size = sizeof omega};
    const uint32_t *parents = NULL;
    size_t n = 0;
    double metres = 0, depths[7], flat[7] = {0};
    OK(tree_factor_graph_new(plan, NULL, NULL, 5, NULL, &graph));
    OK(tree_factor_graph_parents(graph, &parents, &n));
    CHECK(n == 7 && memcmp(parents, segments.parents, 7 * sizeof *parents) == 0);
    OK(tree_factor_graph_length(graph, 0, &metres));
    CHECK(metres > 1);
    FAILS(TREE_ERROR_PARAMETER, "segment is 7", tree_factor_graph_length(graph, 7, &metres));
    OK(tree_inferred_omega(inferred, &omega));
    for (int i = 0; i < 7; i++) depths[i] = segments.points[3 * segments.starts[i + 1] - 1];
    tree_sketch_posterior same, worse;
    OK(tree_factor_graph_posterior(graph, &omega, depths, segments.labels, 7, NULL, &same));
    CHECK(fabs(same.total - parts.total) < 1e-2);
    OK(tree_factor_graph_posterior(graph, &omega, flat, segments.labels, 7, NULL, &worse));
    CHECK(worse.total < same.total);
    FAILS(TREE_ERROR_INVALID, "7 segments",
          tree_factor_graph_posterior(graph, &omega, depths, segments.labels, 6, NULL, &same));
    flat[2] = INFINITY;
    FAILS(TREE_ERROR_PARAMETER, "depths[2]",
          tree_factor_graph_posterior(graph, NULL, flat, segments.labels, 7, NULL, &same));
    OK(tree_factor_graph_free(graph));
    OK(tree_sketch_branches_free(branches));
    OK(tree_inferred_free(inferred));

    /* What is known stays. */
    tree_sketch_infer_params thesis;
    OK(tree_sketch_infer_params_init(&thesis, sizeof thesis));
    CHECK(thesis.beam == 64 && thesis.rounds == 6);
    OK(tree_sketch_infer_params_thesis(&thesis));
    CHECK(thesis.beam == 1 && thesis.struct_size == sizeof thesis);
    tree_sketch_pin pin = {(uint32_t)plane.n_nodes - 1, 1.25f};
    OK(tree_sketch_infer(plan, &omega, &pin, 1, NULL, &thesis, 5, NULL, &inferred));
    OK(tree_inferred_branches(inferred, &branches));
    OK(tree_inferred_view(inferred, &found));
    OK(tree_sketch_branches_view(branches, &segments));
    int seen = 0;
    for (size_t i = 0; i < found.n_nodes; i++) {
        if (found.nodes[i] != pin.node) continue;
        CHECK(segments.points[3 * i + 2] == 1.25f);
        seen++;
    }
    CHECK(seen == 1);
    OK(tree_sketch_branches_free(branches));
    OK(tree_inferred_free(inferred));
    pin.node = 100000;
    FAILS(TREE_ERROR_INVALID, "pins[0]",
          tree_sketch_infer(plan, &omega, &pin, 1, NULL, &thesis, 5, NULL, &inferred));
    thesis.rounds = 101;
    FAILS(TREE_ERROR_PARAMETER, "infer.rounds",
          tree_sketch_infer(plan, &omega, NULL, 0, NULL, &thesis, 5, NULL, &inferred));
    OK(tree_plan_free(plan));
    OK(tree_drawing_free(drawing));
}

/* Depth of a stroke's tip; NaN where it has none. */
static float tip(tree_sketch_session *session, uint32_t stroke) {
    tree_plan *plan = NULL;
    tree_inferred *inferred = NULL;
    tree_sketch_branches *branches = NULL;
    tree_plan_columns plane = {.struct_size = sizeof plane};
    tree_inferred_columns found = {.struct_size = sizeof found};
    tree_sketch_branches_columns segments = {.struct_size = sizeof segments};
    OK(tree_sketch_session_plan(session, NULL, &plan));
    OK(tree_sketch_session_inferred(session, NULL, &inferred));
    OK(tree_inferred_branches(inferred, &branches));
    OK(tree_plan_view(plan, &plane));
    OK(tree_inferred_view(inferred, &found));
    OK(tree_sketch_branches_view(branches, &segments));
    float depth = NAN;
    for (size_t i = 0; i < found.n_nodes; i++)
        if (plane.strokes[found.nodes[i]] == stroke) depth = segments.points[3 * i + 2];
    OK(tree_sketch_branches_free(branches));
    OK(tree_inferred_free(inferred));
    OK(tree_plan_free(plan));
    return depth;
}

static uint32_t runs(const tree_sketch_session *session, tree_sketch_stage stage) {
    uint32_t n_runs = 0;
    OK(tree_sketch_session_runs(session, stage, &n_runs));
    return n_runs;
}

static void test_stages(void) {
    tree_sketch_session *session = a_session();
    tree_template_choice choices[64];
    size_t n_choices = 0;
    OK(tree_sketch_session_choices(session, NULL, NULL, 0, &n_choices));
    CHECK(n_choices >= 10 && n_choices <= 64);
    OK(tree_sketch_session_choices(session, NULL, choices, 64, &n_choices));
    CHECK(choices[0].score >= choices[1].score && choices[0].score < 0);
    CHECK(runs(session, TREE_SKETCH_STAGE_SELECT) == 1 && runs(session, TREE_SKETCH_STAGE_INFER) == 0);
    tree_templates *taken = NULL;
    size_t n_templates = 0;
    OK(tree_sketch_session_template_taken(session, NULL, &taken));
    OK(tree_templates_count(taken, &n_templates));
    CHECK(n_templates == 1);

    tree_sketch_branches *branches = NULL;
    tree_sketch_propagate_report report = {.struct_size = sizeof report};
    tree_sketch_branches_columns columns = {.struct_size = sizeof columns};
    OK(tree_sketch_session_branches(session, NULL, &report, &branches));
    OK(tree_sketch_branches_view(branches, &columns));
    CHECK(columns.n_sketched == 7 && columns.n_segments == 7 + report.n_new);
    tree_skeleton *wood = NULL;
    OK(tree_sketch_session_wood(session, NULL, &wood));
    OK(tree_skeleton_free(wood));
    OK(tree_sketch_branches_free(branches));

    tree_crown *crown = NULL;
    FAILS(TREE_ERROR_NO_RESULT, "no crown", tree_sketch_session_crown(session, NULL, &crown));
    tree_lines *warnings = NULL;
    const tree_str *texts = NULL;
    size_t n_texts = 99;
    OK(tree_sketch_session_warnings(session, NULL, &warnings));
    OK(tree_lines_view(warnings, &texts, &n_texts));
    CHECK(n_texts < 10);
    OK(tree_lines_free(warnings));

    /* Other parameters of the finish redo the finish alone. */
    tree_sketch_params params = {.struct_size = sizeof params};
    OK(tree_sketch_session_get_params(session, &params));
    CHECK(params.height == 8 && params.propagate->generations == 2 && params.infer->rounds == 6);
    tree_sketch_finish_params finish = *params.finish;
    finish.leaves = 0;
    params.finish = &finish;
    tree_tree *tree = NULL;
    OK(tree_sketch_session_set_params(session, &params));
    OK(tree_sketch_session_tree(session, NULL, NULL, &tree));
    OK(tree_tree_free(tree));
    CHECK(runs(session, TREE_SKETCH_STAGE_PROPAGATE) == 1 && runs(session, TREE_SKETCH_STAGE_TREE) == 2);
    OK(tree_sketch_session_redo_from(session, TREE_SKETCH_STAGE_PROPAGATE));
    OK(tree_sketch_session_tree(session, NULL, NULL, &tree));
    OK(tree_tree_free(tree));
    CHECK(runs(session, TREE_SKETCH_STAGE_PROPAGATE) == 2 && runs(session, TREE_SKETCH_STAGE_INFER) == 1);
    FAILS(TREE_ERROR_ENUM, "TREE_SKETCH_STAGE_", tree_sketch_session_redo_from(session, 6));

    /* Nothing grows into the half behind the tree, and the sketch stays. */
    static const float behind[] = {0, 0, -1.5f}, backwards[] = {0, 0, 1};
    tree_volume *half = NULL;
    OK(tree_volume_half_space(behind, backwards, &half));
    float before = tip(session, LEFT);
    OK(tree_sketch_session_set_obstacles(session, half));
    OK(tree_sketch_session_branches(session, NULL, &report, &branches));
    CHECK(report.n_blocked + report.n_turned_aside + report.n_shortened > 0);
    CHECK(tip(session, LEFT) == before);
    OK(tree_sketch_branches_free(branches));
    OK(tree_sketch_session_set_obstacles(session, NULL));
    OK(tree_volume_free(half));

    /* One template of one's own is the one taken. */
    OK(tree_sketch_session_set_templates(session, taken));
    OK(tree_sketch_session_choices(session, NULL, NULL, 0, &n_choices));
    CHECK(n_choices == 1);
    OK(tree_sketch_session_set_templates(session, NULL));
    OK(tree_sketch_session_choices(session, NULL, NULL, 0, &n_choices));
    CHECK(n_choices >= 10);
    OK(tree_templates_free(taken));
    OK(tree_sketch_session_free(session));
}

static void test_edits(void) {
    tree_sketch_session *session = a_session(), *copy = NULL;
    float left = tip(session, LEFT), right = tip(session, RIGHT), top = tip(session, TOP);
    CHECK(isfinite(left) && isfinite(right) && isfinite(top));
    CHECK(fabsf(left) + fabsf(right) + fabsf(top) > 0.1f);
    OK(tree_sketch_session_copy(session, &copy));

    /* A stroke more: those before keep their depths. */
    tree_sketch_stroke more = a_line(more_points, 3, TREE_ROLE_BRANCH);
    size_t number = 0;
    OK(tree_sketch_session_add_stroke(session, &more, NULL, &number));
    CHECK(number == STROKES && isfinite(tip(session, STROKES)));
    CHECK(fabsf(tip(session, LEFT) - left) < 1e-3f && fabsf(tip(session, RIGHT) - right) < 1e-3f);
    CHECK(fabsf(tip(session, TOP) - top) < 1e-3f);
    CHECK(runs(session, TREE_SKETCH_STAGE_INFER) == 2);

    /* One erased: the others keep theirs, and their numbers. */
    uint32_t gone[5];
    size_t n_gone = 0;
    FAILS(TREE_ERROR_BUFFER, "5 may be needed",
          tree_sketch_session_erase_stroke(session, RIGHT, NULL, gone, 4, &n_gone));
    OK(tree_sketch_session_erase_stroke(session, RIGHT, NULL, gone, 5, &n_gone));
    CHECK(n_gone == 1 && gone[0] == RIGHT && isnan(tip(session, RIGHT)));
    CHECK(fabsf(tip(session, LEFT) - left) < 1e-3f && fabsf(tip(session, TOP) - top) < 1e-3f);
    FAILS(TREE_ERROR_INVALID, "erased",
          tree_sketch_session_erase_stroke(session, RIGHT, NULL, NULL, 0, NULL));
    FAILS(TREE_ERROR_INVALID, "5 strokes",
          tree_sketch_session_erase_stroke(session, 5, NULL, NULL, 0, NULL));
    tree_drawing *drawing = NULL;
    tree_sketch_stroke empty = {.struct_size = sizeof empty};
    OK(tree_sketch_session_drawing(session, &drawing));
    OK(tree_drawing_count(drawing, &number));
    OK(tree_drawing_stroke(drawing, RIGHT, &empty));
    CHECK(number == 5 && empty.n_points == 0);
    OK(tree_drawing_free(drawing));

    /* A depth moved: it is where it was put, and the others stay. */
    float added = tip(session, STROKES);
    OK(tree_sketch_session_set_depth(session, LEFT, left_points + 6, 1.5f, NULL));
    CHECK(tip(session, LEFT) == 1.5f);
    CHECK(fabsf(tip(session, TOP) - top) < 1e-3f && fabsf(tip(session, STROKES) - added) < 1e-3f);
    FAILS(TREE_ERROR_INVALID, "strokes[2]",
          tree_sketch_session_set_depth(session, RIGHT, right_points, 1, NULL));
    FAILS(TREE_ERROR_PARAMETER, "finite",
          tree_sketch_session_set_depth(session, LEFT, left_points, NAN, NULL));
    tree_tree *tree = NULL;
    OK(tree_sketch_session_tree(session, NULL, NULL, &tree));
    OK(tree_tree_free(tree));

    /* All that is forgotten, and the copy is as it was. */
    OK(tree_sketch_session_infer_anew(session));
    CHECK(tip(session, LEFT) != 1.5f);
    CHECK(tip(copy, LEFT) == left && tip(copy, RIGHT) == right);
    CHECK(runs(copy, TREE_SKETCH_STAGE_INFER) == 1);
    OK(tree_sketch_session_free(session));
    OK(tree_sketch_session_free(copy));
}

static int32_t busy(void *user, const char *stage, float fraction) {
    (void)stage;
    (void)fraction;
    FAILS(TREE_ERROR_ORDER, "at work", tree_sketch_session_free(user));
    return 0;
}

static int32_t at_once(void *user, const char *stage, float fraction) {
    (void)stage;
    (void)fraction;
    ++*(int *)user;
    return 1;
}

static void test_what_goes_wrong(void) {
    /* Cancelled: the session can go on later. */
    tree_sketch_session *session = a_session();
    tree_control control;
    int n_told = 0;
    tree_tree *tree = (tree_tree *)&n_told;
    OK(tree_control_init(&control, sizeof control));
    control.progress = at_once;
    control.user = &n_told;
    FAILS(TREE_ERROR_CANCELLED, "", tree_sketch_session_tree(session, &control, NULL, &tree));
    CHECK(tree == NULL && n_told == 1);
    tree_cancel *cancel = NULL;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    control.progress = NULL;
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "", tree_sketch_session_tree(session, &control, NULL, &tree));
    OK(tree_cancel_free(cancel));
    OK(tree_control_init(&control, sizeof control));
    control.progress = busy;
    control.user = session;
    OK(tree_sketch_session_tree(session, &control, NULL, &tree));
    OK(tree_tree_free(tree));

    /* Limits. */
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&control, sizeof control));
    limits.nodes = 20;
    control.limits = &limits;
    OK(tree_sketch_session_redo_from(session, TREE_SKETCH_STAGE_CLEAN));
    FAILS(TREE_ERROR_LIMIT, "20", tree_sketch_session_tree(session, &control, NULL, &tree));

    /* Stale handles. */
    OK(tree_sketch_session_free(session));
    FAILS(TREE_ERROR_HANDLE, "session", tree_sketch_session_tree(session, NULL, NULL, &tree));
    FAILS(TREE_ERROR_HANDLE, "session", tree_sketch_session_free(session));
    OK(tree_sketch_session_free(NULL));
    FAILS(TREE_ERROR_NULL, "drawing", tree_sketch_session_new(NULL, NULL, 1, &session));

    /* Strokes of no use. */
    static const float nowhere[] = {NAN, 1, INFINITY, 3}, spot[] = {4, 4, 4, 4, 4, 4};
    tree_sketch_stroke bad[] = {a_line(nowhere, 2, TREE_ROLE_BRANCH), a_line(spot, 3, TREE_ROLE_TRUNK)};
    tree_drawing *drawing = NULL;
    OK(tree_drawing_new(bad, 2, NULL, &drawing));
    FAILS(TREE_ERROR_INVALID, "stroke",
          tree_from_sketch(drawing, NULL, NULL, NULL, 1, NULL, NULL, &tree));
    OK(tree_drawing_free(drawing));
    OK(tree_drawing_new(NULL, 0, NULL, &drawing));
    FAILS(TREE_ERROR_INVALID, "",
          tree_from_sketch(drawing, NULL, NULL, NULL, 1, NULL, NULL, &tree));
    OK(tree_drawing_free(drawing));

    /* Parameters out of range are named, in parts too. */
    tree_sketch_params params = *small();
    params.height = -1;
    FAILS(TREE_ERROR_PARAMETER, "height", tree_sketch_params_check(&params));
    params.height = 0;
    tree_sketch_propagate_params propagate;
    OK(tree_sketch_propagate_params_init(&propagate, sizeof propagate));
    propagate.jitter = NAN;
    params.propagate = &propagate;
    FAILS(TREE_ERROR_PARAMETER, "propagate.jitter", tree_sketch_params_check(&params));
    drawing = four_strokes();
    FAILS(TREE_ERROR_PARAMETER, "propagate.jitter",
          tree_sketch_session_new(drawing, &params, 1, &session));
    OK(tree_drawing_free(drawing));
}

/* With a crown drawn. */
static void test_crown_in_session(void) {
    static const float around[] = {100, 10, 40, 40, 25, 110, 70, 150, 140, 150, 180, 100, 160, 35};
    tree_sketch_session *session = a_session();
    tree_sketch_stroke outline = a_line(around, 7, TREE_ROLE_CROWN);
    outline.closed = 1;
    size_t number = 0;
    OK(tree_sketch_session_add_stroke(session, &outline, NULL, &number));
    tree_crown *crown = NULL;
    OK(tree_sketch_session_crown(session, NULL, &crown));
    OK(tree_crown_free(crown));
    tree_tree *tree = NULL;
    tree_sketch_report report = {.struct_size = sizeof report};
    OK(tree_sketch_session_tree(session, NULL, &report, &tree));
    CHECK(report.has_crown == 1 && report.crown_outside < 0.3f && report.grown_new > 20);
    OK(tree_tree_free(tree));
    OK(tree_sketch_session_free(session));
}

void test_sketch(void) {
    test_omega();
    test_branches();
    test_inference();
    test_in_one_call();
    test_stages();
    test_edits();
    test_crown_in_session();
    test_what_goes_wrong();
}
