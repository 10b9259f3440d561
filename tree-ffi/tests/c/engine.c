#include "check.h"
#include <math.h>

/* The oak twig with six-sided bark and plain leaves, tangents and light map. Also for io.c and preview.c.
 * Free it with tree_mesh_free. */
tree_mesh *a_leafy_mesh(void);
tree_mesh *a_leafy_mesh(void) {
    tree_tree *tree = an_oak_twig();
    tree_look *look = NULL;
    OK(tree_look_plain(NULL, &look));
    tree_mesh_params params;
    OK(tree_mesh_params_init(&params, sizeof params));
    params.max_sides = 6;
    params.error = 0.02f;
    params.tangents = params.lightmap = 1;
    tree_mesh *mesh = NULL;
    OK(tree_mesh_build(tree, look, &params, NULL, NULL, &mesh));
    OK(tree_look_free(look));
    OK(tree_tree_free(tree));
    return mesh;
}

static tree_surface surface_of(const tree_mesh *mesh, size_t number) {
    tree_surface surface = {.struct_size = sizeof surface};
    OK(tree_mesh_surface(mesh, number, &surface));
    return surface;
}

static int near(float a, float b, float most) { return fabsf(a - b) <= most; }

static void conventions(void) {
    tree_convention_traits traits = {.struct_size = sizeof traits};
    OK(tree_convention_view(TREE_CONVENTION_UNREAL, &traits));
    CHECK(traits.unit == 100 && traits.is_left_handed && !traits.is_clockwise && !traits.is_v_up);
    OK(tree_convention_view(TREE_CONVENTION_UNITY, &traits));
    CHECK(traits.unit == 1 && traits.is_left_handed && traits.is_clockwise && traits.is_v_up);
    FAILS(TREE_ERROR_ENUM, "TREE_CONVENTION_", tree_convention_view(5, &traits));

    const float from[] = {1, 2, 3, 4, 5, 6};
    float to[8];
    OK(tree_convert_positions(TREE_CONVENTION_UNREAL, TREE_CONVERT_TO, from, 2, to));
    CHECK(to[0] == 100 && to[1] == 300 && to[2] == 200 && to[5] == 500);
    /* In place, and back. */
    OK(tree_convert_positions(TREE_CONVENTION_UNREAL, TREE_CONVERT_BACK, to, 2, to));
    CHECK(memcmp(from, to, sizeof from) == 0);
    OK(tree_convert_directions(TREE_CONVENTION_BLENDER, TREE_CONVERT_TO, from, 2, to));
    CHECK(to[0] == 1 && to[1] == -3 && to[2] == 2);
    OK(tree_convert_directions(TREE_CONVENTION_BLENDER, TREE_CONVERT_BACK, to, 2, to));
    CHECK(memcmp(from, to, sizeof from) == 0);
    const float tangent[] = {0.6f, 0, 0.8f, 1};
    OK(tree_convert_tangents(TREE_CONVENTION_UNITY, TREE_CONVERT_TO, tangent, 1, to));
    CHECK(to[0] == -0.6f && to[2] == 0.8f && to[3] == -1);
    OK(tree_convert_tangents(TREE_CONVENTION_UNITY, TREE_CONVERT_BACK, to, 1, to));
    CHECK(memcmp(tangent, to, sizeof tangent) == 0);
    const float uv[] = {0.25f, 0.75f};
    OK(tree_convert_uvs(TREE_CONVENTION_UNITY, uv, 1, to));
    CHECK(to[0] == 0.25f && to[1] == 0.25f);
    uint32_t corners[] = {0, 1, 2, 2, 1, 3};
    OK(tree_convert_triangles(TREE_CONVENTION_GODOT, corners, 2, corners));
    CHECK(corners[0] == 0 && corners[1] == 2 && corners[2] == 1 && corners[4] == 3);

    OK(tree_convert_uvs(TREE_CONVENTION_GLTF, NULL, 0, NULL));
    FAILS(TREE_ERROR_NULL, "from", tree_convert_uvs(TREE_CONVENTION_GLTF, NULL, 1, to));
    FAILS(TREE_ERROR_NULL, "to", tree_convert_uvs(TREE_CONVENTION_GLTF, uv, 1, NULL));
    FAILS(TREE_ERROR_ENUM, "TREE_CONVERT_", tree_convert_positions(0, 2, from, 1, to));
    FAILS(TREE_ERROR_LIMIT, "triangles",
          tree_convert_triangles(TREE_CONVENTION_GODOT, corners, (size_t)1 << 60, corners));
}

