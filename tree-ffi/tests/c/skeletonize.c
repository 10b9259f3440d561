#include "check.h"
#include <math.h>

enum { SIDES = 12, RINGS = 20, CARDS = 6 };

/* A tapering pole of ten units with open ends, and cards that stick out of it. */
static float wood[3 * SIDES * RINGS];
static uint32_t wood_indices[6 * SIDES * (RINGS - 1)];
static float cards[3 * 4 * CARDS], card_uvs[2 * 4 * CARDS];
static uint32_t card_indices[6 * CARDS];

static void build(tree_mesh_part parts[2]) {
    for (int ring = 0; ring < RINGS; ring++) {
        for (int side = 0; side < SIDES; side++) {
            float *at = wood + 3 * (ring * SIDES + side);
            float turn = 6.2831853f * (float)side / SIDES;
            float radius = 0.5f - 0.02f * (float)ring;
            at[0] = radius * cosf(turn);
            at[1] = 10 * (float)ring / (RINGS - 1);
            at[2] = -radius * sinf(turn);
        }
    }
    uint32_t *to = wood_indices;
    for (uint32_t ring = 0; ring + 1 < RINGS; ring++) {
        for (uint32_t side = 0; side < SIDES; side++) {
            uint32_t a = ring * SIDES + side, b = ring * SIDES + (side + 1) % SIDES;
            uint32_t quad[6] = {a, b, a + SIDES, b, b + SIDES, a + SIDES};
            memcpy(to, quad, sizeof quad);
            to += 6;
        }
    }
    for (uint32_t card = 0; card < CARDS; card++) {
        for (uint32_t corner = 0; corner < 4; corner++) {
            float *at = cards + 3 * (4 * card + corner);
            at[0] = 0.4f + (corner / 2 ? 1.0f : 0.0f);
            at[1] = 4 + (float)card;
            at[2] = corner % 2 ? 0.25f : -0.25f;
            card_uvs[2 * (4 * card + corner)] = (float)(corner % 2);
            card_uvs[2 * (4 * card + corner) + 1] = 1 - (float)(corner / 2);
        }
        uint32_t first = 4 * card, quad[6] = {0, 1, 2, 1, 3, 2};
        for (int i = 0; i < 6; i++) {
            card_indices[6 * card + (uint32_t)i] = first + quad[i];
        }
    }
    OK(tree_mesh_part_init(&parts[0], sizeof parts[0]));
    OK(tree_mesh_part_init(&parts[1], sizeof parts[1]));
    parts[0].name = (tree_str){"bark", 4};
    parts[0].positions = wood;
    parts[0].n_vertices = SIDES * RINGS;
    parts[0].indices = wood_indices;
    parts[0].n_indices = 6 * SIDES * (RINGS - 1);
    parts[1].name = (tree_str){"oak leaf", TREE_NUL_TERMINATED};
    parts[1].positions = cards;
    parts[1].uvs = card_uvs;
    parts[1].n_vertices = 4 * CARDS;
    parts[1].indices = card_indices;
    parts[1].n_indices = 6 * CARDS;
    parts[1].double_sided = 1;
    parts[1].alpha_masked = 1;
}

