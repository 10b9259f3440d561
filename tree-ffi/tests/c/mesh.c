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
    params.max_sides = 6;
    params.error = 0.02f;
    return params;
}

static void parameters(void) {
    tree_mesh_params params;
    OK(tree_mesh_params_init(&params, sizeof params));
    CHECK(params.max_sides == 20 && params.error == 0.003f && params.fit == TREE_CURVE_THROUGH);
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
    tree_look *look = NULL;
    OK(tree_look_plain(NULL, &look));
    OK(tree_mesh_build(tree, look, &params, NULL, &report, &mesh));
    CHECK(report.n_tubes == 2 && report.n_leaf_fallbacks == 0 && report.leaf_fallbacks == NULL);

    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_mesh_measure(mesh, &totals));
    CHECK(totals.n_surfaces == 2 && totals.n_materials == 2 && totals.n_branches == 2);
    CHECK(totals.n_vertices == report.n_vertices && totals.n_triangles == report.n_triangles);
    size_t n_surfaces = 0;
    OK(tree_mesh_surface_count(mesh, &n_surfaces));
    CHECK(n_surfaces == 2);
    OK(tree_mesh_check(mesh));
    OK(tree_mesh_check_surface(mesh, 1));
    FAILS(TREE_ERROR_INVALID, "surface 2", tree_mesh_check_surface(mesh, 2));
    OK(tree_mesh_check_colors(mesh));
    OK(tree_mesh_check_normals(mesh));
    OK(tree_mesh_free(mesh));

    OK(tree_mesh_build_leaves(tree, look, &params, NULL, &mesh));
    tree_mesh_totals leaves = {.struct_size = sizeof leaves};
    OK(tree_mesh_measure(mesh, &leaves));
    CHECK(leaves.n_surfaces == 2 && leaves.n_branches == 0 && leaves.n_triangles > 0);
    CHECK(leaves.n_triangles < totals.n_triangles);
    OK(tree_mesh_free(mesh));

    params.min_sides = 50;
    FAILS(TREE_ERROR_PARAMETER, "min_sides", tree_mesh_build(tree, look, &params, NULL, NULL, &mesh));
    FAILS(TREE_ERROR_PARAMETER, "min_sides", tree_mesh_build_leaves(tree, look, &params, NULL, &mesh));
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

static void materials(void) {
    tree_tree *tree = an_oak_twig();
    tree_look *look = NULL;
    OK(tree_look_of_tree(tree, 0, &look));
    tree_mesh *mesh = NULL;
    tree_mesh_params params = coarse();
    OK(tree_mesh_build(tree, look, &params, NULL, NULL, &mesh));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
    tree_material material = {.struct_size = sizeof material};
    OK(tree_mesh_material(mesh, 1, &material));
    CHECK(material.has_texture && material.alpha == TREE_ALPHA_MASK && material.translucency > 0.3f);
    CHECK(material.name.len == 8 && memcmp(material.name.data, "oak leaf", 8) == 0);
    FAILS(TREE_ERROR_INVALID, "2 materials", tree_mesh_material(mesh, 2, &material));
    tree_texture *texture = NULL;
    OK(tree_mesh_texture(mesh, 0, &texture));
    OK(tree_mesh_free(mesh));
    /* It outlives the mesh. */
    tree_texture_pixels pixels = {.struct_size = sizeof pixels};
    OK(tree_texture_view(texture, &pixels));
    CHECK(pixels.width == 512 && pixels.pixels[3] == 255);
    OK(tree_texture_free(texture));
}

