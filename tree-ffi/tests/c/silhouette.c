/* Trees from outlines: sessions and their edits, plans, growth. */
#include "check.h"
#include <math.h>

enum { MOST = 512 };

/* A ring with lobes, against the clock; the first point is not repeated. */
static size_t ring(float *points, float x, float y, float radius, float wave, int n_lobes) {
    enum { N = 144 };
    for (int i = 0; i < N; i++) {
        double turn = 6.283185307 * i / N;
        double reach = radius * (1 + wave * sin(n_lobes * turn));
        points[2 * i] = (float)(x + reach * cos(turn));
        points[2 * i + 1] = (float)(y + reach * sin(turn));
    }
    return N;
}

static const float trunk_points[] = {0, 0, 0.05f, 2, 0, 5};

static tree_silhouette_change_columns view_of(const tree_silhouette_change *change) {
    tree_silhouette_change_columns columns = {.struct_size = sizeof columns};
    OK(tree_silhouette_change_view(change, &columns));
    return columns;
}

static int has(const uint32_t *ids, size_t n, uint32_t id) {
    for (size_t i = 0; i < n; i++)
        if (ids[i] == id) return 1;
    return 0;
}

/* Little work, and no leaves too many. */
static const tree_silhouette_params *small(void) {
    static tree_silhouette_params params;
    static tree_silhouette_grow_params grow;
    static tree_silhouette_leaves leaves;
    OK(tree_silhouette_params_init(&params, sizeof params));
    OK(tree_silhouette_grow_params_init(&grow, sizeof grow));
    OK(tree_silhouette_leaves_init(&leaves, sizeof leaves));
    CHECK(params.nearness == 0.35f && params.height == 10 && params.grow == NULL);
    CHECK(grow.has_leaves == 1 && grow.depth == 0 && grow.n_levels == 0 && grow.trunk_radius == 0);
    CHECK(grow.fence == 1 && grow.fill == 1.6f);
    CHECK(isnan(leaves.length) && isnan(leaves.bare) && leaves.petiole == 0.05f);
    CHECK(leaves.arrangement.kind == TREE_ARRANGEMENT_SPIRAL);
    leaves.spacing = 2;
    grow.leaves = &leaves;
    grow.depth = 2;
    params.grow = &grow;
    OK(tree_silhouette_params_check(&params));
    return &params;
}

/* Trunk and crown. */
static tree_silhouette_session *a_silhouette(void) {
    float crown[2 * MOST];
    size_t n = ring(crown, 0, 5, 3, 0.16f, 7);
    tree_silhouette_session *silhouette = NULL;
    OK(tree_silhouette_session_new(small(), 5, &silhouette));
    OK(tree_silhouette_session_draw_trunk(silhouette, trunk_points, 3, NULL, NULL));
    OK(tree_silhouette_session_draw_crown(silhouette, crown, n, NULL, NULL));
    return silhouette;
}

static tree_outline_plan *plan_of(const tree_silhouette_session *silhouette) {
    tree_outline_plan *plan = NULL;
    OK(tree_silhouette_session_plan(silhouette, &plan));
    return plan;
}

static tree_outline_plan_columns columns_of(const tree_outline_plan *plan) {
    tree_outline_plan_columns columns = {.struct_size = sizeof columns};
    OK(tree_outline_plan_view(plan, &columns));
    return columns;
}

static tree_outline_branch branch_of(const tree_outline_plan *plan, uint32_t id) {
    tree_outline_branch branch = {.struct_size = sizeof branch};
    OK(tree_outline_plan_branch(plan, id, &branch));
    return branch;
}

static int same_points(const float *a, size_t n_a, const float *b, size_t n_b) {
    return n_a == n_b && memcmp(a, b, 2 * n_a * sizeof *a) == 0;
}

/* A number for all positions of a tree. */
static double sum_of(const tree_tree *tree) {
    tree_skeleton *skeleton = NULL;
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_view(skeleton, &columns));
    double sum = 0;
    for (size_t i = 0; i < 3 * columns.n_nodes; i++) sum += columns.positions[i] * (double)(i % 7 + 1);
    OK(tree_skeleton_free(skeleton));
    return sum;
}

static double sum_of_silhouette(const tree_silhouette_session *silhouette, const tree_control *control) {
    tree_tree *tree = NULL;
    OK(tree_silhouette_session_tree(silhouette, control, NULL, &tree));
    double sum = sum_of(tree);
    OK(tree_tree_free(tree));
    return sum;
}

