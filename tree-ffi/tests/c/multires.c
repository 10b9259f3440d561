#include "multires.h"
#include <math.h>

tree_tree *a_tree_with_levels(void) {
    float positions[3 * NODES] = {0}, radii[NODES] = {0.2f};
    float leaf_positions[3 * LEAVES], rotations[4 * LEAVES] = {0}, sizes[LEAVES];
    uint32_t parents[NODES] = {TREE_NO_PARENT}, leaf_nodes[LEAVES], trunk = 0, n = 1, leaf = 0;
    static const uint16_t kinds[LEAVES];
    for (int i = 1; i <= TRUNK; i++) {
        float y = (float)i;
        positions[3 * n + 1] = y;
        radii[n] = 0.2f - 0.04f * y;
        parents[n] = trunk;
        trunk = n++;
        for (int side = -1; side <= 1; side += 2) {
            float tip[3] = {(float)side * (1.5f - 0.2f * y), y + 0.5f, 0.1f};
            memcpy(positions + 3 * n, tip, sizeof tip);
            radii[n] = 0.02f;
            parents[n] = trunk;
            for (int k = 0; k < 2; k++, leaf++) {
                leaf_nodes[leaf] = n;
                memcpy(leaf_positions + 3 * leaf, tip, sizeof tip);
                rotations[4 * leaf + (k ? 1 : 3)] = 1;
                sizes[leaf] = 0.1f;
            }
            n++;
        }
    }
    tree_skeleton_columns columns = {sizeof columns, NODES, positions, radii, parents};
    tree_foliage foliage = {sizeof foliage, LEAVES, leaf_nodes, leaf_positions, rotations, sizes, kinds};
    tree_skeleton *skeleton = NULL;
    tree_tree *tree = NULL;
    OK(tree_skeleton_from_columns(&columns, NULL, &skeleton));
    OK(tree_tree_new(skeleton, &foliage, NULL, NULL, &tree));
    OK(tree_skeleton_free(skeleton));
    return tree;
}

static tree_multires *levels_of(const tree_tree *tree) {
    tree_multires *multires = NULL, *same = NULL, *none = NULL;
    OK(tree_multires_new(tree, NULL, 0, NULL, &multires));
    tree_skeleton *skeleton = NULL;
    tree_adt *adt = NULL;
    tree_multi_paths *paths = NULL;
    tree_rows *nodes = NULL, *leaves = NULL;
    OK(tree_tree_skeleton(tree, &skeleton));
    tree_adt_columns wood = {.struct_size = sizeof wood}, leafy = wood;
    tree_adt *bare = NULL;
    OK(tree_adt_of_skeleton(skeleton, NULL, &bare));
    OK(tree_adt_of_tree(tree, NULL, &adt));
    OK(tree_adt_view(bare, &wood));
    OK(tree_adt_view(adt, &leafy));
    CHECK(wood.n_branches == leafy.n_branches);
    size_t leaf_branches = 0;
    for (size_t i = 0; i < wood.n_branches; i++) leaf_branches += leafy.areas[i] > wood.areas[i];
    CHECK(leaf_branches == LEAVES / 2);
    OK(tree_adt_free(bare));
    bare = NULL;
    FAILS(TREE_ERROR_NULL, "tree", tree_adt_of_tree(NULL, NULL, &bare));
    OK(tree_multi_paths_new(adt, NULL, 0, NULL, &paths));
    OK(tree_adt_free(adt));
    OK(tree_multires_of_paths(tree, paths, NULL, &nodes, &leaves, &same));

    tree_skeleton_columns a = {.struct_size = sizeof a}, b = a, before = a;
    tree_foliage grown = {.struct_size = sizeof grown}, foliage = grown;
    const uint32_t *rows = NULL;
    size_t n = 0;
    OK(tree_multires_level(multires, SIZE_MAX, &a, &grown));
    OK(tree_multires_level(same, LEVELS, &b, NULL));
    OK(tree_skeleton_view(skeleton, &before));
    OK(tree_tree_foliage(tree, &foliage));
    CHECK(a.n_nodes == NODES && b.n_nodes == NODES && grown.n_leaves == LEAVES);
    CHECK(memcmp(a.positions, b.positions, 12 * NODES) == 0 && memcmp(a.parents, b.parents, 4 * NODES) == 0);
    OK(tree_rows_view(nodes, &rows, &n));
    CHECK(n == NODES);
    for (size_t i = 0; i < n; i++)
        CHECK(a.radii[i] == before.radii[rows[i]] && a.positions[3 * i] == before.positions[3 * rows[i]]);
    OK(tree_rows_view(leaves, &rows, &n));
    CHECK(n == LEAVES);
    for (size_t i = 0; i < n; i++)
        CHECK(memcmp(grown.positions + 3 * i, foliage.positions + 3 * rows[i], 12) == 0 &&
              memcmp(grown.rotations + 4 * i, foliage.rotations + 4 * rows[i], 16) == 0);
    OK(tree_rows_free(leaves));
    OK(tree_rows_free(nodes));
    OK(tree_multires_free(same));
    OK(tree_multires_of_paths(tree, paths, NULL, NULL, NULL, &same));
    OK(tree_multires_free(same));
    tree_tree *other = an_oak_twig();
    FAILS(TREE_ERROR_INVALID, "paths are not",
          tree_multires_of_paths(other, paths, NULL, &nodes, &leaves, &none));
    CHECK(none == NULL && nodes == NULL && leaves == NULL);
    OK(tree_tree_free(other));
    OK(tree_multi_paths_free(paths));
    OK(tree_skeleton_free(skeleton));

    tree_metric_params params;
    OK(tree_metric_params_init(&params, sizeof params));
    params.metric = 9;
    FAILS(TREE_ERROR_ENUM, "TREE_METRIC_", tree_multires_new(tree, &params, 0, NULL, &none));
    FAILS(TREE_ERROR_NULL, "tree", tree_multires_new(NULL, NULL, 0, NULL, &none));
    return multires;
}

