#include "crown.h"
#include <math.h>

static float tips[3 * TIPS];

tree_skeleton *a_forked_tree(void) {
    static float positions[3 * NODES], radii[NODES];
    static uint32_t parents[NODES];
    positions[4] = 2;
    parents[0] = TREE_NO_PARENT;
    for (int i = 0; i < NODES; i++) radii[i] = i < 2 ? 0.15f : 0.05f;
    for (int i = 0; i < 3; i++) {
        float turn = 2.1f * (float)i + 0.4f, *limb = positions + 3 * (2 + 4 * i);
        limb[0] = 2 * sinf(turn), limb[1] = 3, limb[2] = 2 * cosf(turn);
        parents[2 + 4 * i] = 1;
        for (int k = 0; k < 3; k++) {
            float angle = 2.1f * (float)k + (float)i, *tip = limb + 3 * (k + 1);
            tip[0] = 3 * sinf(turn) + sinf(angle);
            tip[1] = 3.8f + 0.3f * cosf(angle);
            tip[2] = 3 * cosf(turn) + cosf(angle);
            parents[3 + 4 * i + k] = (uint32_t)(2 + 4 * i);
            memcpy(tips + 3 * (3 * i + k), tip, 3 * sizeof(float));
        }
    }
    tree_skeleton_columns columns = {sizeof columns, NODES, positions, radii, parents};
    tree_skeleton *skeleton = NULL;
    OK(tree_skeleton_from_columns(&columns, NULL, &skeleton));
    return skeleton;
}

tree_mesh *leaves_at_tips(void) {
    static float positions[12 * LEAVES], normals[12 * LEAVES];
    static const float uvs[8 * LEAVES];
    static uint32_t indices[6 * LEAVES];
    static const int corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const uint32_t quad[] = {0, 1, 2, 0, 2, 3};
    for (int i = 0; i < LEAVES; i++) {
        float y = 1 - (2 * (float)(i % PER_TIP) + 1) / PER_TIP, ring = sqrtf(1 - y * y);
        float turn = 2.3999632f * (float)i, s = sinf(turn), c = cosf(turn);
        float normal[3] = {ring * s, y, ring * c}, along[3] = {c, 0, -s}, up[3] = {-y * s, ring, -y * c};
        for (int k = 0; k < 4; k++)
            for (int axis = 0; axis < 3; axis++) {
                int at = 3 * (4 * i + k) + axis;
                float side = (float)corners[k][0] * along[axis] + (float)corners[k][1] * up[axis];
                positions[at] = tips[3 * (i / PER_TIP) + axis] + 0.4f * normal[axis] + 0.15f * side;
                normals[at] = normal[axis];
            }
        for (int k = 0; k < 6; k++) indices[6 * i + k] = (uint32_t)(4 * i) + quad[k];
    }
    tree_surface surface = {.struct_size = sizeof surface, .n_vertices = 4 * LEAVES,
                            .n_indices = 6 * LEAVES, .positions = positions, .normals = normals,
                            .uvs = uvs, .indices = indices};
    tree_material material;
    OK(tree_material_init(&material, sizeof material));
    material.name = (tree_str){"leaves", 6};
    material.base_color[1] = 0.5f;
    material.double_sided = 1;
    tree_mesh *mesh = NULL;
    OK(tree_mesh_from_surfaces(&surface, 1, &material, 1, NULL, 0, NULL, &mesh));
    return mesh;
}

tree_tree *a_leafy_tree(void) {
    static uint32_t nodes[LEAVES];
    static float positions[3 * LEAVES], rotations[4 * LEAVES], sizes[LEAVES];
    static const uint16_t kinds[LEAVES];
    tree_skeleton *skeleton = a_forked_tree();
    for (int i = 0; i < LEAVES; i++) {
        int tip = i / PER_TIP;
        float turn = 2.3999632f * (float)i;
        nodes[i] = (uint32_t)(3 + 4 * (tip / 3) + tip % 3);
        memcpy(positions + 3 * i, tips + 3 * tip, 3 * sizeof(float));
        rotations[4 * i + 1] = sinf(0.5f * turn);
        rotations[4 * i + 3] = cosf(0.5f * turn);
        sizes[i] = 0.4f;
    }
    tree_foliage foliage = {sizeof foliage, LEAVES, nodes, positions, rotations, sizes, kinds};
    tree_tree *tree = NULL;
    OK(tree_tree_new(skeleton, &foliage, NULL, NULL, &tree));
    OK(tree_skeleton_free(skeleton));
    return tree;
}

tree_view from_the_side(uint32_t camera) {
    tree_view view;
    OK(tree_view_init(&view, sizeof view));
    view.width = view.height = 32;
    view.camera = camera;
    view.lens = TREE_LENS_ORTHOGRAPHIC;
    view.lens_height = 10;
    view.eye[0] = 40;
    view.eye[1] = view.target[1] = 3.8f;
    return view;
}

int n_covered(const tree_picture *picture) {
    tree_pixels pixels = {.struct_size = sizeof pixels};
    int n = 0;
    OK(tree_picture_view(picture, &pixels));
    for (size_t i = 3; i < pixels.n_bytes; i += 4) n += pixels.pixels[i] >= 128;
    return n;
}
