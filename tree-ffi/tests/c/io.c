#include "check.h"

tree_mesh *a_leafy_mesh(void);

static const char PYRAMID[] = "mtllib m.mtl\no pyramid\nv 0 0 0\nv 1 0 0\nv 0 0 -1\nv 0 1 0\n"
                              "usemtl red\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 3 2\n";
static const char RED[] = "newmtl red\nKd 1 0 0\n";

/* A path in the folder for tests; `place` has 4096 bytes. */
static const char *in_folder(char *place, const char *name) {
    const char *folder = getenv("TREE_TEST_DIR");
    snprintf(place, 4096, "%s/tree_test_%s", folder ? folder : ".", name);
    return place;
}

static void gone(const char *name) {
    char path[4096];
    CHECK(remove(in_folder(path, name)) == 0);
}

static tree_mesh_totals totals_of(const tree_mesh *mesh) {
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_mesh_measure(mesh, &totals));
    return totals;
}

/* Reads bytes back, and frees them. */
static tree_mesh *back(tree_mesh_format format, tree_bytes *bytes, tree_import_report *report) {
    const uint8_t *data = NULL;
    size_t len = 0;
    tree_mesh *mesh = NULL;
    OK(tree_bytes_view(bytes, &data, &len));
    OK(tree_mesh_from_bytes(format, data, len, NULL, 0, NULL, report, &mesh));
    OK(tree_bytes_free(bytes));
    return mesh;
}

static size_t size_of(const tree_bytes *bytes) {
    const uint8_t *data = NULL;
    size_t len = 0;
    OK(tree_bytes_view(bytes, &data, &len));
    return len;
}

static int has(const tree_bytes *bytes, const char *part) {
    const uint8_t *data = NULL;
    size_t len = 0, n = strlen(part);
    OK(tree_bytes_view(bytes, &data, &len));
    for (size_t i = 0; i + n <= len; i++) {
        if (!memcmp(data + i, part, n)) {
            return 1;
        }
    }
    return 0;
}

/* A mesh all of whose vertices hang on one joint that moves. */
static void moving(void) {
    tree_mesh *mesh = a_leafy_mesh();
    size_t n = totals_of(mesh).n_vertices;
    uint16_t *joints = calloc(n, sizeof *joints);
    const float at[] = {0, 0, 0}, times[] = {0, 1}, places[] = {0, 0, 0, 0, 1, 0}, scales[] = {1, 0.5f};
    const float turns[] = {0, 0, 0, 1, 0, 1, 0, 0};
    tree_glb_motion motion;
    OK(tree_glb_motion_init(&motion, sizeof motion));
    tree_bytes *bytes = NULL;
    FAILS(TREE_ERROR_INVALID, "0 joints", tree_mesh_to_glb_moving(mesh, &motion, NULL, NULL, &bytes));
    motion.joints = at;
    motion.n_joints = 1;
    motion.vertex_joints = joints;
    motion.n_vertices = n;
    motion.times = times;
    motion.n_frames = 2;
    motion.positions = places;
    motion.rotations = turns;
    motion.scales = scales;
    OK(tree_mesh_to_glb_moving(mesh, &motion, NULL, NULL, &bytes));
    CHECK(has(bytes, "\"skins\"") && has(bytes, "\"animations\"") && has(bytes, "JOINTS_0"));
    OK(tree_bytes_free(bytes));
    motion.n_vertices--;
    FAILS(TREE_ERROR_INVALID, "vertices", tree_mesh_to_glb_moving(mesh, &motion, NULL, NULL, &bytes));
    motion.n_vertices++;
    char path[4096];
    OK(tree_mesh_write_glb_moving(mesh, &motion, in_folder(path, "m.glb"), TREE_NUL_TERMINATED, NULL, NULL));
    gone("m.glb");
    free(joints);
    OK(tree_mesh_free(mesh));
}