static void prefixes(const tree_multires *multires) {
    size_t n = 0, n_nodes = 0, n_leaves = 0, before = 0;
    tree_skeleton_columns all = {.struct_size = sizeof all}, columns = all;
    tree_foliage foliage = {.struct_size = sizeof foliage};
    OK(tree_multires_count(multires, &n));
    CHECK(n == LEVELS);
    OK(tree_multires_level(multires, LEVELS, &all, NULL));
    for (size_t k = 1; k <= n; k++, before = n_nodes) {
        tree_tree *tree = NULL;
        tree_skeleton *skeleton = NULL;
        tree_skeleton_columns own = {.struct_size = sizeof own};
        size_t found = 0;
        OK(tree_multires_level_counts(multires, k, &n_nodes, &n_leaves));
        OK(tree_multires_level(multires, k, &columns, &foliage));
        CHECK(n_nodes > before && columns.n_nodes == n_nodes && foliage.n_leaves == n_leaves);
        CHECK(columns.positions == all.positions && columns.parents == all.parents);
        for (size_t leaf = 0; leaf < n_leaves; leaf++) CHECK(foliage.nodes[leaf] < n_nodes);
        OK(tree_multires_tree_at(multires, k, NULL, &tree));
        OK(tree_tree_skeleton(tree, &skeleton));
        OK(tree_skeleton_view(skeleton, &own));
        CHECK(own.n_nodes == n_nodes && memcmp(own.positions, all.positions, 12 * n_nodes) == 0);
        OK(tree_skeleton_free(skeleton));
        OK(tree_tree_free(tree));
        OK(tree_multires_level_of_nodes(multires, n_nodes, &found));
        CHECK(found == k);
    }
    CHECK(n_nodes == NODES && n_leaves == LEAVES);
    OK(tree_multires_level_counts(multires, 0, &n_nodes, &n_leaves));
    CHECK(n_nodes == TRUNK + 2 && n_leaves == 2);
    OK(tree_multires_level_of_nodes(multires, 0, &n));
    CHECK(n == 1);
    foliage.struct_size = 3;
    FAILS(TREE_ERROR_STRUCT_SIZE, "foliage", tree_multires_level(multires, 1, &columns, &foliage));
    FAILS(TREE_ERROR_NULL, "n_leaves", tree_multires_level_counts(multires, 1, &n_nodes, NULL));
}

static const char *a_path(const char *name) {
    static char path[4096];
    const char *folder = getenv("TREE_TEST_DIR");
    snprintf(path, sizeof path, "%s/tree_test_multires.%s", folder ? folder : ".", name);
    return path;
}

