/* Pools, cancellation, progress, memory, and the same bytes from any number of threads. */
#include "check.h"
#include <pthread.h>

/* A tree small enough for a test, and large enough that threads share the work. */
static tree_status a_small_oak(uint64_t seed, const tree_control *control, tree_tree **tree) {
    static tree_path_params params;
    static tree_path_level level;
    static pthread_mutex_t once = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&once);
    if (!params.struct_size) {
        OK(tree_path_preset("oak", TREE_NUL_TERMINATED, &params, sizeof params));
        CHECK(params.n_levels > 0);
        level = params.levels[0];
        level.graph_nodes = 40;
        params.levels = &level;
        params.n_levels = 1;
        params.graph_nodes = 300;
        params.endpoints_random = 20;
    }
    pthread_mutex_unlock(&once);
    return tree_path_grow(&params, seed, control, NULL, tree);
}

static uint64_t fnv1a(uint64_t hash, const void *data, size_t n_bytes) {
    const unsigned char *bytes = data;
    for (size_t i = 0; i < n_bytes; i++) hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

/* A hash of all that comes of a seed, from skeleton to mesh; 0 after an error. */
static uint64_t hash_of(uint64_t seed, const tree_control *control) {
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    tree_tree *tree = NULL;
    tree_look *look = NULL;
    tree_mesh *mesh = NULL;
    if (a_small_oak(seed, control, &tree)) return 0;
    OK(tree_look_of_tree(tree, 1, &look));
    if (tree_mesh_build(tree, look, NULL, control, NULL, &mesh)) {
        OK(tree_look_free(look));
        OK(tree_tree_free(tree));
        return 0;
    }
    size_t n = 0;
    OK(tree_mesh_surface_count(mesh, &n));
    for (size_t i = 0; i < n; i++) {
        tree_surface view = {.struct_size = sizeof view};
        OK(tree_mesh_surface(mesh, i, &view));
        hash = fnv1a(hash, view.positions, view.n_vertices * 3 * sizeof(float));
        hash = fnv1a(hash, view.indices, view.n_indices * sizeof(uint32_t));
    }
    OK(tree_mesh_free(mesh));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
    return hash;
}

static void pools_do_not_change_results(void) {
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    uint64_t expected = hash_of(3, NULL);
    CHECK(expected != 0 && expected != hash_of(4, NULL));
    for (uint32_t n = 1; n <= 4; n += 3) {
        tree_pool_options options;
        OK(tree_pool_options_init(&options, sizeof options));
        CHECK(options.n_threads == 0 && options.spawn == NULL);
        options.n_threads = n;
        options.stack_size = 4 << 20;
        tree_pool *pool = NULL;
        OK(tree_pool_new(&options, &pool));
        uint32_t has = 0;
        OK(tree_pool_threads(pool, &has));
        CHECK(has == n);
        control.pool = pool;
        CHECK(hash_of(3, &control) == expected);
        OK(tree_pool_free(pool));
        FAILS(TREE_ERROR_HANDLE, "freed", tree_pool_free(pool));
    }
    tree_pool *pool = NULL;
    OK(tree_pool_new(NULL, &pool));
    uint32_t has = 0;
    OK(tree_pool_threads(pool, &has));
    CHECK(has >= 1);
    OK(tree_pool_free(pool));
    tree_pool_options many = {sizeof many, 1025, 0, 0, NULL, NULL};
    FAILS(TREE_ERROR_PARAMETER, "n_threads", tree_pool_new(&many, &pool));
    CHECK(pool == NULL);
}

/* A host that owns its threads. */
typedef struct host {
    pthread_t threads[8];
    int n_threads;
    int n_most;
} host;

typedef struct job {
    tree_worker_fn run;
    void *worker;
} job;

static void *do_job(void *job_) {
    job mine = *(job *)job_;
    free(job_);
    mine.run(mine.worker);
    return NULL;
}

static int32_t spawn(void *user, tree_worker_fn run, void *worker) {
    host *us = user;
    if (us->n_threads == us->n_most) return 1;
    job *one = malloc(sizeof *one);
    *one = (job){run, worker};
    if (pthread_create(&us->threads[us->n_threads], NULL, do_job, one)) {
        free(one);
        return 1;
    }
    us->n_threads++;
    return 0;
}

static void hosts_bring_their_threads(void) {
    host us = {.n_most = 3};
    tree_pool_options options = {sizeof options, 3, 0, 0, spawn, &us};
    tree_pool *pool = NULL;
    OK(tree_pool_new(&options, &pool));
    CHECK(us.n_threads == 3);
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.pool = pool;
    CHECK(hash_of(3, &control) == hash_of(3, NULL));
    OK(tree_pool_free(pool));
    /* The workers have returned: nothing of the library runs on the host's threads. */
    for (int i = 0; i < us.n_threads; i++) pthread_join(us.threads[i], NULL);

    /* A host that has too few: those that it gave come back. */
    host poor = {.n_most = 1};
    options.user = &poor;
    FAILS(TREE_ERROR_NO_RESULT, "no thread", tree_pool_new(&options, &pool));
    CHECK(pool == NULL && poor.n_threads == 1);
    pthread_join(poor.threads[0], NULL);
}

typedef struct watcher {
    tree_pool *pool;
    tree_cancel *cancel;
    int n_told;
    int refuse_at;
    tree_status freed;
    float last;
} watcher;

static int32_t watch(void *user, const char *stage, float fraction) {
    watcher *us = user;
    CHECK(stage && *stage && fraction >= 0 && fraction <= 1);
    us->n_told++;
    us->last = fraction;
    if (us->pool) us->freed = tree_pool_free(us->pool);
    if (us->cancel) OK(tree_cancel_set(us->cancel));
    return us->refuse_at && us->n_told >= us->refuse_at;
}

static void progress_is_told(void) {
    watcher us = {.freed = TREE_OK};
    tree_pool_options one = {sizeof one, 1, 0, 0, NULL, NULL};
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.progress = watch;
    control.user = &us;
    OK(tree_pool_new(&one, &us.pool));
    control.pool = us.pool;
    CHECK(hash_of(3, &control) == hash_of(3, NULL));
    CHECK(us.n_told > 1 && us.last == 1.0f);
    /* A pool at work stays. */
    CHECK(us.freed == TREE_ERROR_ORDER);
    tree_pool *pool = us.pool;
    us.pool = NULL;

    us.refuse_at = us.n_told + 2;
    tree_tree *tree = NULL;
    FAILS(TREE_ERROR_CANCELLED, "", a_small_oak(3, &control, &tree));
    CHECK(tree == NULL);
    us.refuse_at = 0;
    CHECK(hash_of(3, &control) == hash_of(3, NULL));
    OK(tree_pool_free(pool));

    /* A switch that is set from within, and stays set. */
    control.pool = NULL;
    OK(tree_cancel_new(&us.cancel));
    control.cancel = us.cancel;
    FAILS(TREE_ERROR_CANCELLED, "", a_small_oak(3, &control, &tree));
    control.progress = NULL;
    FAILS(TREE_ERROR_CANCELLED, "", a_small_oak(3, &control, &tree));
    control.cancel = NULL;
    OK(tree_cancel_free(us.cancel));
}

static void *set_soon(void *cancel) {
    OK(tree_cancel_set(cancel));
    return NULL;
}

static int32_t begin_to_cancel(void *user, const char *stage, float fraction) {
    (void)stage, (void)fraction;
    void **both = user;
    if (!both[1]) {
        pthread_t *thread = both[1] = malloc(sizeof *thread);
        CHECK(pthread_create(thread, NULL, set_soon, both[0]) == 0);
        pthread_join(*thread, NULL);
    }
    return 0;
}

static void another_thread_cancels(void) {
    tree_cancel *cancel = NULL;
    OK(tree_cancel_new(&cancel));
    tree_pool_options one = {sizeof one, 1, 0, 0, NULL, NULL};
    tree_pool *pool = NULL;
    OK(tree_pool_new(&one, &pool));
    void *both[] = {cancel, NULL};
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    control.pool = pool;
    control.progress = begin_to_cancel;
    control.user = both;
    tree_tree *tree = NULL;
    FAILS(TREE_ERROR_CANCELLED, "", a_small_oak(3, &control, &tree));
    CHECK(tree == NULL && both[1] != NULL);
    free(both[1]);
    OK(tree_pool_free(pool));
    OK(tree_cancel_free(cancel));
}

typedef struct grower {
    uint64_t seed;
    uint64_t hashes[2];
    const tree_control *control;
} grower;

static void *grow_two(void *user) {
    grower *us = user;
    for (uint64_t i = 0; i < 2; i++) us->hashes[i] = hash_of(us->seed + i, us->control);
    tree_error_clear();
    return NULL;
}

static void threads_at_once_make_the_same(void) {
    tree_pool_options two = {sizeof two, 2, 0, 0, NULL, NULL};
    tree_pool *pool = NULL;
    OK(tree_pool_new(&two, &pool));
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.pool = pool;
    grower growers[4];
    pthread_t threads[4];
    for (uint64_t i = 0; i < 4; i++) {
        /* Half of them on one pool, half on the shared threads. */
        growers[i] = (grower){i % 2, {0, 0}, i < 2 ? &control : NULL};
        CHECK(pthread_create(&threads[i], NULL, grow_two, &growers[i]) == 0);
    }
    for (int i = 0; i < 4; i++) pthread_join(threads[i], NULL);
    for (uint64_t i = 0; i < 4; i++)
        for (uint64_t j = 0; j < 2; j++) CHECK(growers[i].hashes[j] == hash_of(i % 2 + j, NULL));
    OK(tree_pool_free(pool));
}

static void memory_has_a_budget(void) {
    /* An allocator comes first or never. */
    tree_allocator allocator = {.struct_size = sizeof allocator};
    FAILS(TREE_ERROR_NULL, "alloc", tree_memory_set_allocator(&allocator));

    tree_skeleton *fork = a_fork();
    CHECK(tree_memory_used() > 0 && tree_memory_budget() == 0);
    tree_memory_reset_peak();
    uint64_t before = tree_memory_used();
    CHECK(tree_memory_peak() >= before);
    CHECK(hash_of(5, NULL) != 0);
    uint64_t needed = tree_memory_peak() - before;
    CHECK(needed > 10000);

    uint64_t budget = tree_memory_used() + needed / 8;
    tree_memory_set_budget(budget);
    CHECK(tree_memory_budget() == budget);
    tree_memory_reset_peak();
    tree_error_clear();
    CHECK(hash_of(5, NULL) == 0);
    CHECK(tree_error_status() == TREE_ERROR_LIMIT || tree_error_status() == TREE_ERROR_MEMORY);
    /* Near the budget: work in progress is looked at often, not always. */
    CHECK(tree_memory_peak() < budget + needed / 2);
    /* Looking costs nothing. */
    tree_skeleton_columns view = {.struct_size = sizeof view};
    OK(tree_skeleton_view(fork, &view));
    tree_memory_set_budget(0);
    CHECK(tree_memory_budget() == 0 && hash_of(5, NULL) != 0);
    OK(tree_skeleton_free(fork));

    tree_limits limits, small;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_limits_for_memory(&small, sizeof small, 1 << 20));
    CHECK(small.nodes < limits.nodes && small.triangles < limits.triangles && small.nodes > 0);
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &small;
    small.graph_nodes = 10;
    tree_tree *tree = NULL;
    FAILS(TREE_ERROR_LIMIT, "", a_small_oak(3, &control, &tree));
}

static void *some_memory(void *user, size_t size, size_t align) {
    (void)user, (void)align;
    return malloc(size);
}

static void no_memory(void *user, void *block, size_t size, size_t align) {
    (void)user, (void)size, (void)align;
    free(block);
}

static void the_allocator_is_set_first(void) {
    tree_skeleton *fork = a_fork();
    tree_allocator allocator = {sizeof allocator, NULL, some_memory, no_memory};
    FAILS(TREE_ERROR_ORDER, "first", tree_memory_set_allocator(&allocator));
    OK(tree_skeleton_free(fork));
}

void test_threads(void) {
    the_allocator_is_set_first();
    pools_do_not_change_results();
    hosts_bring_their_threads();
    progress_is_told();
    another_thread_cancels();
    threads_at_once_make_the_same();
    memory_has_a_budget();
    tree_error_clear();
}
