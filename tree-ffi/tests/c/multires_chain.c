/* Branches, paths and multi-chains: levels before there is a tree. */
#include "multires.h"
#include <math.h>

static int says(const tree_bytes *bytes, const char *expected) {
    const uint8_t *data = NULL;
    size_t len = 0;
    OK(tree_bytes_view(bytes, &data, &len));
    return len == strlen(expected) && memcmp(data, expected, len) == 0;
}

/* The branches of a chain that is written a letter a module. */
static tree_status adt_of(const char *text, tree_adt **adt) {
    static uint8_t kinds[64];
    static double lengths[64];
    tree_token_columns columns = {sizeof columns, strlen(text), kinds, lengths};
    for (size_t i = 0; i < columns.n_tokens; i++) {
        kinds[i] = text[i] == '[' ? TREE_TOKEN_PUSH : text[i] == ']' ? TREE_TOKEN_POP : TREE_TOKEN_MODULE;
        lengths[i] = text[i] == '?' ? NAN : text[i] == '!' ? -1 : 1;
    }
    return tree_adt_of_tokens(&columns, NULL, adt);
}

static void branches(void) {
    tree_adt *adt = NULL, *none = NULL;
    OK(adt_of("F[+F]F[-]", &adt));
    tree_adt_columns columns = {.struct_size = sizeof columns};
    OK(tree_adt_view(adt, &columns));
    CHECK(columns.n_branches == 3 && columns.parents[0] == TREE_NO_PARENT && columns.parents[2] == 0);
    CHECK(columns.lengths[0] == 2 && columns.lengths[1] == 2 && columns.lengths[2] == 1);
    CHECK(columns.areas[0] == 2 && columns.areas[1] == 2 && columns.areas[2] == 1);
    const uint32_t *row = NULL;
    size_t n = 0;
    OK(tree_adt_modules(adt, 0, &row, &n));
    CHECK(n == 2 && row[0] == 0 && row[1] == 5);
    OK(tree_adt_modules(adt, 1, &row, &n));
    CHECK(n == 2 && row[0] == 2 && row[1] == 3);
    OK(tree_adt_children(adt, 0, &row, &n));
    CHECK(n == 2 && row[0] == 1 && row[1] == 2);
    OK(tree_adt_children(adt, 2, &row, &n));
    CHECK(n == 0 && row == NULL);
    FAILS(TREE_ERROR_PARAMETER, "3 branches", tree_adt_modules(adt, 3, &row, &n));
    FAILS(TREE_ERROR_PARAMETER, "3 branches", tree_adt_children(adt, UINT32_MAX, &row, &n));
    FAILS(TREE_ERROR_NULL, "n_children", tree_adt_children(adt, 0, &row, NULL));
    OK(tree_adt_free(adt));

    FAILS(TREE_ERROR_INVALID, "module 1", adt_of("F]", &none));
    FAILS(TREE_ERROR_INVALID, "never closed", adt_of("[F", &none));
    FAILS(TREE_ERROR_INVALID, "module 1", adt_of("F?", &none));
    FAILS(TREE_ERROR_INVALID, "module 0", adt_of("!", &none));
    static const uint8_t bad[] = {0, 3};
    static const double lengths[2];
    tree_token_columns tokens = {sizeof tokens, 2, bad, lengths};
    FAILS(TREE_ERROR_ENUM, "columns.kinds[1]", tree_adt_of_tokens(&tokens, NULL, &none));
    tokens.lengths = NULL;
    FAILS(TREE_ERROR_NULL, "columns.lengths", tree_adt_of_tokens(&tokens, NULL, &none));
    FAILS(TREE_ERROR_NULL, "columns", tree_adt_of_tokens(NULL, NULL, &none));
    tree_limits limits;
    tree_control control;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&control, sizeof control));
    limits.modules = 1;
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "modules", tree_adt_of_tokens(&tokens, &control, &none));
    CHECK(none == NULL);
    OK(tree_adt_of_tokens(&(tree_token_columns){.struct_size = sizeof tokens}, NULL, &adt));
    OK(tree_adt_view(adt, &columns));
    CHECK(columns.n_branches == 1);
    OK(tree_adt_free(adt));
}

/* Chain (3) of the paper, with the multi-chain that was derived of it by hand. */
static const char paper[] = "1[2[3[4][5[6][7]]][9[b][a]][8]][c[d][e][f[g]]]";

