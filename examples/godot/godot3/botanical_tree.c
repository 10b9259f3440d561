/* BotanicalTree for Godot 3: grows a preset and fills an ArrayMesh from the library's own memory,
 * with a SpatialMaterial for each surface.
 *
 *   var trees = preload("res://botanical_tree.gdns").new()
 *   mesh_instance.mesh = trees.grow("oak", 1)   # null after an error, which trees.error() tells
 *   print(trees.facts())                        # what C saw, for test.gd
 *
 * Godot's axes are the library's; its front faces run clockwise, so triangles are turned. */
#include "material.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Places in the array that ArrayMesh.add_surface_from_arrays takes. */
enum { AT_VERTEX = 0, AT_NORMAL = 1, AT_TEX_UV = 4, AT_INDEX = 8, N_ARRAYS = 9 };
enum { PRIMITIVE_TRIANGLES = 4 };

/* Godot 3.2 builds know the names that were there in 3.0: core API 1.0 is enough. */
static const godot_gdnative_core_api_struct *api;
static const godot_gdnative_ext_nativescript_api_struct *scripts;

/* What C saw of the last tree, as text: a line for each surface, and one of hashes. */
typedef struct {
    char facts[4096];
    char error[1024];
} trees;

static void say(char *text, size_t room, const char *line) {
    size_t used = strlen(text);
    snprintf(text + used, room - used, "%s", line);
}

static godot_variant text_variant(const char *text) {
    godot_string string = api->godot_string_chars_to_utf8(text);
    godot_variant variant;
    api->godot_variant_new_string(&variant, &string);
    api->godot_string_destroy(&string);
    return variant;
}

static uint64_t fnv(uint64_t hash, const void *data, size_t n_bytes) {
    const unsigned char *bytes = data;
    for (size_t i = 0; i < n_bytes; i++) {
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    }
    return hash;
}

/* ---- from a column to a pool array: one copy, as Godot keeps its own ---- */

static void put(godot_array *arrays, int at, godot_variant *variant) {
    api->godot_array_set(arrays, at, variant);
    api->godot_variant_destroy(variant);
}

static void put_vector3(godot_array *arrays, int at, const float *column, size_t n) {
    godot_pool_vector3_array pool;
    godot_variant variant;
    api->godot_pool_vector3_array_new(&pool);
    api->godot_pool_vector3_array_resize(&pool, (godot_int)n);
    godot_pool_vector3_array_write_access *access = api->godot_pool_vector3_array_write(&pool);
    memcpy(api->godot_pool_vector3_array_write_access_ptr(access), column, n * 3 * sizeof(float));
    api->godot_pool_vector3_array_write_access_destroy(access);
    api->godot_variant_new_pool_vector3_array(&variant, &pool);
    api->godot_pool_vector3_array_destroy(&pool);
    put(arrays, at, &variant);
}

static void put_vector2(godot_array *arrays, int at, const float *column, size_t n) {
    godot_pool_vector2_array pool;
    godot_variant variant;
    api->godot_pool_vector2_array_new(&pool);
    api->godot_pool_vector2_array_resize(&pool, (godot_int)n);
    godot_pool_vector2_array_write_access *access = api->godot_pool_vector2_array_write(&pool);
    memcpy(api->godot_pool_vector2_array_write_access_ptr(access), column, n * 2 * sizeof(float));
    api->godot_pool_vector2_array_write_access_destroy(access);
    api->godot_variant_new_pool_vector2_array(&variant, &pool);
    api->godot_pool_vector2_array_destroy(&pool);
    put(arrays, at, &variant);
}

static void put_triangles(godot_array *arrays, int at, const uint32_t *indices, size_t n) {
    godot_pool_int_array pool;
    godot_variant variant;
    api->godot_pool_int_array_new(&pool);
    api->godot_pool_int_array_resize(&pool, (godot_int)n);
    godot_pool_int_array_write_access *access = api->godot_pool_int_array_write(&pool);
    godot_int *to = api->godot_pool_int_array_write_access_ptr(access);
    for (size_t i = 0; i + 2 < n; i += 3) {
        to[i] = (godot_int)indices[i];
        to[i + 1] = (godot_int)indices[i + 2];
        to[i + 2] = (godot_int)indices[i + 1];
    }
    api->godot_pool_int_array_write_access_destroy(access);
    api->godot_variant_new_pool_int_array(&variant, &pool);
    api->godot_pool_int_array_destroy(&pool);
    put(arrays, at, &variant);
}

