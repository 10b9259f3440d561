/* What a C program sees: evaluate compiles this against libtree_ffi and asks it, line by line, for one
 * measurement each. Answers are numbers on one line. */
#define _POSIX_C_SOURCE 199309L
#include "tree.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void must(tree_status status) {
    if (status != TREE_OK) {
        fprintf(stderr, "%s: %s\n", tree_status_name(status), tree_error_text());
        exit(1);
    }
}

static tree_tree *grow(const char *preset, const tree_control *control) {
    tree_path_params params;
    tree_tree *tree = NULL;
    must(tree_path_preset(preset, TREE_NUL_TERMINATED, &params, sizeof params));
    must(tree_path_grow(&params, 1, control, NULL, &tree));
    return tree;
}

/* Nanoseconds of a call that does nothing, of looking at a surface, and of a refused NULL. */
static void calls(void) {
    tree_tree *tree = grow("a", NULL);
    tree_mesh *mesh = NULL;
    must(tree_mesh_build(tree, NULL, NULL, NULL, NULL, &mesh));
    enum { N = 1000000 };
    volatile uint32_t sink = 0;
    double t0 = now();
    for (int i = 0; i < N; i++) sink += tree_abi_version();
    double t1 = now();
    tree_surface surface = {.struct_size = sizeof surface};
    for (int i = 0; i < N; i++) {
        must(tree_mesh_surface(mesh, 0, &surface));
        sink += surface.indices[0];
    }
    double t2 = now();
    for (int i = 0; i < N; i++) sink += (uint32_t)tree_mesh_surface(NULL, 0, &surface);
    double t3 = now();
    printf("%.3f %.3f %.3f\n", 1e9 * (t1 - t0) / N, 1e9 * (t2 - t1) / N, 1e9 * (t3 - t2) / N);
    must(tree_mesh_free(mesh));
    must(tree_tree_free(tree));
}

/* Seconds from nothing to the buffers of a preset's mesh, and back to nothing. */
static void whole(const char *preset) {
    double start = now();
    tree_tree *tree = grow(preset, NULL);
    tree_mesh *mesh = NULL;
    must(tree_mesh_build(tree, NULL, NULL, NULL, NULL, &mesh));
    size_t n = 0, n_vertices = 0;
    must(tree_mesh_surface_count(mesh, &n));
    for (size_t i = 0; i < n; i++) {
        tree_surface surface = {.struct_size = sizeof surface};
        must(tree_mesh_surface(mesh, i, &surface));
        n_vertices += surface.n_vertices;
    }
    must(tree_mesh_free(mesh));
    must(tree_tree_free(tree));
    printf("%.9f %zu\n", now() - start, n_vertices);
}

/* Bytes that the library takes while every column of a mesh is fetched a thousand times, and how many
 * of the pointers moved. */
static void fetch(void) {
    tree_tree *tree = grow("oak", NULL);
    tree_mesh *mesh = NULL;
    must(tree_mesh_build(tree, NULL, NULL, NULL, NULL, &mesh));
    tree_surface first = {.struct_size = sizeof first};
    must(tree_mesh_surface(mesh, 0, &first));
    tree_memory_reset_peak();
    uint64_t used = tree_memory_used();
    size_t moved = 0;
    for (int i = 0; i < 1000; i++) {
        tree_surface surface = {.struct_size = sizeof surface};
        must(tree_mesh_surface(mesh, 0, &surface));
        moved += surface.positions != first.positions || surface.indices != first.indices;
    }
    printf("%llu %zu\n", (unsigned long long)(tree_memory_peak() - used), moved);
    must(tree_mesh_free(mesh));
    must(tree_tree_free(tree));
}

static double resident(void) {
    long total = 0, pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%ld %ld", &total, &pages) != 2) pages = 0;
    if (file) fclose(file);
    return (double)pages * (double)sysconf(_SC_PAGESIZE);
}

/* Resident bytes after 200 and after 1000 cycles of making and freeing, and objects left. */
static void cycles(void) {
    double early = 0;
    size_t before = tree_live_objects();
    for (int i = 0; i < 1000; i++) {
        tree_tree *tree = grow("a", NULL);
        tree_mesh *mesh = NULL;
        must(tree_mesh_build(tree, NULL, NULL, NULL, NULL, &mesh));
        must(tree_mesh_free(mesh));
        must(tree_tree_free(tree));
        if (i == 199) early = resident();
    }
    printf("%.0f %.0f %zu\n", early, resident(), tree_live_objects() - before);
}

/* Peak under a budget of so many megabytes, in bytes, and how the call ended. */
static void budget(uint64_t megabytes) {
    tree_tree *tree = NULL;
    tree_mesh *mesh = NULL;
    tree_path_params params;
    must(tree_path_preset("oak", TREE_NUL_TERMINATED, &params, sizeof params));
    tree_memory_set_budget(megabytes << 20);
    tree_memory_reset_peak();
    tree_status status = tree_path_grow(&params, 1, NULL, NULL, &tree);
    if (status == TREE_OK) status = tree_mesh_build(tree, NULL, NULL, NULL, NULL, &mesh);
    printf("%llu %d\n", (unsigned long long)tree_memory_peak(), status);
    tree_memory_set_budget(0);
    must(tree_mesh_free(mesh));
    must(tree_tree_free(tree));
}

int main(void) {
    char line[64];
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\n")] = 0;
        if (!strcmp(line, "calls")) calls();
        else if (!strncmp(line, "whole ", 6)) whole(line + 6);
        else if (!strcmp(line, "fetch")) fetch();
        else if (!strcmp(line, "cycles")) cycles();
        else if (!strncmp(line, "budget ", 7)) budget(strtoull(line + 7, NULL, 10));
        else return 2;
        fflush(stdout);
    }
    return 0;
}