/* A file has what memory has; it is removed. */
static void same_file(const char *path, const tree_bytes *bytes) {
    const uint8_t *data = NULL;
    size_t len = 0;
    OK(tree_bytes_view(bytes, &data, &len));
    uint8_t *found = malloc(len + 1);
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL);
    if (file) {
        CHECK(fread(found, 1, len + 1, file) == len && memcmp(found, data, len) == 0);
        fclose(file);
    }
    free(found);
    CHECK(remove(path) == 0);
}

static void same_levels(const tree_multires *a, const tree_multires *b, size_t n_levels) {
    tree_skeleton_columns first = {.struct_size = sizeof first}, second = first;
    tree_foliage leaves = {.struct_size = sizeof leaves}, others = leaves;
    OK(tree_multires_level(a, n_levels, &first, &leaves));
    OK(tree_multires_level(b, n_levels, &second, &others));
    CHECK(first.n_nodes == second.n_nodes && leaves.n_leaves == others.n_leaves);
    CHECK(memcmp(first.positions, second.positions, 12 * first.n_nodes) == 0);
    CHECK(memcmp(first.radii, second.radii, 4 * first.n_nodes) == 0);
    CHECK(memcmp(leaves.rotations, others.rotations, 16 * leaves.n_leaves) == 0);
}

static void as_it_arrives(const tree_multires *multires, const uint8_t *data, size_t len) {
    tree_stream_reader *reader = NULL;
    tree_multires *found = NULL;
    tree_stream_report report = {.struct_size = sizeof report};
    size_t last = 0;
    OK(tree_stream_reader_new(NULL, &reader));
    OK(tree_stream_reader_received(reader, &report));
    CHECK(report.n_levels == 0 && report.n_levels_in_all == 0 && report.n_bytes == 0 && !report.is_complete);
    FAILS(TREE_ERROR_FORMAT, "before its first level", tree_stream_reader_multires(reader, NULL, &found));
    for (size_t i = 0; i < len; i++) {
        OK(tree_stream_reader_push(reader, data + i, 1, &report));
        CHECK(report.n_levels >= last && report.is_complete == (i + 1 == len));
        if (report.n_levels == last) continue;
        last = report.n_levels;
        OK(tree_stream_reader_multires(reader, NULL, &found));
        same_levels(multires, found, last);
        OK(tree_multires_free(found));
    }
    CHECK(last == LEVELS && report.n_levels_in_all == LEVELS && report.n_bytes == len);
    OK(tree_stream_reader_push(reader, data, 0, NULL));
    FAILS(TREE_ERROR_FORMAT, "follow the end", tree_stream_reader_push(reader, data, 1, NULL));
    FAILS(TREE_ERROR_NULL, "data", tree_stream_reader_push(reader, NULL, 1, NULL));
    OK(tree_stream_reader_received(reader, &report));
    CHECK(report.is_complete);
    OK(tree_stream_reader_free(reader));

    tree_limits limits;
    tree_control control;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    limits.input_bytes = len - 1;
    OK(tree_stream_reader_new(&control, &reader));
    OK(tree_stream_reader_push(reader, data, len - 1, NULL));
    FAILS(TREE_ERROR_LIMIT, "bytes", tree_stream_reader_push(reader, data + len - 1, 1, NULL));
    OK(tree_stream_reader_free(reader));
    limits.input_bytes = len;
    limits.nodes = NODES - 1;
    OK(tree_stream_reader_new(&control, &reader));
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_stream_reader_push(reader, data, len, NULL));
    OK(tree_stream_reader_free(reader));
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_multires_from_stream(data, len, &control, NULL, &found));
    limits.input_bytes = 10;
    FAILS(TREE_ERROR_LIMIT, "bytes", tree_multires_from_stream(data, len, &control, NULL, &found));
    CHECK(found == NULL);
}

