/* A small tree of which every function of levels is tried. */
#ifndef MULTIRES_H
#define MULTIRES_H

#include "check.h"

enum { TRUNK = 4, NODES = 1 + 3 * TRUNK, LEAVES = 4 * TRUNK, LEVELS = 2 * TRUNK, SURFACES = 2 };

/* A trunk of TRUNK metres with a branch to either side at each metre, two leaves a branch. Free it with
   tree_tree_free. */
tree_tree *a_tree_with_levels(void);

#endif