static const tree_stream *stream(const tree_packed_columns *columns, const char *name) {
    for (size_t i = 0; i < columns->n_streams; i++) {
        const tree_stream *stream = &columns->streams[i];
        if (stream->name.len == strlen(name) && !memcmp(stream->name.data, name, stream->name.len)) {
            return stream;
        }
    }
    return NULL;
}

/* Packs a surface, looks at it, and reads it back. */
static void layout(const tree_mesh *mesh, size_t number, tree_layout layout, size_t vertex_bytes) {
    tree_surface surface = surface_of(mesh, number);
    tree_packed *packed = NULL;
    OK(tree_mesh_pack(mesh, number, layout, NULL, &packed));
    tree_packed_columns columns = {.struct_size = sizeof columns};
    OK(tree_packed_view(packed, &columns));
    CHECK(columns.layout == layout && columns.n_vertices == surface.n_vertices);
    CHECK(columns.vertex_bytes == vertex_bytes);
    CHECK(columns.n_indices == surface.n_indices && columns.index_bytes == 2);
    CHECK(((const uint16_t *)columns.indices)[0] == surface.indices[0]);
    static const size_t widths[] = {4, 2, 2, 1};
    size_t bytes = 0;
    for (size_t i = 0; i < columns.n_streams; i++) {
        const tree_stream *stream = &columns.streams[i];
        size_t row = stream->components * widths[stream->number];
        CHECK(stream->n_bytes == row * surface.n_vertices);
        bytes += row;
    }
    CHECK(columns.n_streams == 0 ? layout == TREE_LAYOUT_VERTEX : bytes == vertex_bytes);

    tree_unpacked *unpacked = NULL;
    OK(tree_packed_unpack(packed, mesh, &unpacked));
    tree_unpacked_columns back = {.struct_size = sizeof back};
    OK(tree_unpacked_view(unpacked, &back));
    CHECK(back.n_vertices == surface.n_vertices && back.n_indices == surface.n_indices);
    for (size_t i = 0; i < 3 * surface.n_vertices; i++) {
        CHECK(near(back.positions[i], surface.positions[i], 1e-4f));
    }
    CHECK(memcmp(back.indices, surface.indices, surface.n_indices * sizeof(uint32_t)) == 0);
    OK(tree_unpacked_free(unpacked));
    OK(tree_packed_free(packed));
}

static void layouts(const tree_mesh *mesh) {
    for (size_t surface = 0; surface < 2; surface++) {
        layout(mesh, surface, TREE_LAYOUT_SPEEDTREE8, 108);
        layout(mesh, surface, TREE_LAYOUT_SPEEDTREE9, 108);
        layout(mesh, surface, TREE_LAYOUT_TREE_CREATOR, 60);
        layout(mesh, surface, TREE_LAYOUT_PIVOT_PAINTER, 68);
        layout(mesh, surface, TREE_LAYOUT_GODOT, 124);
        layout(mesh, surface, TREE_LAYOUT_GODOT_HALF, 92);
        layout(mesh, surface, TREE_LAYOUT_GLTF_WIND, 136);
        layout(mesh, surface, TREE_LAYOUT_VERTEX, 32);
    }
    tree_packed *packed = NULL;
    FAILS(TREE_ERROR_ENUM, "TREE_LAYOUT_", tree_mesh_pack(mesh, 0, 8, NULL, &packed));
    FAILS(TREE_ERROR_INVALID, "surface", tree_mesh_pack(mesh, 9, 0, NULL, &packed));
    tree_cancel *cancel = NULL;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_mesh_pack(mesh, 0, 0, &control, &packed));
    CHECK(packed == NULL);
    OK(tree_cancel_free(cancel));
}

