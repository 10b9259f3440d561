#include "check.h"
#include <math.h>

/* A disc on a stick: the tree is 64 of the picture's 72 rows high. */
enum { WIDTH = 48, HEIGHT = 72, FOOT = 68 };

static tree_matte *a_matte(void) {
    static float alpha[WIDTH * HEIGHT];
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            float dx = (float)x + 0.5f - WIDTH / 2, dy = (float)y + 0.5f - 24;
            int crown = dx * dx + dy * dy < 20 * 20;
            int trunk = fabsf(dx) < 2 && y >= 24 && y < FOOT;
            alpha[y * WIDTH + x] = trunk ? 1.0f : crown ? 0.8f : 0.0f;
        }
    }
    tree_matte *matte = NULL;
    OK(tree_matte_from_alpha(WIDTH, HEIGHT, alpha, WIDTH * HEIGHT, NULL, &matte));
    return matte;
}

static tree_particle_camera a_camera(float yaw) {
    tree_particle_camera camera;
    OK(tree_particle_camera_init(&camera, sizeof camera));
    camera.yaw = yaw;
    camera.size[0] = WIDTH;
    camera.size[1] = HEIGHT;
    camera.base[0] = WIDTH / 2;
    camera.base[1] = FOOT;
    camera.scale = 8.0f / 64;
    return camera;
}

/* A Y on a stick. */
static tree_attractor *a_graph(void) {
    static const float positions[] = {24, 68, 24, 40, 14, 18, 34, 18};
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 1, 1};
    tree_attractor_columns columns = {.struct_size = sizeof columns, 4, positions, parents};
    tree_attractor *graph = NULL;
    OK(tree_attractor_from_columns(&columns, NULL, &graph));
    return graph;
}

/* Little work. */
static tree_density_params coarse(void) {
    tree_density_params params;
    OK(tree_density_params_init(&params, sizeof params));
    CHECK(params.resolution == 48 && params.rounding == 1);
    params.resolution = 16;
    OK(tree_density_params_check(&params));
    params.tolerance = NAN;
    FAILS(TREE_ERROR_PARAMETER, "density.tolerance", tree_density_params_check(&params));
    params.tolerance = 0.05f;
    return params;
}

static tree_flow_params few(void) {
    tree_flow_params params;
    OK(tree_flow_params_init(&params, sizeof params));
    CHECK(params.image == 1 && params.steps > 100);
    params.particles = 80;
    OK(tree_flow_params_check(&params));
    params.stem = 0;
    FAILS(TREE_ERROR_PARAMETER, "flow.stem", tree_flow_params_check(&params));
    params.stem = 0.6f;
    return params;
}

static tree_finish_params sparse(tree_leaf_params *leaves) {
    tree_finish_params params;
    OK(tree_finish_params_init(&params, sizeof params));
    CHECK(params.radii->kind == TREE_RADII_PIPE && fabsf(params.radii->exponent - 2.49f) < 1e-6f);
    CHECK(params.twigs && params.leaves && params.species->n_leaf_kinds == 1);
    OK(tree_finish_params_check(&params));
    params.blade = -1;
    FAILS(TREE_ERROR_PARAMETER, "finish.blade", tree_finish_params_check(&params));
    tree_radius_rule rule = *params.radii;
    rule.kind = TREE_RADII_STRANDS;
    params.blade = 0.28f;
    params.radii = &rule;
    FAILS(TREE_ERROR_PARAMETER, "TREE_RADII_PIPE", tree_finish_params_check(&params));
    OK(tree_finish_params_find("pine", TREE_NUL_TERMINATED, &params, sizeof params));
    CHECK(params.species->name.len == 4 && memcmp(params.species->name.data, "pine", 4) == 0);
    CHECK(params.leaves->size > 0.2f);
    FAILS(TREE_ERROR_UNKNOWN_NAME, "pine",
          tree_finish_params_find("no tree", TREE_NUL_TERMINATED, &params, sizeof params));
    OK(tree_finish_params_of("pine", 4, &params, sizeof params));
    CHECK(params.leaves->size < 0.2f);
    OK(tree_finish_params_find("oak", 3, &params, sizeof params));
    *leaves = *params.leaves;
    leaves->size = 0.6f;
    params.leaves = leaves;
    params.twigs = NULL;
    params.corrections = 1;
    return params;
}

