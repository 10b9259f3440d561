/* Wrong on purpose: a view is read after its object's end. The tools must say so. */
#include "tree.h"
#include <stdio.h>

int main(void) {
    static const float positions[30], radii[10];
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 1, 2, 3, 4, 5, 6, 7, 8};
    tree_skeleton_columns columns = {sizeof columns, 10, positions, radii, parents};
    tree_skeleton *skeleton = 0;
    if (tree_skeleton_from_columns(&columns, 0, &skeleton) != TREE_OK) return 1;
    tree_skeleton_columns view = {.struct_size = sizeof view};
    if (tree_skeleton_view(skeleton, &view) != TREE_OK) return 1;
    if (tree_skeleton_free(skeleton) != TREE_OK) return 1;
    printf("%g\n", (double)view.positions[4]);
    return 0;
}