static void chains(void) {
    enum { MODULES = sizeof paper - 1 };
    tree_adt *adt = NULL;
    tree_multi_paths *paths = NULL, *no_paths = NULL;
    tree_multi_chain *chain = NULL;
    tree_bytes *bytes = NULL;
    uint32_t ends[MODULES];
    for (uint32_t i = 0; i < MODULES; i++) ends[i] = i + 1;
    OK(adt_of(paper, &adt));
    tree_metric_params params;
    OK(tree_metric_params_init(&params, sizeof params));
    CHECK(params.metric == TREE_METRIC_DENSITY && params.worths == NULL && params.n_worths == 0);
    params.metric = TREE_METRIC_BRANCHING_LENGTH;
    OK(tree_multi_paths_new(adt, &params, 0, NULL, &paths));
    size_t n = 0, all = 0;
    const uint32_t *first = NULL, *row = NULL;
    OK(tree_multi_paths_count(paths, &n));
    OK(tree_multi_paths_branches(paths, &first, &all));
    OK(tree_multi_paths_path(paths, 0, &row, &n));
    CHECK(all == 16 && row == first && n == 5 && row[0] == 0);
    OK(tree_multi_paths_path(paths, 1, &row, &n));
    CHECK(row == first + 5 && n >= 1);
    OK(tree_multi_paths_count(paths, &n));
    CHECK(n == 9);
    FAILS(TREE_ERROR_PARAMETER, "9 paths", tree_multi_paths_path(paths, 9, &row, &n));

    OK(tree_multi_chain_new(paths, NULL, &chain));
    tree_multi_chain_columns items = {.struct_size = sizeof items};
    OK(tree_multi_chain_view(chain, &items));
    CHECK(items.n_levels == 9 && items.n_states == 6 && items.ends[8] == items.n_items);
    CHECK(items.kinds[0] == TREE_ITEM_MODULE && items.values[0] == 0);
    CHECK(items.kinds[1] == TREE_ITEM_SAVE && items.values[1] == 0);
    CHECK(items.kinds[items.ends[0]] == TREE_ITEM_RESTORE && items.values[items.ends[0]] == 1);
    OK(tree_multi_chain_to_text(chain, 2, paper, TREE_NUL_TERMINATED, ends, MODULES, NULL, &bytes));
    CHECK(says(bytes, "1SAVE(0)2SAVE(1)3SAVE(2)5SAVE(3)6RESTORE(1)9SAVE(4)b"));
    OK(tree_bytes_free(bytes));
    OK(tree_multi_chain_to_text(chain, SIZE_MAX, paper, MODULES, ends, MODULES, NULL, &bytes));
    CHECK(says(bytes, "1SAVE(0)2SAVE(1)3SAVE(2)5SAVE(3)6RESTORE(1)9SAVE(4)bRESTORE(0)cSAVE(5)fg"
                      "RESTORE(2)4RESTORE(3)7RESTORE(4)aRESTORE(5)dRESTORE(1)8RESTORE(5)e"));
    OK(tree_bytes_free(bytes));
    FAILS(TREE_ERROR_INVALID, "n_ends is 3",
          tree_multi_chain_to_text(chain, 9, paper, MODULES, ends, 3, NULL, &bytes));
    FAILS(TREE_ERROR_INVALID, "ends[45]",
          tree_multi_chain_to_text(chain, 9, paper, MODULES - 1, ends, MODULES, NULL, &bytes));
    ends[3] = 2;
    FAILS(TREE_ERROR_INVALID, "ends[3]",
          tree_multi_chain_to_text(chain, 9, paper, MODULES, ends, MODULES, NULL, &bytes));
    FAILS(TREE_ERROR_TEXT, "UTF-8",
          tree_multi_chain_to_text(chain, 9, "\xff", 1, ends, 1, NULL, &bytes));
    FAILS(TREE_ERROR_NULL, "text", tree_multi_chain_to_text(chain, 9, NULL, 0, ends, 1, NULL, &bytes));
    CHECK(bytes == NULL);
    OK(tree_multi_chain_free(chain));
    FAILS(TREE_ERROR_NULL, "paths", tree_multi_chain_new(NULL, NULL, &chain));

    /* Paths of a chain are not those of a skeleton. */
    tree_tree *tree = a_tree_with_levels();
    tree_multires *none = NULL;
    FAILS(TREE_ERROR_INVALID, "paths are not",
          tree_multires_of_paths(tree, paths, NULL, NULL, NULL, &none));
    CHECK(none == NULL);
    OK(tree_tree_free(tree));
    OK(tree_multi_paths_free(paths));

    for (tree_metric metric = TREE_METRIC_CHILDREN; metric <= TREE_METRIC_DENSITY; metric++) {
        params.metric = metric;
        OK(tree_multi_paths_new(adt, &params, 7, NULL, &paths));
        OK(tree_multi_paths_branches(paths, &first, &all));
        OK(tree_multi_paths_path(paths, 0, &row, &n));
        CHECK(all == 16 && first[0] == 0 && (metric != TREE_METRIC_GENERATION || n == 1));
        OK(tree_multi_paths_free(paths));
    }
    double worths[16] = {0};
    worths[15] = 5;
    params.metric = TREE_METRIC_BRANCHING;
    params.worths = worths;
    params.n_worths = 16;
    OK(tree_multi_paths_new(adt, &params, 0, NULL, &paths));
    OK(tree_multi_paths_path(paths, 0, &row, &n));
    CHECK(n == 4 && row[n - 1] == 15);
    OK(tree_multi_paths_free(paths));
    params.metric = TREE_METRIC_DENSITY_OF;
    OK(tree_multi_paths_new(adt, &params, 0, NULL, &paths));
    OK(tree_multi_paths_path(paths, 0, &row, &n));
    CHECK(n == 4 && row[n - 1] == 15);
    OK(tree_multi_paths_free(paths));
    params.n_worths = 15;
    FAILS(TREE_ERROR_INVALID, "worths", tree_multi_paths_new(adt, &params, 0, NULL, &no_paths));
    params.n_worths = 16;
    worths[2] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "worth", tree_multi_paths_new(adt, &params, 0, NULL, &no_paths));
    params.metric = TREE_METRIC_CHILDREN;
    FAILS(TREE_ERROR_PARAMETER, "n_worths", tree_multi_paths_new(adt, &params, 0, NULL, &no_paths));
    params.n_worths = 0;
    params.metric = TREE_METRIC_DENSITY_OF + 1;
    FAILS(TREE_ERROR_ENUM, "TREE_METRIC_", tree_multi_paths_new(adt, &params, 0, NULL, &no_paths));
    CHECK(no_paths == NULL);
    OK(tree_adt_free(adt));
}

void test_multires_chain(void) {
    branches();
    chains();
}