static void grids(void) {
    static const float corner[] = {-1, 0, -1}, points[] = {-0.5f, 0.5f, -0.5f, 0, 1, 0, 9, 9, NAN};
    float values[8] = {0, 1, 2, 3, 4, 5, 6, 7}, found[3];
    tree_grid *grid;
    OK(tree_grid_new(corner, 1, 2, 2, 2, values, 8, NULL, &grid));
    tree_grid_columns view = {.struct_size = sizeof view};
    OK(tree_grid_view(grid, &view));
    CHECK(view.n_values == 8 && view.voxel == 1 && view.size[2] == 2 && view.corner[0] == -1);
    CHECK(memcmp(view.values, values, sizeof values) == 0);
    float box[6];
    OK(tree_grid_bounds(grid, &box));
    CHECK(box[0] == -1 && box[4] == 2 && box[5] == 1);
    size_t index;
    OK(tree_grid_index(grid, 1, 0, 1, &index));
    CHECK(index == 5);
    OK(tree_grid_index(grid, 1, -1, 1, &index));
    CHECK(index == SIZE_MAX);
    int32_t voxel[3];
    static const float point[] = {0.2f, 1.9f, -0.1f};
    OK(tree_grid_voxel_at(grid, point, &voxel));
    CHECK(voxel[0] == 1 && voxel[1] == 1 && voxel[2] == 0);
    OK(tree_grid_sample(grid, points, 3, NULL, found, 3));
    CHECK(found[0] == 0 && fabsf(found[1] - 3.5f) < 1e-6f && found[2] == 0);
    OK(tree_grid_nearest(grid, points, 3, NULL, found, 3));
    CHECK(found[0] == 0 && found[1] == 7 && found[2] == 0);
    FAILS(TREE_ERROR_BUFFER, "values", tree_grid_sample(grid, points, 3, NULL, found, 2));
    double measure;
    OK(tree_grid_crown_volume(grid, 3.5f, &measure));
    CHECK(measure == 4);

    tree_density_brush brush;
    OK(tree_density_brush_init(&brush, sizeof brush));
    CHECK(brush.radius == 0.5f && brush.softness == 0.5f);
    brush.points = points;
    brush.n_points = 1;
    brush.value = 9;
    tree_grid *painted;
    OK(tree_grid_paint(grid, &brush, 1, NULL, &painted));
    OK(tree_grid_view(painted, &view));
    CHECK(view.values[0] == 9 && view.values[1] == 1);
    OK(tree_grid_overlap(grid, 0.5f, painted, 0.5f, &measure));
    CHECK(fabs(measure - 7.0 / 8) < 1e-6);
    OK(tree_grid_free(painted));
    brush.softness = 2;
    FAILS(TREE_ERROR_PARAMETER, "brushes[0].softness",
          tree_grid_paint(grid, &brush, 1, NULL, &painted));
    CHECK(painted == NULL);
    OK(tree_grid_free(grid));

    OK(tree_grid_new(corner, 1, 2, 2, 2, NULL, 0, NULL, &grid));
    OK(tree_grid_view(grid, &view));
    CHECK(view.n_values == 8 && view.values[7] == 0);
    OK(tree_grid_free(grid));
    FAILS(TREE_ERROR_INVALID, "8 voxels", tree_grid_new(corner, 1, 2, 2, 2, values, 7, NULL, &grid));
    FAILS(TREE_ERROR_PARAMETER, "grid.size.y", tree_grid_new(corner, 1, 2, 0, 2, NULL, 0, NULL, &grid));
    FAILS(TREE_ERROR_LIMIT, "voxels",
          tree_grid_new(corner, 1, 4096, 4096, 4096, NULL, 0, NULL, &grid));
    values[3] = INFINITY;
    FAILS(TREE_ERROR_PARAMETER, "values[3]", tree_grid_new(corner, 1, 2, 2, 2, values, 8, NULL, &grid));
    CHECK(grid == NULL);
}

static void strokes(tree_matte *matte) {
    static const float points[] = {4, 4, 12, 4};
    tree_density_stroke stroke;
    OK(tree_density_stroke_init(&stroke, sizeof stroke));
    CHECK(stroke.width == 20 && stroke.value == 1);
    stroke.points = points;
    stroke.n_points = 2;
    stroke.width = 4;
    tree_matte *painted;
    OK(tree_matte_paint(matte, &stroke, 1, NULL, &painted));
    tree_matte_columns before = {.struct_size = sizeof before}, after = before;
    OK(tree_matte_view(matte, &before));
    OK(tree_matte_view(painted, &after));
    CHECK(after.area > before.area + 20 && after.area < before.area + 60);
    OK(tree_matte_free(painted));
    stroke.value = 2;
    FAILS(TREE_ERROR_PARAMETER, "strokes[0].value",
          tree_matte_paint(matte, &stroke, 1, NULL, &painted));
    stroke.n_points = SIZE_MAX;
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_matte_paint(matte, &stroke, 1, NULL, &painted));
}

/* More where x is large, none on the other side. */
static float right_only(void *user, const float *position) {
    ++*(int *)user;
    return position[0] > 0 ? 1 : NAN;
}

