#include "crown.h"
#include <math.h>

/* Plain: to draw the built-in textures takes longest, under valgrind minutes. */
static tree_hybrid *a_hybrid(const tree_tree *tree) {
    tree_look *look = NULL;
    tree_hybrid_params params;
    tree_leaf_box_params boxes;
    tree_card_params cards;
    tree_metric_params metric;
    tree_hybrid *hybrid = NULL;
    OK(tree_hybrid_params_init(&params, sizeof params));
    OK(tree_leaf_box_params_init(&boxes, sizeof boxes));
    OK(tree_card_params_init(&cards, sizeof cards));
    OK(tree_metric_params_init(&metric, sizeof metric));
    OK(tree_look_of_tree(tree, 1, &look));
    CHECK(params.wood_pixels == 0.5f && params.cards == NULL && params.seed == 0);
    OK(tree_hybrid_params_check(&params));
    boxes.least_leaves = 10;
    boxes.least_volume = 0.001;
    cards.size = 16;
    cards.samples = 2;
    metric.metric = TREE_METRIC_LONGEST_PATH;
    params.boxes = &boxes;
    params.cards = &cards;
    params.metric = &metric;
    params.wood_pixels = 0;
    FAILS(TREE_ERROR_PARAMETER, "wood_pixels", tree_hybrid_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "wood_pixels", tree_hybrid_make(tree, look, &params, NULL, &hybrid));
    params.wood_pixels = 0.5f;
    metric.metric = 99;
    FAILS(TREE_ERROR_ENUM, "TREE_METRIC_", tree_hybrid_params_check(&params));
    metric.metric = TREE_METRIC_LONGEST_PATH;
    cards.size = 15;
    FAILS(TREE_ERROR_PARAMETER, "cards.size", tree_hybrid_make(tree, look, &params, NULL, &hybrid));
    CHECK(hybrid == NULL);
    cards.size = 16;
    OK(tree_hybrid_make(tree, look, &params, NULL, &hybrid));
    OK(tree_look_free(look));
    return hybrid;
}

/* Parts are those of the model, and stay when it is gone. */
static void parts(const tree_tree *tree) {
    tree_hybrid *hybrid = a_hybrid(tree);
    tree_multires *multires = NULL;
    tree_multi_mesh *wood = NULL;
    tree_mesh *mesh = NULL;
    tree_cards *cards = NULL;
    tree_hybrid_totals totals = {.struct_size = sizeof totals};
    OK(tree_hybrid_measure(hybrid, &totals));
    CHECK(totals.n_levels == TIPS && totals.n_surfaces == 2 && totals.n_leaves == LEAVES);
    CHECK(totals.n_boxes > 1);
    OK(tree_hybrid_multires(hybrid, &multires));
    OK(tree_hybrid_wood(hybrid, &wood));
    OK(tree_hybrid_mesh(hybrid, &mesh));
    OK(tree_hybrid_cards(hybrid, &cards));
    OK(tree_hybrid_free(hybrid));
    size_t n_levels = 0;
    OK(tree_multires_count(multires, &n_levels));
    CHECK(n_levels == TIPS);
    tree_multi_mesh_totals of_wood = {.struct_size = sizeof of_wood};
    OK(tree_multi_mesh_measure(wood, &of_wood));
    CHECK(of_wood.n_levels == TIPS && of_wood.n_triangles == totals.n_triangles);
    tree_mesh_totals of_mesh = {.struct_size = sizeof of_mesh};
    OK(tree_mesh_measure(mesh, &of_mesh));
    CHECK(of_mesh.n_triangles == totals.n_triangles);
    tree_cards_report report = {.struct_size = sizeof report};
    OK(tree_cards_measure(cards, &report));
    CHECK(report.n_boxes == totals.n_boxes && report.size == 16);
    OK(tree_multires_free(multires));
    OK(tree_multi_mesh_free(wood));
    OK(tree_mesh_free(mesh));
    OK(tree_cards_free(cards));
}

