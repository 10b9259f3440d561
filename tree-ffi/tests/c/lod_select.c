#include "check.h"
#include <math.h>

enum { LEVELS = 16, PARTS = 2, TREES = 40, WIDTH = 64, HEIGHT = 36 };

/* A ball of 2 m: a trunk that is always drawn, and leaves of LEVELS levels. */
static tree_scene_model a_model(void) {
    static float samples[24], lambdas[LEVELS], scales[LEVELS];
    static tree_scene_draw draws[LEVELS * PARTS];
    static const tree_scene_occluder core = {{0, 0, 0}, {1.8f, 1.8f, 1.8f}};
    static tree_lod_distance distance;
    for (int i = 0; i < 24; i++) samples[i] = (i % 3 == i / 3 % 3 ? 2.0f : 0.0f) * (i < 12 ? 1.0f : -1.0f);
    for (int i = 0; i < LEVELS; i++) {
        lambdas[i] = (float)(i + 1) / LEVELS;
        scales[i] = 1 / lambdas[i];
        draws[PARTS * i] = (tree_scene_draw){0, 30, 0};
        draws[PARTS * i + 1] = (tree_scene_draw){30, (uint32_t)(300 * (i + 1)), 7};
    }
    OK(tree_lod_distance_cook(&distance));
    tree_scene_model model;
    OK(tree_scene_model_init(&model, sizeof model));
    CHECK(model.near == 10 && model.far == 500 && model.n_levels == 0);
    FAILS(TREE_ERROR_INVALID, "levels", tree_scene_model_check(&model));
    model.samples = samples;
    model.n_samples = 8;
    model.occluders = &core;
    model.n_occluders = 1;
    model.distance = &distance;
    model.lambdas = lambdas;
    model.scales = scales;
    model.n_levels = LEVELS;
    model.draws = draws;
    model.n_parts = PARTS;
    model.radius = 2;
    model.near = 5;
    model.far = 400;
    OK(tree_scene_model_check(&model));
    return model;
}

static void bad_models(const tree_scene_model *good) {
    static const float falling[LEVELS] = {0.5f, 0.4f};
    tree_scene_model model = *good;
    model.radius = NAN;
    FAILS(TREE_ERROR_INVALID, "radius", tree_scene_model_check(&model));
    model = *good;
    model.lambdas = falling;
    FAILS(TREE_ERROR_INVALID, "lambda must rise", tree_scene_model_check(&model));
    model.lambdas = NULL;
    FAILS(TREE_ERROR_NULL, "model.lambdas", tree_scene_model_check(&model));
    model = *good;
    model.draws = NULL;
    FAILS(TREE_ERROR_NULL, "model.draws", tree_scene_model_check(&model));
    model.n_parts = 65;
    FAILS(TREE_ERROR_PARAMETER, "n_parts", tree_scene_model_check(&model));
    model.n_levels = 1025;
    FAILS(TREE_ERROR_PARAMETER, "lambdas", tree_scene_model_check(&model));
    model.n_samples = 65;
    FAILS(TREE_ERROR_PARAMETER, "samples", tree_scene_model_check(&model));
    model = *good;
    static const float fades[LEVELS] = {0.1f, 2};
    model.fades = fades;
    FAILS(TREE_ERROR_INVALID, "fade", tree_scene_model_check(&model));
    model.fades = NULL;
    model.scales = NULL;
    model.distance = NULL;
    OK(tree_scene_model_check(&model));
    FAILS(TREE_ERROR_NULL, "model", tree_scene_model_check(NULL));
}

static tree_scene_instance at(float x, float z) {
    return (tree_scene_instance){.position = {x, 0, z}, .rotation = {0, 0, 0, 1}, .scale = 1};
}

/* From the origin along -Z: perspective, depth from 0 to 1, not reversed. */
static tree_scene_frame a_frame(void) {
    tree_scene_frame frame;
    OK(tree_scene_frame_init(&frame, sizeof frame));
    CHECK(frame.occlusion == TREE_SCENE_OCCLUSION_NONE && frame.seconds == 0);
    const float near = 0.1f, far = 1000, half = 0.5773503f;
    for (int i = 0; i < 4; i++) frame.view[5 * i] = 1;
    frame.projection[0] = 9 / (16 * half);
    frame.projection[5] = 1 / half;
    frame.projection[10] = far / (near - far);
    frame.projection[11] = -1;
    frame.projection[14] = far * near / (near - far);
    frame.seconds = 0.016f;
    return frame;
}