static tree_grid *densities(tree_matte *matte, const tree_particle_view views[2]) {
    tree_density_params params = coarse();
    tree_density_report report = {.struct_size = sizeof report};
    tree_density_view rows[2];
    tree_grid *grid, *alpha, *solved;
    OK(tree_grid_from_views(views, 2, &params, NULL, &report, rows, 2, &grid));
    CHECK(report.n_rays > 50 && report.n_voxels > 100 && report.n_carved > 100);
    CHECK(report.n_iterations > 0 && !report.not_converged && report.n_entries > report.n_voxels);
    CHECK(report.residual < 0.3 && report.n_opaque == 0 && report.n_contradictions == 0);
    CHECK(fabs(rows[0].residual - rows[1].residual) < 0.1 && !rows[0].is_opaque);

    tree_carved *carved;
    OK(tree_carved_new(views, 2, &params, NULL, &carved));
    tree_carved_columns view = {.struct_size = sizeof view};
    OK(tree_carved_view(carved, &view));
    CHECK(view.n_voxels == report.n_voxels && view.n_carved == report.n_carved);
    CHECK(view.n_unseen == report.n_unseen && view.voxels[0] < view.voxels[1]);
    CHECK(view.weights[0] > 0 && view.weights[0] <= 1);
    OK(tree_carved_alpha(carved, &alpha));
    double measure;
    OK(tree_grid_overlap(alpha, 0, grid, 0, &measure));
    CHECK(measure > 0.5);
    OK(tree_carved_solve(carved, views, 2, &params, NULL, &report, NULL, 0, &solved));
    OK(tree_grid_overlap(solved, 0, grid, 0, &measure));
    CHECK(measure == 1);
    OK(tree_grid_free(solved));
    FAILS(TREE_ERROR_BUFFER, "rows",
          tree_carved_solve(carved, views, 2, &params, NULL, &report, rows, 1, &solved));
    CHECK(solved == NULL);
    OK(tree_grid_free(alpha));

    /* The equations outlive what they were made of, and hold what they count. */
    tree_equations *equations;
    OK(tree_equations_new(carved, views, 2, &params, NULL, &equations));
    OK(tree_carved_free(carved));
    tree_equations_columns of = {.struct_size = sizeof of};
    OK(tree_equations_view(equations, &of));
    CHECK(of.n_rays == report.n_rays && of.n_voxels == report.n_voxels && of.lambda > 0);
    CHECK(of.n_entries == report.n_entries && of.starts[0] == 0);
    CHECK(of.starts[of.n_rays] == of.n_entries);
    for (size_t ray = 0; ray < of.n_rays; ray++) CHECK(of.starts[ray] < of.starts[ray + 1]);
    for (size_t i = 0; i < of.n_entries; i++)
        CHECK(of.voxels[i] < of.n_voxels && of.lengths[i] >= 0);
    CHECK(of.targets[0] >= 0 && of.weights[0] > 0 && of.weights[0] <= 1);
    OK(tree_equations_free(equations));

    /* Looking through it gives the matte again. */
    tree_matte *seen;
    OK(tree_grid_look_through(grid, views[0].camera, NULL, &seen));
    tree_matte_columns is = {.struct_size = sizeof is}, should = is;
    OK(tree_matte_view(seen, &is));
    OK(tree_matte_view(matte, &should));
    CHECK(fabs(is.area - should.area) < 0.2 * should.area);
    OK(tree_matte_free(seen));

    float points[3 * 50], other[3 * 50];
    int n_asked = 0, n_right = 0;
    OK(tree_grid_draw_points(grid, 50, NULL, NULL, 1, NULL, points, 150));
    OK(tree_grid_draw_points(grid, 50, NULL, NULL, 2, NULL, other, 150));
    CHECK(memcmp(points, other, sizeof points) != 0);
    OK(tree_grid_draw_points(grid, 50, NULL, NULL, 1, NULL, other, 150));
    CHECK(memcmp(points, other, sizeof points) == 0);
    tree_pool_options one = {.struct_size = sizeof one, .n_threads = 1};
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    tree_pool *pool;
    OK(tree_pool_new(&one, &pool));
    control.pool = pool;
    OK(tree_grid_draw_points(grid, 50, right_only, &n_asked, 1, &control, points, 150));
    for (int i = 0; i < 50; i++) n_right += points[3 * i] > 0;
    CHECK(n_asked > 100 && n_right > 45);
    OK(tree_pool_free(pool));
    FAILS(TREE_ERROR_BUFFER, "points",
          tree_grid_draw_points(grid, 50, NULL, NULL, 1, NULL, points, 149));

    tree_particle_view bad[2];
    OK(tree_particle_view_init(&bad[0], sizeof bad[0]));
    FAILS(TREE_ERROR_NULL, "views[0].camera",
          tree_grid_from_views(bad, 1, &params, NULL, NULL, NULL, 0, &solved));
    tree_particle_camera wrong = a_camera(0);
    wrong.size[0] = 10;
    bad[0] = views[0];
    bad[0].camera = &wrong;
    FAILS(TREE_ERROR_NO_RESULT, "views[0]",
          tree_grid_from_views(bad, 1, &params, NULL, NULL, NULL, 0, &solved));
    wrong.scale = 0;
    FAILS(TREE_ERROR_PARAMETER, "views[0].camera.scale",
          tree_grid_from_views(bad, 1, &params, NULL, NULL, NULL, 0, &solved));
    FAILS(TREE_ERROR_PARAMETER, "views",
          tree_grid_from_views(NULL, 0, &params, NULL, NULL, NULL, 0, &solved));
    return grid;
}

static float half(void *user, float distance) {
    return distance > 0 ? *(float *)user : 0;
}

