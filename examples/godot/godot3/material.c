/* SpatialMaterials with albedo textures. Properties are set by name, as a script would. */
#include "material.h"
#include <math.h>
#include <string.h>

enum { FORMAT_RGBA8 = 5, CULL_DISABLED = 2 };

typedef godot_gdnative_core_api_struct core;

void call_method(const core *api, godot_object *object, const char *class_name, const char *method,
                 godot_variant *arguments, int n_arguments) {
    const godot_variant *places[8] = {NULL};
    for (int i = 0; i < n_arguments; i++) {
        places[i] = &arguments[i];
    }
    godot_method_bind *bind = api->godot_method_bind_get_method(class_name, method);
    godot_variant_call_error wrong;
    godot_variant nothing = api->godot_method_bind_call(bind, object, places, n_arguments, &wrong);
    api->godot_variant_destroy(&nothing);
    for (int i = 0; i < n_arguments; i++) {
        api->godot_variant_destroy(&arguments[i]);
    }
}

/* A new object, held by the variant, which takes the one reference. */
static godot_object *make(const core *api, const char *class_name, godot_variant *holder) {
    godot_object *made = api->godot_get_class_constructor(class_name)();
    api->godot_variant_new_object(holder, made);
    return made;
}

/* Destroys the value. */
static void set(const core *api, godot_object *object, const char *name, godot_variant value) {
    godot_string text = api->godot_string_chars_to_utf8(name);
    godot_variant arguments[2];
    api->godot_variant_new_string(&arguments[0], &text);
    arguments[1] = value;
    api->godot_string_destroy(&text);
    call_method(api, object, "Object", "set", arguments, 2);
}

static void set_number(const core *api, godot_object *object, const char *name, double number) {
    godot_variant value;
    api->godot_variant_new_real(&value, number);
    set(api, object, name, value);
}

static void set_int(const core *api, godot_object *object, const char *name, int64_t number) {
    godot_variant value;
    api->godot_variant_new_int(&value, number);
    set(api, object, name, value);
}

static void set_yes(const core *api, godot_object *object, const char *name) {
    godot_variant value;
    api->godot_variant_new_bool(&value, true);
    set(api, object, name, value);
}

static void set_color(const core *api, godot_object *object, const char *name, const float rgba[4]) {
    godot_color color;
    godot_variant value;
    api->godot_color_new_rgba(&color, rgba[0], rgba[1], rgba[2], rgba[3]);
    api->godot_variant_new_color(&value, &color);
    set(api, object, name, value);
}

static godot_variant bytes_variant(const core *api, const uint8_t *bytes, size_t n) {
    godot_pool_byte_array pool;
    godot_variant variant;
    api->godot_pool_byte_array_new(&pool);
    api->godot_pool_byte_array_resize(&pool, (godot_int)n);
    godot_pool_byte_array_write_access *access = api->godot_pool_byte_array_write(&pool);
    memcpy(api->godot_pool_byte_array_write_access_ptr(access), bytes, n);
    api->godot_pool_byte_array_write_access_destroy(access);
    api->godot_variant_new_pool_byte_array(&variant, &pool);
    api->godot_pool_byte_array_destroy(&pool);
    return variant;
}

/* An ImageTexture with smaller levels, that repeats: Godot's default for its flags. */
static godot_variant picture(const core *api, const tree_texture_pixels *pixels) {
    godot_variant image, texture, arguments[5];
    godot_object *made = make(api, "Image", &image);
    api->godot_variant_new_int(&arguments[0], pixels->width);
    api->godot_variant_new_int(&arguments[1], pixels->height);
    api->godot_variant_new_bool(&arguments[2], false);
    api->godot_variant_new_int(&arguments[3], FORMAT_RGBA8);
    arguments[4] = bytes_variant(api, pixels->pixels, (size_t)4 * pixels->width * pixels->height);
    call_method(api, made, "Image", "create_from_data", arguments, 5);
    made = make(api, "ImageTexture", &texture);
    arguments[0] = image;
    call_method(api, made, "ImageTexture", "create_from_image", arguments, 1);
    return texture;
}

/* Godot takes material colours for sRGB. */
static float srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * powf(linear, 1.0f / 2.4f) - 0.055f;
}

static void fill(const core *api, godot_object *material, const tree_material *from) {
    const float *base = from->base_color;
    const float color[4] = {srgb(base[0]), srgb(base[1]), srgb(base[2]), base[3]};
    set_color(api, material, "albedo_color", color);
    set_number(api, material, "roughness", from->roughness);
    if (from->alpha == TREE_ALPHA_MASK) {
        set_yes(api, material, "params_use_alpha_scissor");
        set_number(api, material, "params_alpha_scissor_threshold", from->alpha_cutoff);
    }
    if (from->double_sided) {
        set_int(api, material, "params_cull_mode", CULL_DISABLED);
    }
    if (from->translucency > 0.0f) {
        const float share[4] = {from->translucency, from->translucency, from->translucency, 1.0f};
        set_yes(api, material, "transmission_enabled");
        set_color(api, material, "transmission", share);
    }
}

tree_status make_material(const core *api, const tree_mesh *mesh, size_t number, godot_variant *made) {
    tree_material from = {.struct_size = sizeof from};
    tree_texture_pixels pixels = {.struct_size = sizeof pixels};
    tree_texture *texture = NULL;
    tree_status status = tree_mesh_material(mesh, number, &from);
    if (status == TREE_OK) {
        status = tree_mesh_texture(mesh, number, &texture);
    }
    if (status == TREE_OK && texture) {
        status = tree_texture_view(texture, &pixels);
    }
    if (status == TREE_OK) {
        api->godot_variant_destroy(made);
        godot_object *material = make(api, "SpatialMaterial", made);
        fill(api, material, &from);
        if (texture) {
            set(api, material, "albedo_texture", picture(api, &pixels));
        }
    }
    tree_texture_free(texture);
    return status;
}
