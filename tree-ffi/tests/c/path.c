#include "check.h"
#include <math.h>

static const float origin[3] = {0, 0, 0};

/* A small oak without leaves: a second or two under valgrind. */
static tree_path_params a_sapling(void) {
    tree_path_params params;
    OK(tree_path_params_init(&params, sizeof params));
    params.graph_nodes = 200;
    params.endpoints_random = 4;
    params.n_levels = 1;
    params.leaves = NULL;
    return params;
}

static size_t n_nodes(const tree_tree *tree) {
    tree_skeleton *skeleton;
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_view(skeleton, &columns));
    OK(tree_skeleton_free(skeleton));
    return columns.n_nodes;
}

static void presets(void) {
    size_t before = tree_live_objects();
    size_t n = tree_path_preset_count();
    CHECK(n == 15);
    for (size_t i = 0; i < n; i++) {
        tree_str name, title;
        float seconds = -1;
        tree_path_params params;
        OK(tree_path_preset_name(i, &name, &title));
        OK(tree_path_preset_paper_seconds(i, &seconds));
        CHECK(title.len > 3 && seconds >= 0);
        OK(tree_path_preset(name.data, name.len, &params, sizeof params));
        OK(tree_path_params_check(&params, NULL));
        uint32_t bounded = 0;
        OK(tree_volume_is_bounded(params.volume, &bounded));
        CHECK(bounded && params.radii && params.species);
        FAILS(TREE_ERROR_ORDER, "library", tree_volume_free((tree_volume *)params.volume));
    }
    CHECK(tree_live_objects() == before);
    tree_path_params params;
    OK(tree_path_preset("oak", TREE_NUL_TERMINATED, &params, sizeof params));
    CHECK(params.graph_nodes == 5000 && params.n_levels == 3 && params.levels[0].branching == 5);
    CHECK(params.leaves && params.species->n_leaf_kinds == 1);
    OK(tree_path_params_check(NULL, NULL));
    float radius;
    OK(tree_path_level_radius(&params, 1, &radius));
    CHECK(fabsf(radius - params.size * params.shrink) < 1e-5f);
    FAILS(TREE_ERROR_PARAMETER, "levels", tree_path_level_radius(&params, 3, &radius));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "oak", tree_path_preset("elm", 3, &params, sizeof params));
    FAILS(TREE_ERROR_STRUCT_SIZE, "sizeof", tree_path_preset("oak", 3, &params, 3));
    FAILS(TREE_ERROR_PARAMETER, "index", tree_path_preset_name(n, NULL, NULL));
}

static float twice_on_the_left(void *user, const float *point) {
    return point[0] < 0 ? *(const float *)user : 1;
}