/* ---- the mesh ---- */

static void add_surface(godot_object *mesh, const tree_surface *surface) {
    godot_array arrays, no_shapes;
    api->godot_array_new(&arrays);
    api->godot_array_new(&no_shapes);
    api->godot_array_resize(&arrays, N_ARRAYS);
    put_vector3(&arrays, AT_VERTEX, surface->positions, surface->n_vertices);
    put_vector3(&arrays, AT_NORMAL, surface->normals, surface->n_vertices);
    put_vector2(&arrays, AT_TEX_UV, surface->uvs, surface->n_vertices);
    put_triangles(&arrays, AT_INDEX, surface->indices, surface->n_indices);

    godot_variant arguments[4];
    api->godot_variant_new_int(&arguments[0], PRIMITIVE_TRIANGLES);
    api->godot_variant_new_array(&arguments[1], &arrays);
    api->godot_variant_new_array(&arguments[2], &no_shapes);
    /* No compression: bark repeats, and half floats have no digits left at u = 60. */
    api->godot_variant_new_int(&arguments[3], 0);
    call_method(api, mesh, "ArrayMesh", "add_surface_from_arrays", arguments, 4);
    api->godot_array_destroy(&arrays);
    api->godot_array_destroy(&no_shapes);
}

/* Gives the surface that was added last its material. */
static tree_status add_material(godot_object *filled, int at, const tree_mesh *mesh, size_t number) {
    godot_variant arguments[2];
    api->godot_variant_new_int(&arguments[0], at);
    api->godot_variant_new_nil(&arguments[1]);
    tree_status status = make_material(api, mesh, number, &arguments[1]);
    call_method(api, filled, "ArrayMesh", "surface_set_material", arguments, 2);
    return status;
}

/* Fills Godot's mesh, and notes what it is made of. */
static tree_status fill(trees *self, const tree_mesh *mesh, godot_object *filled) {
    char line[256];
    uint64_t positions = 0xcbf29ce484222325u, indices = positions;
    size_t n_surfaces = 0;
    int n_added = 0;
    tree_status status = tree_mesh_surface_count(mesh, &n_surfaces);
    for (size_t i = 0; status == TREE_OK && i < n_surfaces; i++) {
        tree_surface surface = {.struct_size = sizeof surface};
        tree_bounds box = {.struct_size = sizeof box};
        status = tree_mesh_surface(mesh, i, &surface);
        if (status == TREE_OK) {
            status = tree_mesh_surface_bounds(mesh, i, &box);
        }
        /* Godot takes no empty surface. */
        if (status != TREE_OK || surface.n_indices == 0) {
            continue;
        }
        positions = fnv(positions, surface.positions, surface.n_vertices * 3 * sizeof(float));
        indices = fnv(indices, surface.indices, surface.n_indices * sizeof(uint32_t));
        add_surface(filled, &surface);
        status = add_material(filled, n_added++, mesh, surface.material);
        snprintf(line, sizeof line, "surface %zu %zu %.9g %.9g %.9g %.9g %.9g %.9g\n",
                 surface.n_vertices, surface.n_indices, (double)box.min[0], (double)box.min[1],
                 (double)box.min[2], (double)box.max[0], (double)box.max[1], (double)box.max[2]);
        say(self->facts, sizeof self->facts, line);
    }
    snprintf(line, sizeof line, "positions %016" PRIx64 " indices %016" PRIx64, positions, indices);
    say(self->facts, sizeof self->facts, line);
    return status;
}

static tree_status grow_preset(const char *preset, uint64_t seed, tree_tree **tree) {
    tree_path_params params;
    tree_status status = tree_path_preset(preset, TREE_NUL_TERMINATED, &params, sizeof params);
    return status != TREE_OK ? status : tree_path_grow(&params, seed, NULL, NULL, tree);
}