static void test_first_strokes(void) {
    tree_silhouette_session *silhouette = NULL;
    tree_outline_plan *plan = NULL;
    tree_tree *tree = NULL;
    tree_silhouette_change *change = NULL;
    float by_bumps = 9, by_all = 9, crown[2 * MOST];
    OK(tree_silhouette_session_new(NULL, 5, &silhouette));
    FAILS(TREE_ERROR_NO_RESULT, "crown", tree_silhouette_session_plan(silhouette, &plan));
    FAILS(TREE_ERROR_INVALID, "crown", tree_silhouette_session_tree(silhouette, NULL, NULL, &tree));
    FAILS(TREE_ERROR_INVALID, "crown",
          tree_silhouette_session_draw_leaf(silhouette, trunk_points, 3, NULL, &change));
    OK(tree_silhouette_session_coverage(silhouette, &by_bumps, &by_all));
    CHECK(by_bumps == 0 && by_all == 0 && plan == NULL && tree == NULL && change == NULL);

    /* With the clock: it is turned. A point far away is left out, and that is told. */
    size_t n = ring(crown, 0, 5, 3, 0.16f, 7);
    float turned[2 * MOST];
    for (size_t i = 0; i < n; i++) {
        turned[2 * i] = crown[2 * (n - 1 - i)];
        turned[2 * i + 1] = crown[2 * (n - 1 - i) + 1];
    }
    turned[6] = 1e30f;
    OK(tree_silhouette_session_draw_crown(silhouette, turned, n, NULL, &change));
    tree_silhouette_change_columns changed = view_of(change);
    CHECK(changed.trunk == 1 && changed.n_added >= 5);
    CHECK(changed.n_removed == 0 && changed.removed == NULL && changed.n_reshaped == 0);
    CHECK(changed.n_repairs >= 1);
    int told = 0;
    for (size_t i = 0; i < changed.n_repairs; i++) {
        char text[200] = "";
        memcpy(text, changed.repairs[i].data, changed.repairs[i].len < 199 ? changed.repairs[i].len : 199);
        told |= strstr(text, "crown") && strstr(text, "left out");
    }
    CHECK(told);

    /* The plan has the branches that the change names; all stand on the trunk. */
    plan = plan_of(silhouette);
    tree_outline_plan_columns columns = columns_of(plan);
    tree_outline_system trunk = {.struct_size = sizeof trunk};
    OK(tree_outline_plan_system(plan, TREE_NO_BRANCH, &trunk));
    CHECK(columns.n_branches == changed.n_added && columns.n_own == columns.n_branches);
    CHECK(trunk.n_branches == columns.n_branches && trunk.n_angles == 2 && trunk.n_sections == 0);
    CHECK(trunk.angles[0] == 0 && trunk.angles[1] == 1.35f && trunk.angles[2] == 1);
    CHECK(trunk.n_axis_points > 2 && trunk.n_outline_points > 50);
    CHECK(columns.line_starts[columns.n_branches] == columns.n_line_points);
    CHECK(columns.outline_starts[columns.n_branches] == columns.n_outline_points);
    int n_lefts = 0, n_of_bumps = 0;
    for (size_t i = 0; i < columns.n_branches; i++) {
        uint32_t id = columns.ids[i];
        const float *line = columns.line_points + 2 * columns.line_starts[i];
        size_t n_line = columns.line_starts[i + 1] - columns.line_starts[i];
        CHECK(id > 0 && has(changed.added, changed.n_added, id));
        CHECK(columns.parents[i] == TREE_NO_BRANCH && columns.levels[i] == 1);
        CHECK(columns.styles[i] == TREE_NO_BRANCH && !columns.refined[i] && isnan(columns.azimuths[i]));
        CHECK(columns.places[i] >= 0 && columns.places[i] <= 1 && columns.radii[i] >= 0);
        /* The axis is upright here: what is left of it ends there. */
        CHECK(fabsf(line[0]) < 0.3f && (line[2 * n_line - 2] < line[0]) == columns.lefts[i]);
        n_lefts += columns.lefts[i];
        n_of_bumps += columns.origins[i] == TREE_BRANCH_OF_BUMP;
        CHECK(columns.origins[i] <= TREE_BRANCH_OF_COVERAGE);
        CHECK(isnan(columns.stretches[2 * i]) || columns.stretches[2 * i] < columns.stretches[2 * i + 1]);
        size_t row = 99;
        OK(tree_outline_plan_find(plan, id, &row));
        tree_outline_branch branch = branch_of(plan, id);
        CHECK(row == i && branch.id == id && branch.level == 1 && branch.place == columns.places[i]);
        CHECK(branch.is_left == columns.lefts[i] && branch.origin == columns.origins[i]);
        CHECK(same_points(branch.line_points, branch.n_line_points, line, n_line));
        CHECK(same_points(branch.outline_points, branch.n_outline_points,
                          columns.outline_points + 2 * columns.outline_starts[i],
                          columns.outline_starts[i + 1] - columns.outline_starts[i]));
    }
    CHECK(n_lefts > 1 && (size_t)n_lefts + 1 < columns.n_branches && n_of_bumps >= 5);
    OK(tree_silhouette_session_coverage(silhouette, &by_bumps, &by_all));
    CHECK(by_bumps > 0.3f && by_all >= by_bumps && by_all > 0.6f && by_all <= 1);

    /* What is not there. */
    size_t row = 0;
    uint32_t n_levels = 0;
    float length = 0;
    tree_outline *outline = NULL;
    tree_leaf_outline *leaf = NULL;
    tree_outline_branch none = {.struct_size = sizeof none};
    FAILS(TREE_ERROR_INVALID, "branch 9999", tree_outline_plan_find(plan, 9999, &row));
    FAILS(TREE_ERROR_INVALID, "branch 0", tree_outline_plan_branch(plan, TREE_NO_BRANCH, &none));
    FAILS(TREE_ERROR_NO_RESULT, "not drawn", tree_outline_plan_system(plan, columns.ids[0], &trunk));
    FAILS(TREE_ERROR_INVALID, "section is 0",
          tree_outline_plan_section(plan, TREE_NO_BRANCH, 0, &length, &outline));
    FAILS(TREE_ERROR_NO_RESULT, "leaf", tree_outline_plan_leaf(plan, &length, &leaf));
    CHECK(outline == NULL && leaf == NULL);
    OK(tree_outline_plan_count_levels(plan, &n_levels));
    CHECK(n_levels == 1);

    /* The trunk drawn from the top down is turned. What was handed out stays as it was. */
    static const float down[] = {0, 5, 0.05f, 2, 0, 0};
    OK(tree_silhouette_change_free(change));
    OK(tree_silhouette_session_draw_trunk(silhouette, down, 3, NULL, &change));
    changed = view_of(change);
    CHECK(changed.trunk == 1 && changed.n_repairs == 1);
    CHECK(trunk.axis_points[1] > 1 && columns.n_branches == columns_of(plan).n_branches);
    OK(tree_outline_plan_free(plan));
    plan = plan_of(silhouette);
    OK(tree_outline_plan_system(plan, TREE_NO_BRANCH, &trunk));
    CHECK(trunk.axis_points[0] == 0 && trunk.axis_points[1] == 0);
    OK(tree_outline_plan_free(plan));
    OK(tree_silhouette_change_free(change));

    /* Far from the crown it bears nothing. */
    static const float aside[] = {40, 0, 40, 5};
    FAILS(TREE_ERROR_INVALID, "trunk", tree_silhouette_session_draw_trunk(silhouette, aside, 2, NULL, &change));
    CHECK(change == NULL);
    OK(tree_silhouette_session_free(silhouette));
}

