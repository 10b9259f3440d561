// The tree family for C++17, over tree.h. Header only. Licence: MIT OR Apache-2.0.
// Made of tree.h by tests/hpp.rs in tree-ffi: do not edit.
//
// * Objects (tree::Mesh and so on) are moved, never copied, and free themselves. They convert to the C
//   pointers, so C functions take them too.
// * Parameters (tree::MeshParams and so on) are C's structs with the defaults filled in. A call takes them
//   by value or as pointers; `nullptr` and nothing at all mean the defaults.
// * Views (tree::Surface and so on, tree::Span, std::string_view) point into the object that they were
//   asked of and live as long as it.
// * A call that fails throws tree::Error. Without exceptions (-fno-exceptions) it returns something empty
//   instead; tree::status() and tree::error_text() say what was wrong, tree::clear_error() forgets it.
// * What a function does is said at the C function of its name in tree.h.

#ifndef TREE_HPP
#define TREE_HPP

#include "tree.h"
#include <array>
#include <functional>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define TREE_THROWS 1
#else
#define TREE_THROWS 0
#endif

namespace tree {

// What this thread's last call that failed says; `TREE_OK` and nothing before any did.
inline tree_status status() noexcept { return tree_error_status(); }
inline std::string_view error_text() noexcept { return tree_error_text(); }
inline void clear_error() noexcept { tree_error_clear(); }

// What a call that failed throws.
class Error : public std::runtime_error {
public:
    Error(tree_status code, const char *text)
        : std::runtime_error(std::string(tree_status_name(code)) + ": " + text), code_(code) {}
    // One of the `TREE_ERROR_` codes.
    tree_status status() const noexcept { return code_; }

private:
    tree_status code_;
};

// Whether a call went well. Throws when it did not, where exceptions are there.
inline bool check(tree_status code) {
#if TREE_THROWS
    if (code != TREE_OK) throw Error(code, tree_error_text());
#endif
    return code == TREE_OK;
}

// A view of an array.
template <class T>
class Span {
public:
    constexpr Span() noexcept = default;
    constexpr Span(T *data, std::size_t size) noexcept : data_(data), size_(size) {}
    template <std::size_t N>
    constexpr Span(T (&array)[N]) noexcept : data_(array), size_(N) {}
    // Anything with data() and size().
    template <class C, class = decltype(static_cast<T *>(std::declval<const C &>().data()))>
    constexpr Span(const C &container) noexcept : data_(container.data()), size_(container.size()) {}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winit-list-lifetime"
#endif
    // For arguments: the list lives as long as the call.
    constexpr Span(std::initializer_list<std::remove_const_t<T>> list) noexcept
        : data_(list.begin()), size_(list.size()) {}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

