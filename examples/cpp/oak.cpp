// Grows an oak, meshes it, copies it into buffers as an engine has them, and writes oak.glb.
//
//     oak [PRESET [SEED]]
//
// See ../c/README.md for how to build it.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <tree.hpp>
#include <vector>

namespace {

// An engine's vertex: what goes to the GPU as it is.
struct EngineVertex {
    float position[3];
    float normal[3];
    float uv[2];
};

std::uint64_t fnv1a(std::uint64_t hash, const void *data, std::size_t n_bytes) {
    auto bytes = static_cast<const unsigned char *>(data);
    for (std::size_t i = 0; i < n_bytes; i++) hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

void grow(const char *preset, std::uint64_t seed) {
    std::string last;
    tree::Control control;
    control.on_progress([&](std::string_view stage, float fraction) {
        if (stage != last) {
            last = stage;
            std::fprintf(stderr, "%3.0f %% %s\n", 100.0 * static_cast<double>(fraction), last.c_str());
        }
        return true; // go on
    });

    tree::Tree oak = tree::path_grow(tree::path_preset(preset), seed, control);
    tree::Mesh mesh = tree::Mesh::build(oak, tree::Look::of_tree(oak, false), nullptr, control);

    std::vector<EngineVertex> vertices;
    std::vector<std::uint32_t> triangles;
    std::uint64_t positions = UINT64_C(0xcbf29ce484222325), indices = positions;
    for (std::size_t i = 0; i < mesh.surface_count(); i++) {
        tree::Surface surface = mesh.surface(i);
        positions = fnv1a(positions, surface.positions, surface.n_vertices * 3 * sizeof(float));
        indices = fnv1a(indices, surface.indices, surface.n_indices * sizeof(std::uint32_t));
        auto first = static_cast<std::uint32_t>(vertices.size());
        for (std::size_t v = 0; v < surface.n_vertices; v++) {
            EngineVertex vertex;
            std::memcpy(vertex.position, surface.positions + 3 * v, sizeof vertex.position);
            std::memcpy(vertex.normal, surface.normals + 3 * v, sizeof vertex.normal);
            std::memcpy(vertex.uv, surface.uvs + 2 * v, sizeof vertex.uv);
            vertices.push_back(vertex);
        }
        for (std::uint32_t index : tree::Span(surface.indices, surface.n_indices))
            triangles.push_back(first + index);
    }
    std::printf("%zu surfaces, %zu vertices, %zu triangles\n", mesh.surface_count(), vertices.size(),
                triangles.size() / 3);
    std::printf("%s seed %" PRIu64 "\n", preset, seed);
    std::printf("positions %016" PRIx64 " indices %016" PRIx64 "\n", positions, indices);

    mesh.write_glb("oak.glb");
}

} // namespace

int main(int n, char **arguments) {
    try {
        grow(n > 1 ? arguments[1] : "oak", n > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    tree::clear_error();
    return 0;
}
