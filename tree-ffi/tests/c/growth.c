#include "check.h"
#include <math.h>

static void presets(void) {
    size_t n = tree_growth_preset_count();
    CHECK(n == 6);
    tree_str name;
    for (size_t i = 0; i < n; i++) {
        tree_growth_params params;
        OK(tree_growth_preset_name(i, &name));
        OK(tree_growth_preset(name.data, name.len, &params, sizeof params));
        OK(tree_growth_params_check(&params));
        CHECK(params.world && params.habit && params.habit->leaves && params.habit->species);
        CHECK(params.habit->species->name.len == name.len);
    }
    tree_growth_params params;
    FAILS(TREE_ERROR_PARAMETER, "6 presets", tree_growth_preset_name(n, &name));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "birch",
          tree_growth_preset("cactus", TREE_NUL_TERMINATED, &params, sizeof params));
}

static void alone(void) {
    tree_growth_params params;
    OK(tree_growth_preset("birch", TREE_NUL_TERMINATED, &params, sizeof params));
    params.iterations = 6;
    params.base[0] = 4;
    tree_grown *grown;
    OK(tree_growth_grow(&params, 1, NULL, &grown));
    tree_grown_columns columns = {.struct_size = sizeof columns};
    OK(tree_grown_view(grown, &columns));
    CHECK(columns.n_years == 6 && columns.n_nodes == columns.years[5].n_nodes);
    CHECK(columns.years[0].n_buds > 0 && columns.years[0].light > 0 && columns.years[5].n_shoots > 0);
    uint32_t oldest = 0, youngest = 99;
    for (size_t i = 0; i < columns.n_nodes; i++) {
        if (columns.ages[i] > oldest) oldest = columns.ages[i];
        if (columns.ages[i] < youngest) youngest = columns.ages[i];
    }
    CHECK(oldest == 6 && columns.ages[0] == 6 && youngest == 0 && columns.orders[0] == 0);
    tree_tree *tree;
    OK(tree_grown_tree(grown, &tree));
    size_t n_nodes = columns.n_nodes;
    OK(tree_grown_free(grown));
    /* It outlives what it was asked of. */
    tree_skeleton *skeleton;
    tree_skeleton_columns nodes = {.struct_size = sizeof nodes};
    tree_foliage leaves = {.struct_size = sizeof leaves};
    tree_species species = {.struct_size = sizeof species};
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_view(skeleton, &nodes));
    CHECK(nodes.n_nodes == n_nodes && nodes.positions[0] == 4 && nodes.radii[0] > 0);
    OK(tree_tree_foliage(tree, &leaves));
    OK(tree_tree_species(tree, &species));
    CHECK(leaves.n_leaves > 0 && species.name.len == 5 && memcmp(species.name.data, "birch", 5) == 0);
    OK(tree_skeleton_free(skeleton));
    OK(tree_tree_free(tree));

    /* A bare tree of another habit, that shares vigour by priorities. */
    tree_growth_habit habit = *params.habit;
    habit.leaves = NULL;
    habit.allocation = TREE_ALLOCATION_PRIORITY;
    habit.priority_first = habit.priority_fall = 1;
    habit.priority_last = 0.5f;
    params.habit = &habit;
    OK(tree_growth_grow(&params, 1, NULL, &grown));
    OK(tree_grown_view(grown, &columns));
    CHECK(columns.n_nodes != n_nodes);
    OK(tree_grown_tree(grown, &tree));
    OK(tree_tree_foliage(tree, &leaves));
    CHECK(leaves.n_leaves == 0);
    OK(tree_tree_free(tree));
    OK(tree_grown_free(grown));

    habit.allocation = 2;
    FAILS(TREE_ERROR_ENUM, "params.habit.allocation", tree_growth_params_check(&params));
    habit.allocation = 0;
    habit.buds = 9;
    FAILS(TREE_ERROR_ENUM, "params.habit.buds", tree_growth_params_check(&params));
    habit.buds = TREE_PHYLLOTAXIS_WHORLED;
    FAILS(TREE_ERROR_PARAMETER, "habit.buds", tree_growth_params_check(&params));
    habit.whorl = 4;
    habit.branches.gravi = -11;
    FAILS(TREE_ERROR_PARAMETER, "habit.branches.gravi", tree_growth_grow(&params, 1, NULL, &grown));
    CHECK(grown == NULL);
    OK(tree_growth_habit_init(&habit, sizeof habit));
    CHECK(habit.leaves && habit.species && habit.max_shoot == 6 && habit.trunk.photo == 0.25f);
    OK(tree_growth_params_init(&params, sizeof params));
    CHECK(params.iterations == 18 && !params.world && !params.habit);
    params.iterations = 10001;
    FAILS(TREE_ERROR_PARAMETER, "iterations", tree_growth_grow(&params, 1, NULL, &grown));
}