static void test_levels(void) {
    tree_silhouette_session *silhouette = a_silhouette();
    tree_silhouette_change *change = NULL;
    tree_outline_plan *plan = plan_of(silhouette);
    tree_outline_plan_columns columns = columns_of(plan);
    uint32_t first = columns.ids[0], other = columns.ids[1], n_levels = 0;

    /* Its own outline, drawn: the branch bears a system. */
    tree_outline_branch branch = branch_of(plan, first);
    OK(tree_silhouette_session_refine_branch(silhouette, first, branch.outline_points,
                                     branch.n_outline_points, NULL, &change));
    tree_silhouette_change_columns changed = view_of(change);
    CHECK(changed.n_restyled == 1 && changed.restyled[0] == first && changed.n_added > 0);
    CHECK(changed.trunk == 0 && changed.n_removed == 0);
    tree_outline_plan *refined = plan_of(silhouette);
    tree_outline_plan_columns now = columns_of(refined);
    tree_outline_system system = {.struct_size = sizeof system};
    OK(tree_outline_plan_system(refined, first, &system));
    OK(tree_outline_plan_count_levels(refined, &n_levels));
    CHECK(system.n_branches == changed.n_added && n_levels == 2);
    CHECK(now.n_branches == columns.n_branches + changed.n_added);
    CHECK(branch_of(refined, first).is_refined == 1 && branch_of(refined, other).is_refined == 0);
    CHECK(same_points(system.axis_points, system.n_axis_points,
                      branch_of(refined, first).line_points, branch.n_line_points));
    for (size_t i = columns.n_branches; i < now.n_branches; i++)
        CHECK(now.levels[i] == 2 && now.parents[i] == first && has(changed.added, changed.n_added, now.ids[i]));
    OK(tree_silhouette_change_free(change));

    /* The same by its place: the branch that runs through it. */
    tree_silhouette_session *copy = NULL;
    OK(tree_silhouette_session_copy(silhouette, &copy));
    branch = branch_of(plan, other);
    OK(tree_silhouette_session_refine(copy, 1, branch.outline_points, branch.n_outline_points, NULL, &change));
    changed = view_of(change);
    CHECK(changed.n_restyled == 1 && changed.restyled[0] == other);
    OK(tree_silhouette_change_free(change));
    FAILS(TREE_ERROR_INVALID, "level 3",
          tree_silhouette_session_refine(copy, 4, branch.outline_points, branch.n_outline_points, NULL, &change));
    FAILS(TREE_ERROR_PARAMETER, "level",
          tree_silhouette_session_refine(copy, 9, branch.outline_points, branch.n_outline_points, NULL, &change));
    FAILS(TREE_ERROR_INVALID, "branch 9999",
          tree_silhouette_session_refine_branch(copy, 9999, branch.outline_points, branch.n_outline_points,
                                        NULL, &change));
    OK(tree_silhouette_session_free(copy));

    /* Styles: the second takes that of the first, whatever is nearest. */
    uint32_t targets[] = {other};
    OK(tree_silhouette_session_copy_style(silhouette, first, targets, 1, &change));
    changed = view_of(change);
    CHECK(changed.n_restyled == 1 && changed.restyled[0] == other && changed.n_reshaped == 0);
    OK(tree_silhouette_change_free(change));
    FAILS(TREE_ERROR_INVALID, "not drawn", tree_silhouette_session_copy_style(silhouette, other, targets, 1, &change));
    OK(tree_outline_plan_free(refined));
    refined = plan_of(silhouette);
    CHECK(branch_of(refined, other).style == first);
    OK(tree_silhouette_session_copy_style(silhouette, 0, targets, 1, NULL));
    OK(tree_outline_plan_free(refined));
    refined = plan_of(silhouette);
    CHECK(branch_of(refined, other).style == TREE_NO_BRANCH);
    OK(tree_outline_plan_free(refined));

    /* The leaf: as long as it was drawn. */
    float points[2 * MOST], length = 0;
    size_t n = ring(points, 8, 1, 0.05f, 0, 0);
    tree_leaf_outline *leaf = NULL;
    OK(tree_silhouette_session_draw_leaf(silhouette, points, n, NULL, &change));
    changed = view_of(change);
    CHECK(changed.leaf == 1 && changed.trunk == 0 && changed.n_added == 0 && changed.n_restyled == 0);
    OK(tree_silhouette_change_free(change));
    refined = plan_of(silhouette);
    OK(tree_outline_plan_leaf(refined, &length, &leaf));
    CHECK(fabsf(length - 0.1f) < 0.01f);
    OK(tree_leaf_outline_free(leaf));
    OK(tree_outline_plan_free(refined));

    /* The crown from the side. */
    tree_outline *outline = NULL;
    n = ring(points, 0, 5, 2, 0.1f, 5);
    OK(tree_silhouette_session_draw_section(silhouette, 1.5708f, points, n, NULL, &change));
    CHECK(view_of(change).trunk == 1);
    OK(tree_silhouette_change_free(change));
    refined = plan_of(silhouette);
    float azimuth = 0;
    OK(tree_outline_plan_section(refined, TREE_NO_BRANCH, 0, &azimuth, &outline));
    CHECK(azimuth == 1.5708f);
    OK(tree_outline_free(outline));
    FAILS(TREE_ERROR_INVALID, "there are 0",
          tree_outline_plan_section(refined, first, 0, &azimuth, &outline));
    OK(tree_outline_plan_outline(refined, TREE_NO_BRANCH, &outline));
    OK(tree_outline_free(outline));
    OK(tree_outline_plan_outline(refined, other, &outline));
    OK(tree_outline_free(outline));
    OK(tree_outline_plan_free(refined));
    OK(tree_outline_plan_free(plan));
    OK(tree_silhouette_session_free(silhouette));
}