static void streams(const tree_mesh *mesh) {
    tree_surface leaves = surface_of(mesh, 1);
    tree_packed *packed = NULL;
    OK(tree_mesh_pack(mesh, 1, TREE_LAYOUT_SPEEDTREE9, NULL, &packed));
    tree_packed_columns columns = {.struct_size = sizeof columns};
    OK(tree_packed_view(packed, &columns));
    CHECK(columns.convention == TREE_CONVENTION_UNITY);
    CHECK(columns.stretch_limits[0] > 0 && columns.stretch_limits[1] == 0);
    const tree_stream *positions = stream(&columns, "POSITION");
    CHECK(positions && positions->number == TREE_NUMBER_F32 && positions->components == 3);
    CHECK(((const float *)positions->data)[0] == -leaves.positions[0]);
    const tree_stream *colors = stream(&columns, "COLOR");
    CHECK(colors && colors->number == TREE_NUMBER_UNORM8 && ((const uint8_t *)colors->data)[0] == 255);
    CHECK(((const uint16_t *)columns.indices)[1] == leaves.indices[2]);

    tree_pivots pivots = {.struct_size = sizeof pivots};
    FAILS(TREE_ERROR_INVALID, "PIVOT_PAINTER", tree_packed_pivots(packed, &pivots));
    tree_packed_vertices vertices = {.struct_size = sizeof vertices};
    FAILS(TREE_ERROR_INVALID, "TREE_LAYOUT_VERTEX", tree_packed_vertices_view(packed, &vertices));
    OK(tree_packed_free(packed));

    OK(tree_mesh_pack(mesh, 1, TREE_LAYOUT_GODOT_HALF, NULL, &packed));
    OK(tree_packed_view(packed, &columns));
    CHECK(stream(&columns, "CUSTOM3") && stream(&columns, "CUSTOM3")->number == TREE_NUMBER_F16);
    CHECK(columns.convention == TREE_CONVENTION_GODOT);
    OK(tree_packed_free(packed));
    OK(tree_mesh_pack(mesh, 1, TREE_LAYOUT_GLTF_WIND, NULL, &packed));
    OK(tree_packed_view(packed, &columns));
    CHECK(stream(&columns, "_WIND_BRANCH")->number == TREE_NUMBER_U16);
    OK(tree_packed_free(packed));
}

static void pivot_textures(const tree_mesh *mesh) {
    tree_packed *packed = NULL;
    OK(tree_mesh_pack(mesh, 0, TREE_LAYOUT_PIVOT_PAINTER, NULL, &packed));
    tree_pivots pivots = {.struct_size = sizeof pivots};
    OK(tree_packed_pivots(packed, &pivots));
    CHECK(pivots.n_branches == 2 && pivots.n_elements == 2 && pivots.n_merged == 0);
    CHECK(pivots.levels == 2 && pivots.kept_levels == 2);
    CHECK(pivots.width * pivots.height >= 2 && pivots.element_of[1] == 1);
    const tree_wind_branch *branches = NULL;
    size_t n = 0;
    OK(tree_mesh_branches(mesh, &branches, &n));
    CHECK(near(pivots.position_and_index[4 + 2], 100 * branches[1].pivot[1], 1e-3f));
    CHECK(pivots.position_and_index_half[3] == 1024 && pivots.position_and_index_half[7] == 1024);
    CHECK(pivots.axis_and_extent[7] > 0);
    tree_pivot_element element = {.struct_size = sizeof element};
    OK(tree_packed_pivot_element(packed, 1, &element));
    CHECK(element.parent == 0 && near(element.pivot[1], branches[1].pivot[1], 1e-4f));
    CHECK(near(element.extent, branches[1].length, 0.05f) && near(element.axis[1], branches[1].axis[1], 0.01f));
    FAILS(TREE_ERROR_PARAMETER, "2 elements", tree_packed_pivot_element(packed, 2, &element));
    tree_unpacked *unpacked = NULL;
    OK(tree_packed_unpack(packed, NULL, &unpacked));
    tree_unpacked_columns back = {.struct_size = sizeof back};
    OK(tree_unpacked_view(unpacked, &back));
    CHECK(back.parents && back.parents[0] == 0 && !back.stiffness && !back.is_leaf);
    OK(tree_unpacked_free(unpacked));
    OK(tree_packed_free(packed));
}

/* The normal and the tangent of a vertex, by the words of the header alone. */
static void unpack(const tree_packed_vertex *vertex, float n[3], float t[3]) {
    float x = (float)vertex->normal[0] / 32767, y = (float)vertex->normal[1] / 32767;
    float z = 1 - fabsf(x) - fabsf(y);
    if (z < 0) {
        float old = x;
        x = copysignf(1 - fabsf(y), x);
        y = copysignf(1 - fabsf(old), y);
    }
    float length = sqrtf(x * x + y * y + z * z);
    n[0] = x / length;
    n[1] = y / length;
    n[2] = z / length;
    float s = copysignf(1, n[2]), a = -1 / (s + n[2]), b = n[0] * n[1] * a;
    const float e[3] = {b, s + n[1] * n[1] * a, -n[1]};
    float turn = (float)(vertex->tangent & 0x7FFF) * 6.2831853f / 32768;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        t[i] = cosf(turn) * e[i] + sinf(turn) * (n[j] * e[k] - n[k] * e[j]);
    }
}

