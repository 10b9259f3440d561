#include "check.h"
#include <math.h>

static const tree_pose origin = {{0, 0, 0}, {0, 0, 0, 1}};

/* A young tree that grew alone in the open. */
static tree_plastic *a_model(tree_plastic_report *report) {
    tree_growth_params params;
    tree_grown *grown;
    tree_tree *tree;
    tree_plastic *plastic;
    OK(tree_growth_preset("oak", TREE_NUL_TERMINATED, &params, sizeof params));
    params.iterations = 9;
    OK(tree_growth_grow(&params, 1, NULL, &grown));
    OK(tree_grown_tree(grown, &tree));
    OK(tree_grown_free(grown));
    OK(tree_plastic_new(tree, NULL, NULL, report, &plastic));
    OK(tree_tree_free(tree));
    return plastic;
}

static void box_of(tree_tree *tree, float box[6], size_t *n_nodes) {
    tree_skeleton *skeleton;
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    float bounds[6];
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_bounds(skeleton, &bounds));
    OK(tree_skeleton_view(skeleton, &columns));
    memcpy(box, bounds, sizeof bounds);
    *n_nodes = columns.n_nodes;
    OK(tree_skeleton_free(skeleton));
}

static void analysis(const tree_plastic *plastic, const tree_plastic_report *made) {
    tree_plastic_report report = {.struct_size = sizeof report};
    OK(tree_plastic_measure(plastic, &report));
    CHECK(memcmp(&report, made, sizeof report) == 0);
    CHECK(report.n_seasons > 2 && report.internode > 0 && report.n_clusters > 1);
    CHECK(!report.already_bent && report.lean < 0.26f);
    tree_plastic_columns columns = {.struct_size = sizeof columns};
    OK(tree_plastic_view(plastic, &columns));
    CHECK(columns.n_nodes == report.n_main_nodes + report.n_branchlet_nodes);
    size_t n_main = 0, n_can_die = 0;
    uint32_t last = 0;
    for (size_t i = 0; i < columns.n_nodes; i++) {
        const float *way = columns.own_directions + 3 * i;
        n_main += columns.is_main[i];
        n_can_die += columns.pruning_factors[i] >= 0;
        if (columns.seasons[i] > last) last = columns.seasons[i];
        CHECK(way[0] * way[0] + way[1] * way[1] + way[2] * way[2] > 0.98f);
    }
    CHECK(n_main == report.n_main_nodes && last + 1 == report.n_seasons && columns.seasons[0] == 0);
    CHECK(n_can_die > 0 && n_can_die < n_main);

    tree_plastic_clusters *clusters;
    const tree_plastic_cluster *rows;
    size_t n_rows;
    OK(tree_plastic_clusters_of_season(plastic, report.n_seasons - 1, &clusters));
    OK(tree_plastic_clusters_view(clusters, &rows, &n_rows));
    CHECK(n_rows == report.n_clusters && rows[0].n_tips > 0 && rows[0].radius > 0);
    CHECK(rows[0].light > 0 && rows[0].light <= 1 && rows[0].translucency < 1);
    OK(tree_plastic_clusters_free(clusters));
    FAILS(TREE_ERROR_PARAMETER, "season",
          tree_plastic_clusters_of_season(plastic, report.n_seasons, &clusters));
    CHECK(clusters == NULL);

    tree_plastic_params params = {.struct_size = sizeof params};
    OK(tree_plastic_get_params(plastic, &params));
    CHECK(params.seasons == 40 && params.lobe == 0.2f && params.sky_light[1] == 1);
    params.phototropism = params.gravitropism = 0.5f;
    FAILS(TREE_ERROR_PARAMETER, "phototropism", tree_plastic_params_check(&params));
    OK(tree_plastic_params_init(&params, sizeof params));
    OK(tree_plastic_params_check(&params));
    tree_tree *tree, *bent;
    tree_plastic *other;
    OK(tree_plastic_tree(plastic, &tree));
    params.sky_light[1] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "sky.light", tree_plastic_new(tree, &params, NULL, NULL, &other));
    OK(tree_tree_free(tree));

    /* What leans all one way was bent before. */
    static const float positions[] = {0, 0, 0, 0.5f, 0.5f, 0, 1.5f, 1, 0, 1.5f, 0.8f, 0.4f};
    static const float radii[] = {0.1f, 0.08f, 0.04f, 0.04f};
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 1, 1};
    tree_skeleton_columns leaning = {sizeof leaning, 4, positions, radii, parents};
    tree_skeleton *skeleton;
    OK(tree_skeleton_from_columns(&leaning, NULL, &skeleton));
    OK(tree_tree_new(skeleton, NULL, NULL, NULL, &bent));
    OK(tree_plastic_new(bent, NULL, NULL, &report, &other));
    CHECK(report.already_bent && report.lean > 0.26f);
    OK(tree_plastic_free(other));
    OK(tree_tree_free(bent));

    uint16_t seasons[4];
    float rates[4];
    size_t n_seasons;
    OK(tree_skeleton_ages(skeleton, 0.5f, 40, seasons, rates, 4, &n_seasons));
    CHECK(n_seasons > 1 && seasons[0] == 0 && seasons[2] > seasons[1] && rates[1] >= 1);
    FAILS(TREE_ERROR_BUFFER, "seasons", tree_skeleton_ages(skeleton, 0, 40, seasons, rates, 3, &n_seasons));
    FAILS(TREE_ERROR_PARAMETER, "most", tree_skeleton_ages(skeleton, 0, 0, seasons, rates, 4, &n_seasons));
    FAILS(TREE_ERROR_PARAMETER, "internode",
          tree_skeleton_ages(skeleton, -1, 9, seasons, rates, 4, &n_seasons));
    OK(tree_skeleton_free(skeleton));
}

