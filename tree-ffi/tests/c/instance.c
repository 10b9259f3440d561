#include "check.h"

/* A trunk with many forked twigs of few shapes, a leaf at every tip. */
static tree_tree *a_bush(void) {
    enum { TWIGS = 16, NODES = 2 + 4 * TWIGS, LEAVES = 2 * TWIGS };
    static float positions[3 * NODES], radii[NODES], leaf_positions[3 * LEAVES];
    static float rotations[4 * LEAVES], sizes[LEAVES];
    static uint32_t parents[NODES], leaf_nodes[LEAVES];
    static uint16_t kinds[LEAVES];
    memset(positions, 0, sizeof positions);
    positions[4] = 2;
    radii[0] = radii[1] = 0.1f;
    parents[0] = TREE_NO_PARENT;
    parents[1] = 0;
    for (int i = 0; i < TWIGS; i++) {
        int at = 2 + 4 * i;
        float x = i % 4 < 2 ? 1.0f : -1.0f, z = i % 2 ? 1.0f : -1.0f, y = 1 + 0.06f * (float)i;
        float places[4][3] = {{0, y, 0}, {x, y, z}, {x * 1.3f, y + 0.2f, z}, {x, y + 0.2f, z * 1.3f}};
        for (int k = 0; k < 4; k++) {
            memcpy(positions + 3 * (at + k), places[k], sizeof places[k]);
            radii[at + k] = k == 0 ? 0.08f : 0.01f;
        }
        parents[at] = i == 0 ? 0 : (uint32_t)(at - 4);
        parents[at + 1] = (uint32_t)at;
        parents[at + 2] = parents[at + 3] = (uint32_t)at + 1;
        for (int k = 0; k < 2; k++) {
            int leaf = 2 * i + k;
            leaf_nodes[leaf] = (uint32_t)(at + 2 + k);
            memcpy(leaf_positions + 3 * leaf, places[2 + k], sizeof places[0]);
            rotations[4 * leaf + 3] = 1;
            sizes[leaf] = 0.1f;
        }
    }
    tree_skeleton_columns columns = {sizeof columns, NODES, positions, radii, parents};
    tree_foliage foliage = {sizeof foliage, LEAVES,    leaf_nodes, leaf_positions,
                            rotations,      sizes,     kinds};
    tree_skeleton *skeleton = NULL;
    tree_tree *tree = NULL;
    OK(tree_skeleton_from_columns(&columns, NULL, &skeleton));
    OK(tree_tree_new(skeleton, &foliage, NULL, NULL, &tree));
    OK(tree_skeleton_free(skeleton));
    return tree;
}