static void reading(void) {
    tree_import_report report = {.struct_size = sizeof report};
    tree_mesh *mesh = NULL;
    const uint8_t *obj = (const uint8_t *)PYRAMID, *mtl = (const uint8_t *)RED;
    OK(tree_mesh_from_bytes(TREE_MESH_FORMAT_OBJ, obj, TREE_NUL_TERMINATED, NULL, 0, NULL, &report,
                            &mesh));
    CHECK(report.n_surfaces == 1 && report.n_triangles == 4 && report.n_nodes >= 1);
    CHECK(report.n_vertices == totals_of(mesh).n_vertices);
    CHECK(report.notes[TREE_NOTE_NORMALS_COMPUTED] == 4 && report.notes[TREE_NOTE_UVS_MISSING] == 4);
    CHECK(report.notes[TREE_NOTE_EXTERNAL_REFUSED] == 1);
    OK(tree_mesh_free(mesh));
    OK(tree_mesh_from_bytes(TREE_MESH_FORMAT_OBJ, obj, sizeof PYRAMID - 1, mtl, sizeof RED - 1, NULL,
                            &report, &mesh));
    CHECK(report.notes[TREE_NOTE_EXTERNAL_REFUSED] == 0);
    OK(tree_mesh_free(mesh));

    tree_str text;
    OK(tree_note_text(TREE_NOTE_NORMALS_COMPUTED, &text));
    CHECK(text.len == 16 && !memcmp(text.data, "normals computed", 16));
    OK(tree_note_text(TREE_N_NOTES - 1, &text));
    FAILS(TREE_ERROR_ENUM, "TREE_NOTE_", tree_note_text(TREE_N_NOTES, &text));

    FAILS(TREE_ERROR_ENUM, "TREE_MESH_FORMAT_",
          tree_mesh_from_bytes(TREE_MESH_FORMAT_BY_NAME, obj, 5, NULL, 0, NULL, NULL, &mesh));
    FAILS(TREE_ERROR_PARAMETER, "mtl",
          tree_mesh_from_bytes(TREE_MESH_FORMAT_PLY, obj, 5, mtl, 5, NULL, NULL, &mesh));
    FAILS(TREE_ERROR_FORMAT, "PLY",
          tree_mesh_from_bytes(TREE_MESH_FORMAT_PLY, obj, 5, NULL, 0, NULL, NULL, &mesh));
    FAILS(TREE_ERROR_NULL, "data",
          tree_mesh_from_bytes(TREE_MESH_FORMAT_OBJ, NULL, 5, NULL, 0, NULL, NULL, &mesh));
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.input_bytes = 10;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "input_bytes",
          tree_mesh_from_bytes(TREE_MESH_FORMAT_OBJ, obj, 50, NULL, 0, &control, NULL, &mesh));
    CHECK(mesh == NULL);
    FAILS(TREE_ERROR_FORMAT, "extension", tree_mesh_read("a.stl", 5, NULL, NULL, NULL, &mesh));
    FAILS(TREE_ERROR_IO, "no_such", tree_mesh_read("no_such.obj", 11, NULL, NULL, NULL, &mesh));
    FAILS(TREE_ERROR_TEXT, "path", tree_mesh_read("", 0, NULL, NULL, NULL, &mesh));
}

static void glb(const tree_mesh *mesh) {
    tree_mesh_totals totals = totals_of(mesh);
    tree_glb_options options;
    OK(tree_glb_options_init(&options, sizeof options));
    CHECK(options.occlusion == TREE_GLTF_OCCLUSION_ATTRIBUTE && !options.quantize);
    tree_bytes *plain = NULL, *small = NULL;
    OK(tree_mesh_to_glb(mesh, NULL, NULL, &plain));
    CHECK(has(plain, "\"tree\""));
    options.quantize = 1;
    options.name = (tree_str){"birch", TREE_NUL_TERMINATED};
    options.translucency = 1;
    OK(tree_mesh_to_glb(mesh, &options, NULL, &small));
    CHECK(has(small, "\"birch\"") && has(small, "KHR_mesh_quantization"));
    CHECK(has(small, "KHR_materials_diffuse_transmission") && size_of(small) < size_of(plain));
    tree_import_report report = {.struct_size = sizeof report};
    tree_mesh *read = back(TREE_MESH_FORMAT_GLTF, plain, &report);
    CHECK(report.n_triangles == totals.n_triangles && report.n_surfaces == 2);
    OK(tree_mesh_free(read));
    OK(tree_bytes_free(small));
    options.occlusion = 3;
    FAILS(TREE_ERROR_ENUM, "TREE_GLTF_OCCLUSION_", tree_mesh_to_glb(mesh, &options, NULL, &small));
    CHECK(small == NULL);

    char path[4096];
    OK(tree_mesh_write_glb(mesh, in_folder(path, "a.glb"), TREE_NUL_TERMINATED, NULL, NULL));
    OK(tree_mesh_read(path, TREE_NUL_TERMINATED, NULL, NULL, &report, &read));
    CHECK(report.n_triangles == totals.n_triangles);
    OK(tree_mesh_free(read));
    /* Whatever it is called. */
    tree_import_options how;
    OK(tree_import_options_init(&how, sizeof how));
    CHECK(how.external == 0 && how.format == TREE_MESH_FORMAT_BY_NAME);
    how.format = TREE_MESH_FORMAT_OBJ;
    FAILS(TREE_ERROR_FORMAT, "OBJ", tree_mesh_read(path, strlen(path), &how, NULL, NULL, &read));
    how.format = TREE_MESH_FORMAT_GLTF;
    OK(tree_mesh_read(path, strlen(path), &how, NULL, NULL, &read));
    OK(tree_mesh_free(read));
    how.format = 4;
    FAILS(TREE_ERROR_ENUM, "options.format", tree_mesh_read(path, strlen(path), &how, NULL, NULL, &read));
    gone("a.glb");
    FAILS(TREE_ERROR_IO, "nowhere", tree_mesh_write_glb(mesh, "/nowhere/a.glb", 14, NULL, NULL));
}

