#include "check.h"
#include <math.h>

enum { LEAVES = 24, CORNERS = 8, TIERS = 3, LEVELS = 6, WINDOWS = 64 };

/* A trunk of two triangles, and LEAVES discs of CORNERS triangles around a ball on top of it. */
static tree_mesh *a_ball_of_discs(int with_leaves) {
    enum { VERTICES = CORNERS + 1 };
    static const float trunk[] = {-0.1f, 0, 0, 0.1f, 0, 0, 0.1f, 2, 0, -0.1f, 2, 0};
    static const float trunk_normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    static const float uvs[2 * VERTICES * LEAVES];
    static const uint32_t quad[] = {0, 1, 2, 0, 2, 3};
    static float positions[3 * VERTICES * LEAVES], normals[3 * VERTICES * LEAVES];
    static uint32_t indices[3 * CORNERS * LEAVES];
    for (int i = 0; i < LEAVES; i++) {
        float y = 1 - (2 * (float)i + 1) / LEAVES, ring = sqrtf(1 - y * y), turn = 2.3999632f * (float)i;
        float normal[3] = {ring * cosf(turn), y, ring * sinf(turn)};
        float along[3] = {-sinf(turn), 0, cosf(turn)};
        float up[3] = {-y * cosf(turn), ring, -y * sinf(turn)};
        for (int k = 0; k < VERTICES; k++) {
            float angle = 0.7853982f * (float)k, size = k < CORNERS ? 0.25f : 0;
            float a = size * cosf(angle), b = size * sinf(angle);
            for (int axis = 0; axis < 3; axis++) {
                int at = 3 * (VERTICES * i + k) + axis;
                positions[at] = normal[axis] + (axis == 1 ? 3.0f : 0) + a * along[axis] + b * up[axis];
                normals[at] = normal[axis];
            }
        }
        for (int k = 0; k < CORNERS; k++) {
            uint32_t *corner = indices + 3 * (CORNERS * i + k), first = (uint32_t)(VERTICES * i);
            corner[0] = first + CORNERS;
            corner[1] = first + (uint32_t)k;
            corner[2] = first + (uint32_t)((k + 1) % CORNERS);
        }
    }
    tree_surface surfaces[2] = {
        {.struct_size = sizeof *surfaces, .n_vertices = 4, .n_indices = 6, .positions = trunk,
         .normals = trunk_normals, .uvs = uvs, .indices = quad},
        {.struct_size = sizeof *surfaces, .n_vertices = VERTICES * LEAVES,
         .n_indices = 3 * CORNERS * LEAVES, .positions = positions, .normals = normals, .uvs = uvs,
         .indices = indices, .material = 1}};
    tree_material materials[2];
    OK(tree_material_init(&materials[0], sizeof *materials));
    OK(tree_material_init(&materials[1], sizeof *materials));
    materials[0].name = (tree_str){"bark", 4};
    materials[1].name = (tree_str){"leaves", 6};
    materials[1].base_color[1] = 0.5f;
    tree_mesh *mesh = NULL;
    OK(tree_mesh_from_surfaces(surfaces, with_leaves ? 2 : 1, materials, 2, NULL, 0, NULL, &mesh));
    return mesh;
}

static size_t triangles_of(const tree_mesh *mesh) {
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_mesh_measure(mesh, &totals));
    return totals.n_triangles;
}

static tree_around few_views(void) {
    tree_around around;
    OK(tree_around_init(&around, sizeof around));
    around.azimuths = 4;
    around.size = 64;
    return around;
}

static tree_tiers *three_tiers(const tree_mesh *mesh, const tree_elements *elements) {
    static const float shares[] = {0.5f, 0.25f}, rising[] = {0.25f, 0.5f};
    tree_tiers_params params;
    tree_tiers *tiers = NULL, *none = NULL;
    OK(tree_tiers_params_init(&params, sizeof params));
    CHECK(params.shares == NULL && params.alike == 0.08f && params.worth == 0.9f);
    OK(tree_tiers_params_check(&params));
    params.shares = shares;
    params.n_shares = 2;
    OK(tree_tiers_of_mesh(mesh, elements, &params, NULL, &tiers));
    params.shares = rising;
    FAILS(TREE_ERROR_PARAMETER, "outline.shares", tree_tiers_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "outline.shares",
          tree_tiers_of_mesh(mesh, elements, &params, NULL, &none));
    params.n_shares = 65;
    FAILS(TREE_ERROR_PARAMETER, "shares", tree_tiers_params_check(&params));
    params.n_shares = 0;
    params.alike = NAN;
    FAILS(TREE_ERROR_PARAMETER, "outline.alike", tree_tiers_params_check(&params));
    FAILS(TREE_ERROR_NULL, "mesh", tree_tiers_of_mesh(NULL, elements, NULL, NULL, &none));
    CHECK(none == NULL);
    return tiers;
}