static void streams(const tree_multires *multires) {
    tree_bytes *whole = NULL, *part = NULL, *plain = NULL, *none = NULL;
    const uint8_t *data = NULL, *begin = NULL;
    size_t len = 0, n = 0;
    tree_multires *found = NULL;
    tree_stream_report report = {.struct_size = sizeof report};
    OK(tree_multires_to_stream(multires, SIZE_MAX, NULL, NULL, &whole));
    OK(tree_bytes_view(whole, &data, &len));
    CHECK(len > 100 && memcmp(data, "TREM", 4) == 0);
    OK(tree_multires_to_stream(multires, 3, NULL, NULL, &part));
    OK(tree_bytes_view(part, &begin, &n));
    CHECK(n < len && memcmp(data, begin, n) == 0);
    OK(tree_multires_from_stream(data, len, NULL, &report, &found));
    CHECK(report.n_levels == LEVELS && report.n_levels_in_all == LEVELS && report.is_complete);
    CHECK(report.n_bytes == len);
    same_levels(multires, found, LEVELS);
    OK(tree_multires_free(found));
    OK(tree_multires_from_stream(begin, n, NULL, NULL, &found));
    same_levels(multires, found, 3);
    OK(tree_multires_free(found));
    FAILS(TREE_ERROR_FORMAT, "byte", tree_multires_from_stream(data, 20, NULL, NULL, &found));
    FAILS(TREE_ERROR_FORMAT, "TREM", tree_multires_from_stream((const uint8_t *)"no tree", 7, NULL, NULL, &found));
    FAILS(TREE_ERROR_NULL, "data", tree_multires_from_stream(NULL, 20, NULL, NULL, &found));
    as_it_arrives(multires, data, len);

    const char *path = a_path("trem");
    OK(tree_multires_write_stream(multires, LEVELS, path, TREE_NUL_TERMINATED, NULL, NULL));
    OK(tree_multires_read_stream(path, strlen(path), NULL, &report, &found));
    CHECK(report.is_complete);
    same_levels(multires, found, LEVELS);
    OK(tree_multires_free(found));
    same_file(path, whole);
    FAILS(TREE_ERROR_IO, "multires", tree_multires_read_stream(path, strlen(path), NULL, NULL, &found));
    FAILS(TREE_ERROR_IO, "nowhere",
          tree_multires_write_stream(multires, 1, "/nowhere/a", TREE_NUL_TERMINATED, NULL, NULL));
    CHECK(found == NULL);

    tree_stream_params params;
    OK(tree_stream_params_init(&params, sizeof params));
    CHECK(params.precision == 0);
    OK(tree_stream_params_check(&params));
    params.precision = 1e-3f;
    OK(tree_multires_to_bracketed(multires, &params, NULL, &plain));
    OK(tree_bytes_view(plain, &begin, &n));
    CHECK(n > 100 && n < len);
    OK(tree_bytes_free(plain));
    OK(tree_bytes_free(part));
    OK(tree_multires_to_stream(multires, LEVELS, &params, NULL, &part));
    OK(tree_bytes_view(part, &begin, &n));
    CHECK(n < len);
    params.precision = 2;
    FAILS(TREE_ERROR_PARAMETER, "precision", tree_stream_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "precision", tree_multires_to_stream(multires, 1, &params, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "precision", tree_multires_to_bracketed(multires, &params, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "precision",
          tree_multires_write_stream(multires, 1, path, strlen(path), &params, NULL));
    CHECK(none == NULL);
    OK(tree_bytes_free(part));
    OK(tree_bytes_free(whole));
}

/* Levels as draws, as meshes, and as a shader draws them. */
static void draws(const tree_multi_mesh *multi, const tree_multires *multires) {
    tree_multi_mesh_totals totals = {.struct_size = sizeof totals};
    tree_multi_draw rows[SURFACES] = {{0, 0}, {0, 0}};
    tree_mesh *whole = NULL, *mesh = NULL, *none = NULL;
    uint64_t n = 0, before = 0;
    uint32_t n_indices = 0;
    size_t n_levels = 0;
    OK(tree_multi_mesh_measure(multi, &totals));
    CHECK(totals.n_levels == LEVELS && totals.n_surfaces == SURFACES);
    for (int level = 1; level <= LEVELS; level++, before = n) {
        OK(tree_multi_mesh_draws(multi, (float)level, rows, SURFACES, &n));
        CHECK(n > before && 3 * n == rows[0].index_count + rows[1].index_count && rows[1].surface == 1);
        OK(tree_multi_mesh_level_of_wood(multi, rows[0].index_count / 3, &n_levels));
        CHECK(n_levels == (size_t)level);
        OK(tree_multi_mesh_wood_indices(multi, (float)level, &n_indices));
        CHECK(n_indices == rows[0].index_count);
    }
    CHECK(n == totals.n_triangles);
    OK(tree_multi_mesh_draws(multi, INFINITY, rows, SURFACES, &n));
    CHECK(n == totals.n_triangles);
    OK(tree_multi_mesh_level_of_wood(multi, 0, &n_levels));
    CHECK(n_levels == 1);
    FAILS(TREE_ERROR_PARAMETER, "level", tree_multi_mesh_wood_indices(multi, NAN, &n_indices));
    FAILS(TREE_ERROR_PARAMETER, "level", tree_multi_mesh_draws(multi, NAN, rows, SURFACES, &n));
    FAILS(TREE_ERROR_BUFFER, "draws", tree_multi_mesh_draws(multi, 1, rows, SURFACES - 1, &n));
    FAILS(TREE_ERROR_NULL, "draws", tree_multi_mesh_draws(multi, 1, NULL, SURFACES, &n));
    FAILS(TREE_ERROR_NULL, "n_triangles", tree_multi_mesh_draws(multi, 1, rows, SURFACES, NULL));

    OK(tree_multi_mesh_mesh(multi, &whole));
    OK(tree_mesh_check(whole));
    OK(tree_multi_mesh_draws(multi, 4.5f, rows, SURFACES, &n));
    OK(tree_multi_mesh_mesh_at(multi, 4.5f, NULL, &mesh));
    for (size_t i = 0; i < SURFACES; i++) {
        tree_surface all = {.struct_size = sizeof all}, few = {.struct_size = sizeof few};
        tree_multi_mesh_column column = {.struct_size = sizeof column};
        OK(tree_mesh_surface(whole, i, &all));
        OK(tree_mesh_surface(mesh, i, &few));
        OK(tree_multi_mesh_branches(multi, i, &column));
        CHECK(column.n_vertices == all.n_vertices && few.n_indices == rows[i].index_count);
        for (size_t k = 0; k < few.n_indices; k++) {
            float drawn[3];
            const float *branch = column.branches + 4 * all.indices[k];
            OK(tree_multi_mesh_position(all.positions + 3 * all.indices[k], branch, 4.5f, &drawn));
            CHECK(memcmp(drawn, few.positions + 3 * few.indices[k], sizeof drawn) == 0 && branch[3] < 5);
        }
        /* The last path stems from a node of those before. */
        if (i == 0) {
            tree_skeleton_columns nodes = {.struct_size = sizeof nodes};
            OK(tree_multires_level(multires, LEVELS, &nodes, NULL));
            const float *branch = column.branches + 4 * (column.n_vertices - 1);
            uint32_t fork = nodes.parents[NODES - 1];
            CHECK(branch[3] == LEVELS - 1 && memcmp(branch, nodes.positions + 3 * fork, 12) == 0);
        }
    }
    tree_multi_mesh_column column = {.struct_size = sizeof column};
    FAILS(TREE_ERROR_PARAMETER, "2 surfaces", tree_multi_mesh_branches(multi, SURFACES, &column));
    FAILS(TREE_ERROR_PARAMETER, "level", tree_multi_mesh_mesh_at(multi, NAN, NULL, &none));
    CHECK(none == NULL);
    OK(tree_mesh_free(mesh));
    OK(tree_mesh_free(whole));
}

static void shaders(void) {
    static const char *const words[] = {"vec3<f32>", "vec3 ", "float3 "};
    tree_str text = {0};
    for (tree_shader language = TREE_SHADER_WGSL; language <= TREE_SHADER_HLSL; language++) {
        OK(tree_multi_mesh_shader(language, &text));
        char *copy = calloc(text.len + 1, 1);
        memcpy(copy, text.data, text.len);
        CHECK(strstr(copy, "tree_grow_position") && strstr(copy, words[language]));
        free(copy);
    }
    FAILS(TREE_ERROR_ENUM, "TREE_SHADER_", tree_multi_mesh_shader(3, &text));
    FAILS(TREE_ERROR_NULL, "text", tree_multi_mesh_shader(TREE_SHADER_WGSL, NULL));
    static const float vertex[3] = {2, 0, 0}, branch[4] = {1, 0, 0, 3};
    float drawn[3];
    OK(tree_multi_mesh_position(vertex, branch, 3.25f, &drawn));
    CHECK(drawn[0] == 1.25f && drawn[1] == 0);
    OK(tree_multi_mesh_position(vertex, branch, 9, &drawn));
    CHECK(drawn[0] == 2);
    FAILS(TREE_ERROR_NULL, "branch", tree_multi_mesh_position(vertex, NULL, 1, &drawn));
    FAILS(TREE_ERROR_NULL, "drawn", tree_multi_mesh_position(vertex, branch, 1, NULL));
}

static int holds(const tree_bytes *bytes, const char *word) {
    const uint8_t *data = NULL;
    size_t len = 0, n = strlen(word);
    OK(tree_bytes_view(bytes, &data, &len));
    for (size_t i = 0; i + n <= len; i++)
        if (memcmp(data + i, word, n) == 0) return 1;
    return 0;
}

static void files(const tree_multi_mesh *multi) {
    static const tree_level_share shares[] = {{LEVELS, 0.5f}, {4.5f, 0.2f}, {1, 0.05f}};
    static const tree_level_share rising[] = {{1, 0.5f}, {2, 0.2f}}, alike[] = {{2, 0.5f}, {1, 0.5f}};
    const char *path = a_path("glb");
    tree_glb_options options;
    tree_bytes *bytes = NULL, *none = NULL;
    OK(tree_glb_options_init(&options, sizeof options));
    OK(tree_multi_mesh_to_glb(multi, NULL, NULL, &bytes));
    CHECK(holds(bytes, "_TREE_BRANCH"));
    OK(tree_multi_mesh_write_glb(multi, path, TREE_NUL_TERMINATED, &options, NULL));
    same_file(path, bytes);
    OK(tree_bytes_free(bytes));
    OK(tree_multi_mesh_to_glb_levels(multi, shares, 3, NULL, NULL, &bytes));
    CHECK(holds(bytes, "MSFT_lod") && holds(bytes, "MSFT_screencoverage"));
    OK(tree_multi_mesh_write_glb_levels(multi, shares, 3, path, strlen(path), &options, NULL));
    same_file(path, bytes);
    OK(tree_bytes_free(bytes));
    options.quantize = 1;
    FAILS(TREE_ERROR_PARAMETER, "quantize", tree_multi_mesh_to_glb(multi, &options, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "quantize",
          tree_multi_mesh_write_glb(multi, path, strlen(path), &options, NULL));
    FAILS(TREE_ERROR_IO, "nowhere", tree_multi_mesh_write_glb(multi, "/nowhere/a.glb", 14, NULL, NULL));
    FAILS(TREE_ERROR_INVALID, "fall", tree_multi_mesh_to_glb_levels(multi, rising, 2, NULL, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "fall", tree_multi_mesh_to_glb_levels(multi, alike, 2, NULL, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "fall", tree_multi_mesh_to_glb_levels(multi, NULL, 0, NULL, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "fall",
          tree_multi_mesh_write_glb_levels(multi, rising, 2, path, strlen(path), NULL, NULL));
    FAILS(TREE_ERROR_NULL, "levels", tree_multi_mesh_to_glb_levels(multi, NULL, 2, NULL, NULL, &none));
    FAILS(TREE_ERROR_LIMIT, "", tree_multi_mesh_to_glb_levels(multi, shares, 1025, NULL, NULL, &none));
    CHECK(none == NULL && fopen(path, "rb") == NULL);
}

static void bad_meshes(const tree_multires *multires) {
    tree_multi_mesh *none = NULL;
    tree_mesh_params params;
    OK(tree_mesh_params_init(&params, sizeof params));
    params.min_radius = NAN;
    FAILS(TREE_ERROR_PARAMETER, "min_radius", tree_multi_mesh_new(multires, NULL, &params, NULL, &none));
    FAILS(TREE_ERROR_NULL, "multires", tree_multi_mesh_new(NULL, NULL, NULL, NULL, &none));
    tree_cancel *cancel = NULL;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "", tree_multi_mesh_new(multires, NULL, NULL, &control, &none));
    OK(tree_cancel_free(cancel));
    CHECK(none == NULL);
}

void test_multires(void) {
    tree_tree *tree = a_tree_with_levels();
    tree_multires *multires = levels_of(tree);
    prefixes(multires);
    streams(multires);
    bad_meshes(multires);
    tree_look *look = NULL;
    tree_multi_mesh *multi = NULL;
    tree_mesh *mesh = NULL;
    OK(tree_look_of_tree(tree, 1, &look));
    OK(tree_tree_free(tree));
    OK(tree_multi_mesh_new(multires, look, NULL, NULL, &multi));
    OK(tree_look_free(look));
    draws(multi, multires);
    OK(tree_multires_free(multires));
    shaders();
    files(multi);
    /* The mesh outlives what it is of. */
    OK(tree_multi_mesh_mesh(multi, &mesh));
    OK(tree_multi_mesh_free(multi));
    OK(tree_mesh_check(mesh));
    OK(tree_mesh_free(mesh));
}