static void bad_scenes(const tree_scene_model *model) {
    tree_scene_instance instances[2] = {at(0, -20), at(0, -30)};
    tree_scene *scene = NULL;
    instances[1].model = 1;
    FAILS(TREE_ERROR_INVALID, "instance 1", tree_scene_new(model, 1, instances, 2, NULL, &scene));
    instances[1].model = 0;
    instances[1].position[0] = NAN;
    FAILS(TREE_ERROR_INVALID, "position", tree_scene_new(model, 1, instances, 2, NULL, &scene));
    instances[1] = at(0, 0);
    instances[1].rotation[3] = 0;
    FAILS(TREE_ERROR_INVALID, "rotation", tree_scene_new(model, 1, instances, 2, NULL, &scene));
    FAILS(TREE_ERROR_NULL, "instances", tree_scene_new(model, 1, NULL, 2, NULL, &scene));
    FAILS(TREE_ERROR_NULL, "models", tree_scene_new(NULL, 1, instances, 2, NULL, &scene));
    CHECK(scene == NULL);
}

static void bad_frames(tree_scene *scene, tree_scene_state *state) {
    static float depths[WIDTH * HEIGHT];
    tree_scene_frame frame = a_frame();
    tree_scene_params params;
    uint32_t is_reversed = 7;
    OK(tree_scene_eye_check(frame.view, frame.projection, &is_reversed));
    CHECK(is_reversed == 0);
    frame.view[3] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "view", tree_scene_eye_check(frame.view, frame.projection, &is_reversed));
    FAILS(TREE_ERROR_PARAMETER, "view", tree_scene_state_select(state, scene, &frame, NULL, NULL));
    frame = a_frame();
    frame.projection[0] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "projection", tree_scene_state_select(state, scene, &frame, NULL, NULL));
    frame = a_frame();
    frame.seconds = -1;
    FAILS(TREE_ERROR_PARAMETER, "seconds", tree_scene_state_select(state, scene, &frame, NULL, NULL));
    FAILS(TREE_ERROR_NULL, "frame", tree_scene_state_select(state, scene, NULL, NULL, NULL));
    FAILS(TREE_ERROR_NULL, "scene", tree_scene_state_select(state, NULL, &frame, NULL, NULL));
    frame = a_frame();
    frame.occlusion = 3;
    FAILS(TREE_ERROR_ENUM, "TREE_SCENE_OCCLUSION_",
          tree_scene_state_select(state, scene, &frame, NULL, NULL));
    frame.occlusion = TREE_SCENE_OCCLUSION_DEPTH;
    frame.depths = depths;
    frame.n_depths = WIDTH * HEIGHT - 1;
    frame.depth_width = WIDTH;
    frame.depth_height = HEIGHT;
    FAILS(TREE_ERROR_INVALID, "depth buffer", tree_scene_state_select(state, scene, &frame, NULL, NULL));
    frame.n_depths++;
    FAILS(TREE_ERROR_PARAMETER, "view", tree_scene_state_select(state, scene, &frame, NULL, NULL));
    frame.depths = NULL;
    FAILS(TREE_ERROR_NULL, "frame.depths", tree_scene_state_select(state, scene, &frame, NULL, NULL));
    OK(tree_scene_params_init(&params, sizeof params));
    CHECK(params.hidden == 0.1f && params.band == 0.05f);
    OK(tree_scene_params_check(&params));
    params.band = 2;
    FAILS(TREE_ERROR_PARAMETER, "band", tree_scene_params_check(&params));
    frame = a_frame();
    FAILS(TREE_ERROR_PARAMETER, "band", tree_scene_state_select(state, scene, &frame, &params, NULL));
}

