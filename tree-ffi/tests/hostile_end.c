
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

static double slowest;
static const char *slowest_name = "";

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
    if (took > slowest) {
        slowest = took;
        slowest_name = attack->name;
    }
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

static void run(const attack *attack, unsigned n_random) {
    all(0);
    int status = try(attack);
    if (attack->strict && attack->n_arguments && status == TREE_OK) complain("NULL is fine with it");
    all(1);
    try(attack);
    for (unsigned others = 0; others < 2; others++) {
        for (unsigned i = 0; i < attack->n_arguments; i++) {
            for (unsigned mood = 0; mood < attack->n_moods[i]; mood++) {
                all(others);
                moods_now[i] = mood;
                try(attack);
            }
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

int main(int n, char **arguments) {
    int few = n > 1 && !strcmp(arguments[1], "few");
    int signals[] = {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGALRM};
    for (unsigned i = 0; i < sizeof signals / sizeof *signals; i++) signal(signals[i], crashed);
    patient = few;
    if (!few) {
        /* Memory for a hostile number would have to come from somewhere. */
        struct rlimit most = {(rlim_t)6 << 30, (rlim_t)6 << 30};
        setrlimit(RLIMIT_AS, &most);
    }
    size_t before = tree_live_objects();
    must(tree_cancel_new(&a_switch));
    must(tree_pool_new(&one_thread, &one_thread_pool));
    for (unsigned i = 0; i < sizeof attacks / sizeof *attacks; i++)
        run(&attacks[i], few ? 3 : 100);
    free_all();
    must(tree_skeleton_free(second_skeleton));
    must(tree_mesh_free(second_mesh));
    must(tree_tree_free(second_tree));
    must(tree_cancel_free(a_switch));
    must(tree_pool_free(one_thread_pool));
    now = "the end";
    if (tree_live_objects() > before) complain("objects are left");
    printf("slowest: %s, %.2f s\n", slowest_name, slowest);
    printf(n_failures ? "%d failures\n" : "all is well\n", n_failures);
    return n_failures != 0;
}
