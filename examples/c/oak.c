/* Grows an oak, meshes it, copies it into buffers as an engine has them, and writes oak.glb.
 *
 *     oak [PRESET [SEED]]
 *
 * See README.md for how to build it. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tree.h>

/* An engine's vertex: what goes to the GPU as it is. */
typedef struct engine_vertex {
    float position[3];
    float normal[3];
    float uv[2];
} engine_vertex;

typedef struct engine_mesh {
    engine_vertex *vertices;
    uint32_t *indices;
    size_t n_vertices;
    size_t n_indices;
} engine_mesh;

/* Ends the program when a call failed. */
static void check(tree_status status) {
    if (status == TREE_OK) return;
    fprintf(stderr, "%s: %s\n", tree_status_name(status), tree_error_text());
    exit(1);
}

/* Prints a stage when it begins. */
static int32_t told(void *user, const char *stage, float fraction) {
    char *last = user;
    if (strcmp(last, stage) != 0) {
        fprintf(stderr, "%3.0f %% %s\n", 100.0 * fraction, stage);
        snprintf(last, 64, "%s", stage);
    }
    return 0; /* go on */
}

static uint64_t fnv1a(uint64_t hash, const void *data, size_t n_bytes) {
    const unsigned char *bytes = data;
    for (size_t i = 0; i < n_bytes; i++) hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

/* Appends a surface: views become an engine's buffer. */
static void append(engine_mesh *mesh, const tree_surface *surface) {
    size_t first = mesh->n_vertices;
    mesh->n_vertices += surface->n_vertices;
    mesh->vertices = realloc(mesh->vertices, (mesh->n_vertices + 1) * sizeof *mesh->vertices);
    size_t first_index = mesh->n_indices;
    mesh->n_indices += surface->n_indices;
    mesh->indices = realloc(mesh->indices, (mesh->n_indices + 1) * sizeof *mesh->indices);
    if (!mesh->vertices || !mesh->indices) {
        fprintf(stderr, "no memory\n");
        exit(1);
    }
    for (size_t i = 0; i < surface->n_vertices; i++) {
        engine_vertex *vertex = &mesh->vertices[first + i];
        memcpy(vertex->position, surface->positions + 3 * i, sizeof vertex->position);
        memcpy(vertex->normal, surface->normals + 3 * i, sizeof vertex->normal);
        memcpy(vertex->uv, surface->uvs + 2 * i, sizeof vertex->uv);
    }
    for (size_t i = 0; i < surface->n_indices; i++)
        mesh->indices[first_index + i] = (uint32_t)first + surface->indices[i];
}

int main(int n, char **arguments) {
    const char *preset = n > 1 ? arguments[1] : "oak";
    uint64_t seed = n > 2 ? strtoull(arguments[2], NULL, 10) : 1;

    if (tree_abi_version() != TREE_ABI_VERSION) {
        fprintf(stderr, "the library's ABI is %" PRIu32 ", tree.h's is %d\n", tree_abi_version(),
                TREE_ABI_VERSION);
        return 1;
    }

    char stage[64] = "";
    tree_control control;
    check(tree_control_init(&control, sizeof control));
    control.progress = told;
    control.user = stage;

    tree_path_params params;
    check(tree_path_preset(preset, TREE_NUL_TERMINATED, &params, sizeof params));
    tree_tree *tree = NULL;
    check(tree_path_grow(&params, seed, &control, NULL, &tree));

    tree_look *look = NULL;
    check(tree_look_of_tree(tree, 0, &look));
    tree_mesh *mesh = NULL;
    check(tree_mesh_build(tree, look, NULL, &control, NULL, &mesh));
    /* A mesh needs neither. */
    check(tree_look_free(look));
    check(tree_tree_free(tree));

    size_t n_surfaces = 0;
    check(tree_mesh_surface_count(mesh, &n_surfaces));
    engine_mesh engine = {NULL, NULL, 0, 0};
    uint64_t positions = UINT64_C(0xcbf29ce484222325), indices = positions;
    for (size_t i = 0; i < n_surfaces; i++) {
        tree_surface surface;
        surface.struct_size = sizeof surface;
        check(tree_mesh_surface(mesh, i, &surface));
        positions = fnv1a(positions, surface.positions, surface.n_vertices * 3 * sizeof(float));
        indices = fnv1a(indices, surface.indices, surface.n_indices * sizeof(uint32_t));
        append(&engine, &surface);
    }
    printf("%zu surfaces, %zu vertices, %zu triangles\n", n_surfaces, engine.n_vertices,
           engine.n_indices / 3);
    printf("%s seed %" PRIu64 "\n", preset, seed);
    printf("positions %016" PRIx64 " indices %016" PRIx64 "\n", positions, indices);

    check(tree_mesh_write_glb(mesh, "oak.glb", TREE_NUL_TERMINATED, NULL, NULL));
    check(tree_mesh_free(mesh));
    free(engine.vertices);
    free(engine.indices);
    tree_error_clear();
    return 0;
}