static void tiers_and_own(const tree_mesh *mesh, const tree_mesh *bare, const tree_elements *elements,
                          const tree_tiers *tiers) {
    tree_tier_columns rows[TIERS] = {{.struct_size = sizeof *rows}, {.struct_size = sizeof *rows},
                                     {.struct_size = sizeof *rows}};
    size_t n_tiers = 0;
    OK(tree_tiers_count(tiers, &n_tiers));
    CHECK(n_tiers == TIERS);
    for (size_t i = 0; i < TIERS; i++) OK(tree_tiers_view(tiers, i, &rows[i]));
    CHECK(rows[0].n_elements == LEAVES && rows[0].n_triangles == CORNERS * LEAVES);
    CHECK(rows[1].n_triangles <= 4 * LEAVES && rows[2].n_triangles <= 2 * LEAVES);
    CHECK(rows[2].n_triangles >= LEAVES && rows[2].starts[LEAVES] == rows[2].n_triangles);
    FAILS(TREE_ERROR_PARAMETER, "there are 3", tree_tiers_view(tiers, TIERS, &rows[0]));

    tree_tiers *own = NULL;
    tree_tier_columns again = {.struct_size = sizeof again};
    OK(tree_tiers_from_columns(mesh, elements, rows, TIERS, NULL, &own));
    OK(tree_tiers_view(own, 2, &again));
    CHECK(again.triangles != rows[2].triangles && again.n_triangles == rows[2].n_triangles);
    CHECK(memcmp(again.triangles, rows[2].triangles, 12 * again.n_triangles) == 0);
    OK(tree_tiers_free(own));
    FAILS(TREE_ERROR_INVALID, "no tiers", tree_tiers_from_columns(mesh, elements, NULL, 0, NULL, &own));
    rows[1].n_elements--;
    FAILS(TREE_ERROR_INVALID, "tier.starts",
          tree_tiers_from_columns(mesh, elements, rows, TIERS, NULL, &own));
    rows[1].n_elements++;
    rows[1].n_triangles--;
    FAILS(TREE_ERROR_INVALID, "starts must rise",
          tree_tiers_from_columns(mesh, elements, rows, TIERS, NULL, &own));
    rows[1].starts = NULL;
    FAILS(TREE_ERROR_NULL, "columns[1].starts",
          tree_tiers_from_columns(mesh, elements, rows, TIERS, NULL, &own));
    FAILS(TREE_ERROR_LIMIT, "columns", tree_tiers_from_columns(mesh, elements, rows, 65, NULL, &own));
    FAILS(TREE_ERROR_INVALID, "mesh lacks",
          tree_tiers_from_columns(bare, elements, rows, 1, NULL, &own));
    FAILS(TREE_ERROR_INVALID, "mesh lacks", tree_tiers_full(bare, elements, &own));
    CHECK(own == NULL);
    OK(tree_tiers_full(mesh, elements, &own));
    OK(tree_tiers_count(own, &n_tiers));
    OK(tree_tiers_view(own, 0, &again));
    CHECK(n_tiers == 1 && memcmp(again.triangles, rows[0].triangles, 12 * again.n_triangles) == 0);
    OK(tree_tiers_free(own));
}

static uint32_t order[LEAVES], kept[TIERS];
static float pivots[3 * LEAVES];

