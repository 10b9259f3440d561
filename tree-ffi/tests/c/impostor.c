#include "crown.h"
#include <math.h>

static void bearers_of_a_tree(void) {
    tree_tree *tree = an_oak_twig();
    tree_look *look = NULL;
    tree_mesh *mesh = NULL;
    tree_elements *leaves = NULL;
    uint32_t bearers[3] = {9, 9, 9};
    OK(tree_look_plain(NULL, &look));
    OK(tree_mesh_build(tree, look, NULL, NULL, NULL, &mesh));
    OK(tree_elements_of_mesh(mesh, NULL, 0, TREE_GRAIN_LEAF, NULL, &leaves));
    OK(tree_leaf_bearers_of_tree(tree, mesh, leaves, bearers, 3));
    CHECK(bearers[0] == 2 && bearers[1] == 3 && bearers[2] == 3);
    FAILS(TREE_ERROR_BUFFER, "bearers", tree_leaf_bearers_of_tree(tree, mesh, leaves, bearers, 2));
    OK(tree_elements_free(leaves));
    OK(tree_elements_of_mesh(mesh, NULL, 0, TREE_GRAIN_TRIANGLE, NULL, &leaves));
    uint32_t many[64];
    FAILS(TREE_ERROR_INVALID, "whole leaves", tree_leaf_bearers_of_tree(tree, mesh, leaves, many, 64));
    OK(tree_elements_free(leaves));
    OK(tree_mesh_free(mesh));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
}

static tree_leaf_boxes *grown(const tree_skeleton *skeleton, const tree_mesh *mesh,
                              const tree_elements *elements) {
    static uint32_t bearers[LEAVES];
    OK(tree_leaf_bearers_nearest(skeleton, elements, NULL, bearers, LEAVES));
    for (int i = 0; i < LEAVES; i++) CHECK(bearers[i] >= 3 && bearers[i] < NODES);
    FAILS(TREE_ERROR_BUFFER, "bearers",
          tree_leaf_bearers_nearest(skeleton, elements, NULL, bearers, LEAVES - 1));
    tree_leaf_box_params params;
    OK(tree_leaf_box_params_init(&params, sizeof params));
    CHECK(params.levels == 4 && params.least_leaves == 24 && params.most_boxes == 64);
    OK(tree_leaf_box_params_check(&params));
    tree_leaf_boxes_report report = {.struct_size = sizeof report};
    tree_leaf_boxes *boxes = NULL, *none = NULL;
    params.least_volume = 2;
    FAILS(TREE_ERROR_PARAMETER, "boxes.least_volume", tree_leaf_box_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "boxes.least_volume",
          tree_leaf_boxes_along(skeleton, mesh, elements, bearers, LEAVES, &params, NULL, NULL, &none));
    params.least_volume = 0.001;
    params.least_leaves = 10;
    FAILS(TREE_ERROR_INVALID, "bearers",
          tree_leaf_boxes_along(skeleton, mesh, elements, bearers, 3, &params, NULL, NULL, &none));
    CHECK(none == NULL);
    OK(tree_leaf_boxes_along(skeleton, mesh, elements, bearers, LEAVES, &params, NULL, &report, &boxes));
    CHECK(report.n_leaves == LEAVES && report.n_boxes > 3 && report.n_levels >= 2);
    bearers[0] = NODES;
    FAILS(TREE_ERROR_INVALID, "lacks",
          tree_leaf_boxes_along(skeleton, mesh, elements, bearers, LEAVES, &params, NULL, NULL, &none));
    return boxes;
}

