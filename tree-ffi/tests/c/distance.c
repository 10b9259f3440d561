#include "check.h"
#include <math.h>

static tree_edit_distance zeroed(void) {
    tree_edit_distance distance = {.struct_size = sizeof distance};
    return distance;
}

/* The fork, and the fork without its thin, longer branch. */
static tree_skeleton *a_whip(void) {
    static const float positions[] = {0, 0, 0, 0, 1, 0, -0.5f, 2, 0};
    static const float radii[] = {0.1f, 0.08f, 0.01f};
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 1};
    tree_skeleton_columns columns = {sizeof columns, 3, positions, radii, parents};
    tree_skeleton *skeleton = NULL;
    OK(tree_skeleton_from_columns(&columns, NULL, &skeleton));
    return skeleton;
}

static void of_skeletons(void) {
    tree_skeleton *fork = a_fork(), *whip = a_whip();
    tree_edit_params params;
    OK(tree_edit_params_init(&params, sizeof params));
    CHECK(params.weight == TREE_EDIT_WEIGHT_RADIUS && params.reduction == TREE_EDIT_REDUCTION_RUNS);

    tree_edit_distance same = zeroed(), there = zeroed(), back = zeroed();
    OK(tree_skeleton_distance(fork, fork, NULL, NULL, &same));
    CHECK(same.value == 0 && same.normalized == 0 && same.n_nodes[0] == 3);
    OK(tree_skeleton_distance(fork, whip, &params, NULL, &there));
    OK(tree_skeleton_distance(whip, fork, &params, NULL, &back));
    CHECK(there.value > 0 && there.value == back.value);
    CHECK(there.n_nodes[0] == 3 && there.n_nodes[1] == 1);
    CHECK(there.weights[0] == back.weights[1] && there.weights[1] == back.weights[0]);
    double sum = there.weights[0] + there.weights[1] + there.value;
    CHECK(fabs(there.normalized - 2 * there.value / sum) < 1e-12);

    /* Every node for itself, by structure: one node too many, and three that stay. */
    params.weight = TREE_EDIT_WEIGHT_UNIT;
    params.reduction = TREE_EDIT_REDUCTION_NONE;
    tree_edit_pairs *pairs = NULL;
    OK(tree_skeleton_distance_pairs(fork, whip, &params, NULL, &there, &pairs));
    CHECK(there.value == 1 && there.n_nodes[0] == 4 && there.n_nodes[1] == 3);
    const tree_edit_pair *rows;
    size_t n_pairs;
    OK(tree_edit_pairs_view(pairs, &rows, &n_pairs));
    CHECK(n_pairs == 3 && rows[0].first == 0 && rows[0].second == 0 && rows[1].first == 1);
    CHECK(n_pairs == 3 && rows[1].second == 1 && rows[2].first >= 2 && rows[2].second == 2);
    OK(tree_edit_pairs_free(pairs));
    OK(tree_skeleton_distance_pairs(fork, whip, NULL, NULL, NULL, &pairs));
    OK(tree_edit_pairs_free(pairs));

    /* The trunk goes on in one branch: two axes against one. */
    params.reduction = TREE_EDIT_REDUCTION_AXES;
    OK(tree_skeleton_distance(fork, whip, &params, NULL, &there));
    CHECK(there.value == 1 && there.n_nodes[0] == 2 && there.n_nodes[1] == 1);
    params.weight = TREE_EDIT_WEIGHT_RADIUS_TIMES_LENGTH;
    OK(tree_skeleton_distance(fork, whip, &params, NULL, &there));
    double bark = there.value;
    params.weight = TREE_EDIT_WEIGHT_RADIUS_SQUARED_TIMES_LENGTH;
    OK(tree_skeleton_distance(fork, whip, &params, NULL, &there));
    CHECK(there.value > 0 && there.value < bark);

    params.weight = 4;
    FAILS(TREE_ERROR_ENUM, "params.weight", tree_skeleton_distance(fork, whip, &params, NULL, &there));
    params.weight = 0;
    params.reduction = 3;
    FAILS(TREE_ERROR_ENUM, "params.reduction",
          tree_skeleton_distance_pairs(fork, whip, &params, NULL, NULL, &pairs));
    CHECK(pairs == NULL);
    FAILS(TREE_ERROR_NULL, "distance", tree_skeleton_distance(fork, whip, NULL, NULL, NULL));
    FAILS(TREE_ERROR_NULL, "second", tree_skeleton_distance(fork, NULL, NULL, NULL, &there));
    tree_limits limits;
    tree_control control;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    limits.pairs = 2;
    FAILS(TREE_ERROR_LIMIT, "pairs",
          tree_skeleton_distance_pairs(fork, whip, NULL, &control, NULL, &pairs));
    OK(tree_skeleton_free(fork));
    OK(tree_skeleton_free(whip));
}

