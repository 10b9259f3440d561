#include "check.h"

static void looks(void) {
    tree_str kinds[] = {{"oak", TREE_NUL_TERMINATED}, {"no such", TREE_NUL_TERMINATED}};
    tree_species species = {.struct_size = sizeof species,
                            .bark = {"birch", 5},
                            .leaf_kinds = kinds,
                            .n_leaf_kinds = 2};
    tree_look *look = NULL;
    FAILS(TREE_ERROR_UNKNOWN_NAME, "no such", tree_look_built_in(&species, &look));
    CHECK(look == NULL);
    OK(tree_look_plain(&species, &look));
    OK(tree_look_check(look, &species));
    FAILS(TREE_ERROR_INVALID, "leaf", tree_look_check(look, NULL));
    OK(tree_look_free(look));
    species.n_leaf_kinds = 1;
    OK(tree_look_built_in(&species, &look));
    OK(tree_look_check(look, &species));
    OK(tree_look_free(look));

    tree_tree *twig = an_oak_twig();
    OK(tree_look_of_tree(twig, 1, &look));
    OK(tree_look_check(look, NULL));
    OK(tree_look_free(look));
    OK(tree_tree_free(twig));
}

void test_look(void) { looks(); }