static tree_direction_field *fields(tree_attractor *graph) {
    tree_field_params params;
    OK(tree_field_params_init(&params, sizeof params));
    CHECK(params.blend == TREE_BLEND_LINEAR && params.rows == 100);
    CHECK(params.blend_reach > 0 && params.blend_table == NULL);
    OK(tree_field_params_check(&params));
    params.rows = 24;
    tree_direction_field *field, *other;
    OK(tree_direction_field_new(graph, WIDTH, HEIGHT, 24, FOOT, &params, NULL, &field));
    tree_direction_field_columns view = {.struct_size = sizeof view};
    OK(tree_direction_field_view(field, &view));
    CHECK(view.n_vectors == (size_t)view.size[0] * view.size[1] && view.size[1] >= 24);
    CHECK(fabsf(view.cell - 3) < 1e-4f);
    static const float spots[] = {24, 55, 4, 55};
    float found[4];
    OK(tree_direction_field_sample(field, spots, 2, NULL, found, 4));
    /* Down the trunk, and towards it. */
    CHECK(found[1] < -0.8f && fabsf(found[0]) < 0.3f && found[2] > 0.5f);
    tree_photo *picture, *drawn;
    tree_pixels pixels = {.struct_size = sizeof pixels};
    OK(tree_direction_field_picture(field, &picture));
    OK(tree_photo_view(picture, &pixels));
    CHECK(pixels.width == view.size[0] && pixels.height == view.size[1]);
    OK(tree_direction_field_draw_over(field, picture, 0xff0000ffu, &drawn));
    OK(tree_photo_free(drawn));
    OK(tree_photo_free(picture));

    /* The same by number, by table and by function. */
    float share = 0.5f, table[] = {0, 0.5f, 1, 0.5f}, at;
    params.blend = TREE_BLEND_CONSTANT;
    params.blend_share = share;
    OK(tree_field_params_blend_at(&params, 0.3f, &at));
    CHECK(at == 0.5f);
    OK(tree_direction_field_new(graph, WIDTH, HEIGHT, 24, FOOT, &params, NULL, &other));
    OK(tree_direction_field_view(other, &view));
    float sum = 0, rest = 0;
    for (size_t i = 0; i < 2 * view.n_vectors; i++) sum += fabsf(view.vectors[i]);
    OK(tree_direction_field_free(other));
    params.blend_function = half;
    params.blend_user = &share;
    params.blend = TREE_BLEND_FUNCTION;
    OK(tree_field_params_blend_at(&params, 0.3f, &at));
    CHECK(at == 0.5f);
    OK(tree_direction_field_new(graph, WIDTH, HEIGHT, 24, FOOT, &params, NULL, &other));
    OK(tree_direction_field_view(other, &view));
    for (size_t i = 0; i < 2 * view.n_vectors; i++) rest += fabsf(view.vectors[i]);
    CHECK(sum == rest && sum > 0);
    OK(tree_direction_field_free(other));
    params.blend = TREE_BLEND_TABLE;
    params.blend_table = table;
    params.n_blend_table = 2;
    OK(tree_field_params_blend_at(&params, 0.3f, &at));
    CHECK(at == 0.5f);
    table[3] = 3;
    FAILS(TREE_ERROR_PARAMETER, "field.blend[1].share", tree_field_params_check(&params));
    params.blend = 9;
    FAILS(TREE_ERROR_ENUM, "params.blend",
          tree_direction_field_new(graph, WIDTH, HEIGHT, 24, FOOT, &params, NULL, &other));
    FAILS(TREE_ERROR_PARAMETER, "picture_size",
          tree_direction_field_new(graph, WIDTH, 0, 24, FOOT, NULL, NULL, &other));
    return field;
}

static void flows(tree_grid *grid, tree_direction_field *field, const tree_particle_view views[2]) {
    tree_flow_params params = few();
    tree_way *way;
    OK(tree_way_new(grid, &params, NULL, &way));
    tree_grid *costs;
    OK(tree_way_costs(way, &costs));
    static const float points[] = {0.1f, 7, 0.1f, NAN, 0, 0}, far_off[] = {3e38f, -3e38f, 3e38f};
    float values[2], directions[6];
    OK(tree_way_sample(way, far_off, 1, NULL, directions, 6));
    for (int i = 0; i < 3; i++) CHECK(fabsf(directions[i]) <= 1);
    OK(tree_grid_sample(costs, points, 1, NULL, values, 2));
    CHECK(values[0] > 3);
    OK(tree_grid_free(costs));
    OK(tree_way_sample(way, points, 2, NULL, directions, 6));
    CHECK(directions[1] < -0.3f && directions[3] == 0);
    tree_flow_view eyes[2];
    for (int i = 0; i < 2; i++) {
        OK(tree_flow_view_init(&eyes[i], sizeof eyes[i]));
        eyes[i].camera = views[i].camera;
        eyes[i].field = field;
    }
    OK(tree_way_directions(way, eyes, 2, points, 2, &params, NULL, directions, 6));
    CHECK(directions[1] < -0.3f && directions[3] == 0);
    FAILS(TREE_ERROR_BUFFER, "directions", tree_way_sample(way, points, 2, NULL, directions, 5));

    float starts[3 * 80];
    OK(tree_grid_draw_points(grid, 80, NULL, NULL, 5, NULL, starts, 240));
    tree_flow_report report = {.struct_size = sizeof report};
    tree_traces *traces, *none;
    OK(tree_traces_flow(way, eyes, 2, starts, 80, 8, &params, NULL, &report, &traces));
    CHECK(report.n_particles == 80 && report.n_joins + report.n_followed > 40);
    CHECK(report.n_arrived >= 1 && report.n_steps > 10 && report.n_parts >= report.n_steps);
    CHECK(report.n_led == 0);
    tree_traces_columns view = {.struct_size = sizeof view};
    OK(tree_traces_view(traces, &view));
    CHECK(view.n_nodes > 80 && view.next[0] == TREE_NO_PARENT && view.masses[0] == 80);
    CHECK(view.positions[1] == 0);
    tree_skeleton *skeleton, *wood;
    OK(tree_traces_skeleton(traces, NULL, &skeleton));
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_skeleton_view(skeleton, &columns));
    CHECK(columns.n_nodes == view.n_nodes);
    OK(tree_skeleton_free(skeleton));
    FAILS(TREE_ERROR_PARAMETER, "height",
          tree_traces_flow(way, eyes, 2, starts, 80, NAN, &params, NULL, &report, &none));
    eyes[1].field = NULL;
    FAILS(TREE_ERROR_NULL, "views[1].field",
          tree_traces_flow(way, eyes, 2, starts, 80, 8, &params, NULL, &report, &none));
    CHECK(none == NULL);
    OK(tree_way_free(way));

    tree_leaf_params leaves;
    tree_finish_params finish = sparse(&leaves);
    OK(tree_traces_grow_wood(traces, 8, 0.3f, &finish, NULL, &wood));
    OK(tree_skeleton_view(wood, &columns));
    CHECK(fabsf(columns.radii[0] - 0.3f) < 1e-4f && columns.n_nodes > 20);
    tree_crown_report told = {.struct_size = sizeof told};
    tree_tree *tree;
    OK(tree_skeleton_grow_crown(wood, grid, views, 2, 8, &finish, 1, NULL, &told, &tree));
    CHECK(told.n_leaves > 10 && told.leaves_asked > 10 && told.n_twig_nodes == 0);
    tree_foliage foliage = {.struct_size = sizeof foliage};
    OK(tree_tree_foliage(tree, &foliage));
    CHECK(foliage.n_leaves == told.n_leaves);
    CHECK(told.n_twig_nodes_cut == 0 && told.n_leaves_discarded < 100000);
    OK(tree_tree_free(tree));
    OK(tree_skeleton_free(wood));
    OK(tree_traces_free(traces));
}