/* The line of a branch with its tip moved up. */
static size_t bent(const tree_outline_branch *branch, float *points) {
    size_t n = branch->n_line_points;
    memcpy(points, branch->line_points, 2 * n * sizeof *points);
    for (size_t i = 0; i < n; i++) {
        float share = (float)i / (float)(n - 1);
        points[2 * i + 1] += 0.3f * share * share;
    }
    return n;
}

static void test_redrawn(void) {
    tree_silhouette_session *silhouette = a_silhouette();
    tree_silhouette_change *change = NULL;
    tree_outline_plan *plan = plan_of(silhouette);
    tree_outline_plan_columns columns = columns_of(plan);
    uint32_t id = columns.ids[0], side = columns.lefts[0];
    tree_outline_branch branch = branch_of(plan, id);
    float points[2 * MOST];
    size_t n = bent(&branch, points), n_side = 0, n_undo = 0, n_redo = 0;
    for (size_t i = 0; i < columns.n_branches; i++) n_side += columns.lefts[i] == side;

    /* By who takes its shape. */
    struct {
        tree_transfer transfer;
        size_t least, most;
    } cases[] = {{TREE_TRANSFER_NOBODY, 1, 1},
                 {TREE_TRANSFER_ONLY, 2, 2},
                 {TREE_TRANSFER_SIDE, 2, n_side},
                 {TREE_TRANSFER_SIBLINGS, n_side, columns.n_branches}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        OK(tree_silhouette_session_redraw(silhouette, 1, points, n, cases[i].transfer, columns.ids + 1, 1,
                                  NULL, &change));
        tree_silhouette_change_columns changed = view_of(change);
        CHECK(changed.n_added == 0 && changed.n_removed == 0 && has(changed.reshaped, changed.n_reshaped, id));
        CHECK(changed.n_reshaped >= cases[i].least && changed.n_reshaped <= cases[i].most);
        if (cases[i].transfer == TREE_TRANSFER_ONLY)
            CHECK(has(changed.reshaped, changed.n_reshaped, columns.ids[1]));
        OK(tree_silhouette_change_free(change));
        tree_outline_plan *redrawn = plan_of(silhouette);
        tree_outline_branch drawn = branch_of(redrawn, id);
        CHECK(drawn.origin == TREE_BRANCH_DRAWN && drawn.n_line_points > 2);
        CHECK(fabsf(drawn.line_points[2 * drawn.n_line_points - 1] - points[2 * n - 1]) < 1e-4f);
        tree_outline_system trunk = {.struct_size = sizeof trunk};
        OK(tree_outline_plan_system(redrawn, TREE_NO_BRANCH, &trunk));
        CHECK(trunk.n_angles >= 2);
        OK(tree_outline_plan_free(redrawn));
        OK(tree_silhouette_session_undo(silhouette, NULL));
    }
    FAILS(TREE_ERROR_ENUM, "TREE_TRANSFER_",
          tree_silhouette_session_redraw(silhouette, 1, points, n, 4, NULL, 0, NULL, &change));
    FAILS(TREE_ERROR_NULL, "only",
          tree_silhouette_session_redraw(silhouette, 1, points, n, TREE_TRANSFER_ONLY, NULL, 2, NULL, &change));
    FAILS(TREE_ERROR_INVALID, "no length",
          tree_silhouette_session_redraw(silhouette, 1, points, 1, TREE_TRANSFER_NOBODY, NULL, 0, NULL, &change));
    CHECK(change == NULL);

    /* Seen from the side: a new branch, with an azimuth. From in front it is as before. */
    static const float towards[] = {0, 3.5f, 1, 4.2f, 1.8f, 5};
    OK(tree_silhouette_session_redraw_from(silhouette, 1.5708f, 0, towards, 3, TREE_TRANSFER_NOBODY, NULL, 0,
                                   NULL, &change));
    tree_silhouette_change_columns changed = view_of(change);
    CHECK(changed.n_added == 1 && changed.n_reshaped == 0);
    tree_outline_plan *more = plan_of(silhouette);
    branch = branch_of(more, changed.added[0]);
    CHECK(branch.origin == TREE_BRANCH_DRAWN && fabsf(branch.azimuth - 4.7124f) < 0.01f);
    CHECK(columns_of(more).n_branches == columns.n_branches + 1);
    OK(tree_outline_plan_free(more));
    uint32_t added = changed.added[0];
    OK(tree_silhouette_change_free(change));
    OK(tree_silhouette_session_redraw_from(silhouette, 0, 0, points, n, TREE_TRANSFER_NOBODY, NULL, 0, NULL,
                                   &change));
    changed = view_of(change);
    CHECK(changed.n_reshaped == 1 && changed.reshaped[0] == id && changed.n_added == 0);
    OK(tree_silhouette_change_free(change));
    FAILS(TREE_ERROR_PARAMETER, "view.pitch",
          tree_silhouette_session_redraw_from(silhouette, 0, 1.5f, points, n, 0, NULL, 0, NULL, &change));
    FAILS(TREE_ERROR_PARAMETER, "view.yaw",
          tree_silhouette_session_redraw_from(silhouette, NAN, 0, points, n, 0, NULL, 0, NULL, &change));

    /* Removed, undone, done again. */
    OK(tree_silhouette_session_remove(silhouette, added, &change));
    changed = view_of(change);
    CHECK(changed.n_removed == 1 && changed.removed[0] == added && changed.n_reshaped == 0);
    OK(tree_silhouette_change_free(change));
    FAILS(TREE_ERROR_INVALID, "no branch", tree_silhouette_session_remove(silhouette, added, &change));
    OK(tree_silhouette_session_depth(silhouette, &n_undo, &n_redo));
    /* Trunk, crown, two redrawn, one removed; those undone before are forgotten. */
    CHECK(n_undo == 5 && n_redo == 0);
    OK(tree_silhouette_session_undo(silhouette, &change));
    changed = view_of(change);
    CHECK(changed.n_added == 1 && changed.added[0] == added && changed.n_removed == 0);
    OK(tree_silhouette_change_free(change));
    OK(tree_silhouette_session_depth(silhouette, &n_undo, &n_redo));
    CHECK(n_undo == 4 && n_redo == 1);
    OK(tree_silhouette_session_redo(silhouette, &change));
    changed = view_of(change);
    CHECK(changed.n_removed == 1 && changed.removed[0] == added);
    OK(tree_silhouette_change_free(change));
    FAILS(TREE_ERROR_NO_RESULT, "again", tree_silhouette_session_redo(silhouette, &change));
    for (int i = 0; i < 5; i++) OK(tree_silhouette_session_undo(silhouette, NULL));
    FAILS(TREE_ERROR_NO_RESULT, "take back", tree_silhouette_session_undo(silhouette, &change));
    CHECK(change == NULL);
    OK(tree_outline_plan_free(plan));
    FAILS(TREE_ERROR_NO_RESULT, "", tree_silhouette_session_plan(silhouette, &plan));
    OK(tree_silhouette_session_free(silhouette));
}