/* From afar to close by: ever more wood, and each leaf drawn once, in one window. */
static void choices(const tree_hybrid *hybrid) {
    tree_hybrid_totals totals = {.struct_size = sizeof totals};
    OK(tree_hybrid_measure(hybrid, &totals));
    tree_hybrid_choice *choice = NULL;
    tree_hybrid_choice_report report = {.struct_size = sizeof report}, again = report;
    OK(tree_hybrid_choice_new(hybrid, &choice));
    OK(tree_hybrid_choice_measure(choice, &report));
    CHECK(report.level == 1 && report.n_boxes == 0 && report.n_leaves == 0);
    tree_leaf_range ranges[64];
    uint32_t boxes[64];
    float eye[] = {20000, 3, 0}, last = 0;
    for (; eye[0] > 1; eye[0] *= 0.6f, last = report.level) {
        OK(tree_hybrid_choice_update(choice, eye, 800, &report));
        OK(tree_hybrid_choice_boxes(choice, boxes, totals.n_boxes));
        OK(tree_hybrid_choice_ranges(choice, ranges, totals.n_boxes));
        uint64_t n = report.wood_indices / 3 + 12 * report.n_boxes;
        size_t leaves = 0;
        for (size_t i = 0; i < report.n_ranges; i++) {
            tree_index_window window = {1, 1};
            OK(tree_hybrid_leaf_window(hybrid, 1, ranges[i].first, ranges[i].n_leaves, &window));
            n += window.index_count / 3;
            leaves += ranges[i].n_leaves;
            OK(tree_hybrid_leaf_window(hybrid, 0, ranges[i].first, ranges[i].n_leaves, &window));
            CHECK(window.first_index == 0 && window.index_count == 0);
        }
        CHECK(n == report.n_triangles && leaves == report.n_leaves && report.level >= last);
        CHECK(report.n_boxes > 0 || leaves == LEAVES);
    }
    CHECK(report.level == TIPS && report.n_triangles == totals.n_triangles);
    FAILS(TREE_ERROR_BUFFER, "ranges", tree_hybrid_choice_ranges(choice, ranges, 0));
    FAILS(TREE_ERROR_PARAMETER, "pixels_per_metre", tree_hybrid_choice_update(choice, eye, 0, NULL));
    eye[1] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "", tree_hybrid_choice_update(choice, eye, 800, NULL));
    OK(tree_hybrid_choice_measure(choice, &again));
    CHECK(memcmp(&again, &report, sizeof report) == 0);
    OK(tree_hybrid_choice_free(choice));
    tree_index_window window;
    FAILS(TREE_ERROR_PARAMETER, "2 surfaces", tree_hybrid_leaf_window(hybrid, 2, 0, 1, &window));
    OK(tree_hybrid_leaf_window(hybrid, 1, UINT32_MAX, UINT32_MAX, &window));
    CHECK(window.index_count == 0);
    float few = 0, many = 0;
    OK(tree_hybrid_level(hybrid, 0.01f, &few));
    OK(tree_hybrid_level(hybrid, INFINITY, &many));
    CHECK(few == 1 && many == TIPS);
    FAILS(TREE_ERROR_PARAMETER, "pixels_per_metre", tree_hybrid_level(hybrid, NAN, &few));
}

/* What is chosen as a mesh; the choice keeps its model alive. */
static void meshes(const tree_tree *tree) {
    tree_hybrid *hybrid = a_hybrid(tree);
    tree_hybrid_totals all = {.struct_size = sizeof all};
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    tree_hybrid_choice *near = NULL, *far = NULL, *none = NULL;
    tree_mesh *mesh = NULL;
    OK(tree_hybrid_measure(hybrid, &all));
    OK(tree_hybrid_choice_for_height(hybrid, 1e5f, &near));
    OK(tree_hybrid_choice_for_height(hybrid, 4, &far));
    FAILS(TREE_ERROR_PARAMETER, "pixels", tree_hybrid_choice_for_height(hybrid, -1, &none));
    CHECK(none == NULL);
    OK(tree_hybrid_free(hybrid));
    OK(tree_hybrid_choice_mesh(near, NULL, &mesh));
    OK(tree_mesh_measure(mesh, &totals));
    CHECK(totals.n_triangles == all.n_triangles);
    OK(tree_mesh_free(mesh));
    OK(tree_hybrid_choice_mesh(far, NULL, &mesh));
    OK(tree_mesh_measure(mesh, &totals));
    CHECK(totals.n_triangles > 0 && totals.n_triangles < all.n_triangles / 2);
    OK(tree_mesh_free(mesh));
    OK(tree_hybrid_choice_free(near));
    OK(tree_hybrid_choice_free(far));
}