static void directions(const tree_mesh *mesh) {
    tree_surface bark = surface_of(mesh, 0);
    tree_packed *packed = NULL;
    OK(tree_mesh_pack(mesh, 0, TREE_LAYOUT_VERTEX, NULL, &packed));
    tree_packed_vertices view = {.struct_size = sizeof view};
    OK(tree_packed_vertices_view(packed, &view));
    CHECK(view.n_anchors == 0 && view.anchors == NULL && view.n_vertices == bark.n_vertices);
    for (size_t i = 0; i < view.n_vertices; i++) {
        float normal[3], tangent[3];
        unpack(&view.vertices[i], normal, tangent);
        for (size_t axis = 0; axis < 3; axis++) {
            CHECK(near(normal[axis], bark.normals[3 * i + axis], 5e-4f));
            CHECK(near(tangent[axis], bark.tangents[4 * i + axis], 2e-3f));
        }
        CHECK((view.vertices[i].tangent >= 0x8000) == (bark.tangents[4 * i + 3] < 0));
    }
    OK(tree_packed_free(packed));
}

static void vertices(const tree_mesh *mesh) {
    tree_surface leaves = surface_of(mesh, 1);
    tree_packed *packed = NULL;
    OK(tree_mesh_pack(mesh, 1, TREE_LAYOUT_VERTEX, NULL, &packed));
    tree_packed_vertices view = {.struct_size = sizeof view};
    OK(tree_packed_vertices_view(packed, &view));
    CHECK(sizeof(tree_packed_vertex) == 32 && view.n_vertices == leaves.n_vertices);
    CHECK(view.n_anchors == 3 && view.anchors[1] == leaves.anchors[1]);
    for (size_t i = 0; i < view.n_vertices; i++) {
        const tree_packed_vertex *vertex = &view.vertices[i];
        for (int axis = 0; axis < 3; axis++) {
            float wide = view.bounds[3 + axis] - view.bounds[axis];
            float at = view.bounds[axis] + wide * (float)vertex->position[axis] / 65535.0f;
            CHECK(near(at, leaves.positions[3 * i + (size_t)axis], 1e-4f));
        }
        float u = view.uv_range[0] + (view.uv_range[2] - view.uv_range[0]) * (float)vertex->uv[0] / 65535.0f;
        CHECK(near(u, leaves.uvs[2 * i], 1e-4f));
        CHECK(vertex->branch == leaves.branches[i] && vertex->occlusion == 255);
    }
    tree_unpacked *unpacked = NULL;
    FAILS(TREE_ERROR_NULL, "mesh", tree_packed_unpack(packed, NULL, &unpacked));
    OK(tree_packed_unpack(packed, mesh, &unpacked));
    tree_unpacked_columns back = {.struct_size = sizeof back};
    OK(tree_unpacked_view(unpacked, &back));
    CHECK(back.is_leaf[0] == 1 && near(back.anchors[1], leaves.anchors[1], 1e-6f));
    CHECK(back.tangents && back.uvs2 && back.axes && !back.weights && !back.directions);
    OK(tree_unpacked_free(unpacked));
    OK(tree_packed_free(packed));
}

static void wind(const tree_mesh *mesh) {
    tree_surface leaves = surface_of(mesh, 1);
    size_t n = leaves.n_vertices;
    tree_vertex_wind *rows = calloc(n, sizeof *rows);
    float *moved = calloc(3 * n, sizeof *moved);
    OK(tree_mesh_wind(mesh, 1, rows, n));
    float phase = -1, sway = -1;
    OK(tree_wind_leaf_phase(1, &phase));
    CHECK(rows[n / 3].leaf_phase == phase && phase > 0 && phase < 1);
    CHECK(rows[0].branch == leaves.branches[0] && rows[0].anchor[1] == leaves.anchors[1]);
    CHECK(rows[0].reach > 0 && rows[0].reach <= 1);
    OK(tree_wind_sway(1, &sway));
    CHECK(sway == 1);
    FAILS(TREE_ERROR_BUFFER, "room", tree_mesh_wind(mesh, 1, rows, n - 1));
    FAILS(TREE_ERROR_INVALID, "surface", tree_mesh_wind(mesh, 5, rows, n));

    tree_wind wind;
    OK(tree_wind_init(&wind, sizeof wind));
    CHECK(wind.direction[0] == 1 && wind.strength == 0.5f && wind.gusts == 0.4f && wind.flutter == 0.3f);
    wind.strength = wind.flutter = 0;
    OK(tree_mesh_bend(mesh, &wind, 1, 1, moved, 3 * n));
    for (size_t i = 0; i < 3 * n; i++) {
        CHECK(near(moved[i], leaves.positions[i], 1e-5f));
    }
    OK(tree_mesh_bend(mesh, NULL, 1, 1, moved, 3 * n));
    CHECK(moved[0] > leaves.positions[0]);
    FAILS(TREE_ERROR_BUFFER, "room", tree_mesh_bend(mesh, NULL, 1, 1, moved, 3 * n - 1));
    FAILS(TREE_ERROR_PARAMETER, "seconds", tree_mesh_bend(mesh, NULL, NAN, 1, moved, 3 * n));
    wind.gusts = NAN;
    FAILS(TREE_ERROR_PARAMETER, "gusts", tree_mesh_bend(mesh, &wind, 1, 1, moved, 3 * n));
    free(rows);
    free(moved);
}

