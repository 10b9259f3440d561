
static void crashed(int signal) {
    printf("signal %d in %s(", signal, now);
    for (int i = 0; i < 8; i++) printf("%u ", moods_now[i]);
    printf(")\n");
    fflush(stdout);
    _exit(2);
}

static double seconds(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Seconds in all calls of each function. */
static double spent[sizeof attacks / sizeof *attacks];

static int patient;

static int try(const attack *attack) {
    now = attack->name;
    n_told = 0;
    tree_error_clear();
    /* A call that hangs is a failure of its own. */
    alarm(patient ? 300 : 20);
    double start = seconds();
    int status = attack->call(moods_now);
    double took = seconds() - start;
    n_calls++;
    spent[attack - attacks] += took;
    if (status == PASSED_FOR_WELL) complain("passed for well");
    if (status == TREE_ERROR_PANIC) complain("panicked");
    if (status > TREE_OK && !*tree_error_text()) complain("has no text");
    if (status > TREE_OK && !strcmp(tree_status_name(status), "unknown")) complain("no such status");
    tree_memory_set_budget(0);
    return status;
}

static uint32_t random_number(void) {
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(state >> 33);
}

static void all(unsigned mood) {
    for (int i = 0; i < MOST_ARGUMENTS; i++) moods_now[i] = mood;
}

/* Under valgrind, where a call takes fifty times as long, calls are a sample; without it the same program makes all of
 * them. Every function still gets each bad value of each argument that is no struct, with all others good. What can be
 * wrong with a struct is dealt out to the functions that take it: each of them gets some of it. */
static int few;
static unsigned n_taking[MOST_STRUCTS], turns[MOST_STRUCTS];

static void count_structs(void) {
    for (unsigned i = 0; i < sizeof attacks / sizeof *attacks; i++)
        for (unsigned k = 0; k < attacks[i].n_arguments; k++) n_taking[attacks[i].structs[k]]++;
}

static int is_left_out(const attack *attack, unsigned i, unsigned mood) {
    unsigned which = attack->structs[i];
    /* Without a control work is not kept short; the other programs under valgrind have none. */
    if (few && (int)i == attack->control && mood == 0) return 1;
    if (!few || which == 0 || mood < 2) return 0;
    unsigned every = n_taking[which], most = attack->n_moods[i] - 2;
    if (every > most) every = most;
    return every > 1 && (mood + turns[which]) % every != 0;
}

static void run(const attack *attack, unsigned n_random) {
    all(0);
    int status = try(attack);
    if (attack->strict && attack->n_arguments && status == TREE_OK) complain("NULL is fine with it");
    all(1);
    try(attack);
    for (unsigned others = few; others < 2; others++) {
        for (unsigned i = 0; i < attack->n_arguments; i++) {
            for (unsigned mood = 0; mood < attack->n_moods[i]; mood++) {
                if (mood == others || is_left_out(attack, i, mood)) continue;
                all(others);
                moods_now[i] = mood;
                try(attack);
            }
            turns[attack->structs[i]]++;
        }
    }
    for (unsigned n = 0; n < n_random && attack->n_arguments > 1; n++) {
        all(1);
        for (unsigned i = 0; i < attack->n_arguments; i++) {
            /* A good control keeps what succeeds short. */
            if ((int)i != attack->control && random_number() % 2)
                moods_now[i] = random_number() % attack->n_moods[i];
        }
        try(attack);
    }
}

static void slowest(void) {
    for (int i = 0; i < 10; i++) {
        size_t most = 0;
        for (size_t k = 1; k < sizeof spent / sizeof *spent; k++)
            if (spent[k] > spent[most]) most = k;
        printf("%s: %.2f s in all calls\n", attacks[most].name, spent[most]);
        spent[most] = 0;
    }
}

int main(int n, char **arguments) {
    /* `hostile few PART OF`: every so many functions of a sample of calls. */
    few = n > 1 && !strcmp(arguments[1], "few");
    unsigned part = n > 3 ? (unsigned)atoi(arguments[2]) : 0, n_parts = n > 3 ? (unsigned)atoi(arguments[3]) : 1;
    int signals[] = {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM};
    for (unsigned i = 0; i < sizeof signals / sizeof *signals; i++) signal(signals[i], crashed);
    patient = few;
    count_structs();
    if (!few) {
        /* Memory for a hostile number would have to come from somewhere. */
        struct rlimit most = {(rlim_t)6 << 30, (rlim_t)6 << 30};
        setrlimit(RLIMIT_AS, &most);
    }
    else {
        /* What a call does when it works is what valgrind is slow at. */
        tree_control first = {.struct_size = sizeof first};
        calm(&first);
        small_limits.pixels = small_limits.triangles = small_limits.voxels = 5000;
        small_limits.nodes = small_limits.leaves = 500;
        small_limits.modules = small_limits.graph_nodes = small_limits.graph_arcs = 4000;
    }
    size_t before = tree_live_objects();
    must(tree_cancel_new(&a_switch));
    must(tree_pool_new(&one_thread, &one_thread_pool));
    for (unsigned i = 0; i < sizeof attacks / sizeof *attacks; i++) {
        if (i % n_parts == part)
            run(&attacks[i], few ? 1 : 100);
        else
            for (unsigned k = 0; k < attacks[i].n_arguments; k++) turns[attacks[i].structs[k]]++;
    }
    free_all();
    must(tree_skeleton_free(second_skeleton));
    must(tree_mesh_free(second_mesh));
    must(tree_tree_free(second_tree));
    must(tree_cancel_free(a_switch));
    must(tree_pool_free(one_thread_pool));
    now = "the end";
    if (tree_live_objects() > before) complain("objects are left");
    printf("%zu calls\n", n_calls);
    slowest();
    printf(n_failures ? "%d failures\n" : "all is well\n", n_failures);
    return n_failures != 0;
}