/* grow(preset: String, seed: int) -> ArrayMesh, null after an error. */
static godot_variant grow(godot_object *object, void *method, void *user, int n_arguments,
                          godot_variant **arguments) {
    (void)object;
    (void)method;
    trees *self = user;
    godot_variant result;
    api->godot_variant_new_nil(&result);
    self->facts[0] = self->error[0] = 0;
    if (n_arguments != 2) {
        say(self->error, sizeof self->error, "grow takes a preset and a seed");
        return result;
    }
    godot_string name = api->godot_variant_as_string(arguments[0]);
    godot_char_string preset = api->godot_string_utf8(&name);
    uint64_t seed = (uint64_t)api->godot_variant_as_int(arguments[1]);
    tree_tree *tree = NULL;
    tree_mesh *mesh = NULL;
    tree_status status = grow_preset(api->godot_char_string_get_data(&preset), seed, &tree);
    if (status == TREE_OK) {
        status = tree_mesh_build(tree, NULL, NULL, NULL, NULL, &mesh);
    }
    if (status == TREE_OK) {
        /* The variant takes the one reference. */
        godot_object *filled = api->godot_get_class_constructor("ArrayMesh")();
        api->godot_variant_destroy(&result);
        api->godot_variant_new_object(&result, filled);
        status = fill(self, mesh, filled);
    }
    if (status != TREE_OK) {
        snprintf(self->error, sizeof self->error, "%s: %s", tree_status_name(status),
                 tree_error_text());
        api->godot_variant_destroy(&result);
        api->godot_variant_new_nil(&result);
    }
    tree_mesh_free(mesh);
    tree_tree_free(tree);
    api->godot_char_string_destroy(&preset);
    api->godot_string_destroy(&name);
    return result;
}

static godot_variant facts(godot_object *object, void *method, void *user, int n_arguments,
                           godot_variant **arguments) {
    (void)object;
    (void)method;
    (void)n_arguments;
    (void)arguments;
    return text_variant(((trees *)user)->facts);
}

static godot_variant error(godot_object *object, void *method, void *user, int n_arguments,
                           godot_variant **arguments) {
    (void)object;
    (void)method;
    (void)n_arguments;
    (void)arguments;
    return text_variant(((trees *)user)->error);
}

/* Objects of the library alive: test.gd looks for leaks. */
static godot_variant live_objects(godot_object *object, void *method, void *user, int n_arguments,
                                  godot_variant **arguments) {
    (void)object;
    (void)method;
    (void)user;
    (void)n_arguments;
    (void)arguments;
    godot_variant result;
    api->godot_variant_new_int(&result, (int64_t)tree_live_objects());
    return result;
}

/* ---- what Godot calls when it loads the library ---- */

static void *begin(godot_object *object, void *method) {
    (void)object;
    (void)method;
    return calloc(1, sizeof(trees));
}

static void end(godot_object *object, void *method, void *user) {
    (void)object;
    (void)method;
    free(user);
}

void GDN_EXPORT botanical_tree_gdnative_init(godot_gdnative_init_options *options) {
    api = options->api_struct;
    for (unsigned int i = 0; i < api->num_extensions; i++) {
        if (api->extensions[i]->type == GDNATIVE_EXT_NATIVESCRIPT) {
            scripts = (const godot_gdnative_ext_nativescript_api_struct *)api->extensions[i];
        }
    }
}

void GDN_EXPORT botanical_tree_gdnative_terminate(godot_gdnative_terminate_options *options) {
    (void)options;
    api = NULL;
    scripts = NULL;
}

static void method(void *library, const char *name,
                   godot_variant (*body)(godot_object *, void *, void *, int, godot_variant **)) {
    godot_method_attributes attributes = {GODOT_METHOD_RPC_MODE_DISABLED};
    godot_instance_method instance = {.method = body};
    scripts->godot_nativescript_register_method(library, "BotanicalTree", name, attributes,
                                                instance);
}

void GDN_EXPORT botanical_tree_nativescript_init(void *library) {
    if (!scripts || tree_abi_version() != TREE_ABI_VERSION) {
        return; /* Nothing is registered: new() fails, and says so. */
    }
    godot_instance_create_func create = {.create_func = begin};
    godot_instance_destroy_func destroy = {.destroy_func = end};
    scripts->godot_nativescript_register_class(library, "BotanicalTree", "Reference", create,
                                               destroy);
    method(library, "grow", grow);
    method(library, "facts", facts);
    method(library, "error", error);
    method(library, "live_objects", live_objects);
}