/* The same mesh again, out of its own views. */
static void own_triangles(void) {
    tree_mesh_params params = coarse();
    params.tangents = params.lightmap = 1;
    tree_mesh *mesh = a_mesh(&params), *copy = NULL;
    tree_surface rows[2] = {{.struct_size = sizeof rows[0]}, {.struct_size = sizeof rows[0]}}, view;
    tree_material materials[2] = {{.struct_size = sizeof materials[0]},
                                  {.struct_size = sizeof materials[0]}};
    for (size_t i = 0; i < 2; i++) {
        OK(tree_mesh_surface(mesh, i, &rows[i]));
        OK(tree_mesh_material(mesh, i, &materials[i]));
    }
    const tree_wind_branch *branches = NULL, *copied = NULL;
    size_t n_branches = 0, n_copied = 0;
    OK(tree_mesh_branches(mesh, &branches, &n_branches));
    OK(tree_mesh_from_surfaces(rows, 2, materials, 2, branches, n_branches, NULL, &copy));
    view.struct_size = sizeof view;
    for (size_t i = 0; i < 2; i++) {
        size_t floats = rows[i].n_vertices * sizeof(float);
        OK(tree_mesh_surface(copy, i, &view));
        CHECK(view.n_vertices == rows[i].n_vertices && view.positions != rows[i].positions);
        CHECK(memcmp(view.positions, rows[i].positions, 3 * floats) == 0);
        CHECK(memcmp(view.normals, rows[i].normals, 3 * floats) == 0);
        CHECK(memcmp(view.uvs, rows[i].uvs, 2 * floats) == 0);
        CHECK(memcmp(view.tangents, rows[i].tangents, 4 * floats) == 0);
        CHECK(memcmp(view.uvs2, rows[i].uvs2, 2 * floats) == 0);
        CHECK(memcmp(view.branches, rows[i].branches, floats) == 0);
        CHECK(memcmp(view.indices, rows[i].indices, rows[i].n_indices * sizeof(uint32_t)) == 0);
    }
    OK(tree_mesh_branches(copy, &copied, &n_copied));
    CHECK(n_copied == n_branches && memcmp(copied, branches, n_copied * sizeof *copied) == 0);
    OK(tree_mesh_free(copy));

    FAILS(TREE_ERROR_INVALID, "branch",
          tree_mesh_from_surfaces(rows, 2, materials, 2, NULL, 0, NULL, &copy));
    FAILS(TREE_ERROR_INVALID, "material",
          tree_mesh_from_surfaces(rows, 2, materials, 1, branches, n_branches, NULL, &copy));
    rows[1].indices = NULL;
    FAILS(TREE_ERROR_NULL, "surfaces[1].indices",
          tree_mesh_from_surfaces(rows, 2, materials, 2, branches, n_branches, NULL, &copy));
    OK(tree_mesh_free(mesh));

    static const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, ups[] = {0, 0, 1, 0, 0, 1, 0, 0, 2};
    static const uint32_t order[] = {0, 1, 2};
    tree_surface one = {.struct_size = sizeof one, .n_vertices = 3, .n_indices = 3,
                        .positions = corners, .normals = ups, .uvs = corners, .indices = order};
    tree_material glowing;
    OK(tree_material_init(&glowing, sizeof glowing));
    glowing.base_color[1] = 3;
    OK(tree_mesh_from_surfaces(&one, 1, &glowing, 1, NULL, 0, NULL, &copy));
    FAILS(TREE_ERROR_PARAMETER, "base_color", tree_mesh_check_colors(copy));
    FAILS(TREE_ERROR_PARAMETER, "normals", tree_mesh_check_normals(copy));
    OK(tree_mesh_free(copy));
    one.n_indices = (size_t)1 << 62;
    FAILS(TREE_ERROR_LIMIT, "triangles",
          tree_mesh_from_surfaces(&one, 1, &glowing, 1, NULL, 0, NULL, &copy));
    one.n_indices = 2;
    FAILS(TREE_ERROR_INVALID, "whole triangles",
          tree_mesh_from_surfaces(&one, 1, &glowing, 1, NULL, 0, NULL, &copy));
    CHECK(copy == NULL);
    OK(tree_mesh_from_surfaces(NULL, 0, NULL, 0, NULL, 0, NULL, &copy));
    tree_bounds bounds = {.struct_size = sizeof bounds};
    OK(tree_mesh_bounds(copy, &bounds));
    CHECK(bounds.radius == 0.0f && bounds.max[0] == 0.0f);
    OK(tree_mesh_free(copy));
}