static void growing(void) {
    tree_path_params params = a_sapling();
    tree_path_report report = {.struct_size = sizeof report};
    tree_tree *tree, *again;
    tree_bytes *levels;
    OK(tree_path_grow(&params, 1, NULL, &report, &tree));
    CHECK(report.n_levels == 2 && report.n_root_levels == 0 && report.levels[0].n_endpoints == 4);
    CHECK(report.total.n_graphs == report.levels[0].n_graphs + report.levels[1].n_graphs);
    CHECK(report.total.n_endpoints > 4 && report.total.n_graph_nodes > 200);

    OK(tree_path_grow_with_levels(&params, 1, NULL, NULL, &levels, &again));
    const uint8_t *bytes;
    size_t len;
    OK(tree_bytes_view(levels, &bytes, &len));
    CHECK(len == n_nodes(again) && len == n_nodes(tree));
    CHECK(bytes[0] == 1 && bytes[len - 1] == 2);
    OK(tree_bytes_free(levels));
    FAILS(TREE_ERROR_NULL, "tree", tree_path_grow_with_levels(&params, 1, NULL, NULL, &levels, NULL));
    CHECK(levels == NULL);
    OK(tree_tree_free(tree));
    OK(tree_tree_free(again));

    /* All that a tree can have. */
    tree_path_level level[2];
    OK(tree_path_level_init(&level[0], sizeof level[0]));
    CHECK(level[0].branching == 4 && level[0].graph_nodes == 110);
    level[0].branching = 2;
    level[0].graph_nodes = 40;
    level[0].axis = TREE_PATH_AXIS_FIXED;
    level[0].direction[1] = 2;
    level[0].size = 0.8f;
    level[1] = level[0];
    level[1].shape = TREE_PATH_SHAPE_CUSTOM;
    level[1].axis = TREE_PATH_AXIS_RANDOM;
    level[1].placing = TREE_PATH_PLACING_SURFACE;
    level[1].from_all_levels = 1;
    static const float middle[] = {0, 0.5f, 0}, wall[] = {8, 3, 0}, aside[] = {0.5f, 6, 0.5f};
    tree_volume *ball, *far;
    OK(tree_volume_sphere(middle, 0.5f, &ball));
    OK(tree_volume_sphere(wall, 1, &far));
    level[1].custom = ball;
    tree_paint paint;
    OK(tree_paint_init(&paint, sizeof paint));
    CHECK(paint.factor == 1);
    paint.volume = far;
    paint.factor = 0.5f;
    tree_leaf_params leaves;
    OK(tree_leaf_params_init(&leaves, sizeof leaves));
    leaves.spacing = 0.5f;
    tree_radius_rule radii;
    OK(tree_radius_rule_init(&radii, sizeof radii));
    radii.kind = TREE_RADII_TIP_DISTANCE;
    tree_path_params roots;
    OK(tree_path_preset("taproot", TREE_NUL_TERMINATED, &roots, sizeof roots));
    CHECK(roots.roots == NULL || roots.roots->roots == NULL);
    if (roots.roots) {
        roots = *roots.roots;
    }
    roots.graph_nodes = 100;
    roots.n_levels = 0;
    float dear = 2;
    params.levels = level;
    params.n_levels = 2;
    params.placed = aside;
    params.n_placed = 1;
    params.lifespan = TREE_PATH_LIFESPAN_RANDOM;
    params.lifespan_stop = 0.3f;
    params.paints = &paint;
    params.n_paints = 1;
    params.cost = twice_on_the_left;
    params.cost_user = &dear;
    params.obstacle = far;
    params.clearance = 0.1f;
    params.leaves = &leaves;
    params.radii = &radii;
    params.roots = &roots;
    OK(tree_path_grow_with_levels(&params, 2, NULL, &report, &levels, &tree));
    CHECK(report.n_levels == 3 && report.n_root_levels == 1 && report.root_levels[0].n_endpoints > 0);
    OK(tree_bytes_view(levels, &bytes, &len));
    CHECK(bytes[len - 1] == 0);
    tree_foliage foliage = {.struct_size = sizeof foliage};
    OK(tree_tree_foliage(tree, &foliage));
    CHECK(foliage.n_leaves > 0);
    OK(tree_tree_free(tree));
    OK(tree_bytes_free(levels));

    dear = NAN;
    FAILS(TREE_ERROR_PARAMETER, "cost", tree_path_grow(&params, 2, NULL, NULL, &tree));
    CHECK(tree == NULL);
    roots.roots = &roots;
    FAILS(TREE_ERROR_PARAMETER, "roots", tree_path_grow(&params, 2, NULL, NULL, &tree));
    roots.roots = NULL;
    level[1].shape = 77;
    FAILS(TREE_ERROR_ENUM, "levels[1].shape", tree_path_params_check(&params, NULL));
    level[1].shape = TREE_PATH_SHAPE_CONE;
    FAILS(TREE_ERROR_PARAMETER, "width", tree_path_params_check(&params, NULL));
    level[1].width = 0.5f;
    OK(tree_path_params_check(&params, NULL));
    level[1].shape = TREE_PATH_SHAPE_INVERTED_CONE;
    level[1].axis = 9;
    FAILS(TREE_ERROR_ENUM, "axis", tree_path_params_check(&params, NULL));
    level[1].axis = TREE_PATH_AXIS_DOWN;
    level[1].placing = 9;
    FAILS(TREE_ERROR_ENUM, "placing", tree_path_params_check(&params, NULL));
    level[1].struct_size = 8;
    FAILS(TREE_ERROR_STRUCT_SIZE, "levels[1]", tree_path_params_check(&params, NULL));
    params.n_levels = 17;
    FAILS(TREE_ERROR_LIMIT, "levels", tree_path_params_check(&params, NULL));
    OK(tree_volume_free(ball));
    OK(tree_volume_free(far));
    params = a_sapling();
    params.lifespan = 5;
    FAILS(TREE_ERROR_ENUM, "lifespan", tree_path_params_check(&params, NULL));
    params = a_sapling();
    params.volume = NULL;
    FAILS(TREE_ERROR_NULL, "volume", tree_path_params_check(&params, NULL));
    params = a_sapling();
    params.root[1] = 99;
    FAILS(TREE_ERROR_NO_RESULT, "root", tree_path_grow(&params, 1, NULL, NULL, &tree));

    params = a_sapling();
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.graph_nodes = 100;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "graph_nodes", tree_path_grow(&params, 1, &control, NULL, &tree));
    tree_cancel *cancel;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    control.limits = NULL;
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_path_grow(&params, 1, &control, NULL, &tree));
    OK(tree_cancel_free(cancel));
}

