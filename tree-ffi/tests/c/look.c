#include "check.h"
#include <math.h>

static void looks(void) {
    tree_str kinds[] = {{"oak", TREE_NUL_TERMINATED}, {"no such", TREE_NUL_TERMINATED}};
    tree_species species = {.struct_size = sizeof species,
                            .bark = {"birch", 5},
                            .leaf_kinds = kinds,
                            .n_leaf_kinds = 2};
    tree_look *look = NULL;
    FAILS(TREE_ERROR_UNKNOWN_NAME, "no such", tree_look_built_in(&species, &look));
    CHECK(look == NULL);
    OK(tree_look_plain(&species, &look));
    OK(tree_look_check(look, &species));
    FAILS(TREE_ERROR_INVALID, "leaf", tree_look_check(look, NULL));
    size_t n_leaves = 0;
    OK(tree_look_leaf_count(look, &n_leaves));
    CHECK(n_leaves == 2);
    OK(tree_look_free(look));
    species.n_leaf_kinds = 1;
    OK(tree_look_built_in(&species, &look));
    OK(tree_look_check(look, &species));
    tree_material material = {.struct_size = sizeof material};
    OK(tree_look_material(look, 0, &material));
    CHECK(material.name.len == 10 && memcmp(material.name.data, "birch bark", 10) == 0);
    CHECK(material.has_texture && !material.texture && material.alpha == TREE_ALPHA_OPAQUE);
    OK(tree_look_material(look, 1, &material));
    CHECK(material.alpha == TREE_ALPHA_MASK && material.alpha_cutoff == 0.5f && material.double_sided);
    FAILS(TREE_ERROR_INVALID, "2 materials", tree_look_material(look, 2, &material));
    OK(tree_look_free(look));

    tree_tree *twig = an_oak_twig();
    OK(tree_look_of_tree(twig, 1, &look));
    OK(tree_look_check(look, NULL));
    tree_texture *none = NULL;
    OK(tree_look_texture(look, 0, &none));
    CHECK(none == NULL);
    OK(tree_look_free(look));
    OK(tree_tree_free(twig));
}

static void names(void) {
    const tree_str *names = NULL;
    size_t n = 0;
    OK(tree_bark_names(&names, &n));
    CHECK(n > 5);
    int found = 0;
    for (size_t i = 0; i < n; i++) {
        found += names[i].len == 3 && memcmp(names[i].data, "oak", 3) == 0;
    }
    CHECK(found == 1);
    OK(tree_leaf_names(&names, &n));
    CHECK(n > 5 && names[n - 1].len > 0);
    for (size_t i = 0; i < n; i += 7) {
        tree_texture *leaf = NULL;
        OK(tree_texture_leaf(names[i].data, names[i].len, 16, NULL, NULL, &leaf));
        OK(tree_texture_free(leaf));
    }
}

static void textures(void) {
    static const uint8_t pixels[] = {255, 0, 0, 255, 0, 10, 20, 0};
    tree_texture_pixels input = {sizeof input, {"two", 3}, pixels, 2, 1};
    tree_texture *two = NULL, *back = NULL;
    OK(tree_texture_from_pixels(&input, NULL, &two));
    tree_texture_pixels view = {.struct_size = sizeof view};
    OK(tree_texture_view(two, &view));
    CHECK(view.width == 2 && view.height == 1 && view.pixels != pixels);
    CHECK(memcmp(view.pixels, pixels, 8) == 0 && view.name.len == 3);

    tree_bytes *png = NULL;
    OK(tree_texture_to_png(two, &png));
    const uint8_t *file = NULL;
    size_t file_len = 0;
    OK(tree_bytes_view(png, &file, &file_len));
    CHECK(file_len > 8 && memcmp(file + 1, "PNG", 3) == 0);
    OK(tree_texture_from_bytes("again", 5, file, file_len, NULL, &back));
    OK(tree_texture_view(back, &view));
    CHECK(memcmp(view.pixels, pixels, 8) == 0 && memcmp(view.name.data, "again", 5) == 0);
    OK(tree_texture_free(back));
    FAILS(TREE_ERROR_FORMAT, "cut", tree_texture_from_bytes("cut", 3, file, file_len / 2, NULL, &back));
    OK(tree_bytes_free(png));

    char path[L_tmpnam + 8];
    snprintf(path, sizeof path, "look_test_%p.png", (void *)two);
    OK(tree_texture_write_png(two, path, TREE_NUL_TERMINATED));
    OK(tree_texture_read(path, TREE_NUL_TERMINATED, NULL, &back));
    OK(tree_texture_view(back, &view));
    CHECK(view.width == 2 && view.name.len > 9 && memcmp(view.name.data, "look_test", 9) == 0);
    OK(tree_texture_free(back));
    remove(path);
    FAILS(TREE_ERROR_IO, path, tree_texture_read(path, TREE_NUL_TERMINATED, NULL, &back));
    FAILS(TREE_ERROR_IO, "", tree_texture_write_png(two, "no/such/folder/x.png", TREE_NUL_TERMINATED));
    OK(tree_texture_free(two));

    input.width = 0;
    FAILS(TREE_ERROR_INVALID, "two", tree_texture_from_pixels(&input, NULL, &two));
    input.width = input.height = 0xFFFFFFFF;
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_texture_from_pixels(&input, NULL, &two));
    input.width = input.height = 1;
    input.pixels = NULL;
    FAILS(TREE_ERROR_NULL, "pixels.pixels", tree_texture_from_pixels(&input, NULL, &two));
}