    constexpr T *data() const noexcept { return data_; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr T *begin() const noexcept { return data_; }
    constexpr T *end() const noexcept { return data_ + size_; }
    constexpr T &operator[](std::size_t i) const noexcept { return data_[i]; }

private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

// An argument that may be left out: a struct, a pointer to one, or `nullptr`.
template <class T>
class Ref {
public:
    constexpr Ref(std::nullptr_t = nullptr) noexcept {}
    constexpr Ref(const T *pointer) noexcept : pointer_(pointer) {}
    constexpr Ref(const T &value) noexcept : pointer_(&value) {}
    constexpr operator const T *() const noexcept { return pointer_; }

private:
    const T *pointer_ = nullptr;
};

namespace detail {

inline std::string_view text(tree_str text) noexcept {
    return text.len ? std::string_view(text.data, text.len) : std::string_view();
}

// Owns a C object.
template <class T, tree_status (*Free)(T *)>
class Object {
public:
    Object() noexcept = default;
    explicit Object(T *owned) noexcept : object_(owned) {}
    Object(Object &&other) noexcept : object_(other.release()) {}
    Object &operator=(Object &&other) noexcept {
        if (this != &other) reset(other.release());
        return *this;
    }
    ~Object() { reset(); }

    T *get() const noexcept { return object_; }
    operator T *() const noexcept { return object_; }
    explicit operator bool() const noexcept { return object_ != nullptr; }
    // Frees the object, and owns another. TREE_OK, or what the library says.
    tree_status reset(T *owned = nullptr) noexcept {
        tree_status freed = Free(object_);
        object_ = owned;
        return freed;
    }
    // Hands the object over to the caller, who frees it.
    T *release() noexcept { return std::exchange(object_, nullptr); }

private:
    T *object_ = nullptr;
};

} // namespace detail

// Text for a C struct; `text` must live as long as the struct is used.
inline tree_str str(std::string_view text) noexcept { return {text.data(), text.size()}; }

// How a call is done, with a function for progress.
struct Control : tree_control {
    Control() : tree_control{} { tree_control_init(this, sizeof(tree_control)); }
    Control(const Control &) = delete;
    Control &operator=(const Control &) = delete;

    // `told(stage, fraction)` returns whether to go on. Called from whichever thread does the work; what
    // it throws cancels the call.
    template <class F>
    Control &on_progress(F told) {
        told_ = std::move(told);
        user = this;
        progress = [](void *self, const char *stage, float fraction) noexcept -> int32_t {
#if TREE_THROWS
            try {
                return static_cast<Control *>(self)->told_(stage, fraction) ? 0 : 1;
            } catch (...) {
                return 1;
            }
#else
            return static_cast<Control *>(self)->told_(stage, fraction) ? 0 : 1;
#endif
        };
        return *this;
    }

private:
    std::function<bool(std::string_view, float)> told_;
};

class Axes;
class Bytes;
class Cancel;
class Capsules;
class Crossings;
class FoundLeaves;
class GltfAttributes;
class GltfLeaves;
class Graph;
class GraphNodes;
class LeafModel;
class Look;
class Mask;
class Mesh;
class Packed;
class Picture;
class Pieces;
class Pool;
class Profile;
class Rows;
class Separation;
class Skeleton;
class Swc;
class Texture;
class Tree;
class Twigs;
class Unpacked;
class Volume;
class WindBranches;
struct Allocator;
struct AxisColumns;
using BarkPatches = tree_bark_patches;
struct BarkStyle;
struct Bounds;
struct BranchMotion;
using Capsule = tree_capsule;
struct CapsuleParams;
struct CapsuleReport;
struct ConventionTraits;
struct CrossingPairs;
struct DisplaceParams;
struct Foliage;
struct GlbOptions;
struct GltfAttribute;
struct GltfInstances;
struct GltfLevel;
using GraphArc = tree_graph_arc;
struct GraphColumns;
struct GraphNodesColumns;
struct ImportOptions;
struct ImportReport;
struct InstancingParams;
struct InstancingReport;
struct LeafCard;
struct LeafKinds;
struct LeafLook;
struct LeafMesh;
struct LeafModelReport;
struct LeafParams;
struct LeafReport;
struct LeafShape;
struct Limits;
struct LinkParams;
struct MaskColumns;
struct Material;
struct MeshParams;
struct MeshPart;
struct MeshReport;
struct MeshTotals;
struct OcclusionParams;
struct PackedColumns;
using PackedVertex = tree_packed_vertex;
struct PackedVertices;
struct Paint;
struct PathLevel;
using PathLevelReport = tree_path_level_report;
struct PathParams;
struct PathReport;
using Piece = tree_piece;
struct PivotElement;
struct Pivots;
struct Pixels;
struct PlyOptions;
struct PoolOptions;
struct ProfileColumns;
struct ProfileOptions;
struct RadiusRule;
struct SeparationColumns;
struct SkeletonColumns;
struct SkeletonizeParams;
struct SkeletonizeReport;
struct Solid;
struct Species;
using Stream = tree_stream;
struct StrewParams;
struct Style;
struct SubdivideParams;
struct Surface;
struct SwcContents;
struct SwcOptions;
struct TexturePixels;
struct Topology;
struct TwigInstances;
struct TwigParams;
struct TwigReport;
struct UnpackedColumns;
using VertexWind = tree_vertex_wind;
struct View;
struct Wind;
using WindBranch = tree_wind_branch;

struct Allocator : tree_allocator {
    Allocator() : tree_allocator{} { struct_size = sizeof *this; }
};

struct AxisColumns : tree_axis_columns {
    AxisColumns() : tree_axis_columns{} { struct_size = sizeof *this; }
};

struct BarkStyle : tree_bark_style {
    BarkStyle() : tree_bark_style{} { tree_bark_style_init(this, sizeof(tree_bark_style)); }
};

struct Bounds : tree_bounds {
    Bounds() : tree_bounds{} { struct_size = sizeof *this; }
};

struct BranchMotion : tree_branch_motion {
    BranchMotion() : tree_branch_motion{} { struct_size = sizeof *this; }
};

struct CapsuleParams : tree_capsule_params {
    CapsuleParams() : tree_capsule_params{} { tree_capsule_params_init(this, sizeof(tree_capsule_params)); }
};

struct CapsuleReport : tree_capsule_report {
    CapsuleReport() : tree_capsule_report{} { struct_size = sizeof *this; }
};

struct ConventionTraits : tree_convention_traits {
    ConventionTraits() : tree_convention_traits{} { struct_size = sizeof *this; }
};

struct CrossingPairs : tree_crossing_pairs {
    CrossingPairs() : tree_crossing_pairs{} { struct_size = sizeof *this; }
};

struct DisplaceParams : tree_displace_params {
    DisplaceParams() : tree_displace_params{} { tree_displace_params_init(this, sizeof(tree_displace_params)); }
};

struct Foliage : tree_foliage {
    Foliage() : tree_foliage{} { struct_size = sizeof *this; }
};

struct GlbOptions : tree_glb_options {
    GlbOptions() : tree_glb_options{} { tree_glb_options_init(this, sizeof(tree_glb_options)); }
};

struct GltfAttribute : tree_gltf_attribute {
    GltfAttribute() : tree_gltf_attribute{} { struct_size = sizeof *this; }
};

struct GltfInstances : tree_gltf_instances {
    GltfInstances() : tree_gltf_instances{} { struct_size = sizeof *this; }
};

struct GltfLevel : tree_gltf_level {
    GltfLevel() : tree_gltf_level{} { struct_size = sizeof *this; }
};

struct GraphColumns : tree_graph_columns {
    GraphColumns() : tree_graph_columns{} { struct_size = sizeof *this; }
};

struct GraphNodesColumns : tree_graph_nodes_columns {
    GraphNodesColumns() : tree_graph_nodes_columns{} { struct_size = sizeof *this; }
};

struct ImportOptions : tree_import_options {
    ImportOptions() : tree_import_options{} { tree_import_options_init(this, sizeof(tree_import_options)); }
};

struct ImportReport : tree_import_report {
    ImportReport() : tree_import_report{} { struct_size = sizeof *this; }
};

struct InstancingParams : tree_instancing_params {
    InstancingParams() : tree_instancing_params{} { tree_instancing_params_init(this, sizeof(tree_instancing_params)); }
};

struct InstancingReport : tree_instancing_report {
    InstancingReport() : tree_instancing_report{} { struct_size = sizeof *this; }
};

struct LeafCard : tree_leaf_card {
    LeafCard() : tree_leaf_card{} { struct_size = sizeof *this; }
};

struct LeafKinds : tree_leaf_kinds {
    LeafKinds() : tree_leaf_kinds{} { struct_size = sizeof *this; }
};

struct LeafLook : tree_leaf_look {
    LeafLook() : tree_leaf_look{} { tree_leaf_look_init(this, sizeof(tree_leaf_look)); }
};

struct LeafMesh : tree_leaf_mesh {
    LeafMesh() : tree_leaf_mesh{} { struct_size = sizeof *this; }
};

struct LeafModelReport : tree_leaf_model_report {
    LeafModelReport() : tree_leaf_model_report{} { struct_size = sizeof *this; }
};

struct LeafParams : tree_leaf_params {
    LeafParams() : tree_leaf_params{} { tree_leaf_params_init(this, sizeof(tree_leaf_params)); }
    void check(size_t n_kinds) const;
};

struct LeafReport : tree_leaf_report {
    LeafReport() : tree_leaf_report{} { struct_size = sizeof *this; }
};

struct LeafShape : tree_leaf_shape {
    LeafShape() : tree_leaf_shape{} { tree_leaf_shape_init(this, sizeof(tree_leaf_shape)); }
    void autumn(float progress);
};

struct Limits : tree_limits {
    Limits() : tree_limits{} { tree_limits_init(this, sizeof(tree_limits)); }
    static Limits for_memory(uint64_t bytes);
};

struct LinkParams : tree_link_params {
    LinkParams() : tree_link_params{} { tree_link_params_init(this, sizeof(tree_link_params)); }
};

struct MaskColumns : tree_mask_columns {
    MaskColumns() : tree_mask_columns{} { struct_size = sizeof *this; }
};

struct Material : tree_material {
    Material() : tree_material{} { tree_material_init(this, sizeof(tree_material)); }
};

struct MeshParams : tree_mesh_params {
    MeshParams() : tree_mesh_params{} { tree_mesh_params_init(this, sizeof(tree_mesh_params)); }
    void check() const;
    float error() const;
};

struct MeshPart : tree_mesh_part {
    MeshPart() : tree_mesh_part{} { tree_mesh_part_init(this, sizeof(tree_mesh_part)); }
};

struct MeshReport : tree_mesh_report {
    MeshReport() : tree_mesh_report{} { struct_size = sizeof *this; }
};

struct MeshTotals : tree_mesh_totals {
    MeshTotals() : tree_mesh_totals{} { struct_size = sizeof *this; }
};

struct OcclusionParams : tree_occlusion_params {
    OcclusionParams() : tree_occlusion_params{} { tree_occlusion_params_init(this, sizeof(tree_occlusion_params)); }
};

struct PackedColumns : tree_packed_columns {
    PackedColumns() : tree_packed_columns{} { struct_size = sizeof *this; }
};

struct PackedVertices : tree_packed_vertices {
    PackedVertices() : tree_packed_vertices{} { struct_size = sizeof *this; }
};

struct Paint : tree_paint {
    Paint() : tree_paint{} { tree_paint_init(this, sizeof(tree_paint)); }
};

struct PathLevel : tree_path_level {
    PathLevel() : tree_path_level{} { tree_path_level_init(this, sizeof(tree_path_level)); }
};

struct PathParams : tree_path_params {
    PathParams() : tree_path_params{} { tree_path_params_init(this, sizeof(tree_path_params)); }
};

struct PathReport : tree_path_report {
    PathReport() : tree_path_report{} { struct_size = sizeof *this; }
};

struct PivotElement : tree_pivot_element {
    PivotElement() : tree_pivot_element{} { struct_size = sizeof *this; }
};

struct Pivots : tree_pivots {
    Pivots() : tree_pivots{} { struct_size = sizeof *this; }
};

struct Pixels : tree_pixels {
    Pixels() : tree_pixels{} { struct_size = sizeof *this; }
};

struct PlyOptions : tree_ply_options {
    PlyOptions() : tree_ply_options{} { tree_ply_options_init(this, sizeof(tree_ply_options)); }
};

struct PoolOptions : tree_pool_options {
    PoolOptions() : tree_pool_options{} { tree_pool_options_init(this, sizeof(tree_pool_options)); }
};

struct ProfileColumns : tree_profile_columns {
    ProfileColumns() : tree_profile_columns{} { struct_size = sizeof *this; }
};

struct ProfileOptions : tree_profile_options {
    ProfileOptions() : tree_profile_options{} { tree_profile_options_init(this, sizeof(tree_profile_options)); }
};

struct RadiusRule : tree_radius_rule {
    RadiusRule() : tree_radius_rule{} { tree_radius_rule_init(this, sizeof(tree_radius_rule)); }
    void check() const;
};

struct SeparationColumns : tree_separation_columns {
    SeparationColumns() : tree_separation_columns{} { struct_size = sizeof *this; }
};

struct SkeletonColumns : tree_skeleton_columns {
    SkeletonColumns() : tree_skeleton_columns{} { struct_size = sizeof *this; }
};

struct SkeletonizeParams : tree_skeletonize_params {
    SkeletonizeParams() : tree_skeletonize_params{} { tree_skeletonize_params_init(this, sizeof(tree_skeletonize_params)); }
};

struct SkeletonizeReport : tree_skeletonize_report {
    SkeletonizeReport() : tree_skeletonize_report{} { struct_size = sizeof *this; }
};

struct Solid : tree_solid {
    Solid() : tree_solid{} { struct_size = sizeof *this; }
};

struct Species : tree_species {
    Species() : tree_species{} { struct_size = sizeof *this; }
};

struct StrewParams : tree_strew_params {
    StrewParams() : tree_strew_params{} { tree_strew_params_init(this, sizeof(tree_strew_params)); }
};

struct Style : tree_style {
    Style() : tree_style{} { tree_style_init(this, sizeof(tree_style)); }
    static Style studio();
};

struct SubdivideParams : tree_subdivide_params {
    SubdivideParams() : tree_subdivide_params{} { tree_subdivide_params_init(this, sizeof(tree_subdivide_params)); }
};

struct Surface : tree_surface {
    Surface() : tree_surface{} { struct_size = sizeof *this; }
};

struct SwcContents : tree_swc_contents {
    SwcContents() : tree_swc_contents{} { struct_size = sizeof *this; }
};

struct SwcOptions : tree_swc_options {
    SwcOptions() : tree_swc_options{} { tree_swc_options_init(this, sizeof(tree_swc_options)); }
};

struct TexturePixels : tree_texture_pixels {
    TexturePixels() : tree_texture_pixels{} { struct_size = sizeof *this; }
};

struct Topology : tree_topology {
    Topology() : tree_topology{} { struct_size = sizeof *this; }
};

struct TwigInstances : tree_twig_instances {
    TwigInstances() : tree_twig_instances{} { struct_size = sizeof *this; }
};

struct TwigParams : tree_twig_params {
    TwigParams() : tree_twig_params{} { tree_twig_params_init(this, sizeof(tree_twig_params)); }
    void check() const;
};

struct TwigReport : tree_twig_report {
    TwigReport() : tree_twig_report{} { struct_size = sizeof *this; }
};

struct UnpackedColumns : tree_unpacked_columns {
    UnpackedColumns() : tree_unpacked_columns{} { struct_size = sizeof *this; }
};

struct View : tree_view {
    View() : tree_view{} { tree_view_init(this, sizeof(tree_view)); }
    View place(const struct tree_mesh *mesh) const;
};

struct Wind : tree_wind {
    Wind() : tree_wind{} { tree_wind_init(this, sizeof(tree_wind)); }
};

class Axes : public detail::Object<tree_axes, tree_axes_free> {
public:
    using Object::Object;
    AxisColumns view() const;
};

class Bytes : public detail::Object<tree_bytes, tree_bytes_free> {
public:
    using Object::Object;
    Span<const uint8_t> view() const;
};

class Cancel : public detail::Object<tree_cancel, tree_cancel_free> {
public:
    using Object::Object;
    static Cancel make();
    void set() const;
};

class Capsules : public detail::Object<tree_capsules, tree_capsules_free> {
public:
    using Object::Object;
    Span<const tree_capsule> view() const;
};

class Crossings : public detail::Object<tree_crossings, tree_crossings_free> {
public:
    using Object::Object;
    CrossingPairs view() const;
};

class FoundLeaves : public detail::Object<tree_found_leaves, tree_found_leaves_free> {
public:
    using Object::Object;
    Foliage foliage() const;
    LeafKinds view() const;
};

class GltfAttributes : public detail::Object<tree_gltf_attributes, tree_gltf_attributes_free> {
public:
    using Object::Object;
    Span<const tree_gltf_attribute> view() const;
};

class GltfLeaves : public detail::Object<tree_gltf_leaves, tree_gltf_leaves_free> {
public:
    using Object::Object;
    Span<const tree_gltf_instances> view() const;
};

class Graph : public detail::Object<tree_graph, tree_graph_free> {
public:
    using Object::Object;
    static Graph link(const struct tree_graph_nodes *nodes, Ref<tree_link_params> params, uint64_t seed, Ref<tree_control> control = nullptr);
    static Graph from_edges(const float *positions, size_t n_nodes, const uint32_t *edges, const float *costs, size_t n_edges, Ref<tree_control> control = nullptr);
    GraphColumns view() const;
    void search(uint32_t root, Ref<tree_control> control, float *costs, uint32_t *predecessors, size_t capacity) const;
};

class GraphNodes : public detail::Object<tree_graph_nodes, tree_graph_nodes_free> {
public:
    using Object::Object;
    GraphNodesColumns view() const;
};

class LeafModel : public detail::Object<tree_leaf_model, tree_leaf_model_free> {
public:
    using Object::Object;
    LeafMesh view() const;
};

class Look : public detail::Object<tree_look, tree_look_free> {
public:
    using Object::Object;
    static Look built_in(Ref<tree_species> species = nullptr);
    static Look plain(Ref<tree_species> species = nullptr);
    static Look of_tree(const struct tree_tree *tree, uint32_t plain);
    static Look make(Ref<tree_material> bark, Span<const tree_leaf_look> leaves, Ref<tree_control> control = nullptr);
    size_t leaf_count() const;
    Material material(size_t number) const;
    Texture texture(size_t number) const;
    LeafLook leaf(size_t kind) const;
    void check(Ref<tree_species> species = nullptr) const;
    LeafModel leaf_model(size_t kind, Ref<tree_control> control = nullptr, tree_leaf_model_report *report = nullptr) const;
    LeafMesh leaf_mesh(size_t kind) const;
};

class Mask : public detail::Object<tree_mask, tree_mask_free> {
public:
    using Object::Object;
    MaskColumns view() const;
    void bits(uint8_t *bits, size_t capacity) const;
    Picture picture() const;
};

class Mesh : public detail::Object<tree_mesh, tree_mesh_free> {
public:
    using Object::Object;
    BranchMotion branch_motion(size_t branch) const;
    float branch_reach(size_t branch, const float *point) const;
    Packed pack(size_t surface, tree_layout layout, Ref<tree_control> control = nullptr) const;
    void wind(size_t surface, struct tree_vertex_wind *rows, size_t capacity) const;
    void bend(Ref<tree_wind> wind, float seconds, size_t surface, float *positions, size_t capacity) const;
    void write_glb(std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_glb(Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    static std::tuple<Mesh, GltfLeaves> build_instanced(const struct tree_tree *tree, const struct tree_look *look, Ref<tree_mesh_params> params = nullptr, Ref<tree_control> control = nullptr);
    GltfAttributes gltf_wind(Ref<tree_control> control = nullptr) const;
    void write_obj(std::string_view path, Ref<tree_control> control = nullptr) const;
    std::tuple<Bytes, Bytes> to_obj(std::string_view stem, Ref<tree_control> control = nullptr) const;
    void write_ply(std::string_view path, Ref<tree_ply_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_ply(Ref<tree_ply_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    static Mesh read(std::string_view path, Ref<tree_import_options> options = nullptr, Ref<tree_control> control = nullptr, tree_import_report *report = nullptr);
    static Mesh from_bytes(tree_mesh_format format, Span<const uint8_t> data, Span<const uint8_t> mtl, Ref<tree_control> control = nullptr, tree_import_report *report = nullptr);
    Span<const tree_wind_branch> branches() const;
    static Mesh build(const struct tree_tree *tree, const struct tree_look *look, Ref<tree_mesh_params> params = nullptr, Ref<tree_control> control = nullptr, tree_mesh_report *report = nullptr);
    Mesh subdivide(size_t number, Ref<tree_subdivide_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    Mesh displace(size_t number, Ref<tree_displace_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    Mesh bake_occlusion(Ref<tree_occlusion_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    Mesh weld(size_t number, Ref<tree_control> control = nullptr) const;
    static Mesh from_surfaces(Span<const tree_surface> surfaces, Span<const tree_material> materials, Span<const tree_wind_branch> branches, Ref<tree_control> control = nullptr);
    Material material(size_t number) const;
    Texture texture(size_t number) const;
    Topology examine(size_t number, Ref<tree_control> control = nullptr) const;
    size_t points(size_t number, uint32_t *of_vertex, size_t of_vertex_capacity, uint32_t *first, size_t first_capacity) const;
    Crossings crossings(size_t number, Ref<tree_control> control = nullptr) const;
    MeshTotals count() const;
    size_t surface_count() const;
    Surface surface(size_t number) const;
    Bounds surface_bounds(size_t number) const;
    Bounds bounds() const;
    void check() const;
    void check_surface(size_t number) const;
    void check_colors() const;
    void check_normals() const;
    Picture render(Ref<tree_view> view = nullptr, Ref<tree_style> style = nullptr, Ref<tree_control> control = nullptr) const;
    Mask render_mask(Ref<tree_view> view = nullptr, Ref<tree_control> control = nullptr) const;
    Picture render_silhouette(Ref<tree_view> view = nullptr, Ref<tree_control> control = nullptr) const;
    Tree skeletonize_mesh(const tree_hint *hints, size_t n_hints, Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr, tree_skeletonize_report *report = nullptr) const;
};

class Packed : public detail::Object<tree_packed, tree_packed_free> {
public:
    using Object::Object;
    PackedColumns view() const;
    Pivots pivots() const;
    PivotElement pivot_element(uint32_t number) const;
    Unpacked unpack(const struct tree_mesh *mesh) const;
    PackedVertices vertices_view() const;
};

class Picture : public detail::Object<tree_picture, tree_picture_free> {
public:
    using Object::Object;
    static Picture from_pixels(uint32_t width, uint32_t height, Span<const uint8_t> pixels, Ref<tree_control> control = nullptr);
    Pixels view() const;
    void write_png(std::string_view path) const;
    Bytes to_png() const;
};

class Pieces : public detail::Object<tree_pieces, tree_pieces_free> {
public:
    using Object::Object;
    static std::tuple<Skeleton, Pieces> make(Span<const tree_piece> rows, Ref<tree_control> control = nullptr);
    size_t count() const;
    std::tuple<tree_piece, Skeleton> piece(size_t index) const;
    Skeleton link(Ref<tree_skeletonize_params> params, Ref<tree_control> control, uint8_t *reached, size_t capacity) const;
};

class Pool : public detail::Object<tree_pool, tree_pool_free> {
public:
    using Object::Object;
    static Pool make(Ref<tree_pool_options> options = nullptr);
    uint32_t threads() const;
};

class Profile : public detail::Object<tree_profile, tree_profile_free> {
public:
    using Object::Object;
    static Profile from_svg(std::string_view svg, Ref<tree_profile_options> options = nullptr, Ref<tree_control> control = nullptr);
    ProfileColumns view() const;
    Volume volume(const float *base) const;
};

class Rows : public detail::Object<tree_rows, tree_rows_free> {
public:
    using Object::Object;
    Span<const uint32_t> view() const;
};

class Separation : public detail::Object<tree_separation, tree_separation_free> {
public:
    using Object::Object;
    FoundLeaves leaves(const struct tree_skeleton *skeleton, Ref<tree_control> control = nullptr) const;
    Pieces follow(Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    static Separation make(Span<const tree_mesh_part> parts, Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr);
    static Separation of_mesh(const struct tree_mesh *mesh, const tree_hint *hints, size_t n_hints, Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr);
    SeparationColumns view() const;
    Separation with_classes(const tree_class *classes, size_t n_classes) const;
    Skeleton outward(const struct tree_skeleton *skeleton) const;
};

class Skeleton : public detail::Object<tree_skeleton, tree_skeleton_free> {
public:
    using Object::Object;
    void radii(Ref<tree_radius_rule> rule, float *radii, size_t capacity) const;
    Skeleton by_rule(Ref<tree_radius_rule> rule = nullptr) const;
    void radii_at_levels(const uint32_t *levels, size_t n_levels, Ref<tree_radius_rule> rule, float *radii, size_t capacity) const;
    void strands(Ref<tree_radius_rule> rule, uint64_t *strands, size_t capacity) const;
    WindBranches wind_branches(tree_continuation continuation) const;
    Capsules capsules(Ref<tree_capsule_params> params = nullptr, Ref<tree_control> control = nullptr, tree_capsule_report *report = nullptr) const;
    std::tuple<Rows, Skeleton> refine(float bearing, float spacing, Ref<tree_control> control = nullptr) const;
    static Skeleton from_columns(Ref<tree_skeleton_columns> columns = nullptr, Ref<tree_control> control = nullptr);
    static Skeleton from_unordered(Ref<tree_skeleton_columns> columns, Ref<tree_control> control, uint32_t *rows);
    SkeletonColumns view() const;
    std::array<float, 6> bounds() const;
    Axes axes(tree_continuation rule) const;
    Skeleton with_radii(const float *radii, size_t n) const;
    Skeleton with_positions(const float *positions, size_t n) const;
    void segment_lengths(float *lengths, size_t capacity) const;
    void distances_to_root(float *distances, size_t capacity) const;
    void distances_to_tip(float *distances, size_t capacity) const;
    void subtree_sizes(uint32_t *sizes, size_t capacity) const;
    void tip_counts(uint32_t *counts, size_t capacity) const;
    void children(uint32_t *starts, size_t starts_capacity, uint32_t *nodes, size_t nodes_capacity) const;
    void write_swc(std::string_view path, Ref<tree_swc_options> options = nullptr) const;
    Bytes to_swc(Ref<tree_swc_options> options = nullptr) const;
};

class Swc : public detail::Object<tree_swc, tree_swc_free> {
public:
    using Object::Object;
    static Swc read(std::string_view path, Ref<tree_swc_options> options = nullptr, Ref<tree_control> control = nullptr);
    static Swc from_text(std::string_view text, Ref<tree_swc_options> options = nullptr, Ref<tree_control> control = nullptr);
    Skeleton skeleton() const;
    SwcContents view() const;
};

class Texture : public detail::Object<tree_texture, tree_texture_free> {
public:
    using Object::Object;
    static Texture bark_with(Ref<tree_bark_style> style, uint32_t size, Ref<tree_control> control = nullptr);
    static std::tuple<LeafCard, Texture> leaf_with(Ref<tree_leaf_shape> shape, uint32_t size, Ref<tree_control> control = nullptr);
    static Texture from_pixels(Ref<tree_texture_pixels> pixels = nullptr, Ref<tree_control> control = nullptr);
    static Texture from_bytes(std::string_view name, Span<const uint8_t> data, Ref<tree_control> control = nullptr);
    static Texture read(std::string_view path, Ref<tree_control> control = nullptr);
    static Texture bark(std::string_view name, uint32_t size, Ref<tree_control> control = nullptr);
    static std::tuple<LeafCard, Texture> leaf(std::string_view name, uint32_t size, Ref<tree_control> control = nullptr);
    TexturePixels view() const;
    Bytes to_png() const;
    void write_png(std::string_view path) const;
};

class Tree : public detail::Object<tree_tree, tree_tree_free> {
public:
    using Object::Object;
    Tree grow_leaves(Ref<tree_leaf_params> params, tree_density_fn density, void *user, uint32_t with_stalks, uint64_t seed, Ref<tree_control> control = nullptr, tree_leaf_report *report = nullptr) const;
    Tree grow_twigs(Ref<tree_twig_params> params, tree_density_fn density, void *user, uint64_t seed, Ref<tree_control> control = nullptr, tree_twig_report *report = nullptr) const;
    static Tree make(const struct tree_skeleton *skeleton, Ref<tree_foliage> foliage = nullptr, Ref<tree_species> species = nullptr, Ref<tree_control> control = nullptr);
    Skeleton skeleton() const;
    Foliage foliage() const;
    Species species() const;
};

class Twigs : public detail::Object<tree_twigs, tree_twigs_free> {
public:
    using Object::Object;
    static Twigs build(const struct tree_tree *tree, const struct tree_look *look, Ref<tree_mesh_params> mesh_params, Ref<tree_instancing_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_instancing_report *report = nullptr);
    size_t count() const;
    InstancingReport report() const;
    Mesh base() const;
    Mesh mesh(size_t number) const;
    TwigInstances instances(size_t number) const;
    static std::tuple<Mesh, Twigs> from_parts(const struct tree_mesh *base, Span<const tree_twig_instances> instances, Ref<tree_control> control = nullptr);
    Mesh flatten(Ref<tree_control> control = nullptr) const;
};

class Unpacked : public detail::Object<tree_unpacked, tree_unpacked_free> {
public:
    using Object::Object;
    UnpackedColumns view() const;
};

class Volume : public detail::Object<tree_volume, tree_volume_free> {
public:
    using Object::Object;
    GraphNodes graph_strew(Ref<tree_strew_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    static Volume from_svg(std::string_view svg, Ref<tree_profile_options> options, const float *base, Ref<tree_control> control = nullptr);
    bool obstacle_is_free(float clearance, const float *a, const float *b) const;
    static Volume union_(Span<const tree_volume *const> volumes);
    static Volume intersection(Span<const tree_volume *const> volumes);
    Volume difference(const struct tree_volume *without) const;
    Volume transformed(const float *columns) const;
    void contains(const float *points, size_t n_points, Ref<tree_control> control, uint8_t *inside) const;
    void distance(const float *points, size_t n_points, Ref<tree_control> control, float *distances) const;
    bool distance_is_exact() const;
    std::array<float, 6> bounds() const;
    bool is_bounded() const;
    float measure() const;
    float estimate_measure(uint32_t n_samples, Ref<tree_control> control = nullptr) const;
    void sample(size_t n_points, uint32_t attempts, uint64_t seed, Ref<tree_control> control, float *points) const;
    static Volume sphere(const float *center, float radius);
    static Volume ellipsoid(const float *center, const float *radii);
    static Volume cylinder(const float *base, const float *top, float radius);
    static Volume frustum(const float *base, const float *top, float base_radius, float top_radius);
    static Volume cone(const float *base, const float *apex, float base_radius);
    static Volume capsule(const float *start, const float *end, float radius);
    static Volume box(const float *min, const float *max);
    static Volume half_space(const float *point, const float *normal);
    static Volume sector(const float *apex, const float *axis, float angle, float radius);
    static Volume revolution(const float *base, const float *axis, const float *profile, size_t n_points, Ref<tree_control> control = nullptr);
    static Volume closed_mesh(const float *positions, size_t n_positions, const uint32_t *indices, size_t n_triangles, Ref<tree_control> control = nullptr);
    Solid view() const;
    Volume part(size_t index) const;
};

class WindBranches : public detail::Object<tree_wind_branches, tree_wind_branches_free> {
public:
    using Object::Object;
    Span<const tree_wind_branch> view() const;
};

std::array<float, 2> murray_angles(float r0, float r1, float r2);
std::array<float, 2> pipe_angles(float exponent, float r1, float r2);
std::array<float, 2> strand_angles(uint64_t s1, uint64_t s2, float sum);
std::string_view status_name(tree_status status);
void capsule_contains(const struct tree_capsule *capsule, const float *point, uint32_t *inside);
double capsule_volume(const struct tree_capsule *capsule);
ConventionTraits convention_view(tree_convention convention);
void convert_positions(tree_convention convention, tree_convert way, const float *from, size_t n, float *to);
void convert_directions(tree_convention convention, tree_convert way, const float *from, size_t n, float *to);
void convert_tangents(tree_convention convention, tree_convert way, const float *from, size_t n, float *to);
void convert_uvs(tree_convention convention, const float *from, size_t n, float *to);
void convert_triangles(tree_convention convention, const uint32_t *from, size_t n_triangles, uint32_t *to);
float wind_sway(float reach);
float wind_leaf_phase(uint32_t leaf);
size_t foliage_species_count();
std::string_view foliage_species_name(size_t index);
std::tuple<LeafParams, TwigParams, std::string_view> foliage_preset(std::string_view name);
void gltf_write_glb(Span<const tree_gltf_level> levels, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr);
Bytes gltf_to_glb(Span<const tree_gltf_level> levels, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr);
void gltf_write_files(Span<const tree_gltf_level> levels, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr);
std::string_view note_text(tree_note note);
BarkStyle bark_style_of(std::string_view name);
LeafShape leaf_shape_of(std::string_view name);
Span<const tree_str> bark_names();
Span<const tree_str> leaf_names();
uint64_t memory_used();
uint64_t memory_peak();
void memory_reset_peak();
void memory_set_budget(uint64_t bytes);
uint64_t memory_budget();
void memory_set_allocator(Ref<tree_allocator> allocator = nullptr);
Tree path_grow(Ref<tree_path_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_path_report *report = nullptr);
std::tuple<Bytes, Tree> path_grow_with_levels(Ref<tree_path_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_path_report *report = nullptr);
void path_check(Ref<tree_path_params> params = nullptr, Ref<tree_control> control = nullptr);
float path_level_radius(Ref<tree_path_params> params, size_t index);
size_t path_preset_count();
std::tuple<std::string_view, std::string_view> path_preset_name(size_t index);
float path_preset_paper_seconds(size_t index);
PathParams path_preset(std::string_view name);
Tree skeletonize(Span<const tree_mesh_part> parts, Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr, tree_skeletonize_report *report = nullptr);
uint32_t abi_version();
std::string_view version();
size_t live_objects();

inline std::array<float, 2> murray_angles(float r0, float r1, float r2) {
    std::array<float, 2> angles{};
    tree::check(tree_murray_angles(r0, r1, r2, reinterpret_cast<float(*)[2]>(angles.data())));
    return angles;
}
inline std::array<float, 2> pipe_angles(float exponent, float r1, float r2) {
    std::array<float, 2> angles{};
    tree::check(tree_pipe_angles(exponent, r1, r2, reinterpret_cast<float(*)[2]>(angles.data())));
    return angles;
}
inline std::array<float, 2> strand_angles(uint64_t s1, uint64_t s2, float sum) {
    std::array<float, 2> angles{};
    tree::check(tree_strand_angles(s1, s2, sum, reinterpret_cast<float(*)[2]>(angles.data())));
    return angles;
}
inline void Skeleton::radii(Ref<tree_radius_rule> rule, float *radii, size_t capacity) const {
    tree::check(tree_skeleton_radii(get(), rule, radii, capacity));
}
inline Skeleton Skeleton::by_rule(Ref<tree_radius_rule> rule) const {
    tree_skeleton *changed = nullptr;
    tree::check(tree_skeleton_by_rule(get(), rule, &changed));
    return Skeleton(changed);
}
inline void Skeleton::radii_at_levels(const uint32_t *levels, size_t n_levels, Ref<tree_radius_rule> rule, float *radii, size_t capacity) const {
    tree::check(tree_skeleton_radii_at_levels(get(), levels, n_levels, rule, radii, capacity));
}
inline void Skeleton::strands(Ref<tree_radius_rule> rule, uint64_t *strands, size_t capacity) const {
    tree::check(tree_skeleton_strands(get(), rule, strands, capacity));
}
inline void RadiusRule::check() const {
    tree::check(tree_radius_rule_check(this));
}
inline std::string_view status_name(tree_status status) {
    return tree_status_name(status);
}
inline Limits Limits::for_memory(uint64_t bytes) {
    Limits limits;
    tree::check(tree_limits_for_memory(&limits, sizeof(tree_limits), bytes));
    return limits;
}
inline Cancel Cancel::make() {
    tree_cancel *cancel = nullptr;
    tree::check(tree_cancel_new(&cancel));
    return Cancel(cancel);
}
inline void Cancel::set() const {
    tree::check(tree_cancel_set(get()));
}
inline BranchMotion Mesh::branch_motion(size_t branch) const {
    BranchMotion motion;
    tree::check(tree_mesh_branch_motion(get(), branch, &motion));
    return motion;
}
inline float Mesh::branch_reach(size_t branch, const float *point) const {
    float reach = 0;
    tree::check(tree_mesh_branch_reach(get(), branch, point, &reach));
    return reach;
}
inline WindBranches Skeleton::wind_branches(tree_continuation continuation) const {
    tree_wind_branches *branches = nullptr;
    tree::check(tree_skeleton_wind_branches(get(), continuation, &branches));
    return WindBranches(branches);
}
inline Span<const tree_wind_branch> WindBranches::view() const {
    const tree_wind_branch *rows = nullptr; size_t n = 0;
    tree::check(tree_wind_branches_view(get(), &rows, &n));
    return Span<const tree_wind_branch>(rows, n);
}
inline Capsules Skeleton::capsules(Ref<tree_capsule_params> params, Ref<tree_control> control, tree_capsule_report *report) const {
    tree_capsules *capsules = nullptr;
    tree::check(tree_skeleton_capsules(get(), params, control, report, &capsules));
    return Capsules(capsules);
}
inline Span<const tree_capsule> Capsules::view() const {
    const tree_capsule *rows = nullptr; size_t n = 0;
    tree::check(tree_capsules_view(get(), &rows, &n));
    return Span<const tree_capsule>(rows, n);
}
inline void capsule_contains(const struct tree_capsule *capsule, const float *point, uint32_t *inside) {
    tree::check(tree_capsule_contains(capsule, point, inside));
}
inline double capsule_volume(const struct tree_capsule *capsule) {
    double volume = 0;
    tree::check(tree_capsule_volume(capsule, &volume));
    return volume;
}
inline ConventionTraits convention_view(tree_convention convention) {
    ConventionTraits traits;
    tree::check(tree_convention_view(convention, &traits));
    return traits;
}
inline void convert_positions(tree_convention convention, tree_convert way, const float *from, size_t n, float *to) {
    tree::check(tree_convert_positions(convention, way, from, n, to));
}
inline void convert_directions(tree_convention convention, tree_convert way, const float *from, size_t n, float *to) {
    tree::check(tree_convert_directions(convention, way, from, n, to));
}
inline void convert_tangents(tree_convention convention, tree_convert way, const float *from, size_t n, float *to) {
    tree::check(tree_convert_tangents(convention, way, from, n, to));
}
inline void convert_uvs(tree_convention convention, const float *from, size_t n, float *to) {
    tree::check(tree_convert_uvs(convention, from, n, to));
}
inline void convert_triangles(tree_convention convention, const uint32_t *from, size_t n_triangles, uint32_t *to) {
    tree::check(tree_convert_triangles(convention, from, n_triangles, to));
}
inline Packed Mesh::pack(size_t surface, tree_layout layout, Ref<tree_control> control) const {
    tree_packed *packed = nullptr;
    tree::check(tree_mesh_pack(get(), surface, layout, control, &packed));
    return Packed(packed);
}
inline PackedColumns Packed::view() const {
    PackedColumns columns;
    tree::check(tree_packed_view(get(), &columns));
    return columns;
}
inline Pivots Packed::pivots() const {
    Pivots pivots;
    tree::check(tree_packed_pivots(get(), &pivots));
    return pivots;
}
inline PivotElement Packed::pivot_element(uint32_t number) const {
    PivotElement element;
    tree::check(tree_packed_pivot_element(get(), number, &element));
    return element;
}
inline Unpacked Packed::unpack(const struct tree_mesh *mesh) const {
    tree_unpacked *unpacked = nullptr;
    tree::check(tree_packed_unpack(get(), mesh, &unpacked));
    return Unpacked(unpacked);
}
inline UnpackedColumns Unpacked::view() const {
    UnpackedColumns columns;
    tree::check(tree_unpacked_view(get(), &columns));
    return columns;
}
inline PackedVertices Packed::vertices_view() const {
    PackedVertices vertices;
    tree::check(tree_packed_vertices_view(get(), &vertices));
    return vertices;
}
inline void Mesh::wind(size_t surface, struct tree_vertex_wind *rows, size_t capacity) const {
    tree::check(tree_mesh_wind(get(), surface, rows, capacity));
}
inline void Mesh::bend(Ref<tree_wind> wind, float seconds, size_t surface, float *positions, size_t capacity) const {
    tree::check(tree_mesh_bend(get(), wind, seconds, surface, positions, capacity));
}
inline float wind_sway(float reach) {
    float sway = 0;
    tree::check(tree_wind_sway(reach, &sway));
    return sway;
}
inline float wind_leaf_phase(uint32_t leaf) {
    float phase = 0;
    tree::check(tree_wind_leaf_phase(leaf, &phase));
    return phase;
}
inline Tree Tree::grow_leaves(Ref<tree_leaf_params> params, tree_density_fn density, void *user, uint32_t with_stalks, uint64_t seed, Ref<tree_control> control, tree_leaf_report *report) const {
    tree_tree *grown = nullptr;
    tree::check(tree_tree_grow_leaves(get(), params, density, user, with_stalks, seed, control, report, &grown));
    return Tree(grown);
}
inline Tree Tree::grow_twigs(Ref<tree_twig_params> params, tree_density_fn density, void *user, uint64_t seed, Ref<tree_control> control, tree_twig_report *report) const {
    tree_tree *grown = nullptr;
    tree::check(tree_tree_grow_twigs(get(), params, density, user, seed, control, report, &grown));
    return Tree(grown);
}
inline void LeafParams::check(size_t n_kinds) const {
    tree::check(tree_leaf_params_check(this, n_kinds));
}
inline size_t foliage_species_count() {
    return tree_foliage_species_count();
}
inline std::string_view foliage_species_name(size_t index) {
    tree_str name{};
    tree::check(tree_foliage_species_name(index, &name));
    return detail::text(name);
}
inline std::tuple<LeafParams, TwigParams, std::string_view> foliage_preset(std::string_view name) {
    LeafParams leaves; TwigParams twigs; tree_str leaf_kind{};
    tree::check(tree_foliage_preset(name.data() ? name.data() : "", name.size(), &leaves, &twigs, &leaf_kind));
    return {leaves, twigs, detail::text(leaf_kind)};
}
inline Span<const uint32_t> Rows::view() const {
    const uint32_t *first = nullptr; size_t n = 0;
    tree::check(tree_rows_view(get(), &first, &n));
    return Span<const uint32_t>(first, n);
}
inline std::tuple<Rows, Skeleton> Skeleton::refine(float bearing, float spacing, Ref<tree_control> control) const {
    tree_rows *rows = nullptr; tree_skeleton *refined = nullptr;
    tree::check(tree_skeleton_refine(get(), bearing, spacing, control, &rows, &refined));
    return {Rows(rows), Skeleton(refined)};
}
inline void TwigParams::check() const {
    tree::check(tree_twig_params_check(this));
}
inline Twigs Twigs::build(const struct tree_tree *tree, const struct tree_look *look, Ref<tree_mesh_params> mesh_params, Ref<tree_instancing_params> params, uint64_t seed, Ref<tree_control> control, tree_instancing_report *report) {
    tree_twigs *twigs = nullptr;
    tree::check(tree_twigs_build(tree, look, mesh_params, params, seed, control, report, &twigs));
    return Twigs(twigs);
}
inline size_t Twigs::count() const {
    size_t n_twigs = 0;
    tree::check(tree_twigs_count(get(), &n_twigs));
    return n_twigs;
}
inline InstancingReport Twigs::report() const {
    InstancingReport report;
    tree::check(tree_twigs_report(get(), &report));
    return report;
}
inline Mesh Twigs::base() const {
    tree_mesh *base = nullptr;
    tree::check(tree_twigs_base(get(), &base));
    return Mesh(base);
}
inline Mesh Twigs::mesh(size_t number) const {
    tree_mesh *mesh = nullptr;
    tree::check(tree_twigs_mesh(get(), number, &mesh));
    return Mesh(mesh);
}
inline TwigInstances Twigs::instances(size_t number) const {
    TwigInstances instances;
    tree::check(tree_twigs_instances(get(), number, &instances));
    return instances;
}
inline std::tuple<Mesh, Twigs> Twigs::from_parts(const struct tree_mesh *base, Span<const tree_twig_instances> instances, Ref<tree_control> control) {
    tree_mesh *meshes = nullptr; tree_twigs *twigs = nullptr;
    tree::check(tree_twigs_from_parts(base, &meshes, instances.data(), instances.size(), control, &twigs));
    return {Mesh(meshes), Twigs(twigs)};
}
inline Mesh Twigs::flatten(Ref<tree_control> control) const {
    tree_mesh *mesh = nullptr;
    tree::check(tree_twigs_flatten(get(), control, &mesh));
    return Mesh(mesh);
}
inline Span<const uint8_t> Bytes::view() const {
    const uint8_t *data = nullptr; size_t len = 0;
    tree::check(tree_bytes_view(get(), &data, &len));
    return Span<const uint8_t>(data, len);
}
inline void Mesh::write_glb(std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    tree::check(tree_mesh_write_glb(get(), path.data() ? path.data() : "", path.size(), options, control));
}
inline Bytes Mesh::to_glb(Ref<tree_glb_options> options, Ref<tree_control> control) const {
    tree_bytes *bytes = nullptr;
    tree::check(tree_mesh_to_glb(get(), options, control, &bytes));
    return Bytes(bytes);
}
inline void gltf_write_glb(Span<const tree_gltf_level> levels, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) {
    tree::check(tree_gltf_write_glb(levels.data(), levels.size(), path.data() ? path.data() : "", path.size(), options, control));
}
inline Bytes gltf_to_glb(Span<const tree_gltf_level> levels, Ref<tree_glb_options> options, Ref<tree_control> control) {
    tree_bytes *bytes = nullptr;
    tree::check(tree_gltf_to_glb(levels.data(), levels.size(), options, control, &bytes));
    return Bytes(bytes);
}
inline void gltf_write_files(Span<const tree_gltf_level> levels, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) {
    tree::check(tree_gltf_write_files(levels.data(), levels.size(), path.data() ? path.data() : "", path.size(), options, control));
}
inline std::tuple<Mesh, GltfLeaves> Mesh::build_instanced(const struct tree_tree *tree, const struct tree_look *look, Ref<tree_mesh_params> params, Ref<tree_control> control) {
    tree_mesh *bark = nullptr; tree_gltf_leaves *leaves = nullptr;
    tree::check(tree_mesh_build_instanced(tree, look, params, control, &bark, &leaves));
    return {Mesh(bark), GltfLeaves(leaves)};
}
inline Span<const tree_gltf_instances> GltfLeaves::view() const {
    const tree_gltf_instances *rows = nullptr; size_t n = 0;
    tree::check(tree_gltf_leaves_view(get(), &rows, &n));
    return Span<const tree_gltf_instances>(rows, n);
}
inline GltfAttributes Mesh::gltf_wind(Ref<tree_control> control) const {
    tree_gltf_attributes *attributes = nullptr;
    tree::check(tree_mesh_gltf_wind(get(), control, &attributes));
    return GltfAttributes(attributes);
}
inline Span<const tree_gltf_attribute> GltfAttributes::view() const {
    const tree_gltf_attribute *rows = nullptr; size_t n = 0;
    tree::check(tree_gltf_attributes_view(get(), &rows, &n));
    return Span<const tree_gltf_attribute>(rows, n);
}
inline std::string_view note_text(tree_note note) {
    tree_str text{};
    tree::check(tree_note_text(note, &text));
    return detail::text(text);
}
inline void Mesh::write_obj(std::string_view path, Ref<tree_control> control) const {
    tree::check(tree_mesh_write_obj(get(), path.data() ? path.data() : "", path.size(), control));
}
inline std::tuple<Bytes, Bytes> Mesh::to_obj(std::string_view stem, Ref<tree_control> control) const {
    tree_bytes *obj = nullptr; tree_bytes *mtl = nullptr;
    tree::check(tree_mesh_to_obj(get(), stem.data() ? stem.data() : "", stem.size(), control, &obj, &mtl));
    return {Bytes(obj), Bytes(mtl)};
}
inline void Mesh::write_ply(std::string_view path, Ref<tree_ply_options> options, Ref<tree_control> control) const {
    tree::check(tree_mesh_write_ply(get(), path.data() ? path.data() : "", path.size(), options, control));
}
inline Bytes Mesh::to_ply(Ref<tree_ply_options> options, Ref<tree_control> control) const {
    tree_bytes *bytes = nullptr;
    tree::check(tree_mesh_to_ply(get(), options, control, &bytes));
    return Bytes(bytes);
}
inline Mesh Mesh::read(std::string_view path, Ref<tree_import_options> options, Ref<tree_control> control, tree_import_report *report) {
    tree_mesh *mesh = nullptr;
    tree::check(tree_mesh_read(path.data() ? path.data() : "", path.size(), options, control, report, &mesh));
    return Mesh(mesh);
}
inline Mesh Mesh::from_bytes(tree_mesh_format format, Span<const uint8_t> data, Span<const uint8_t> mtl, Ref<tree_control> control, tree_import_report *report) {
    tree_mesh *mesh = nullptr;
    tree::check(tree_mesh_from_bytes(format, data.data(), data.size(), mtl.data(), mtl.size(), control, report, &mesh));
    return Mesh(mesh);
}
inline Look Look::built_in(Ref<tree_species> species) {
    tree_look *look = nullptr;
    tree::check(tree_look_built_in(species, &look));
    return Look(look);
}
inline Look Look::plain(Ref<tree_species> species) {
    tree_look *look = nullptr;
    tree::check(tree_look_plain(species, &look));
    return Look(look);
}
inline Look Look::of_tree(const struct tree_tree *tree, uint32_t plain) {
    tree_look *look = nullptr;
    tree::check(tree_look_of_tree(tree, plain, &look));
    return Look(look);
}
inline Look Look::make(Ref<tree_material> bark, Span<const tree_leaf_look> leaves, Ref<tree_control> control) {
    tree_look *look = nullptr;
    tree::check(tree_look_new(bark, leaves.data(), leaves.size(), control, &look));
    return Look(look);
}
inline size_t Look::leaf_count() const {
    size_t n_leaves = 0;
    tree::check(tree_look_leaf_count(get(), &n_leaves));
    return n_leaves;
}
inline Material Look::material(size_t number) const {
    Material material;
    tree::check(tree_look_material(get(), number, &material));
    return material;
}
inline Texture Look::texture(size_t number) const {
    tree_texture *texture = nullptr;
    tree::check(tree_look_texture(get(), number, &texture));
    return Texture(texture);
}
inline LeafLook Look::leaf(size_t kind) const {
    LeafLook leaf;
    tree::check(tree_look_leaf(get(), kind, &leaf));
    return leaf;
}
inline void Look::check(Ref<tree_species> species) const {
    tree::check(tree_look_check(get(), species));
}
inline BarkStyle bark_style_of(std::string_view name) {
    BarkStyle style;
    tree::check(tree_bark_style_of(name.data() ? name.data() : "", name.size(), &style));
    return style;
}
inline Texture Texture::bark_with(Ref<tree_bark_style> style, uint32_t size, Ref<tree_control> control) {
    tree_texture *texture = nullptr;
    tree::check(tree_texture_bark_with(style, size, control, &texture));
    return Texture(texture);
}
inline LeafModel Look::leaf_model(size_t kind, Ref<tree_control> control, tree_leaf_model_report *report) const {
    tree_leaf_model *model = nullptr;
    tree::check(tree_look_leaf_model(get(), kind, control, report, &model));
    return LeafModel(model);
}
inline LeafMesh LeafModel::view() const {
    LeafMesh mesh;
    tree::check(tree_leaf_model_view(get(), &mesh));
    return mesh;
}
inline LeafMesh Look::leaf_mesh(size_t kind) const {
    LeafMesh mesh;
    tree::check(tree_look_leaf_mesh(get(), kind, &mesh));
    return mesh;
}
inline LeafShape leaf_shape_of(std::string_view name) {
    LeafShape shape;
    tree::check(tree_leaf_shape_of(name.data() ? name.data() : "", name.size(), &shape));
    return shape;
}
inline void LeafShape::autumn(float progress) {
    tree::check(tree_leaf_shape_autumn(this, progress));
}
inline std::tuple<LeafCard, Texture> Texture::leaf_with(Ref<tree_leaf_shape> shape, uint32_t size, Ref<tree_control> control) {
    LeafCard card; tree_texture *texture = nullptr;
    tree::check(tree_texture_leaf_with(shape, size, control, &card, &texture));
    return {card, Texture(texture)};
}
inline Span<const tree_str> bark_names() {
    const tree_str *names = nullptr; size_t n_names = 0;
    tree::check(tree_bark_names(&names, &n_names));
    return Span<const tree_str>(names, n_names);
}
inline Span<const tree_str> leaf_names() {
    const tree_str *names = nullptr; size_t n_names = 0;
    tree::check(tree_leaf_names(&names, &n_names));
    return Span<const tree_str>(names, n_names);
}
inline Texture Texture::from_pixels(Ref<tree_texture_pixels> pixels, Ref<tree_control> control) {
    tree_texture *texture = nullptr;
    tree::check(tree_texture_from_pixels(pixels, control, &texture));
    return Texture(texture);
}
inline Texture Texture::from_bytes(std::string_view name, Span<const uint8_t> data, Ref<tree_control> control) {
    tree_texture *texture = nullptr;
    tree::check(tree_texture_from_bytes(name.data() ? name.data() : "", name.size(), data.data(), data.size(), control, &texture));
    return Texture(texture);
}
inline Texture Texture::read(std::string_view path, Ref<tree_control> control) {
    tree_texture *texture = nullptr;
    tree::check(tree_texture_read(path.data() ? path.data() : "", path.size(), control, &texture));
    return Texture(texture);
}
inline Texture Texture::bark(std::string_view name, uint32_t size, Ref<tree_control> control) {
    tree_texture *texture = nullptr;
    tree::check(tree_texture_bark(name.data() ? name.data() : "", name.size(), size, control, &texture));
    return Texture(texture);
}
inline std::tuple<LeafCard, Texture> Texture::leaf(std::string_view name, uint32_t size, Ref<tree_control> control) {
    LeafCard card; tree_texture *texture = nullptr;
    tree::check(tree_texture_leaf(name.data() ? name.data() : "", name.size(), size, control, &card, &texture));
    return {card, Texture(texture)};
}
inline TexturePixels Texture::view() const {
    TexturePixels pixels;
    tree::check(tree_texture_view(get(), &pixels));
    return pixels;
}
inline Bytes Texture::to_png() const {
    tree_bytes *png = nullptr;
    tree::check(tree_texture_to_png(get(), &png));
    return Bytes(png);
}
inline void Texture::write_png(std::string_view path) const {
    tree::check(tree_texture_write_png(get(), path.data() ? path.data() : "", path.size()));
}
inline uint64_t memory_used() {
    return tree_memory_used();
}
inline uint64_t memory_peak() {
    return tree_memory_peak();
}
inline void memory_reset_peak() {
    tree_memory_reset_peak();
}
inline void memory_set_budget(uint64_t bytes) {
    tree_memory_set_budget(bytes);
}
inline uint64_t memory_budget() {
    return tree_memory_budget();
}
inline void memory_set_allocator(Ref<tree_allocator> allocator) {
    tree::check(tree_memory_set_allocator(allocator));
}
inline Span<const tree_wind_branch> Mesh::branches() const {
    const tree_wind_branch *branches = nullptr; size_t n_branches = 0;
    tree::check(tree_mesh_branches(get(), &branches, &n_branches));
    return Span<const tree_wind_branch>(branches, n_branches);
}
inline Mesh Mesh::build(const struct tree_tree *tree, const struct tree_look *look, Ref<tree_mesh_params> params, Ref<tree_control> control, tree_mesh_report *report) {
    tree_mesh *mesh = nullptr;
    tree::check(tree_mesh_build(tree, look, params, control, report, &mesh));
    return Mesh(mesh);
}
inline Mesh Mesh::subdivide(size_t number, Ref<tree_subdivide_params> params, Ref<tree_control> control) const {
    tree_mesh *subdivided = nullptr;
    tree::check(tree_mesh_subdivide(get(), number, params, control, &subdivided));
    return Mesh(subdivided);
}
inline Mesh Mesh::displace(size_t number, Ref<tree_displace_params> params, uint64_t seed, Ref<tree_control> control) const {
    tree_mesh *displaced = nullptr;
    tree::check(tree_mesh_displace(get(), number, params, seed, control, &displaced));
    return Mesh(displaced);
}
inline Mesh Mesh::bake_occlusion(Ref<tree_occlusion_params> params, Ref<tree_control> control) const {
    tree_mesh *baked = nullptr;
    tree::check(tree_mesh_bake_occlusion(get(), params, control, &baked));
    return Mesh(baked);
}
inline Mesh Mesh::weld(size_t number, Ref<tree_control> control) const {
    tree_mesh *welded = nullptr;
    tree::check(tree_mesh_weld(get(), number, control, &welded));
    return Mesh(welded);
}
inline Mesh Mesh::from_surfaces(Span<const tree_surface> surfaces, Span<const tree_material> materials, Span<const tree_wind_branch> branches, Ref<tree_control> control) {
    tree_mesh *mesh = nullptr;
    tree::check(tree_mesh_from_surfaces(surfaces.data(), surfaces.size(), materials.data(), materials.size(), branches.data(), branches.size(), control, &mesh));
    return Mesh(mesh);
}
inline Material Mesh::material(size_t number) const {
    Material material;
    tree::check(tree_mesh_material(get(), number, &material));
    return material;
}
inline Texture Mesh::texture(size_t number) const {
    tree_texture *texture = nullptr;
    tree::check(tree_mesh_texture(get(), number, &texture));
    return Texture(texture);
}
inline void MeshParams::check() const {
    tree::check(tree_mesh_params_check(this));
}
inline float MeshParams::error() const {
    float metres = 0;
    tree::check(tree_mesh_params_error(this, &metres));
    return metres;
}
inline Topology Mesh::examine(size_t number, Ref<tree_control> control) const {
    Topology topology;
    tree::check(tree_mesh_examine(get(), number, control, &topology));
    return topology;
}
inline size_t Mesh::points(size_t number, uint32_t *of_vertex, size_t of_vertex_capacity, uint32_t *first, size_t first_capacity) const {
    size_t n_points = 0;
    tree::check(tree_mesh_points(get(), number, of_vertex, of_vertex_capacity, first, first_capacity, &n_points));
    return n_points;
}
inline Crossings Mesh::crossings(size_t number, Ref<tree_control> control) const {
    tree_crossings *crossings = nullptr;
    tree::check(tree_mesh_crossings(get(), number, control, &crossings));
    return Crossings(crossings);
}
inline CrossingPairs Crossings::view() const {
    CrossingPairs pairs;
    tree::check(tree_crossings_view(get(), &pairs));
    return pairs;
}
inline MeshTotals Mesh::count() const {
    MeshTotals totals;
    tree::check(tree_mesh_count(get(), &totals));
    return totals;
}
inline size_t Mesh::surface_count() const {
    size_t n_surfaces = 0;
    tree::check(tree_mesh_surface_count(get(), &n_surfaces));
    return n_surfaces;
}
inline Surface Mesh::surface(size_t number) const {
    Surface surface;
    tree::check(tree_mesh_surface(get(), number, &surface));
    return surface;
}
inline Bounds Mesh::surface_bounds(size_t number) const {
    Bounds bounds;
    tree::check(tree_mesh_surface_bounds(get(), number, &bounds));
    return bounds;
}
inline Bounds Mesh::bounds() const {
    Bounds bounds;
    tree::check(tree_mesh_bounds(get(), &bounds));
    return bounds;
}
inline void Mesh::check() const {
    tree::check(tree_mesh_check(get()));
}
inline void Mesh::check_surface(size_t number) const {
    tree::check(tree_mesh_check_surface(get(), number));
}
inline void Mesh::check_colors() const {
    tree::check(tree_mesh_check_colors(get()));
}
inline void Mesh::check_normals() const {
    tree::check(tree_mesh_check_normals(get()));
}
inline Graph Graph::link(const struct tree_graph_nodes *nodes, Ref<tree_link_params> params, uint64_t seed, Ref<tree_control> control) {
    tree_graph *graph = nullptr;
    tree::check(tree_graph_link(nodes, params, seed, control, &graph));
    return Graph(graph);
}
inline Graph Graph::from_edges(const float *positions, size_t n_nodes, const uint32_t *edges, const float *costs, size_t n_edges, Ref<tree_control> control) {
    tree_graph *graph = nullptr;
    tree::check(tree_graph_from_edges(positions, n_nodes, edges, costs, n_edges, control, &graph));
    return Graph(graph);
}
inline GraphColumns Graph::view() const {
    GraphColumns columns;
    tree::check(tree_graph_view(get(), &columns));
    return columns;
}
inline void Graph::search(uint32_t root, Ref<tree_control> control, float *costs, uint32_t *predecessors, size_t capacity) const {
    tree::check(tree_graph_search(get(), root, control, costs, predecessors, capacity));
}
inline Tree path_grow(Ref<tree_path_params> params, uint64_t seed, Ref<tree_control> control, tree_path_report *report) {
    tree_tree *tree = nullptr;
    tree::check(tree_path_grow(params, seed, control, report, &tree));
    return Tree(tree);
}
inline std::tuple<Bytes, Tree> path_grow_with_levels(Ref<tree_path_params> params, uint64_t seed, Ref<tree_control> control, tree_path_report *report) {
    tree_bytes *node_levels = nullptr; tree_tree *tree = nullptr;
    tree::check(tree_path_grow_with_levels(params, seed, control, report, &node_levels, &tree));
    return {Bytes(node_levels), Tree(tree)};
}
inline GraphNodes Volume::graph_strew(Ref<tree_strew_params> params, uint64_t seed, Ref<tree_control> control) const {
    tree_graph_nodes *nodes = nullptr;
    tree::check(tree_graph_strew(get(), params, seed, control, &nodes));
    return GraphNodes(nodes);
}
inline GraphNodesColumns GraphNodes::view() const {
    GraphNodesColumns columns;
    tree::check(tree_graph_nodes_view(get(), &columns));
    return columns;
}
inline void path_check(Ref<tree_path_params> params, Ref<tree_control> control) {
    tree::check(tree_path_check(params, control));
}
inline float path_level_radius(Ref<tree_path_params> params, size_t index) {
    float radius = 0;
    tree::check(tree_path_level_radius(params, index, &radius));
    return radius;
}
inline size_t path_preset_count() {
    return tree_path_preset_count();
}
inline std::tuple<std::string_view, std::string_view> path_preset_name(size_t index) {
    tree_str name{}; tree_str title{};
    tree::check(tree_path_preset_name(index, &name, &title));
    return {detail::text(name), detail::text(title)};
}
inline float path_preset_paper_seconds(size_t index) {
    float seconds = 0;
    tree::check(tree_path_preset_paper_seconds(index, &seconds));
    return seconds;
}
inline PathParams path_preset(std::string_view name) {
    PathParams params;
    tree::check(tree_path_preset(name.data() ? name.data() : "", name.size(), &params, sizeof(tree_path_params)));
    return params;
}
inline Profile Profile::from_svg(std::string_view svg, Ref<tree_profile_options> options, Ref<tree_control> control) {
    tree_profile *profile = nullptr;
    tree::check(tree_profile_from_svg(svg.data() ? svg.data() : "", svg.size(), options, control, &profile));
    return Profile(profile);
}
inline ProfileColumns Profile::view() const {
    ProfileColumns columns;
    tree::check(tree_profile_view(get(), &columns));
    return columns;
}
inline Volume Profile::volume(const float *base) const {
    tree_volume *volume = nullptr;
    tree::check(tree_profile_volume(get(), base, &volume));
    return Volume(volume);
}
inline Volume Volume::from_svg(std::string_view svg, Ref<tree_profile_options> options, const float *base, Ref<tree_control> control) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_from_svg(svg.data() ? svg.data() : "", svg.size(), options, base, control, &volume));
    return Volume(volume);
}
inline bool Volume::obstacle_is_free(float clearance, const float *a, const float *b) const {
    uint32_t is_free = 0;
    tree::check(tree_obstacle_is_free(get(), clearance, a, b, &is_free));
    return is_free != 0;
}
inline Pool Pool::make(Ref<tree_pool_options> options) {
    tree_pool *pool = nullptr;
    tree::check(tree_pool_new(options, &pool));
    return Pool(pool);
}
inline uint32_t Pool::threads() const {
    uint32_t n_threads = 0;
    tree::check(tree_pool_threads(get(), &n_threads));
    return n_threads;
}
inline MaskColumns Mask::view() const {
    MaskColumns columns;
    tree::check(tree_mask_view(get(), &columns));
    return columns;
}
inline void Mask::bits(uint8_t *bits, size_t capacity) const {
    tree::check(tree_mask_bits(get(), bits, capacity));
}
inline Picture Mask::picture() const {
    tree_picture *picture = nullptr;
    tree::check(tree_mask_picture(get(), &picture));
    return Picture(picture);
}
inline Picture Picture::from_pixels(uint32_t width, uint32_t height, Span<const uint8_t> pixels, Ref<tree_control> control) {
    tree_picture *picture = nullptr;
    tree::check(tree_picture_from_pixels(width, height, pixels.data(), pixels.size(), control, &picture));
    return Picture(picture);
}
inline Pixels Picture::view() const {
    Pixels pixels;
    tree::check(tree_picture_view(get(), &pixels));
    return pixels;
}
inline void Picture::write_png(std::string_view path) const {
    tree::check(tree_picture_write_png(get(), path.data() ? path.data() : "", path.size()));
}
inline Bytes Picture::to_png() const {
    tree_bytes *bytes = nullptr;
    tree::check(tree_picture_to_png(get(), &bytes));
    return Bytes(bytes);
}
inline Picture Mesh::render(Ref<tree_view> view, Ref<tree_style> style, Ref<tree_control> control) const {
    tree_picture *picture = nullptr;
    tree::check(tree_render(get(), view, style, control, &picture));
    return Picture(picture);
}
inline Mask Mesh::render_mask(Ref<tree_view> view, Ref<tree_control> control) const {
    tree_mask *mask = nullptr;
    tree::check(tree_render_mask(get(), view, control, &mask));
    return Mask(mask);
}
inline Picture Mesh::render_silhouette(Ref<tree_view> view, Ref<tree_control> control) const {
    tree_picture *picture = nullptr;
    tree::check(tree_render_silhouette(get(), view, control, &picture));
    return Picture(picture);
}
inline Style Style::studio() {
    Style style;
    tree::check(tree_style_studio(&style, sizeof(tree_style)));
    return style;
}
inline View View::place(const struct tree_mesh *mesh) const {
    View placed;
    tree::check(tree_view_place(this, mesh, &placed));
    return placed;
}
inline Skeleton Skeleton::from_columns(Ref<tree_skeleton_columns> columns, Ref<tree_control> control) {
    tree_skeleton *skeleton = nullptr;
    tree::check(tree_skeleton_from_columns(columns, control, &skeleton));
    return Skeleton(skeleton);
}
inline Skeleton Skeleton::from_unordered(Ref<tree_skeleton_columns> columns, Ref<tree_control> control, uint32_t *rows) {
    tree_skeleton *skeleton = nullptr;
    tree::check(tree_skeleton_from_unordered(columns, control, rows, &skeleton));
    return Skeleton(skeleton);
}
inline SkeletonColumns Skeleton::view() const {
    SkeletonColumns columns;
    tree::check(tree_skeleton_view(get(), &columns));
    return columns;
}
inline std::array<float, 6> Skeleton::bounds() const {
    std::array<float, 6> min_max{};
    tree::check(tree_skeleton_bounds(get(), reinterpret_cast<float(*)[6]>(min_max.data())));
    return min_max;
}
inline Axes Skeleton::axes(tree_continuation rule) const {
    tree_axes *axes = nullptr;
    tree::check(tree_skeleton_axes(get(), rule, &axes));
    return Axes(axes);
}
inline AxisColumns Axes::view() const {
    AxisColumns columns;
    tree::check(tree_axes_view(get(), &columns));
    return columns;
}
inline Skeleton Skeleton::with_radii(const float *radii, size_t n) const {
    tree_skeleton *changed = nullptr;
    tree::check(tree_skeleton_with_radii(get(), radii, n, &changed));
    return Skeleton(changed);
}
inline Skeleton Skeleton::with_positions(const float *positions, size_t n) const {
    tree_skeleton *changed = nullptr;
    tree::check(tree_skeleton_with_positions(get(), positions, n, &changed));
    return Skeleton(changed);
}
inline void Skeleton::segment_lengths(float *lengths, size_t capacity) const {
    tree::check(tree_skeleton_segment_lengths(get(), lengths, capacity));
}
inline void Skeleton::distances_to_root(float *distances, size_t capacity) const {
    tree::check(tree_skeleton_distances_to_root(get(), distances, capacity));
}
inline void Skeleton::distances_to_tip(float *distances, size_t capacity) const {
    tree::check(tree_skeleton_distances_to_tip(get(), distances, capacity));
}
inline void Skeleton::subtree_sizes(uint32_t *sizes, size_t capacity) const {
    tree::check(tree_skeleton_subtree_sizes(get(), sizes, capacity));
}
inline void Skeleton::tip_counts(uint32_t *counts, size_t capacity) const {
    tree::check(tree_skeleton_tip_counts(get(), counts, capacity));
}
inline void Skeleton::children(uint32_t *starts, size_t starts_capacity, uint32_t *nodes, size_t nodes_capacity) const {
    tree::check(tree_skeleton_children(get(), starts, starts_capacity, nodes, nodes_capacity));
}
inline Swc Swc::read(std::string_view path, Ref<tree_swc_options> options, Ref<tree_control> control) {
    tree_swc *swc = nullptr;
    tree::check(tree_swc_read(path.data() ? path.data() : "", path.size(), options, control, &swc));
    return Swc(swc);
}
inline Swc Swc::from_text(std::string_view text, Ref<tree_swc_options> options, Ref<tree_control> control) {
    tree_swc *swc = nullptr;
    tree::check(tree_swc_from_text(text.data() ? text.data() : "", text.size(), options, control, &swc));
    return Swc(swc);
}
inline Skeleton Swc::skeleton() const {
    tree_skeleton *skeleton = nullptr;
    tree::check(tree_swc_skeleton(get(), &skeleton));
    return Skeleton(skeleton);
}
inline SwcContents Swc::view() const {
    SwcContents contents;
    tree::check(tree_swc_view(get(), &contents));
    return contents;
}
inline void Skeleton::write_swc(std::string_view path, Ref<tree_swc_options> options) const {
    tree::check(tree_skeleton_write_swc(get(), path.data() ? path.data() : "", path.size(), options));
}
inline Bytes Skeleton::to_swc(Ref<tree_swc_options> options) const {
    tree_bytes *text = nullptr;
    tree::check(tree_skeleton_to_swc(get(), options, &text));
    return Bytes(text);
}
inline FoundLeaves Separation::leaves(const struct tree_skeleton *skeleton, Ref<tree_control> control) const {
    tree_found_leaves *leaves = nullptr;
    tree::check(tree_separation_leaves(get(), skeleton, control, &leaves));
    return FoundLeaves(leaves);
}
inline Foliage FoundLeaves::foliage() const {
    Foliage foliage;
    tree::check(tree_found_leaves_foliage(get(), &foliage));
    return foliage;
}
inline LeafKinds FoundLeaves::view() const {
    LeafKinds kinds;
    tree::check(tree_found_leaves_view(get(), &kinds));
    return kinds;
}
inline Pieces Separation::follow(Ref<tree_skeletonize_params> params, Ref<tree_control> control) const {
    tree_pieces *pieces = nullptr;
    tree::check(tree_separation_follow(get(), params, control, &pieces));
    return Pieces(pieces);
}
inline std::tuple<Skeleton, Pieces> Pieces::make(Span<const tree_piece> rows, Ref<tree_control> control) {
    tree_skeleton *skeletons = nullptr; tree_pieces *pieces = nullptr;
    tree::check(tree_pieces_new(&skeletons, rows.data(), rows.size(), control, &pieces));
    return {Skeleton(skeletons), Pieces(pieces)};
}
inline size_t Pieces::count() const {
    size_t n_pieces = 0;
    tree::check(tree_pieces_count(get(), &n_pieces));
    return n_pieces;
}
inline std::tuple<tree_piece, Skeleton> Pieces::piece(size_t index) const {
    tree_piece row{}; tree_skeleton *skeleton = nullptr;
    tree::check(tree_pieces_piece(get(), index, &row, &skeleton));
    return {row, Skeleton(skeleton)};
}
inline Skeleton Pieces::link(Ref<tree_skeletonize_params> params, Ref<tree_control> control, uint8_t *reached, size_t capacity) const {
    tree_skeleton *skeleton = nullptr;
    tree::check(tree_pieces_link(get(), params, control, reached, capacity, &skeleton));
    return Skeleton(skeleton);
}
inline Separation Separation::make(Span<const tree_mesh_part> parts, Ref<tree_skeletonize_params> params, Ref<tree_control> control) {
    tree_separation *separation = nullptr;
    tree::check(tree_separation_new(parts.data(), parts.size(), params, control, &separation));
    return Separation(separation);
}
inline Separation Separation::of_mesh(const struct tree_mesh *mesh, const tree_hint *hints, size_t n_hints, Ref<tree_skeletonize_params> params, Ref<tree_control> control) {
    tree_separation *separation = nullptr;
    tree::check(tree_separation_of_mesh(mesh, hints, n_hints, params, control, &separation));
    return Separation(separation);
}
inline SeparationColumns Separation::view() const {
    SeparationColumns columns;
    tree::check(tree_separation_view(get(), &columns));
    return columns;
}
inline Separation Separation::with_classes(const tree_class *classes, size_t n_classes) const {
    tree_separation *other = nullptr;
    tree::check(tree_separation_with_classes(get(), classes, n_classes, &other));
    return Separation(other);
}
inline Skeleton Separation::outward(const struct tree_skeleton *skeleton) const {
    tree_skeleton *outward = nullptr;
    tree::check(tree_separation_outward(get(), skeleton, &outward));
    return Skeleton(outward);
}
inline Tree skeletonize(Span<const tree_mesh_part> parts, Ref<tree_skeletonize_params> params, Ref<tree_control> control, tree_skeletonize_report *report) {
    tree_tree *tree = nullptr;
    tree::check(tree_skeletonize(parts.data(), parts.size(), params, control, report, &tree));
    return Tree(tree);
}
inline Tree Mesh::skeletonize_mesh(const tree_hint *hints, size_t n_hints, Ref<tree_skeletonize_params> params, Ref<tree_control> control, tree_skeletonize_report *report) const {
    tree_tree *tree = nullptr;
    tree::check(tree_skeletonize_mesh(get(), hints, n_hints, params, control, report, &tree));
    return Tree(tree);
}
inline Tree Tree::make(const struct tree_skeleton *skeleton, Ref<tree_foliage> foliage, Ref<tree_species> species, Ref<tree_control> control) {
    tree_tree *tree = nullptr;
    tree::check(tree_tree_new(skeleton, foliage, species, control, &tree));
    return Tree(tree);
}
inline Skeleton Tree::skeleton() const {
    tree_skeleton *skeleton = nullptr;
    tree::check(tree_tree_skeleton(get(), &skeleton));
    return Skeleton(skeleton);
}
inline Foliage Tree::foliage() const {
    Foliage foliage;
    tree::check(tree_tree_foliage(get(), &foliage));
    return foliage;
}
inline Species Tree::species() const {
    Species species;
    tree::check(tree_tree_species(get(), &species));
    return species;
}
inline uint32_t abi_version() {
    return tree_abi_version();
}
inline std::string_view version() {
    return tree_version();
}
inline size_t live_objects() {
    return tree_live_objects();
}
inline Volume Volume::union_(Span<const tree_volume *const> volumes) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_union(volumes.data(), volumes.size(), &volume));
    return Volume(volume);
}
inline Volume Volume::intersection(Span<const tree_volume *const> volumes) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_intersection(volumes.data(), volumes.size(), &volume));
    return Volume(volume);
}
inline Volume Volume::difference(const struct tree_volume *without) const {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_difference(get(), without, &volume));
    return Volume(volume);
}
inline Volume Volume::transformed(const float *columns) const {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_transformed(get(), columns, &volume));
    return Volume(volume);
}
inline void Volume::contains(const float *points, size_t n_points, Ref<tree_control> control, uint8_t *inside) const {
    tree::check(tree_volume_contains(get(), points, n_points, control, inside));
}
inline void Volume::distance(const float *points, size_t n_points, Ref<tree_control> control, float *distances) const {
    tree::check(tree_volume_distance(get(), points, n_points, control, distances));
}
inline bool Volume::distance_is_exact() const {
    uint32_t is_exact = 0;
    tree::check(tree_volume_distance_is_exact(get(), &is_exact));
    return is_exact != 0;
}
inline std::array<float, 6> Volume::bounds() const {
    std::array<float, 6> min_max{};
    tree::check(tree_volume_bounds(get(), reinterpret_cast<float(*)[6]>(min_max.data())));
    return min_max;
}
inline bool Volume::is_bounded() const {
    uint32_t is_bounded = 0;
    tree::check(tree_volume_is_bounded(get(), &is_bounded));
    return is_bounded != 0;
}
inline float Volume::measure() const {
    float measure = 0;
    tree::check(tree_volume_measure(get(), &measure));
    return measure;
}
inline float Volume::estimate_measure(uint32_t n_samples, Ref<tree_control> control) const {
    float measure = 0;
    tree::check(tree_volume_estimate_measure(get(), n_samples, control, &measure));
    return measure;
}
inline void Volume::sample(size_t n_points, uint32_t attempts, uint64_t seed, Ref<tree_control> control, float *points) const {
    tree::check(tree_volume_sample(get(), n_points, attempts, seed, control, points));
}
inline Volume Volume::sphere(const float *center, float radius) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_sphere(center, radius, &volume));
    return Volume(volume);
}
inline Volume Volume::ellipsoid(const float *center, const float *radii) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_ellipsoid(center, radii, &volume));
    return Volume(volume);
}
inline Volume Volume::cylinder(const float *base, const float *top, float radius) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_cylinder(base, top, radius, &volume));
    return Volume(volume);
}
inline Volume Volume::frustum(const float *base, const float *top, float base_radius, float top_radius) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_frustum(base, top, base_radius, top_radius, &volume));
    return Volume(volume);
}
inline Volume Volume::cone(const float *base, const float *apex, float base_radius) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_cone(base, apex, base_radius, &volume));
    return Volume(volume);
}
inline Volume Volume::capsule(const float *start, const float *end, float radius) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_capsule(start, end, radius, &volume));
    return Volume(volume);
}
inline Volume Volume::box(const float *min, const float *max) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_box(min, max, &volume));
    return Volume(volume);
}
inline Volume Volume::half_space(const float *point, const float *normal) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_half_space(point, normal, &volume));
    return Volume(volume);
}
inline Volume Volume::sector(const float *apex, const float *axis, float angle, float radius) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_sector(apex, axis, angle, radius, &volume));
    return Volume(volume);
}
inline Volume Volume::revolution(const float *base, const float *axis, const float *profile, size_t n_points, Ref<tree_control> control) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_revolution(base, axis, profile, n_points, control, &volume));
    return Volume(volume);
}
inline Volume Volume::closed_mesh(const float *positions, size_t n_positions, const uint32_t *indices, size_t n_triangles, Ref<tree_control> control) {
    tree_volume *volume = nullptr;
    tree::check(tree_volume_closed_mesh(positions, n_positions, indices, n_triangles, control, &volume));
    return Volume(volume);
}
inline Solid Volume::view() const {
    Solid solid;
    tree::check(tree_volume_view(get(), &solid));
    return solid;
}
inline Volume Volume::part(size_t index) const {
    tree_volume *part = nullptr;
    tree::check(tree_volume_part(get(), index, &part));
    return Volume(part);
}

} // namespace tree

#endif // TREE_HPP
