/* A thousand times a tree, a mesh, its views and their end: the process does not grow. */
#define _DEFAULT_SOURCE
#include "../c/check.h"

#include <unistd.h>

int n_failures = 0;

static long resident_pages(void) {
    long whole = 0, resident = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%ld %ld", &whole, &resident) != 2) resident = 0;
    if (file) fclose(file);
    return resident;
}

static void cycle(uint32_t i) {
    enum { N = 64 };
    float positions[3 * N], radii[N];
    uint32_t parents[N];
    for (uint32_t k = 0; k < N; k++) {
        positions[3 * k] = 0.1f * (float)((k * 7 + i) % 11);
        positions[3 * k + 1] = 0.2f * (float)k;
        positions[3 * k + 2] = 0.1f * (float)((k * 5 + i) % 13);
        radii[k] = 0.1f / (float)(k + 1);
        parents[k] = k ? (k - 1) / 2 : TREE_NO_PARENT;
    }
    tree_skeleton_columns columns = {sizeof columns, N, positions, radii, parents};
    tree_skeleton *skeleton = NULL;
    tree_tree *tree = NULL;
    tree_look *look = NULL;
    tree_mesh *mesh = NULL;
    OK(tree_skeleton_from_columns(&columns, NULL, &skeleton));
    OK(tree_tree_new(skeleton, NULL, NULL, NULL, &tree));
    OK(tree_skeleton_free(skeleton));
    OK(tree_look_plain(NULL, &look));
    OK(tree_mesh_build(tree, look, NULL, NULL, NULL, &mesh));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
    size_t n = 0;
    OK(tree_mesh_surface_count(mesh, &n));
    double sum = 0;
    for (size_t s = 0; s < n; s++) {
        tree_surface view = {.struct_size = sizeof view};
        OK(tree_mesh_surface(mesh, s, &view));
        for (size_t v = 0; v < 3 * view.n_vertices; v++) sum += view.positions[v];
    }
    CHECK(n > 0 && sum > 0);
    OK(tree_mesh_free(mesh));
    /* Errors take no memory either. */
    FAILS(TREE_ERROR_HANDLE, "freed", tree_mesh_free(mesh));
}

int main(int n, char **arguments) {
    uint32_t n_cycles = n > 1 ? (uint32_t)atoi(arguments[1]) : 1000;
    long early = 0;
    uint64_t used = 0;
    for (uint32_t i = 0; i < n_cycles; i++) {
        cycle(i);
        if (i == n_cycles / 5) {
            early = resident_pages();
            used = tree_memory_used();
        }
    }
    long late = resident_pages();
    printf("%ld pages after a fifth, %ld at the end; %llu and %llu bytes in use\n", early, late,
           (unsigned long long)used, (unsigned long long)tree_memory_used());
    /* An allocator keeps a little of what was freed: 2 MiB are let pass, 2 KiB a cycle. */
    CHECK(early > 0 && (late - early) * sysconf(_SC_PAGESIZE) < 2 << 20);
    CHECK(tree_memory_used() <= used + 4096);
    CHECK(tree_live_objects() == 0);
    tree_error_clear();
    printf(n_failures ? "%d failures\n" : "all is well\n", n_failures);
    return n_failures != 0;
}