static void drawn(void) {
    tree_texture *texture = NULL;
    tree_texture_pixels view = {.struct_size = sizeof view};
    OK(tree_texture_bark("oak", 3, 32, NULL, &texture));
    OK(tree_texture_view(texture, &view));
    CHECK(view.width == 32 && view.height == 32 && view.pixels[3] == 255);
    OK(tree_texture_free(texture));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "oek", tree_texture_bark("oek", 3, 32, NULL, &texture));
    FAILS(TREE_ERROR_PARAMETER, "size_px", tree_texture_bark("oak", 3, 8, NULL, &texture));

    tree_leaf_card card = {.struct_size = sizeof card};
    OK(tree_texture_leaf("oak", 3, 0, NULL, &card, &texture));
    OK(tree_texture_view(texture, &view));
    CHECK(view.width == 256 && card.width > 0.2f && card.width < 2 && card.petiole < 0.5f);
    OK(tree_texture_free(texture));
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.pixels = 100;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_texture_leaf("oak", 3, 16, &control, NULL, &texture));

    tree_bark_style style;
    OK(tree_bark_style_init(&style, sizeof style));
    CHECK(style.furrows[0] == 8 && style.n_patches == 0 && !style.has_lenticels);
    tree_bark_patches patch = {.color = {255, 0, 0}, .count = {2, 2}, .share = 1, .softness = 0.1f,
                               .opacity = 1, .roughness = 0};
    style.patches = &patch;
    style.n_patches = 1;
    style.has_lenticels = 1;
    OK(tree_texture_bark_with(&style, 16, NULL, &texture));
    OK(tree_texture_view(texture, &view));
    CHECK(view.width == 16 && view.pixels[0] > 2 * view.pixels[1]);
    OK(tree_texture_free(texture));
    patch.softness = NAN;
    FAILS(TREE_ERROR_PARAMETER, "patches.softness", tree_texture_bark_with(&style, 16, NULL, &texture));
    style.n_patches = 1u << 20;
    FAILS(TREE_ERROR_LIMIT, "", tree_texture_bark_with(&style, 16, NULL, &texture));
    style.struct_size = sizeof style;
    OK(tree_bark_style_of("birch", 5, &style));
    CHECK(style.has_lenticels || style.n_patches > 0);
    OK(tree_texture_bark_with(&style, 16, NULL, &texture));
    tree_texture *same = NULL;
    tree_texture_pixels other = view;
    OK(tree_texture_bark("birch", 5, 16, NULL, &same));
    OK(tree_texture_view(texture, &view));
    OK(tree_texture_view(same, &other));
    CHECK(memcmp(view.pixels, other.pixels, 4 * 16 * 16) == 0);
    OK(tree_texture_free(same));
    OK(tree_texture_free(texture));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "", tree_bark_style_of("x", 1, &style));
}