/* The order by coverage on the second tier, and the plan. */
static tree_lod_subject planned(const tree_mesh *mesh, const tree_elements *elements,
                                const tree_tiers *tiers) {
    tree_around around = few_views();
    tree_coverage_params params;
    tree_lod_subject subject;
    OK(tree_coverage_params_init(&params, sizeof params));
    params.around = &around;
    OK(tree_order_coverage(mesh, elements, tiers, 1, &params, NULL, order, LEAVES, pivots, 3 * LEAVES));
    OK(tree_order_check(order, LEAVES, LEAVES));
    FAILS(TREE_ERROR_PARAMETER, "there are 3",
          tree_order_coverage(mesh, elements, tiers, 3, &params, NULL, order, LEAVES, pivots, 3 * LEAVES));
    FAILS(TREE_ERROR_PARAMETER, "without tiers",
          tree_order_coverage(mesh, elements, NULL, 1, &params, NULL, order, LEAVES, pivots, 3 * LEAVES));
    OK(tree_lod_subject_init(&subject, sizeof subject));
    subject.mesh = mesh;
    subject.elements = elements;
    subject.order = order;
    subject.n_order = LEAVES;
    subject.pivots = pivots;
    subject.n_pivots = LEAVES;
    OK(tree_lod_plan(&subject, NULL, kept, 1));
    CHECK(kept[0] == LEAVES);
    subject.tiers = tiers;
    FAILS(TREE_ERROR_BUFFER, "kept", tree_lod_plan(&subject, NULL, kept, TIERS - 1));
    OK(tree_lod_plan(&subject, NULL, kept, TIERS));
    CHECK(kept[0] == LEAVES && kept[1] <= kept[0] && kept[2] <= kept[1] && kept[2] >= 1);
    /* The plan may leave tiers out; here they are all to be seen. */
    kept[1] = LEAVES - 4;
    kept[2] = LEAVES - 8;
    subject.kept = kept;
    subject.n_kept = TIERS;
    return subject;
}

static tree_lod_table *measured(const tree_lod_subject *subject) {
    static const float lambdas[] = {0.05f, 0.25f, 0.5f, 1};
    tree_around around = few_views();
    tree_lod_table_params params;
    tree_lod_table *table = NULL;
    OK(tree_lod_table_params_init(&params, sizeof params));
    params.around = &around;
    params.lambdas = lambdas;
    params.n_lambdas = 4;
    OK(tree_lod_table_measure(subject, &params, NULL, &table));
    tree_score scores[4];
    double quality;
    tree_lod_row row;
    OK(tree_lod_table_at(table, 0.25f, &row));
    OK(tree_lod_subject_scores(subject, &row.lambda, 1, &row.scale, 1, &around, NULL, scores, 4));
    OK(tree_score_mean_quality(scores, 4, &quality));
    CHECK(row.quality > 0.5f && fabs(quality - row.quality) < 1e-5);
    return table;
}

static void schedule(const tree_pruned *pruned, const tree_pruned_totals *totals) {
    tree_lod_cut cut, last, fit;
    float lambda, next;
    uint32_t found[TIERS];
    OK(tree_pruned_kept(pruned, found, TIERS));
    CHECK(memcmp(found, kept, sizeof kept) == 0);
    FAILS(TREE_ERROR_BUFFER, "kept", tree_pruned_kept(pruned, found, TIERS - 1));
    OK(tree_pruned_step(pruned, 0, &cut));
    CHECK(cut.n_triangles == CORNERS * LEAVES && cut.tier == 0 && cut.end == LEAVES);
    OK(tree_pruned_step(pruned, totals->n_steps - 1, &last));
    OK(tree_pruned_step(pruned, UINT64_MAX, &cut));
    CHECK(last.end == 1 && last.tier == 2 && cut.n_triangles == last.n_triangles);
    for (uint64_t step = 0; step < totals->n_steps; step++) {
        OK(tree_pruned_step(pruned, step, &cut));
        OK(tree_pruned_lambda_of(pruned, cut.n_triangles, &lambda));
        OK(tree_pruned_cut(pruned, lambda, &fit));
        CHECK(fit.n_triangles == cut.n_triangles);
    }
    CHECK(lambda == totals->least_lambda);
    OK(tree_pruned_cut(pruned, 0, &cut));
    CHECK(cut.n_triangles == last.n_triangles);
    FAILS(TREE_ERROR_PARAMETER, "lambda", tree_pruned_cut(pruned, -0.1f, &cut));
    FAILS(TREE_ERROR_PARAMETER, "lambda", tree_pruned_cut(pruned, 1.1f, &cut));
    FAILS(TREE_ERROR_PARAMETER, "lambda", tree_pruned_cut(pruned, NAN, &cut));
    OK(tree_pruned_lambda_of(pruned, UINT64_MAX, &lambda));
    CHECK(lambda == 1);
    OK(tree_pruned_lambda_of_rank(pruned, 0, &lambda));
    CHECK(lambda == 0);
    for (uint32_t rank = 0; rank <= LEAVES; rank++) {
        OK(tree_pruned_lambda_of_rank(pruned, rank, &next));
        CHECK(next >= lambda);
        lambda = next;
    }
    CHECK(lambda == 1);
}