static size_t looked_at(const tree_leaf_boxes *boxes) {
    tree_leaf_boxes_report report = {.struct_size = sizeof report};
    OK(tree_leaf_boxes_measure(boxes, &report));
    tree_leaf_box row = {.struct_size = sizeof row};
    size_t own = 0, n_leaves = 0;
    for (uint32_t i = 0; i < report.n_boxes; i++) {
        OK(tree_leaf_boxes_get(boxes, i, &row));
        CHECK(i ? row.parent < i && row.level > 0 : row.parent == TREE_NO_BOX && row.n_leaves == LEAVES);
        CHECK(row.n_own <= row.n_leaves && row.first_child + row.n_children <= report.n_boxes);
        CHECK(fabs(row.volume - 8.0 * (double)row.half[0] * (double)row.half[1] * (double)row.half[2]) <
              1e-4 * row.volume);
        own += row.n_own;
    }
    CHECK(own == LEAVES);
    FAILS(TREE_ERROR_PARAMETER, "number is 99", tree_leaf_boxes_get(boxes, 99, &row));
    const uint32_t *order = NULL;
    OK(tree_leaf_boxes_order(boxes, &order, &n_leaves));
    CHECK(n_leaves == LEAVES);
    int seen[LEAVES] = {0}, once = 1;
    for (size_t i = 0; i < n_leaves; i++) seen[order[i]]++;
    for (int i = 0; i < LEAVES; i++) once &= seen[i] == 1;
    CHECK(once);

    OK(tree_leaf_boxes_get(boxes, 0, &row));
    float metres = -1, far[3] = {row.center[0], row.center[1] + 100, row.center[2]};
    OK(tree_leaf_boxes_distance(boxes, 0, row.center, &metres));
    CHECK(metres == 0);
    OK(tree_leaf_boxes_distance(boxes, 0, far, &metres));
    CHECK(metres > 90 && metres < 100);
    tree_card_plane planes[TREE_CARD_PLANES];
    OK(tree_leaf_boxes_planes(boxes, 0, planes, TREE_CARD_PLANES));
    for (uint32_t i = 0; i < TREE_CARD_PLANES; i++) {
        const float *a = planes[i].right, *b = planes[i].normal;
        CHECK(fabsf(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) < 1e-5f);
        CHECK(planes[i].reach > 0 && fabsf(planes[i].half[1] - row.half[i / 2]) < 1e-4f);
        CHECK(memcmp(planes[i].center, row.center, sizeof row.center) == 0);
    }
    FAILS(TREE_ERROR_BUFFER, "planes", tree_leaf_boxes_planes(boxes, 0, planes, 5));
    FAILS(TREE_ERROR_PARAMETER, "99", tree_leaf_boxes_planes(boxes, 99, planes, 6));
    return report.n_boxes;
}

static tree_cards *baked(const tree_mesh *mesh, const tree_elements *elements,
                         const tree_leaf_boxes *boxes, size_t n_boxes) {
    tree_card_params params;
    tree_cards_report report = {.struct_size = sizeof report};
    tree_cards *cards = NULL;
    OK(tree_card_params_init(&params, sizeof params));
    CHECK(params.size == 64 && params.samples == 4 && params.gutter == 1);
    OK(tree_card_params_check(&params));
    params.size = 15;
    FAILS(TREE_ERROR_PARAMETER, "cards.size", tree_card_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "cards.size",
          tree_cards_bake(mesh, elements, boxes, &params, NULL, NULL, &cards));
    params.size = 16;
    params.samples = 2;
    tree_elements *other = NULL;
    OK(tree_elements_of_mesh(mesh, NULL, 0, TREE_GRAIN_TRIANGLE, NULL, &other));
    FAILS(TREE_ERROR_INVALID, "number of leaves",
          tree_cards_bake(mesh, other, boxes, &params, NULL, NULL, &cards));
    CHECK(cards == NULL);
    OK(tree_elements_free(other));
    OK(tree_cards_bake(mesh, elements, boxes, &params, NULL, &report, &cards));
    CHECK(report.n_boxes == n_boxes && report.n_images == 6 * n_boxes && report.size == 16);
    CHECK(report.n_texels == 256 * report.n_images && report.n_empty < report.n_images);
    tree_cards_report again = {.struct_size = sizeof again};
    OK(tree_cards_measure(cards, &again));
    CHECK(memcmp(&again, &report, sizeof report) == 0);
    return cards;
}