static uint32_t runs(const tree_photo_session *session, tree_photo_stage stage) {
    uint32_t n_runs = 999;
    OK(tree_photo_session_runs(session, stage, &n_runs));
    return n_runs;
}

/* Whether the stages from views to crown have been done so often, a digit each. */
static int ran(const tree_photo_session *session, const char *expected) {
    char found[8] = "";
    for (uint32_t stage = 0; stage < 7; stage++)
        found[stage] = (char)('0' + runs(session, TREE_PHOTO_STAGE_VIEWS + stage));
    if (strcmp(found, expected) != 0) printf("ran %s, not %s\n", found, expected);
    return strcmp(found, expected) == 0;
}

static size_t nodes(tree_tree *tree, float *sum) {
    tree_skeleton *skeleton;
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_view(skeleton, &columns));
    *sum = 0;
    for (size_t i = 0; i < 3 * columns.n_nodes; i++) *sum += fabsf(columns.positions[i]);
    size_t n_nodes = columns.n_nodes;
    OK(tree_skeleton_free(skeleton));
    return n_nodes;
}

static int32_t call_again(void *user, const char *stage, float fraction) {
    uint64_t seed;
    (void)stage, (void)fraction;
    FAILS(TREE_ERROR_ORDER, "one call", tree_photo_session_seed(user, &seed));
    FAILS(TREE_ERROR_ORDER, "one call", tree_photo_session_free(user));
    return 0;
}

static int32_t stop(void *user, const char *stage, float fraction) {
    (void)user, (void)fraction;
    return strcmp(stage, "particles") == 0;
}

typedef struct small {
    tree_photo_params params;
    tree_density_params density;
    tree_flow_params flow;
    tree_field_params field;
    tree_finish_params finish;
    tree_leaf_params leaves;
} small;

static void make_small(small *small) {
    OK(tree_photo_params_init(&small->params, sizeof small->params));
    CHECK(small->params.height == 10 && small->params.branches == 40 && !small->params.flow);
    OK(tree_photo_params_check(&small->params, NULL));
    small->density = coarse();
    small->flow = few();
    small->finish = sparse(&small->leaves);
    OK(tree_field_params_init(&small->field, sizeof small->field));
    small->field.rows = 24;
    small->params.height = 8;
    small->params.branches = 8;
    small->params.density = &small->density;
    small->params.flow = &small->flow;
    small->params.field = &small->field;
    small->params.finish = &small->finish;
}