/* Levels, instances and columns of one's own. */
static void levels(const tree_mesh *mesh) {
    tree_mesh *pyramid = NULL;
    OK(tree_mesh_from_bytes(TREE_MESH_FORMAT_OBJ, (const uint8_t *)PYRAMID, TREE_NUL_TERMINATED, NULL,
                            0, NULL, NULL, &pyramid));
    size_t n = totals_of(pyramid).n_vertices;
    float *values = calloc(n, sizeof *values);
    tree_gltf_attribute own = {
        .struct_size = sizeof own,
        .name = {"_OWN", 4},
        .components = 1,
        .values = values,
        .n_values = n,
    };
    static const float places[] = {1, 0, 0, 2, 0, 0}, turns[] = {0, 0, 0, 1, 0, 1, 0, 0};
    static const float sizes[] = {1, 1, 1, 2, 2, 2};
    tree_gltf_instances twice = {
        .struct_size = sizeof twice,
        .name = {"cone", 4},
        .mesh = pyramid,
        .n = 2,
        .translations = places,
        .rotations = turns,
        .scales = sizes,
    };
    tree_gltf_level rows[2] = {
        {.struct_size = sizeof rows[0], .mesh = mesh, .instances = &twice, .n_instances = 1, .coverage = 0.5f},
        {.struct_size = sizeof rows[0], .mesh = pyramid, .attributes = &own, .n_attributes = 1, .coverage = 0.1f},
    };
    tree_bytes *bytes = NULL;
    OK(tree_gltf_to_glb(rows, 2, NULL, NULL, &bytes));
    CHECK(has(bytes, "MSFT_lod") && has(bytes, "EXT_mesh_gpu_instancing") && has(bytes, "_OWN"));
    OK(tree_bytes_free(bytes));
    /* Instances alone. */
    rows[0].mesh = NULL;
    OK(tree_gltf_to_glb(rows, 1, NULL, NULL, &bytes));
    tree_import_report report = {.struct_size = sizeof report};
    tree_mesh *read = back(TREE_MESH_FORMAT_GLTF, bytes, &report);
    CHECK(report.n_instances == 2 && report.n_triangles == 8);
    OK(tree_mesh_free(read));
    char path[4096];
    OK(tree_gltf_write_glb(rows, 1, in_folder(path, "b.glb"), TREE_NUL_TERMINATED, NULL, NULL));
    gone("b.glb");

    OK(tree_gltf_write_files(rows + 1, 1, in_folder(path, "c.gltf"), TREE_NUL_TERMINATED, NULL, NULL));
    FAILS(TREE_ERROR_FORMAT, "tree_test_c.bin",
          tree_mesh_read(path, TREE_NUL_TERMINATED, NULL, NULL, NULL, &read));
    tree_import_options how;
    OK(tree_import_options_init(&how, sizeof how));
    how.external = 1;
    OK(tree_mesh_read(path, TREE_NUL_TERMINATED, &how, NULL, &report, &read));
    CHECK(report.n_triangles == 4);
    OK(tree_mesh_free(read));
    gone("c.gltf");
    gone("c.bin");

    /* What one row may be, many may not: each is a copy. */
    tree_gltf_instances four[4] = {twice, twice, twice, twice};
    tree_gltf_level level = {.struct_size = sizeof level, .instances = four, .n_instances = 4};
    tree_limits limits;
    tree_control few;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&few, sizeof few));
    few.limits = &limits;
    limits.leaves = 8;
    limits.triangles = 16;
    OK(tree_gltf_to_glb(&level, 1, NULL, &few, &bytes));
    OK(tree_bytes_free(bytes));
    tree_gltf_level both[2] = {level, level};
    both[1].n_instances = 1;
    FAILS(TREE_ERROR_LIMIT, "leaves", tree_gltf_to_glb(both, 2, NULL, &few, &bytes));
    limits.leaves = 10;
    FAILS(TREE_ERROR_LIMIT, "triangles", tree_gltf_to_glb(both, 2, NULL, &few, &bytes));
    tree_gltf_attribute many[32];
    for (int i = 0; i < 32; i++) {
        many[i] = own;
    }
    level = (tree_gltf_level){.struct_size = sizeof level, .mesh = pyramid, .attributes = many, .n_attributes = 32};
    limits.triangles = n;
    FAILS(TREE_ERROR_LIMIT, "triangles", tree_gltf_to_glb(&level, 1, NULL, &few, &bytes));

    own.components = 2;
    FAILS(TREE_ERROR_INVALID, "_OWN", tree_gltf_to_glb(rows + 1, 1, NULL, NULL, &bytes));
    own.components = 1;
    own.n_values = (size_t)1 << 60;
    FAILS(TREE_ERROR_LIMIT, "triangles", tree_gltf_to_glb(rows + 1, 1, NULL, NULL, &bytes));
    twice.rotations = NULL;
    FAILS(TREE_ERROR_NULL, "levels[0].instances[0].rotations",
          tree_gltf_to_glb(rows, 1, NULL, NULL, &bytes));
    twice.n = (size_t)1 << 60;
    FAILS(TREE_ERROR_LIMIT, "leaves", tree_gltf_to_glb(rows, 1, NULL, NULL, &bytes));
    rows[0].n_instances = 0;
    FAILS(TREE_ERROR_NULL, "levels[0].mesh", tree_gltf_to_glb(rows, 1, NULL, NULL, &bytes));
    rows[0].mesh = rows[1].mesh = mesh;
    rows[0].coverage = 0.05f;
    rows[1].n_attributes = 0;
    FAILS(TREE_ERROR_PARAMETER, "coverage", tree_gltf_to_glb(rows, 2, NULL, NULL, &bytes));
    FAILS(TREE_ERROR_NO_RESULT, "triangles", tree_gltf_to_glb(NULL, 0, NULL, NULL, &bytes));
    CHECK(bytes == NULL);
    free(values);
    OK(tree_mesh_free(pyramid));
}