static tree_tree *today(const tree_plastic_scene *scene, uint64_t id, tree_adapted_report *report) {
    tree_adapted *adapted;
    tree_tree *tree;
    OK(tree_plastic_scene_adapted(scene, id, NULL, report, &adapted));
    OK(tree_adapted_tree(adapted, &tree));
    OK(tree_adapted_free(adapted));
    return tree;
}

/* Alone in the open it is what it was; a wall bends and prunes it; taken away, the wall leaves no trace. */
static void wall(const tree_plastic *plastic) {
    tree_plastic_scene *scene, *copy;
    OK(tree_plastic_scene_new(NULL, NULL, &scene));
    uint64_t id = 99, wall = 99;
    OK(tree_plastic_scene_add_tree(scene, plastic, &origin, &id));
    tree_plastic_update update = {.struct_size = sizeof update};
    OK(tree_plastic_scene_update(scene, NULL, &update));
    CHECK(update.n_touched == 1 && update.n_seasons > 2);
    tree_tree *tree;
    tree_adapted_report report = {.struct_size = sizeof report};
    float box[6], open_box[6];
    size_t n_nodes, n_open;
    tree = today(scene, id, &report);
    CHECK(report.farthest == 0 && report.n_pruned == 0 && report.n_branchlets_dropped == 0);
    box_of(tree, open_box, &n_open);
    OK(tree_tree_free(tree));

    const float low[] = {0, -1, -20}, high[] = {1, 20, 20};
    tree_volume *volume;
    OK(tree_volume_box(low, high, &volume));
    float side = 0.4f * open_box[3];
    CHECK(side > 0.05f);
    tree_pose pose = origin;
    pose.position[0] = side;
    OK(tree_plastic_scene_add_obstacle(scene, volume, &pose, &wall));
    OK(tree_plastic_scene_copy(scene, &copy));
    OK(tree_plastic_scene_update(scene, NULL, &update));
    CHECK(update.n_changed == 1 && update.n_touched == 1);
    const uint64_t *ids;
    size_t n_ids;
    OK(tree_plastic_scene_changed(scene, &ids, &n_ids));
    CHECK(n_ids == 1 && ids[0] == id);
    tree = today(scene, id, &report);
    CHECK(report.farthest > 0 && report.n_pruned > 0 && report.n_leaves_dropped > 0);
    box_of(tree, box, &n_nodes);
    CHECK(box[3] <= side + 1e-4f && n_nodes < n_open);
    OK(tree_tree_free(tree));
    /* The copy was made before, when nothing had changed the tree. */
    OK(tree_plastic_scene_changed(copy, &ids, &n_ids));
    CHECK(n_ids == 0);

    tree_adapted *adapted;
    tree_adapted_columns columns = {.struct_size = sizeof columns};
    OK(tree_plastic_scene_adapted(scene, id, NULL, NULL, &adapted));
    OK(tree_adapted_view(adapted, &columns));
    CHECK(columns.n_nodes == n_nodes && columns.n_input_nodes == n_open && columns.source[0] == 0);
    CHECK(columns.moved[0] == 0 && columns.died[0] == TREE_PLASTIC_ALIVE);
    float farthest = 0;
    size_t n_dead = 0;
    for (size_t i = 0; i < columns.n_input_nodes; i++) {
        int lives = columns.died[i] == TREE_PLASTIC_ALIVE;
        n_dead += !lives;
        if (lives && columns.moved[i] > farthest) farthest = columns.moved[i];
    }
    CHECK(n_dead > 0 && farthest > 0);
    OK(tree_adapted_free(adapted));

    /* Less light from that side. */
    tree_plastic_clusters *clusters;
    const tree_plastic_cluster *rows;
    size_t n_rows;
    OK(tree_plastic_scene_clusters(scene, id, &clusters));
    OK(tree_plastic_clusters_view(clusters, &rows, &n_rows));
    CHECK(n_rows > 0 && rows[0].towards[0] < 0 && rows[0].n_tips == 0);
    OK(tree_plastic_clusters_free(clusters));

    /* Away with it, by moving and by removing. */
    pose.position[0] = 5000;
    OK(tree_plastic_scene_move_obstacle(scene, wall, &pose));
    OK(tree_plastic_scene_remove_obstacle(copy, wall));
    tree_plastic_scene *both[] = {scene, copy};
    for (int i = 0; i < 2; i++) {
        OK(tree_plastic_scene_update(both[i], NULL, NULL));
        tree = today(both[i], id, &report);
        box_of(tree, box, &n_nodes);
        CHECK(n_nodes == n_open && memcmp(box, open_box, sizeof box) == 0 && report.farthest == 0);
        OK(tree_tree_free(tree));
    }
    OK(tree_plastic_scene_obstacles(copy, &ids, &n_ids));
    CHECK(n_ids == 0);
    OK(tree_plastic_scene_obstacles(scene, &ids, &n_ids));
    CHECK(n_ids == 1 && ids[0] == wall);
    FAILS(TREE_ERROR_INVALID, "obstacle", tree_plastic_scene_remove_obstacle(copy, wall));
    pose.position[0] = 0;
    FAILS(TREE_ERROR_INVALID, "base", tree_plastic_scene_move_obstacle(scene, wall, &origin));
    OK(tree_volume_free(volume));
    OK(tree_plastic_scene_free(copy));
    OK(tree_plastic_scene_free(scene));
}

