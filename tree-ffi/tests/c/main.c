/* Every function of the interface, from C: `cargo test -p tree-ffi` compiles and runs this. */
#include "check.h"

int n_failures = 0;

tree_skeleton *a_fork(void) {
    static const float positions[] = {0, 0, 0, 0, 1, 0, 0.5f, 2.5f, 0, -0.5f, 2, 0};
    static const float radii[] = {0.1f, 0.08f, 0.01f, 0.01f};
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 1, 1};
    tree_skeleton_columns columns = {sizeof columns, 4, positions, radii, parents};
    tree_skeleton *skeleton = NULL;
    OK(tree_skeleton_from_columns(&columns, NULL, &skeleton));
    return skeleton;
}

tree_tree *an_oak_twig(void) {
    static const uint32_t nodes[] = {2, 3, 3};
    static const float positions[] = {0.5f, 2.5f, 0, -0.5f, 2, 0, -0.4f, 1.8f, 0};
    static const float rotations[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.6f, 0, 0.8f};
    static const float sizes[] = {0.1f, 0.12f, 0.09f};
    static const uint16_t kinds[] = {0, 0, 0};
    tree_foliage foliage = {sizeof foliage, 3, nodes, positions, rotations, sizes, kinds};
    tree_skeleton *skeleton = a_fork();
    tree_tree *tree = NULL;
    OK(tree_tree_new(skeleton, &foliage, NULL, NULL, &tree));
    OK(tree_skeleton_free(skeleton));
    return tree;
}

int main(void) {
    CHECK(tree_abi_version() == TREE_ABI_VERSION);
    size_t before = tree_live_objects();
    test_border();
    test_skeleton();
    test_foliage();
    test_volume();
    test_path();
    test_skeletonize();
    test_scan();
    test_distance();
    test_growth();
    test_plastic();
    test_particle();
    test_look();
    test_mesh();
    test_instance();
    test_engine();
    test_io();
    test_sketch();
    test_preview();
    test_photo();
    test_sketch_in();
    test_silhouette();
    test_silhouette_in();
    test_lod();
    test_lod_select();
    test_prune();
    test_multires_chain();
    test_multires();
    test_lsystem();
    test_impostor();
    test_octahedral();
    test_hybrid();
    test_threads();
    /* Presets stay. */
    CHECK(tree_live_objects() <= before);
    printf(n_failures ? "%d failures\n" : "all is well\n", n_failures);
    return n_failures != 0;
}