static void parts(const tree_pruned *pruned, const tree_pruned_totals *totals) {
    CHECK(totals->n_parts == 1 && totals->n_tiers == TIERS && totals->n_elements == LEAVES);
    CHECK(totals->n_triangles == CORNERS * LEAVES && totals->n_steps > LEAVES);
    CHECK(totals->indices_before == 12 * CORNERS * LEAVES && totals->indices_after > totals->indices_before);
    CHECK(totals->vertices_after > totals->vertices_before && totals->vertices_before > 0);
    CHECK(totals->least_lambda > 0 && totals->lambda_of_all > totals->least_lambda);
    tree_pruned_part part = {.struct_size = sizeof part};
    OK(tree_pruned_part_view(pruned, 0, &part));
    CHECK(part.surface == 1 && part.n_vertices >= (CORNERS + 1) * LEAVES && part.mean[1] == 0.5f);
    uint32_t first = order[0];
    const float *center = part.centers + (size_t)4 * (CORNERS + 1) * first;
    CHECK(memcmp(center, pivots + 3 * first, 3 * sizeof(float)) == 0 && center[3] == 0);
    FAILS(TREE_ERROR_PARAMETER, "1 parts", tree_pruned_part_view(pruned, 1, &part));
    part.struct_size = 3;
    FAILS(TREE_ERROR_STRUCT_SIZE, "part", tree_pruned_part_view(pruned, 0, &part));

    tree_lod_table *table = NULL;
    tree_lod_row row;
    OK(tree_pruned_table(pruned, &table));
    OK(tree_lod_table_at(table, 0, &row));
    CHECK(row.lambda == 0.05f && row.scale > 1);
    OK(tree_lod_table_free(table));
}

