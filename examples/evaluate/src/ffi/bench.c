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

/* What a budget is tried on. Frees what it made; its status. */
static tree_status work(const char *name, const tree_tree *tree, const tree_mesh *mesh) {
    tree_tree *grown = NULL;
    tree_mesh *made = NULL;
    tree_bytes *bytes = NULL;
    tree_picture *picture = NULL;
    tree_status status = TREE_ERROR_UNKNOWN_NAME;
    if (!strcmp(name, "grow")) {
        tree_path_params params;
        must(tree_path_preset("oak", TREE_NUL_TERMINATED, &params, sizeof params));
        params.graph_nodes = 200000;
        status = tree_path_grow(&params, 1, NULL, NULL, &grown);
    } else if (!strcmp(name, "leaves")) {
        tree_leaf_params params;
        must(tree_leaf_params_init(&params, sizeof params));
        params.spacing = 0.002f;
        status = tree_tree_grow_leaves(tree, &params, NULL, NULL, 0, 1, NULL, NULL, &grown);
    } else if (!strcmp(name, "mesh")) {
        tree_mesh_params params;
        must(tree_mesh_params_init(&params, sizeof params));
        params.error = 0.0003f;
        params.tangents = params.lightmap = 1;
        status = tree_mesh_build(tree, NULL, &params, NULL, NULL, &made);
    } else if (!strcmp(name, "picture")) {
        tree_view view;
        must(tree_view_init(&view, sizeof view));
        view.width = view.height = 2000;
        status = tree_render(mesh, &view, NULL, NULL, &picture);
    } else if (!strcmp(name, "glb")) {
        status = tree_mesh_to_glb(mesh, NULL, NULL, &bytes);
    }
    must(tree_picture_free(picture));
    must(tree_bytes_free(bytes));
    must(tree_mesh_free(made));
    must(tree_tree_free(grown));
    return status;
}

/* Bytes that a piece of work takes at its peak under a budget of so many (0 for none), and its status. */
static void budget(const char *name, uint64_t bytes, const tree_tree *tree, const tree_mesh *mesh) {
    tree_memory_reset_peak();
    uint64_t before = tree_memory_used();
    tree_memory_set_budget(bytes ? before + bytes : 0);
    tree_status status = work(name, tree, mesh);
    tree_memory_set_budget(0);
    printf("%llu %d\n", (unsigned long long)(tree_memory_peak() - before), status);
}

int main(void) {
    char line[64], name[32];
    unsigned long long bytes = 0;
    tree_tree *tree = NULL;
    tree_mesh *mesh = NULL;
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\n")] = 0;
        if (!strcmp(line, "calls")) calls();
        else if (!strncmp(line, "whole ", 6)) whole(line + 6);
        else if (!strcmp(line, "fetch")) fetch();
        else if (!strcmp(line, "cycles")) cycles();
        else if (sscanf(line, "budget %31s %llu", name, &bytes) == 2) {
            if (!tree) {
                tree = grow("oak", NULL);
                must(tree_mesh_build(tree, NULL, NULL, NULL, NULL, &mesh));
            }
            budget(name, bytes, tree, mesh);
        } else return 2;
        fflush(stdout);
    }
    must(tree_mesh_free(mesh));
    must(tree_tree_free(tree));
    return 0;
}