static size_t nodes_of(tree_grown *grown, float box[6]) {
    tree_tree *tree;
    tree_skeleton *skeleton;
    tree_skeleton_columns nodes = {.struct_size = sizeof nodes};
    float bounds[6];
    OK(tree_grown_tree(grown, &tree));
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_view(skeleton, &nodes));
    OK(tree_skeleton_bounds(skeleton, &bounds));
    memcpy(box, bounds, sizeof bounds);
    size_t n = nodes.n_nodes;
    OK(tree_skeleton_free(skeleton));
    OK(tree_tree_free(tree));
    return n;
}

/* By space, within a crown, beside a wall. */
static void surroundings(void) {
    const float middle[] = {0, 2, 0}, low[] = {0.3f, -1, -5}, high[] = {0.6f, 5, 5};
    tree_volume *crown, *wall;
    OK(tree_volume_sphere(middle, 1.8f, &crown));
    OK(tree_volume_box(low, high, &wall));
    tree_growth_world world;
    OK(tree_growth_world_init(&world, sizeof world));
    CHECK(world.environment == TREE_GROWTH_BY_LIGHT && world.shadow_depth == 7 && world.light[1] == 1);
    world.environment = TREE_GROWTH_BY_SPACE;
    world.crown = crown;
    tree_growth_params params;
    OK(tree_growth_params_init(&params, sizeof params));
    params.world = &world;
    tree_growth_habit habit;
    OK(tree_growth_habit_init(&habit, sizeof habit));
    habit.leaves = NULL;
    params.habit = &habit;
    params.iterations = 12;
    tree_grown *grown;
    float free_box[6], box[6];
    habit.angle = 1.1f;
    OK(tree_growth_grow(&params, 3, NULL, &grown));
    size_t n = nodes_of(grown, free_box);
    CHECK(n > 500 && free_box[3] > 1.2f && free_box[3] < 2.1f && free_box[4] < 4.1f);
    OK(tree_grown_free(grown));

    world.obstacle = wall;
    world.clearance = 0.05f;
    OK(tree_growth_grow(&params, 3, NULL, &grown));
    nodes_of(grown, box);
    CHECK(box[3] <= 0.25f);
    OK(tree_grown_free(grown));
    params.base[0] = 0.4f;
    FAILS(TREE_ERROR_NO_RESULT, "obstacle", tree_growth_grow(&params, 3, NULL, &grown));
    world.clearance = -1;
    FAILS(TREE_ERROR_PARAMETER, "clearance", tree_growth_grow(&params, 3, NULL, &grown));
    world.environment = 5;
    FAILS(TREE_ERROR_ENUM, "params.world.environment", tree_growth_params_check(&params));
    OK(tree_volume_free(crown));
    OK(tree_volume_free(wall));
}

static int32_t refuses(void *user, const char *stage, float fraction) {
    (void)user, (void)stage;
    return fraction >= 0.5f;
}

/* A call on an object that is at work. */
static tree_growth *at_work;
static int32_t meddles(void *user, const char *stage, float fraction) {
    (void)stage, (void)fraction;
    tree_growth_counts counts = {.struct_size = sizeof counts};
    *(tree_status *)user = tree_growth_measure(at_work, &counts);
    CHECK(tree_growth_free(at_work) == TREE_ERROR_ORDER);
    return 0;
}

