#include "check.h"
#include <math.h>

enum { TIPS = 9, PER_TIP = 12, LEAVES = TIPS * PER_TIP, NODES = 5 + TIPS };

static float tips[3 * TIPS];

/* A trunk that forks three ways, and each of those again three ways. */
static tree_skeleton *a_forked_tree(void) {
    static float positions[3 * NODES], radii[NODES];
    static uint32_t parents[NODES];
    positions[4] = 2;
    parents[0] = TREE_NO_PARENT;
    for (int i = 0; i < NODES; i++) radii[i] = i < 2 ? 0.15f : 0.05f;
    for (int i = 0; i < 3; i++) {
        float turn = 2.1f * (float)i + 0.4f, *limb = positions + 3 * (2 + 4 * i);
        limb[0] = 2 * sinf(turn), limb[1] = 3, limb[2] = 2 * cosf(turn);
        parents[2 + 4 * i] = 1;
        for (int k = 0; k < 3; k++) {
            float angle = 2.1f * (float)k + (float)i, *tip = limb + 3 * (k + 1);
            tip[0] = 3 * sinf(turn) + sinf(angle);
            tip[1] = 3.8f + 0.3f * cosf(angle);
            tip[2] = 3 * cosf(turn) + cosf(angle);
            parents[3 + 4 * i + k] = (uint32_t)(2 + 4 * i);
            memcpy(tips + 3 * (3 * i + k), tip, 3 * sizeof(float));
        }
    }
    tree_skeleton_columns columns = {sizeof columns, NODES, positions, radii, parents};
    tree_skeleton *skeleton = NULL;
    OK(tree_skeleton_from_columns(&columns, NULL, &skeleton));
    return skeleton;
}

/* Square leaves around the tips. */
static tree_mesh *leaves_at_tips(void) {
    static float positions[12 * LEAVES], normals[12 * LEAVES];
    static const float uvs[8 * LEAVES];
    static uint32_t indices[6 * LEAVES];
    static const int corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const uint32_t quad[] = {0, 1, 2, 0, 2, 3};
    for (int i = 0; i < LEAVES; i++) {
        float y = 1 - (2 * (float)(i % PER_TIP) + 1) / PER_TIP, ring = sqrtf(1 - y * y);
        float turn = 2.3999632f * (float)i, s = sinf(turn), c = cosf(turn);
        float normal[3] = {ring * s, y, ring * c}, along[3] = {c, 0, -s}, up[3] = {-y * s, ring, -y * c};
        for (int k = 0; k < 4; k++)
            for (int axis = 0; axis < 3; axis++) {
                int at = 3 * (4 * i + k) + axis;
                float side = (float)corners[k][0] * along[axis] + (float)corners[k][1] * up[axis];
                positions[at] = tips[3 * (i / PER_TIP) + axis] + 0.4f * normal[axis] + 0.15f * side;
                normals[at] = normal[axis];
            }
        for (int k = 0; k < 6; k++) indices[6 * i + k] = (uint32_t)(4 * i) + quad[k];
    }
    tree_surface surface = {.struct_size = sizeof surface, .n_vertices = 4 * LEAVES,
                            .n_indices = 6 * LEAVES, .positions = positions, .normals = normals,
                            .uvs = uvs, .indices = indices};
    tree_material material;
    OK(tree_material_init(&material, sizeof material));
    material.name = (tree_str){"leaves", 6};
    material.base_color[1] = 0.5f;
    material.double_sided = 1;
    tree_mesh *mesh = NULL;
    OK(tree_mesh_from_surfaces(&surface, 1, &material, 1, NULL, 0, NULL, &mesh));
    return mesh;
}

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
    CHECK(report.texels == 256 * report.n_images && report.empty < report.n_images);
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

static tree_view from_the_side(uint32_t camera) {
    tree_view view;
    OK(tree_view_init(&view, sizeof view));
    view.width = view.height = 32;
    view.camera = camera;
    view.lens = TREE_LENS_ORTHOGRAPHIC;
    view.lens_height = 10;
    view.eye[0] = 40;
    view.eye[1] = view.target[1] = 3.8f;
    return view;
}

