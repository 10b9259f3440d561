/* Grows a tree in the open, then moves a wall at it, step by step, and says what the tree makes of it.
 *
 *     wall [PRESET [YEARS]]
 *
 * See README.md for how to build it. */
#include <stdio.h>
#include <stdlib.h>
#include <tree.h>

/* Ends the program when a call failed. */
static void check(tree_status status) {
    if (status == TREE_OK) return;
    fprintf(stderr, "%s: %s\n", tree_status_name(status), tree_error_text());
    exit(1);
}

/* A tree of one of the growing presets, which stands alone. */
static tree_tree *grow(const char *preset, uint32_t years) {
    tree_growth_params params;
    check(tree_growth_preset(preset, TREE_NUL_TERMINATED, &params, sizeof params));
    params.iterations = years;
    tree_grown *grown = NULL;
    check(tree_growth_grow(&params, 1, NULL, &grown));
    tree_tree *tree = NULL;
    check(tree_grown_tree(grown, &tree));
    check(tree_grown_free(grown));
    return tree;
}

/* How far the crown reaches towards +X, in metres. */
static float reach(const tree_tree *tree) {
    tree_skeleton *skeleton = NULL;
    float box[6];
    check(tree_tree_skeleton(tree, &skeleton));
    check(tree_skeleton_bounds(skeleton, &box));
    check(tree_skeleton_free(skeleton));
    return box[3];
}

int main(int n, char **arguments) {
    const char *preset = n > 1 ? arguments[1] : "oak";
    uint32_t years = n > 2 ? (uint32_t)strtoul(arguments[2], NULL, 10) : 12;
    if (tree_abi_version() != TREE_ABI_VERSION) {
        fprintf(stderr, "the library is another version than tree.h\n");
        return 1;
    }
    tree_tree *tree = grow(preset, years);
    float open = reach(tree);

    /* Read once; any number of trees of it can be planted. */
    tree_plastic_report read = {.struct_size = sizeof read};
    tree_plastic *plastic = NULL;
    check(tree_plastic_new(tree, NULL, NULL, &read, &plastic));
    check(tree_tree_free(tree));
    printf("%s: %u seasons, %llu main nodes, %llu leaf clusters, reaches %.2f m\n", preset, read.n_seasons,
           (unsigned long long)read.n_main_nodes, (unsigned long long)read.n_clusters, open);
    if (read.already_bent) printf("it leans by %.2f rad already, and will keep that\n", read.lean);

    tree_plastic_scene *scene = NULL;
    uint64_t id, wall;
    check(tree_plastic_scene_new(NULL, NULL, &scene));
    check(tree_plastic_scene_add_tree(scene, plastic, NULL, &id));
    check(tree_plastic_free(plastic));

    /* Half a metre thick, its near side at its own origin. */
    const float low[] = {0, -1, -25}, high[] = {0.5f, 25, 25};
    tree_volume *volume = NULL;
    check(tree_volume_box(low, high, &volume));
    tree_pose pose = {{3 * open, 0, 0}, {0, 0, 0, 1}};
    check(tree_plastic_scene_add_obstacle(scene, volume, &pose, &wall));
    check(tree_volume_free(volume));

    printf("   wall   reach  farthest  pruned  leaves\n");
    for (int step = 0; step <= 6; step++) {
        pose.position[0] = open * (1.5f - 0.2f * (float)step);
        check(tree_plastic_scene_move_obstacle(scene, wall, &pose));
        check(tree_plastic_scene_update(scene, NULL, NULL));

        tree_adapted_report report = {.struct_size = sizeof report};
        tree_adapted *adapted = NULL;
        check(tree_plastic_scene_adapted(scene, id, NULL, &report, &adapted));
        tree_tree *today = NULL;
        check(tree_adapted_tree(adapted, &today));
        check(tree_adapted_free(adapted));
        printf("%5.2f m %5.2f m %7.3f m %7llu %+7lld\n", pose.position[0], reach(today), report.farthest,
               (unsigned long long)report.n_pruned,
               (long long)report.n_leaves_added - (long long)report.n_leaves_dropped);
        check(tree_tree_free(today));
    }

    /* Taken away, it leaves no trace. */
    check(tree_plastic_scene_remove_obstacle(scene, wall));
    check(tree_plastic_scene_update(scene, NULL, NULL));
    tree_adapted_report report = {.struct_size = sizeof report};
    tree_adapted *adapted = NULL;
    check(tree_plastic_scene_adapted(scene, id, NULL, &report, &adapted));
    check(tree_adapted_free(adapted));
    printf("without: moved %.3f m, %llu pruned\n", report.farthest, (unsigned long long)report.n_pruned);
    check(tree_plastic_scene_free(scene));
    tree_error_clear();
    return 0;
}