static void leaves_drawn(void) {
    tree_texture *texture = NULL, *same = NULL;
    tree_texture_pixels view = {.struct_size = sizeof view}, other = view;
    tree_leaf_shape shape;
    OK(tree_leaf_shape_init(&shape, sizeof shape));
    CHECK(shape.n_outline == 7 && shape.outline[1] == 0.0f && !shape.has_spray);
    CHECK(shape.spray_leaves == 9);
    float outline[] = {0, 0, 1, 0.1f, 0.3f, 0, 0.08f, 0.7f, 0, 0, 1, 1};
    float ray = 0.5f;
    shape.outline = outline;
    shape.n_outline = 4;
    shape.rays = &ray;
    shape.n_rays = 1;
    tree_leaf_card card = {.struct_size = sizeof card};
    OK(tree_texture_leaf_with(&shape, 64, NULL, &card, &texture));
    CHECK(card.width < 0.4f);
    OK(tree_texture_free(texture));
    outline[0] = INFINITY;
    FAILS(TREE_ERROR_PARAMETER, "outline x", tree_texture_leaf_with(&shape, 64, NULL, NULL, &texture));
    shape.n_outline = 1;
    FAILS(TREE_ERROR_PARAMETER, "outline", tree_texture_leaf_with(&shape, 64, NULL, NULL, &texture));

    OK(tree_leaf_shape_of("maple", 5, &shape));
    uint8_t green = shape.base[1], red = shape.base[0];
    OK(tree_texture_leaf_with(&shape, 32, NULL, NULL, &texture));
    OK(tree_texture_leaf("maple", 5, 32, NULL, NULL, &same));
    OK(tree_texture_view(texture, &view));
    OK(tree_texture_view(same, &other));
    CHECK(memcmp(view.pixels, other.pixels, 4 * 32 * 32) == 0);
    OK(tree_texture_free(same));
    OK(tree_texture_free(texture));
    OK(tree_leaf_shape_autumn(&shape, 1));
    CHECK(shape.base[0] > red && (shape.base[1] != green || shape.base[0] != red));
    shape.has_spray = 1;
    shape.spray_leaves = 3;
    OK(tree_texture_leaf_with(&shape, 16, NULL, NULL, &texture));
    OK(tree_texture_free(texture));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "", tree_leaf_shape_of("x", 1, &shape));
}

/* A diamond. */
static const float positions[] = {0, 0, 0, 0.3f, 0.5f, 0, 0, 1, 0, -0.3f, 0.5f, 0};
static const float normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
static const float uvs[] = {0.5f, 1, 1, 0.5f, 0.5f, 0, 0, 0.5f};
static const uint32_t indices[] = {0, 1, 2, 0, 2, 3};

static tree_leaf_mesh a_diamond(void) {
    tree_leaf_mesh mesh = {sizeof mesh, 4, 6, positions, normals, uvs, NULL, indices};
    return mesh;
}