static int n_covered(const tree_picture *picture) {
    tree_pixels pixels = {.struct_size = sizeof pixels};
    int n = 0;
    OK(tree_picture_view(picture, &pixels));
    for (size_t i = 3; i < pixels.n_bytes; i += 4) n += pixels.pixels[i] >= 128;
    return n;
}

static void drawn(const tree_cards *cards) {
    static const uint32_t two[] = {0, 1}, missing[] = {4096};
    tree_mesh *mesh = NULL;
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_cards_mesh(cards, two, 2, NULL, &mesh));
    OK(tree_mesh_count(mesh, &totals));
    CHECK(totals.n_triangles == 24 && totals.n_vertices == 48);
    OK(tree_mesh_free(mesh));
    FAILS(TREE_ERROR_INVALID, "no box", tree_cards_mesh(cards, missing, 1, NULL, &mesh));
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

static tree_octahedral *all_round(const tree_mesh *mesh) {
    tree_octahedral_params params;
    tree_octahedral_report report = {.struct_size = sizeof report}, again = report;
    tree_octahedral *octahedral = NULL;
    OK(tree_octahedral_params_init(&params, sizeof params));
    CHECK(params.grid == 12 && params.hemi == 1 && params.side == 2048 && params.half_detail == 0);
    OK(tree_octahedral_params_check(&params));
    params.grid = 1;
    FAILS(TREE_ERROR_PARAMETER, "octahedral.grid", tree_octahedral_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "octahedral.grid",
          tree_octahedral_bake(mesh, &params, NULL, NULL, &octahedral));
    CHECK(octahedral == NULL);
    params.grid = 3;
    params.side = 64;
    params.samples = 1;
    params.half_detail = 1;
    OK(tree_octahedral_bake(mesh, &params, NULL, &report, &octahedral));
    CHECK(report.n_views == 9 && report.n_triangles == 2 * LEAVES && report.covered > 100);
    CHECK(report.bytes == 4 * (64 * 64 + 32 * 32));
    OK(tree_octahedral_measure(octahedral, &again));
    CHECK(memcmp(&again, &report, sizeof report) == 0);
    return octahedral;
}

/* Numbers, pictures, and the same impostor put together again. */
static void parts_of(const tree_octahedral *octahedral) {
    tree_octahedral_meta meta = {.struct_size = sizeof meta};
    OK(tree_octahedral_describe(octahedral, &meta));
    CHECK(meta.grid == 3 && meta.hemi == 1 && meta.side == 64 && meta.tile == 21 && meta.detail_side == 32);
    CHECK(meta.radius > 3 && meta.wide > 2 && meta.high > 0.3f && meta.texel > 0.1f);
    OK(tree_octahedral_meta_check(&meta));
    float half[2] = {0, 0}, reach = 0;
    OK(tree_octahedral_meta_extent(&meta, 0, &half, &reach));
    CHECK(half[0] == meta.wide && half[1] == meta.high && reach == meta.wide);
    tree_bytes *json = NULL;
    const uint8_t *data = NULL;
    size_t len = 0;
    OK(tree_octahedral_to_json(octahedral, &json));
    OK(tree_bytes_view(json, &data, &len));
    CHECK(len > 100 && memcmp(data, "{ \"kind\": \"octahedral\"", 22) == 0);
    OK(tree_bytes_free(json));

    tree_pixels color = {.struct_size = sizeof color}, detail = {.struct_size = sizeof detail};
    OK(tree_octahedral_pixels(octahedral, TREE_IMPOSTOR_COLOR, &color));
    OK(tree_octahedral_pixels(octahedral, TREE_IMPOSTOR_DETAIL, &detail));
    CHECK(color.width == 64 && detail.width == 32);
    FAILS(TREE_ERROR_ENUM, "TREE_IMPOSTOR_", tree_octahedral_pixels(octahedral, 2, &color));
    tree_picture *pictures[2] = {NULL, NULL}, *seen = NULL, *same = NULL;
    OK(tree_octahedral_picture(octahedral, TREE_IMPOSTOR_COLOR, NULL, &pictures[0]));
    OK(tree_octahedral_picture(octahedral, TREE_IMPOSTOR_DETAIL, NULL, &pictures[1]));
    tree_octahedral *again = NULL, *none = NULL;
    OK(tree_octahedral_from_pictures(&meta, pictures[0], pictures[1], NULL, &again));
    FAILS(TREE_ERROR_INVALID, "another size",
          tree_octahedral_from_pictures(&meta, pictures[1], pictures[0], NULL, &none));
    tree_view view = from_the_side(TREE_CAMERA_PLACED);
    OK(tree_octahedral_view(octahedral, &view, NULL, &seen));
    OK(tree_octahedral_view(again, &view, NULL, &same));
    tree_pixels a = {.struct_size = sizeof a}, b = {.struct_size = sizeof b};
    OK(tree_picture_view(seen, &a));
    OK(tree_picture_view(same, &b));
    CHECK(memcmp(a.pixels, b.pixels, a.n_bytes) == 0);
    CHECK(n_covered(seen) > 20 && n_covered(seen) < 32 * 32);
    tree_mask *mask = NULL;
    tree_mask_columns columns = {.struct_size = sizeof columns};
    OK(tree_octahedral_mask(octahedral, &view, NULL, &mask));
    OK(tree_mask_view(mask, &columns));
    int alike = 1;
    for (size_t i = 0; i < columns.n_pixels; i++) alike &= columns.coverage[i] == a.pixels[4 * i + 3];
    CHECK(columns.n_pixels == 32 * 32 && alike);
    OK(tree_mask_free(mask));
    view = from_the_side(TREE_CAMERA_FRAMED);
    FAILS(TREE_ERROR_INVALID, "placed", tree_octahedral_mask(octahedral, &view, NULL, &mask));
    meta.detail_side = 7;
    FAILS(TREE_ERROR_INVALID, "detail_side", tree_octahedral_meta_check(&meta));
    FAILS(TREE_ERROR_INVALID, "detail_side",
          tree_octahedral_from_pictures(&meta, pictures[0], pictures[1], NULL, &none));
    CHECK(none == NULL && mask == NULL);
    OK(tree_picture_free(pictures[0]));
    OK(tree_picture_free(pictures[1]));
    OK(tree_picture_free(seen));
    OK(tree_picture_free(same));
    OK(tree_octahedral_free(again));
}