static void finishing(void) {
    tree_mesh_params params = coarse();
    tree_mesh *mesh = a_mesh(&params), *finer = NULL, *rough = NULL, *dark = NULL, *welded = NULL;
    tree_surface before = {.struct_size = sizeof before}, after = before;
    OK(tree_mesh_surface(mesh, 0, &before));

    tree_subdivide_params subdivide;
    OK(tree_subdivide_params_init(&subdivide, sizeof subdivide));
    CHECK(subdivide.levels == 2 && subdivide.crease == 1.0f && subdivide.fit == 1);
    subdivide.levels = 1;
    OK(tree_mesh_subdivide(mesh, 0, &subdivide, NULL, &finer));
    OK(tree_mesh_surface(finer, 0, &after));
    CHECK(after.n_indices == 4 * before.n_indices);
    OK(tree_mesh_surface(finer, 1, &after));
    CHECK(after.n_anchors == 3);
    FAILS(TREE_ERROR_INVALID, "leaves", tree_mesh_subdivide(mesh, 1, NULL, NULL, &rough));
    subdivide.levels = 9;
    FAILS(TREE_ERROR_PARAMETER, "levels", tree_mesh_subdivide(mesh, 0, &subdivide, NULL, &rough));
    FAILS(TREE_ERROR_INVALID, "surface 5", tree_mesh_subdivide(mesh, 5, NULL, NULL, &rough));

    tree_displace_params displace;
    OK(tree_displace_params_init(&displace, sizeof displace));
    CHECK(displace.amplitude == 0.01f && displace.has_ground && displace.ground == 0.001f);
    OK(tree_mesh_displace(finer, 0, &displace, 3, NULL, &rough));
    OK(tree_mesh_surface(finer, 0, &before));
    OK(tree_mesh_surface(rough, 0, &after));
    CHECK(after.n_vertices == before.n_vertices);
    CHECK(memcmp(after.positions, before.positions, 12 * before.n_vertices) != 0);
    OK(tree_mesh_free(rough));
    displace.share = 0.6f;
    FAILS(TREE_ERROR_PARAMETER, "share", tree_mesh_displace(finer, 0, &displace, 3, NULL, &rough));

    tree_occlusion_params occlusion;
    OK(tree_occlusion_params_init(&occlusion, sizeof occlusion));
    CHECK(occlusion.cells == 64 && occlusion.directions == 48);
    occlusion.cells = 8;
    occlusion.directions = 6;
    OK(tree_mesh_bake_occlusion(mesh, &occlusion, NULL, &dark));
    OK(tree_mesh_surface(dark, 0, &after));
    CHECK(after.occlusion != NULL);
    for (size_t v = 0; after.occlusion && v < after.n_vertices; v++) {
        CHECK(after.occlusion[v] >= 0.0f && after.occlusion[v] <= 1.0f);
    }
    OK(tree_mesh_surface(mesh, 0, &before));
    CHECK(before.occlusion == NULL);
    OK(tree_mesh_free(dark));
    occlusion.directions = 0;
    FAILS(TREE_ERROR_PARAMETER, "directions",
          tree_mesh_bake_occlusion(mesh, &occlusion, NULL, &dark));

    OK(tree_mesh_weld(mesh, 0, NULL, &welded));
    OK(tree_mesh_surface(welded, 0, &after));
    CHECK(after.n_vertices < before.n_vertices);
    OK(tree_mesh_free(welded));
    FAILS(TREE_ERROR_INVALID, "leaves", tree_mesh_weld(mesh, 1, NULL, &welded));
    OK(tree_mesh_free(finer));
    OK(tree_mesh_free(mesh));
}