static tree_photo_session *a_session(tree_matte *matte, small *small) {
    tree_photo_shot shots[2];
    tree_photo_placing aside;
    tree_photo_branches branches;
    OK(tree_photo_placing_init(&aside, sizeof aside));
    OK(tree_photo_branches_init(&branches, sizeof branches));
    aside.yaw = 1.5707963f;
    for (int i = 0; i < 2; i++) {
        OK(tree_photo_shot_init(&shots[i], sizeof shots[i]));
        shots[i].matte = matte;
    }
    shots[1].placing = &aside;
    shots[1].branches = &branches;
    tree_photo_session *session = NULL, *none;
    OK(tree_photo_session_new(shots, 2, &small->params, 7, NULL, &session));

    tree_photo_report report = {.struct_size = sizeof report};
    tree_tree *tree;
    OK(tree_from_photos(shots, 2, &small->params, 7, NULL, &report, &tree));
    CHECK(report.n_views == 2 && report.flow_particles == 80 && report.crown_leaves > 10);
    OK(tree_tree_free(tree));

    FAILS(TREE_ERROR_PARAMETER, "shots", tree_photo_session_new(NULL, 0, NULL, 1, NULL, &none));
    branches.kind = 77;
    FAILS(TREE_ERROR_ENUM, "shots[1].branches.kind",
          tree_photo_session_new(shots, 2, NULL, 1, NULL, &none));
    branches.kind = TREE_BRANCHES_GRAPH;
    FAILS(TREE_ERROR_NULL, "shots[1].branches.graph",
          tree_from_photos(shots, 2, NULL, 1, NULL, NULL, &tree));
    shots[0].matte = NULL;
    FAILS(TREE_ERROR_NULL, "shots[0].matte", tree_photo_session_new(shots, 2, NULL, 1, NULL, &none));
    shots[0].matte = matte;
    shots[1].branches = NULL;
    small->density.resolution = 1;
    FAILS(TREE_ERROR_PARAMETER, "density.resolution",
          tree_photo_session_new(shots, 2, &small->params, 1, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "density.resolution", tree_photo_params_check(&small->params, NULL));
    small->density.resolution = 16;
    small->field.blend = TREE_BLEND_FUNCTION;
    small->field.blend_function = half;
    FAILS(TREE_ERROR_PARAMETER, "TREE_BLEND_TABLE",
          tree_photo_session_new(shots, 2, &small->params, 1, NULL, &none));
    small->field.blend = TREE_BLEND_LINEAR;
    CHECK(none == NULL);
    return session;
}

static void stages(tree_photo_session *session) {
    size_t n_views;
    uint64_t seed;
    OK(tree_photo_session_count(session, &n_views));
    OK(tree_photo_session_seed(session, &seed));
    CHECK(n_views == 2 && seed == 7 && ran(session, "0000000"));
    tree_photo_params params = {.struct_size = sizeof params};
    OK(tree_photo_session_get_params(session, &params));
    CHECK(params.height == 8 && params.flow->particles == 80 && params.density->resolution == 16);
    CHECK(params.livewire && params.seeds && params.strokes && params.field->rows == 24);
    CHECK(params.finish->twigs == NULL && params.finish->leaves->size == 0.6f);

    tree_particle_camera camera = {.struct_size = sizeof camera};
    OK(tree_photo_session_camera(session, 1, NULL, &camera));
    CHECK(fabsf(camera.yaw - 1.5707963f) < 1e-6f && fabsf(camera.base[1] - FOOT) < 1.5f);
    CHECK(fabsf(camera.scale - 0.125f) < 0.01f && ran(session, "1000000"));
    OK(tree_photo_session_count_views(session, NULL, &n_views));
    CHECK(n_views == 2);
    tree_attractor *graph;
    tree_attractor_columns columns = {.struct_size = sizeof columns};
    OK(tree_photo_session_attractor(session, 0, NULL, &graph));
    OK(tree_attractor_view(graph, &columns));
    CHECK(columns.n_nodes > 4 && ran(session, "1100000"));
    tree_strokes *strokes;
    tree_strokes_columns drawn = {.struct_size = sizeof drawn};
    OK(tree_photo_session_strokes(session, 0, NULL, &strokes));
    OK(tree_strokes_view(strokes, &drawn));
    CHECK(drawn.n_strokes + 1 == columns.n_nodes && drawn.n_points == 2 * drawn.n_strokes);
    CHECK(drawn.points[0] == columns.positions[0] && ran(session, "1100000"));
    OK(tree_strokes_free(strokes));
    FAILS(TREE_ERROR_PARAMETER, "2 views", tree_photo_session_strokes(session, 2, NULL, &strokes));
    OK(tree_attractor_free(graph));
    tree_grid *density;
    OK(tree_photo_session_density(session, NULL, &density));
    CHECK(ran(session, "1110000"));
    OK(tree_grid_free(density));
    tree_direction_field *field;
    OK(tree_photo_session_field(session, 1, NULL, &field));
    CHECK(ran(session, "1111000"));
    OK(tree_direction_field_free(field));
    tree_traces *traces;
    OK(tree_photo_session_traces(session, NULL, &traces));
    CHECK(ran(session, "1111100"));
    OK(tree_traces_free(traces));
    tree_skeleton *wood;
    OK(tree_photo_session_wood(session, NULL, &wood));
    CHECK(ran(session, "1111110"));
    OK(tree_skeleton_free(wood));
    tree_tree *tree;
    tree_photo_report report = {.struct_size = sizeof report};
    OK(tree_photo_session_tree(session, NULL, &report, &tree));
    CHECK(ran(session, "1111111") && report.flow_particles == 80 && report.density_voxels > 100);
    CHECK(report.trunk_radius > 0.1f && report.trunk_radius < 0.5f && report.crown_base > 1);
    OK(tree_tree_free(tree));
    tree_photo_view_report row = {.struct_size = sizeof row};
    OK(tree_photo_session_view_report(session, 0, NULL, &row));
    CHECK(row.n_warnings < TREE_ALIGN_WARNINGS && row.residual < 0.5);
    CHECK(row.has_livewire && row.n_tips > 1 && row.attracts && !row.has_strokes);
    FAILS(TREE_ERROR_PARAMETER, "2 views", tree_photo_session_view_report(session, 2, NULL, &row));
    /* The same tree from both sides. */
    size_t n_doubts = 99;
    OK(tree_photo_session_disagreements(session, NULL, NULL, 0, &n_doubts));
    CHECK(n_doubts == 0);
    tree_lines *warnings;
    const tree_str *texts;
    size_t n_texts;
    OK(tree_photo_session_warnings(session, NULL, &warnings));
    OK(tree_lines_view(warnings, &texts, &n_texts));
    CHECK(n_texts == report.n_warnings && ran(session, "1111111"));
    OK(tree_lines_free(warnings));

    tree_matte *matte;
    OK(tree_photo_session_matte(session, 1, &matte));
    OK(tree_matte_free(matte));
    tree_photo *photo;
    FAILS(TREE_ERROR_NO_RESULT, "no photograph", tree_photo_session_photo(session, 1, &photo));
    FAILS(TREE_ERROR_PARAMETER, "2 views", tree_photo_session_matte(session, 2, &matte));
    FAILS(TREE_ERROR_PARAMETER, "2 views", tree_photo_session_camera(session, 2, NULL, &camera));
    FAILS(TREE_ERROR_ENUM, "stage", tree_photo_session_redo_from(session, 9));
}

static void pictures(tree_photo_session *session) {
    tree_photo *pictures[5];
    OK(tree_photo_session_draw_matte(session, 0, &pictures[0]));
    OK(tree_photo_session_draw_attractor(session, 0, NULL, &pictures[1]));
    OK(tree_photo_session_draw_field(session, 0, NULL, &pictures[2]));
    OK(tree_photo_session_draw_traces(session, 1, NULL, &pictures[3]));
    OK(tree_photo_session_draw_density(session, NULL, &pictures[4]));
    for (int i = 0; i < 5; i++) {
        tree_pixels pixels = {.struct_size = sizeof pixels};
        OK(tree_photo_view(pictures[i], &pixels));
        CHECK(i == 4 || (pixels.width == WIDTH && pixels.height == HEIGHT));
        int n_coloured = 0;
        for (size_t at = 0; at < pixels.n_bytes; at += 4)
            n_coloured += pixels.pixels[at] != pixels.pixels[at + 2];
        CHECK((n_coloured > 20) == (i > 0 && i < 4));
        OK(tree_photo_free(pictures[i]));
    }
    CHECK(ran(session, "1111111"));
    FAILS(TREE_ERROR_PARAMETER, "2 views", tree_photo_session_draw_field(session, 5, NULL, &pictures[0]));
}

static void edits(tree_photo_session *session, small *small, tree_matte *matte) {
    tree_photo_session *copy;
    tree_tree *tree, *other;
    float sum, other_sum;
    OK(tree_photo_session_copy(session, &copy));
    CHECK(ran(copy, "1111111"));
    OK(tree_photo_session_tree(session, NULL, NULL, &tree));
    nodes(tree, &sum);
    OK(tree_tree_free(tree));

    /* Another seed makes another tree in the same density; the old one comes back. */
    OK(tree_photo_session_set_seed(copy, 8));
    OK(tree_photo_session_tree(copy, NULL, NULL, &other));
    CHECK(ran(copy, "1111222"));
    nodes(other, &other_sum);
    CHECK(sum != other_sum);
    OK(tree_tree_free(other));
    OK(tree_photo_session_set_seed(copy, 7));
    OK(tree_photo_session_tree(copy, NULL, NULL, &other));
    nodes(other, &other_sum);
    CHECK(sum == other_sum && ran(copy, "1111333"));
    OK(tree_tree_free(other));
    OK(tree_photo_session_free(copy));

    small->finish.smoothing = 6;
    OK(tree_photo_session_set_params(session, &small->params, NULL));
    OK(tree_photo_session_tree(session, NULL, NULL, &tree));
    CHECK(ran(session, "1111122"));
    OK(tree_tree_free(tree));
    tree_photo_params now = {.struct_size = sizeof now};
    OK(tree_photo_session_get_params(session, &now));
    CHECK(now.finish->smoothing == 6);
    small->params.height = -1;
    FAILS(TREE_ERROR_PARAMETER, "height",
          tree_photo_session_set_params(session, &small->params, NULL));
    small->params.height = 8;

    static const float dab[] = {24, 60}, ball[] = {0, 5, 0};
    tree_density_stroke stroke;
    OK(tree_density_stroke_init(&stroke, sizeof stroke));
    stroke.points = dab;
    stroke.n_points = 1;
    OK(tree_photo_session_paint(session, 0, &stroke, 1, NULL));
    OK(tree_photo_session_tree(session, NULL, NULL, &tree));
    CHECK(ran(session, "1121233"));
    OK(tree_tree_free(tree));
    OK(tree_photo_session_set_matte(session, 0, matte));
    tree_density_brush brush;
    OK(tree_density_brush_init(&brush, sizeof brush));
    brush.points = ball;
    brush.n_points = 1;
    OK(tree_photo_session_paint_volume(session, &brush, 1, NULL));
    CHECK(ran(session, "1131233"));
    tree_grid *density;
    OK(tree_photo_session_density(session, NULL, &density));
    OK(tree_photo_session_set_density(session, density));
    OK(tree_grid_free(density));
    OK(tree_photo_session_tree(session, NULL, NULL, &tree));
    CHECK(ran(session, "1131344"));
    OK(tree_tree_free(tree));

    tree_attractor *graph = a_graph(), *found;
    OK(tree_photo_session_edit_attractor(session, 0, graph, NULL));
    OK(tree_photo_session_attractor(session, 0, NULL, &found));
    tree_attractor_columns columns = {.struct_size = sizeof columns};
    OK(tree_attractor_view(found, &columns));
    CHECK(columns.n_nodes == 4 && ran(session, "1131344"));
    OK(tree_attractor_free(found));
    static const float points[] = {24, 68, 24, 30, 24, 40, 40, 20};
    static const uint64_t starts[] = {0, 2, 4};
    tree_strokes_columns drawn = {.struct_size = sizeof drawn, 2, starts, 4, points};
    tree_photo_branches branches;
    OK(tree_photo_branches_init(&branches, sizeof branches));
    branches.kind = TREE_BRANCHES_STROKES;
    branches.strokes = &drawn;
    OK(tree_photo_session_set_branches(session, 0, &branches, NULL));
    tree_photo_view_report row = {.struct_size = sizeof row};
    OK(tree_photo_session_view_report(session, 0, NULL, &row));
    CHECK(row.has_strokes && !row.has_livewire && row.n_empty == 0);
    float gaps[2] = {-1, -1};
    OK(tree_photo_session_gaps(session, 0, NULL, gaps, 2));
    CHECK(gaps[0] >= 0 && gaps[1] >= 0);
    CHECK(ran(session, "1232455"));
    FAILS(TREE_ERROR_BUFFER, "gaps", tree_photo_session_gaps(session, 0, NULL, gaps, 1));
    drawn.n_points = 1;
    FAILS(TREE_ERROR_INVALID, "branches.strokes.starts",
          tree_photo_session_set_branches(session, 0, &branches, NULL));
    branches.kind = TREE_BRANCHES_SEEDS;
    branches.seeds = points;
    branches.n_seeds = 2;
    OK(tree_photo_session_set_branches(session, 1, &branches, NULL));
    branches.kind = TREE_BRANCHES_NONE;
    OK(tree_photo_session_set_branches(session, 0, &branches, NULL));
    OK(tree_photo_session_view_report(session, 0, NULL, &row));
    CHECK(!row.attracts && ran(session, "1333566"));
    OK(tree_attractor_free(graph));

    tree_particle_camera camera = a_camera(0.5f);
    tree_photo_placing placing;
    OK(tree_photo_placing_init(&placing, sizeof placing));
    placing.camera = &camera;
    OK(tree_photo_session_set_placing(session, 0, &placing));
    camera.struct_size = sizeof camera;
    OK(tree_photo_session_camera(session, 0, NULL, &camera));
    CHECK(camera.yaw == 0.5f && ran(session, "2333566"));
    OK(tree_photo_session_redo_from(session, TREE_PHOTO_STAGE_VIEWS));
    OK(tree_photo_session_camera(session, 0, NULL, &camera));
    CHECK(ran(session, "3333566"));

    tree_matte *wrong;
    static const float one[1];
    OK(tree_matte_from_alpha(1, 1, one, 1, NULL, &wrong));
    FAILS(TREE_ERROR_NO_RESULT, "size", tree_photo_session_set_matte(session, 0, wrong));
    OK(tree_matte_free(wrong));
}

static void controlled(tree_photo_session *session) {
    tree_tree *tree;
    tree_control control;
    tree_limits limits;
    OK(tree_control_init(&control, sizeof control));
    OK(tree_photo_session_redo_from(session, TREE_PHOTO_STAGE_DENSITY));
    uint32_t density = runs(session, TREE_PHOTO_STAGE_DENSITY);
    control.progress = stop;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_photo_session_tree(session, &control, NULL, &tree));
    /* What was done by then stays. */
    CHECK(tree == NULL && runs(session, TREE_PHOTO_STAGE_DENSITY) == density + 1);
    control.progress = call_again;
    control.user = session;
    OK(tree_photo_session_tree(session, &control, NULL, &tree));
    CHECK(runs(session, TREE_PHOTO_STAGE_DENSITY) == density + 1);
    OK(tree_tree_free(tree));

    control.progress = NULL;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.voxels = 10;
    control.limits = &limits;
    OK(tree_photo_session_redo_from(session, TREE_PHOTO_STAGE_DENSITY));
    FAILS(TREE_ERROR_LIMIT, "voxels", tree_photo_session_tree(session, &control, NULL, &tree));
    limits.voxels = 1 << 20;
    limits.nodes = 10;
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_photo_session_tree(session, &control, NULL, &tree));
    OK(tree_photo_session_tree(session, NULL, NULL, &tree));
    OK(tree_tree_free(tree));
}