static void atlases(const tree_cards *cards) {
    tree_pixels color = {.struct_size = sizeof color}, detail = {.struct_size = sizeof detail};
    tree_pixels copy = {.struct_size = sizeof copy}, level = {.struct_size = sizeof level};
    OK(tree_cards_pixels(cards, TREE_IMPOSTOR_COLOR, &color));
    OK(tree_cards_pixels(cards, TREE_IMPOSTOR_DETAIL, &detail));
    CHECK(color.n_bytes == 4 * (size_t)color.width * color.height && color.n_bytes == detail.n_bytes);
    CHECK(color.pixels != detail.pixels);
    FAILS(TREE_ERROR_ENUM, "TREE_IMPOSTOR_", tree_cards_pixels(cards, 2, &color));
    tree_picture *picture = NULL;
    FAILS(TREE_ERROR_ENUM, "TREE_IMPOSTOR_", tree_cards_picture(cards, 2, NULL, &picture));
    OK(tree_cards_picture(cards, TREE_IMPOSTOR_COLOR, NULL, &picture));
    OK(tree_picture_view(picture, &copy));
    CHECK(copy.pixels != color.pixels && memcmp(copy.pixels, color.pixels, color.n_bytes) == 0);
    tree_picture *lit = NULL;
    tree_pixels shone = {.struct_size = sizeof shone};
    OK(tree_cards_lit(cards, NULL, &lit));
    OK(tree_picture_view(lit, &shone));
    CHECK(shone.width == color.width && memcmp(shone.pixels, color.pixels, color.n_bytes) != 0);
    OK(tree_picture_free(lit));
    const uint32_t box = 0, no_box = 1u << 30;
    tree_mesh *planes = NULL;
    OK(tree_cards_plain(cards, &box, 1, NULL, &planes));
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_mesh_measure(planes, &totals));
    CHECK(totals.n_triangles == 12);
    OK(tree_mesh_free(planes));
    FAILS(TREE_ERROR_INVALID, "box", tree_cards_plain(cards, &no_box, 1, NULL, &planes));

    tree_mips *mips = NULL;
    size_t n_levels = 0;
    OK(tree_mips_of_picture(picture, 3, NULL, &mips));
    OK(tree_mips_count(mips, &n_levels));
    CHECK(n_levels == 3);
    OK(tree_mips_view(mips, 0, &level));
    CHECK(memcmp(level.pixels, color.pixels, color.n_bytes) == 0);
    OK(tree_mips_view(mips, 2, &level));
    CHECK(level.width == color.width / 4 && level.n_bytes == 4 * (size_t)level.width * level.height);
    FAILS(TREE_ERROR_PARAMETER, "there are 3", tree_mips_view(mips, 3, &level));
    OK(tree_mips_free(mips));
    OK(tree_picture_free(picture));
}

static void drawn(const tree_cards *cards) {
    static const uint32_t two[] = {0, 1}, missing[] = {4096};
    tree_mesh *mesh = NULL;
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_cards_mesh(cards, two, 2, NULL, &mesh));
    OK(tree_mesh_measure(mesh, &totals));
    CHECK(totals.n_triangles == 24 && totals.n_vertices == 48);
    OK(tree_mesh_free(mesh));
    FAILS(TREE_ERROR_INVALID, "no box", tree_cards_mesh(cards, missing, 1, NULL, &mesh));
    static const uint32_t planes[] = {0, 2, 4, 6, 0, 0, 0};
    OK(tree_cards_mesh_of_planes(cards, two, 2, planes, 3, NULL, &mesh));
    OK(tree_mesh_measure(mesh, &totals));
    CHECK(totals.n_triangles == 12 && totals.n_vertices == 24);
    OK(tree_mesh_free(mesh));
    FAILS(TREE_ERROR_INVALID, "no plane",
          tree_cards_mesh_of_planes(cards, two, 1, planes, 4, NULL, &mesh));
    FAILS(TREE_ERROR_PARAMETER, "at most 6",
          tree_cards_mesh_of_planes(cards, two, 1, planes, 7, NULL, &mesh));
    float metres = 0;
    OK(tree_cards_texel(cards, 0, &metres));
    CHECK(metres > 0.1f && metres < 2);
    FAILS(TREE_ERROR_INVALID, "no box", tree_cards_texel(cards, 4096, &metres));

    tree_view view = from_the_side(TREE_CAMERA_PLACED);
    tree_picture *picture = NULL;
    OK(tree_cards_view(cards, two, 1, &view, NULL, &picture));
    CHECK(n_covered(picture) > 20 && n_covered(picture) < 32 * 32);
    OK(tree_picture_free(picture));
    view = from_the_side(TREE_CAMERA_FRAMED);
    FAILS(TREE_ERROR_INVALID, "placed", tree_cards_view(cards, two, 1, &view, NULL, &picture));
    CHECK(picture == NULL);

    tree_bytes *bytes = NULL;
    const uint8_t *data = NULL;
    size_t len = 0;
    OK(tree_cards_to_glb(cards, two, 2, NULL, NULL, &bytes));
    OK(tree_bytes_view(bytes, &data, &len));
    CHECK(len > 1000 && memcmp(data, "glTF", 4) == 0);
    const char *folder = getenv("TREE_TEST_DIR");
    char path[4096];
    snprintf(path, sizeof path, "%s/tree_test_cards.glb", folder ? folder : ".");
    OK(tree_cards_write_glb(cards, two, 2, path, TREE_NUL_TERMINATED, NULL, NULL));
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL);
    if (file) {
        CHECK(fseek(file, 0, SEEK_END) == 0 && ftell(file) == (long)len);
        fclose(file);
    }
    CHECK(remove(path) == 0);
    OK(tree_bytes_free(bytes));
    tree_glb_options options;
    OK(tree_glb_options_init(&options, sizeof options));
    options.quantize = 1;
    FAILS(TREE_ERROR_PARAMETER, "quantize", tree_cards_to_glb(cards, two, 2, &options, NULL, &bytes));
}