static void topology(void) {
    tree_mesh_params params = coarse();
    tree_mesh *mesh = a_mesh(&params);
    tree_topology found = {.struct_size = sizeof found};
    OK(tree_mesh_examine(mesh, 0, NULL, &found));
    CHECK(found.is_closed && found.euler == 2 && found.components == 1 && found.boundary_edges == 0);
    CHECK(found.volume > 0.01 && found.area > 0.1 && found.smallest_angle > 0);
    tree_surface bark = {.struct_size = sizeof bark};
    OK(tree_mesh_surface(mesh, 0, &bark));
    uint32_t *of_vertex = malloc(bark.n_vertices * sizeof *of_vertex);
    uint32_t *first = malloc(bark.n_vertices * sizeof *first);
    size_t n_points = 0;
    OK(tree_mesh_points(mesh, 0, of_vertex, bark.n_vertices, first, bark.n_vertices, &n_points));
    CHECK(n_points == found.n_points && first[0] == 0);
    for (size_t v = 0; v < bark.n_vertices; v++) {
        CHECK(of_vertex[v] < n_points && first[of_vertex[v]] == bark.welds[v]);
    }
    OK(tree_mesh_points(mesh, 0, NULL, 0, NULL, 0, NULL));
    FAILS(TREE_ERROR_BUFFER, "first", tree_mesh_points(mesh, 0, NULL, 0, first, 2, NULL));
    free(of_vertex);
    free(first);
    OK(tree_mesh_free(mesh));

    /* Two triangles through each other. */
    static const float corners[] = {-1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.3f, -1, 0, 0.3f, 1, 0, 0.6f, 0};
    static const float normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0};
    static const uint32_t order[] = {0, 1, 2, 3, 4, 5};
    tree_surface crossed = {.struct_size = sizeof crossed, .n_vertices = 6, .n_indices = 6,
                            .positions = corners, .normals = normals, .uvs = normals,
                            .indices = order};
    tree_material plain;
    OK(tree_material_init(&plain, sizeof plain));
    OK(tree_mesh_from_surfaces(&crossed, 1, &plain, 1, NULL, 0, NULL, &mesh));
    tree_crossings *crossings = NULL;
    OK(tree_mesh_crossings(mesh, 0, NULL, &crossings));
    tree_crossing_pairs pairs = {.struct_size = sizeof pairs};
    OK(tree_crossings_view(crossings, &pairs));
    CHECK(pairs.n_pairs == 1 && pairs.pairs[0] == 0 && pairs.pairs[1] == 1);
    CHECK(pairs.n_triangles == 2 && pairs.n_pairs_at_points == 0 && !pairs.pairs_at_points);
    OK(tree_crossings_free(crossings));
    OK(tree_mesh_examine(mesh, 0, NULL, &found));
    CHECK(!found.is_closed && found.boundary_edges == 6 && found.components == 2);
    OK(tree_mesh_free(mesh));
}

/* A picture without a mask cannot be outlined: the report says so. */
static void fallbacks(void) {
    tree_leaf_look leaf;
    OK(tree_leaf_look_init(&leaf, sizeof leaf));
    leaf.form = TREE_LEAF_OUTLINE;
    tree_look *look = NULL;
    OK(tree_look_new(NULL, &leaf, 1, NULL, &look));
    tree_tree *tree = an_oak_twig();
    tree_mesh *mesh = NULL;
    tree_mesh_report report = {.struct_size = sizeof report};
    tree_mesh_params params = coarse();
    OK(tree_mesh_build(tree, look, &params, NULL, &report, &mesh));
    CHECK(report.n_leaf_fallbacks == 1 && report.leaf_fallbacks && report.leaf_fallbacks[0] == 0);
    OK(tree_mesh_free(mesh));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
}

void test_mesh(void) {
    parameters();
    building();
    surfaces();
    materials();
    own_triangles();
    finishing();
    topology();
    fallbacks();
}