static void branches(const tree_mesh *mesh) {
    const tree_wind_branch *table = NULL;
    size_t n = 0;
    OK(tree_mesh_branches(mesh, &table, &n));
    tree_branch_motion motion = {.struct_size = sizeof motion};
    OK(tree_mesh_branch_motion(mesh, 1, &motion));
    CHECK(motion.give == 1 - table[1].stiffness && motion.frequency > 0);
    const float *axis = table[1].axis, *swing = motion.swing;
    CHECK(near(axis[0] * swing[0] + axis[1] * swing[1] + axis[2] * swing[2], 0, 1e-5f));
    float reach = -1;
    OK(tree_mesh_branch_reach(mesh, 1, table[1].pivot, &reach));
    CHECK(reach == 0);
    const float far[] = {9, 9, 9};
    OK(tree_mesh_branch_reach(mesh, 1, far, &reach));
    CHECK(reach == 1);
    FAILS(TREE_ERROR_PARAMETER, "has 2", tree_mesh_branch_motion(mesh, 2, &motion));

    tree_skeleton *fork = a_fork();
    tree_wind_branches *own = NULL;
    OK(tree_skeleton_wind_branches(fork, TREE_CONTINUATION_LONGEST, &own));
    const tree_wind_branch *rows = NULL;
    OK(tree_wind_branches_view(own, &rows, &n));
    CHECK(n == 2 && rows[1].parent == 0 && rows[1].level == 1 && rows[1].pivot[1] == 1.0f);
    OK(tree_wind_branches_free(own));
    FAILS(TREE_ERROR_ENUM, "TREE_CONTINUATION_", tree_skeleton_wind_branches(fork, 3, &own));
    OK(tree_skeleton_free(fork));
}

static void capsules(void) {
    tree_skeleton *fork = a_fork();
    tree_capsule_params params;
    OK(tree_capsule_params_init(&params, sizeof params));
    CHECK(params.max_count == 32 && params.min_radius == 0.05f && params.share == 0.95f);
    params.max_count = 3;
    tree_capsule_report report = {.struct_size = sizeof report};
    tree_capsules *capsules = NULL;
    OK(tree_skeleton_capsules(fork, &params, NULL, &report, &capsules));
    const tree_capsule *rows = NULL;
    size_t n = 0;
    OK(tree_capsules_view(capsules, &rows, &n));
    CHECK(n >= 1 && n <= 3 && report.n_capsules == n);
    uint32_t inside = 9;
    double volume = 0;
    OK(tree_capsule_contains(&rows[0], rows[0].a, &inside));
    CHECK(inside == 1);
    const float far[] = {9, 9, 9};
    OK(tree_capsule_contains(&rows[0], far, &inside));
    CHECK(inside == 0);
    OK(tree_capsule_volume(&rows[0], &volume));
    CHECK(n > 1 || fabs(volume - report.bulk * report.volume * report.held) < 1e-6);
    FAILS(TREE_ERROR_NULL, "capsule", tree_capsule_volume(NULL, &volume));
    CHECK(rows[0].radius >= 0.08f && report.is_enough && report.held >= 0.95 && report.bulk >= 1);
    CHECK(report.min_radius == 0.05f && report.volume > 0);
    OK(tree_capsules_free(capsules));
    params.share = 2;
    FAILS(TREE_ERROR_PARAMETER, "share", tree_skeleton_capsules(fork, &params, NULL, NULL, &capsules));
    params.continuation = 9;
    FAILS(TREE_ERROR_ENUM, "TREE_CONTINUATION_",
          tree_skeleton_capsules(fork, &params, NULL, NULL, &capsules));
    CHECK(capsules == NULL);
    OK(tree_skeleton_free(fork));
}

void test_engine(void) {
    tree_mesh *mesh = a_leafy_mesh();
    conventions();
    layouts(mesh);
    streams(mesh);
    pivot_textures(mesh);
    vertices(mesh);
    directions(mesh);
    wind(mesh);
    branches(mesh);
    capsules();
    OK(tree_mesh_free(mesh));
}