static void whole(const tree_mesh_part parts[2]) {
    tree_skeletonize_params params;
    OK(tree_skeletonize_params_init(&params, sizeof params));
    CHECK(params.spacing == 1 && params.leaves == 1);
    tree_skeletonize_report report = {.struct_size = sizeof report};
    tree_tree *tree;
    OK(tree_skeletonize(parts, 2, &params, NULL, &report, &tree));
    CHECK(report.n_triangles == 2 * SIDES * (RINGS - 1) + 2 * CARDS);
    CHECK(report.n_pieces == 1 && report.n_left_out == 0 && report.covered > 0.99f);
    CHECK(report.n_leaves == CARDS && report.n_leaf_kinds == 1 && report.n_blobs == 0);
    CHECK(fabsf(report.leaf_widths[0] - 0.5f) < 0.05f);
    tree_species species = {.struct_size = sizeof species};
    OK(tree_tree_species(tree, &species));
    CHECK(species.bark.len == 4 && memcmp(species.leaf_kinds[0].data, "oak leaf", 8) == 0);
    tree_skeleton *skeleton;
    float box[6];
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_bounds(skeleton, &box));
    CHECK(fabsf(box[4] - box[1] - 10) < 0.2f);
    OK(tree_skeleton_free(skeleton));
    OK(tree_tree_free(tree));

    params.leaves = 0;
    OK(tree_skeletonize(parts, 2, &params, NULL, &report, &tree));
    CHECK(report.n_leaves == 0);
    OK(tree_tree_free(tree));

    tree_mesh_part bad[2] = {parts[0], parts[1]};
    bad[0].hint = bad[1].hint = TREE_HINT_IGNORE;
    FAILS(TREE_ERROR_NO_RESULT, "wood", tree_skeletonize(bad, 2, NULL, NULL, NULL, &tree));
    CHECK(tree == NULL);
    bad[1].hint = 8;
    FAILS(TREE_ERROR_ENUM, "parts[1].hint", tree_skeletonize(bad, 2, NULL, NULL, NULL, &tree));
    bad[1].hint = TREE_HINT_LEAVES;
    bad[1].n_vertices = 3;
    FAILS(TREE_ERROR_INVALID, "index", tree_skeletonize(bad, 2, NULL, NULL, NULL, &tree));
    bad[1].positions = NULL;
    FAILS(TREE_ERROR_NULL, "parts[1].positions", tree_skeletonize(bad, 2, NULL, NULL, NULL, &tree));
    bad[0].n_indices = SIZE_MAX;
    FAILS(TREE_ERROR_LIMIT, "triangles", tree_skeletonize(bad, 2, NULL, NULL, NULL, &tree));
    bad[0].n_indices = 3;
    bad[0].n_vertices = SIZE_MAX;
    FAILS(TREE_ERROR_LIMIT, "triangles", tree_skeletonize(bad, 2, NULL, NULL, NULL, &tree));
    params.weld = NAN;
    FAILS(TREE_ERROR_PARAMETER, "weld", tree_skeletonize(parts, 2, &params, NULL, NULL, &tree));
    tree_cancel *cancel;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel",
          tree_skeletonize(parts, 2, NULL, &control, NULL, &tree));
    OK(tree_cancel_free(cancel));
}

static void stage_by_stage(const tree_mesh_part parts[2]) {
    tree_separation *separation, *other;
    OK(tree_separation_new(parts, 2, NULL, NULL, &separation));
    tree_separation_columns view = {.struct_size = sizeof view};
    OK(tree_separation_view(separation, &view));
    CHECK(view.n_components == 1 + CARDS);
    CHECK(view.starts[view.n_components] == view.n_triangles);
    CHECK(view.n_triangles == 2 * SIDES * (RINGS - 1) + 2 * CARDS);
    uint32_t classes[1 + CARDS];
    int n_leaves = 0;
    for (size_t i = 0; i < view.n_components; i++) {
        CHECK(view.classes[i] == (view.triangles[2 * view.starts[i]] ? TREE_CLASS_LEAF : TREE_CLASS_WOOD));
        n_leaves += view.classes[i] == TREE_CLASS_LEAF;
        /* One leaf stays. */
        classes[i] = n_leaves > 1 && view.classes[i] ? TREE_CLASS_IGNORED : view.classes[i];
    }
    OK(tree_separation_with_classes(separation, classes, 1 + CARDS, &other));
    OK(tree_separation_free(separation));
    FAILS(TREE_ERROR_INVALID, "components",
          tree_separation_with_classes(other, classes, 1, &separation));
    classes[0] = 9;
    FAILS(TREE_ERROR_ENUM, "classes[0]",
          tree_separation_with_classes(other, classes, 1 + CARDS, &separation));

    tree_pieces *pieces, *copies;
    size_t n_pieces;
    OK(tree_separation_follow(other, NULL, NULL, &pieces));
    OK(tree_pieces_count(pieces, &n_pieces));
    CHECK(n_pieces == 1);
    tree_piece row;
    tree_skeleton *piece, *linked, *outward;
    OK(tree_pieces_piece(pieces, 0, &row, &piece));
    CHECK(row.area > 0 && row.n_cut == 0);
    FAILS(TREE_ERROR_PARAMETER, "pieces", tree_pieces_piece(pieces, 1, NULL, &outward));
    OK(tree_pieces_free(pieces));
    const tree_skeleton *const own[] = {piece};
    OK(tree_pieces_new(own, &row, 1, NULL, &copies));
    /* The nodes of all pieces together are capped, not the number of pieces. */
    const tree_skeleton *const twice[] = {piece, piece};
    const tree_piece rows[] = {row, row};
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_skeleton_view(piece, &columns));
    tree_limits limits;
    tree_control few;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&few, sizeof few));
    few.limits = &limits;
    limits.nodes = 2 * columns.n_nodes;
    tree_pieces *two;
    OK(tree_pieces_new(twice, rows, 2, &few, &two));
    OK(tree_pieces_free(two));
    limits.nodes--;
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_pieces_new(twice, rows, 2, &few, &two));
    CHECK(two == NULL);
    OK(tree_skeleton_free(piece));
    uint8_t reached = 9;
    OK(tree_pieces_link(copies, NULL, NULL, &reached, 1, &linked));
    CHECK(reached == 1);
    OK(tree_pieces_free(copies));
    OK(tree_pieces_new(NULL, NULL, 0, NULL, &copies));
    FAILS(TREE_ERROR_NO_RESULT, "pieces", tree_pieces_link(copies, NULL, NULL, NULL, 0, &outward));
    OK(tree_pieces_free(copies));

    tree_found_leaves *leaves;
    OK(tree_separation_leaves(other, linked, NULL, &leaves));
    tree_foliage foliage = {.struct_size = sizeof foliage};
    tree_leaf_kinds kinds = {.struct_size = sizeof kinds};
    OK(tree_found_leaves_foliage(leaves, &foliage));
    OK(tree_found_leaves_view(leaves, &kinds));
    CHECK(foliage.n_leaves == 1 && fabsf(foliage.sizes[0] - 1) < 0.1f);
    CHECK(kinds.n_kinds == 1 && kinds.names[0].len == 8 && fabsf(kinds.widths[0] - 0.5f) < 0.05f);
    OK(tree_found_leaves_free(leaves));
    OK(tree_separation_outward(other, linked, &outward));
    float inner[6], box[6];
    OK(tree_skeleton_bounds(linked, &inner));
    OK(tree_skeleton_bounds(outward, &box));
    CHECK(inner[4] - inner[1] < 1.1f && fabsf(box[4] - box[1] - 10) < 0.2f);
    OK(tree_skeleton_free(linked));
    OK(tree_skeleton_free(outward));
    OK(tree_separation_free(other));
}

