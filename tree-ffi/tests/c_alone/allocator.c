/* A host that brings its allocator sees every block, with its size and alignment, and gets all back. */
#include "../c/check.h"
#include <pthread.h>
#include <stdatomic.h>

int n_failures = 0;

static atomic_size_t n_blocks, n_bytes, n_calls;

/* What stands in front of each block. */
typedef struct header {
    size_t size, align;
    void *whole;
} header;

static void *give(void *user, size_t size, size_t align) {
    CHECK(user == &n_blocks && size > 0 && align && (align & (align - 1)) == 0);
    char *whole = malloc(size + align + sizeof(header));
    if (!whole) return NULL;
    uintptr_t at = (uintptr_t)whole + sizeof(header);
    size_t skip = (align - at % align) % align;
    char *block = whole + sizeof(header) + skip;
    header mine = {size, align, whole};
    memcpy(block - sizeof mine, &mine, sizeof mine);
    n_blocks++;
    n_calls++;
    n_bytes += size;
    return block;
}

static void take(void *user, void *block, size_t size, size_t align) {
    CHECK(user == &n_blocks && block);
    header mine;
    memcpy(&mine, (char *)block - sizeof mine, sizeof mine);
    CHECK(mine.size == size && mine.align == align);
    n_blocks--;
    n_bytes -= size;
    free(mine.whole);
}

int main(void) {
    tree_allocator allocator = {sizeof allocator, &n_blocks, give, take};
    CHECK(tree_memory_used() == 0);
    OK(tree_memory_set_allocator(&allocator));

    tree_pool_options two = {sizeof two, 2, 0, 0, NULL, NULL};
    tree_pool *pool = NULL;
    OK(tree_pool_new(&two, &pool));
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.pool = pool;
    static const float positions[] = {0, 0, 0, 0, 1, 0, 0, 2, 0};
    static const float radii[] = {0.1f, 0.08f, 0.01f};
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 1};
    tree_skeleton_columns columns = {sizeof columns, 3, positions, radii, parents};
    size_t n_kept = 0;
    for (int round = 0; round < 3; round++) {
        tree_skeleton *skeleton = NULL;
        tree_tree *tree = NULL;
        tree_look *look = NULL;
        tree_mesh *mesh = NULL;
        OK(tree_skeleton_from_columns(&columns, NULL, &skeleton));
        OK(tree_tree_new(skeleton, NULL, NULL, NULL, &tree));
        OK(tree_look_plain(NULL, &look));
        OK(tree_mesh_build(tree, look, NULL, &control, NULL, &mesh));
        CHECK(n_calls > 0 && n_bytes > 0 && tree_memory_used() > 0);
        OK(tree_mesh_free(mesh));
        OK(tree_look_free(look));
        OK(tree_tree_free(tree));
        OK(tree_skeleton_free(skeleton));
        FAILS(TREE_ERROR_HANDLE, "freed", tree_skeleton_free(skeleton));
        tree_error_clear();
        /* From the second round on nothing is kept that was not kept before; the pool's threads may be
         * just taking or giving back a block of their own. */
        if (round == 1) n_kept = n_blocks;
        if (round == 2) CHECK(n_blocks <= n_kept + 16);
    }
    FAILS(TREE_ERROR_ORDER, "once", tree_memory_set_allocator(&allocator));
    OK(tree_pool_free(pool));
    tree_error_clear();
    /* What stays: a few blocks that the Rust standard library keeps for each process. */
    printf("%zu blocks with %zu bytes stay of %zu\n", (size_t)n_blocks, (size_t)n_bytes,
           (size_t)n_calls);
    CHECK(n_bytes == tree_memory_used() && n_blocks < 64 && tree_live_objects() == 0);
    printf(n_failures ? "%d failures\n" : "all is well\n", n_failures);
    return n_failures != 0;
}