static void files(const tree_hybrid *hybrid) {
    static const float heights[] = {400, 50, 8}, rising[] = {8, 50};
    tree_bytes *bytes = NULL, *none = NULL;
    const uint8_t *data = NULL;
    size_t len = 0;
    OK(tree_hybrid_to_glb_levels(hybrid, heights, 3, 1080, NULL, NULL, &bytes));
    OK(tree_bytes_view(bytes, &data, &len));
    CHECK(len > 1000 && memcmp(data, "glTF", 4) == 0);
    const char *folder = getenv("TREE_TEST_DIR");
    char path[4096];
    snprintf(path, sizeof path, "%s/tree_test_hybrid.glb", folder ? folder : ".");
    OK(tree_hybrid_write_glb_levels(hybrid, heights, 3, 1080, path, TREE_NUL_TERMINATED, NULL, NULL));
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL);
    if (file) {
        CHECK(fseek(file, 0, SEEK_END) == 0 && ftell(file) == (long)len);
        fclose(file);
    }
    CHECK(remove(path) == 0);
    OK(tree_bytes_free(bytes));
    FAILS(TREE_ERROR_INVALID, "fall", tree_hybrid_to_glb_levels(hybrid, rising, 2, 1080, NULL, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "fall", tree_hybrid_to_glb_levels(hybrid, NULL, 0, 1080, NULL, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "screen", tree_hybrid_to_glb_levels(hybrid, heights, 3, 0, NULL, NULL, &none));
    CHECK(none == NULL);
}

static void without_leaves(void) {
    tree_skeleton *skeleton = a_forked_tree();
    tree_tree *bare = NULL;
    tree_hybrid *hybrid = NULL;
    tree_cards *cards = NULL;
    tree_hybrid_choice *choice = NULL;
    tree_hybrid_choice_report report = {.struct_size = sizeof report};
    static const float eye[] = {30, 2, 0};
    OK(tree_tree_new(skeleton, NULL, NULL, NULL, &bare));
    OK(tree_skeleton_free(skeleton));
    OK(tree_hybrid_make(bare, NULL, NULL, NULL, &hybrid));
    FAILS(TREE_ERROR_NO_RESULT, "no leaves", tree_hybrid_cards(hybrid, &cards));
    CHECK(cards == NULL);
    OK(tree_hybrid_choice_new(hybrid, &choice));
    OK(tree_hybrid_choice_update(choice, eye, 1000, &report));
    CHECK(report.n_boxes == 0 && report.n_ranges == 0 && report.wood_indices > 0);
    OK(tree_hybrid_choice_boxes(choice, NULL, 0));
    OK(tree_hybrid_choice_ranges(choice, NULL, 0));
    OK(tree_hybrid_choice_free(choice));
    OK(tree_hybrid_free(hybrid));
    OK(tree_tree_free(bare));
}

static void limited(const tree_tree *tree) {
    tree_limits limits;
    tree_control control;
    tree_hybrid *none = NULL;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&control, sizeof control));
    limits.pixels = 100;
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_hybrid_make(tree, NULL, NULL, &control, &none));
    CHECK(none == NULL);
}

void test_hybrid(void) {
    tree_tree *tree = a_leafy_tree();
    parts(tree);
    limited(tree);
    meshes(tree);
    tree_hybrid *hybrid = a_hybrid(tree);
    OK(tree_tree_free(tree));
    choices(hybrid);
    files(hybrid);
    OK(tree_hybrid_free(hybrid));
    without_leaves();
}