void test_instance(void) {
    tree_tree *bush = a_bush();
    tree_look *look = NULL;
    OK(tree_look_of_tree(bush, 1, &look));
    tree_mesh_params mesh_params;
    OK(tree_mesh_params_init(&mesh_params, sizeof mesh_params));
    mesh_params.max_sides = 4;
    mesh_params.error = 0.05f;
    tree_instancing_params params;
    OK(tree_instancing_params_init(&params, sizeof params));
    CHECK(params.max_twigs == 30 && params.ratio == 11.0f && params.reach == 0.0f);
    params.max_twigs = 4;
    params.ratio = 2;
    params.reach = 1.9f;
    tree_instancing_report report = {.struct_size = sizeof report}, again = report;
    tree_twigs *twigs = NULL;
    OK(tree_twigs_build(bush, look, &mesh_params, &params, 7, NULL, &report, &twigs));
    CHECK(report.n_twigs >= 1 && report.n_twigs <= 4 && report.n_instances >= 8);
    CHECK(report.n_leaves == 32 && report.ratio > 1 && report.bytes < report.bytes_flat);
    CHECK(report.reach == 1.9f);
    OK(tree_twigs_measure(twigs, &again));
    CHECK(again.bytes == report.bytes && again.deviation == report.deviation);
    size_t n_twigs = 0;
    OK(tree_twigs_count(twigs, &n_twigs));
    CHECK(n_twigs == report.n_twigs);

    tree_mesh *base = NULL, *twig = NULL, *flat = NULL;
    OK(tree_twigs_base(twigs, &base));
    tree_mesh_totals base_totals = {.struct_size = sizeof base_totals}, twig_totals = base_totals,
                     flat_totals = base_totals;
    OK(tree_mesh_measure(base, &base_totals));
    uint64_t expected = base_totals.n_triangles;
    size_t n_instances = 0;
    for (size_t i = 0; i < n_twigs; i++) {
        tree_twig_instances instances = {.struct_size = sizeof instances};
        OK(tree_twigs_instances(twigs, i, &instances));
        n_instances += instances.n_instances;
        for (size_t k = 0; k < instances.n_instances; k++) {
            const float *q = instances.rotations + 4 * k;
            float unit = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
            CHECK(unit > 0.99f && unit < 1.01f && instances.scales[3 * k] > 0);
            CHECK(instances.branches[k] < base_totals.n_branches);
            CHECK(instances.translations[3 * k + 1] > 0);
        }
        OK(tree_twigs_mesh(twigs, i, &twig));
        OK(tree_mesh_measure(twig, &twig_totals));
        CHECK(twig_totals.n_triangles > 0 && twig_totals.n_surfaces == base_totals.n_surfaces);
        expected += twig_totals.n_triangles * instances.n_instances;
        OK(tree_mesh_free(twig));
    }
    CHECK(n_instances == report.n_instances);
    OK(tree_twigs_flatten(twigs, NULL, &flat));
    OK(tree_mesh_measure(flat, &flat_totals));
    CHECK(flat_totals.n_triangles == expected);
    OK(tree_mesh_check(flat));
    OK(tree_mesh_free(flat));

    FAILS(TREE_ERROR_INVALID, "twigs", tree_twigs_mesh(twigs, n_twigs, &twig));
    OK(tree_twigs_mesh(twigs, 0, &twig));

    /* The base with three more copies of a twig. */
    float at[] = {0, 1, 0, 0, 2, 0, 0, 3, 0}, turns[] = {0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1};
    float scales[] = {1, 1, 1, 2, 2, 2, 0.5f, 0.5f, 0.5f};
    uint32_t bearers[] = {0, 0, 0};
    tree_twig_instances own = {sizeof own, 3, at, turns, scales, bearers};
    const tree_mesh *meshes[] = {twig};
    tree_twigs *made = NULL;
    OK(tree_twigs_from_parts(base, meshes, &own, 1, NULL, &made));
    OK(tree_twigs_measure(made, &again));
    CHECK(again.n_twigs == 1 && again.n_instances == 3 && again.reach == 0);
    OK(tree_twigs_flatten(made, NULL, &flat));
    OK(tree_mesh_measure(flat, &flat_totals));
    OK(tree_mesh_measure(twig, &twig_totals));
    CHECK(flat_totals.n_triangles == base_totals.n_triangles + 3 * twig_totals.n_triangles);
    OK(tree_mesh_free(flat));
    OK(tree_twigs_free(made));
    scales[4] = 1;
    FAILS(TREE_ERROR_INVALID, "scale 1", tree_twigs_from_parts(base, meshes, &own, 1, NULL, &made));
    scales[4] = 2;
    bearers[2] = 1000;
    FAILS(TREE_ERROR_INVALID, "branch 1000",
          tree_twigs_from_parts(base, meshes, &own, 1, NULL, &made));
    /* What one twig may be, many may not: the sum is what is copied. */
    bearers[2] = 0;
    tree_limits limits;
    tree_control few;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&few, sizeof few));
    few.limits = &limits;
    const tree_mesh *same[] = {twig, twig, twig};
    tree_twig_instances rows[] = {own, own, own};
    limits.leaves = 9;
    OK(tree_twigs_from_parts(base, same, rows, 3, &few, &made));
    OK(tree_twigs_free(made));
    limits.leaves = 8;
    FAILS(TREE_ERROR_LIMIT, "leaves", tree_twigs_from_parts(base, same, rows, 3, &few, &made));
    limits.leaves = 9;
    limits.triangles = base_totals.n_triangles + 2 * twig_totals.n_triangles;
    FAILS(TREE_ERROR_LIMIT, "triangles", tree_twigs_from_parts(base, same, rows, 3, &few, &made));
    CHECK(made == NULL);
    own.n_instances = (size_t)1 << 60;
    FAILS(TREE_ERROR_LIMIT, "leaves", tree_twigs_from_parts(base, meshes, &own, 1, NULL, &made));
    meshes[0] = NULL;
    FAILS(TREE_ERROR_NULL, "meshes[0]", tree_twigs_from_parts(base, meshes, &own, 1, NULL, &made));
    FAILS(TREE_ERROR_NULL, "meshes", tree_twigs_from_parts(base, NULL, &own, 1, NULL, &made));
    OK(tree_twigs_free(twigs));
    /* Both outlive the twigs. */
    OK(tree_mesh_check(base));
    OK(tree_mesh_check(twig));
    OK(tree_mesh_free(base));
    OK(tree_mesh_free(twig));

    params.ratio = 0.5f;
    FAILS(TREE_ERROR_PARAMETER, "ratio",
          tree_twigs_build(bush, look, &mesh_params, &params, 7, NULL, NULL, &twigs));
    params.ratio = 2;
    params.reach = -1;
    FAILS(TREE_ERROR_PARAMETER, "reach",
          tree_twigs_build(bush, look, &mesh_params, &params, 7, NULL, NULL, &twigs));
    CHECK(twigs == NULL);
    OK(tree_look_free(look));
    OK(tree_tree_free(bush));
}