/* What this library drew, read back. */
static void of_a_mesh(void) {
    tree_tree *tree = an_oak_twig(), *again;
    tree_look *look;
    tree_mesh *mesh;
    OK(tree_look_of_tree(tree, 1, &look));
    OK(tree_mesh_build(tree, look, NULL, NULL, NULL, &mesh));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_mesh_measure(mesh, &totals));

    tree_skeletonize_report report = {.struct_size = sizeof report};
    OK(tree_skeletonize_mesh(mesh, NULL, 0, NULL, NULL, &report, &again));
    CHECK(report.n_triangles == totals.n_triangles && report.n_leaves == 3);
    CHECK(report.n_pieces >= 1 && report.n_left_out == 0);
    tree_skeleton *skeleton;
    float box[6];
    OK(tree_tree_skeleton(again, &skeleton));
    OK(tree_skeleton_bounds(skeleton, &box));
    CHECK(fabsf(box[4] - 2.5f) < 0.1f && fabsf(box[3] - 0.5f) < 0.1f);
    OK(tree_skeleton_free(skeleton));
    OK(tree_tree_free(again));

    const uint32_t hints[] = {TREE_HINT_WOOD, TREE_HINT_IGNORE};
    OK(tree_skeletonize_mesh(mesh, hints, 2, NULL, NULL, &report, &again));
    CHECK(report.n_leaves == 0);
    OK(tree_tree_free(again));
    FAILS(TREE_ERROR_INVALID, "surfaces",
          tree_skeletonize_mesh(mesh, hints, 1, NULL, NULL, NULL, &again));
    tree_separation *separation;
    OK(tree_separation_of_mesh(mesh, hints, 2, NULL, NULL, &separation));
    tree_separation_columns view = {.struct_size = sizeof view};
    /* The copies outlive the mesh. */
    OK(tree_mesh_free(mesh));
    OK(tree_separation_view(separation, &view));
    tree_pieces *pieces;
    size_t n_pieces;
    OK(tree_separation_follow(separation, NULL, NULL, &pieces));
    OK(tree_pieces_count(pieces, &n_pieces));
    CHECK(n_pieces == report.n_pieces && view.n_components >= n_pieces);
    OK(tree_pieces_free(pieces));
    OK(tree_separation_free(separation));
    FAILS(TREE_ERROR_HANDLE, "mesh",
          tree_skeletonize_mesh(mesh, NULL, 0, NULL, NULL, NULL, &again));
}

void test_skeletonize(void) {
    tree_mesh_part parts[2];
    build(parts);
    whole(parts);
    stage_by_stage(parts);
    of_a_mesh();
}