static void test_tree(void) {
    tree_silhouette_session *silhouette = a_silhouette();
    tree_outline_plan *plan = plan_of(silhouette);
    tree_tree *tree = NULL, *same = NULL;
    tree_silhouette_grown grown = {.struct_size = sizeof grown}, again = grown;
    OK(tree_silhouette_session_tree(silhouette, NULL, &grown, &tree));
    tree_foliage foliage = {.struct_size = sizeof foliage};
    OK(tree_tree_foliage(tree, &foliage));
    size_t n_sketched = columns_of(plan).n_branches;
    uint64_t n = grown.n_leaves;
    for (size_t i = 0; i < TREE_SILHOUETTE_LEVELS; i++) n += grown.branches[i];
    CHECK(grown.n_levels == 3 && grown.branches[0] == 1 && grown.n_sketched == n_sketched);
    CHECK(grown.branches[1] > n_sketched && grown.branches[2] > grown.branches[1]);
    CHECK(grown.n_leaves > 100 && grown.n_leaves == foliage.n_leaves && grown.n_elements == n);
    CHECK(grown.n_patterns > 0);

    /* Of the plan alone, on one thread: the same. */
    tree_pool_options one = {.struct_size = sizeof one, .n_threads = 1};
    tree_pool *pool = NULL;
    tree_control control;
    OK(tree_pool_new(&one, &pool));
    OK(tree_control_init(&control, sizeof control));
    control.pool = pool;
    OK(tree_outline_plan_grow(plan, small()->grow, 5, &control, &again, &same));
    CHECK(sum_of(same) == sum_of(tree) && memcmp(&grown, &again, sizeof grown) == 0);
    OK(tree_tree_free(same));
    CHECK(sum_of_silhouette(silhouette, &control) == sum_of(tree));
    OK(tree_pool_free(pool));

    /* Another seed, another tree. */
    uint64_t seed = 0;
    OK(tree_silhouette_session_set_seed(silhouette, 6));
    OK(tree_silhouette_session_seed(silhouette, &seed));
    CHECK(seed == 6 && sum_of_silhouette(silhouette, NULL) != sum_of(tree));
    OK(tree_tree_free(tree));

    /* Other parameters. */
    tree_silhouette_params params = {.struct_size = sizeof params};
    OK(tree_silhouette_session_get_params(silhouette, &params));
    CHECK(params.grow->depth == 2 && params.grow->leaves->spacing == 2 && params.system->bumps != NULL);
    CHECK(params.system->cover->places == 24 && params.system->infer->points == 16);
    CHECK(params.angles->n_samples == 2 && params.grow->species->n_leaf_kinds == 1);
    tree_silhouette_grow_params grow = *params.grow;
    tree_silhouette_level level;
    OK(tree_silhouette_level_init(&level, sizeof level));
    CHECK(level.density == 2 && level.count == 18 && level.angles == NULL);
    CHECK(level.arrangement.kind == TREE_ARRANGEMENT_SPREAD);
    level.density = 0;
    grow.levels = &level;
    grow.n_levels = 1;
    grow.has_leaves = 0;
    grow.depth = 1;
    params.grow = &grow;
    tree_silhouette_change *change = NULL;
    OK(tree_silhouette_session_set_params(silhouette, &params, &change));
    CHECK(view_of(change).n_added == 0 && view_of(change).n_reshaped == 0);
    OK(tree_silhouette_change_free(change));
    OK(tree_silhouette_session_tree(silhouette, NULL, &grown, &tree));
    CHECK(grown.n_leaves == 0 && grown.n_levels == 2 && grown.branches[1] == n_sketched);
    OK(tree_tree_free(tree));
    OK(tree_silhouette_session_get_params(silhouette, &params));
    CHECK(params.grow->has_leaves == 0 && params.grow->levels->density == 0);

    /* Those of branches: they are inferred anew, and that can be taken back. */
    tree_branch_system_params system;
    tree_cover_params cover;
    OK(tree_branch_system_params_init(&system, sizeof system));
    OK(tree_cover_params_init(&cover, sizeof cover));
    CHECK(cover.overlap == 0.2f && system.cover == NULL);
    cover.places = 0;
    cover.bare = 1;
    system.cover = &cover;
    params.system = &system;
    OK(tree_silhouette_session_set_params(silhouette, &params, &change));
    CHECK(view_of(change).n_removed > 0);
    OK(tree_silhouette_change_free(change));
    float by_bumps = 0, by_all = 1;
    OK(tree_silhouette_session_coverage(silhouette, &by_bumps, &by_all));
    CHECK(by_bumps == by_all);
    OK(tree_silhouette_session_undo(silhouette, NULL));
    OK(tree_silhouette_session_get_params(silhouette, &params));
    CHECK(params.system->cover->places == 24);
    params.nearness = -1;
    FAILS(TREE_ERROR_PARAMETER, "near", tree_silhouette_session_set_params(silhouette, &params, &change));
    OK(tree_outline_plan_free(plan));
    OK(tree_silhouette_session_free(silhouette));
}

