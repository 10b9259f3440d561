/* A small tree whose leaves hang in balls, and what sees it. */
#ifndef CROWN_H
#define CROWN_H

#include "check.h"

enum { TIPS = 9, PER_TIP = 12, LEAVES = TIPS * PER_TIP, NODES = 5 + TIPS };

/* A trunk that forks three ways, and each of those again three ways. Free it with tree_skeleton_free. */
tree_skeleton *a_forked_tree(void);
/* Square leaves around its tips. Free them with tree_mesh_free. */
tree_mesh *leaves_at_tips(void);
/* The tree with as many leaves at its tips. Free it with tree_tree_free. */
tree_tree *a_leafy_tree(void);
/* A view of it of 32 by 32 pixels. */
tree_view from_the_side(uint32_t camera);
int n_covered(const tree_picture *picture);

#endif
