/* Wrong on purpose: a skeleton is never freed. The tools must say so. */
#include "tree.h"

int main(void) {
    static const float positions[3], radii[1];
    static const uint32_t parents[] = {TREE_NO_PARENT};
    tree_skeleton_columns columns = {sizeof columns, 1, positions, radii, parents};
    tree_skeleton *skeleton = 0;
    if (tree_skeleton_from_columns(&columns, 0, &skeleton) != TREE_OK) return 1;
    skeleton = 0;
    return skeleton != 0;
}