static int32_t busy(void *user, const char *stage, float fraction) {
    (void)stage;
    (void)fraction;
    FAILS(TREE_ERROR_ORDER, "at work", tree_silhouette_session_undo(user, NULL));
    FAILS(TREE_ERROR_ORDER, "at work", tree_silhouette_session_free(user));
    return 0;
}

static int32_t at_once(void *user, const char *stage, float fraction) {
    (void)stage;
    (void)fraction;
    ++*(int *)user;
    return 1;
}

static void test_what_goes_wrong(void) {
    tree_silhouette_session *silhouette = a_silhouette();
    tree_control control;
    int n_told = 0;
    tree_tree *tree = (tree_tree *)&n_told;
    OK(tree_control_init(&control, sizeof control));
    control.progress = at_once;
    control.user = &n_told;
    FAILS(TREE_ERROR_CANCELLED, "", tree_silhouette_session_tree(silhouette, &control, NULL, &tree));
    CHECK(tree == NULL && n_told == 1);
    control.progress = busy;
    control.user = silhouette;
    OK(tree_silhouette_session_tree(silhouette, &control, NULL, &tree));
    OK(tree_tree_free(tree));

    /* Cancelled before it begins, an edit is not done. */
    tree_cancel *cancel = NULL;
    tree_silhouette_change *change = NULL;
    float points[2 * MOST];
    size_t n = ring(points, 0, 5, 3, 0.1f, 5), n_undo = 0, n_redo = 0;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "", tree_silhouette_session_draw_crown(silhouette, points, n, &control, &change));
    OK(tree_silhouette_session_depth(silhouette, &n_undo, &n_redo));
    CHECK(n_undo == 2 && change == NULL);
    OK(tree_cancel_free(cancel));

    /* Limits. */
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&control, sizeof control));
    limits.nodes = 100;
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_silhouette_session_draw_crown(silhouette, points, n, &control, &change));
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_silhouette_session_tree(silhouette, &control, NULL, &tree));

    /* Strokes of no use: the session stays as it was. */
    static const float spot[] = {1, 1, 1, 1, 1, 1}, nowhere[] = {NAN, 1, INFINITY, 3, 2, NAN};
    FAILS(TREE_ERROR_INVALID, "crown", tree_silhouette_session_draw_crown(silhouette, spot, 3, NULL, &change));
    FAILS(TREE_ERROR_INVALID, "trunk", tree_silhouette_session_draw_trunk(silhouette, nowhere, 3, NULL, &change));
    FAILS(TREE_ERROR_INVALID, "leaf", tree_silhouette_session_draw_leaf(silhouette, NULL, 0, NULL, &change));
    FAILS(TREE_ERROR_NULL, "stroke", tree_silhouette_session_draw_leaf(silhouette, NULL, 3, NULL, &change));
    FAILS(TREE_ERROR_PARAMETER, "azimuth",
          tree_silhouette_session_draw_section(silhouette, 7, points, n, NULL, &change));
    OK(tree_silhouette_session_depth(silhouette, &n_undo, &n_redo));
    CHECK(n_undo == 2 && n_redo == 0 && change == NULL);

    /* Parameters out of range are named, in parts too. */
    tree_silhouette_params params = *small();
    tree_silhouette_grow_params grow = *params.grow;
    tree_silhouette_level levels[2];
    for (int i = 0; i < 2; i++) OK(tree_silhouette_level_init(levels + i, sizeof *levels));
    levels[1].density = -1;
    grow.levels = levels;
    grow.n_levels = 2;
    params.grow = &grow;
    FAILS(TREE_ERROR_PARAMETER, "levels[1].density", tree_silhouette_params_check(&params));
    tree_silhouette_session *none = NULL;
    FAILS(TREE_ERROR_PARAMETER, "levels[1].density", tree_silhouette_session_new(&params, 1, &none));
    CHECK(none == NULL);
    levels[1].density = 1;
    levels[1].arrangement.kind = 99;
    FAILS(TREE_ERROR_ENUM, "params.grow.levels[1].arrangement", tree_silhouette_params_check(&params));
    grow.n_levels = 65;
    FAILS(TREE_ERROR_LIMIT, "params.grow.levels", tree_silhouette_params_check(&params));
    grow.n_levels = 0;
    tree_silhouette_leaves leaves = *grow.leaves;
    leaves.length = 0;
    grow.leaves = &leaves;
    FAILS(TREE_ERROR_PARAMETER, "leaves.length", tree_silhouette_params_check(&params));

    /* Stale handles. */
    OK(tree_silhouette_session_free(silhouette));
    FAILS(TREE_ERROR_HANDLE, "silhouette", tree_silhouette_session_depth(silhouette, &n_undo, &n_redo));
    FAILS(TREE_ERROR_HANDLE, "silhouette", tree_silhouette_session_free(silhouette));
    OK(tree_silhouette_session_free(NULL));
    OK(tree_silhouette_change_free(NULL));
    OK(tree_outline_plan_free(NULL));
}