/* Depths of a wall close to the eye hide all; of none, nothing. */
static void occlusion(tree_scene *scene, tree_scene_state *state) {
    static float depths[WIDTH * HEIGHT];
    tree_scene_frame frame = a_frame();
    tree_scene_report report = {.struct_size = sizeof report};
    frame.occlusion = TREE_SCENE_OCCLUSION_DEPTH;
    frame.depths = depths;
    frame.n_depths = WIDTH * HEIGHT;
    frame.depth_width = WIDTH;
    frame.depth_height = HEIGHT;
    frame.cut = 1;
    memcpy(frame.depth_view, frame.view, sizeof frame.view);
    memcpy(frame.depth_projection, frame.projection, sizeof frame.view);
    OK(tree_scene_state_select(state, scene, &frame, NULL, &report));
    CHECK(report.n_hidden == report.n_drawn && report.n_drawn > 0);
    uint64_t few = report.n_indices;
    for (int i = 0; i < WIDTH * HEIGHT; i++) depths[i] = 1;
    OK(tree_scene_state_select(state, scene, &frame, NULL, &report));
    CHECK(report.n_hidden == 0 && report.n_occluded == 0 && report.n_indices > few);
    CHECK(report.n_triangles == report.n_indices / 3);
    frame.occlusion = TREE_SCENE_OCCLUSION_BUILT_IN;
    OK(tree_scene_state_select(state, scene, &frame, NULL, &report));
    CHECK(report.n_hidden > 0 && report.n_hidden < report.n_drawn);
}

/* What is written says the same as what was selected. */
static void frames(tree_scene *scene, tree_scene_state *state) {
    tree_draw_indexed draws[TREES * PARTS], batches[TREES * PARTS];
    tree_instance_lod rows[TREES];
    tree_scene_frame frame = a_frame();
    tree_scene_report report = {.struct_size = sizeof report};
    size_t n_draws = 0, n_rows = 0, n_drawn = 0, n_batches = 0;
    CHECK(sizeof *draws == 20 && sizeof *rows == 20);
    frame.cut = 1;
    OK(tree_scene_state_select(state, scene, &frame, NULL, &report));
    CHECK(report.n_drawn == TREES - 1 && report.n_culled == 1);
    OK(tree_scene_state_count_drawn(state, &n_drawn));
    CHECK(n_drawn == report.n_drawn);
    OK(tree_scene_state_draws(state, scene, draws, TREES * PARTS, rows, TREES, &n_draws, &n_rows));
    CHECK(n_rows == report.n_drawn && n_draws == PARTS * n_rows);
    uint64_t indices = 0;
    for (size_t i = 0; i < n_draws; i++) {
        indices += draws[i].index_count;
        CHECK(draws[i].instance_count == 1 && draws[i].first_instance == i / PARTS);
        CHECK(draws[i].base_vertex == (i % PARTS ? 7 : 0) && draws[i].first_index == (i % PARTS ? 30 : 0));
    }
    CHECK(indices == report.n_indices);
    for (size_t i = 0; i < n_rows; i++) {
        tree_scene_shown shown;
        OK(tree_scene_state_shown(state, scene, rows[i].instance, &shown));
        CHECK(shown.in_view == 1 && shown.lambda == rows[i].lambda && shown.visible == 1);
        CHECK(draws[PARTS * i + 1].index_count == 300 * (shown.level + 1));
        CHECK(rows[i].scale >= 1 && rows[i].contrast > 0 && rows[i].contrast <= 1);
    }
    tree_scene_shown shown;
    OK(tree_scene_state_shown(state, scene, TREES - 1, &shown));
    CHECK(shown.in_view == 0);
    OK(tree_scene_state_shown(state, scene, SIZE_MAX, &shown));
    CHECK(shown.in_view == 0);

    OK(tree_scene_state_batches(state, scene, batches, TREES * PARTS, rows, TREES, &n_batches, &n_rows));
    CHECK(n_batches <= LEVELS * PARTS && n_batches < n_draws && n_rows == report.n_drawn);
    uint64_t in_batches = 0;
    for (size_t i = 0; i < n_batches; i++)
        in_batches += (uint64_t)batches[i].index_count * batches[i].instance_count;
    CHECK(in_batches == indices);

    /* Buffers that are too small stay as they are. */
    memset(draws, 0xee, sizeof draws);
    FAILS(TREE_ERROR_BUFFER, "draws needed: 78",
          tree_scene_state_draws(state, scene, draws, 5, rows, TREES, &n_draws, &n_rows));
    FAILS(TREE_ERROR_BUFFER, "instances needed: 39",
          tree_scene_state_draws(state, scene, draws, TREES * PARTS, rows, 38, &n_draws, &n_rows));
    FAILS(TREE_ERROR_BUFFER, "draws needed",
          tree_scene_state_batches(state, scene, draws, 1, rows, TREES, &n_draws, &n_rows));
    CHECK(draws[0].index_count == 0xeeeeeeee && draws[0].first_instance == 0xeeeeeeee);
    FAILS(TREE_ERROR_NULL, "rows",
          tree_scene_state_draws(state, scene, draws, TREES * PARTS, NULL, TREES, &n_draws, &n_rows));
    FAILS(TREE_ERROR_NULL, "n_rows",
          tree_scene_state_draws(state, scene, draws, TREES * PARTS, rows, TREES, &n_draws, NULL));
    FAILS(TREE_ERROR_INVALID, "draws is not aligned",
          tree_scene_state_draws(state, scene, (tree_draw_indexed *)(void *)((char *)draws + 1), 5,
                                 rows, TREES, &n_draws, &n_rows));
}

