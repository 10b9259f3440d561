#include "check.h"
#include <math.h>

enum { CARDS = 64 };

/* A trunk of two triangles, and CARDS cards around a ball on top of it. */
static tree_mesh *a_ball_of_cards(int with_leaves) {
    static const float trunk[] = {-0.1f, 0, 0, 0.1f, 0, 0, 0.1f, 2, 0, -0.1f, 2, 0};
    static const float trunk_normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, uvs[8 * CARDS];
    static const uint32_t quad[] = {0, 1, 2, 0, 2, 3};
    static float positions[12 * CARDS], normals[12 * CARDS];
    static uint32_t indices[6 * CARDS];
    for (int i = 0; i < CARDS; i++) {
        float y = 1 - (2 * (float)i + 1) / CARDS, ring = sqrtf(1 - y * y), turn = 2.3999632f * (float)i;
        float normal[3] = {ring * cosf(turn), y, ring * sinf(turn)};
        float along[3] = {-sinf(turn), 0, cosf(turn)};
        float up[3] = {-y * cosf(turn), ring, -y * sinf(turn)};
        for (int k = 0; k < 4; k++) {
            float a = k == 0 || k == 3 ? -0.15f : 0.15f, b = k < 2 ? -0.15f : 0.15f;
            for (int axis = 0; axis < 3; axis++) {
                float center = normal[axis] + (axis == 1 ? 3.0f : 0.0f);
                positions[12 * i + 3 * k + axis] = center + a * along[axis] + b * up[axis];
                normals[12 * i + 3 * k + axis] = normal[axis];
            }
        }
        for (int k = 0; k < 6; k++) indices[6 * i + k] = (uint32_t)(4 * i) + quad[k];
    }
    tree_surface surfaces[2] = {
        {.struct_size = sizeof *surfaces, .n_vertices = 4, .n_indices = 6, .positions = trunk,
         .normals = trunk_normals, .uvs = uvs, .indices = quad},
        {.struct_size = sizeof *surfaces, .n_vertices = 4 * CARDS, .n_indices = 6 * CARDS,
         .positions = positions, .normals = normals, .uvs = uvs, .indices = indices, .material = 1}};
    tree_material materials[2];
    OK(tree_material_init(&materials[0], sizeof *materials));
    OK(tree_material_init(&materials[1], sizeof *materials));
    materials[0].name = (tree_str){"bark", 4};
    materials[1].name = (tree_str){"leaves", 6};
    tree_mesh *mesh = NULL;
    OK(tree_mesh_from_surfaces(surfaces, with_leaves ? 2 : 1, materials, 2, NULL, 0, NULL, &mesh));
    return mesh;
}

static tree_elements *elements_of(const tree_mesh *mesh) {
    tree_elements *elements = NULL;
    OK(tree_elements_of_mesh(mesh, NULL, 0, TREE_GRAIN_BLADE, NULL, &elements));
    return elements;
}