static const char svg[] =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 120'>"
    "<g id='L0' fill='none' stroke='black'><path id='trunk' d='M50 110 L50 40'/>"
    "<path id='crown' d='M50 8 L62 22 L74 20 L78 34 L90 44 L82 56 L86 72 L70 76 L60 84 L50 80 L40 84 L30 76 "
    "L14 72 L18 56 L10 44 L22 34 L26 20 L38 22 Z'/></g>"
    "<g id='L2' fill='none' stroke='black'><path d='M1 1 L3 1 L3 3 L1 3 Z'/></g>"
    "<g id='leaf' fill='none' stroke='black'><path d='M95 110 L97 106 L95 102 L93 106 Z'/></g></svg>";

static void test_drawing(void) {
    tree_outline_drawing *drawing = NULL;
    tree_silhouette_session *silhouette = NULL;
    tree_silhouette_play_report report = {.struct_size = sizeof report};
    OK(tree_outline_drawing_from_svg(svg, sizeof svg - 1, NULL, &drawing));
    OK(tree_silhouette_session_of_drawing(drawing, 0, small(), 5, NULL, &report, &silhouette));
    /* Level 2 has no branch yet that bears any. */
    CHECK(report.n_strokes == 3 && report.n_refused == 1);
    tree_lines *lines = NULL;
    const tree_str *texts = NULL;
    size_t n_texts = 0, n_undo = 9, n_redo = 9;
    OK(tree_silhouette_session_refused(silhouette, &lines));
    OK(tree_lines_view(lines, &texts, &n_texts));
    CHECK(n_texts == 1 && texts[0].len > 2 && memcmp(texts[0].data, "L2", 2) == 0);
    OK(tree_lines_free(lines));
    OK(tree_silhouette_session_repairs(silhouette, &lines));
    OK(tree_lines_view(lines, &texts, &n_texts));
    CHECK(n_texts == report.n_repairs);
    OK(tree_lines_free(lines));
    OK(tree_silhouette_session_depth(silhouette, &n_undo, &n_redo));
    CHECK(n_undo == 0 && n_redo == 0);

    /* 102 units are the 10 metres of the parameters. */
    tree_outline_plan *plan = plan_of(silhouette);
    tree_outline_system trunk = {.struct_size = sizeof trunk};
    float highest = 0, length = 0;
    tree_leaf_outline *leaf = NULL;
    OK(tree_outline_plan_system(plan, TREE_NO_BRANCH, &trunk));
    for (size_t i = 0; i < trunk.n_outline_points; i++)
        highest = fmaxf(highest, trunk.outline_points[2 * i + 1]);
    CHECK(fabsf(highest - 10) < 0.01f && fabsf(trunk.axis_points[1]) < 1e-4f);
    OK(tree_outline_plan_leaf(plan, &length, &leaf));
    CHECK(fabsf(length - 80.0f / 102) < 0.01f);
    OK(tree_leaf_outline_free(leaf));
    OK(tree_outline_plan_free(plan));
    CHECK(sum_of_silhouette(silhouette, NULL) != 0);
    OK(tree_silhouette_session_free(silhouette));
    FAILS(TREE_ERROR_INVALID, "tree", tree_silhouette_session_of_drawing(drawing, 1, NULL, 5, NULL, NULL, &silhouette));
    CHECK(silhouette == NULL);
    OK(tree_outline_drawing_free(drawing));
}

#define A_CROWN "l12 14 l12 -2 l4 14 l12 10 l-8 12 l4 16 l-16 4 l-10 8 l-10 -4 l-10 4 l-10 -8 l-16 -4 l4 -16 " \
    "l-8 -12 l12 -10 l4 -14 l12 2 Z"