/* With one photograph a side is imagined. */
static void one_photograph(tree_matte *matte, small *small) {
    tree_photo_shot shot;
    tree_photo_session *session;
    size_t n_views;
    tree_particle_camera camera = {.struct_size = sizeof camera};
    OK(tree_photo_shot_init(&shot, sizeof shot));
    shot.matte = matte;
    for (uint32_t imagine = 0; imagine < 2; imagine++) {
        small->params.imagine = imagine;
        OK(tree_photo_session_new(&shot, 1, &small->params, 7, NULL, &session));
        OK(tree_photo_session_count_views(session, NULL, &n_views));
        CHECK(n_views == 1 + imagine);
        tree_photo_view_report row = {.struct_size = sizeof row};
        if (imagine) {
            OK(tree_photo_session_camera(session, 1, NULL, &camera));
            OK(tree_photo_session_view_report(session, 1, NULL, &row));
            CHECK(row.residual > 0 && row.n_warnings == 0);
        } else {
            FAILS(TREE_ERROR_PARAMETER, "1 views",
                  tree_photo_session_view_report(session, 1, NULL, &row));
        }
        OK(tree_photo_session_free(session));
    }
    CHECK(fabsf(fabsf(camera.yaw) - 1.5707963f) < 1e-5f);
}

static void bad_pictures(void) {
    static const float nothing[WIDTH * HEIGHT];
    tree_matte *matte;
    tree_photo_shot shot;
    tree_tree *tree;
    OK(tree_matte_from_alpha(WIDTH, HEIGHT, nothing, WIDTH * HEIGHT, NULL, &matte));
    OK(tree_photo_shot_init(&shot, sizeof shot));
    shot.matte = matte;
    FAILS(TREE_ERROR_NO_RESULT, "views[0]", tree_from_photos(&shot, 1, NULL, 1, NULL, NULL, &tree));
    CHECK(tree == NULL);
    static const uint8_t pixels[4];
    tree_photo *photo;
    OK(tree_photo_from_pixels(1, 1, pixels, 4, NULL, &photo));
    shot.photo = photo;
    FAILS(TREE_ERROR_NO_RESULT, "one size", tree_from_photos(&shot, 1, NULL, 1, NULL, NULL, &tree));
    OK(tree_photo_free(photo));
    OK(tree_matte_free(matte));
}

void test_particle(void) {
    grids();
    tree_matte *matte = a_matte();
    strokes(matte);
    tree_particle_camera cameras[2] = {a_camera(0), a_camera(1.5707963f)};
    tree_particle_view views[2];
    for (int i = 0; i < 2; i++) {
        OK(tree_particle_view_init(&views[i], sizeof views[i]));
        views[i].matte = matte;
        views[i].camera = &cameras[i];
    }
    tree_grid *grid = densities(matte, views);
    tree_attractor *graph = a_graph();
    tree_direction_field *field = fields(graph);
    flows(grid, field, views);
    OK(tree_direction_field_free(field));
    OK(tree_attractor_free(graph));
    OK(tree_grid_free(grid));

    static small small;
    make_small(&small);
    tree_photo_session *session = a_session(matte, &small);
    stages(session);
    pictures(session);
    edits(session, &small, matte);
    controlled(session);
    OK(tree_photo_session_free(session));
    one_photograph(matte, &small);
    bad_pictures();
    OK(tree_matte_free(matte));
}