static void together(void) {
    tree_growth_params poplar, birch;
    OK(tree_growth_preset("poplar", TREE_NUL_TERMINATED, &poplar, sizeof poplar));
    OK(tree_growth_preset("birch", TREE_NUL_TERMINATED, &birch, sizeof birch));
    tree_growth_plant plants[2];
    OK(tree_growth_plant_init(&plants[0], sizeof plants[0]));
    OK(tree_growth_plant_init(&plants[1], sizeof plants[1]));
    CHECK(plants[0].direction[1] == 1);
    plants[0].habit = poplar.habit;
    plants[1].habit = birch.habit;
    plants[1].base[0] = 1.5f;
    tree_growth *stand, *step_by_step, *copy;
    OK(tree_growth_stand(poplar.world, plants, 2, 5, 7, NULL, &stand));
    OK(tree_growth_new(poplar.world, plants, 2, 7, NULL, &step_by_step));
    tree_growth_counts counts = {.struct_size = sizeof counts}, whole = counts;
    OK(tree_growth_measure(step_by_step, &counts));
    CHECK(counts.n_plants == 2 && counts.n_nodes == 4 && counts.n_iterations == 0);
    const float points[] = {0.7f, 0.1f, 0, 0.7f, 50, 0};
    float before[2], after[2];
    OK(tree_growth_light(step_by_step, points, 2, NULL, before));
    OK(tree_growth_step(step_by_step, 2, NULL));
    OK(tree_growth_copy(step_by_step, &copy));
    OK(tree_growth_step(step_by_step, 3, NULL));
    OK(tree_growth_measure(step_by_step, &counts));
    OK(tree_growth_measure(stand, &whole));
    CHECK(counts.n_iterations == 5 && counts.n_nodes == whole.n_nodes && counts.n_nodes > 40);
    OK(tree_growth_light(step_by_step, points, 2, NULL, after));
    CHECK(before[1] == 1 && after[1] == 1 && after[0] < before[0] && after[0] >= 0);

    /* What they make together is what each hands out. */
    tree_grown *first, *second;
    float box[6];
    OK(tree_growth_grown(stand, 0, NULL, &first));
    OK(tree_growth_grown(stand, 1, NULL, &second));
    CHECK(nodes_of(first, box) + nodes_of(second, box) == counts.n_nodes);
    CHECK(box[0] <= 1.5f && box[3] >= 1.5f);
    OK(tree_grown_free(first));
    OK(tree_grown_free(second));
    FAILS(TREE_ERROR_PARAMETER, "index", tree_growth_grown(stand, 2, NULL, &first));
    CHECK(first == NULL);

    /* Nothing happens half. */
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.progress = refuses;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_growth_step(copy, 4, &control));
    OK(tree_growth_measure(copy, &counts));
    CHECK(counts.n_iterations == 2);
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.nodes = counts.n_nodes + 5;
    control.progress = NULL;
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_growth_step(copy, 4, &control));
    OK(tree_growth_step(copy, 3, NULL));
    OK(tree_growth_measure(copy, &counts));
    CHECK(counts.n_iterations == 5 && counts.n_nodes == whole.n_nodes);
    FAILS(TREE_ERROR_PARAMETER, "9995", tree_growth_step(copy, 9996, NULL));

    tree_status said = TREE_OK;
    control.limits = NULL;
    control.progress = meddles;
    control.user = &said;
    at_work = copy;
    OK(tree_growth_step(copy, 1, &control));
    CHECK(said == TREE_ERROR_ORDER);

    tree_growth *none;
    plants[1].direction[1] = 0;
    FAILS(TREE_ERROR_PARAMETER, "plants[1]", tree_growth_new(NULL, plants, 2, 1, NULL, &none));
    FAILS(TREE_ERROR_PARAMETER, "plants", tree_growth_new(NULL, NULL, 0, 1, NULL, &none));
    const float nowhere[] = {NAN, 0, 0};
    FAILS(TREE_ERROR_PARAMETER, "points[0]", tree_growth_light(stand, nowhere, 1, NULL, after));
    FAILS(TREE_ERROR_NULL, "light", tree_growth_light(stand, points, 1, NULL, NULL));
    OK(tree_growth_free(stand));
    OK(tree_growth_free(step_by_step));
    OK(tree_growth_free(copy));
}

void test_growth(void) {
    presets();
    alone();
    surroundings();
    together();
}