static float length_of(const float *v) {
    return sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void elements_and_grains(const tree_mesh *mesh) {
    tree_elements *elements = elements_of(mesh), *found = NULL;
    tree_elements_columns view = {.struct_size = sizeof view};
    OK(tree_elements_view(elements, &view));
    CHECK(view.n_elements == CARDS && view.n_triangles == 2 * CARDS && view.n_surfaces == 1);
    CHECK(view.surfaces[0] == 1 && view.surface[CARDS - 1] == 1);
    CHECK(view.starts[0] == 0 && view.starts[CARDS] == 2 * CARDS && view.triangles[3] == 3);
    CHECK(fabsf(view.areas[5] - 0.09f) < 1e-4f && view.radii[5] > 0.1f && view.radii[5] < 0.3f);
    CHECK(fabsf(length_of(view.normals + 15) - 1) < 1e-4f);
    CHECK(fabsf(view.centers[1] - (4 - 1.0f / CARDS)) < 1e-4f);
    float metres;
    OK(tree_elements_plant_height(elements, &metres));
    CHECK(fabsf(metres - view.centers[1]) < 1e-5f);
    /* The same again, and two cards alone. */
    tree_elements_columns own = view, again = view;
    OK(tree_elements_from_columns(mesh, &own, NULL, &found));
    OK(tree_elements_view(found, &again));
    CHECK(again.n_triangles == view.n_triangles && again.centers != view.centers);
    CHECK(memcmp(again.centers, view.centers, 3 * CARDS * sizeof(float)) == 0);
    OK(tree_elements_free(found));
    own.n_elements = 2;
    FAILS(TREE_ERROR_INVALID, "starts", tree_elements_from_columns(mesh, &own, NULL, &found));
    own.n_triangles = 4;
    OK(tree_elements_from_columns(mesh, &own, NULL, &found));
    OK(tree_elements_free(found));
    own.areas = NULL;
    FAILS(TREE_ERROR_NULL, "areas", tree_elements_from_columns(mesh, &own, NULL, &found));
    own = view;
    own.surface = own.triangles;
    FAILS(TREE_ERROR_INVALID, "not pruned", tree_elements_from_columns(mesh, &own, NULL, &found));
    uint32_t beyond[2 * CARDS];
    memset(beyond, 0xff, sizeof beyond);
    own = view;
    own.triangles = beyond;
    FAILS(TREE_ERROR_INVALID, "mesh lacks", tree_elements_from_columns(mesh, &own, NULL, &found));
    own.n_elements = SIZE_MAX;
    FAILS(TREE_ERROR_LIMIT, "", tree_elements_from_columns(mesh, &own, NULL, &found));
    CHECK(found == NULL);
    OK(tree_elements_free(elements));

    static const uint32_t leaves[] = {1, 1}, none[] = {7};
    OK(tree_elements_of_mesh(mesh, leaves, 1, TREE_GRAIN_TRIANGLE, NULL, &found));
    OK(tree_elements_view(found, &view));
    CHECK(view.n_elements == 2 * CARDS);
    OK(tree_elements_free(found));
    OK(tree_elements_of_mesh(mesh, leaves, 1, TREE_GRAIN_LEAF, NULL, &found));
    OK(tree_elements_free(found));
    FAILS(TREE_ERROR_ENUM, "TREE_GRAIN_", tree_elements_of_mesh(mesh, NULL, 0, 3, NULL, &found));
    CHECK(found == NULL);
    FAILS(TREE_ERROR_INVALID, "foliage", tree_elements_of_mesh(mesh, leaves, 2, 0, NULL, &found));
    FAILS(TREE_ERROR_INVALID, "foliage", tree_elements_of_mesh(mesh, none, 1, 0, NULL, &found));
    FAILS(TREE_ERROR_NULL, "surfaces", tree_elements_of_mesh(mesh, NULL, 1, 0, NULL, &found));
    FAILS(TREE_ERROR_NULL, "mesh", tree_elements_of_mesh(NULL, NULL, 0, 0, NULL, &found));
    FAILS(TREE_ERROR_HANDLE, "elements", tree_elements_view((const tree_elements *)mesh, &view));
    /* A trunk has nothing that could be pruned. */
    tree_mesh *bare = a_ball_of_cards(0);
    FAILS(TREE_ERROR_INVALID, "foliage", tree_elements_of_mesh(bare, NULL, 0, 0, NULL, &found));
    CHECK(found == NULL);
    OK(tree_mesh_free(bare));
}

static tree_around few_views(void) {
    tree_around around;
    OK(tree_around_init(&around, sizeof around));
    CHECK(around.azimuths == 8 && around.size == 512 && around.n_pitches == 0 && around.fov == 0);
    OK(tree_around_check(&around));
    around.azimuths = 4;
    around.size = 64;
    return around;
}

static void views(void) {
    static const float pitches[] = {0, 0.4f, NAN};
    tree_around around = few_views();
    size_t n_views;
    around.pitches = pitches;
    around.n_pitches = 2;
    OK(tree_around_count(&around, &n_views));
    CHECK(n_views == 8);
    tree_view view = {.struct_size = sizeof view};
    OK(tree_around_view(&around, 5, &view));
    CHECK(view.camera == TREE_CAMERA_FRAMED && view.lens == TREE_LENS_ORTHOGRAPHIC);
    CHECK(view.pitch == 0.4f && view.width == 64 && view.height == 64);
    FAILS(TREE_ERROR_PARAMETER, "8 views", tree_around_view(&around, 8, &view));
    around.n_pitches = 3;
    FAILS(TREE_ERROR_PARAMETER, "", tree_around_check(&around));
    around.n_pitches = 65;
    FAILS(TREE_ERROR_PARAMETER, "pitches", tree_around_check(&around));
    around.n_pitches = 1;
    around.size = 7;
    FAILS(TREE_ERROR_PARAMETER, "around.size", tree_around_count(&around, &n_views));
    FAILS(TREE_ERROR_NULL, "around", tree_around_check(NULL));
    OK(tree_around_for_order(&around, sizeof around, 100));
    CHECK(around.azimuths == 12 && around.n_pitches == 2 && around.pitches[1] > 0.3f);
    OK(tree_around_for_order(&around, sizeof around, 4000000));
    CHECK(around.azimuths == 4 && around.size < 256);
    OK(tree_around_for_table(&around, sizeof around, 100));
    CHECK(around.azimuths == 8 && around.size == 256 && around.pitches[0] == 0);
    OK(tree_around_check(&around));
}

static void masks(const tree_mesh *mesh, const tree_mesh *bare) {
    tree_around around = few_views();
    tree_view view = {.struct_size = sizeof view};
    OK(tree_around_view(&around, 0, &view));
    view.camera = TREE_CAMERA_PLACED;
    view.lens_height = 5;
    view.eye[1] = view.target[1] = 2.5f;
    view.eye[2] = 20;
    tree_bits *full = NULL, *trunk = NULL, *none = NULL;
    OK(tree_bits_of_mesh(mesh, &view, NULL, &full));
    OK(tree_bits_of_mesh(bare, &view, NULL, &trunk));
    tree_bits_size size = {.struct_size = sizeof size};
    OK(tree_bits_measure(full, &size));
    CHECK(size.width == 64 && size.height == 64 && size.n_words == 64 && size.n_pixels == 4096);
    CHECK(size.count > 200 && size.count < 1000);
    uint64_t words[64], n_bits = 0;
    static uint8_t bytes[4096];
    OK(tree_bits_words(full, words, 64));
    OK(tree_bits_bytes(full, bytes, sizeof bytes));
    for (int i = 0; i < 4096; i++) {
        CHECK(bytes[i] == (words[i / 64] >> (i % 64) & 1 ? 255 : 0));
        n_bits += bytes[i] == 255;
    }
    CHECK(n_bits == size.count);
    FAILS(TREE_ERROR_BUFFER, "words", tree_bits_words(full, words, 63));
    FAILS(TREE_ERROR_BUFFER, "bytes", tree_bits_bytes(full, bytes, 4095));
    tree_score score;
    OK(tree_bits_score(trunk, full, &score));
    CHECK(score.both > 0 && score.wrong == 0 && score.both + score.missed == size.count);
    double precision, recall, quality, mean;
    OK(tree_score_quality(&score, &precision, &recall, &quality));
    CHECK(precision == 1 && recall > 0 && recall < 0.5 && fabs(quality - recall) < 1e-12);
    OK(tree_score_mean_quality(&score, 1, &mean));
    CHECK(mean == quality);
    OK(tree_score_mean_quality(NULL, 0, &mean));
    CHECK(mean == 0);
    score.both = UINT64_MAX;
    FAILS(TREE_ERROR_PARAMETER, "score", tree_score_quality(&score, &precision, &recall, &quality));
    FAILS(TREE_ERROR_NULL, "score", tree_score_quality(NULL, &precision, &recall, &quality));
    view.height = 32;
    FAILS(TREE_ERROR_PARAMETER, "view.height", tree_bits_of_mesh(mesh, &view, NULL, &none));
    CHECK(none == NULL);
    OK(tree_bits_free(trunk));
    OK(tree_bits_free(full));

    tree_score scores[4];
    OK(tree_mesh_score(mesh, mesh, &around, NULL, scores, 4));
    OK(tree_score_mean_quality(scores, 4, &mean));
    CHECK(mean == 1);
    OK(tree_mesh_score(bare, mesh, &around, NULL, scores, 4));
    CHECK(scores[3].missed > 100);
    FAILS(TREE_ERROR_BUFFER, "scores", tree_mesh_score(bare, mesh, &around, NULL, scores, 3));
    around.fov = NAN;
    FAILS(TREE_ERROR_PARAMETER, "fov", tree_mesh_score(bare, mesh, &around, NULL, scores, 4));
}

typedef struct measured_table {
    tree_lod_table *table;
    const tree_lod_row *rows;
    size_t n_rows;
} measured_table;

static measured_table measured(const tree_lod_subject *subject, tree_lod_scale scale) {
    static const float lambdas[] = {0.25f, 0.5f, 1};
    tree_around around = few_views();
    tree_lod_table_params params;
    measured_table made = {0};
    OK(tree_lod_table_params_init(&params, sizeof params));
    OK(tree_lod_table_params_check(&params));
    params.around = &around;
    params.lambdas = lambdas;
    params.n_lambdas = 3;
    params.scale = scale;
    params.fixed = 1.5f;
    OK(tree_lod_table_measure(subject, &params, NULL, &made.table));
    OK(tree_lod_table_rows(made.table, &made.rows, &made.n_rows));
    params.scale = 9;
    FAILS(TREE_ERROR_ENUM, "TREE_LOD_SCALE_", tree_lod_table_params_check(&params));
    params.scale = TREE_LOD_SCALE_FIXED;
    params.fixed = 0;
    FAILS(TREE_ERROR_PARAMETER, "scale", tree_lod_table_params_check(&params));
    params.n_lambdas = 2;
    params.fixed = 1;
    FAILS(TREE_ERROR_INVALID, "table", tree_lod_table_params_check(&params));
    return made;
}

static void tables(const tree_mesh *mesh, const tree_mesh *bare, const tree_elements *elements) {
    uint32_t order[CARDS];
    float pivots[3 * CARDS];
    tree_lod_subject subject;
    OK(tree_lod_subject_init(&subject, sizeof subject));
    tree_lod_table *none = NULL;
    FAILS(TREE_ERROR_NULL, "subject.mesh", tree_lod_table_measure(&subject, NULL, NULL, &none));
    OK(tree_order_stochastic(elements, 1, order, CARDS));
    subject.mesh = mesh;
    subject.elements = elements;
    FAILS(TREE_ERROR_INVALID, "order", tree_lod_table_measure(&subject, NULL, NULL, &none));
    subject.order = order;
    subject.n_order = CARDS;
    measured_table cook = measured(&subject, TREE_LOD_SCALE_COOK);
    CHECK(cook.n_rows == 3 && cook.rows[0].lambda == 0.25f && fabsf(cook.rows[0].scale - 4) < 1e-4f);
    CHECK(cook.rows[2].quality == 1 && cook.rows[2].scale == 1 && cook.rows[0].quality < 0.9f);
    measured_table best = measured(&subject, TREE_LOD_SCALE_BEST);
    CHECK(best.rows[0].quality >= cook.rows[0].quality && best.rows[0].recall > 0);
    measured_table fixed = measured(&subject, TREE_LOD_SCALE_FIXED);
    CHECK(fabsf(fixed.rows[1].scale - 1.5f) < 1e-5f && fixed.rows[1].precision < 1);
    measured_table kept = measured(&subject, TREE_LOD_SCALE_KEPT);
    CHECK(kept.rows[0].scale == 1 && kept.rows[0].precision > 0.99f);

    tree_around around = few_views();
    tree_score scores[8];
    double mean;
    float shares[] = {0.25f, 1}, scales[] = {4, 1};
    OK(tree_lod_subject_scores(&subject, shares, 2, scales, 2, &around, NULL, scores, 8));
    OK(tree_score_mean_quality(scores, 4, &mean));
    CHECK(fabs(mean - cook.rows[0].quality) < 1e-6);
    OK(tree_score_mean_quality(scores + 4, 4, &mean));
    CHECK(mean == 1);
    OK(tree_lod_subject_scores(&subject, NULL, 0, NULL, 0, &around, NULL, NULL, 0));
    FAILS(TREE_ERROR_BUFFER, "scores",
          tree_lod_subject_scores(&subject, shares, 2, scales, 2, &around, NULL, scores, 7));
    FAILS(TREE_ERROR_NULL, "scales", tree_lod_subject_scores(&subject, shares, 2, NULL, 2, &around, NULL, scores, 8));
    FAILS(TREE_ERROR_INVALID, "scales", tree_lod_subject_scores(&subject, shares, 2, scales, 1, &around, NULL, scores, 8));
    scales[1] = 0;
    FAILS(TREE_ERROR_PARAMETER, "scale",
          tree_lod_subject_scores(&subject, shares, 2, scales, 2, &around, NULL, scores, 8));
    shares[0] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "lambda",
          tree_lod_subject_scores(&subject, shares, 1, scales, 1, &around, NULL, scores, 8));
    shares[0] = 1.5f;
    FAILS(TREE_ERROR_PARAMETER, "lambda",
          tree_lod_subject_scores(&subject, shares, 1, scales, 1, &around, NULL, scores, 8));
    subject.mesh = bare;
    FAILS(TREE_ERROR_INVALID, "mesh lacks", tree_lod_table_measure(&subject, NULL, NULL, &none));
    subject.mesh = mesh;
    order[3] = order[2];
    FAILS(TREE_ERROR_INVALID, "order, row 3", tree_lod_table_measure(&subject, NULL, NULL, &none));
    OK(tree_order_golden(elements, order, CARDS));
    memset(pivots, 0xff, sizeof pivots);
    subject.pivots = pivots;
    subject.n_pivots = CARDS;
    FAILS(TREE_ERROR_INVALID, "pivot", tree_lod_table_measure(&subject, NULL, NULL, &none));
    subject.n_pivots = 3;
    FAILS(TREE_ERROR_INVALID, "pivots: 3 rows", tree_lod_table_measure(&subject, NULL, NULL, &none));
    CHECK(none == NULL);

    tree_lod_distance distance;
    OK(tree_lod_distance_parity(best.table, cook.table, &distance));
    CHECK(distance.lambdas[0] == 1 && distance.lambdas[20] == 0.25f);
    OK(tree_lod_table_free(cook.table));
    OK(tree_lod_table_free(best.table));
    OK(tree_lod_table_free(fixed.table));
    OK(tree_lod_table_free(kept.table));
}