static void stages(void) {
    static const float ends[] = {0, 0.1f, 0, 0, 0.9f, 0}, wall_min[] = {0.2f, 0, -1}, wall_max[] = {0.3f, 1, 1};
    static const float one[] = {1, 1, 1}, other[] = {1, 0.5f, 0};
    tree_volume *box, *wall;
    OK(tree_volume_box(origin, one, &box));
    OK(tree_volume_box(wall_min, wall_max, &wall));
    uint32_t is_free = 9;
    OK(tree_obstacle_is_free(wall, 0.05f, origin, other, &is_free));
    CHECK(is_free == 0);
    OK(tree_obstacle_is_free(wall, 0.05f, origin, origin, &is_free));
    CHECK(is_free == 1);
    FAILS(TREE_ERROR_PARAMETER, "clearance",
          tree_obstacle_is_free(wall, NAN, origin, other, &is_free));

    tree_strew_params strew;
    OK(tree_strew_params_init(&strew, sizeof strew));
    CHECK(strew.n_nodes == 5000);
    strew.n_nodes = 300;
    strew.forced = ends;
    strew.n_forced = 2;
    tree_graph_nodes *nodes;
    OK(tree_graph_strew(box, &strew, 3, NULL, &nodes));
    tree_graph_nodes_columns strewn = {.struct_size = sizeof strewn};
    OK(tree_graph_nodes_view(nodes, &strewn));
    CHECK(strewn.n_nodes > 200 && strewn.n_nodes < 400 && strewn.n_forced == 2);
    CHECK(strewn.separation > 0.05f && strewn.separation < 0.2f);
    CHECK(strewn.positions[3 * strewn.forced[1] + 1] == 0.9f);
    /* Columns without rows are NULL. */
    strew.n_forced = 0;
    tree_graph_nodes *free_nodes;
    OK(tree_graph_strew(box, &strew, 3, NULL, &free_nodes));
    tree_graph_nodes_columns unforced = {.struct_size = sizeof unforced};
    OK(tree_graph_nodes_view(free_nodes, &unforced));
    CHECK(unforced.n_forced == 0 && unforced.forced == NULL && unforced.positions);
    OK(tree_graph_nodes_free(free_nodes));

    tree_link_params link;
    OK(tree_link_params_init(&link, sizeof link));
    CHECK(link.reach == 2 && link.low == 0.25f && link.bias == 1);
    tree_graph *graph;
    OK(tree_graph_link(nodes, &link, 3, NULL, &graph));
    tree_graph_columns view = {.struct_size = sizeof view};
    OK(tree_graph_view(graph, &view));
    CHECK(view.n_nodes == strewn.n_nodes && view.starts[view.n_nodes] == view.n_arcs);
    CHECK(view.arcs[0].to < view.n_nodes && view.arcs[0].cost > 0);
    float *costs = malloc(view.n_nodes * sizeof(float));
    uint32_t *from = malloc(view.n_nodes * sizeof(uint32_t));
    OK(tree_graph_search(graph, strewn.forced[0], NULL, costs, from, view.n_nodes));
    CHECK(costs[strewn.forced[0]] == 0 && from[strewn.forced[0]] == TREE_NO_NODE);
    /* The cost of the path is the sum of its arcs. */
    double sum = 0;
    for (uint32_t node = strewn.forced[1]; from[node] != TREE_NO_NODE; node = from[node]) {
        for (uint32_t arc = view.starts[node]; arc < view.starts[node + 1]; arc++) {
            sum += view.arcs[arc].to == from[node] ? (double)view.arcs[arc].cost : 0;
        }
    }
    CHECK(fabs(sum - (double)costs[strewn.forced[1]]) < 1e-4 && sum > 0.1);
    free(costs);
    free(from);
    OK(tree_graph_search(graph, 1u << 30, NULL, NULL, NULL, 0));
    OK(tree_graph_free(graph));

    tree_paint paint = {.struct_size = sizeof paint, .volume = wall, .factor = -1};
    link.paints = &paint;
    link.n_paints = 1;
    FAILS(TREE_ERROR_PARAMETER, "factor", tree_graph_link(nodes, &link, 3, NULL, &graph));
    link.n_paints = 0;
    link.reach = NAN;
    FAILS(TREE_ERROR_PARAMETER, "reach", tree_graph_link(nodes, &link, 3, NULL, &graph));
    OK(tree_graph_nodes_free(nodes));
    tree_volume *endless;
    OK(tree_volume_half_space(origin, one, &endless));
    FAILS(TREE_ERROR_NO_RESULT, "end", tree_graph_strew(endless, NULL, 3, NULL, &nodes));
    OK(tree_volume_free(endless));
    const float lost[] = {NAN, 0, 0};
    strew.forced = lost;
    strew.n_forced = 1;
    FAILS(TREE_ERROR_PARAMETER, "forced[0]", tree_graph_strew(box, &strew, 3, NULL, &nodes));
    OK(tree_volume_free(box));
    OK(tree_volume_free(wall));

    static const float places[] = {0, 0, 0, 1, 0, 0, 2, 0, 0};
    static const uint32_t edges[] = {0, 1, 1, 2, 0, 2};
    float prices[] = {1, 1, 5}, found[3];
    uint32_t before[3];
    OK(tree_graph_from_edges(places, 3, edges, prices, 3, NULL, &graph));
    OK(tree_graph_search(graph, 0, NULL, found, before, 3));
    CHECK(found[2] == 2 && before[2] == 1 && before[1] == 0);
    OK(tree_graph_free(graph));
    prices[1] = -1;
    FAILS(TREE_ERROR_PARAMETER, "edges[1]",
          tree_graph_from_edges(places, 3, edges, prices, 3, NULL, &graph));
}