static void wind(const tree_mesh *mesh) {
    tree_gltf_attributes *wind = NULL;
    OK(tree_mesh_gltf_wind(mesh, NULL, &wind));
    tree_gltf_level level = {.struct_size = sizeof level, .mesh = mesh};
    OK(tree_gltf_attributes_view(wind, &level.attributes, &level.n_attributes));
    CHECK(level.n_attributes == 12 && level.attributes[6].surface == 1);
    CHECK(level.attributes[0].components == 4 && !memcmp(level.attributes[0].name.data, "_WIND_PIVOT", 11));
    tree_glb_options options;
    OK(tree_glb_options_init(&options, sizeof options));
    options.occlusion = TREE_GLTF_OCCLUSION_OMIT;
    tree_bytes *bytes = NULL;
    OK(tree_gltf_to_glb(&level, 1, &options, NULL, &bytes));
    CHECK(has(bytes, "_WIND_LEAF"));
    OK(tree_bytes_free(bytes));
    OK(tree_gltf_attributes_free(wind));
}

/* Progress that only rises. */
static int32_t rises(void *user, const char *stage, float fraction) {
    (void)stage;
    float *last = user;
    CHECK(fraction >= *last && fraction <= 1);
    *last = fraction;
    return 0;
}

static void instanced(void) {
    tree_tree *tree = an_oak_twig();
    tree_look *look = NULL;
    OK(tree_look_plain(NULL, &look));
    tree_mesh *bark = NULL;
    tree_gltf_leaves *leaves = NULL;
    float last = 0;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.progress = rises;
    control.user = &last;
    size_t before = tree_live_objects();
    OK(tree_mesh_build_instanced(tree, look, NULL, &control, &bark, &leaves));
    CHECK(last == 1 && tree_live_objects() == before + 2);
    tree_gltf_level level = {.struct_size = sizeof level, .mesh = bark};
    OK(tree_gltf_leaves_view(leaves, &level.instances, &level.n_instances));
    CHECK(level.n_instances == 1 && level.instances[0].n == 3);
    CHECK(level.instances[0].translations[1] == 2.5f && level.instances[0].scales[0] == 0.1f);
    /* The meshes are the leaves' own. */
    FAILS(TREE_ERROR_ORDER, "tree_gltf_leaves", tree_mesh_free((tree_mesh *)level.instances[0].mesh));
    CHECK(totals_of(level.instances[0].mesh).n_triangles > 0);
    tree_bytes *bytes = NULL;
    OK(tree_gltf_to_glb(&level, 1, NULL, NULL, &bytes));
    tree_import_report report = {.struct_size = sizeof report};
    tree_mesh *read = back(TREE_MESH_FORMAT_GLTF, bytes, &report);
    CHECK(report.n_instances == 3);
    OK(tree_mesh_free(read));
    const tree_mesh *leaf = level.instances[0].mesh;
    OK(tree_gltf_leaves_free(leaves));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_mesh_check(leaf));
    /* Both places are NULL, though the first is an error. */
    FAILS(TREE_ERROR_NULL, "bark", tree_mesh_build_instanced(tree, look, NULL, NULL, NULL, &leaves));
    CHECK(leaves == NULL);
    OK(tree_mesh_free(bark));
    tree_mesh_params params;
    OK(tree_mesh_params_init(&params, sizeof params));
    params.min_sides = 99;
    FAILS(TREE_ERROR_PARAMETER, "min_sides",
          tree_mesh_build_instanced(tree, look, &params, NULL, &bark, &leaves));
    CHECK(bark == NULL && leaves == NULL);
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
}