static void rows_and_distances(void) {
    static const tree_lod_row rows[] = {
        {0.1f, 4, 0.6f, 0.6f, 0.6f}, {0.5f, 2, 0.8f, 0.8f, 0.8f}, {1, 1, 1, 1, 1}};
    tree_lod_table *table = NULL, *none = NULL;
    OK(tree_lod_table_from_rows(rows, 3, &table));
    tree_lod_row row;
    float lambda;
    OK(tree_lod_table_at(table, 0.3f, &row));
    CHECK(fabsf(row.scale - 3) < 1e-5f && row.lambda == 0.3f && fabsf(row.quality - 0.7f) < 1e-5f);
    OK(tree_lod_table_lambda_for(table, 0.7f, &lambda));
    CHECK(fabsf(lambda - 0.3f) < 1e-5f);
    FAILS(TREE_ERROR_INVALID, "row 1", tree_lod_table_from_rows(rows, 2, &none));
    FAILS(TREE_ERROR_INVALID, "table", tree_lod_table_from_rows(NULL, 0, &none));
    FAILS(TREE_ERROR_NULL, "rows", tree_lod_table_from_rows(NULL, 3, &none));
    tree_lod_row bad = {1, NAN, 1, 1, 1};
    FAILS(TREE_ERROR_INVALID, "row 0", tree_lod_table_from_rows(&bad, 1, &none));
    CHECK(none == NULL);

    tree_lod_distance distance;
    float places[TREE_LOD_DISTANCE_SAMPLES];
    OK(tree_lod_distance_cook(&distance));
    OK(tree_lod_distance_places(places, TREE_LOD_DISTANCE_SAMPLES));
    FAILS(TREE_ERROR_BUFFER, "places", tree_lod_distance_places(places, 20));
    CHECK(sizeof distance == sizeof places && fabsf(places[11] - 0.19f) < 1e-6f && places[20] == 1);
    OK(tree_lod_distance_lambda(&distance, 0.55f, &lambda));
    CHECK(fabsf(lambda - 0.2025f) < 1e-2f);
    OK(tree_lod_distance_lambda(&distance, NAN, &lambda));
    CHECK(lambda == 0);
    OK(tree_lod_distance_for_quality(table, 1, 0.6f, &distance));
    CHECK(distance.lambdas[0] == 1 && distance.lambdas[20] == 0.1f);
    FAILS(TREE_ERROR_PARAMETER, "quality", tree_lod_distance_for_quality(table, 1, NAN, &distance));
    for (int i = 0; i < TREE_LOD_DISTANCE_SAMPLES; i++) places[i] = i == 5 ? 0.9f : 0.5f;
    OK(tree_lod_distance_from_samples(places, TREE_LOD_DISTANCE_SAMPLES, &distance));
    CHECK(distance.lambdas[5] == 0.5f);
    FAILS(TREE_ERROR_INVALID, "21", tree_lod_distance_from_samples(places, 20, &distance));
    places[7] = 1.1f;
    FAILS(TREE_ERROR_PARAMETER, "lambda",
          tree_lod_distance_from_samples(places, TREE_LOD_DISTANCE_SAMPLES, &distance));
    distance.lambdas[2] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "lambda", tree_lod_distance_lambda(&distance, 0.5f, &lambda));
    FAILS(TREE_ERROR_NULL, "distance", tree_lod_distance_lambda(NULL, 0.5f, &lambda));
    OK(tree_lod_table_free(table));
}

