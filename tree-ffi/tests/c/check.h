/* The smallest test harness that says where and why. */
#ifndef CHECK_H
#define CHECK_H

#include "tree.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Counts and prints; a test goes on after a failure where it can. */
extern int n_failures;

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            printf("%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition);                   \
            n_failures++;                                                                          \
        }                                                                                          \
    } while (0)

/* The call succeeds. */
#define OK(call)                                                                                   \
    do {                                                                                           \
        tree_status status_ = (call);                                                              \
        if (status_ != TREE_OK) {                                                                  \
            printf("%s:%d: %s\n    %s: %s\n", __FILE__, __LINE__, #call,                           \
                   tree_status_name(status_), tree_error_text());                                  \
            n_failures++;                                                                          \
        }                                                                                          \
    } while (0)

/* The call fails with this code, and says why in a text that has `part` in it. */
#define FAILS(code, part, call)                                                                    \
    do {                                                                                           \
        tree_error_clear();                                                                        \
        tree_status status_ = (call);                                                              \
        if (status_ != (code) || tree_error_status() != (code) ||                                  \
            !strstr(tree_error_text(), part)) {                                                    \
            printf("%s:%d: %s\n    should be %s with '%s', is %s: %s\n", __FILE__, __LINE__,       \
                   #call, tree_status_name(code), part, tree_status_name(status_),                 \
                   tree_error_text());                                                             \
            n_failures++;                                                                          \
        }                                                                                          \
    } while (0)

/* A fork: trunk, and two branches of unlike length. Free it with tree_skeleton_free. */
tree_skeleton *a_fork(void);
/* The fork with three leaves, as an oak. Free it with tree_tree_free. */
tree_tree *an_oak_twig(void);

void test_border(void);
void test_skeleton(void);
void test_foliage(void);
void test_volume(void);
void test_path(void);
void test_skeletonize(void);
void test_scan(void);
void test_distance(void);
void test_growth(void);
void test_plastic(void);
void test_particle(void);
void test_look(void);
void test_mesh(void);
void test_instance(void);
void test_engine(void);
void test_io(void);
void test_sketch(void);
void test_preview(void);
void test_photo(void);
void test_sketch_in(void);
void test_silhouette(void);
void test_silhouette_in(void);
void test_lod(void);
void test_lod_select(void);
void test_prune(void);
void test_multires_chain(void);
void test_multires(void);
void test_lsystem(void);
void test_impostor(void);
void test_octahedral(void);
void test_hybrid(void);
void test_threads(void);

#endif