static void own_looks(void) {
    tree_texture *picture = NULL, *shared = NULL;
    OK(tree_texture_leaf("oak", 3, 64, NULL, NULL, &picture));
    tree_material bark, leaf;
    OK(tree_material_init(&bark, sizeof bark));
    CHECK(bark.base_color[2] == 1.0f && bark.roughness == 0.9f && bark.alpha == TREE_ALPHA_OPAQUE);
    leaf = bark;
    leaf.name = (tree_str){"my leaf", 7};
    leaf.texture = picture;
    leaf.alpha = TREE_ALPHA_MASK;
    leaf.double_sided = 1;
    tree_leaf_mesh diamond = a_diamond();
    tree_leaf_look leaves[2];
    OK(tree_leaf_look_init(&leaves[0], sizeof leaves[0]));
    CHECK(leaves[0].form == TREE_LEAF_CARD && leaves[0].sheets == 1 && leaves[0].rows == 2);
    leaves[1] = leaves[0];
    leaves[0].material = leaves[1].material = &leaf;
    leaves[0].form = TREE_LEAF_OUTLINE;
    leaves[0].bend = 0.5f;
    leaves[1].form = TREE_LEAF_MESH;
    leaves[1].mesh = &diamond;
    tree_look *look = NULL;
    OK(tree_look_new(&bark, leaves, 2, NULL, &look));
    /* The look keeps the picture. */
    OK(tree_texture_free(picture));

    tree_material material = {.struct_size = sizeof material};
    OK(tree_look_material(look, 0, &material));
    CHECK(material.name.len == 8 && !material.has_texture);
    OK(tree_look_material(look, 2, &material));
    CHECK(material.name.len == 7 && material.has_texture && material.alpha == TREE_ALPHA_MASK);
    OK(tree_look_texture(look, 1, &shared));
    tree_texture_pixels view = {.struct_size = sizeof view};
    OK(tree_texture_view(shared, &view));
    CHECK(view.width == 64);
    OK(tree_texture_free(shared));
    tree_leaf_look back = {.struct_size = sizeof back};
    OK(tree_look_leaf(look, 0, &back));
    CHECK(back.form == TREE_LEAF_OUTLINE && back.max_vertices == 8 && back.bend == 0.5f);
    CHECK(!back.material && !back.mesh);
    tree_leaf_mesh mesh = {.struct_size = sizeof mesh};
    OK(tree_look_leaf_mesh(look, 0, &mesh));
    CHECK(mesh.n_vertices == 0 && mesh.positions == NULL);
    OK(tree_look_leaf_mesh(look, 1, &mesh));
    CHECK(mesh.n_vertices == 4 && mesh.positions[7] == 1.0f && mesh.uvs2 == NULL);
    FAILS(TREE_ERROR_INVALID, "2 leaf kinds", tree_look_leaf(look, 2, &back));

    tree_leaf_model_report report = {.struct_size = sizeof report};
    tree_leaf_model *model = NULL;
    OK(tree_look_leaf_model(look, 0, NULL, &report, &model));
    CHECK(!report.fallback && !report.opaque && report.drawn < 0.9f && report.visible < report.drawn);
    CHECK(report.area > 0.1f);
    OK(tree_leaf_model_view(model, &mesh));
    CHECK(mesh.n_vertices > 4 && mesh.n_indices % 3 == 0 && mesh.indices[0] < mesh.n_vertices);
    OK(tree_leaf_model_free(model));
    OK(tree_look_leaf_model(look, 1, NULL, NULL, &model));
    OK(tree_leaf_model_view(model, &mesh));
    CHECK(mesh.n_vertices == 4 && mesh.n_indices == 6);
    OK(tree_leaf_model_free(model));
    OK(tree_look_free(look));
    FAILS(TREE_ERROR_HANDLE, "leaves[0].material.texture", tree_look_new(&bark, leaves, 2, NULL, &look));
}

static void bad_looks(void) {
    tree_look *look = NULL;
    tree_material bark;
    OK(tree_material_init(&bark, sizeof bark));
    tree_leaf_look leaf;
    OK(tree_leaf_look_init(&leaf, sizeof leaf));
    OK(tree_look_new(NULL, &leaf, 1, NULL, &look));
    OK(tree_look_free(look));
    bark.roughness = NAN;
    FAILS(TREE_ERROR_PARAMETER, "roughness", tree_look_new(&bark, NULL, 0, NULL, &look));
    bark.roughness = 1;
    bark.alpha = 5;
    FAILS(TREE_ERROR_ENUM, "TREE_ALPHA_", tree_look_new(&bark, NULL, 0, NULL, &look));
    leaf.form = 4;
    FAILS(TREE_ERROR_ENUM, "leaves[0].form", tree_look_new(NULL, &leaf, 1, NULL, &look));
    leaf.form = TREE_LEAF_MESH;
    FAILS(TREE_ERROR_NULL, "leaves[0].mesh", tree_look_new(NULL, &leaf, 1, NULL, &look));
    tree_leaf_mesh diamond = a_diamond();
    leaf.mesh = &diamond;
    diamond.n_vertices = 3;
    FAILS(TREE_ERROR_INVALID, "vertex", tree_look_new(NULL, &leaf, 1, NULL, &look));
    diamond.n_vertices = (size_t)1 << 60;
    FAILS(TREE_ERROR_LIMIT, "triangles", tree_look_new(NULL, &leaf, 1, NULL, &look));
    leaf.form = TREE_LEAF_MODELLED;
    leaf.max_vertices = 65;
    FAILS(TREE_ERROR_PARAMETER, "max_vertices", tree_look_new(NULL, &leaf, 1, NULL, &look));
    leaf.max_vertices = 12;
    leaf.struct_size = 1;
    FAILS(TREE_ERROR_STRUCT_SIZE, "leaves", tree_look_new(NULL, &leaf, 1, NULL, &look));
    CHECK(look == NULL);
}

void test_look(void) {
    looks();
    names();
    textures();
    drawn();
    leaves_drawn();
    own_looks();
    bad_looks();
}