static void shaders_and_weights(void) {
    static const float half[] = {1, 2, 0.5f}, sides[] = {1, 0.2f, 0.3f}, zero[3], pixel[] = {3.5f, 7.5f};
    tree_str text = {NULL, 0}, other = {NULL, 0};
    for (tree_shader language = TREE_SHADER_WGSL; language <= TREE_SHADER_HLSL; language++) {
        OK(tree_cards_shader(language, &text));
        OK(tree_octahedral_shader(language, &other));
        CHECK(text.len > 500 && other.len > 500 && text.data != other.data);
    }
    FAILS(TREE_ERROR_ENUM, "TREE_SHADER_", tree_cards_shader(3, &text));
    FAILS(TREE_ERROR_ENUM, "TREE_SHADER_", tree_octahedral_shader(3, &text));
    float weights[TREE_CARD_PLANES], sum = 0, interval[2], last = 0, share = -1;
    OK(tree_card_weights(half, sides, &weights));
    for (uint32_t i = 0; i < TREE_CARD_PLANES; i++) {
        sum += weights[i];
        OK(tree_card_interval(weights, i, &interval));
        CHECK(fabsf(interval[0] - last) < 1e-6f && interval[1] >= interval[0]);
        last = interval[1];
    }
    CHECK(fabsf(sum - 1) < 1e-5f && last == 1);
    FAILS(TREE_ERROR_INVALID, "direction", tree_card_weights(half, zero, &weights));
    FAILS(TREE_ERROR_INVALID, "half sides", tree_card_weights(zero, sides, &weights));
    FAILS(TREE_ERROR_PARAMETER, "plane is 6", tree_card_interval(weights, 6, &interval));
    OK(tree_card_noise(pixel, &share));
    CHECK(share >= 0 && share < 1);
}