static int32_t refuses(void *user, const char *stage, float fraction) {
    (void)user, (void)stage;
    return fraction > 0.3f;
}

/* Neighbours, poses, the sky and the response. */
static void neighbours(tree_plastic *plastic) {
    tree_plastic_sky sky;
    OK(tree_plastic_sky_init(&sky, sizeof sky));
    CHECK(sky.light[1] == 1 && sky.brightness == 1);
    OK(tree_plastic_sky_towards(&sky, sizeof sky, 1.5707964f, 0.7f));
    CHECK(sky.light[0] > 0.7f && fabsf(sky.light[2]) < 1e-4f);
    FAILS(TREE_ERROR_PARAMETER, "sky.light", tree_plastic_sky_towards(&sky, sizeof sky, 0, -0.5f));
    CHECK(sky.light[0] > 0.7f);
    tree_plastic_response response;
    OK(tree_plastic_response_init(&response, sizeof response));
    CHECK(response.bending == 1 && response.pruning == 0.8f && response.density == 1);
    tree_plastic_scene *scene;
    OK(tree_plastic_scene_new(&sky, &response, &scene));
    uint64_t one, two;
    tree_pose pose = {{1.2f, 0, 0}, {0, 1, 0, 0}}, found;
    OK(tree_plastic_scene_add_tree(scene, plastic, NULL, &one));
    OK(tree_plastic_scene_add_tree(scene, plastic, &pose, &two));
    const uint64_t *ids;
    size_t n_ids;
    OK(tree_plastic_scene_trees(scene, &ids, &n_ids));
    CHECK(n_ids == 2 && ids[0] == one && ids[1] == two && one != two);
    OK(tree_plastic_scene_pose(scene, two, &found));
    CHECK(memcmp(&found, &pose, sizeof pose) == 0);
    tree_plastic *model;
    OK(tree_plastic_scene_model(scene, two, &model));
    tree_plastic_report report = {.struct_size = sizeof report};
    OK(tree_plastic_measure(model, &report));
    CHECK(report.n_seasons > 2);
    OK(tree_plastic_free(model));

    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.progress = refuses;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_plastic_scene_update(scene, &control, NULL));
    tree_plastic_update update = {.struct_size = sizeof update};
    OK(tree_plastic_scene_update(scene, NULL, &update));
    CHECK(update.n_touched == 2 && update.n_changed == 2);
    OK(tree_plastic_scene_update(scene, NULL, &update));
    CHECK(update.n_touched == 0 && update.n_changed == 0);

    /* They give each other less than each has far away. */
    tree_adapted_report near = {.struct_size = sizeof near}, far = near;
    OK(tree_tree_free(today(scene, one, &near)));
    pose.position[0] = 500;
    OK(tree_plastic_scene_move_tree(scene, two, &pose));
    OK(tree_plastic_scene_update(scene, NULL, &update));
    CHECK(update.n_changed == 2);
    OK(tree_tree_free(today(scene, one, &far)));
    CHECK(near.n_leaves_dropped > far.n_leaves_dropped);

    OK(tree_plastic_scene_get_sky(scene, &sky));
    CHECK(sky.light[0] > 0.7f);
    sky.brightness = 11;
    FAILS(TREE_ERROR_PARAMETER, "sky.brightness", tree_plastic_scene_set_sky(scene, &sky));
    OK(tree_plastic_sky_init(&sky, sizeof sky));
    OK(tree_plastic_scene_set_sky(scene, &sky));
    OK(tree_plastic_scene_update(scene, NULL, NULL));
    OK(tree_tree_free(today(scene, one, &far)));
    CHECK(far.farthest == 0 && far.n_leaves_dropped == 0);

    /* A wall that nobody minds. */
    const float point[] = {0.5f, 0, 0}, normal[] = {1, 0, 0};
    tree_volume *half;
    uint64_t wall;
    OK(tree_volume_half_space(point, normal, &half));
    response.bending = response.pruning = response.density = 0;
    OK(tree_plastic_scene_set_response(scene, &response));
    tree_plastic_response back = {.struct_size = sizeof back};
    OK(tree_plastic_scene_get_response(scene, &back));
    CHECK(back.bending == 0 && back.density == 0);
    response.bending = 2;
    FAILS(TREE_ERROR_PARAMETER, "response.bending", tree_plastic_scene_set_response(scene, &response));
    OK(tree_plastic_scene_remove_tree(scene, two));
    OK(tree_plastic_scene_trees(scene, &ids, &n_ids));
    CHECK(n_ids == 1 && ids[0] == one);
    FAILS(TREE_ERROR_INVALID, "base", tree_plastic_scene_add_obstacle(scene, half, &origin, &wall));
    pose.position[0] = 30;
    OK(tree_plastic_scene_add_obstacle(scene, half, &pose, &wall));
    OK(tree_plastic_scene_update(scene, NULL, NULL));
    OK(tree_tree_free(today(scene, one, &far)));
    CHECK(far.farthest == 0 && far.n_leaves_dropped == 0);
    OK(tree_volume_free(half));

    FAILS(TREE_ERROR_INVALID, "not in the scene", tree_plastic_scene_pose(scene, two, &found));
    FAILS(TREE_ERROR_INVALID, "not in the scene", tree_plastic_scene_model(scene, two, &model));
    FAILS(TREE_ERROR_INVALID, "not in the scene", tree_plastic_scene_move_tree(scene, two, &origin));
    FAILS(TREE_ERROR_INVALID, "not in the scene", tree_plastic_scene_remove_tree(scene, two));
    tree_adapted *adapted;
    FAILS(TREE_ERROR_INVALID, "not in the scene",
          tree_plastic_scene_adapted(scene, two, NULL, NULL, &adapted));
    tree_plastic_clusters *clusters;
    FAILS(TREE_ERROR_INVALID, "not in the scene", tree_plastic_scene_clusters(scene, two, &clusters));
    pose.rotation[1] = 0;
    FAILS(TREE_ERROR_INVALID, "rotation", tree_plastic_scene_move_tree(scene, one, &pose));
    FAILS(TREE_ERROR_NULL, "id", tree_plastic_scene_add_tree(scene, plastic, NULL, NULL));
    OK(tree_plastic_scene_trees(scene, &ids, &n_ids));
    CHECK(n_ids == 1);
    OK(tree_plastic_scene_free(scene));
}

