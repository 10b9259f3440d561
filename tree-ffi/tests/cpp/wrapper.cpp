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

static tree::Skeleton fork() {
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
        tree::Skeleton a = fork(), b;
        CHECK(a && !b && tree::live_objects() == before + 1);
        b = std::move(a);
        CHECK(!a && b.view().n_nodes == 4 && b.bounds()[4] == 2.5f);
        b = fork();
        CHECK(tree::live_objects() == before + 1);
        tree_skeleton *raw = b.release();
        CHECK(!b && tree_skeleton_free(raw) == TREE_OK);
        CHECK(b.reset() == TREE_OK);
    }
    CHECK(tree::live_objects() == before);
}

static void meshes_come_of_trees() {
    tree::Tree twig = tree::Tree::make(fork());
    tree::MeshParams params;
    CHECK(params.struct_size == sizeof(tree_mesh_params) && params.sides_max > 3);
    params.sides_max = params.sides_min;
    params.check();
    tree::MeshReport report;
    tree::Look look = tree::Look::plain();
    tree::Mesh mesh = tree::Mesh::build(twig, look, params, nullptr, &report);
    CHECK(mesh.count().n_vertices == report.n_vertices && mesh.surface_count() > 0);
    tree::Surface surface = mesh.surface(0);
    float top = 0;
    tree::Span<const float> positions(surface.positions, 3 * surface.n_vertices);
    for (std::size_t i = 1; i < positions.size(); i += 3) top = std::max(top, positions[i]);
    CHECK(top > 2.4f && top < 2.7f);

    tree::Bytes file = mesh.to_glb();
    tree::Span<const std::uint8_t> bytes = file.view();
    CHECK(bytes.size() > 100 && std::string_view(reinterpret_cast<const char *>(bytes.data()), 4) == "glTF");
    tree::Mesh read = tree::Mesh::from_bytes(TREE_MESH_FORMAT_GLTF, bytes, {});
    CHECK(read.count().n_triangles == mesh.count().n_triangles);
    auto [obj, mtl] = mesh.to_obj("twig");
    CHECK(!obj.view().empty() && !mtl.view().empty());
}

static void volumes_combine() {
    const float origin[] = {0, 0, 0}, above[] = {0, 1, 0};
    tree::Volume a = tree::Volume::sphere(origin, 1), b = tree::Volume::sphere(above, 1);
    tree::Volume both = tree::Volume::union_({a.get(), b.get()});
    CHECK(both.bounds()[4] == 2.0f && both.is_bounded());
    const tree_volume *array[] = {a, b};
    CHECK(tree::Volume::intersection(array).is_bounded());
    std::vector<const tree_volume *> list = {a, b};
    CHECK(tree::Volume::union_(list));
    CHECK(a.difference(b).bounds()[1] == -1.0f);
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
    control.on_progress([](std::string_view, float) -> bool { throw 1; });
    try {
        tree::path_grow(nullptr, 1, control);
        CHECK(false);
    } catch (const tree::Error &error) {
        CHECK(error.status() == TREE_ERROR_CANCELLED);
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

int main() {
    objects_move_and_end();
    meshes_come_of_trees();
    volumes_combine();
    texts_are_views();
    progress_cancels();
    errors_are_told();
    CHECK(tree::live_objects() == 0);
    tree::clear_error();
    std::printf(n_failures ? "%d failures\n" : "all is well\n", n_failures);
    return n_failures != 0;
}