static void rules(void) {
    float found;
    OK(tree_lod_cook_scale(0.25f, &found));
    CHECK(found == 4);
    OK(tree_lod_cook_lambda(0.5f, &found));
    CHECK(found == 0.25f);
    OK(tree_lod_size_lambda(50, 200, 0.25f, &found));
    CHECK(fabsf(found - 0.5f) < 1e-5f);
    FAILS(TREE_ERROR_PARAMETER, "h is", tree_lod_size_lambda(50, 200, 1, &found));
    OK(tree_lod_drop_and_resize(8, 2, 1, &found));
    CHECK(found == 2);
    FAILS(TREE_ERROR_PARAMETER, "k is", tree_lod_drop_and_resize(8, 9, 1, &found));
    OK(tree_lod_contrast(0.25f, 4, &found));
    CHECK(fabsf(found - 0.5f) < 1e-6f);
    FAILS(TREE_ERROR_NULL, "contrast", tree_lod_contrast(0.25f, 4, NULL));
}

static void fields(const tree_elements *elements) {
    static const float points[] = {0, 0, 0, 0.5f, 0, 0, NAN, 0, 0};
    float values[3], gradients[9], box[6], radius;
    size_t n_points;
    tree_metaballs *field = NULL, *none = NULL;
    OK(tree_metaballs_new(points, 2, 1, NULL, &field));
    OK(tree_metaballs_radius(field, &radius));
    OK(tree_metaballs_count(field, &n_points));
    OK(tree_metaballs_bounds(field, &box));
    CHECK(radius == 1 && n_points == 2 && box[3] == 0.5f && box[1] == 0);
    OK(tree_metaballs_values(field, points, 3, NULL, values, 3));
    CHECK(fabsf(values[0] - 1.5625f) < 1e-5f && values[0] == values[1] && values[2] == 0);
    OK(tree_metaballs_gradients(field, points, 3, NULL, gradients, 9));
    CHECK(fabsf(gradients[0] - 1.5f) < 1e-5f && gradients[3] == -gradients[0] && gradients[6] == 0);
    FAILS(TREE_ERROR_BUFFER, "values", tree_metaballs_values(field, points, 3, NULL, values, 2));
    FAILS(TREE_ERROR_BUFFER, "gradients",
          tree_metaballs_gradients(field, points, 3, NULL, gradients, 8));
    OK(tree_metaballs_free(field));
    FAILS(TREE_ERROR_PARAMETER, "centers", tree_metaballs_new(points, 3, 1, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "radius", tree_metaballs_new(points, 2, 0, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "no elements", tree_metaballs_new(NULL, 0, 1, NULL, &none));
    OK(tree_metaballs_of_elements(elements, 0.1f, 0, NULL, &field));
    OK(tree_metaballs_count(field, &n_points));
    OK(tree_metaballs_radius(field, &radius));
    CHECK(n_points == CARDS && fabsf(radius - 0.4f) < 0.01f);
    OK(tree_metaballs_free(field));
}

static tree_hull *hulls(const tree_elements *elements) {
    tree_hull_params fine;
    tree_order_params params;
    tree_hull *hull = NULL, *other = NULL;
    OK(tree_hull_params_init(&fine, sizeof fine));
    CHECK(fine.iso == 0.05f && fine.detail == 3);
    OK(tree_hull_params_check(&fine));
    OK(tree_order_params_init(&params, sizeof params));
    CHECK(params.radius == 0.05f && params.hull == NULL);
    params.radius = 0.15f;
    params.hull = &fine;
    OK(tree_order_params_check(&params));
    OK(tree_hull_of_elements(elements, &params, NULL, &hull));
    tree_hull_columns view = {.struct_size = sizeof view}, again = view;
    OK(tree_hull_view(hull, &view));
    CHECK(view.n_vertices > 100 && view.n_indices % 3 == 0 && view.indices[0] < view.n_vertices);
    CHECK(fabsf(length_of(view.normals) - 1) < 1e-4f && view.positions[1] > 1);

    tree_metaballs *field = NULL;
    OK(tree_metaballs_of_elements(elements, params.radius, 0, NULL, &field));
    OK(tree_hull_of_metaballs(field, &fine, NULL, &other));
    OK(tree_hull_view(other, &again));
    CHECK(again.n_vertices == view.n_vertices);
    CHECK(memcmp(again.positions, view.positions, 3 * sizeof(float) * view.n_vertices) == 0);
    OK(tree_hull_free(other));
    fine.iso = 0;
    FAILS(TREE_ERROR_PARAMETER, "hull.iso", tree_hull_of_metaballs(field, &fine, NULL, &other));
    FAILS(TREE_ERROR_PARAMETER, "hull.iso", tree_hull_params_check(&fine));
    FAILS(TREE_ERROR_PARAMETER, "hull.iso", tree_order_params_check(&params));
    OK(tree_metaballs_free(field));

    tree_mesh *mesh = NULL;
    OK(tree_hull_mesh(hull, &mesh));
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_mesh_measure(mesh, &totals));
    CHECK(totals.n_surfaces == 1 && totals.n_triangles == view.n_indices / 3);
    OK(tree_mesh_free(mesh));
    float places[96], normals[96];
    OK(tree_hull_sample(hull, 32, 1, NULL, places, 96, normals, 96));
    for (int i = 0; i < 32; i++) {
        float from[3] = {places[3 * i], places[3 * i + 1] - 3, places[3 * i + 2]};
        CHECK(length_of(from) > 1 && length_of(from) < 1.8f);
        CHECK(fabsf(length_of(normals + 3 * i) - 1) < 1e-4f);
    }
    FAILS(TREE_ERROR_BUFFER, "normals", tree_hull_sample(hull, 32, 1, NULL, places, 96, normals, 95));
    FAILS(TREE_ERROR_LIMIT, "", tree_hull_sample(hull, SIZE_MAX, 1, NULL, places, 96, normals, 96));
    static const float points[] = {9, 3, 0, NAN, 0, 0};
    OK(tree_hull_nearest(hull, points, 2, NULL, places, 6, normals, 6));
    CHECK(normals[0] > 0.9f && places[0] > 1 && places[0] < 1.8f && normals[3] == 0 && places[3] == 0);
    FAILS(TREE_ERROR_BUFFER, "positions",
          tree_hull_nearest(hull, points, 2, NULL, places, 5, normals, 6));
    return hull;
}

static void orders(const tree_mesh *mesh, const tree_mesh *bare, const tree_elements *elements) {
    uint32_t order[CARDS], other[CARDS];
    float pivots[3 * CARDS];
    tree_order_params params;
    OK(tree_order_params_init(&params, sizeof params));
    params.radius = 0.15f;
    tree_hull *hull = hulls(elements);
    OK(tree_order_stochastic(elements, 1, order, CARDS));
    OK(tree_order_check(order, CARDS, CARDS));
    OK(tree_order_stochastic(elements, 2, other, CARDS));
    CHECK(memcmp(order, other, sizeof order) != 0);
    OK(tree_order_golden(elements, order, CARDS));
    OK(tree_order_check(order, CARDS, CARDS));
    OK(tree_order_density(elements, &params, 1, NULL, order, CARDS));
    OK(tree_order_check(order, CARDS, CARDS));
    OK(tree_order_orientation(elements, hull, NULL, 1, NULL, order, CARDS));
    OK(tree_order_check(order, CARDS, CARDS));
    OK(tree_order_combined(elements, &params, 1, NULL, order, CARDS));
    OK(tree_order_check(order, CARDS, CARDS));
    OK(tree_hull_free(hull));
    FAILS(TREE_ERROR_BUFFER, "order", tree_order_golden(elements, order, CARDS - 1));
    FAILS(TREE_ERROR_NULL, "elements", tree_order_golden(NULL, order, CARDS));
    FAILS(TREE_ERROR_NULL, "order", tree_order_golden(elements, NULL, CARDS));
    params.least = NAN;
    FAILS(TREE_ERROR_PARAMETER, "order.least",
          tree_order_combined(elements, &params, 1, NULL, order, CARDS));
    FAILS(TREE_ERROR_INVALID, "order, row", tree_order_check(order, CARDS - 1, CARDS));
    FAILS(TREE_ERROR_INVALID, "no such element", tree_order_check(order, CARDS, CARDS - 1));

    static const float stages[] = {0.5f, 0.2f};
    tree_around around = few_views();
    tree_coverage_params coverage;
    OK(tree_coverage_params_init(&coverage, sizeof coverage));
    CHECK(coverage.pivots == 1 && coverage.around == NULL);
    OK(tree_coverage_params_check(&coverage));
    coverage.around = &around;
    coverage.stages = stages;
    coverage.n_stages = 2;
    OK(tree_order_coverage(mesh, elements, NULL, 0, &coverage, NULL, order, CARDS, pivots, 3 * CARDS));
    OK(tree_order_check(order, CARDS, CARDS));
    CHECK(isfinite(pivots[0]) && isfinite(pivots[3 * CARDS - 1]));
    FAILS(TREE_ERROR_BUFFER, "pivots",
          tree_order_coverage(mesh, elements, NULL, 0, &coverage, NULL, order, CARDS, pivots, CARDS));
    FAILS(TREE_ERROR_INVALID, "mesh lacks",
          tree_order_coverage(bare, elements, NULL, 0, &coverage, NULL, order, CARDS, pivots, 3 * CARDS));
    tree_cancel *cancel = NULL;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "",
          tree_order_coverage(mesh, elements, NULL, 0, &coverage, &control, order, CARDS, pivots, 3 * CARDS));
    OK(tree_cancel_free(cancel));
    coverage.n_stages = 1;
    coverage.stages = &around.turn;
    FAILS(TREE_ERROR_PARAMETER, "stages", tree_coverage_params_check(&coverage));
}

void test_lod(void) {
    tree_mesh *mesh = a_ball_of_cards(1), *bare = a_ball_of_cards(0);
    tree_elements *elements = elements_of(mesh);
    elements_and_grains(mesh);
    views();
    masks(mesh, bare);
    tables(mesh, bare, elements);
    rows_and_distances();
    rules();
    fields(elements);
    orders(mesh, bare, elements);
    OK(tree_elements_free(elements));
    OK(tree_mesh_free(bare));
    OK(tree_mesh_free(mesh));
}