/* A thousand frames take no memory. */
static void memory_stays(tree_scene *scene, tree_scene_state *state) {
    static tree_draw_indexed draws[TREES * PARTS];
    static tree_instance_lod rows[TREES];
    tree_scene_frame frame = a_frame();
    size_t n_draws, n_rows;
    frame.occlusion = TREE_SCENE_OCCLUSION_BUILT_IN;
    uint64_t before = tree_memory_used();
    tree_memory_reset_peak();
    for (int i = 0; i < 1000; i++) {
        frame.view[14] = -0.1f * (float)(i % 300);
        OK(tree_scene_state_select(state, scene, &frame, NULL, NULL));
        OK(tree_scene_state_draws(state, scene, draws, TREES * PARTS, rows, TREES, &n_draws, &n_rows));
        OK(tree_scene_state_batches(state, scene, draws, TREES * PARTS, rows, TREES, &n_draws, &n_rows));
    }
    CHECK(tree_memory_used() == before && tree_memory_peak() == before);
}

void test_lod_select(void) {
    tree_scene_model model = a_model();
    bad_models(&model);
    bad_scenes(&model);
    /* Rows of trees ahead, each behind the one before; the last stands behind the eye. */
    tree_scene_instance trees[TREES];
    for (int i = 0; i < TREES; i++) trees[i] = at((float)(i % 4) - 1.5f, -15.0f - 8.0f * (float)(i / 4));
    trees[TREES - 1] = at(0, 50);
    tree_scene *scene = NULL, *small = NULL, *empty = NULL;
    OK(tree_scene_new(&model, 1, trees, TREES, NULL, &scene));
    tree_scene_needs needs = {.struct_size = sizeof needs};
    OK(tree_scene_measure(scene, &needs));
    CHECK(needs.n_instances == TREES && needs.most_draws == TREES * PARTS);
    CHECK(needs.most_indices == TREES * (30 + 300 * LEVELS));
    tree_scene_state *state = NULL;
    OK(tree_scene_state_new(scene, NULL, &state));
    bad_frames(scene, state);
    frames(scene, state);
    occlusion(scene, state);
    memory_stays(scene, state);

    trees[TREES - 1] = at(0, -40);
    FAILS(TREE_ERROR_INVALID, "instance", tree_scene_set_instances(scene, 1, trees, TREES));
    OK(tree_scene_set_instances(scene, TREES - 1, &trees[TREES - 1], 1));
    OK(tree_scene_set_instances(scene, 0, trees, TREES));
    tree_scene_frame frame = a_frame();
    tree_scene_report report = {.struct_size = sizeof report};
    OK(tree_scene_state_select(state, scene, &frame, NULL, &report));
    CHECK(report.n_culled == 0);
    trees[0].scale = NAN;
    FAILS(TREE_ERROR_INVALID, "scale", tree_scene_set_instances(scene, 0, trees, 1));

    OK(tree_scene_new(&model, 1, trees + 1, 1, NULL, &small));
    FAILS(TREE_ERROR_INVALID, "state", tree_scene_state_select(state, small, &frame, NULL, &report));
    OK(tree_scene_free(small));
    OK(tree_scene_new(NULL, 0, NULL, 0, NULL, &empty));
    OK(tree_scene_free(empty));
    OK(tree_scene_free(scene));
    OK(tree_scene_state_free(state));
}
