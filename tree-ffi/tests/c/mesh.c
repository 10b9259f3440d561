#include "check.h"

/* A mesh of the oak twig, coarse, in plain colours. Free it with tree_mesh_free. */
static tree_mesh *a_mesh(const tree_mesh_params *params) {
    tree_tree *tree = an_oak_twig();
    tree_look *look = NULL;
    OK(tree_look_of_tree(tree, 1, &look));
    tree_mesh *mesh = NULL;
    OK(tree_mesh_build(tree, look, params, NULL, NULL, &mesh));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
    return mesh;
}

static tree_mesh_params coarse(void) {
    tree_mesh_params params;
    OK(tree_mesh_params_init(&params, sizeof params));
    params.sides_max = 6;
    params.error = 0.02f;
    return params;
}

static void parameters(void) {
    tree_mesh_params params;
    OK(tree_mesh_params_init(&params, sizeof params));
    CHECK(params.sides_max == 20 && params.error == 0.003f && params.fit == TREE_CURVE_THROUGH);
    CHECK(params.continuation == TREE_CONTINUATION_THICKEST && params.leaf_rounding == 0.6f);
    OK(tree_mesh_params_check(&params));
    float metres = 0;
    OK(tree_mesh_params_error(NULL, &metres));
    CHECK(metres == 0.003f);
    params.error_kind = TREE_BOUND_PIXELS;
    OK(tree_mesh_params_error(&params, &metres));
    CHECK(metres > 0.009f && metres < 0.011f);
    params.error_height = 0;
    FAILS(TREE_ERROR_PARAMETER, "error.height", tree_mesh_params_check(&params));
    params.error_kind = 7;
    FAILS(TREE_ERROR_ENUM, "TREE_BOUND_", tree_mesh_params_check(&params));
    OK(tree_mesh_params_init(&params, sizeof params));
    params.fit = 9;
    FAILS(TREE_ERROR_ENUM, "TREE_CURVE_", tree_mesh_params_check(&params));
    params.fit = TREE_CURVE_NEAR;
    params.continuation = 3;
    FAILS(TREE_ERROR_ENUM, "TREE_CONTINUATION_", tree_mesh_params_check(&params));
    params.continuation = TREE_CONTINUATION_STRAIGHTEST;
    params.leaf_scale = 0.0f / 1.0f;
    FAILS(TREE_ERROR_PARAMETER, "leaf_scale", tree_mesh_params_check(&params));
    FAILS(TREE_ERROR_STRUCT_SIZE, "sizeof", tree_mesh_params_init(&params, 4));
}

static void building(void) {
    tree_tree *tree = an_oak_twig();
    tree_mesh_params params = coarse();
    params.tangents = params.lightmap = 1;
    tree_mesh_report report = {.struct_size = sizeof report};
    tree_mesh *mesh = NULL;
    OK(tree_mesh_build(tree, NULL, &params, NULL, &report, &mesh));
    CHECK(report.n_tubes == 2 && report.n_leaf_fallbacks == 0 && report.leaf_fallbacks == NULL);

    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_mesh_count(mesh, &totals));
    CHECK(totals.n_surfaces == 2 && totals.n_materials == 2 && totals.n_branches == 2);
    CHECK(totals.n_vertices == report.n_vertices && totals.n_triangles == report.n_triangles);
    size_t n_surfaces = 0;
    OK(tree_mesh_surface_count(mesh, &n_surfaces));
    CHECK(n_surfaces == 2);
    OK(tree_mesh_check(mesh));
    OK(tree_mesh_check_colors(mesh));
    OK(tree_mesh_check_normals(mesh));
    OK(tree_mesh_free(mesh));

    /* A plain material has no mask to outline. */
    tree_look *look = NULL;
    OK(tree_look_plain(NULL, &look));
    params.sides_min = 50;
    FAILS(TREE_ERROR_PARAMETER, "sides_min", tree_mesh_build(tree, look, &params, NULL, NULL, &mesh));
    CHECK(mesh == NULL);
    FAILS(TREE_ERROR_HANDLE, "tree_look",
          tree_mesh_build(tree, (const tree_look *)tree, NULL, NULL, NULL, &mesh));

    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.triangles = 3;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "triangles", tree_mesh_build(tree, look, NULL, &control, NULL, &mesh));
    control.limits = NULL;
    tree_cancel *cancel = NULL;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "", tree_mesh_build(tree, look, NULL, &control, NULL, &mesh));
    OK(tree_cancel_free(cancel));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
}

static void surfaces(void) {
    tree_mesh_params params = coarse();
    params.tangents = params.lightmap = 1;
    tree_mesh *mesh = a_mesh(&params);
    tree_surface bark = {.struct_size = sizeof bark}, leaves = bark;
    OK(tree_mesh_surface(mesh, 0, &bark));
    CHECK(bark.n_vertices > 12 && bark.n_indices % 3 == 0 && bark.n_anchors == 0);
    CHECK(bark.tangents && bark.uvs2 && bark.branches && bark.welds && bark.vertices_per_leaf == 0);
    CHECK(!bark.occlusion && !bark.anchors && bark.material == 0);
    for (size_t i = 0; i < bark.n_indices; i++) {
        CHECK(bark.indices[i] < bark.n_vertices);
    }
    for (size_t v = 0; v < bark.n_vertices; v++) {
        const float *n = bark.normals + 3 * v;
        float length = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        CHECK(length > 0.99f && length < 1.01f && bark.welds[v] <= v);
        CHECK(bark.tangents[4 * v + 3] == 1.0f || bark.tangents[4 * v + 3] == -1.0f);
    }
    OK(tree_mesh_surface(mesh, 1, &leaves));
    CHECK(leaves.n_anchors == 3 && leaves.vertices_per_leaf == 4 && leaves.material == 1);
    CHECK(leaves.anchors[1] == 2.5f && leaves.welds == NULL);
    FAILS(TREE_ERROR_INVALID, "surface 2", tree_mesh_surface(mesh, 2, &leaves));

    tree_bounds bounds = {.struct_size = sizeof bounds}, whole = bounds;
    OK(tree_mesh_surface_bounds(mesh, 0, &bounds));
    OK(tree_mesh_bounds(mesh, &whole));
    CHECK(bounds.min[1] == 0.0f && bounds.max[1] > 2.4f && bounds.max[1] <= whole.max[1]);
    CHECK(whole.radius > 1.2f && whole.radius < 2.5f && whole.center[1] > 1.0f);

    const tree_wind_branch *branches = NULL;
    size_t n_branches = 0;
    OK(tree_mesh_branches(mesh, &branches, &n_branches));
    CHECK(n_branches == 2 && branches[0].parent == 0 && branches[1].level == 1);
    CHECK(branches[1].length > 0.5f && branches[1].stiffness > 0.0f && branches[1].pivot[1] > 0.5f);
    OK(tree_mesh_free(mesh));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_mesh_surface(mesh, 0, &bark));
}

void test_mesh(void) {
    parameters();
    building();
    surfaces();
}