/* Deleting is dear, inserting cheap, changing free. */
static int n_asked;
static double cost(void *user, uint32_t first, uint32_t second) {
    n_asked++;
    if (second == TREE_NO_PARENT) return *(double *)user;
    return first == TREE_NO_PARENT ? 0.5 : 0;
}

static void of_trees(void) {
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 0, 0};
    static const double weights[] = {1, 2, 3, 4};
    tree_edit_columns columns = {.struct_size = sizeof columns};
    columns.n_nodes = 4;
    columns.parents = parents;
    columns.weights = weights;
    tree_edit_tree *star, *lesser, *of_fork;
    OK(tree_edit_tree_from_columns(&columns, NULL, &star));
    columns.n_nodes = 3;
    OK(tree_edit_tree_from_columns(&columns, NULL, &lesser));

    tree_edit_distance distance = zeroed();
    /* 2 is deleted, 3 and 4 become 2 and 3, or 4 is deleted: 2 + 1 + 1, or 4. */
    OK(tree_edit_tree_distance(star, lesser, NULL, NULL, &distance));
    CHECK(distance.value == 4 && distance.weights[0] == 10 && distance.weights[1] == 6);

    tree_edit_costs costs;
    OK(tree_edit_costs_init(&costs, sizeof costs));
    double dear = 7;
    costs.cost = cost;
    costs.user = &dear;
    tree_edit_pairs *pairs;
    OK(tree_edit_tree_distance_pairs(star, lesser, &costs, NULL, &distance, &pairs));
    CHECK(distance.value == 7 && n_asked > 0);
    const tree_edit_pair *rows;
    size_t n_pairs;
    OK(tree_edit_pairs_view(pairs, &rows, &n_pairs));
    CHECK(n_pairs == 3 && rows[0].first == 0 && rows[0].second == 0);
    OK(tree_edit_pairs_free(pairs));
    OK(tree_edit_tree_distance(lesser, star, &costs, NULL, &distance));
    CHECK(distance.value == 0.5);
    dear = NAN;
    FAILS(TREE_ERROR_PARAMETER, "deleting node",
          tree_edit_tree_distance(star, lesser, &costs, NULL, &distance));
    dear = -1;
    FAILS(TREE_ERROR_PARAMETER, "deleting node",
          tree_edit_tree_distance_pairs(star, lesser, &costs, NULL, NULL, &pairs));
    OK(tree_edit_tree_free(star));
    OK(tree_edit_tree_free(lesser));

    tree_skeleton *fork = a_fork();
    OK(tree_edit_tree_of_skeleton(fork, NULL, &of_fork));
    OK(tree_skeleton_free(fork));
    OK(tree_edit_tree_view(of_fork, &columns));
    CHECK(columns.n_nodes == 3 && columns.parents[0] == TREE_NO_PARENT && columns.parents[2] == 0);
    CHECK(columns.nodes[0] == 1 && columns.nodes[1] == 2 && columns.nodes[2] == 3);
    CHECK(columns.weights[0] > columns.weights[1] && columns.weights[1] > 0);
    OK(tree_edit_tree_free(of_fork));

    static const uint32_t two_roots[] = {TREE_NO_PARENT, TREE_NO_PARENT};
    static const double light[] = {1, -1};
    columns = (tree_edit_columns){sizeof columns, 2, two_roots, weights, NULL};
    FAILS(TREE_ERROR_INVALID, "root", tree_edit_tree_from_columns(&columns, NULL, &of_fork));
    columns.parents = parents;
    columns.weights = light;
    FAILS(TREE_ERROR_PARAMETER, "weights", tree_edit_tree_from_columns(&columns, NULL, &of_fork));
    columns.n_nodes = SIZE_MAX;
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_edit_tree_from_columns(&columns, NULL, &of_fork));
}

void test_distance(void) {
    of_skeletons();
    of_trees();
}