static void obj_and_ply(const tree_mesh *mesh) {
    size_t n = totals_of(mesh).n_triangles;
    tree_import_report report = {.struct_size = sizeof report};
    tree_mesh *read = NULL;
    tree_bytes *obj = NULL, *mtl = NULL, *binary = NULL, *text = NULL;
    OK(tree_mesh_to_obj(mesh, "oak", 3, NULL, &obj, &mtl));
    CHECK(has(obj, "mtllib oak.mtl") && has(mtl, "newmtl"));
    OK(tree_bytes_free(mtl));
    FAILS(TREE_ERROR_NULL, "obj", tree_mesh_to_obj(mesh, "oak", 3, NULL, NULL, &mtl));
    CHECK(mtl == NULL);
    OK(tree_mesh_free(back(TREE_MESH_FORMAT_OBJ, obj, &report)));
    CHECK(report.n_triangles == n);
    char path[4096];
    OK(tree_mesh_write_obj(mesh, in_folder(path, "d.obj"), TREE_NUL_TERMINATED, NULL));
    tree_import_options how;
    OK(tree_import_options_init(&how, sizeof how));
    how.external = 1;
    OK(tree_mesh_read(path, TREE_NUL_TERMINATED, &how, NULL, &report, &read));
    CHECK(report.n_triangles == n && report.notes[TREE_NOTE_MATERIAL_UNKNOWN] == 0);
    OK(tree_mesh_free(read));
    gone("d.obj");
    gone("d.mtl");

    OK(tree_mesh_to_ply(mesh, NULL, NULL, &binary));
    tree_ply_options options;
    OK(tree_ply_options_init(&options, sizeof options));
    CHECK(options.ascii == 0);
    options.ascii = 1;
    OK(tree_mesh_to_ply(mesh, &options, NULL, &text));
    CHECK(has(text, "format ascii 1.0") && size_of(text) > size_of(binary));
    OK(tree_bytes_free(text));
    OK(tree_mesh_free(back(TREE_MESH_FORMAT_PLY, binary, &report)));
    CHECK(report.n_triangles == n && report.n_nodes == 1);
    OK(tree_mesh_write_ply(mesh, in_folder(path, "e.ply"), TREE_NUL_TERMINATED, &options, NULL));
    OK(tree_mesh_read(path, TREE_NUL_TERMINATED, NULL, NULL, &report, &read));
    CHECK(report.n_triangles == n);
    OK(tree_mesh_free(read));
    gone("e.ply");

    tree_cancel *cancel = NULL;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_mesh_to_ply(mesh, NULL, &control, &binary));
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_mesh_to_obj(mesh, "oak", 3, &control, &obj, &mtl));
    CHECK(binary == NULL && obj == NULL && mtl == NULL);
    OK(tree_cancel_free(cancel));
}

void test_io(void) {
    moving();
    tree_mesh *mesh = a_leafy_mesh();
    reading();
    glb(mesh);
    levels(mesh);
    wind(mesh);
    instanced();
    obj_and_ply(mesh);
    OK(tree_mesh_free(mesh));
}
