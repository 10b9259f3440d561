/* A photograph becomes a tree, a wall bends it, and what comes is meshed and pruned: all in C, with the bits that Rust gets. Prints the hash
   of a level's positions and indices. */
#include "../c/check.h"

int n_failures = 0;

enum { W = 60, H = 80, N = W * H };

/* FNV-1a. */
static uint64_t fnv1a(uint64_t hash, const void *data, size_t n_bytes) {
    const uint8_t *bytes = data;
    for (size_t i = 0; i < n_bytes; i++) hash = (hash ^ bytes[i]) * 0x100000001b3u;
    return hash;
}

/* A round crown on a trunk that ends above the picture's bottom. */
static tree_matte *photographed(void) {
    static float alpha[N];
    for (int i = 0; i < N; i++) {
        float x = (float)(i % W) + 0.5f, y = (float)(i / W) + 0.5f;
        int crown = (x - 30) * (x - 30) + (y - 28) * (y - 28) < 22 * 22;
        alpha[i] = crown || (x >= 28 && x < 32 && y >= 28 && y < 74);
    }
    tree_matte *matte = NULL;
    OK(tree_matte_from_alpha(W, H, alpha, N, NULL, &matte));
    return matte;
}

static tree_tree *modelled(const tree_matte *matte) {
    tree_density_params density;
    tree_flow_params flow;
    tree_field_params field;
    tree_livewire_params livewire;
    tree_photo_params params;
    tree_photo_shot shot;
    tree_photo_session *session = NULL;
    tree_tree *tree = NULL;
    OK(tree_density_params_init(&density, sizeof density));
    OK(tree_flow_params_init(&flow, sizeof flow));
    OK(tree_field_params_init(&field, sizeof field));
    OK(tree_livewire_params_init(&livewire, sizeof livewire));
    OK(tree_photo_params_init(&params, sizeof params));
    OK(tree_photo_shot_init(&shot, sizeof shot));
    density.resolution = 16;
    flow.particles = 60;
    field.rows = 24;
    livewire.rows = 64;
    params.height = 8;
    params.branches = 8;
    params.density = &density;
    params.flow = &flow;
    params.field = &field;
    params.livewire = &livewire;
    shot.matte = matte;
    OK(tree_photo_session_new(&shot, 1, &params, 1, NULL, &session));
    OK(tree_photo_session_tree(session, NULL, NULL, &tree));
    OK(tree_photo_session_free(session));
    return tree;
}

static tree_tree *beside_a_wall(const tree_tree *tree, float side) {
    static const tree_pose here = {{0, 0, 0}, {0, 0, 0, 1}};
    static const float low[] = {0, -1, -50}, high[] = {1, 50, 50};
    tree_pose there = here;
    tree_plastic *plastic = NULL;
    tree_plastic_scene *scene = NULL;
    tree_volume *volume = NULL;
    tree_adapted *adapted = NULL;
    tree_tree *bent = NULL;
    tree_adapted_report report = {.struct_size = sizeof report};
    uint64_t id = 0, wall = 0;
    OK(tree_plastic_new(tree, NULL, NULL, NULL, &plastic));
    OK(tree_plastic_scene_new(NULL, NULL, &scene));
    OK(tree_plastic_scene_add_tree(scene, plastic, &here, &id));
    OK(tree_plastic_free(plastic));
    OK(tree_volume_box(low, high, &volume));
    there.position[0] = side;
    OK(tree_plastic_scene_add_obstacle(scene, volume, &there, &wall));
    OK(tree_volume_free(volume));
    OK(tree_plastic_scene_update(scene, NULL, NULL));
    OK(tree_plastic_scene_adapted(scene, id, NULL, &report, &adapted));
    CHECK(report.farthest > 0 && report.n_pruned > 0);
    OK(tree_adapted_tree(adapted, &bent));
    OK(tree_adapted_free(adapted));
    OK(tree_plastic_scene_free(scene));
    return bent;
}

static size_t triangles_of(const tree_mesh *mesh) {
    tree_mesh_totals totals = {.struct_size = sizeof totals};
    OK(tree_mesh_measure(mesh, &totals));
    return totals.n_triangles;
}

static tree_pruned *levels_of(const tree_mesh *mesh) {
    tree_around around;
    tree_coverage_params order;
    tree_prune_make_params params;
    tree_pruned *pruned = NULL;
    OK(tree_around_init(&around, sizeof around));
    OK(tree_coverage_params_init(&order, sizeof order));
    OK(tree_prune_make_params_init(&params, sizeof params));
    around.azimuths = 3;
    around.size = 64;
    order.around = &around;
    params.order = &order;
    OK(tree_pruned_make(mesh, &params, NULL, &pruned));
    return pruned;
}

int main(void) {
    tree_matte *matte = photographed();
    tree_tree *tree = modelled(matte);
    OK(tree_matte_free(matte));
    tree_skeleton *skeleton = NULL;
    float box[6], side;
    OK(tree_tree_skeleton(tree, &skeleton));
    OK(tree_skeleton_bounds(skeleton, &box));
    OK(tree_skeleton_free(skeleton));
    side = 0.4f * box[3];
    tree_tree *bent = beside_a_wall(tree, side);
    OK(tree_tree_free(tree));
    OK(tree_tree_skeleton(bent, &skeleton));
    OK(tree_skeleton_bounds(skeleton, &box));
    OK(tree_skeleton_free(skeleton));
    CHECK(box[3] <= side + 1e-3f);

    tree_mesh *mesh = NULL;
    OK(tree_mesh_build(bent, NULL, NULL, NULL, NULL, &mesh));
    OK(tree_tree_free(bent));
    tree_pruned *pruned = levels_of(mesh);
    size_t last = triangles_of(mesh) + 1;
    OK(tree_mesh_free(mesh));
    static const float lambdas[] = {1, 0.5f, 0.2f};
    uint64_t positions = 0, indices = 0;
    for (int i = 0; i < 3; i++) {
        tree_mesh *level = NULL;
        OK(tree_pruned_mesh_at(pruned, lambdas[i], NULL, &level));
        size_t n = triangles_of(level), n_surfaces = 0;
        CHECK(n < last);
        last = n;
        tree_mesh_totals totals = {.struct_size = sizeof totals};
        OK(tree_mesh_measure(level, &totals));
        n_surfaces = totals.n_surfaces;
        positions = indices = 0xcbf29ce484222325u;
        for (size_t k = 0; k < n_surfaces; k++) {
            tree_surface surface = {.struct_size = sizeof surface};
            OK(tree_mesh_surface(level, k, &surface));
            positions = fnv1a(positions, surface.positions, surface.n_vertices * 3 * sizeof(float));
            indices = fnv1a(indices, surface.indices, surface.n_indices * sizeof(uint32_t));
        }
        OK(tree_mesh_free(level));
    }
    OK(tree_pruned_free(pruned));
    if (n_failures) return 1;
    printf("triangles %zu positions %016llx indices %016llx\n", last, (unsigned long long)positions,
           (unsigned long long)indices);
    return 0;
}
