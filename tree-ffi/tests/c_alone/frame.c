/* A frame of a scene takes no memory: a host's allocator is not asked, not even for what is given back at once. */
#include "../c/check.h"

int n_failures = 0;

static size_t n_calls;

static void *give(void *user, size_t size, size_t align) {
    (void)user;
    n_calls++;
    if (align < sizeof(void *)) align = sizeof(void *);
    return aligned_alloc(align, (size + align - 1) / align * align);
}

static void take(void *user, void *block, size_t size, size_t align) {
    (void)user, (void)size, (void)align;
    free(block);
}

enum { TREES = 500, WIDTH = 64, HEIGHT = 36 };

int main(void) {
    tree_allocator allocator = {sizeof allocator, NULL, give, take};
    OK(tree_memory_set_allocator(&allocator));
    static const float lambdas[] = {0.1f, 1}, samples[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const tree_scene_draw draws_of_levels[] = {{0, 300, 0}, {300, 3000, 0}};
    static const tree_scene_occluder core = {{0, 0, 0}, {1, 1, 1}};
    static tree_scene_instance trees[TREES];
    static tree_draw_indexed draws[TREES];
    static tree_instance_lod rows[TREES];
    static float depths[WIDTH * HEIGHT];
    tree_scene_model model;
    OK(tree_scene_model_init(&model, sizeof model));
    model.lambdas = lambdas;
    model.draws = draws_of_levels;
    model.n_levels = 2;
    model.n_parts = 1;
    model.samples = samples;
    model.n_samples = 4;
    model.occluders = &core;
    model.n_occluders = 1;
    for (int i = 0; i < TREES; i++) {
        trees[i].position[0] = (float)(i % 20) * 6 - 60;
        trees[i].position[2] = (float)(i / 20) * -8 - 5;
        trees[i].rotation[3] = trees[i].scale = 1;
    }
    tree_scene *scene = NULL;
    tree_scene_state *state = NULL;
    OK(tree_scene_new(&model, 1, trees, TREES, NULL, &scene));
    OK(tree_scene_state_new(scene, NULL, &state));

    tree_scene_frame frame;
    OK(tree_scene_frame_init(&frame, sizeof frame));
    for (int i = 0; i < 4; i++) frame.view[5 * i] = 1;
    /* 90 degrees, depth from 0 to 1 between 0.1 m and 1000 m. */
    frame.projection[0] = frame.projection[5] = 1;
    frame.projection[10] = 1000 / (0.1f - 1000);
    frame.projection[11] = -1;
    frame.projection[14] = 100 / (0.1f - 1000);
    frame.seconds = 0.016f;
    frame.depths = depths;
    frame.n_depths = WIDTH * HEIGHT;
    frame.depth_width = WIDTH;
    frame.depth_height = HEIGHT;
    memcpy(frame.depth_view, frame.view, sizeof frame.view);
    memcpy(frame.depth_projection, frame.projection, sizeof frame.view);
    tree_scene_report report = {.struct_size = sizeof report};
    size_t n_draws = 0, n_rows = 0, before = n_calls;
    CHECK(before > 0);
    for (uint32_t i = 0; i < 300; i++) {
        frame.occlusion = i % 3;
        frame.view[14] = 0.5f * (float)i;
        OK(tree_scene_state_select(state, scene, &frame, NULL, &report));
        OK(tree_scene_state_draws(state, scene, draws, TREES, rows, TREES, &n_draws, &n_rows));
        CHECK(n_rows == report.n_drawn && n_draws == n_rows);
        OK(tree_scene_state_batches(state, scene, draws, TREES, rows, TREES, &n_draws, &n_rows));
        CHECK(n_rows == report.n_drawn);
    }
    CHECK(n_calls == before);
    OK(tree_scene_set_instances(scene, 7, trees, 1));
    CHECK(n_calls == before);
    OK(tree_scene_free(scene));
    OK(tree_scene_state_free(state));
    printf(n_failures ? "%d failures\n" : "all is well\n", n_failures);
    return n_failures != 0;
}
