#include "check.h"

void test_skeleton(void) {
    tree_skeleton *fork = a_fork();
    tree_skeleton_columns view = {.struct_size = sizeof view};
    OK(tree_skeleton_view(fork, &view));
    CHECK(view.n_nodes == 4);
    CHECK(view.parents[0] == TREE_NO_PARENT && view.parents[3] == 1);
    CHECK(view.positions[3 * 3 + 1] == 2.0f);

    float box[6];
    OK(tree_skeleton_bounds(fork, &box));
    CHECK(box[1] == 0.0f && box[4] == 2.5f);

    /* The same nodes from the tips down. */
    float positions[12], radii[4];
    uint32_t parents[4], rows[4];
    for (int i = 0; i < 4; i++) {
        memcpy(positions + 3 * i, view.positions + 3 * (3 - i), 3 * sizeof(float));
        radii[i] = view.radii[3 - i];
        parents[i] = view.parents[3 - i] == TREE_NO_PARENT ? TREE_NO_PARENT : 3 - view.parents[3 - i];
    }
    tree_skeleton_columns columns = {sizeof columns, 4, positions, radii, parents};
    tree_skeleton *turned = NULL;
    OK(tree_skeleton_from_unordered(&columns, NULL, rows, &turned));
    CHECK(rows[0] == 3 && rows[1] == 2);
    OK(tree_skeleton_free(turned));

    FAILS(TREE_ERROR_INVALID, "root", tree_skeleton_from_columns(&columns, NULL, &turned));
    CHECK(turned == NULL);
    columns.n_nodes = (size_t)1 << 60;
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_skeleton_from_columns(&columns, NULL, &turned));
    columns.struct_size = 3;
    FAILS(TREE_ERROR_STRUCT_SIZE, "sizeof", tree_skeleton_from_columns(&columns, NULL, &turned));

    OK(tree_skeleton_free(fork));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_skeleton_free(fork));
    OK(tree_skeleton_free(NULL));
}
