// tree.hpp, with exceptions and without.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <tree.hpp>
#include <type_traits>

static int n_failures = 0;

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            std::printf("%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition);              \
            n_failures++;                                                                          \
        }                                                                                          \
    } while (0)

static_assert(!std::is_copy_constructible_v<tree::Mesh> && std::is_nothrow_move_constructible_v<tree::Mesh>);
static_assert(!std::is_copy_assignable_v<tree::Tree> && std::is_nothrow_move_assignable_v<tree::Tree>);
static_assert(sizeof(tree::Mesh) == sizeof(void *));
static_assert(sizeof(tree::MeshParams) == sizeof(tree_mesh_params));
// Nothing becomes a bare pointer by itself: `delete mesh` and `params.volume = Volume::sphere(...)`.
static_assert(!std::is_convertible_v<tree::Mesh &, tree_mesh *> && !std::is_convertible_v<tree::Mesh, void *>);

// Whether a view can be asked of a `T`, and whether its pointer can.
template <class T, class = void>
constexpr bool has_view = false;
template <class T>
constexpr bool has_view<T, std::void_t<decltype(std::declval<T>().view())>> = true;
template <class T, class = void>
constexpr bool has_pointer = false;
template <class T>
constexpr bool has_pointer<T, std::void_t<decltype(std::declval<T>().get())>> = true;
template <class T, class = void>
constexpr bool has_surface = false;
template <class T>
constexpr bool has_surface<T, std::void_t<decltype(std::declval<T>().surface(0))>> = true;
static_assert(has_view<tree::Bytes &> && has_view<const tree::Bytes &> && !has_view<tree::Bytes>);
static_assert(has_surface<const tree::Mesh &> && !has_surface<tree::Mesh> && !has_surface<const tree::Mesh>);
static_assert(has_pointer<tree::Volume &> && !has_pointer<tree::Volume>);

// Whether a field can be put into parameters that outlive it.
template <class F, class = void>
constexpr bool can_set = false;
template <class F>
constexpr bool can_set<F, std::void_t<decltype(std::declval<tree::LinkParams &>().set_cost(std::declval<F>()))>> =
    true;
static_assert(can_set<const tree::Field &> && !can_set<tree::Field>);

// What the call failed with, and whether it said so.
template <class F>
static tree_status failure(F call) {
    tree::clear_error();
#if TREE_THROWS
    try {
        call();
        return TREE_OK;
    } catch (const tree::Error &error) {
        return error.status();
    }
#else
    CHECK(!call());
    return tree::status();
#endif
}

static tree::Skeleton a_fork() {
    static const float positions[] = {0, 0, 0, 0, 1, 0, 0.5f, 2.5f, 0, -0.5f, 2, 0};
    static const float radii[] = {0.1f, 0.08f, 0.01f, 0.01f};
    static const std::uint32_t parents[] = {TREE_NO_PARENT, 0, 1, 1};
    tree::SkeletonColumns columns;
    columns.n_nodes = 4;
    columns.positions = positions;
    columns.radii = radii;
    columns.parents = parents;
    return tree::Skeleton::from_columns(columns);
}

static void objects_move_and_end() {
    std::size_t before = tree::live_objects();
    {
        tree::Skeleton a = a_fork(), b;
        CHECK(a && !b && tree::live_objects() == before + 1);
        b = std::move(a);
        CHECK(!a && b.view().n_nodes == 4 && b.bounds()[4] == 2.5f);
        b = a_fork();
        CHECK(tree::live_objects() == before + 1);
        tree_skeleton *raw = b.release();
        CHECK(!b && tree_skeleton_free(raw) == TREE_OK);
        CHECK(b.reset() == TREE_OK);
    }
    CHECK(tree::live_objects() == before);
}

static void meshes_come_of_trees() {
    tree::Tree twig = tree::Tree::make(a_fork());
    tree::MeshParams params;
    CHECK(params.struct_size == sizeof(tree_mesh_params) && params.max_sides > 3);
    params.max_sides = params.min_sides;
    params.check();
    tree::MeshReport report;
    tree::Look look = tree::Look::plain();
    tree::Mesh mesh = tree::Mesh::build(twig, look, params, nullptr, &report);
    CHECK(mesh.measure().n_vertices == report.n_vertices && mesh.surface_count() > 0);
    tree::Surface surface = mesh.surface(0);
    float top = 0;
    tree::Span<const float> positions(surface.positions, 3 * surface.n_vertices);
    for (std::size_t i = 1; i < positions.size(); i += 3) top = std::max(top, positions[i]);
    CHECK(top > 2.4f && top < 2.7f);

    tree::Bytes file = mesh.to_glb();
    tree::Span<const std::uint8_t> bytes = file.view();
    CHECK(bytes.size() > 100 && std::string_view(reinterpret_cast<const char *>(bytes.data()), 4) == "glTF");
    tree::Mesh read = tree::Mesh::from_bytes(TREE_MESH_FORMAT_GLTF, bytes, {});
    CHECK(read.measure().n_triangles == mesh.measure().n_triangles);
    auto [obj, mtl] = mesh.to_obj("twig");
    CHECK(!obj.view().empty() && !mtl.view().empty());
}

static tree::Tree oak_twig() {
    static const float positions[] = {0, 0.5f, 0, 0.5f, 2.5f, 0};
    static const float orientations[] = {0, 0, 0, 1, 0, 0, 0, 1}, sizes[] = {0.05f, 0.05f};
    static const std::uint32_t bearers[] = {1, 2};
    static const std::uint16_t kinds[] = {0, 0};
    static const tree_str leaf = tree::str("oak");
    tree::Foliage foliage;
    foliage.n_leaves = 2;
    foliage.positions = positions;
    foliage.rotations = orientations;
    foliage.sizes = sizes;
    foliage.nodes = bearers;
    foliage.kinds = kinds;
    tree::Species species;
    species.name = tree::str("oak");
    species.bark = tree::str("oak");
    species.leaf_kinds = &leaf;
    species.n_leaf_kinds = 1;
    return tree::Tree::make(a_fork(), foliage, species);
}

static void arrays_of_objects_are_taken() {
    tree::Tree twig = oak_twig();
    tree::Mesh base = tree::Mesh::build(twig), small = tree::Mesh::build(twig);
    static const float at[] = {0, 1, 0}, turn[] = {0, 0, 0, 1}, scale[] = {1, 1, 1};
    static const std::uint32_t bearer[] = {0};
    tree::TwigInstances one;
    one.n_instances = 1;
    one.translations = at;
    one.rotations = turn;
    one.scales = scale;
    one.branches = bearer;
    tree::Span<const tree_twig_instances> rows(&one, 1);
    tree::Twigs twigs = tree::Twigs::from_parts(base, {small}, rows);
    CHECK(twigs.count() == 1);
    std::size_t n_triangles = base.measure().n_triangles + small.measure().n_triangles;
    CHECK(twigs.flatten().measure().n_triangles == n_triangles);
    CHECK(failure([&] { return tree::Twigs::from_parts(base, {small, base}, rows); }) == TREE_ERROR_BUFFER);

    std::vector<tree::Skeleton> skeletons;
    skeletons.push_back(a_fork());
    std::vector<tree_piece> pieces{{1, 0, 0}};
    tree::Pieces made = tree::Pieces::make(skeletons, pieces);
    auto [row, skeleton] = made.piece(0);
    CHECK(made.count() == 1 && row.area == 1 && skeleton.view().n_nodes == 4);
    auto [reached, linked] = made.link();
    CHECK(reached.size() == 1 && reached[0] == 1 && linked.view().n_nodes == 4);
    pieces.clear();
    CHECK(failure([&] { return tree::Pieces::make(skeletons, pieces); }) == TREE_ERROR_BUFFER);
    CHECK(tree::error_text() == "skeletons and rows must be of one length");
}

static void calls_say_whether_they_went_well() {
    tree::MeshParams params;
    CHECK(params.check());
    params.max_sides = 0;
    CHECK(failure([&] { return params.check(); }) == TREE_ERROR_PARAMETER);
    tree::Mesh none;
    CHECK(failure([&] { return none.check(); }) == TREE_ERROR_NULL);
    CHECK(failure([&] { return none.write_glb("never.glb"); }) == TREE_ERROR_NULL);
}

static void failed_parameters_are_refused() {
#if TREE_THROWS
    CHECK(failure([] { return tree::path_preset("nope"); }) == TREE_ERROR_UNKNOWN_NAME);
#else
    tree::PathParams params = tree::path_preset("nope");
    CHECK(params.struct_size == 0 && tree::status() == TREE_ERROR_UNKNOWN_NAME);
    CHECK(!tree::path_grow(params, 1) && tree::status() == TREE_ERROR_STRUCT_SIZE);
    CHECK(tree::bark_style_of("nope").struct_size == 0 && tree::leaf_shape_of("nope").struct_size == 0);
    CHECK(tree::View().place(tree::Mesh()).struct_size == 0);
    auto [leaves, twigs, kind] = tree::foliage_preset("nope");
    CHECK(leaves.struct_size == 0 && twigs.struct_size == 0 && kind.empty());
    CHECK(!leaves.check(1) && tree::status() == TREE_ERROR_STRUCT_SIZE);
#endif
    CHECK(tree::path_preset("oak").struct_size == sizeof(tree_path_params));
    CHECK(tree::Limits::for_memory(1 << 20).struct_size != 0 && tree::Style::studio().struct_size != 0);
}

static void empty_objects_are_not_left_out() {
    tree::Tree twig = oak_twig();
    tree::Look look = tree::Look::of_tree(twig, true), *missing = nullptr;
    CHECK(tree::Mesh::build(twig, look) && tree::Mesh::build(twig, &look) && tree::Mesh::build(twig));
    CHECK(tree::Mesh::build(twig, nullptr) && tree::Mesh::build(twig, missing));
    tree::Look moved = std::move(look);
    CHECK(failure([&] { return tree::Mesh::build(twig, look); }) == TREE_ERROR_NULL);
    CHECK(failure([&] { return tree::Mesh::build(twig, &look); }) == TREE_ERROR_NULL);
    CHECK(failure([&] { return tree::Twigs::build(twig, look, {}, {}, 1); }) == TREE_ERROR_NULL);
    CHECK(moved);
}

static void fields_are_asked() {
    tree::Tree twig = oak_twig();
    tree::LeafReport all, none;
    tree::Tree full = twig.grow_leaves({}, nullptr, false, 1, nullptr, &all);
    tree::Tree bare = twig.grow_leaves({}, [](std::array<float, 3>) { return 0.0f; }, true, 1, nullptr, &none);
    CHECK(full.foliage().n_leaves > 0 && bare.foliage().n_leaves == 0);

    std::atomic<int> n_asked{0};
    tree::Field cost([&](std::array<float, 3> at) {
        n_asked++;
        return at[0] < 0 ? 2.0f : 1.0f;
    });
    tree::PathParams params;
    params.graph_nodes = 200;
    params.n_levels = 0;
    params.leaves = nullptr;
    params.set_cost(cost);
    CHECK(tree::path_grow(params, 1) && n_asked > 0);
#if TREE_THROWS
    tree::PathParams roots = params;
    tree::Field bad([](std::array<float, 3>) -> float { throw std::range_error("cost"); });
    roots.set_cost(bad);
    for (bool below : {false, true}) {
        params.roots = below ? &roots : nullptr;
        bool thrown = false;
        try {
            tree::path_grow(below ? params : roots, 1);
        } catch (const std::range_error &error) {
            thrown = std::string_view(error.what()) == "cost";
        }
        CHECK(thrown);
    }
    std::size_t before = tree::live_objects();
    int thrown = 0;
    try {
        twig.grow_leaves({}, [](std::array<float, 3>) -> float { throw 7; }, false, 1);
    } catch (int number) {
        thrown = number;
    }
    CHECK(thrown == 7 && tree::live_objects() == before);
#endif
}

static void volumes_combine() {
    const float origin[] = {0, 0, 0};
    tree::Volume a = tree::Volume::sphere(origin, 1), b = tree::Volume::sphere({0, 1, 0}, 1);
    tree::Volume both = tree::Volume::union_({a, b});
    CHECK(both.bounds()[4] == 2.0f && both.is_bounded());
    const tree_volume *array[] = {a.get(), b.get()};
    CHECK(tree::Volume::intersection(array).is_bounded());
    std::vector<const tree_volume *> list = {a.get(), b.get()};
    CHECK(tree::Volume::union_(list));
    CHECK(a.difference(b).bounds()[1] == -1.0f);
    std::vector<tree::Volume> owned;
    owned.push_back(tree::Volume::box({0, 0, 0}, {1, 2, 3}));
    owned.push_back(std::move(b));
    CHECK(tree::Volume::union_(owned).bounds()[5] == 3.0f);
    CHECK(failure([&] { return tree::Volume::union_({a, b}); }) == TREE_ERROR_NULL);
}

static void arrays_come_back() {
    tree::Skeleton skeleton = a_fork();
    CHECK(skeleton.segment_lengths().size() == 4 && skeleton.segment_lengths()[1] == 1);
    std::vector<float> radii = skeleton.radii(), own(4);
    CHECK(skeleton.radii(nullptr, own) && own == radii);
    own[0] = 0.5f;
    tree::Skeleton thick = skeleton.with_radii(own);
    CHECK(thick.view().radii[0] == 0.5f);
    own.pop_back();
    CHECK(failure([&] { return skeleton.radii(nullptr, own); }) == TREE_ERROR_BUFFER);
    auto [starts, nodes] = skeleton.children();
    CHECK(starts.size() == 5 && starts[4] == 3 && nodes.size() == 3 && nodes[2] == 3);

    tree::Volume ball = tree::Volume::sphere({0, 0, 0}, 1);
    CHECK(ball.contains({0, 0, 0, 2, 0, 0}) == (std::vector<std::uint8_t>{1, 0}));
    CHECK(ball.distance({0, 3, 0})[0] == 2 && ball.sample(5, 64, 1).size() == 15);
    CHECK(failure([&] { return !ball.contains({0, 0}).empty(); }) == TREE_ERROR_BUFFER);
    CHECK(ball.contains({}).empty() && ball.distance({}).empty() && ball.sample(0, 64, 1).empty());
    std::uint8_t one[1];
    CHECK(failure([&] { return ball.contains({0, 0, 0, 1, 1, 1}, nullptr, one); }) == TREE_ERROR_BUFFER);
    CHECK(ball.contains({0, 0, 0}, nullptr, one) && one[0] == 1);

    tree::Tree twig = oak_twig();
    tree::Mesh mesh = tree::Mesh::build(twig);
    std::size_t n = mesh.surface(0).n_vertices;
    CHECK(mesh.wind(0).size() == n && mesh.bend({}, 1, 0).size() == 3 * n);
    auto [of_vertex, first, n_points] = mesh.points(0);
    CHECK(of_vertex.size() == n && first.size() == n_points && n_points <= n && n_points > 0);
    std::vector<float> z_up = tree::convert_positions(TREE_CONVENTION_BLENDER, TREE_CONVERT_TO, {0, 1, 0});
    CHECK(z_up.size() == 3 && z_up[2] == 1);

    tree::Graph graph = tree::Graph::from_edges({0, 0, 0, 0, 1, 0}, {0, 1}, {2});
    auto [costs, predecessors] = graph.search(0);
    CHECK(costs.size() == 2 && costs[1] == 2 && predecessors[1] == 0);
    CHECK(failure([&] { return tree::Graph::from_edges({0, 0, 0}, {0, 1, 2}, {2}); }) == TREE_ERROR_BUFFER);
    CHECK(mesh.skeletonize_mesh());
    tree::Capsules capsules = skeleton.capsules();
    CHECK(tree::capsule_contains(capsules.view()[0], {0, 0.5f, 0}));
    CHECK(!tree::capsule_contains(capsules.view()[0], {5, 0, 0}));
}

static void texts_are_views() {
    CHECK(tree::abi_version() == TREE_ABI_VERSION && tree::version().find('.') != std::string_view::npos);
    CHECK(tree::status_name(TREE_ERROR_NULL) == "TREE_ERROR_NULL");
    std::string_view name, title;
    std::tie(name, title) = tree::path_preset_name(0);
    CHECK(!name.empty() && !title.empty() && tree::path_preset(name).n_levels > 0);
}

static void progress_cancels() {
    std::atomic<int> n_told{0};
    tree::Control control;
    control.on_progress([&](std::string_view stage, float fraction) {
        CHECK(!stage.empty() && fraction >= 0 && fraction <= 1);
        return ++n_told < 3;
    });
#if TREE_THROWS
    tree_status status = TREE_OK;
    try {
        tree::path_grow(nullptr, 1, control);
    } catch (const tree::Error &error) {
        status = error.status();
    }
    CHECK(status == TREE_ERROR_CANCELLED);
    control.on_progress([](std::string_view, float) -> bool { throw std::range_error("told"); });
    for (int i = 0; i < 2; i++) {
        bool thrown = false;
        try {
            tree::path_grow(nullptr, 1, control);
        } catch (const std::range_error &error) {
            thrown = std::string_view(error.what()) == "told";
        }
        CHECK(thrown);
    }
#else
    CHECK(!tree::path_grow(nullptr, 1, control) && tree::status() == TREE_ERROR_CANCELLED);
#endif
    CHECK(n_told >= 3);
}

static void errors_are_told() {
    tree::clear_error();
    tree::Volume none;
#if TREE_THROWS
    try {
        none.measure();
        CHECK(false);
    } catch (const tree::Error &error) {
        CHECK(error.status() == TREE_ERROR_NULL);
        CHECK(std::string_view(error.what()).find("TREE_ERROR_NULL: volume") == 0);
    }
#else
    CHECK(none.measure() == 0 && !none.part(0));
#endif
    CHECK(tree::status() == TREE_ERROR_NULL && !tree::error_text().empty());
    tree::clear_error();
    CHECK(tree::status() == TREE_OK && tree::error_text().empty());
}

/* Trees grow together, one of them is planted and meets a wall, and both are compared. */
static void trees_grow_and_react() {
    tree::GrowthParams birch = tree::Growth::preset("birch");
    tree::GrowthPlant plants[2];
    plants[0].habit = plants[1].habit = birch.habit;
    plants[1].base[0] = 2;
    tree::Growth stand = tree::Growth::make(nullptr, {plants, 2}, 1);
    CHECK(stand.step(5) && stand.measure().n_iterations == 5);
    const float points[] = {0, 50, 0};
    CHECK(stand.light(points).size() == 1);
    tree::Grown grown = stand.grown(0);
    CHECK(grown.view().n_nodes > 5);

    tree::Plastic plastic = tree::Plastic::make(grown.tree());
    tree::PlasticScene scene = tree::PlasticScene::make();
    tree_pose pose = {{0, 0, 0}, {0, 0, 0, 1}};
    uint64_t id = scene.add_tree(plastic, pose);
    pose.position[0] = 0.2f;
    uint64_t wall = scene.add_obstacle(tree::Volume::box({0, -1, -9}, {1, 9, 9}), pose);
    CHECK(scene.update().n_touched == 1);
    CHECK(scene.trees().size() == 1 && scene.trees()[0] == id && scene.obstacles()[0] == wall);
    CHECK(scene.pose(id).rotation[3] == 1);
    tree::AdaptedReport report;
    tree::Adapted adapted = scene.adapted(id, nullptr, &report);
    CHECK(report.farthest > 0 && adapted.view().n_input_nodes == grown.view().n_nodes);
    tree::PlasticClusters clusters = scene.clusters(id);
    CHECK(clusters.view().size() > 0);

    tree::Skeleton before = grown.tree().skeleton(), after = adapted.tree().skeleton();
    CHECK(before.distance(before).value == 0);
    auto [distance, pairs] = before.distance_pairs(after);
    CHECK(distance.normalized >= 0 && distance.normalized < 1 && pairs.view().size() > 0);
}

int main() {
    trees_grow_and_react();
    objects_move_and_end();
    meshes_come_of_trees();
    arrays_of_objects_are_taken();
    calls_say_whether_they_went_well();
    failed_parameters_are_refused();
    empty_objects_are_not_left_out();
    fields_are_asked();
    volumes_combine();
    arrays_come_back();
    texts_are_views();
    progress_cancels();
    errors_are_told();
    CHECK(tree::live_objects() == 0);
    tree::clear_error();
    std::printf(n_failures ? "%d failures\n" : "all is well\n", n_failures);
    return n_failures != 0;
}