static void directions(void) {
    static const float slanted[] = {0.6f, 0.48f, 0.64f}, outside[] = {2, 0}, nowhere[3];
    float place[2] = {-1, -1}, back[3] = {0, 0, 0}, right[3], up[3], toward[3];
    for (uint32_t hemi = 0; hemi < 2; hemi++) {
        OK(tree_octahedral_encode(slanted, hemi, &place));
        CHECK(place[0] > 0 && place[0] < 1 && place[1] > 0 && place[1] < 1);
        OK(tree_octahedral_decode(place, hemi, &back));
        for (int i = 0; i < 3; i++) CHECK(fabsf(back[i] - slanted[i]) < 1e-5f);
        tree_octahedral_frame frames[3];
        OK(tree_octahedral_frames(slanted, 3, hemi, frames, 3));
        CHECK(fabsf(frames[0].weight + frames[1].weight + frames[2].weight - 1) < 1e-5f);
        for (int i = 0; i < 3; i++) CHECK(frames[i].column < 3 && frames[i].row < 3);
        FAILS(TREE_ERROR_BUFFER, "frames", tree_octahedral_frames(slanted, 3, hemi, frames, 2));
        FAILS(TREE_ERROR_PARAMETER, "grid is 65", tree_octahedral_frames(slanted, 65, hemi, frames, 3));
    }
    OK(tree_octahedral_axes(1, 1, 3, 1, &right, &up, &toward));
    CHECK(right[0] == 1 && fabsf(toward[1] - 1) < 1e-6f && fabsf(up[2] + 1) < 1e-6f);
    FAILS(TREE_ERROR_PARAMETER, "(3, 0)", tree_octahedral_axes(3, 0, 3, 1, &right, &up, &toward));
    FAILS(TREE_ERROR_PARAMETER, "direction", tree_octahedral_encode(nowhere, 1, &place));
    FAILS(TREE_ERROR_PARAMETER, "place", tree_octahedral_decode(outside, 1, &back));
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
    tree_octahedral *octahedral = all_round(mesh);
    OK(tree_mesh_free(mesh));
    parts_of(octahedral);
    OK(tree_octahedral_free(octahedral));
    directions();
}