static void choices(const tree_cards *cards, size_t n_boxes) {
    tree_card_choose_params params;
    tree_card_choice_report report = {.struct_size = sizeof report}, again = report;
    tree_card_choice *choice = NULL;
    uint32_t boxes[64];
    tree_leaf_range ranges[64];
    float eye[] = {10000, 3, 0};
    OK(tree_card_choose_params_init(&params, sizeof params));
    CHECK(params.texel_pixels == 1 && params.hysteresis == 0.1f);
    OK(tree_card_choose_params_check(&params));
    OK(tree_card_choice_new(cards, &choice));
    OK(tree_card_choice_update(choice, cards, eye, 800, &params, &report));
    CHECK(report.n_boxes == 1 && report.n_ranges == 0 && report.n_leaves == 0);
    OK(tree_card_choice_boxes(choice, boxes, 64));
    CHECK(boxes[0] == 0);
    OK(tree_card_choice_ranges(choice, NULL, 0));

    /* From afar to close by, each leaf is drawn once. */
    tree_leaf_boxes *held = NULL;
    tree_leaf_box row = {.struct_size = sizeof row};
    OK(tree_cards_boxes(cards, &held));
    size_t most = 0;
    for (eye[0] = 3000; eye[0] > 1; eye[0] *= 0.7f) {
        OK(tree_card_choice_update(choice, cards, eye, 800, NULL, &report));
        OK(tree_card_choice_boxes(choice, boxes, n_boxes));
        OK(tree_card_choice_ranges(choice, ranges, n_boxes));
        size_t leaves = 0, in_ranges = 0;
        for (size_t i = 0; i < report.n_ranges; i++) in_ranges += ranges[i].n_leaves;
        for (size_t i = 0; i < report.n_boxes; i++) {
            OK(tree_leaf_boxes_get(held, boxes[i], &row));
            leaves += row.n_leaves;
        }
        CHECK(in_ranges == report.n_leaves && leaves + in_ranges == LEAVES);
        most = report.n_boxes > most ? report.n_boxes : most;
    }
    CHECK(most > 1 && report.n_boxes == 0 && ranges[0].first == 0 && ranges[0].n_leaves == LEAVES);
    FAILS(TREE_ERROR_BUFFER, "ranges", tree_card_choice_ranges(choice, ranges, 0));
    params.hysteresis = 2;
    FAILS(TREE_ERROR_PARAMETER, "choose.hysteresis", tree_card_choose_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "choose.hysteresis",
          tree_card_choice_update(choice, cards, eye, 800, &params, NULL));
    FAILS(TREE_ERROR_PARAMETER, "pixels_per_metre", tree_card_choice_update(choice, cards, eye, 0, NULL, NULL));
    eye[1] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "watcher.eye", tree_card_choice_update(choice, cards, eye, 800, NULL, NULL));
    OK(tree_card_choice_measure(choice, &again));
    CHECK(memcmp(&again, &report, sizeof report) == 0);
    OK(tree_leaf_boxes_free(held));
    OK(tree_card_choice_free(choice));
}

static void limited(const tree_mesh *mesh, const tree_elements *elements, const tree_leaf_boxes *boxes,
                    const tree_cards *cards) {
    static const uint32_t one[] = {0};
    tree_limits limits;
    tree_control control;
    tree_cards *none = NULL;
    tree_octahedral *neither = NULL;
    tree_picture *picture = NULL;
    tree_mesh *planes = NULL;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&control, sizeof control));
    limits.pixels = 100;
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_cards_bake(mesh, elements, boxes, NULL, &control, NULL, &none));
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_octahedral_bake(mesh, NULL, &control, NULL, &neither));
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_cards_picture(cards, TREE_IMPOSTOR_COLOR, &control, &picture));
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_cards_mesh(cards, one, 1, &control, &planes));
    CHECK(none == NULL && neither == NULL && picture == NULL && planes == NULL);
}

void test_impostor(void) {
    bearers_of_a_tree();
    tree_skeleton *skeleton = a_forked_tree();
    tree_mesh *mesh = leaves_at_tips();
    tree_elements *elements = NULL;
    OK(tree_elements_of_mesh(mesh, NULL, 0, TREE_GRAIN_BLADE, NULL, &elements));
    tree_leaf_boxes *boxes = grown(skeleton, mesh, elements);
    size_t n_boxes = looked_at(boxes);
    tree_cards *cards = baked(mesh, elements, boxes, n_boxes);
    limited(mesh, elements, boxes, cards);
    /* Cards need nothing of what they were made of. */
    OK(tree_leaf_boxes_free(boxes));
    OK(tree_elements_free(elements));
    OK(tree_skeleton_free(skeleton));
    atlases(cards);
    drawn(cards);
    shaders_and_weights();
    choices(cards, n_boxes);
    OK(tree_cards_free(cards));
    OK(tree_mesh_free(mesh));
}
