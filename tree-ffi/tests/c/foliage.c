#include "check.h"
#include <math.h>

/* 0 below the height that `user` points at, and twice as many above. */
static float above(void *user, const float *position) {
    return position[1] < *(const float *)user ? 0.0f : (float)TREE_DENSITY_CAP / 2;
}

static float not_a_number(void *user, const float *position) {
    (void)user;
    (void)position;
    return NAN;
}

static tree_foliage leaves_of(const tree_tree *tree) {
    tree_foliage foliage = {.struct_size = sizeof foliage};
    OK(tree_tree_foliage(tree, &foliage));
    return foliage;
}

/* Its skeleton's columns, which live as long as the tree. */
static tree_skeleton_columns nodes_of(const tree_tree *tree) {
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    tree_skeleton *skeleton = NULL;
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_view(skeleton, &columns));
    OK(tree_skeleton_free(skeleton));
    return columns;
}

static void test_presets(void) {
    size_t n = tree_foliage_preset_count();
    CHECK(n >= 10);
    int has_ash = 0;
    tree_leaf_params leaves = {.struct_size = sizeof leaves};
    tree_twig_params twigs = {.struct_size = sizeof twigs};
    for (size_t i = 0; i < n; i++) {
        tree_str name, kind;
        OK(tree_foliage_preset_name(i, &name));
        OK(tree_foliage_preset(name.data, name.len, &leaves, &twigs, &kind));
        CHECK(kind.len > 0);
        OK(tree_leaf_params_check(&leaves, 1));
        OK(tree_twig_params_check(&twigs));
        has_ash += name.len == 3 && !memcmp(name.data, "ash", 3);
    }
    CHECK(has_ash == 1);
    tree_str name;
    FAILS(TREE_ERROR_PARAMETER, "species", tree_foliage_preset_name(n, &name));

    OK(tree_foliage_preset("ash", TREE_NUL_TERMINATED, &leaves, NULL, NULL));
    CHECK(leaves.form == TREE_LEAVES_PINNATE && leaves.pinnate_pairs == 5);
    CHECK(leaves.arrangement == TREE_PHYLLOTAXIS_DECUSSATE && leaves.pinnate_profile[2] == 0.85f);
    OK(tree_foliage_preset("larch", 5, &leaves, NULL, NULL));
    CHECK(leaves.form == TREE_LEAVES_ROSETTE && leaves.needles == 30);
    OK(tree_foliage_preset("horse-chestnut", TREE_NUL_TERMINATED, &leaves, NULL, NULL));
    CHECK(leaves.form == TREE_LEAVES_PALMATE && leaves.palmate_leaflets == 7);
    OK(tree_foliage_preset("pine", TREE_NUL_TERMINATED, &leaves, &twigs, NULL));
    CHECK(leaves.form == TREE_LEAVES_FASCICLE && leaves.needle_spread == 0.14f);
    CHECK(twigs.arrangement == TREE_PHYLLOTAXIS_WHORLED && twigs.whorl == 4);
    OK(tree_foliage_preset("beech", TREE_NUL_TERMINATED, NULL, &twigs, NULL));
    CHECK(twigs.branching == TREE_BRANCHING_SYMPODIAL && twigs.module_turn == 0.35f);
    FAILS(TREE_ERROR_UNKNOWN_NAME, "maple", tree_foliage_preset("mapel", 5, NULL, NULL, NULL));
    leaves.struct_size = 1;
    FAILS(TREE_ERROR_STRUCT_SIZE, "leaves", tree_foliage_preset("ash", 3, &leaves, NULL, NULL));
}