/* Levels as windows, as meshes and as text; the model's mesh outlives it. */
static void levels(const tree_pruned *pruned) {
    tree_lod_level level, rows[LEVELS];
    tree_lod_window window, windows[LEVELS];
    tree_mesh *mesh = NULL, *same = NULL, *none = NULL;
    size_t n_levels = 0;
    OK(tree_pruned_level(pruned, 1, &level, &window, 1));
    CHECK(level.lambda == 1 && level.growth == 1 && level.contrast == 1 && level.fade == 0);
    CHECK(window.surface == 1 && window.index_count == 3 * CORNERS * LEAVES);
    OK(tree_pruned_mesh_at(pruned, 1, NULL, &mesh));
    CHECK(triangles_of(mesh) == 2 + CORNERS * LEAVES);
    OK(tree_mesh_free(mesh));
    OK(tree_pruned_level(pruned, 0.25f, &level, &window, 1));
    CHECK(level.lambda == 0.25f && level.scale >= 1 && fabsf(level.growth - sqrtf(level.scale)) < 1e-5f);
    CHECK(level.n_triangles <= CORNERS * LEAVES / 4 && 3 * level.n_triangles == window.index_count);
    OK(tree_pruned_mesh_at(pruned, 0.25f, NULL, &mesh));
    CHECK(triangles_of(mesh) == 2 + level.n_triangles);
    level.fade = 0;
    OK(tree_pruned_mesh_of(pruned, &level, &window, 1, NULL, &same));
    tree_bounds box = {.struct_size = sizeof box}, other = box;
    OK(tree_mesh_bounds(mesh, &box));
    OK(tree_mesh_bounds(same, &other));
    CHECK(memcmp(&box, &other, sizeof box) == 0);
    OK(tree_mesh_free(same));
    OK(tree_mesh_free(mesh));

    OK(tree_pruned_levels(pruned, LEVELS, rows, LEVELS, windows, LEVELS, &n_levels));
    CHECK(n_levels == LEVELS && rows[0].lambda == 0.05f && rows[LEVELS - 1].lambda == 1);
    for (size_t i = 1; i < n_levels; i++) {
        CHECK(rows[i].lambda > rows[i - 1].lambda && rows[i].n_triangles >= rows[i - 1].n_triangles);
        CHECK(3 * rows[i].n_triangles == windows[i].index_count);
    }
    tree_bytes *json = NULL;
    const uint8_t *text = NULL;
    size_t len = 0;
    OK(tree_pruned_to_json(pruned, rows, n_levels, windows, n_levels, &json));
    OK(tree_bytes_view(json, &text, &len));
    static const char begin[] = "{\n  \"triangles\": 192, \"elements\": 24, \"least_lambda\": ";
    CHECK(len > 500 && memcmp(text, begin, sizeof begin - 1) == 0);
    OK(tree_bytes_free(json));

    FAILS(TREE_ERROR_PARAMETER, "lambda", tree_pruned_level(pruned, 1.5f, &level, &window, 1));
    FAILS(TREE_ERROR_PARAMETER, "lambda", tree_pruned_level(pruned, NAN, &level, &window, 1));
    FAILS(TREE_ERROR_PARAMETER, "lambda", tree_pruned_mesh_at(pruned, -1, NULL, &none));
    FAILS(TREE_ERROR_BUFFER, "windows", tree_pruned_level(pruned, 1, &level, &window, 0));
    FAILS(TREE_ERROR_NULL, "windows", tree_pruned_level(pruned, 1, &level, NULL, 1));
    FAILS(TREE_ERROR_NULL, "level", tree_pruned_level(pruned, 1, NULL, &window, 1));
    FAILS(TREE_ERROR_PARAMETER, "levels",
          tree_pruned_levels(pruned, 1, rows, LEVELS, windows, LEVELS, &n_levels));
    FAILS(TREE_ERROR_BUFFER, "levels",
          tree_pruned_levels(pruned, LEVELS, rows, 2, windows, LEVELS, &n_levels));
    FAILS(TREE_ERROR_BUFFER, "windows",
          tree_pruned_levels(pruned, LEVELS, rows, LEVELS, windows, 2, &n_levels));
    FAILS(TREE_ERROR_PARAMETER, "n_windows", tree_pruned_to_json(pruned, rows, 2, windows, 3, &json));
    CHECK(json == NULL);
    window.first_index += 3 * CORNERS * LEAVES * TIERS;
    FAILS(TREE_ERROR_INVALID, "another model",
          tree_pruned_mesh_of(pruned, &level, &window, 1, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "another model",
          tree_pruned_mesh_of(pruned, &level, windows, 2, NULL, &none));
    rows[0].growth = NAN;
    FAILS(TREE_ERROR_PARAMETER, "growth",
          tree_pruned_mesh_of(pruned, &rows[0], windows, 1, NULL, &none));
    FAILS(TREE_ERROR_NULL, "level", tree_pruned_mesh_of(pruned, NULL, windows, 1, NULL, &none));
    CHECK(none == NULL);
}

/* What a shader does is what the mesh of a level has. */
static void shaders(const tree_pruned *pruned) {
    tree_str text = {0};
    static const char *const words[] = {"vec3<f32>", "vec3 ", "float3 "};
    for (tree_shader language = TREE_SHADER_WGSL; language <= TREE_SHADER_HLSL; language++) {
        OK(tree_prune_shader(language, &text));
        char *copy = calloc(text.len + 1, 1);
        memcpy(copy, text.data, text.len);
        CHECK(strstr(copy, "tree_prune_position") && strstr(copy, words[language]));
        free(copy);
    }
    FAILS(TREE_ERROR_ENUM, "TREE_SHADER_", tree_prune_shader(3, &text));
    FAILS(TREE_ERROR_NULL, "text", tree_prune_shader(TREE_SHADER_WGSL, NULL));
    static const float at[3] = {2, 0, 0}, center_rank[4] = {1, 0, 0, 0.5f}, mean[3] = {0.2f, 0.2f, 0.2f};
    float drawn[3];
    OK(tree_prune_position(at, center_rank, 3, 1, 0, &drawn));
    CHECK(drawn[0] == 4 && drawn[1] == 0);
    OK(tree_prune_position(at, center_rank, 3, 0.5f, 0.1f, &drawn));
    CHECK(drawn[0] == 1);
    OK(tree_prune_color(at, mean, 0.5f, &drawn));
    CHECK(fabsf(drawn[0] - 1.1f) < 1e-6f && fabsf(drawn[1] - 0.1f) < 1e-6f);
    FAILS(TREE_ERROR_NULL, "center_rank", tree_prune_position(at, NULL, 3, 1, 0, &drawn));
    FAILS(TREE_ERROR_NULL, "drawn", tree_prune_color(at, mean, 1, NULL));

    tree_pruned_part part = {.struct_size = sizeof part};
    tree_lod_level level;
    tree_lod_window window;
    tree_mesh *whole = NULL, *mesh = NULL;
    tree_surface all = {.struct_size = sizeof all}, few = {.struct_size = sizeof few};
    OK(tree_pruned_mesh(pruned, &whole));
    OK(tree_pruned_mesh_at(pruned, 0.25f, NULL, &mesh));
    OK(tree_pruned_part_view(pruned, 0, &part));
    OK(tree_pruned_level(pruned, 0.25f, &level, &window, 1));
    OK(tree_mesh_surface(whole, 1, &all));
    OK(tree_mesh_surface(mesh, 1, &few));
    CHECK(all.n_vertices == part.n_vertices && few.n_indices == window.index_count);
    for (uint32_t i = 0; i < window.index_count; i++) {
        uint32_t vertex = all.indices[window.first_index + i];
        OK(tree_prune_position(all.positions + 3 * vertex, part.centers + 4 * vertex, level.growth,
                               level.lambda, 0, &drawn));
        CHECK(memcmp(drawn, few.positions + 3 * few.indices[i], sizeof drawn) == 0);
    }
    OK(tree_mesh_free(mesh));
    OK(tree_mesh_free(whole));
}

static void scenes(const tree_pruned *pruned) {
    tree_scene_levels *levels = NULL, *none = NULL;
    tree_lod_distance distance;
    OK(tree_lod_distance_cook(&distance));
    OK(tree_pruned_scene_levels(pruned, LEVELS, &distance, &levels));
    OK(tree_scene_levels_free(levels));
    OK(tree_pruned_scene_levels(pruned, LEVELS, NULL, &levels));
    tree_scene_model model = {.struct_size = sizeof model};
    OK(tree_scene_levels_model(levels, &model));
    CHECK(model.n_levels == LEVELS && model.n_parts == 2 && model.radius > 1 && model.near == 10);
    CHECK(model.lambdas[0] == 0.05f && model.scales[LEVELS - 1] == 1 && model.fades[0] > 0);
    CHECK(model.draws[0].index_count == 6 && model.draws[1].base_vertex == 4);
    CHECK(model.draws[2 * LEVELS - 1].index_count == 3 * CORNERS * LEAVES);
    CHECK(memcmp(model.distance, &distance, sizeof distance) == 0);
    OK(tree_scene_model_check(&model));
    tree_scene *scene = NULL;
    tree_scene_instance instance = {.rotation = {0, 0, 0, 1}, .scale = 1};
    OK(tree_scene_new(&model, 1, &instance, 1, NULL, &scene));
    OK(tree_scene_levels_free(levels));
    tree_scene_needs needs = {.struct_size = sizeof needs};
    OK(tree_scene_measure(scene, &needs));
    CHECK(needs.most_draws == 2 && needs.most_indices == 6 + 3 * CORNERS * LEAVES);
    OK(tree_scene_free(scene));
    FAILS(TREE_ERROR_PARAMETER, "levels", tree_pruned_scene_levels(pruned, 1, NULL, &none));
    distance.lambdas[3] = 2;
    FAILS(TREE_ERROR_PARAMETER, "", tree_pruned_scene_levels(pruned, LEVELS, &distance, &none));
    FAILS(TREE_ERROR_NULL, "levels", tree_scene_levels_model(NULL, &model));
    CHECK(none == NULL);
}

static int holds(const tree_bytes *bytes, const char *word) {
    const uint8_t *data = NULL;
    size_t len = 0, n = strlen(word);
    OK(tree_bytes_view(bytes, &data, &len));
    for (size_t i = 0; i + n <= len; i++)
        if (memcmp(data + i, word, n) == 0) return 1;
    return 0;
}

static const char *a_path(void) {
    static char path[4096];
    const char *folder = getenv("TREE_TEST_DIR");
    snprintf(path, sizeof path, "%s/tree_test_pruned.glb", folder ? folder : ".");
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

static void files(const tree_pruned *pruned) {
    const char *path = a_path();
    static const float lambdas[] = {1, 0.5f, 0.1f}, rising[] = {0.1f, 0.5f}, outside[] = {2, 0.5f};
    tree_glb_options options;
    tree_lod_screen screen;
    tree_bytes *bytes = NULL, *none = NULL;
    OK(tree_glb_options_init(&options, sizeof options));
    OK(tree_pruned_to_glb(pruned, &options, NULL, &bytes));
    CHECK(holds(bytes, "_TREE_CENTER"));
    OK(tree_pruned_write_glb(pruned, path, TREE_NUL_TERMINATED, &options, NULL));
    same_file(path, bytes);
    OK(tree_bytes_free(bytes));
    options.quantize = 1;
    FAILS(TREE_ERROR_PARAMETER, "quantize", tree_pruned_to_glb(pruned, &options, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "quantize",
          tree_pruned_write_glb(pruned, path, TREE_NUL_TERMINATED, &options, NULL));
    FAILS(TREE_ERROR_IO, "nowhere",
          tree_pruned_write_glb(pruned, "/nowhere/a.glb", TREE_NUL_TERMINATED, NULL, NULL));

    OK(tree_lod_screen_init(&screen, sizeof screen));
    CHECK(screen.near == 10 && screen.far == 500 && screen.distance == NULL);
    OK(tree_lod_screen_check(&screen));
    float near = 0, far = 0;
    OK(tree_lod_screen_coverage(&screen, 0.9f, 4, &near));
    OK(tree_lod_screen_coverage(&screen, 0.1f, 4, &far));
    CHECK(near > far && near < 1 && far > 0);
    OK(tree_pruned_to_glb_levels(pruned, lambdas, 3, &screen, &options, NULL, &bytes));
    CHECK(holds(bytes, "MSFT_lod") && holds(bytes, "MSFT_screencoverage"));
    OK(tree_pruned_write_glb_levels(pruned, lambdas, 3, &screen, path, strlen(path), &options, NULL));
    same_file(path, bytes);
    OK(tree_bytes_free(bytes));
    FAILS(TREE_ERROR_INVALID, "falls", tree_pruned_to_glb_levels(pruned, rising, 2, NULL, NULL, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "falls",
          tree_pruned_write_glb_levels(pruned, rising, 2, NULL, path, strlen(path), NULL, NULL));
    FAILS(TREE_ERROR_INVALID, "falls", tree_pruned_to_glb_levels(pruned, NULL, 0, NULL, NULL, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "lambda",
          tree_pruned_to_glb_levels(pruned, outside, 2, NULL, NULL, NULL, &none));
    FAILS(TREE_ERROR_NULL, "lambdas", tree_pruned_to_glb_levels(pruned, NULL, 2, NULL, NULL, NULL, &none));
    screen.far = screen.near;
    FAILS(TREE_ERROR_PARAMETER, "far", tree_lod_screen_check(&screen));
    FAILS(TREE_ERROR_PARAMETER, "far", tree_lod_screen_coverage(&screen, 0.5f, 4, &far));
    FAILS(TREE_ERROR_PARAMETER, "far",
          tree_pruned_to_glb_levels(pruned, lambdas, 3, &screen, NULL, NULL, &none));
    CHECK(none == NULL);
}

static void bad_models(const tree_lod_subject *good, const tree_lod_table *table, const tree_mesh *bare) {
    tree_pruned *none = NULL;
    tree_prune_params params;
    OK(tree_prune_params_init(&params, sizeof params));
    CHECK(params.fade == 0.1f);
    OK(tree_prune_params_check(&params));
    params.fade = 1.5f;
    FAILS(TREE_ERROR_PARAMETER, "fade", tree_prune_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "fade", tree_pruned_new(good, table, &params, NULL, &none));
    tree_lod_subject subject = *good;
    static float nowhere[3 * LEAVES];
    nowhere[7] = NAN;
    subject.pivots = nowhere;
    FAILS(TREE_ERROR_PARAMETER, "pivots", tree_pruned_new(&subject, table, NULL, NULL, &none));
    nowhere[7] = 1e9f;
    FAILS(TREE_ERROR_PARAMETER, "pivots", tree_pruned_new(&subject, table, NULL, NULL, &none));
    subject = *good;
    subject.n_pivots = 3;
    FAILS(TREE_ERROR_INVALID, "pivots", tree_pruned_new(&subject, table, NULL, NULL, &none));
    subject = *good;
    subject.n_order--;
    FAILS(TREE_ERROR_INVALID, "order", tree_pruned_new(&subject, table, NULL, NULL, &none));
    subject = *good;
    subject.n_kept = 2;
    FAILS(TREE_ERROR_INVALID, "kept", tree_pruned_new(&subject, table, NULL, NULL, &none));
    static const uint32_t rising[TIERS] = {LEAVES, 4, 5};
    subject = *good;
    subject.kept = rising;
    FAILS(TREE_ERROR_PARAMETER, "kept", tree_pruned_new(&subject, table, NULL, NULL, &none));
    tree_lod_table *no_table = NULL;
    FAILS(TREE_ERROR_PARAMETER, "kept", tree_lod_table_measure(&subject, NULL, NULL, &no_table));
    CHECK(no_table == NULL);
    subject = *good;
    subject.mesh = bare;
    FAILS(TREE_ERROR_INVALID, "mesh lacks", tree_pruned_new(&subject, table, NULL, NULL, &none));
    FAILS(TREE_ERROR_NULL, "table", tree_pruned_new(good, NULL, NULL, NULL, &none));
    FAILS(TREE_ERROR_NULL, "subject", tree_pruned_new(NULL, table, NULL, NULL, &none));
    CHECK(none == NULL);
}

static void in_one_call(const tree_mesh *mesh, const tree_mesh *bare) {
    static const uint32_t leaves[] = {1};
    static const float stages[] = {0.5f, 0.2f}, lambdas[] = {0.1f, 0.5f, 1}, shares[] = {0.5f};
    tree_around around = few_views();
    tree_prune_make_params params;
    tree_coverage_params coverage;
    tree_lod_table_params measure;
    tree_tiers_params outlines;
    tree_prune_params prune;
    tree_pruned *pruned = NULL, *none = NULL;
    OK(tree_prune_make_params_init(&params, sizeof params));
    CHECK(params.order == NULL && params.grain == TREE_GRAIN_BLADE);
    OK(tree_coverage_params_init(&coverage, sizeof coverage));
    OK(tree_lod_table_params_init(&measure, sizeof measure));
    OK(tree_tiers_params_init(&outlines, sizeof outlines));
    OK(tree_prune_params_init(&prune, sizeof prune));
    coverage.around = measure.around = &around;
    coverage.stages = stages;
    coverage.n_stages = 2;
    measure.lambdas = lambdas;
    measure.n_lambdas = 3;
    outlines.shares = shares;
    outlines.n_shares = 1;
    prune.fade = 0;
    params.surfaces = leaves;
    params.n_surfaces = 1;
    params.order = &coverage;
    params.table = &measure;
    params.outlines = &outlines;
    params.prune = &prune;
    OK(tree_pruned_make(mesh, &params, NULL, &pruned));
    tree_pruned_totals totals = {.struct_size = sizeof totals};
    OK(tree_pruned_measure(pruned, &totals));
    CHECK(totals.n_tiers == 2 && totals.n_elements == LEAVES);
    tree_lod_level level;
    tree_lod_window window;
    OK(tree_pruned_level(pruned, 0.1f, &level, &window, 1));
    CHECK(level.fade == 0 && level.scale > 1);
    OK(tree_pruned_free(pruned));
    FAILS(TREE_ERROR_INVALID, "foliage", tree_pruned_make(bare, NULL, NULL, &none));
    params.grain = 3;
    FAILS(TREE_ERROR_ENUM, "TREE_GRAIN_", tree_pruned_make(mesh, &params, NULL, &none));
    params.grain = TREE_GRAIN_BLADE;
    measure.n_lambdas = 2;
    FAILS(TREE_ERROR_INVALID, "table", tree_pruned_make(mesh, &params, NULL, &none));
    measure.struct_size = 1;
    FAILS(TREE_ERROR_STRUCT_SIZE, "params.table", tree_pruned_make(mesh, &params, NULL, &none));
    FAILS(TREE_ERROR_NULL, "mesh", tree_pruned_make(NULL, NULL, NULL, &none));
    tree_cancel *cancel = NULL;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "", tree_pruned_make(mesh, NULL, &control, &none));
    OK(tree_cancel_free(cancel));
    CHECK(none == NULL);
}

void test_prune(void) {
    tree_mesh *mesh = a_ball_of_discs(1), *bare = a_ball_of_discs(0), *shared = NULL;
    tree_elements *elements = NULL;
    OK(tree_elements_of_mesh(mesh, NULL, 0, TREE_GRAIN_BLADE, NULL, &elements));
    tree_tiers *tiers = three_tiers(mesh, elements);
    tiers_and_own(mesh, bare, elements, tiers);
    tree_lod_subject subject = planned(mesh, elements, tiers);
    tree_lod_table *table = measured(&subject);
    bad_models(&subject, table, bare);
    tree_pruned *pruned = NULL;
    OK(tree_pruned_new(&subject, table, NULL, NULL, &pruned));
    OK(tree_lod_table_free(table));
    OK(tree_tiers_free(tiers));
    OK(tree_elements_free(elements));
    tree_pruned_totals totals = {.struct_size = sizeof totals};
    OK(tree_pruned_measure(pruned, &totals));
    parts(pruned, &totals);
    schedule(pruned, &totals);
    levels(pruned);
    shaders(pruned);
    scenes(pruned);
    files(pruned);
    OK(tree_pruned_mesh(pruned, &shared));
    OK(tree_pruned_free(pruned));
    CHECK(triangles_of(shared) == 2 + totals.indices_after / 12);
    OK(tree_mesh_free(shared));
    in_one_call(mesh, bare);
    OK(tree_mesh_free(bare));
    OK(tree_mesh_free(mesh));
}