/* Two trees and a dot: the first has an outline of a branch and a leaf. */
static const char two_trees[] =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 260 120'><g fill='none' stroke='black'>"
    "<g id='tree1'><g id='L0'><path d='M50 110 L50 40'/><path d='M50 8 " A_CROWN "'/></g>"
    "<g id='L1'><path d='M51 60 L70 30 L88 34 L92 50 L84 66 Z'/></g>"
    "<g id='leaf'><path d='M95 110 L97 106 L95 102 L93 106 Z'/></g></g>"
    "<g id='tree2'><g id='L0'><path d='M170 110 L170 40'/><path d='M170 28 " A_CROWN "'/></g></g>"
    "</g></svg>";

static void test_stand(void) {
    tree_outline_drawing *drawing = NULL;
    tree_stand *stand = NULL;
    tree_stand_params params;
    tree_stand_whole whole = {.struct_size = sizeof whole};
    OK(tree_outline_drawing_from_svg(two_trees, sizeof two_trees - 1, NULL, &drawing));
    OK(tree_stand_params_init(&params, sizeof params));
    CHECK(params.fov == 0.9f && params.scaling == 3 && params.perspective == TREE_PERSPECTIVE_ESTIMATED);
    params.silhouette = small();
    params.perspective = TREE_PERSPECTIVE_FLAT;
    OK(tree_stand_params_check(&params));
    OK(tree_stand_of_drawing(drawing, &params, 5, NULL, &stand));
    OK(tree_stand_view(stand, &whole));
    CHECK(whole.n_trees == 2 && whole.has_view == 0 && whole.n_elements > 200);

    /* The second borrows of the first. */
    tree_stand_tree rows[2] = {{.struct_size = sizeof *rows}, {.struct_size = sizeof *rows}};
    uint64_t n_elements = 0;
    for (size_t i = 0; i < 2; i++) {
        tree_silhouette_grown grown = {.struct_size = sizeof grown};
        tree_tree *tree = NULL, *same = NULL;
        OK(tree_stand_at(stand, i, &rows[i]));
        CHECK(rows[i].number == i && rows[i].name.len > 0 && rows[i].scale > 0);
        OK(tree_stand_grown(stand, i, &grown, &tree));
        n_elements += grown.n_elements;
        tree_silhouette_session *silhouette = NULL;
        tree_silhouette_play_report report = {.struct_size = sizeof report};
        OK(tree_stand_silhouette(stand, i, &report, &silhouette));
        CHECK(report.n_strokes == (i ? 2u : 4u) && report.n_refused == 0);
        OK(tree_silhouette_session_tree(silhouette, NULL, NULL, &same));
        CHECK(sum_of(same) == sum_of(tree));
        OK(tree_tree_free(same));
        OK(tree_tree_free(tree));
        tree_outline_plan *plan = plan_of(silhouette);
        tree_outline_plan_columns columns = columns_of(plan);
        CHECK((columns.n_branches > columns.n_own) == (i == 1));
        OK(tree_outline_plan_free(plan));
        OK(tree_silhouette_session_free(silhouette));
    }
    CHECK(n_elements == whole.n_elements && rows[1].position[0] > rows[0].position[0]);
    CHECK(rows[0].lender == TREE_NO_TREE && rows[0].borrowed_scale == 1 && rows[1].lender == 0);
    FAILS(TREE_ERROR_PARAMETER, "index is 2", tree_stand_at(stand, 2, rows));
    tree_lines *lines = NULL;
    const tree_str *texts = NULL;
    size_t n_texts = 99;
    OK(tree_stand_notes(stand, &lines));
    OK(tree_lines_view(lines, &texts, &n_texts));
    CHECK(n_texts == 0);
    OK(tree_lines_free(lines));
    OK(tree_stand_free(stand));

    /* Nobody lends; then a horizon, given. */
    static const uint32_t nobody[] = {1, TREE_NO_TREE}, none[] = {1, 7};
    params.lendings = nobody;
    params.n_lendings = 1;
    OK(tree_stand_of_drawing(drawing, &params, 5, NULL, &stand));
    OK(tree_stand_at(stand, 1, rows + 1));
    CHECK(rows[1].lender == TREE_NO_TREE);
    OK(tree_stand_free(stand));
    params.lendings = none;
    FAILS(TREE_ERROR_PARAMETER, "lenders", tree_stand_of_drawing(drawing, &params, 5, NULL, &stand));
    params.n_lendings = 0;
    params.perspective = TREE_PERSPECTIVE_HORIZON;
    params.horizon = 60;
    OK(tree_stand_of_drawing(drawing, &params, 5, NULL, &stand));
    OK(tree_stand_view(stand, &whole));
    CHECK(whole.has_view == 1 && whole.focal > 0 && whole.center[1] == 60 && whole.eye[1] > 0);
    OK(tree_stand_free(stand));
    params.horizon = 500;
    FAILS(TREE_ERROR_INVALID, "horizon", tree_stand_of_drawing(drawing, &params, 5, NULL, &stand));
    params.perspective = 3;
    FAILS(TREE_ERROR_ENUM, "params.perspective", tree_stand_params_check(&params));
    params.perspective = 0;
    params.fov = 9;
    FAILS(TREE_ERROR_PARAMETER, "stand.fov", tree_stand_params_check(&params));
    CHECK(stand == NULL);
    OK(tree_outline_drawing_free(drawing));
}

void test_silhouette(void) {
    test_first_strokes();
    test_levels();
    test_redrawn();
    test_tree();
    test_drawing();
    test_stand();
    test_what_goes_wrong();
}