static void test_parameters(void) {
    tree_leaf_params leaves;
    OK(tree_leaf_params_init(&leaves, sizeof leaves));
    CHECK(leaves.spacing == 0.07f && leaves.light[1] == 1 && leaves.terminal == 1);
    CHECK(leaves.form == TREE_LEAVES_SIMPLE && leaves.pinnate_pairs == 4);
    OK(tree_leaf_params_check(&leaves, 1));
    leaves.kind = 1;
    FAILS(TREE_ERROR_PARAMETER, "leaves.kind", tree_leaf_params_check(&leaves, 1));
    leaves.kind = 65536;
    FAILS(TREE_ERROR_PARAMETER, "leaves.kind", tree_leaf_params_check(&leaves, 70000));
    leaves.kind = 0;
    leaves.form = TREE_LEAVES_FASCICLE;
    FAILS(TREE_ERROR_PARAMETER, "needles", tree_leaf_params_check(&leaves, 1));
    leaves.form = 5;
    FAILS(TREE_ERROR_ENUM, "TREE_LEAVES_", tree_leaf_params_check(&leaves, 1));
    leaves.form = TREE_LEAVES_SIMPLE;
    leaves.arrangement = 5;
    FAILS(TREE_ERROR_ENUM, "TREE_PHYLLOTAXIS_", tree_leaf_params_check(&leaves, 1));
    leaves.arrangement = TREE_PHYLLOTAXIS_WHORLED;
    FAILS(TREE_ERROR_PARAMETER, "count", tree_leaf_params_check(&leaves, 1));
    leaves.arrangement = TREE_PHYLLOTAXIS_OPPOSITE;
    leaves.size = NAN;
    FAILS(TREE_ERROR_PARAMETER, "size", tree_leaf_params_check(&leaves, 1));

    tree_twig_params twigs;
    OK(tree_twig_params_init(&twigs, sizeof twigs));
    CHECK(twigs.levels == 2 && twigs.length == 0.25f && twigs.module_internodes == 1);
    OK(tree_twig_params_check(&twigs));
    twigs.branching = TREE_BRANCHING_SYMPODIAL;
    twigs.module_stub = 11;
    FAILS(TREE_ERROR_PARAMETER, "stub", tree_twig_params_check(&twigs));
    twigs.branching = 2;
    FAILS(TREE_ERROR_ENUM, "TREE_BRANCHING_", tree_twig_params_check(&twigs));
    twigs.branching = TREE_BRANCHING_MONOPODIAL;
    twigs.reserved = 1;
    FAILS(TREE_ERROR_PARAMETER, "reserved", tree_twig_params_check(&twigs));
}

static void test_leaves(void) {
    tree_tree *bare = an_oak_twig(), *leafy = NULL, *again = NULL;
    tree_leaf_params params;
    OK(tree_leaf_params_init(&params, sizeof params));
    tree_leaf_report report = {.struct_size = sizeof report};
    OK(tree_tree_grow_leaves(bare, &params, NULL, NULL, 0, 7, NULL, &report, &leafy));
    tree_foliage foliage = leaves_of(leafy);
    CHECK(foliage.n_leaves > 5 && foliage.n_leaves == report.n_blades);
    CHECK(report.n_leaves == report.n_blades && report.n_stalk_nodes == 0);
    CHECK(nodes_of(leafy).n_nodes == 4);

    /* The same seed, the same leaves; the defaults are the defaults. */
    OK(tree_tree_grow_leaves(bare, NULL, NULL, NULL, 0, 7, NULL, NULL, &again));
    tree_foliage same = leaves_of(again);
    CHECK(same.n_leaves == foliage.n_leaves);
    CHECK(!memcmp(same.positions, foliage.positions, 3 * sizeof(float) * same.n_leaves));
    OK(tree_tree_free(again));
    OK(tree_tree_free(leafy));

    float height = 2.3f;
    OK(tree_tree_grow_leaves(bare, &params, above, &height, 0, 7, NULL, &report, &leafy));
    foliage = leaves_of(leafy);
    CHECK(foliage.n_leaves > 0 && report.n_thinned > 0);
    for (size_t i = 0; i < foliage.n_leaves; i++) {
        CHECK(foliage.positions[3 * i + 1] > 2.25f);
    }
    OK(tree_tree_free(leafy));
    OK(tree_tree_grow_leaves(bare, &params, not_a_number, NULL, 0, 7, NULL, &report, &leafy));
    CHECK(leaves_of(leafy).n_leaves == 0 && report.n_bad_density > 0);
    OK(tree_tree_free(leafy));

    OK(tree_foliage_preset("ash", TREE_NUL_TERMINATED, &params, NULL, NULL));
    OK(tree_tree_grow_leaves(bare, &params, NULL, NULL, 1, 7, NULL, &report, &leafy));
    CHECK(report.n_stalk_nodes > 0 && report.n_blades == 11 * report.n_leaves);
    CHECK(nodes_of(leafy).n_nodes == 4 + report.n_stalk_nodes);
    CHECK(leaves_of(leafy).nodes[0] >= 4);
    OK(tree_tree_free(leafy));
    OK(tree_tree_free(bare));
}