static void drawings(void) {
    static const char svg[] = "<svg xmlns='http://www.w3.org/2000/svg'>"
                              "<polygon points='0,8 4,8 2,0'/></svg>";
    tree_profile_options options;
    OK(tree_profile_options_init(&options, sizeof options));
    CHECK(options.height == 10 && options.widen == 1);
    options.height = 4;
    tree_profile *profile;
    OK(tree_profile_from_svg(svg, TREE_NUL_TERMINATED, &options, NULL, &profile));
    tree_profile_columns points = {.struct_size = sizeof points};
    OK(tree_profile_view(profile, &points));
    CHECK(points.from_outline == 1 && points.n_points > 10);
    CHECK(points.points[1] == 0 && fabsf(points.points[0] - 1) < 0.01f);
    tree_volume *first, *second;
    OK(tree_profile_volume(profile, origin, &first));
    OK(tree_profile_free(profile));
    OK(tree_volume_from_svg(svg, sizeof svg - 1, &options, origin, NULL, &second));
    float a, b;
    OK(tree_volume_measure(first, &a));
    OK(tree_volume_measure(second, &b));
    CHECK(a == b && fabsf(a - 4.19f) < 0.05f);
    OK(tree_volume_free(first));
    OK(tree_volume_free(second));
    FAILS(TREE_ERROR_FORMAT, "", tree_profile_from_svg("<svg", 4, NULL, NULL, &profile));
    FAILS(TREE_ERROR_TEXT, "UTF-8", tree_profile_from_svg("\xff", 1, NULL, NULL, &profile));
    options.widen = 0;
    FAILS(TREE_ERROR_PARAMETER, "widen",
          tree_volume_from_svg(svg, TREE_NUL_TERMINATED, &options, origin, NULL, &first));
}

static int32_t never(void *user, const char *stage, float fraction) {
    (void)stage, (void)fraction;
    *(int *)user = 1;
    return 0;
}

/* A report that cannot be written is found before the work is done. */
static void reports_are_foreseen(void) {
    int begun = 0;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.progress = never;
    control.user = &begun;
    tree_path_report report = {.struct_size = 0};
    tree_tree *tree = NULL;
    FAILS(TREE_ERROR_STRUCT_SIZE, "report", tree_path_grow(NULL, 1, &control, &report, &tree));
    CHECK(tree == NULL && !begun);
}

void test_path(void) {
    presets();
    reports_are_foreseen();
    growing();
    stages();
    drawings();
}