/* Volumes without an end, closed meshes, combinations. */
static void obstacles(void) {
    tree_plastic_scene *scene;
    OK(tree_plastic_scene_new(NULL, NULL, &scene));
    const float a[] = {0, 0, 0}, b[] = {0, 3, 0};
    static const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const uint32_t faces[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    tree_volume *volumes[4], *whole;
    OK(tree_volume_capsule(a, b, 0.2f, &volumes[0]));
    OK(tree_volume_closed_mesh(corners, 4, faces, 4, NULL, &volumes[1]));
    OK(tree_volume_sphere(b, 1, &volumes[2]));
    OK(tree_volume_half_space(a, b, &volumes[3]));
    OK(tree_volume_union((const tree_volume *const *)volumes, 4, &whole));
    uint64_t id, last = 0;
    for (int i = 0; i < 4; i++) {
        OK(tree_plastic_scene_add_obstacle(scene, volumes[i], NULL, &id));
        CHECK(i == 0 || id > last);
        last = id;
    }
    OK(tree_plastic_scene_add_obstacle(scene, whole, NULL, &id));
    OK(tree_volume_free(whole));
    OK(tree_volume_difference(volumes[3], volumes[2], &whole));
    FAILS(TREE_ERROR_INVALID, "no end", tree_plastic_scene_add_obstacle(scene, whole, NULL, &id));
    OK(tree_volume_free(whole));
    for (int i = 0; i < 4; i++) OK(tree_volume_free(volumes[i]));
    const uint64_t *ids;
    size_t n_ids;
    OK(tree_plastic_scene_obstacles(scene, &ids, &n_ids));
    CHECK(n_ids == 5);
    OK(tree_plastic_scene_update(scene, NULL, NULL));
    OK(tree_plastic_scene_free(scene));
}

/* Skins follow the nodes; new branches grow where old ones died. */
static void motions_and_regrowth(const tree_plastic *plastic) {
    tree_tree *tree, *grown = NULL;
    tree_skeleton *skeleton;
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_plastic_tree(plastic, &tree));
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_view(skeleton, &columns));
    size_t n = columns.n_nodes;
    tree_plastic_motion *motions = malloc(n * sizeof *motions);
    tree_plastic_scene *scene;
    uint64_t id, wall;
    OK(tree_plastic_scene_new(NULL, NULL, &scene));
    OK(tree_plastic_scene_add_tree(scene, plastic, &origin, &id));
    OK(tree_plastic_scene_update(scene, NULL, NULL));
    OK(tree_plastic_scene_motions(scene, id, motions, n));
    for (size_t i = 0; i < n; i++) {
        CHECK(motions[i].moved[0] == 0 && motions[i].rotation[3] == 1 && motions[i].alive == 1);
    }
    tree_plastic_regrown report = {.struct_size = sizeof report};
    OK(tree_plastic_scene_regrown(scene, id, NULL, 1, NULL, &report, &grown));
    CHECK(report.n_stumps == 0 && report.n_branches == 0 && report.n_adapted == n);
    OK(tree_tree_free(grown));

    const float low[] = {0, -1, -20}, high[] = {1, 20, 20};
    tree_volume *volume;
    OK(tree_volume_box(low, high, &volume));
    tree_pose pose = origin;
    float right = 0;
    for (size_t i = 0; i < n; i++) right = fmaxf(right, columns.positions[3 * i]);
    pose.position[0] = 0.4f * right;
    OK(tree_plastic_scene_add_obstacle(scene, volume, &pose, &wall));
    OK(tree_plastic_scene_update(scene, NULL, NULL));
    OK(tree_plastic_scene_motions(scene, id, motions, n));
    size_t n_dead = 0, n_moved = 0;
    for (size_t i = 0; i < n; i++) {
        n_dead += !motions[i].alive;
        n_moved += motions[i].moved[0] < -0.01f;
    }
    CHECK(n_dead > 0 && n_moved > 0);
    FAILS(TREE_ERROR_BUFFER, "motions", tree_plastic_scene_motions(scene, id, motions, n - 1));
    FAILS(TREE_ERROR_INVALID, "not in the scene", tree_plastic_scene_motions(scene, 99, motions, n));
    tree_plastic_regrowth params;
    OK(tree_plastic_regrowth_init(&params, sizeof params));
    CHECK(params.years == 6 && params.light == 0.4f && params.most == 64 && params.bare == 0);
    OK(tree_plastic_regrowth_of(plastic, &params, sizeof params));
    params.light = 0.05f;
    OK(tree_plastic_scene_regrown(scene, id, &params, 1, NULL, &report, &grown));
    CHECK(report.n_stumps > 0 && report.n_adapted < n);
    OK(tree_tree_free(grown));
    params.light = 2;
    FAILS(TREE_ERROR_PARAMETER, "regrowth.light",
          tree_plastic_scene_regrown(scene, id, &params, 1, NULL, NULL, &grown));
    CHECK(grown == NULL);
    OK(tree_volume_free(volume));
    OK(tree_plastic_scene_free(scene));
    OK(tree_skeleton_free(skeleton));
    OK(tree_tree_free(tree));
    free(motions);
}

void test_plastic(void) {
    tree_plastic_report report = {.struct_size = sizeof report};
    tree_plastic *plastic = a_model(&report);
    analysis(plastic, &report);
    wall(plastic);
    neighbours(plastic);
    obstacles();
    motions_and_regrowth(plastic);
    OK(tree_plastic_free(plastic));
}