static void test_leaf_errors(void) {
    tree_tree *bare = an_oak_twig(), *leafy = bare;
    tree_leaf_params params;
    OK(tree_leaf_params_init(&params, sizeof params));
    params.kind = 1;
    FAILS(TREE_ERROR_PARAMETER, "leaves.kind",
          tree_tree_grow_leaves(bare, &params, NULL, NULL, 0, 7, NULL, NULL, &leafy));
    CHECK(leafy == NULL);
    params.kind = 0;
    params.spacing = 0;
    FAILS(TREE_ERROR_PARAMETER, "leaves.spacing",
          tree_tree_grow_leaves(bare, &params, NULL, NULL, 0, 7, NULL, NULL, &leafy));
    params.spacing = 1e-4f;
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.leaves = 100;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "leaves",
          tree_tree_grow_leaves(bare, &params, NULL, NULL, 0, 7, &control, NULL, &leafy));
    tree_cancel *cancel = NULL;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel",
          tree_tree_grow_leaves(bare, NULL, NULL, NULL, 0, 7, &control, NULL, &leafy));
    tree_tree *twiggy = bare;
    FAILS(TREE_ERROR_CANCELLED, "cancel",
          tree_tree_grow_twigs(bare, NULL, NULL, NULL, 7, &control, NULL, &twiggy));
    CHECK(leafy == NULL && twiggy == NULL);
    OK(tree_cancel_free(cancel));
    tree_leaf_report report = {.struct_size = 1};
    FAILS(TREE_ERROR_STRUCT_SIZE, "report",
          tree_tree_grow_leaves(bare, NULL, NULL, NULL, 0, 7, NULL, &report, &leafy));
    OK(tree_tree_free(bare));
}

static void test_twigs(void) {
    tree_tree *bare = an_oak_twig(), *twiggy = NULL;
    tree_twig_params params;
    OK(tree_twig_params_init(&params, sizeof params));
    tree_twig_report report = {.struct_size = sizeof report};
    OK(tree_tree_grow_twigs(bare, &params, NULL, NULL, 7, NULL, &report, &twiggy));
    tree_skeleton_columns old = nodes_of(bare), grown = nodes_of(twiggy);
    CHECK(report.n_twigs > 0 && report.n_nodes > 0 && report.moved > 0);
    CHECK(grown.n_nodes == 4 + report.n_nodes);
    CHECK(!memcmp(old.positions, grown.positions, 12 * sizeof(float)));
    CHECK(!memcmp(old.parents, grown.parents, 4 * sizeof(uint32_t)));
    CHECK(leaves_of(twiggy).n_leaves == 3 && leaves_of(twiggy).nodes[1] == 3);
    OK(tree_tree_free(twiggy));

    float height = 100;
    OK(tree_tree_grow_twigs(bare, NULL, above, &height, 7, NULL, &report, &twiggy));
    CHECK(report.n_twigs == 0 && report.n_thinned > 0 && nodes_of(twiggy).n_nodes == 4);
    OK(tree_tree_free(twiggy));
    params.levels = 4;
    FAILS(TREE_ERROR_PARAMETER, "twigs.levels",
          tree_tree_grow_twigs(bare, &params, NULL, NULL, 7, NULL, NULL, &twiggy));
    CHECK(twiggy == NULL);
    OK(tree_tree_free(bare));
}

static void test_refine(void) {
    tree_skeleton *fork = a_fork(), *refined = NULL;
    tree_rows *rows = NULL;
    OK(tree_skeleton_refine(fork, 0.1f, 0.25f, NULL, &rows, &refined));
    const uint32_t *row = NULL;
    size_t n = 0;
    OK(tree_rows_view(rows, &row, &n));
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_skeleton_view(refined, &columns));
    /* Segments of 1.58 m and 1.12 m in pieces of 25 cm at most; the trunk stays. */
    CHECK(n == columns.n_nodes && n == 2 + 7 + 5);
    CHECK(row[0] == 0 && row[1] == 1 && row[2] == 2 && row[n - 1] == 3);
    OK(tree_skeleton_free(refined));
    OK(tree_rows_free(rows));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_rows_view(rows, &row, &n));

    OK(tree_skeleton_refine(fork, 0.1f, 10, NULL, NULL, &refined));
    OK(tree_skeleton_view(refined, &columns));
    CHECK(columns.n_nodes == 4);
    OK(tree_skeleton_free(refined));
    OK(tree_skeleton_refine(fork, 0.1f, 10, NULL, &rows, &refined));
    OK(tree_skeleton_free(refined));
    OK(tree_rows_free(rows));
    FAILS(TREE_ERROR_NULL, "refined", tree_skeleton_refine(fork, 0.1f, 10, NULL, &rows, NULL));
    CHECK(rows == NULL);
    /* Columns without rows are NULL. */
    tree_tree *bare = NULL;
    OK(tree_tree_new(fork, NULL, NULL, NULL, &bare));
    tree_foliage none = leaves_of(bare);
    CHECK(none.n_leaves == 0 && !none.nodes && !none.positions && !none.sizes && !none.kinds);
    OK(tree_tree_free(bare));
    FAILS(TREE_ERROR_PARAMETER, "spacing", tree_skeleton_refine(fork, 1, 0, NULL, &rows, &refined));
    CHECK(rows == NULL && refined == NULL);
    OK(tree_skeleton_free(fork));
}

void test_foliage(void) {
    test_presets();
    test_parameters();
    test_leaves();
    test_leaf_errors();
    test_twigs();
    test_refine();
}
