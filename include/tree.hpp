// The tree family for C++17, over tree.h. Header only. Licence: MIT OR Apache-2.0.
// Made of tree.h by tests/hpp.rs in tree-ffi: do not edit.
//
// * Objects (tree::Mesh and so on) are moved, never copied, and free themselves. get() is the C pointer, for
//   C functions; what was moved from is empty, and refused wherever an object is needed.
// * Parameters (tree::MeshParams and so on) are C's structs with the defaults filled in. A call takes them
//   by value or as pointers; `nullptr` and nothing at all mean the defaults.
// * Views (tree::Surface and so on, tree::Span, std::string_view) point into the object that they were
//   asked of and live as long as it; asking a temporary for one does not compile.
// * Arrays come back as std::vector, or are written into a Span of your own. Arrays of points and the like
//   are taken as Spans of all their numbers: three floats for each point.
// * Functions of yours (tree::Control, tree::Field) may throw: the call ends, and throws the same on.
// * A call that fails throws tree::Error. Without exceptions (-fno-exceptions) it returns false, or
//   something empty: objects, arrays, numbers that are 0, structs that the next call refuses.
//   tree::status() and tree::error_text() say what was wrong, until tree::clear_error() forgets it.
// * What a function does is said at the C function of its name in tree.h.

#ifndef TREE_HPP
#define TREE_HPP

#include "tree.h"
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define TREE_THROWS 1
#else
#define TREE_THROWS 0
#endif

namespace tree {

namespace detail {

// What these classes refused by themselves, which the library knows nothing of.
struct Refusal {
    tree_status code = TREE_OK;
    const char *text = "";
};
inline Refusal &refusal() noexcept {
    static thread_local Refusal refusal;
    return refusal;
}

} // namespace detail

// What this thread's last call that failed says; `TREE_OK` and nothing before any did.
inline tree_status status() noexcept {
    tree_status own = detail::refusal().code;
    return own == TREE_OK ? tree_error_status() : own;
}
inline std::string_view error_text() noexcept {
    return detail::refusal().code == TREE_OK ? tree_error_text() : detail::refusal().text;
}
inline void clear_error() noexcept {
    detail::refusal() = {};
    tree_error_clear();
}

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
    if (code == TREE_OK) return true;
    detail::refusal() = {};
#if TREE_THROWS
    throw Error(code, tree_error_text());
#else
    return false;
#endif
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
    template <class C, class = decltype(static_cast<T *>(std::declval<C &>().data()))>
    constexpr Span(C &container) noexcept : data_(container.data()), size_(container.size()) {}
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
    constexpr const T *operator->() const noexcept { return pointer_; }

private:
    const T *pointer_ = nullptr;
};

// `N` floats: an array, or one by one in braces.
template <std::size_t N>
class Floats {
public:
    constexpr Floats(const float *array) noexcept : pointer_(array) {}
    constexpr Floats(const std::array<float, N> &array) noexcept : pointer_(array.data()) {}
    template <class... A, class = std::enable_if_t<sizeof...(A) == N && (std::is_arithmetic_v<A> && ...)>>
    constexpr Floats(A... each) noexcept : own_{static_cast<float>(each)...}, pointer_(own_) {}
    Floats(const Floats &) = delete;
    Floats &operator=(const Floats &) = delete;
    constexpr operator const float *() const noexcept { return pointer_; }

private:
    float own_[N] = {};
    const float *pointer_;
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

    // The C pointer, which lives as long as this.
    T *get() const & noexcept { return object_; }
    T *get() const && = delete;
    explicit operator bool() const noexcept { return object_ != nullptr; }
    // Where a C function puts an object that is to be owned. Frees the one before.
    T **place() & noexcept {
        reset();
        return &object_;
    }
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

// An object's pointer, for as long as the call.
template <class T>
class Borrowed {
public:
    Borrowed(const T *pointer) noexcept : pointer_(pointer) {}
    template <tree_status (*Free)(T *)>
    Borrowed(const Object<T, Free> &object) noexcept : pointer_(object.get()) {}
    operator const T *() const noexcept { return pointer_; }

private:
    const T *pointer_;
};

// Whether all is as the library cannot see for itself.
inline bool expect(bool holds, tree_status code, const char *text) {
    if (holds) return true;
    refusal() = {code, text};
#if TREE_THROWS
    throw Error(code, text);
#else
    return false;
#endif
}

// How long arrays are that share one length: the shortest of those that are there.
struct Length {
    const void *data;
    std::size_t n;
};
inline std::size_t shortest(std::initializer_list<Length> arrays) noexcept {
    const Length *found = nullptr;
    for (const Length &array : arrays)
        if (array.data && (!found || array.n < found->n)) found = &array;
    return found ? found->n : 0;
}

// Keeps the first thing that functions of the caller's threw, for the call to throw on.
class Thrown {
public:
    template <class R, class F>
    R guard(R otherwise, F function) noexcept {
#if TREE_THROWS
        if (is_there_.load(std::memory_order_acquire)) return otherwise;
        try {
            return function();
        } catch (...) {
            std::lock_guard<std::mutex> lock(mutex_);
            if (!first_) first_ = std::current_exception();
            is_there_.store(true, std::memory_order_release);
            return otherwise;
        }
#else
        static_cast<void>(otherwise);
        return function();
#endif
    }
    void rethrow() {
#if TREE_THROWS
        if (!is_there_.load(std::memory_order_acquire)) return;
        std::unique_lock<std::mutex> lock(mutex_);
        std::exception_ptr first = std::exchange(first_, nullptr);
        is_there_.store(false, std::memory_order_release);
        lock.unlock();
        if (first) std::rethrow_exception(first);
#endif
    }

#if TREE_THROWS
private:
    std::atomic<bool> is_there_{false};
    std::mutex mutex_;
    std::exception_ptr first_;
#endif
};

} // namespace detail

// Text for a C struct; `text` must live as long as the struct is used.
inline tree_str str(std::string_view text) noexcept { return {text.data(), text.size()}; }

// An object that may be left out: one, a pointer to one, or `nullptr`. An empty one is refused.
template <class T>
class Maybe {
public:
    Maybe(std::nullptr_t = nullptr) noexcept {}
    Maybe(const T *pointer) noexcept : pointer_(pointer) {}
    template <tree_status (*Free)(T *)>
    Maybe(const detail::Object<T, Free> &object) noexcept : pointer_(object.get()), fits_(pointer_) {}
    template <tree_status (*Free)(T *)>
    Maybe(const detail::Object<T, Free> *object) noexcept
        : pointer_(object ? object->get() : nullptr), fits_(!object || pointer_) {}
    operator const T *() const noexcept { return pointer_; }
    // Whether it is there or was left out on purpose.
    bool fits() const noexcept { return fits_; }

private:
    const T *pointer_ = nullptr;
    bool fits_ = true;
};

// Objects in a row: a container of them or of their pointers, or one by one in braces.
template <class T>
class Handles {
public:
    Handles(std::initializer_list<detail::Borrowed<T>> list) : list_(list.begin(), list.end()) {}
    template <class C, class = decltype(std::begin(std::declval<const C &>()))>
    Handles(const C &container) {
        for (const auto &one : container) list_.push_back(detail::Borrowed<T>(one));
    }
    const T *const *data() const noexcept { return list_.data(); }
    std::size_t size() const noexcept { return list_.size(); }

private:
    std::vector<const T *> list_;
};

// A function of a place in space, three floats in metres: how densely leaves stand, what paths cost. Called
// from any thread, by several at once. What it throws ends the call, as far as the library can, and is
// thrown on by it.
class Field {
public:
    Field(std::nullptr_t = nullptr) noexcept {}
    template <class F, class = std::enable_if_t<std::is_invocable_r_v<float, F &, std::array<float, 3>>>>
    Field(F function) : function_(std::move(function)) {}
    Field(const Field &) = delete;
    Field &operator=(const Field &) = delete;
    explicit operator bool() const noexcept { return static_cast<bool>(function_); }

    // For C: the function, or NULL, and what to hand to it.
    using Function = float (*)(void *, const float *);
    Function function() const noexcept { return function_ ? call : nullptr; }
    void *user() const noexcept { return const_cast<Field *>(this); }

    // Throws what the function threw, if it did; calls do so by themselves.
    void rethrow() const { thrown_.rethrow(); }

    static float call(void *self, const float *place) noexcept {
        const Field &field = *static_cast<const Field *>(self);
        return field.thrown_.guard(std::numeric_limits<float>::quiet_NaN(), [&] {
            return field.function_({place[0], place[1], place[2]});
        });
    }

private:
    std::function<float(std::array<float, 3>)> function_;
    mutable detail::Thrown thrown_;
};

// How a call is done, with a function for progress.
struct Control : tree_control {
    Control() : tree_control{} { tree_control_init(this, sizeof(tree_control)); }
    Control(const Control &) = delete;
    Control &operator=(const Control &) = delete;

    // `told(stage, fraction)` returns whether to go on. Called from whichever thread does the work. What it
    // throws cancels the call, and is thrown on by it.
    template <class F>
    Control &on_progress(F told) {
        told_ = std::move(told);
        user = this;
        progress = tell;
        return *this;
    }

    // Throws what the function threw, if it did; calls do so by themselves.
    void rethrow() { thrown_.rethrow(); }

    static std::int32_t tell(void *self, const char *stage, float fraction) noexcept {
        Control &control = *static_cast<Control *>(self);
        return control.thrown_.guard(1, [&] { return control.told_(stage, fraction) ? 0 : 1; });
    }

private:
    std::function<bool(std::string_view, float)> told_;
    detail::Thrown thrown_;
};

namespace detail {

// Throws on what the functions in a struct threw.
inline void rethrow(const tree_control *control) {
    if (control && control->progress == Control::tell) static_cast<Control *>(control->user)->rethrow();
}
inline void rethrow(const Field &field) { field.rethrow(); }

} // namespace detail

class Adapted;
class Adt;
class Aligned;
class Arranged;
class Attractor;
class Axes;
class Bits;
class Bumps;
class Bytes;
class Cancel;
class Capsules;
class CardChoice;
class Cards;
class Carved;
class Cloud;
class Crossings;
class Crown;
class DirectionField;
class Drawing;
class Drawings;
class EditPairs;
class EditTree;
class Elements;
class Equations;
class FactorGraph;
class FoundLeaves;
class GltfAttributes;
class GltfLeaves;
class Grammar;
class Graph;
class GraphNodes;
class Grid;
class Grown;
class Growth;
class Hull;
class Hybrid;
class HybridChoice;
class Inferred;
class LeafBoxes;
class LeafModel;
class LeafOutline;
class Lines;
class LodTable;
class Look;
class Mask;
class Matte;
class Mesh;
class Metaballs;
class Midlines;
class Mips;
class MultiChain;
class MultiMesh;
class MultiPaths;
class Multires;
class Octahedral;
class Outline;
class OutlineDrawing;
class OutlinePlan;
class Packed;
class Photo;
class PhotoSession;
class Picture;
class Pieces;
class Plan;
class Plastic;
class PlasticClusters;
class PlasticScene;
class Pool;
class Profile;
class Pruned;
class Revolved;
class Rows;
class Scanned;
class Scene;
class SceneLevels;
class SceneState;
class Separation;
class SilhouetteChange;
class SilhouetteSession;
class Skeleton;
class SketchBranches;
class SketchSession;
class Stand;
class StreamReader;
class Strokes;
class Swc;
class Templates;
class Texture;
class Tiers;
class Traces;
class Tree;
class Trimap;
class TurtleTrace;
class Twigs;
class Unpacked;
class Volume;
class Way;
class WindBranches;
class Word;
struct AdaptedColumns;
struct AdaptedReport;
struct AdtColumns;
struct AlignParams;
struct AlignReport;
using AlignWarning = tree_align_warning;
struct Allocator;
struct Around;
struct ArrangedReport;
using Arrangement = tree_arrangement;
struct ArrangementNumbers;
struct AttractorColumns;
struct AttractorNearestPoint;
struct AutomaticParams;
struct AutomaticReport;
struct AxisColumns;
using BarkPatches = tree_bark_patches;
struct BarkStyle;
struct BitsSize;
struct Bounds;
struct BranchInferParams;
struct BranchMotion;
struct BranchShapeReport;
using BranchSpan = tree_branch_span;
struct BranchSystemParams;
struct BranchingAngles;
struct BranchingReport;
using Bump = tree_bump;
struct BumpParams;
using Capsule = tree_capsule;
struct CapsuleParams;
struct CapsuleReport;
struct CardChoiceReport;
struct CardChooseParams;
struct CardParams;
using CardPlane = tree_card_plane;
struct CardsReport;
struct CarvedColumns;
struct ChainParams;
struct CleanParams;
using CleanRepair = tree_clean_repair;
struct CloudColumns;
struct ColorSamples;
struct Concentration;
struct ConventionTraits;
struct CoverParams;
struct CoverageParams;
struct CrossingPairs;
struct CrownMeasures;
struct CrownParams;
using CrownRepair = tree_crown_repair;
struct CrownReport;
struct DensityBrush;
struct DensityParams;
struct DensityReport;
struct DensityStroke;
using DensityView = tree_density_view;
struct DifferenceParams;
struct DirectionFieldColumns;
struct DisplaceParams;
using Domain = tree_domain;
using DrawIndexed = tree_draw_indexed;
using DrawnRepair = tree_drawn_repair;
struct DrawnStroke;
struct DrawnTree;
struct EditColumns;
struct EditCosts;
struct EditDistance;
using EditPair = tree_edit_pair;
struct EditParams;
struct ElementsColumns;
struct EquationsColumns;
struct EraseReport;
struct FieldParams;
struct FinishParams;
struct FlowParams;
struct FlowReport;
struct FlowView;
struct Foliage;
struct GibbsParams;
struct GlbMotion;
struct GlbOptions;
struct GltfAttribute;
struct GltfInstances;
struct GltfLevel;
struct GrammarInfo;
struct GrammarReport;
using GraphArc = tree_graph_arc;
struct GraphColumns;
struct GraphNodesColumns;
struct GridColumns;
struct GrownColumns;
struct GrowthCounts;
struct GrowthHabit;
struct GrowthParams;
struct GrowthPlant;
using GrowthTropisms = tree_growth_tropisms;
struct GrowthWorld;
using GrowthYear = tree_growth_year;
struct HullColumns;
struct HullParams;
struct HybridChoiceReport;
struct HybridParams;
struct HybridTotals;
struct ImportOptions;
struct ImportReport;
using IndexWindow = tree_index_window;
struct InferredColumns;
using InstanceLod = tree_instance_lod;
struct InstancingParams;
struct InstancingReport;
using LateralAngle = tree_lateral_angle;
struct LeafBox;
struct LeafBoxParams;
struct LeafBoxesReport;
struct LeafCard;
struct LeafKinds;
struct LeafLook;
struct LeafMesh;
struct LeafModelReport;
struct LeafOutlineColumns;
struct LeafParams;
using LeafRange = tree_leaf_range;
struct LeafReport;
struct LeafShape;
using LevelShare = tree_level_share;
struct Limits;
struct LinkParams;
struct LivewireParams;
struct LivewireReport;
using LodCut = tree_lod_cut;
using LodDistance = tree_lod_distance;
using LodLevel = tree_lod_level;
using LodRow = tree_lod_row;
struct LodScreen;
struct LodSubject;
struct LodTableParams;
using LodWindow = tree_lod_window;
struct LsystemPresetInfo;
struct MainBranchParams;
using Mark = tree_mark;
struct MaskColumns;
struct Material;
struct MatteColumns;
struct MeshParams;
struct MeshPart;
struct MeshReport;
struct MeshTotals;
struct MetricParams;
struct MidlineParams;
struct MultiChainColumns;
using MultiDraw = tree_multi_draw;
struct MultiMeshColumn;
struct MultiMeshTotals;
struct NaturalParams;
struct NaturalReport;
struct OcclusionParams;
using OctahedralFrame = tree_octahedral_frame;
struct OctahedralMeta;
struct OctahedralParams;
struct OctahedralReport;
struct OrderParams;
struct OutlineBranch;
struct OutlineCloseParams;
struct OutlineColumns;
struct OutlinePlanColumns;
using OutlineRepair = tree_outline_repair;
struct OutlineSystem;
struct PackedColumns;
using PackedVertex = tree_packed_vertex;
struct PackedVertices;
struct Paint;
struct ParticleCamera;
struct ParticleStand;
struct ParticleView;
struct PathLevel;
using PathLevelReport = tree_path_level_report;
struct PathParams;
struct PathReport;
struct PhotoBranches;
struct PhotoParams;
struct PhotoPlacing;
struct PhotoReport;
struct PhotoShot;
struct PhotoViewReport;
using Piece = tree_piece;
struct PivotElement;
struct Pivots;
struct Pixels;
struct PlanColumns;
using PlasticCluster = tree_plastic_cluster;
struct PlasticColumns;
using PlasticMotion = tree_plastic_motion;
struct PlasticParams;
struct PlasticRegrown;
struct PlasticRegrowth;
struct PlasticReport;
struct PlasticResponse;
struct PlasticSky;
struct PlasticUpdate;
struct PlyOptions;
struct PoolOptions;
using Pose = tree_pose;
struct ProfileColumns;
struct ProfileOptions;
struct PruneMakeParams;
struct PruneParams;
struct PrunedPart;
struct PrunedTotals;
struct RadiusRule;
struct RevolvedFrame;
struct ScanParams;
struct ScanReport;
struct ScannedColumns;
using SceneDraw = tree_scene_draw;
struct SceneFrame;
using SceneInstance = tree_scene_instance;
struct SceneModel;
struct SceneNeeds;
using SceneOccluder = tree_scene_occluder;
struct SceneParams;
struct SceneReport;
using SceneShown = tree_scene_shown;
using Score = tree_score;
struct ScreenParams;
struct SeedParams;
struct SeparationColumns;
struct SilhouetteChangeColumns;
struct SilhouetteGrowParams;
struct SilhouetteGrown;
struct SilhouetteLeaves;
struct SilhouetteLevel;
struct SilhouetteParams;
struct SilhouettePlayReport;
using Site = tree_site;
struct SkeletonColumns;
struct SkeletonizeParams;
struct SkeletonizeReport;
struct SketchBranchesColumns;
using SketchFactorRow = tree_sketch_factor_row;
struct SketchFinishParams;
struct SketchFinishReport;
using SketchHabit = tree_sketch_habit;
struct SketchInferParams;
using SketchNormal = tree_sketch_normal;
struct SketchOmega;
struct SketchOutlineParams;
struct SketchParams;
using SketchPin = tree_sketch_pin;
using SketchPosterior = tree_sketch_posterior;
struct SketchPropagateParams;
struct SketchPropagateReport;
using SketchRelation = tree_sketch_relation;
struct SketchReport;
struct SketchStroke;
using SketchTraceRow = tree_sketch_trace_row;
struct Solid;
struct Species;
struct StandParams;
struct StandTree;
struct StandWhole;
using StrahlerOrder = tree_strahler_order;
using Stream = tree_stream;
struct StreamParams;
struct StreamReport;
struct StrewParams;
struct StrokeParams;
struct StrokeReport;
struct StrokesColumns;
struct Style;
struct SubParams;
struct SubReport;
struct SubdivideParams;
struct Surface;
struct SwcContents;
struct SwcOptions;
using TemplateChoice = tree_template_choice;
struct TemplateParams;
struct TemplateSelectParams;
struct TemplateSide;
struct TemplateView;
struct TexturePixels;
struct TierColumns;
struct TiersParams;
struct TokenColumns;
struct Topology;
struct TracesColumns;
struct TrimapColumns;
struct TrimapStroke;
struct TurtleParams;
struct TurtlePolygons;
struct TurtleReport;
struct TwigInstances;
struct TwigParams;
struct TwigReport;
using UnbranchedRun = tree_unbranched_run;
struct UnpackedColumns;
using VertexWind = tree_vertex_wind;
struct View;
struct Wind;
using WindBranch = tree_wind_branch;
struct WordColumns;
struct WordHistory;

struct AdaptedColumns : tree_adapted_columns {
    AdaptedColumns() : tree_adapted_columns{} { struct_size = sizeof *this; }
};

struct AdaptedReport : tree_adapted_report {
    AdaptedReport() : tree_adapted_report{} { struct_size = sizeof *this; }
};

struct AdtColumns : tree_adt_columns {
    AdtColumns() : tree_adt_columns{} { struct_size = sizeof *this; }
};

struct AlignParams : tree_align_params {
    AlignParams() : tree_align_params{} { tree_align_params_init(this, sizeof(tree_align_params)); }
};

struct AlignReport : tree_align_report {
    AlignReport() : tree_align_report{} { struct_size = sizeof *this; }
};

struct Allocator : tree_allocator {
    Allocator() : tree_allocator{} { struct_size = sizeof *this; }
};

struct Around : tree_around {
    Around() : tree_around{} { tree_around_init(this, sizeof(tree_around)); }
    static Around for_order(size_t n_triangles);
    static Around for_table(size_t n_triangles);
    bool check() const;
    size_t count() const;
    View view(size_t number) const;
};

struct ArrangedReport : tree_arranged_report {
    ArrangedReport() : tree_arranged_report{} { struct_size = sizeof *this; }
};

struct ArrangementNumbers : tree_arrangement_numbers {
    ArrangementNumbers() : tree_arrangement_numbers{} { struct_size = sizeof *this; }
};

struct AttractorColumns : tree_attractor_columns {
    AttractorColumns() : tree_attractor_columns{} { struct_size = sizeof *this; }
};

struct AttractorNearestPoint : tree_attractor_nearest_point {
    AttractorNearestPoint() : tree_attractor_nearest_point{} { struct_size = sizeof *this; }
};

struct AutomaticParams : tree_automatic_params {
    AutomaticParams() : tree_automatic_params{} { tree_automatic_params_init(this, sizeof(tree_automatic_params)); }
};

struct AutomaticReport : tree_automatic_report {
    AutomaticReport() : tree_automatic_report{} { struct_size = sizeof *this; }
};

struct AxisColumns : tree_axis_columns {
    AxisColumns() : tree_axis_columns{} { struct_size = sizeof *this; }
};

struct BarkStyle : tree_bark_style {
    BarkStyle() : tree_bark_style{} { tree_bark_style_init(this, sizeof(tree_bark_style)); }
};

struct BitsSize : tree_bits_size {
    BitsSize() : tree_bits_size{} { struct_size = sizeof *this; }
};

struct Bounds : tree_bounds {
    Bounds() : tree_bounds{} { struct_size = sizeof *this; }
};

struct BranchInferParams : tree_branch_infer_params {
    BranchInferParams() : tree_branch_infer_params{} { tree_branch_infer_params_init(this, sizeof(tree_branch_infer_params)); }
    bool check() const;
};

struct BranchMotion : tree_branch_motion {
    BranchMotion() : tree_branch_motion{} { struct_size = sizeof *this; }
};

struct BranchShapeReport : tree_branch_shape_report {
    BranchShapeReport() : tree_branch_shape_report{} { struct_size = sizeof *this; }
};

struct BranchSystemParams : tree_branch_system_params {
    BranchSystemParams() : tree_branch_system_params{} { tree_branch_system_params_init(this, sizeof(tree_branch_system_params)); }
};

struct BranchingAngles : tree_branching_angles {
    BranchingAngles() : tree_branching_angles{} { tree_branching_angles_init(this, sizeof(tree_branching_angles)); }
    std::vector<float> at(Span<const float> places, Ref<tree_control> control = nullptr) const;
    bool at(Span<const float> places, Ref<tree_control> control, Span<float> values) const;
    std::tuple<std::vector<float>, size_t> set(float place, float angle) const;
    size_t set(float place, float angle, Span<float> samples) const;
};

struct BranchingReport : tree_branching_report {
    BranchingReport() : tree_branching_report{} { struct_size = sizeof *this; }
};

struct BumpParams : tree_bump_params {
    BumpParams() : tree_bump_params{} { tree_bump_params_init(this, sizeof(tree_bump_params)); }
    bool check() const;
};

struct CapsuleParams : tree_capsule_params {
    CapsuleParams() : tree_capsule_params{} { tree_capsule_params_init(this, sizeof(tree_capsule_params)); }
};

struct CapsuleReport : tree_capsule_report {
    CapsuleReport() : tree_capsule_report{} { struct_size = sizeof *this; }
};

struct CardChoiceReport : tree_card_choice_report {
    CardChoiceReport() : tree_card_choice_report{} { struct_size = sizeof *this; }
};

struct CardChooseParams : tree_card_choose_params {
    CardChooseParams() : tree_card_choose_params{} { tree_card_choose_params_init(this, sizeof(tree_card_choose_params)); }
    bool check() const;
};

struct CardParams : tree_card_params {
    CardParams() : tree_card_params{} { tree_card_params_init(this, sizeof(tree_card_params)); }
    bool check() const;
};

struct CardsReport : tree_cards_report {
    CardsReport() : tree_cards_report{} { struct_size = sizeof *this; }
};

struct CarvedColumns : tree_carved_columns {
    CarvedColumns() : tree_carved_columns{} { struct_size = sizeof *this; }
};

struct ChainParams : tree_chain_params {
    ChainParams() : tree_chain_params{} { tree_chain_params_init(this, sizeof(tree_chain_params)); }
};

struct CleanParams : tree_clean_params {
    CleanParams() : tree_clean_params{} { tree_clean_params_init(this, sizeof(tree_clean_params)); }
    bool check() const;
};

struct CloudColumns : tree_cloud_columns {
    CloudColumns() : tree_cloud_columns{} { struct_size = sizeof *this; }
};

struct ColorSamples : tree_color_samples {
    ColorSamples() : tree_color_samples{} { tree_color_samples_init(this, sizeof(tree_color_samples)); }
};

struct Concentration : tree_concentration {
    Concentration() : tree_concentration{} { struct_size = sizeof *this; }
};

struct ConventionTraits : tree_convention_traits {
    ConventionTraits() : tree_convention_traits{} { struct_size = sizeof *this; }
};

struct CoverParams : tree_cover_params {
    CoverParams() : tree_cover_params{} { tree_cover_params_init(this, sizeof(tree_cover_params)); }
};

struct CoverageParams : tree_coverage_params {
    CoverageParams() : tree_coverage_params{} { tree_coverage_params_init(this, sizeof(tree_coverage_params)); }
    bool check() const;
};

struct CrossingPairs : tree_crossing_pairs {
    CrossingPairs() : tree_crossing_pairs{} { struct_size = sizeof *this; }
};

struct CrownMeasures : tree_crown_measures {
    CrownMeasures() : tree_crown_measures{} { struct_size = sizeof *this; }
};

struct CrownParams : tree_crown_params {
    CrownParams() : tree_crown_params{} { tree_crown_params_init(this, sizeof(tree_crown_params)); }
    bool check() const;
};

struct CrownReport : tree_crown_report {
    CrownReport() : tree_crown_report{} { struct_size = sizeof *this; }
};

struct DensityBrush : tree_density_brush {
    DensityBrush() : tree_density_brush{} { tree_density_brush_init(this, sizeof(tree_density_brush)); }
};

struct DensityParams : tree_density_params {
    DensityParams() : tree_density_params{} { tree_density_params_init(this, sizeof(tree_density_params)); }
    bool check() const;
};

struct DensityReport : tree_density_report {
    DensityReport() : tree_density_report{} { struct_size = sizeof *this; }
};

struct DensityStroke : tree_density_stroke {
    DensityStroke() : tree_density_stroke{} { tree_density_stroke_init(this, sizeof(tree_density_stroke)); }
};

struct DifferenceParams : tree_difference_params {
    DifferenceParams() : tree_difference_params{} { tree_difference_params_init(this, sizeof(tree_difference_params)); }
};

struct DirectionFieldColumns : tree_direction_field_columns {
    DirectionFieldColumns() : tree_direction_field_columns{} { struct_size = sizeof *this; }
};

struct DisplaceParams : tree_displace_params {
    DisplaceParams() : tree_displace_params{} { tree_displace_params_init(this, sizeof(tree_displace_params)); }
};

struct DrawnStroke : tree_drawn_stroke {
    DrawnStroke() : tree_drawn_stroke{} { struct_size = sizeof *this; }
};

struct DrawnTree : tree_drawn_tree {
    DrawnTree() : tree_drawn_tree{} { struct_size = sizeof *this; }
};

struct EditColumns : tree_edit_columns {
    EditColumns() : tree_edit_columns{} { struct_size = sizeof *this; }
};

struct EditCosts : tree_edit_costs {
    EditCosts() : tree_edit_costs{} { tree_edit_costs_init(this, sizeof(tree_edit_costs)); }
};

struct EditDistance : tree_edit_distance {
    EditDistance() : tree_edit_distance{} { struct_size = sizeof *this; }
};

struct EditParams : tree_edit_params {
    EditParams() : tree_edit_params{} { tree_edit_params_init(this, sizeof(tree_edit_params)); }
};

struct ElementsColumns : tree_elements_columns {
    ElementsColumns() : tree_elements_columns{} { struct_size = sizeof *this; }
};

struct EquationsColumns : tree_equations_columns {
    EquationsColumns() : tree_equations_columns{} { struct_size = sizeof *this; }
};

struct EraseReport : tree_erase_report {
    EraseReport() : tree_erase_report{} { struct_size = sizeof *this; }
};

struct FieldParams : tree_field_params {
    FieldParams() : tree_field_params{} { tree_field_params_init(this, sizeof(tree_field_params)); }
    bool check() const;
    float blend_at(float distance) const;
};

struct FinishParams : tree_finish_params {
    FinishParams() : tree_finish_params{} { tree_finish_params_init(this, sizeof(tree_finish_params)); }
    bool check() const;
};

struct FlowParams : tree_flow_params {
    FlowParams() : tree_flow_params{} { tree_flow_params_init(this, sizeof(tree_flow_params)); }
    bool check() const;
};

struct FlowReport : tree_flow_report {
    FlowReport() : tree_flow_report{} { struct_size = sizeof *this; }
};

struct FlowView : tree_flow_view {
    FlowView() : tree_flow_view{} { tree_flow_view_init(this, sizeof(tree_flow_view)); }
};

struct Foliage : tree_foliage {
    Foliage() : tree_foliage{} { struct_size = sizeof *this; }
};

struct GibbsParams : tree_gibbs_params {
    GibbsParams() : tree_gibbs_params{} { tree_gibbs_params_init(this, sizeof(tree_gibbs_params)); }
    bool check() const;
};

struct GlbMotion : tree_glb_motion {
    GlbMotion() : tree_glb_motion{} { tree_glb_motion_init(this, sizeof(tree_glb_motion)); }
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

struct GrammarInfo : tree_grammar_info {
    GrammarInfo() : tree_grammar_info{} { struct_size = sizeof *this; }
};

struct GrammarReport : tree_grammar_report {
    GrammarReport() : tree_grammar_report{} { struct_size = sizeof *this; }
};

struct GraphColumns : tree_graph_columns {
    GraphColumns() : tree_graph_columns{} { struct_size = sizeof *this; }
};

struct GraphNodesColumns : tree_graph_nodes_columns {
    GraphNodesColumns() : tree_graph_nodes_columns{} { struct_size = sizeof *this; }
};

struct GridColumns : tree_grid_columns {
    GridColumns() : tree_grid_columns{} { struct_size = sizeof *this; }
};

struct GrownColumns : tree_grown_columns {
    GrownColumns() : tree_grown_columns{} { struct_size = sizeof *this; }
};

struct GrowthCounts : tree_growth_counts {
    GrowthCounts() : tree_growth_counts{} { struct_size = sizeof *this; }
};

struct GrowthHabit : tree_growth_habit {
    GrowthHabit() : tree_growth_habit{} { tree_growth_habit_init(this, sizeof(tree_growth_habit)); }
};

struct GrowthParams : tree_growth_params {
    GrowthParams() : tree_growth_params{} { tree_growth_params_init(this, sizeof(tree_growth_params)); }
    bool check() const;
};

struct GrowthPlant : tree_growth_plant {
    GrowthPlant() : tree_growth_plant{} { tree_growth_plant_init(this, sizeof(tree_growth_plant)); }
};

struct GrowthWorld : tree_growth_world {
    GrowthWorld() : tree_growth_world{} { tree_growth_world_init(this, sizeof(tree_growth_world)); }
};

struct HullColumns : tree_hull_columns {
    HullColumns() : tree_hull_columns{} { struct_size = sizeof *this; }
};

struct HullParams : tree_hull_params {
    HullParams() : tree_hull_params{} { tree_hull_params_init(this, sizeof(tree_hull_params)); }
    bool check() const;
};

struct HybridChoiceReport : tree_hybrid_choice_report {
    HybridChoiceReport() : tree_hybrid_choice_report{} { struct_size = sizeof *this; }
};

struct HybridParams : tree_hybrid_params {
    HybridParams() : tree_hybrid_params{} { tree_hybrid_params_init(this, sizeof(tree_hybrid_params)); }
    bool check() const;
};

struct HybridTotals : tree_hybrid_totals {
    HybridTotals() : tree_hybrid_totals{} { struct_size = sizeof *this; }
};

struct ImportOptions : tree_import_options {
    ImportOptions() : tree_import_options{} { tree_import_options_init(this, sizeof(tree_import_options)); }
};

struct ImportReport : tree_import_report {
    ImportReport() : tree_import_report{} { struct_size = sizeof *this; }
};

struct InferredColumns : tree_inferred_columns {
    InferredColumns() : tree_inferred_columns{} { struct_size = sizeof *this; }
};

struct InstancingParams : tree_instancing_params {
    InstancingParams() : tree_instancing_params{} { tree_instancing_params_init(this, sizeof(tree_instancing_params)); }
};

struct InstancingReport : tree_instancing_report {
    InstancingReport() : tree_instancing_report{} { struct_size = sizeof *this; }
};

struct LeafBox : tree_leaf_box {
    LeafBox() : tree_leaf_box{} { struct_size = sizeof *this; }
};

struct LeafBoxParams : tree_leaf_box_params {
    LeafBoxParams() : tree_leaf_box_params{} { tree_leaf_box_params_init(this, sizeof(tree_leaf_box_params)); }
    bool check() const;
};

struct LeafBoxesReport : tree_leaf_boxes_report {
    LeafBoxesReport() : tree_leaf_boxes_report{} { struct_size = sizeof *this; }
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

struct LeafOutlineColumns : tree_leaf_outline_columns {
    LeafOutlineColumns() : tree_leaf_outline_columns{} { struct_size = sizeof *this; }
};

struct LeafParams : tree_leaf_params {
    LeafParams() : tree_leaf_params{} { tree_leaf_params_init(this, sizeof(tree_leaf_params)); }
    bool check(size_t n_kinds) const;
};

struct LeafReport : tree_leaf_report {
    LeafReport() : tree_leaf_report{} { struct_size = sizeof *this; }
};

struct LeafShape : tree_leaf_shape {
    LeafShape() : tree_leaf_shape{} { tree_leaf_shape_init(this, sizeof(tree_leaf_shape)); }
    bool autumn(float progress);
};

struct Limits : tree_limits {
    Limits() : tree_limits{} { tree_limits_init(this, sizeof(tree_limits)); }
    static Limits for_memory(uint64_t bytes);
};

struct LinkParams : tree_link_params {
    LinkParams() : tree_link_params{} { tree_link_params_init(this, sizeof(tree_link_params)); }
    // `cost` must live as long as this is used.
    LinkParams &set_cost(const Field &function) {
        this->cost = function.function();
        this->cost_user = function.user();
        return *this;
    }
    LinkParams &set_cost(const Field &&) = delete;
};

struct LivewireParams : tree_livewire_params {
    LivewireParams() : tree_livewire_params{} { tree_livewire_params_init(this, sizeof(tree_livewire_params)); }
};

struct LivewireReport : tree_livewire_report {
    LivewireReport() : tree_livewire_report{} { struct_size = sizeof *this; }
};

struct LodScreen : tree_lod_screen {
    LodScreen() : tree_lod_screen{} { tree_lod_screen_init(this, sizeof(tree_lod_screen)); }
    bool check() const;
    float coverage(float lambda, float size) const;
};

struct LodSubject : tree_lod_subject {
    LodSubject() : tree_lod_subject{} { tree_lod_subject_init(this, sizeof(tree_lod_subject)); }
    bool scores(Span<const float> lambdas, Span<const float> scales, Ref<tree_around> around, Ref<tree_control> control, Span<tree_score> scores) const;
};

struct LodTableParams : tree_lod_table_params {
    LodTableParams() : tree_lod_table_params{} { tree_lod_table_params_init(this, sizeof(tree_lod_table_params)); }
    bool check() const;
};

struct LsystemPresetInfo : tree_lsystem_preset_info {
    LsystemPresetInfo() : tree_lsystem_preset_info{} { struct_size = sizeof *this; }
};

struct MainBranchParams : tree_main_branch_params {
    MainBranchParams() : tree_main_branch_params{} { tree_main_branch_params_init(this, sizeof(tree_main_branch_params)); }
    bool check() const;
};

struct MaskColumns : tree_mask_columns {
    MaskColumns() : tree_mask_columns{} { struct_size = sizeof *this; }
};

struct Material : tree_material {
    Material() : tree_material{} { tree_material_init(this, sizeof(tree_material)); }
};

struct MatteColumns : tree_matte_columns {
    MatteColumns() : tree_matte_columns{} { struct_size = sizeof *this; }
};

struct MeshParams : tree_mesh_params {
    MeshParams() : tree_mesh_params{} { tree_mesh_params_init(this, sizeof(tree_mesh_params)); }
    bool check() const;
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

struct MetricParams : tree_metric_params {
    MetricParams() : tree_metric_params{} { tree_metric_params_init(this, sizeof(tree_metric_params)); }
};

struct MidlineParams : tree_midline_params {
    MidlineParams() : tree_midline_params{} { tree_midline_params_init(this, sizeof(tree_midline_params)); }
};

struct MultiChainColumns : tree_multi_chain_columns {
    MultiChainColumns() : tree_multi_chain_columns{} { struct_size = sizeof *this; }
};

struct MultiMeshColumn : tree_multi_mesh_column {
    MultiMeshColumn() : tree_multi_mesh_column{} { struct_size = sizeof *this; }
};

struct MultiMeshTotals : tree_multi_mesh_totals {
    MultiMeshTotals() : tree_multi_mesh_totals{} { struct_size = sizeof *this; }
};

struct NaturalParams : tree_natural_params {
    NaturalParams() : tree_natural_params{} { tree_natural_params_init(this, sizeof(tree_natural_params)); }
};

struct NaturalReport : tree_natural_report {
    NaturalReport() : tree_natural_report{} { struct_size = sizeof *this; }
};

struct OcclusionParams : tree_occlusion_params {
    OcclusionParams() : tree_occlusion_params{} { tree_occlusion_params_init(this, sizeof(tree_occlusion_params)); }
};

struct OctahedralMeta : tree_octahedral_meta {
    OctahedralMeta() : tree_octahedral_meta{} { struct_size = sizeof *this; }
    bool check() const;
    std::tuple<std::array<float, 2>, float> extent(float y) const;
};

struct OctahedralParams : tree_octahedral_params {
    OctahedralParams() : tree_octahedral_params{} { tree_octahedral_params_init(this, sizeof(tree_octahedral_params)); }
    bool check() const;
};

struct OctahedralReport : tree_octahedral_report {
    OctahedralReport() : tree_octahedral_report{} { struct_size = sizeof *this; }
};

struct OrderParams : tree_order_params {
    OrderParams() : tree_order_params{} { tree_order_params_init(this, sizeof(tree_order_params)); }
    bool check() const;
};

struct OutlineBranch : tree_outline_branch {
    OutlineBranch() : tree_outline_branch{} { struct_size = sizeof *this; }
};

struct OutlineCloseParams : tree_outline_close_params {
    OutlineCloseParams() : tree_outline_close_params{} { tree_outline_close_params_init(this, sizeof(tree_outline_close_params)); }
    bool check() const;
};

struct OutlineColumns : tree_outline_columns {
    OutlineColumns() : tree_outline_columns{} { struct_size = sizeof *this; }
};

struct OutlinePlanColumns : tree_outline_plan_columns {
    OutlinePlanColumns() : tree_outline_plan_columns{} { struct_size = sizeof *this; }
};

struct OutlineSystem : tree_outline_system {
    OutlineSystem() : tree_outline_system{} { struct_size = sizeof *this; }
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

struct ParticleCamera : tree_particle_camera {
    ParticleCamera() : tree_particle_camera{} { tree_particle_camera_init(this, sizeof(tree_particle_camera)); }
    bool check() const;
    std::tuple<std::array<float, 3>, std::array<float, 3>, std::array<float, 3>> frame() const;
    std::vector<float> project(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool project(Span<const float> points, Ref<tree_control> control, Span<float> spots) const;
    std::vector<float> pixel_sizes(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool pixel_sizes(Span<const float> points, Ref<tree_control> control, Span<float> sizes) const;
    std::vector<float> rays(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool rays(Span<const float> spots, Ref<tree_control> control, Span<float> rays) const;
    ParticleStand stand() const;
    View view() const;
};

struct ParticleStand : tree_particle_stand {
    ParticleStand() : tree_particle_stand{} { struct_size = sizeof *this; }
};

struct ParticleView : tree_particle_view {
    ParticleView() : tree_particle_view{} { tree_particle_view_init(this, sizeof(tree_particle_view)); }
};

struct PathLevel : tree_path_level {
    PathLevel() : tree_path_level{} { tree_path_level_init(this, sizeof(tree_path_level)); }
};

struct PathParams : tree_path_params {
    PathParams() : tree_path_params{} { tree_path_params_init(this, sizeof(tree_path_params)); }
    bool check(Ref<tree_control> control = nullptr) const;
    // `cost` must live as long as this is used.
    PathParams &set_cost(const Field &function) {
        this->cost = function.function();
        this->cost_user = function.user();
        return *this;
    }
    PathParams &set_cost(const Field &&) = delete;
};

struct PathReport : tree_path_report {
    PathReport() : tree_path_report{} { struct_size = sizeof *this; }
};

struct PhotoBranches : tree_photo_branches {
    PhotoBranches() : tree_photo_branches{} { tree_photo_branches_init(this, sizeof(tree_photo_branches)); }
};

struct PhotoParams : tree_photo_params {
    PhotoParams() : tree_photo_params{} { tree_photo_params_init(this, sizeof(tree_photo_params)); }
    bool check(Ref<tree_control> control = nullptr) const;
};

struct PhotoPlacing : tree_photo_placing {
    PhotoPlacing() : tree_photo_placing{} { tree_photo_placing_init(this, sizeof(tree_photo_placing)); }
};

struct PhotoReport : tree_photo_report {
    PhotoReport() : tree_photo_report{} { struct_size = sizeof *this; }
};

struct PhotoShot : tree_photo_shot {
    PhotoShot() : tree_photo_shot{} { tree_photo_shot_init(this, sizeof(tree_photo_shot)); }
};

struct PhotoViewReport : tree_photo_view_report {
    PhotoViewReport() : tree_photo_view_report{} { struct_size = sizeof *this; }
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

struct PlanColumns : tree_plan_columns {
    PlanColumns() : tree_plan_columns{} { struct_size = sizeof *this; }
};

struct PlasticColumns : tree_plastic_columns {
    PlasticColumns() : tree_plastic_columns{} { struct_size = sizeof *this; }
};

struct PlasticParams : tree_plastic_params {
    PlasticParams() : tree_plastic_params{} { tree_plastic_params_init(this, sizeof(tree_plastic_params)); }
    bool check() const;
};

struct PlasticRegrown : tree_plastic_regrown {
    PlasticRegrown() : tree_plastic_regrown{} { struct_size = sizeof *this; }
};

struct PlasticRegrowth : tree_plastic_regrowth {
    PlasticRegrowth() : tree_plastic_regrowth{} { tree_plastic_regrowth_init(this, sizeof(tree_plastic_regrowth)); }
};

struct PlasticReport : tree_plastic_report {
    PlasticReport() : tree_plastic_report{} { struct_size = sizeof *this; }
};

struct PlasticResponse : tree_plastic_response {
    PlasticResponse() : tree_plastic_response{} { tree_plastic_response_init(this, sizeof(tree_plastic_response)); }
};

struct PlasticSky : tree_plastic_sky {
    PlasticSky() : tree_plastic_sky{} { tree_plastic_sky_init(this, sizeof(tree_plastic_sky)); }
    static PlasticSky towards(float azimuth, float elevation);
};

struct PlasticUpdate : tree_plastic_update {
    PlasticUpdate() : tree_plastic_update{} { struct_size = sizeof *this; }
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

struct PruneMakeParams : tree_prune_make_params {
    PruneMakeParams() : tree_prune_make_params{} { tree_prune_make_params_init(this, sizeof(tree_prune_make_params)); }
};

struct PruneParams : tree_prune_params {
    PruneParams() : tree_prune_params{} { tree_prune_params_init(this, sizeof(tree_prune_params)); }
    bool check() const;
};

struct PrunedPart : tree_pruned_part {
    PrunedPart() : tree_pruned_part{} { struct_size = sizeof *this; }
};

struct PrunedTotals : tree_pruned_totals {
    PrunedTotals() : tree_pruned_totals{} { struct_size = sizeof *this; }
};

struct RadiusRule : tree_radius_rule {
    RadiusRule() : tree_radius_rule{} { tree_radius_rule_init(this, sizeof(tree_radius_rule)); }
    bool check() const;
};

struct RevolvedFrame : tree_revolved_frame {
    RevolvedFrame() : tree_revolved_frame{} { struct_size = sizeof *this; }
};

struct ScanParams : tree_scan_params {
    ScanParams() : tree_scan_params{} { tree_scan_params_init(this, sizeof(tree_scan_params)); }
    bool check() const;
};

struct ScanReport : tree_scan_report {
    ScanReport() : tree_scan_report{} { struct_size = sizeof *this; }
};

struct ScannedColumns : tree_scanned_columns {
    ScannedColumns() : tree_scanned_columns{} { struct_size = sizeof *this; }
};

struct SceneFrame : tree_scene_frame {
    SceneFrame() : tree_scene_frame{} { tree_scene_frame_init(this, sizeof(tree_scene_frame)); }
};

struct SceneModel : tree_scene_model {
    SceneModel() : tree_scene_model{} { tree_scene_model_init(this, sizeof(tree_scene_model)); }
    bool check() const;
};

struct SceneNeeds : tree_scene_needs {
    SceneNeeds() : tree_scene_needs{} { struct_size = sizeof *this; }
};

struct SceneParams : tree_scene_params {
    SceneParams() : tree_scene_params{} { tree_scene_params_init(this, sizeof(tree_scene_params)); }
    bool check() const;
};

struct SceneReport : tree_scene_report {
    SceneReport() : tree_scene_report{} { struct_size = sizeof *this; }
};

struct ScreenParams : tree_screen_params {
    ScreenParams() : tree_screen_params{} { tree_screen_params_init(this, sizeof(tree_screen_params)); }
};

struct SeedParams : tree_seed_params {
    SeedParams() : tree_seed_params{} { tree_seed_params_init(this, sizeof(tree_seed_params)); }
};

struct SeparationColumns : tree_separation_columns {
    SeparationColumns() : tree_separation_columns{} { struct_size = sizeof *this; }
};

struct SilhouetteChangeColumns : tree_silhouette_change_columns {
    SilhouetteChangeColumns() : tree_silhouette_change_columns{} { struct_size = sizeof *this; }
};

struct SilhouetteGrowParams : tree_silhouette_grow_params {
    SilhouetteGrowParams() : tree_silhouette_grow_params{} { tree_silhouette_grow_params_init(this, sizeof(tree_silhouette_grow_params)); }
};

struct SilhouetteGrown : tree_silhouette_grown {
    SilhouetteGrown() : tree_silhouette_grown{} { struct_size = sizeof *this; }
};

struct SilhouetteLeaves : tree_silhouette_leaves {
    SilhouetteLeaves() : tree_silhouette_leaves{} { tree_silhouette_leaves_init(this, sizeof(tree_silhouette_leaves)); }
};

struct SilhouetteLevel : tree_silhouette_level {
    SilhouetteLevel() : tree_silhouette_level{} { tree_silhouette_level_init(this, sizeof(tree_silhouette_level)); }
};

struct SilhouetteParams : tree_silhouette_params {
    SilhouetteParams() : tree_silhouette_params{} { tree_silhouette_params_init(this, sizeof(tree_silhouette_params)); }
    bool check() const;
};

struct SilhouettePlayReport : tree_silhouette_play_report {
    SilhouettePlayReport() : tree_silhouette_play_report{} { struct_size = sizeof *this; }
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

struct SketchBranchesColumns : tree_sketch_branches_columns {
    SketchBranchesColumns() : tree_sketch_branches_columns{} { struct_size = sizeof *this; }
};

struct SketchFinishParams : tree_sketch_finish_params {
    SketchFinishParams() : tree_sketch_finish_params{} { tree_sketch_finish_params_init(this, sizeof(tree_sketch_finish_params)); }
};

struct SketchFinishReport : tree_sketch_finish_report {
    SketchFinishReport() : tree_sketch_finish_report{} { struct_size = sizeof *this; }
};

struct SketchInferParams : tree_sketch_infer_params {
    SketchInferParams() : tree_sketch_infer_params{} { tree_sketch_infer_params_init(this, sizeof(tree_sketch_infer_params)); }
    bool thesis();
};

struct SketchOmega : tree_sketch_omega {
    SketchOmega() : tree_sketch_omega{} { tree_sketch_omega_init(this, sizeof(tree_sketch_omega)); }
    bool check() const;
    SketchOmega without_orders() const;
};

struct SketchOutlineParams : tree_sketch_outline_params {
    SketchOutlineParams() : tree_sketch_outline_params{} { tree_sketch_outline_params_init(this, sizeof(tree_sketch_outline_params)); }
};

struct SketchParams : tree_sketch_params {
    SketchParams() : tree_sketch_params{} { tree_sketch_params_init(this, sizeof(tree_sketch_params)); }
    bool check() const;
};

struct SketchPropagateParams : tree_sketch_propagate_params {
    SketchPropagateParams() : tree_sketch_propagate_params{} { tree_sketch_propagate_params_init(this, sizeof(tree_sketch_propagate_params)); }
};

struct SketchPropagateReport : tree_sketch_propagate_report {
    SketchPropagateReport() : tree_sketch_propagate_report{} { struct_size = sizeof *this; }
};

struct SketchReport : tree_sketch_report {
    SketchReport() : tree_sketch_report{} { struct_size = sizeof *this; }
};

struct SketchStroke : tree_sketch_stroke {
    SketchStroke() : tree_sketch_stroke{} { struct_size = sizeof *this; }
};

struct Solid : tree_solid {
    Solid() : tree_solid{} { struct_size = sizeof *this; }
};

struct Species : tree_species {
    Species() : tree_species{} { struct_size = sizeof *this; }
};

struct StandParams : tree_stand_params {
    StandParams() : tree_stand_params{} { tree_stand_params_init(this, sizeof(tree_stand_params)); }
    bool check() const;
};

struct StandTree : tree_stand_tree {
    StandTree() : tree_stand_tree{} { struct_size = sizeof *this; }
};

struct StandWhole : tree_stand_whole {
    StandWhole() : tree_stand_whole{} { struct_size = sizeof *this; }
};

struct StreamParams : tree_stream_params {
    StreamParams() : tree_stream_params{} { tree_stream_params_init(this, sizeof(tree_stream_params)); }
    bool check() const;
};

struct StreamReport : tree_stream_report {
    StreamReport() : tree_stream_report{} { struct_size = sizeof *this; }
};

struct StrewParams : tree_strew_params {
    StrewParams() : tree_strew_params{} { tree_strew_params_init(this, sizeof(tree_strew_params)); }
};

struct StrokeParams : tree_stroke_params {
    StrokeParams() : tree_stroke_params{} { tree_stroke_params_init(this, sizeof(tree_stroke_params)); }
};

struct StrokeReport : tree_stroke_report {
    StrokeReport() : tree_stroke_report{} { struct_size = sizeof *this; }
};

struct StrokesColumns : tree_strokes_columns {
    StrokesColumns() : tree_strokes_columns{} { struct_size = sizeof *this; }
};

struct Style : tree_style {
    Style() : tree_style{} { tree_style_init(this, sizeof(tree_style)); }
    static Style studio();
};

struct SubParams : tree_sub_params {
    SubParams() : tree_sub_params{} { tree_sub_params_init(this, sizeof(tree_sub_params)); }
    bool check() const;
    float opening(float radius, float span) const;
};

struct SubReport : tree_sub_report {
    SubReport() : tree_sub_report{} { struct_size = sizeof *this; }
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

struct TemplateParams : tree_template_params {
    TemplateParams() : tree_template_params{} { tree_template_params_init(this, sizeof(tree_template_params)); }
    bool check() const;
};

struct TemplateSelectParams : tree_template_select_params {
    TemplateSelectParams() : tree_template_select_params{} { tree_template_select_params_init(this, sizeof(tree_template_select_params)); }
    bool check() const;
};

struct TemplateSide : tree_template_side {
    TemplateSide() : tree_template_side{} { struct_size = sizeof *this; }
};

struct TemplateView : tree_template_view {
    TemplateView() : tree_template_view{} { struct_size = sizeof *this; }
};

struct TexturePixels : tree_texture_pixels {
    TexturePixels() : tree_texture_pixels{} { struct_size = sizeof *this; }
};

struct TierColumns : tree_tier_columns {
    TierColumns() : tree_tier_columns{} { struct_size = sizeof *this; }
};

struct TiersParams : tree_tiers_params {
    TiersParams() : tree_tiers_params{} { tree_tiers_params_init(this, sizeof(tree_tiers_params)); }
    bool check() const;
};

struct TokenColumns : tree_token_columns {
    TokenColumns() : tree_token_columns{} { struct_size = sizeof *this; }
};

struct Topology : tree_topology {
    Topology() : tree_topology{} { struct_size = sizeof *this; }
};

struct TracesColumns : tree_traces_columns {
    TracesColumns() : tree_traces_columns{} { struct_size = sizeof *this; }
};

struct TrimapColumns : tree_trimap_columns {
    TrimapColumns() : tree_trimap_columns{} { struct_size = sizeof *this; }
};

struct TrimapStroke : tree_trimap_stroke {
    TrimapStroke() : tree_trimap_stroke{} { tree_trimap_stroke_init(this, sizeof(tree_trimap_stroke)); }
};

struct TurtleParams : tree_turtle_params {
    TurtleParams() : tree_turtle_params{} { tree_turtle_params_init(this, sizeof(tree_turtle_params)); }
    bool check() const;
};

struct TurtlePolygons : tree_turtle_polygons {
    TurtlePolygons() : tree_turtle_polygons{} { struct_size = sizeof *this; }
};

struct TurtleReport : tree_turtle_report {
    TurtleReport() : tree_turtle_report{} { struct_size = sizeof *this; }
};

struct TwigInstances : tree_twig_instances {
    TwigInstances() : tree_twig_instances{} { struct_size = sizeof *this; }
};

struct TwigParams : tree_twig_params {
    TwigParams() : tree_twig_params{} { tree_twig_params_init(this, sizeof(tree_twig_params)); }
    bool check() const;
};

struct TwigReport : tree_twig_report {
    TwigReport() : tree_twig_report{} { struct_size = sizeof *this; }
};

struct UnpackedColumns : tree_unpacked_columns {
    UnpackedColumns() : tree_unpacked_columns{} { struct_size = sizeof *this; }
};

struct View : tree_view {
    View() : tree_view{} { tree_view_init(this, sizeof(tree_view)); }
    View place(const Mesh &mesh) const;
};

struct Wind : tree_wind {
    Wind() : tree_wind{} { tree_wind_init(this, sizeof(tree_wind)); }
};

struct WordColumns : tree_word_columns {
    WordColumns() : tree_word_columns{} { struct_size = sizeof *this; }
};

struct WordHistory : tree_word_history {
    WordHistory() : tree_word_history{} { struct_size = sizeof *this; }
};

class Adapted : public detail::Object<tree_adapted, tree_adapted_free> {
public:
    using Object::Object;
    Tree tree() const;
    AdaptedColumns view() const &;
    AdaptedColumns view() const && = delete;
};

class Adt : public detail::Object<tree_adt, tree_adt_free> {
public:
    using Object::Object;
    static Adt of_tokens(Ref<tree_token_columns> columns, Ref<tree_control> control = nullptr);
    static Adt of_skeleton(const Skeleton &skeleton, Ref<tree_control> control = nullptr);
    static Adt of_tree(const Tree &tree, Ref<tree_control> control = nullptr);
    AdtColumns view() const &;
    AdtColumns view() const && = delete;
    Span<const uint32_t> modules(uint32_t branch) const &;
    Span<const uint32_t> modules(uint32_t branch) const && = delete;
    Span<const uint32_t> children(uint32_t branch) const &;
    Span<const uint32_t> children(uint32_t branch) const && = delete;
};

class Aligned : public detail::Object<tree_aligned, tree_aligned_free> {
public:
    using Object::Object;
    size_t count() const;
    std::tuple<ParticleCamera, AlignReport> camera(size_t index) const;
    Span<const tree_align_warning> warnings() const &;
    Span<const tree_align_warning> warnings() const && = delete;
};

class Arranged : public detail::Object<tree_arranged, tree_arranged_free> {
public:
    using Object::Object;
    static Arranged make(Span<const tree_domain> domains, const tree_arrangement &arrangement, Ref<tree_gibbs_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_arranged_report *report = nullptr);
    static Arranged ready(uint32_t n, const tree_arrangement &arrangement, uint64_t variant, uint64_t seed, Ref<tree_control> control = nullptr);
    Span<const tree_site> sites() const &;
    Span<const tree_site> sites() const && = delete;
    Span<const float> trace() const &;
    Span<const float> trace() const && = delete;
};

class Attractor : public detail::Object<tree_attractor, tree_attractor_free> {
public:
    using Object::Object;
    static Attractor from_columns(Ref<tree_attractor_columns> columns, Ref<tree_control> control = nullptr);
    AttractorColumns view() const &;
    AttractorColumns view() const && = delete;
    AttractorNearestPoint nearest(const Floats<2> &at_pixel) const;
    float length() const;
    Rows tips() const;
    Photo draw(const Photo &photo, float width, uint32_t rgba) const;
    std::tuple<float, Attractor> add_stroke(Span<const float> stroke, Ref<tree_stroke_params> params = nullptr, Ref<tree_control> control = nullptr, tree_stroke_report *report = nullptr) const;
    Attractor erase(Span<const float> eraser, float radius, tree_cut_off cut_off, tree_erase_report *report = nullptr) const;
    Attractor move_near(const Floats<2> &at_pixel, const Floats<2> &by_pixels, float radius) const;
    Attractor mirrored(float width) const;
    static Attractor livewire(const Matte &matte, Maybe<tree_photo> photo, const Floats<2> &base_pixel, Span<const float> seeds, Ref<tree_livewire_params> params = nullptr, Ref<tree_control> control = nullptr, tree_livewire_report *report = nullptr);
    static std::tuple<std::vector<float>, Attractor> from_strokes(Ref<tree_strokes_columns> columns, const Floats<2> &base_pixel, Ref<tree_stroke_params> params = nullptr, Ref<tree_control> control = nullptr, tree_stroke_report *report = nullptr);
    static Attractor from_strokes(Ref<tree_strokes_columns> columns, const Floats<2> &base_pixel, Ref<tree_stroke_params> params, Ref<tree_control> control, tree_stroke_report *report, Span<float> gaps);
};

class Axes : public detail::Object<tree_axes, tree_axes_free> {
public:
    using Object::Object;
    AxisColumns view() const &;
    AxisColumns view() const && = delete;
};

class Bits : public detail::Object<tree_bits, tree_bits_free> {
public:
    using Object::Object;
    static Bits of_mesh(const Mesh &mesh, Ref<tree_view> view = nullptr, Ref<tree_control> control = nullptr);
    BitsSize measure() const;
    std::vector<uint64_t> words() const;
    bool words(Span<uint64_t> words) const;
    std::vector<uint8_t> bytes() const;
    bool bytes(Span<uint8_t> bytes) const;
    tree_score score(const Bits &full) const;
};

class Bumps : public detail::Object<tree_bumps, tree_bumps_free> {
public:
    using Object::Object;
    Span<const tree_bump> view() const &;
    Span<const tree_bump> view() const && = delete;
};

class Bytes : public detail::Object<tree_bytes, tree_bytes_free> {
public:
    using Object::Object;
    Span<const uint8_t> view() const &;
    Span<const uint8_t> view() const && = delete;
};

class Cancel : public detail::Object<tree_cancel, tree_cancel_free> {
public:
    using Object::Object;
    static Cancel make();
    bool set() const;
};

class Capsules : public detail::Object<tree_capsules, tree_capsules_free> {
public:
    using Object::Object;
    Span<const tree_capsule> view() const &;
    Span<const tree_capsule> view() const && = delete;
};

class CardChoice : public detail::Object<tree_card_choice, tree_card_choice_free> {
public:
    using Object::Object;
    static CardChoice make(const Cards &cards);
    CardChoiceReport update(const Cards &cards, const Floats<3> &eye, float pixels_per_metre, Ref<tree_card_choose_params> params = nullptr) const;
    CardChoiceReport measure() const;
    std::vector<uint32_t> boxes() const;
    bool boxes(Span<uint32_t> boxes) const;
    std::vector<tree_leaf_range> ranges() const;
    bool ranges(Span<tree_leaf_range> ranges) const;
};

class Cards : public detail::Object<tree_cards, tree_cards_free> {
public:
    using Object::Object;
    static Cards bake(const Mesh &mesh, const Elements &elements, const LeafBoxes &boxes, Ref<tree_card_params> params = nullptr, Ref<tree_control> control = nullptr, tree_cards_report *report = nullptr);
    CardsReport measure() const;
    LeafBoxes boxes() const;
    float texel(uint32_t number) const;
    Pixels pixels(tree_impostor_map map) const &;
    Pixels pixels(tree_impostor_map map) const && = delete;
    Picture picture(tree_impostor_map map, Ref<tree_control> control = nullptr) const;
    Picture lit(Ref<tree_control> control = nullptr) const;
    Mesh mesh(Span<const uint32_t> boxes, Ref<tree_control> control = nullptr) const;
    Mesh plain(Span<const uint32_t> boxes, Ref<tree_control> control = nullptr) const;
    Mesh mesh_of_planes(Span<const uint32_t> boxes, Span<const uint32_t> planes, Ref<tree_control> control = nullptr) const;
    Picture view(Span<const uint32_t> boxes, Ref<tree_view> view = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_glb(Span<const uint32_t> boxes, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    bool write_glb(Span<const uint32_t> boxes, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    static std::string_view shader(tree_shader language);
};

class Carved : public detail::Object<tree_carved, tree_carved_free> {
public:
    using Object::Object;
    static Carved make(Span<const tree_particle_view> views, Ref<tree_density_params> params = nullptr, Ref<tree_control> control = nullptr);
    CarvedColumns view() const &;
    CarvedColumns view() const && = delete;
    Grid alpha() const;
    std::tuple<std::vector<tree_density_view>, Grid> solve(Span<const tree_particle_view> views, Ref<tree_density_params> params = nullptr, Ref<tree_control> control = nullptr, tree_density_report *report = nullptr) const;
    Grid solve(Span<const tree_particle_view> views, Ref<tree_density_params> params, Ref<tree_control> control, tree_density_report *report, Span<tree_density_view> rows) const;
};

class Cloud : public detail::Object<tree_cloud, tree_cloud_free> {
public:
    using Object::Object;
    static Cloud read(std::string_view path, Ref<tree_control> control = nullptr);
    static Cloud from_bytes(tree_cloud_format format, Span<const uint8_t> data, Ref<tree_control> control = nullptr);
    CloudColumns view() const &;
    CloudColumns view() const && = delete;
    Scanned skeletonize_cloud(Ref<tree_scan_params> params = nullptr, Ref<tree_control> control = nullptr, tree_scan_report *report = nullptr) const;
};

class Crossings : public detail::Object<tree_crossings, tree_crossings_free> {
public:
    using Object::Object;
    CrossingPairs view() const &;
    CrossingPairs view() const && = delete;
};

class Crown : public detail::Object<tree_crown, tree_crown_free> {
public:
    using Object::Object;
    static Crown close(Ref<tree_strokes_columns> columns, Span<const float> spots = {}, Ref<tree_crown_params> params = nullptr, Ref<tree_control> control = nullptr);
    static Crown from_polygons(Ref<tree_strokes_columns> columns, float depth, Ref<tree_control> control = nullptr);
    StrokesColumns polygons() const &;
    StrokesColumns polygons() const && = delete;
    CrownMeasures measure() const;
    Span<const tree_crown_repair> repairs() const &;
    Span<const tree_crown_repair> repairs() const && = delete;
    Lines repairs_text() const;
    std::vector<uint8_t> contains(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool contains(Span<const float> spots, Ref<tree_control> control, Span<uint8_t> inside) const;
    std::vector<float> levels(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool levels(Span<const float> points, Ref<tree_control> control, Span<float> levels) const;
    std::vector<float> exits(Span<const float> ways, Ref<tree_control> control = nullptr) const;
    bool exits(Span<const float> ways, Ref<tree_control> control, Span<float> exits) const;
};

class DirectionField : public detail::Object<tree_direction_field, tree_direction_field_free> {
public:
    using Object::Object;
    static DirectionField make(const Attractor &attractor, float width, float height, float base_x, float base_y, Ref<tree_field_params> params = nullptr, Ref<tree_control> control = nullptr);
    DirectionFieldColumns view() const &;
    DirectionFieldColumns view() const && = delete;
    std::vector<float> sample(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool sample(Span<const float> spots, Ref<tree_control> control, Span<float> directions) const;
    Photo picture() const;
    Photo draw_over(const Photo &photo, uint32_t color) const;
};

class Drawing : public detail::Object<tree_drawing, tree_drawing_free> {
public:
    using Object::Object;
    Plan clean(Ref<tree_clean_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    static Drawing make(Span<const tree_sketch_stroke> strokes, Ref<tree_control> control = nullptr);
    Drawing with_strokes(Span<const tree_sketch_stroke> strokes, Ref<tree_control> control = nullptr) const;
    static Drawing from_svg(std::string_view svg, Ref<tree_control> control = nullptr);
    static Drawing from_json(std::string_view json, Ref<tree_control> control = nullptr);
    Bytes to_json() const;
    size_t count() const;
    SketchStroke stroke(size_t index) const &;
    SketchStroke stroke(size_t index) const && = delete;
    static Drawing of_tree(const Tree &tree, float yaw, bool with_crown, Ref<tree_main_branch_params> main = nullptr, Ref<tree_sketch_outline_params> outline = nullptr, Ref<tree_control> control = nullptr);
    Tree from_sketch(Maybe<tree_templates> templates, Maybe<tree_volume> obstacles, Ref<tree_sketch_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_sketch_report *report = nullptr) const;
};

class Drawings : public detail::Object<tree_drawings, tree_drawings_free> {
public:
    using Object::Object;
    static Drawings from_ndjson(std::string_view ndjson, Ref<tree_control> control = nullptr);
    size_t count() const;
    Drawing at(size_t index) const;
};

class EditPairs : public detail::Object<tree_edit_pairs, tree_edit_pairs_free> {
public:
    using Object::Object;
    Span<const tree_edit_pair> view() const &;
    Span<const tree_edit_pair> view() const && = delete;
};

class EditTree : public detail::Object<tree_edit_tree, tree_edit_tree_free> {
public:
    using Object::Object;
    EditDistance distance(const EditTree &second, Ref<tree_edit_costs> costs = nullptr, Ref<tree_control> control = nullptr) const;
    std::tuple<EditDistance, EditPairs> distance_pairs(const EditTree &second, Ref<tree_edit_costs> costs = nullptr, Ref<tree_control> control = nullptr) const;
    static EditTree of_skeleton(const Skeleton &skeleton, Ref<tree_edit_params> params = nullptr);
    static EditTree from_columns(Ref<tree_edit_columns> columns, Ref<tree_control> control = nullptr);
    EditColumns view() const &;
    EditColumns view() const && = delete;
};

class Elements : public detail::Object<tree_elements, tree_elements_free> {
public:
    using Object::Object;
    static Elements of_mesh(const Mesh &mesh, Span<const uint32_t> surfaces, tree_grain grain, Ref<tree_control> control = nullptr);
    static Elements from_columns(const Mesh &mesh, Ref<tree_elements_columns> columns, Ref<tree_control> control = nullptr);
    ElementsColumns view() const &;
    ElementsColumns view() const && = delete;
    float plant_height() const;
    std::vector<uint32_t> order_stochastic(uint64_t seed) const;
    bool order_stochastic(uint64_t seed, Span<uint32_t> order) const;
    std::vector<uint32_t> order_golden() const;
    bool order_golden(Span<uint32_t> order) const;
    std::vector<uint32_t> order_density(Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    bool order_density(Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control, Span<uint32_t> order) const;
    std::vector<uint32_t> order_orientation(const Hull &hull, Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    bool order_orientation(const Hull &hull, Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control, Span<uint32_t> order) const;
    std::vector<uint32_t> order_combined(Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    bool order_combined(Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control, Span<uint32_t> order) const;
};

class Equations : public detail::Object<tree_equations, tree_equations_free> {
public:
    using Object::Object;
    static Equations make(const Carved &carved, Span<const tree_particle_view> views, Ref<tree_density_params> params = nullptr, Ref<tree_control> control = nullptr);
    EquationsColumns view() const &;
    EquationsColumns view() const && = delete;
};

class FactorGraph : public detail::Object<tree_factor_graph, tree_factor_graph_free> {
public:
    using Object::Object;
    static FactorGraph make(const Plan &plan, Ref<tree_sketch_omega> omega, Ref<tree_sketch_infer_params> params, uint64_t seed, Ref<tree_control> control = nullptr);
    Span<const uint32_t> parents() const &;
    Span<const uint32_t> parents() const && = delete;
    double length(uint32_t segment) const;
    tree_sketch_posterior posterior(Ref<tree_sketch_omega> omega, Span<const double> depths, Span<const tree_sketch_label> labels, Ref<tree_control> control = nullptr) const;
};

class FoundLeaves : public detail::Object<tree_found_leaves, tree_found_leaves_free> {
public:
    using Object::Object;
    Foliage foliage() const &;
    Foliage foliage() const && = delete;
    LeafKinds view() const &;
    LeafKinds view() const && = delete;
};

class GltfAttributes : public detail::Object<tree_gltf_attributes, tree_gltf_attributes_free> {
public:
    using Object::Object;
    Span<const tree_gltf_attribute> view() const &;
    Span<const tree_gltf_attribute> view() const && = delete;
};

class GltfLeaves : public detail::Object<tree_gltf_leaves, tree_gltf_leaves_free> {
public:
    using Object::Object;
    Span<const tree_gltf_instances> view() const &;
    Span<const tree_gltf_instances> view() const && = delete;
};

class Grammar : public detail::Object<tree_grammar, tree_grammar_free> {
public:
    using Object::Object;
    std::tuple<std::string_view, size_t> kind(uint16_t kind) const &;
    std::tuple<std::string_view, size_t> kind(uint16_t kind) const && = delete;
    uint16_t find_kind(std::string_view name, size_t n_params) const;
    Word derive(uint32_t steps, uint64_t seed, Ref<tree_control> control = nullptr) const;
    Word step(const Word &word, uint32_t step, uint32_t of, uint64_t seed, Ref<tree_control> control = nullptr) const;
    Word interpretation(const Word &word, uint64_t seed, Ref<tree_control> control = nullptr) const;
    std::tuple<Word, TurtleTrace, Tree> lsystem_grow(uint32_t steps, Ref<tree_turtle_params> turtle, uint64_t seed, Ref<tree_control> control = nullptr, tree_turtle_report *report = nullptr) const;
    static Grammar from_text(std::string_view text, Ref<tree_control> control = nullptr, tree_grammar_report *report = nullptr);
    static Grammar read(std::string_view path, Ref<tree_control> control = nullptr, tree_grammar_report *report = nullptr);
    GrammarInfo view() const &;
    GrammarInfo view() const && = delete;
    std::tuple<std::string_view, double> constant(size_t index) const &;
    std::tuple<std::string_view, double> constant(size_t index) const && = delete;
    Grammar with_constant(std::string_view name, double value, tree_grammar_report *report = nullptr) const;
    TurtleParams turtle() const &;
    TurtleParams turtle() const && = delete;
    Word word(std::string_view text, Ref<tree_control> control = nullptr, tree_grammar_report *report = nullptr) const;
    Word word_from_columns(Ref<tree_word_columns> columns, Ref<tree_control> control = nullptr, tree_grammar_report *report = nullptr) const;
    Word axiom() const;
};

class Graph : public detail::Object<tree_graph, tree_graph_free> {
public:
    using Object::Object;
    static Graph link(const GraphNodes &nodes, Ref<tree_link_params> params, uint64_t seed, Ref<tree_control> control = nullptr);
    static Graph from_edges(Span<const float> positions, Span<const uint32_t> edges, Span<const float> costs, Ref<tree_control> control = nullptr);
    GraphColumns view() const &;
    GraphColumns view() const && = delete;
    std::tuple<std::vector<float>, std::vector<uint32_t>> search(uint32_t root, Ref<tree_control> control = nullptr) const;
    bool search(uint32_t root, Ref<tree_control> control, Span<float> costs, Span<uint32_t> predecessors) const;
};

class GraphNodes : public detail::Object<tree_graph_nodes, tree_graph_nodes_free> {
public:
    using Object::Object;
    GraphNodesColumns view() const &;
    GraphNodesColumns view() const && = delete;
};

class Grid : public detail::Object<tree_grid, tree_grid_free> {
public:
    using Object::Object;
    static std::tuple<std::vector<tree_density_view>, Grid> from_views(Span<const tree_particle_view> views, Ref<tree_density_params> params = nullptr, Ref<tree_control> control = nullptr, tree_density_report *report = nullptr);
    static Grid from_views(Span<const tree_particle_view> views, Ref<tree_density_params> params, Ref<tree_control> control, tree_density_report *report, Span<tree_density_view> rows);
    Matte look_through(Ref<tree_particle_camera> camera, Ref<tree_control> control = nullptr) const;
    double crown_volume(float threshold) const;
    double overlap(float threshold, const Grid &other, float other_threshold) const;
    std::vector<float> draw_points(uint32_t n_points, const Field &weight, uint64_t seed, Ref<tree_control> control = nullptr) const;
    bool draw_points(uint32_t n_points, const Field &weight, uint64_t seed, Ref<tree_control> control, Span<float> points) const;
    Grid paint(Span<const tree_density_brush> brushes, Ref<tree_control> control = nullptr) const;
    static Grid make(const Floats<3> &corner, float voxel, uint32_t nx, uint32_t ny, uint32_t nz, Span<const float> values = {}, Ref<tree_control> control = nullptr);
    GridColumns view() const &;
    GridColumns view() const && = delete;
    std::array<float, 6> bounds() const;
    size_t index(int32_t x, int32_t y, int32_t z) const;
    std::array<int32_t, 3> voxel_at(const Floats<3> &point) const;
    std::vector<float> sample(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool sample(Span<const float> points, Ref<tree_control> control, Span<float> values) const;
    std::vector<float> nearest(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool nearest(Span<const float> points, Ref<tree_control> control, Span<float> values) const;
};

class Grown : public detail::Object<tree_grown, tree_grown_free> {
public:
    using Object::Object;
    Tree tree() const;
    GrownColumns view() const &;
    GrownColumns view() const && = delete;
};

class Growth : public detail::Object<tree_growth, tree_growth_free> {
public:
    using Object::Object;
    static Grown grow(Ref<tree_growth_params> params, uint64_t seed, Ref<tree_control> control = nullptr);
    static size_t preset_count();
    static std::string_view preset_name(size_t index);
    static GrowthParams preset(std::string_view name);
    static Growth make(Ref<tree_growth_world> world, Span<const tree_growth_plant> plants, uint64_t seed, Ref<tree_control> control = nullptr);
    static Growth stand(Ref<tree_growth_world> world, Span<const tree_growth_plant> plants, uint32_t iterations, uint64_t seed, Ref<tree_control> control = nullptr);
    bool step(uint32_t iterations, Ref<tree_control> control = nullptr) const;
    GrowthCounts measure() const;
    std::vector<float> light(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool light(Span<const float> points, Ref<tree_control> control, Span<float> light) const;
    Grown grown(size_t index, Ref<tree_control> control = nullptr) const;
    Growth copy() const;
};

class Hull : public detail::Object<tree_hull, tree_hull_free> {
public:
    using Object::Object;
    static Hull of_metaballs(const Metaballs &metaballs, Ref<tree_hull_params> params = nullptr, Ref<tree_control> control = nullptr);
    static Hull of_elements(const Elements &elements, Ref<tree_order_params> params = nullptr, Ref<tree_control> control = nullptr);
    HullColumns view() const &;
    HullColumns view() const && = delete;
    Mesh mesh() const;
    std::tuple<std::vector<float>, std::vector<float>> sample(size_t n_samples, uint64_t seed, Ref<tree_control> control = nullptr) const;
    bool sample(size_t n_samples, uint64_t seed, Ref<tree_control> control, Span<float> positions, Span<float> normals) const;
    std::tuple<std::vector<float>, std::vector<float>> nearest(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool nearest(Span<const float> points, Ref<tree_control> control, Span<float> positions, Span<float> normals) const;
};

class Hybrid : public detail::Object<tree_hybrid, tree_hybrid_free> {
public:
    using Object::Object;
    Bytes to_glb_levels(Span<const float> heights, float screen, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    bool write_glb_levels(Span<const float> heights, float screen, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    static Hybrid make(const Tree &tree, Maybe<tree_look> look = nullptr, Ref<tree_hybrid_params> params = nullptr, Ref<tree_control> control = nullptr);
    HybridTotals measure() const;
    Mesh mesh() const;
    Multires multires() const;
    MultiMesh wood() const;
    Cards cards() const;
    tree_index_window leaf_window(size_t number, uint32_t first_leaf, uint32_t n_leaves) const;
    float level(float pixels_per_metre) const;
};

class HybridChoice : public detail::Object<tree_hybrid_choice, tree_hybrid_choice_free> {
public:
    using Object::Object;
    static HybridChoice make(const Hybrid &hybrid);
    static HybridChoice for_height(const Hybrid &hybrid, float pixels);
    HybridChoiceReport update(const Floats<3> &eye, float pixels_per_metre) const;
    HybridChoiceReport measure() const;
    bool boxes(Span<uint32_t> boxes) const;
    bool ranges(Span<tree_leaf_range> ranges) const;
    Mesh mesh(Ref<tree_control> control = nullptr) const;
};

class Inferred : public detail::Object<tree_inferred, tree_inferred_free> {
public:
    using Object::Object;
    InferredColumns view() const &;
    InferredColumns view() const && = delete;
    SketchBranches branches() const;
    SketchOmega omega() const;
};

class LeafBoxes : public detail::Object<tree_leaf_boxes, tree_leaf_boxes_free> {
public:
    using Object::Object;
    static LeafBoxes along(const Skeleton &skeleton, const Mesh &mesh, const Elements &elements, Span<const uint32_t> bearers, Ref<tree_leaf_box_params> params = nullptr, Ref<tree_control> control = nullptr, tree_leaf_boxes_report *report = nullptr);
    LeafBoxesReport measure() const;
    LeafBox get_(uint32_t number) const;
    Span<const uint32_t> order() const &;
    Span<const uint32_t> order() const && = delete;
    float distance(uint32_t number, const Floats<3> &point) const;
    std::vector<tree_card_plane> planes(uint32_t number) const;
    bool planes(uint32_t number, Span<tree_card_plane> planes) const;
};

class LeafModel : public detail::Object<tree_leaf_model, tree_leaf_model_free> {
public:
    using Object::Object;
    LeafMesh view() const &;
    LeafMesh view() const && = delete;
};

class LeafOutline : public detail::Object<tree_leaf_outline, tree_leaf_outline_free> {
public:
    using Object::Object;
    static LeafOutline of(const Outline &outline, const Floats<2> &base, const Floats<2> &tip);
    static LeafOutline guess(const Outline &outline);
    LeafOutlineColumns view() const &;
    LeafOutlineColumns view() const && = delete;
    LeafModel model() const;
};

class Lines : public detail::Object<tree_lines, tree_lines_free> {
public:
    using Object::Object;
    Span<const tree_str> view() const &;
    Span<const tree_str> view() const && = delete;
};

class LodTable : public detail::Object<tree_lod_table, tree_lod_table_free> {
public:
    using Object::Object;
    tree_lod_distance lod_distance_for_quality(float near, float far) const;
    tree_lod_distance lod_distance_parity(const LodTable &cook) const;
    static LodTable from_rows(Span<const tree_lod_row> rows);
    static LodTable measure(Ref<tree_lod_subject> subject = nullptr, Ref<tree_lod_table_params> params = nullptr, Ref<tree_control> control = nullptr);
    Span<const tree_lod_row> rows() const &;
    Span<const tree_lod_row> rows() const && = delete;
    tree_lod_row at(float lambda) const;
    float lambda_for(float quality) const;
};

class Look : public detail::Object<tree_look, tree_look_free> {
public:
    using Object::Object;
    static Look built_in(Ref<tree_species> species = nullptr);
    static Look plain(Ref<tree_species> species = nullptr);
    static Look of_tree(const Tree &tree, bool plain);
    static Look make(Ref<tree_material> bark, Span<const tree_leaf_look> leaves, Ref<tree_control> control = nullptr);
    Look with_leaf(size_t kind, Ref<tree_leaf_look> leaf, Ref<tree_control> control = nullptr) const;
    size_t leaf_count() const;
    Material material(size_t number) const &;
    Material material(size_t number) const && = delete;
    Texture texture(size_t number) const;
    LeafLook leaf(size_t kind) const &;
    LeafLook leaf(size_t kind) const && = delete;
    bool check(Ref<tree_species> species = nullptr) const;
    LeafModel leaf_model(size_t kind, Ref<tree_control> control = nullptr, tree_leaf_model_report *report = nullptr) const;
    LeafMesh leaf_mesh(size_t kind) const &;
    LeafMesh leaf_mesh(size_t kind) const && = delete;
};

class Mask : public detail::Object<tree_mask, tree_mask_free> {
public:
    using Object::Object;
    MaskColumns view() const &;
    MaskColumns view() const && = delete;
    std::vector<uint8_t> bits() const;
    bool bits(Span<uint8_t> bits) const;
    Picture picture() const;
};

class Matte : public detail::Object<tree_matte, tree_matte_free> {
public:
    using Object::Object;
    Matte paint(Span<const tree_density_stroke> strokes, Ref<tree_control> control = nullptr) const;
    std::tuple<ParticleCamera, AlignReport> align(Ref<tree_align_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    static std::tuple<Trimap, Lines, Matte> automatic(const Photo &photo, Ref<tree_automatic_params> params = nullptr, Ref<tree_control> control = nullptr, tree_automatic_report *report = nullptr);
    std::tuple<std::vector<float>, size_t> seeds(const Floats<2> &base_pixel, uint32_t most, Ref<tree_seed_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    size_t seeds(const Floats<2> &base_pixel, uint32_t most, Ref<tree_seed_params> params, uint64_t seed, Ref<tree_control> control, Span<float> seeds) const;
    static Matte from_alpha(uint32_t width, uint32_t height, Span<const float> alpha, Ref<tree_control> control = nullptr);
    static Matte of_photo(const Photo &photo);
    MatteColumns view() const &;
    MatteColumns view() const && = delete;
    std::vector<float> sample(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool sample(Span<const float> spots, Ref<tree_control> control, Span<float> values) const;
    Matte mirrored() const;
    std::tuple<ParticleCamera, Photo, Matte> turned(Maybe<tree_photo> photo, Ref<tree_particle_camera> camera) const;
    Bytes to_png() const;
    bool write_png(std::string_view path) const;
    static std::tuple<Lines, Matte> natural(const Photo &photo, const Trimap &trimap, Ref<tree_natural_params> params = nullptr, Ref<tree_control> control = nullptr, tree_natural_report *report = nullptr);
    static Matte screen(const Photo &photo, Ref<tree_screen_params> params = nullptr, Ref<tree_control> control = nullptr);
    static Matte difference(const Photo &photo, const Photo &plate, Ref<tree_difference_params> params = nullptr, Ref<tree_control> control = nullptr);
};

class Mesh : public detail::Object<tree_mesh, tree_mesh_free> {
public:
    using Object::Object;
    BranchMotion branch_motion(size_t branch) const;
    float branch_reach(size_t branch, const Floats<3> &point) const;
    Packed pack(size_t surface, tree_layout layout, Ref<tree_control> control = nullptr) const;
    std::vector<tree_vertex_wind> wind(size_t surface) const;
    bool wind(size_t surface, Span<tree_vertex_wind> rows) const;
    std::vector<float> bend(Ref<tree_wind> wind, float seconds, size_t surface) const;
    bool bend(Ref<tree_wind> wind, float seconds, size_t surface, Span<float> positions) const;
    bool write_glb(std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_glb(Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    static std::tuple<Mesh, GltfLeaves> build_instanced(const Tree &tree, Maybe<tree_look> look = nullptr, Ref<tree_mesh_params> params = nullptr, Ref<tree_control> control = nullptr);
    bool write_glb_moving(Ref<tree_glb_motion> motion, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_glb_moving(Ref<tree_glb_motion> motion = nullptr, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    GltfAttributes gltf_wind(Ref<tree_control> control = nullptr) const;
    bool write_obj(std::string_view path, Ref<tree_control> control = nullptr) const;
    std::tuple<Bytes, Bytes> to_obj(std::string_view stem, Ref<tree_control> control = nullptr) const;
    bool write_ply(std::string_view path, Ref<tree_ply_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_ply(Ref<tree_ply_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    static Mesh read(std::string_view path, Ref<tree_import_options> options = nullptr, Ref<tree_control> control = nullptr, tree_import_report *report = nullptr);
    static Mesh from_bytes(tree_mesh_format format, Span<const uint8_t> data, Span<const uint8_t> mtl = {}, Ref<tree_control> control = nullptr, tree_import_report *report = nullptr);
    std::tuple<std::vector<uint32_t>, std::vector<float>> order_coverage(const Elements &elements, Maybe<tree_tiers> tiers, size_t tier, Ref<tree_coverage_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    bool order_coverage(const Elements &elements, Maybe<tree_tiers> tiers, size_t tier, Ref<tree_coverage_params> params, Ref<tree_control> control, Span<uint32_t> order, Span<float> pivots) const;
    bool score(const Mesh &full, Ref<tree_around> around, Ref<tree_control> control, Span<tree_score> scores) const;
    Span<const tree_wind_branch> branches() const &;
    Span<const tree_wind_branch> branches() const && = delete;
    static Mesh build(const Tree &tree, Maybe<tree_look> look = nullptr, Ref<tree_mesh_params> params = nullptr, Ref<tree_control> control = nullptr, tree_mesh_report *report = nullptr);
    static Mesh build_leaves(const Tree &tree, Maybe<tree_look> look = nullptr, Ref<tree_mesh_params> params = nullptr, Ref<tree_control> control = nullptr);
    Mesh subdivide(size_t number, Ref<tree_subdivide_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    Mesh displace(size_t number, Ref<tree_displace_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    Mesh bake_occlusion(Ref<tree_occlusion_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    Mesh weld(size_t number, Ref<tree_control> control = nullptr) const;
    static Mesh from_surfaces(Span<const tree_surface> surfaces, Span<const tree_material> materials, Span<const tree_wind_branch> branches = {}, Ref<tree_control> control = nullptr);
    Material material(size_t number) const &;
    Material material(size_t number) const && = delete;
    Texture texture(size_t number) const;
    Topology examine(size_t number, Ref<tree_control> control = nullptr) const;
    std::tuple<std::vector<uint32_t>, std::vector<uint32_t>, size_t> points(size_t number) const;
    size_t points(size_t number, Span<uint32_t> of_vertex, Span<uint32_t> first) const;
    Crossings crossings(size_t number, Ref<tree_control> control = nullptr) const;
    MeshTotals measure() const;
    size_t surface_count() const;
    Surface surface(size_t number) const &;
    Surface surface(size_t number) const && = delete;
    Bounds surface_bounds(size_t number) const;
    Bounds bounds() const;
    bool check() const;
    bool check_surface(size_t number) const;
    bool check_colors() const;
    bool check_normals() const;
    Picture render(Ref<tree_view> view = nullptr, Ref<tree_style> style = nullptr, Ref<tree_control> control = nullptr) const;
    Mask render_mask(Ref<tree_view> view = nullptr, Ref<tree_control> control = nullptr) const;
    Picture render_silhouette(Ref<tree_view> view = nullptr, Ref<tree_control> control = nullptr) const;
    Tree skeletonize_mesh(Span<const tree_hint> hints = {}, Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr, tree_skeletonize_report *report = nullptr) const;
};

class Metaballs : public detail::Object<tree_metaballs, tree_metaballs_free> {
public:
    using Object::Object;
    static Metaballs make(Span<const float> points, float radius, Ref<tree_control> control = nullptr);
    static Metaballs of_elements(const Elements &elements, float radius, float height, Ref<tree_control> control = nullptr);
    float radius() const;
    size_t count() const;
    std::array<float, 6> bounds() const;
    std::vector<float> values(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool values(Span<const float> points, Ref<tree_control> control, Span<float> values) const;
    std::vector<float> gradients(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool gradients(Span<const float> points, Ref<tree_control> control, Span<float> gradients) const;
};

class Midlines : public detail::Object<tree_midlines, tree_midlines_free> {
public:
    using Object::Object;
    static Midlines of(Ref<tree_strokes_columns> columns, Ref<tree_midline_params> params = nullptr, Ref<tree_control> control = nullptr);
    StrokesColumns view() const &;
    StrokesColumns view() const && = delete;
    Span<const float> half_widths() const &;
    Span<const float> half_widths() const && = delete;
};

class Mips : public detail::Object<tree_mips, tree_mips_free> {
public:
    using Object::Object;
    static Mips of_picture(const Picture &picture, size_t most, Ref<tree_control> control = nullptr);
    size_t count() const;
    Pixels view(size_t number) const &;
    Pixels view(size_t number) const && = delete;
};

class MultiChain : public detail::Object<tree_multi_chain, tree_multi_chain_free> {
public:
    using Object::Object;
    static MultiChain make(const MultiPaths &paths, Ref<tree_control> control = nullptr);
    MultiChainColumns view() const &;
    MultiChainColumns view() const && = delete;
    Bytes to_text(size_t n_levels, std::string_view text, Span<const uint32_t> ends, Ref<tree_control> control = nullptr) const;
};

class MultiMesh : public detail::Object<tree_multi_mesh, tree_multi_mesh_free> {
public:
    using Object::Object;
    Bytes to_glb(Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    bool write_glb(std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_glb_levels(Span<const tree_level_share> levels, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    bool write_glb_levels(Span<const tree_level_share> levels, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    static std::string_view shader(tree_shader language);
    static std::array<float, 3> position(const Floats<3> &vertex, const Floats<4> &branch, float level);
    static MultiMesh make(const Multires &multires, Maybe<tree_look> look = nullptr, Ref<tree_mesh_params> params = nullptr, Ref<tree_control> control = nullptr);
    MultiMeshTotals measure() const;
    Mesh mesh() const;
    MultiMeshColumn branches(size_t number) const &;
    MultiMeshColumn branches(size_t number) const && = delete;
    std::tuple<std::vector<tree_multi_draw>, uint64_t> draws(float level) const;
    uint64_t draws(float level, Span<tree_multi_draw> draws) const;
    uint32_t wood_indices(float level) const;
    size_t level_of_wood(uint64_t n_triangles) const;
    Mesh mesh_at(float level, Ref<tree_control> control = nullptr) const;
};

class MultiPaths : public detail::Object<tree_multi_paths, tree_multi_paths_free> {
public:
    using Object::Object;
    static MultiPaths make(const Adt &adt, Ref<tree_metric_params> params, uint64_t seed, Ref<tree_control> control = nullptr);
    size_t count() const;
    Span<const uint32_t> branches() const &;
    Span<const uint32_t> branches() const && = delete;
    Span<const uint32_t> path(size_t number) const &;
    Span<const uint32_t> path(size_t number) const && = delete;
};

class Multires : public detail::Object<tree_multires, tree_multires_free> {
public:
    using Object::Object;
    static Multires make(const Tree &tree, Ref<tree_metric_params> params, uint64_t seed, Ref<tree_control> control = nullptr);
    static std::tuple<Rows, Rows, Multires> of_paths(const Tree &tree, const MultiPaths &paths, Ref<tree_control> control = nullptr);
    size_t count() const;
    std::tuple<size_t, size_t> level_counts(size_t n_levels) const;
    std::tuple<SkeletonColumns, Foliage> level(size_t n_levels) const &;
    std::tuple<SkeletonColumns, Foliage> level(size_t n_levels) const && = delete;
    Tree tree_at(size_t n_levels, Ref<tree_control> control = nullptr) const;
    size_t level_of_nodes(size_t n_nodes) const;
    Bytes to_stream(size_t n_levels, Ref<tree_stream_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    bool write_stream(size_t n_levels, std::string_view path, Ref<tree_stream_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_bracketed(Ref<tree_stream_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    static Multires from_stream(Span<const uint8_t> data, Ref<tree_control> control = nullptr, tree_stream_report *report = nullptr);
    static Multires read_stream(std::string_view path, Ref<tree_control> control = nullptr, tree_stream_report *report = nullptr);
};

class Octahedral : public detail::Object<tree_octahedral, tree_octahedral_free> {
public:
    using Object::Object;
    static std::array<float, 2> encode(const Floats<3> &direction, bool hemi);
    static std::array<float, 3> decode(const Floats<2> &place, bool hemi);
    static std::vector<tree_octahedral_frame> frames(const Floats<3> &direction, uint32_t grid, bool hemi);
    static bool frames(const Floats<3> &direction, uint32_t grid, bool hemi, Span<tree_octahedral_frame> frames);
    static std::tuple<std::array<float, 3>, std::array<float, 3>, std::array<float, 3>> axes(uint32_t column, uint32_t row, uint32_t grid, bool hemi);
    static Octahedral bake(const Mesh &mesh, Ref<tree_octahedral_params> params = nullptr, Ref<tree_control> control = nullptr, tree_octahedral_report *report = nullptr);
    static Octahedral from_pictures(Ref<tree_octahedral_meta> meta, const Picture &color, const Picture &detail, Ref<tree_control> control = nullptr);
    OctahedralReport measure() const;
    OctahedralMeta describe() const;
    Bytes to_json() const;
    Pixels pixels(tree_impostor_map map) const &;
    Pixels pixels(tree_impostor_map map) const && = delete;
    Picture picture(tree_impostor_map map, Ref<tree_control> control = nullptr) const;
    Picture view(Ref<tree_view> view = nullptr, Ref<tree_control> control = nullptr) const;
    Mask mask(Ref<tree_view> view = nullptr, Ref<tree_control> control = nullptr) const;
    static std::string_view shader(tree_shader language);
};

class Outline : public detail::Object<tree_outline, tree_outline_free> {
public:
    using Object::Object;
    Bumps bumps(Ref<tree_bump_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    std::tuple<std::array<float, 2>, std::array<float, 2>> leaf_outline_ends() const;
    std::vector<uint8_t> contains(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool contains(Span<const float> spots, Ref<tree_control> control, Span<uint8_t> inside) const;
    std::vector<float> exits(Span<const float> rays, Ref<tree_control> control = nullptr) const;
    bool exits(Span<const float> rays, Ref<tree_control> control, Span<float> exits) const;
    std::tuple<std::vector<float>, std::vector<float>> nearest(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool nearest(Span<const float> spots, Ref<tree_control> control, Span<float> lengths, Span<float> distances) const;
    std::tuple<std::vector<float>, std::vector<float>> along(Span<const float> lengths, Ref<tree_control> control = nullptr) const;
    bool along(Span<const float> lengths, Ref<tree_control> control, Span<float> points, Span<float> tangents) const;
    std::tuple<std::vector<float>, size_t> part(float from, float to) const;
    size_t part(float from, float to, Span<float> points) const;
    std::tuple<float, float> overlap(const Outline &other) const;
    std::vector<uint8_t> mask(const Floats<2> &low, const Floats<2> &high, uint32_t width, uint32_t height, Ref<tree_control> control = nullptr) const;
    bool mask(const Floats<2> &low, const Floats<2> &high, uint32_t width, uint32_t height, Ref<tree_control> control, Span<uint8_t> cells) const;
    static Outline close(Span<const float> stroke, std::string_view name, Ref<tree_outline_close_params> params = nullptr, Ref<tree_control> control = nullptr);
    static Outline from_points(Span<const float> spots, Ref<tree_control> control = nullptr);
    OutlineColumns view() const &;
    OutlineColumns view() const && = delete;
    Span<const tree_outline_repair> repairs() const &;
    Span<const tree_outline_repair> repairs() const && = delete;
    Lines repairs_text() const;
    Outline resampled(uint32_t n_points, Ref<tree_control> control = nullptr) const;
    Outline transformed(const Floats<6> &affine) const;
    Outline sub(Span<const float> branch, float radius, const Floats<2> &stretch, Ref<tree_sub_params> params = nullptr, Ref<tree_control> control = nullptr, tree_sub_report *report = nullptr) const;
};

class OutlineDrawing : public detail::Object<tree_outline_drawing, tree_outline_drawing_free> {
public:
    using Object::Object;
    static OutlineDrawing make(Span<const tree_drawn_stroke> strokes, std::string_view name, float trunk_width, Ref<tree_control> control = nullptr);
    static OutlineDrawing from_svg(std::string_view svg, Ref<tree_control> control = nullptr);
    static OutlineDrawing of_matte(const Matte &matte, float threshold, Ref<tree_control> control = nullptr);
    static OutlineDrawing of_photo(const Photo &photo, Ref<tree_control> control = nullptr);
    size_t count() const;
    DrawnTree tree(size_t index) const &;
    DrawnTree tree(size_t index) const && = delete;
    DrawnStroke stroke(size_t number, size_t index) const &;
    DrawnStroke stroke(size_t number, size_t index) const && = delete;
    Span<const tree_drawn_repair> repairs() const &;
    Span<const tree_drawn_repair> repairs() const && = delete;
    Lines repairs_text() const;
};

class OutlinePlan : public detail::Object<tree_outline_plan, tree_outline_plan_free> {
public:
    using Object::Object;
    std::tuple<SilhouetteGrown, Tree> grow(Ref<tree_silhouette_grow_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    OutlinePlanColumns view() const &;
    OutlinePlanColumns view() const && = delete;
    size_t find(uint32_t id) const;
    OutlineBranch branch(uint32_t id) const &;
    OutlineBranch branch(uint32_t id) const && = delete;
    OutlineSystem system(uint32_t id) const &;
    OutlineSystem system(uint32_t id) const && = delete;
    std::tuple<float, Outline> section(uint32_t id, size_t section) const;
    Outline outline(uint32_t id) const;
    uint32_t count_levels() const;
    std::tuple<float, LeafOutline> leaf() const;
};

class Packed : public detail::Object<tree_packed, tree_packed_free> {
public:
    using Object::Object;
    PackedColumns view() const &;
    PackedColumns view() const && = delete;
    Pivots pivots() const &;
    Pivots pivots() const && = delete;
    PivotElement pivot_element(uint32_t number) const;
    Unpacked unpack(Maybe<tree_mesh> mesh = nullptr) const;
    PackedVertices vertices_view() const &;
    PackedVertices vertices_view() const && = delete;
};

class Photo : public detail::Object<tree_photo, tree_photo_free> {
public:
    using Object::Object;
    Photo draw(Span<const tree_mark> marks, Ref<tree_control> control = nullptr) const;
    static Photo blank(uint32_t width, uint32_t height, uint32_t rgba, Ref<tree_control> control = nullptr);
    static Photo of_matte(const Matte &matte);
    static Photo from_pixels(uint32_t width, uint32_t height, Span<const uint8_t> pixels, Ref<tree_control> control = nullptr);
    static Photo read(std::string_view path, Ref<tree_control> control = nullptr);
    static Photo from_bytes(Span<const uint8_t> data, Ref<tree_control> control = nullptr);
    Pixels view() const &;
    Pixels view() const && = delete;
    bool has_alpha() const;
    Photo mirrored() const;
    Bytes to_png() const;
    bool write_png(std::string_view path) const;
    Matte mask(Ref<tree_control> control = nullptr) const;
};

class PhotoSession : public detail::Object<tree_photo_session, tree_photo_session_free> {
public:
    using Object::Object;
    static PhotoSession make(Span<const tree_photo_shot> shots, Ref<tree_photo_params> params, uint64_t seed, Ref<tree_control> control = nullptr);
    PhotoSession copy() const;
    bool set_seed(uint64_t seed) const;
    bool set_params(Ref<tree_photo_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    bool set_placing(size_t view, Ref<tree_photo_placing> placing = nullptr) const;
    bool paint(size_t view, Span<const tree_density_stroke> strokes, Ref<tree_control> control = nullptr) const;
    bool set_matte(size_t view, const Matte &matte) const;
    bool paint_volume(Span<const tree_density_brush> brushes, Ref<tree_control> control = nullptr) const;
    bool set_density(const Grid &density) const;
    bool set_branches(size_t view, Ref<tree_photo_branches> branches = nullptr, Ref<tree_control> control = nullptr) const;
    bool edit_attractor(size_t view, const Attractor &attractor, Ref<tree_control> control = nullptr) const;
    bool redo_from(tree_photo_stage stage) const;
    size_t count() const;
    size_t count_views(Ref<tree_control> control = nullptr) const;
    uint64_t seed() const;
    PhotoParams get_params() const &;
    PhotoParams get_params() const && = delete;
    uint32_t runs(tree_photo_stage stage) const;
    Matte matte(size_t view) const;
    Photo photo(size_t view) const;
    ParticleCamera camera(size_t view, Ref<tree_control> control = nullptr) const;
    Attractor attractor(size_t view, Ref<tree_control> control = nullptr) const;
    Strokes strokes(size_t view, Ref<tree_control> control = nullptr) const;
    Grid density(Ref<tree_control> control = nullptr) const;
    DirectionField field(size_t view, Ref<tree_control> control = nullptr) const;
    Traces traces(Ref<tree_control> control = nullptr) const;
    Skeleton wood(Ref<tree_control> control = nullptr) const;
    Tree tree(Ref<tree_control> control = nullptr, tree_photo_report *report = nullptr) const;
    PhotoViewReport view_report(size_t view, Ref<tree_control> control = nullptr) const;
    bool gaps(size_t view, Ref<tree_control> control, Span<float> gaps) const;
    size_t disagreements(Ref<tree_control> control, Span<tree_align_warning> warnings) const;
    Lines warnings(Ref<tree_control> control = nullptr) const;
    Photo draw_matte(size_t view) const;
    Photo draw_attractor(size_t view, Ref<tree_control> control = nullptr) const;
    Photo draw_field(size_t view, Ref<tree_control> control = nullptr) const;
    Photo draw_traces(size_t view, Ref<tree_control> control = nullptr) const;
    Photo draw_density(Ref<tree_control> control = nullptr) const;
};

class Picture : public detail::Object<tree_picture, tree_picture_free> {
public:
    using Object::Object;
    static Picture from_pixels(uint32_t width, uint32_t height, Span<const uint8_t> pixels, Ref<tree_control> control = nullptr);
    Pixels view() const &;
    Pixels view() const && = delete;
    bool write_png(std::string_view path) const;
    Bytes to_png() const;
};

class Pieces : public detail::Object<tree_pieces, tree_pieces_free> {
public:
    using Object::Object;
    static Pieces make(const Handles<tree_skeleton> &skeletons, Span<const tree_piece> rows, Ref<tree_control> control = nullptr);
    size_t count() const;
    std::tuple<tree_piece, Skeleton> piece(size_t index) const;
    std::tuple<std::vector<uint8_t>, Skeleton> link(Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    Skeleton link(Ref<tree_skeletonize_params> params, Ref<tree_control> control, Span<uint8_t> reached) const;
};

class Plan : public detail::Object<tree_plan, tree_plan_free> {
public:
    using Object::Object;
    Inferred sketch_infer(Ref<tree_sketch_omega> omega, Span<const tree_sketch_pin> pins, const Crown &crown, Ref<tree_sketch_infer_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    static Plan from_columns(Ref<tree_plan_columns> columns, Ref<tree_control> control = nullptr);
    PlanColumns view() const &;
    PlanColumns view() const && = delete;
    StrokesColumns crown() const &;
    StrokesColumns crown() const && = delete;
    Span<const uint32_t> crown_strokes() const &;
    Span<const uint32_t> crown_strokes() const && = delete;
    Span<const tree_clean_repair> repairs() const &;
    Span<const tree_clean_repair> repairs() const && = delete;
    Lines repairs_text() const;
    Plan scaled(float factor) const;
    std::vector<float> points_to_drawing(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool points_to_drawing(Span<const float> spots, Ref<tree_control> control, Span<float> drawn) const;
    std::vector<float> points_from_drawing(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool points_from_drawing(Span<const float> spots, Ref<tree_control> control, Span<float> planned) const;
};

class Plastic : public detail::Object<tree_plastic, tree_plastic_free> {
public:
    using Object::Object;
    static Plastic make(const Tree &tree, Ref<tree_plastic_params> params = nullptr, Ref<tree_control> control = nullptr, tree_plastic_report *report = nullptr);
    PlasticReport measure() const;
    PlasticParams get_params() const;
    Tree tree() const;
    PlasticColumns view() const &;
    PlasticColumns view() const && = delete;
    PlasticRegrowth regrowth_of() const &;
    PlasticRegrowth regrowth_of() const && = delete;
};

class PlasticClusters : public detail::Object<tree_plastic_clusters, tree_plastic_clusters_free> {
public:
    using Object::Object;
    static PlasticClusters of_season(const Plastic &plastic, uint32_t season);
    Span<const tree_plastic_cluster> view() const &;
    Span<const tree_plastic_cluster> view() const && = delete;
};

class PlasticScene : public detail::Object<tree_plastic_scene, tree_plastic_scene_free> {
public:
    using Object::Object;
    Adapted adapted(uint64_t id, Ref<tree_control> control = nullptr, tree_adapted_report *report = nullptr) const;
    PlasticClusters clusters(uint64_t id) const;
    uint64_t add_tree(const Plastic &plastic, const tree_pose &pose) const;
    bool move_tree(uint64_t id, const tree_pose &pose) const;
    bool remove_tree(uint64_t id) const;
    uint64_t add_obstacle(const Volume &volume, const tree_pose &pose) const;
    bool move_obstacle(uint64_t id, const tree_pose &pose) const;
    bool remove_obstacle(uint64_t id) const;
    std::vector<tree_plastic_motion> motions(uint64_t id) const;
    bool motions(uint64_t id, Span<tree_plastic_motion> motions) const;
    PlasticSky get_sky() const;
    PlasticResponse get_response() const;
    Span<const uint64_t> trees() const &;
    Span<const uint64_t> trees() const && = delete;
    Span<const uint64_t> obstacles() const &;
    Span<const uint64_t> obstacles() const && = delete;
    Span<const uint64_t> changed() const &;
    Span<const uint64_t> changed() const && = delete;
    tree_pose pose(uint64_t id) const;
    Plastic model(uint64_t id) const;
    std::tuple<PlasticRegrown, Tree> regrown(uint64_t id, Ref<tree_plastic_regrowth> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    static PlasticScene make(Ref<tree_plastic_sky> sky = nullptr, Ref<tree_plastic_response> response = nullptr);
    PlasticScene copy() const;
    bool set_sky(Ref<tree_plastic_sky> sky = nullptr) const;
    bool set_response(Ref<tree_plastic_response> response = nullptr) const;
    PlasticUpdate update(Ref<tree_control> control = nullptr) const;
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
    ProfileColumns view() const &;
    ProfileColumns view() const && = delete;
    Volume volume(const Floats<3> &base) const;
};

class Pruned : public detail::Object<tree_pruned, tree_pruned_free> {
public:
    using Object::Object;
    PrunedTotals measure() const;
    Mesh mesh() const;
    PrunedPart part_view(size_t number) const &;
    PrunedPart part_view(size_t number) const && = delete;
    LodTable table() const;
    std::vector<uint32_t> kept() const;
    bool kept(Span<uint32_t> kept) const;
    tree_lod_cut cut(float lambda) const;
    tree_lod_cut step(uint64_t step) const;
    float lambda_of(uint64_t n_triangles) const;
    float lambda_of_rank(uint32_t rank) const;
    Bytes to_glb(Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    bool write_glb(std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    Bytes to_glb_levels(Span<const float> lambdas, Ref<tree_lod_screen> screen = nullptr, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    bool write_glb_levels(Span<const float> lambdas, Ref<tree_lod_screen> screen, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr) const;
    std::tuple<tree_lod_level, std::vector<tree_lod_window>> level(float lambda) const;
    tree_lod_level level(float lambda, Span<tree_lod_window> windows) const;
    std::tuple<std::vector<tree_lod_level>, std::vector<tree_lod_window>, size_t> levels(size_t n) const;
    size_t levels(size_t n, Span<tree_lod_level> levels, Span<tree_lod_window> windows) const;
    Mesh mesh_at(float lambda, Ref<tree_control> control = nullptr) const;
    Mesh mesh_of(const tree_lod_level &level, Span<const tree_lod_window> windows, Ref<tree_control> control = nullptr) const;
    Bytes to_json(Span<const tree_lod_level> levels, Span<const tree_lod_window> windows) const;
    static Pruned make(const Mesh &mesh, Ref<tree_prune_make_params> params = nullptr, Ref<tree_control> control = nullptr);
    static Pruned make(Ref<tree_lod_subject> subject, const LodTable &table, Ref<tree_prune_params> params = nullptr, Ref<tree_control> control = nullptr);
    SceneLevels scene_levels(size_t n, const tree_lod_distance &distance) const;
};

class Revolved : public detail::Object<tree_revolved, tree_revolved_free> {
public:
    using Object::Object;
    static Revolved of(Span<const float> axis, const Handles<tree_outline> &outlines, Span<const float> azimuths, Ref<tree_control> control = nullptr);
    RevolvedFrame view() const;
    std::vector<float> to_frame(Span<const float> spots, Ref<tree_control> control = nullptr) const;
    bool to_frame(Span<const float> spots, Ref<tree_control> control, Span<float> places) const;
    size_t half(float azimuth, Span<float> points) const;
    Outline profile(float azimuth) const;
    std::vector<float> exits(Span<const float> rays, Span<const float> azimuths, Ref<tree_control> control = nullptr) const;
    bool exits(Span<const float> rays, Span<const float> azimuths, Ref<tree_control> control, Span<float> exits) const;
    std::vector<uint8_t> contains(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool contains(Span<const float> points, Ref<tree_control> control, Span<uint8_t> inside) const;
};

class Rows : public detail::Object<tree_rows, tree_rows_free> {
public:
    using Object::Object;
    Span<const uint32_t> view() const &;
    Span<const uint32_t> view() const && = delete;
};

class Scanned : public detail::Object<tree_scanned, tree_scanned_free> {
public:
    using Object::Object;
    size_t count() const;
    Skeleton skeleton(size_t index) const;
    ScannedColumns view(size_t index) const &;
    ScannedColumns view(size_t index) const && = delete;
    std::tuple<float, size_t> bridge(size_t index) const;
};

class Scene : public detail::Object<tree_scene, tree_scene_free> {
public:
    using Object::Object;
    static Scene make(Span<const tree_scene_model> models, Span<const tree_scene_instance> instances, Ref<tree_control> control = nullptr);
    bool set_instances(size_t first, Span<const tree_scene_instance> instances) const;
    SceneNeeds measure() const;
    static bool eye_check(const Floats<16> &view, const Floats<16> &projection);
};

class SceneLevels : public detail::Object<tree_scene_levels, tree_scene_levels_free> {
public:
    using Object::Object;
    SceneModel model() const &;
    SceneModel model() const && = delete;
};

class SceneState : public detail::Object<tree_scene_state, tree_scene_state_free> {
public:
    using Object::Object;
    static SceneState make(const Scene &scene, Ref<tree_control> control = nullptr);
    size_t count_drawn() const;
    tree_scene_shown shown(const Scene &scene, size_t instance) const;
    SceneReport select(const Scene &scene, Ref<tree_scene_frame> frame, Ref<tree_scene_params> params = nullptr) const;
    std::tuple<size_t, size_t> draws(const Scene &scene, Span<tree_draw_indexed> draws, Span<tree_instance_lod> rows) const;
    std::tuple<size_t, size_t> batches(const Scene &scene, Span<tree_draw_indexed> draws, Span<tree_instance_lod> rows) const;
};

class Separation : public detail::Object<tree_separation, tree_separation_free> {
public:
    using Object::Object;
    FoundLeaves leaves(const Skeleton &skeleton, Ref<tree_control> control = nullptr) const;
    Pieces follow(Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    static Separation make(Span<const tree_mesh_part> parts, Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr);
    static Separation of_mesh(const Mesh &mesh, Span<const tree_hint> hints = {}, Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr);
    SeparationColumns view() const &;
    SeparationColumns view() const && = delete;
    Separation with_classes(Span<const tree_class> classes) const;
    Skeleton outward(const Skeleton &skeleton) const;
};

class SilhouetteChange : public detail::Object<tree_silhouette_change, tree_silhouette_change_free> {
public:
    using Object::Object;
    SilhouetteChangeColumns view() const &;
    SilhouetteChangeColumns view() const && = delete;
};

class SilhouetteSession : public detail::Object<tree_silhouette_session, tree_silhouette_session_free> {
public:
    using Object::Object;
    static SilhouetteSession make(Ref<tree_silhouette_params> params, uint64_t seed);
    static SilhouetteSession of_drawing(const OutlineDrawing &drawing, size_t tree, Ref<tree_silhouette_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_silhouette_play_report *report = nullptr);
    SilhouetteSession copy() const;
    SilhouetteChange draw_trunk(Span<const float> stroke, Ref<tree_control> control = nullptr) const;
    SilhouetteChange draw_crown(Span<const float> stroke, Ref<tree_control> control = nullptr) const;
    SilhouetteChange draw_section(float azimuth, Span<const float> stroke, Ref<tree_control> control = nullptr) const;
    SilhouetteChange refine(uint32_t level, Span<const float> stroke, Ref<tree_control> control = nullptr) const;
    SilhouetteChange refine_branch(uint32_t id, Span<const float> stroke, Ref<tree_control> control = nullptr) const;
    SilhouetteChange redraw(uint32_t level, Span<const float> stroke, tree_transfer transfer, Span<const uint32_t> only, Ref<tree_control> control = nullptr) const;
    SilhouetteChange redraw_from(float yaw, float pitch, Span<const float> stroke, tree_transfer transfer, Span<const uint32_t> only, Ref<tree_control> control = nullptr) const;
    SilhouetteChange remove(uint32_t id) const;
    SilhouetteChange draw_leaf(Span<const float> stroke, Ref<tree_control> control = nullptr) const;
    SilhouetteChange copy_style(uint32_t source, Span<const uint32_t> targets) const;
    SilhouetteChange set_params(Ref<tree_silhouette_params> params = nullptr) const;
    bool set_seed(uint64_t seed) const;
    SilhouetteChange undo() const;
    SilhouetteChange redo() const;
    uint64_t seed() const;
    SilhouetteParams get_params() const &;
    SilhouetteParams get_params() const && = delete;
    std::tuple<size_t, size_t> depth() const;
    std::tuple<float, float> coverage() const;
    Lines repairs() const;
    Lines refused() const;
    OutlinePlan plan() const;
    std::tuple<SilhouetteGrown, Tree> tree(Ref<tree_control> control = nullptr) const;
};

class Skeleton : public detail::Object<tree_skeleton, tree_skeleton_free> {
public:
    using Object::Object;
    std::vector<float> radii(Ref<tree_radius_rule> rule = nullptr) const;
    bool radii(Ref<tree_radius_rule> rule, Span<float> radii) const;
    Skeleton with_rule(Ref<tree_radius_rule> rule = nullptr) const;
    std::vector<float> radii_at_levels(Span<const uint32_t> levels, Ref<tree_radius_rule> rule = nullptr) const;
    bool radii_at_levels(Span<const uint32_t> levels, Ref<tree_radius_rule> rule, Span<float> radii) const;
    std::vector<uint64_t> strands(Ref<tree_radius_rule> rule = nullptr) const;
    bool strands(Ref<tree_radius_rule> rule, Span<uint64_t> strands) const;
    EditDistance distance(const Skeleton &second, Ref<tree_edit_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    std::tuple<EditDistance, EditPairs> distance_pairs(const Skeleton &second, Ref<tree_edit_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    WindBranches wind_branches(tree_continuation continuation) const;
    Capsules capsules(Ref<tree_capsule_params> params = nullptr, Ref<tree_control> control = nullptr, tree_capsule_report *report = nullptr) const;
    std::tuple<Rows, Skeleton> refine(float bearing, float spacing, Ref<tree_control> control = nullptr) const;
    std::vector<uint32_t> leaf_bearers_nearest(const Elements &elements, Ref<tree_control> control = nullptr) const;
    bool leaf_bearers_nearest(const Elements &elements, Ref<tree_control> control, Span<uint32_t> bearers) const;
    Word to_word(Ref<tree_foliage> foliage = nullptr, Ref<tree_chain_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    Tree grow_crown(const Grid &density, Span<const tree_particle_view> views, float height, Ref<tree_finish_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_crown_report *report = nullptr) const;
    std::tuple<std::vector<uint16_t>, std::vector<float>, size_t> ages(float internode, uint32_t most) const;
    size_t ages(float internode, uint32_t most, Span<uint16_t> seasons, Span<float> rates) const;
    static Skeleton from_columns(Ref<tree_skeleton_columns> columns, Ref<tree_control> control = nullptr);
    static std::tuple<std::vector<uint32_t>, Skeleton> from_unordered(Ref<tree_skeleton_columns> columns, Ref<tree_control> control = nullptr);
    static Skeleton from_unordered(Ref<tree_skeleton_columns> columns, Ref<tree_control> control, Span<uint32_t> rows);
    SkeletonColumns view() const &;
    SkeletonColumns view() const && = delete;
    std::array<float, 6> bounds() const;
    Axes axes(tree_continuation rule) const;
    BranchingReport branching() const;
    std::vector<uint32_t> strahler_orders() const;
    bool strahler_orders(Span<uint32_t> orders) const;
    std::tuple<std::vector<tree_strahler_order>, size_t> strahler_counts() const;
    size_t strahler_counts(Span<tree_strahler_order> rows) const;
    std::tuple<std::vector<tree_unbranched_run>, size_t> runs() const;
    size_t runs(Span<tree_unbranched_run> runs) const;
    std::vector<uint32_t> run_of() const;
    bool run_of(Span<uint32_t> run_of) const;
    std::tuple<std::vector<double>, size_t> pipe_exponents() const;
    size_t pipe_exponents(Span<double> exponents) const;
    std::tuple<std::vector<tree_lateral_angle>, size_t> lateral_angles(tree_continuation rule, float reach) const;
    size_t lateral_angles(tree_continuation rule, float reach, Span<tree_lateral_angle> laterals) const;
    Skeleton with_radii(Span<const float> radii) const;
    Skeleton with_positions(Span<const float> positions) const;
    std::vector<float> segment_lengths() const;
    bool segment_lengths(Span<float> lengths) const;
    std::vector<float> distances_to_root() const;
    bool distances_to_root(Span<float> distances) const;
    std::vector<float> distances_to_tip() const;
    bool distances_to_tip(Span<float> distances) const;
    std::vector<uint32_t> subtree_sizes() const;
    bool subtree_sizes(Span<uint32_t> sizes) const;
    std::vector<uint32_t> tip_counts() const;
    bool tip_counts(Span<uint32_t> counts) const;
    std::tuple<std::vector<uint32_t>, std::vector<uint32_t>> children() const;
    bool children(Span<uint32_t> starts, Span<uint32_t> nodes) const;
    bool write_swc(std::string_view path, Ref<tree_swc_options> options = nullptr) const;
    Bytes to_swc(Ref<tree_swc_options> options = nullptr) const;
    Tree sketch_grow_crown(Maybe<tree_crown> crown, Ref<tree_sketch_finish_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_sketch_finish_report *report = nullptr) const;
};

class SketchBranches : public detail::Object<tree_sketch_branches, tree_sketch_branches_free> {
public:
    using Object::Object;
    static SketchBranches from_columns(Ref<tree_sketch_branches_columns> columns, Ref<tree_control> control = nullptr);
    SketchBranchesColumns view() const &;
    SketchBranchesColumns view() const && = delete;
    std::vector<uint32_t> orders() const;
    bool orders(Span<uint32_t> orders) const;
    Skeleton wood(Ref<tree_sketch_finish_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    SketchOmega sketch_omega_fit() const;
    std::tuple<std::vector<tree_sketch_relation>, size_t> relations() const;
    size_t relations(Span<tree_sketch_relation> relations) const;
    SketchBranches propagate(Ref<tree_sketch_omega> omega, Maybe<tree_crown> crown, Maybe<tree_volume> obstacles, Ref<tree_sketch_propagate_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_sketch_propagate_report *report = nullptr) const;
};

class SketchSession : public detail::Object<tree_sketch_session, tree_sketch_session_free> {
public:
    using Object::Object;
    static SketchSession make(const Drawing &drawing, Ref<tree_sketch_params> params, uint64_t seed);
    SketchSession copy() const;
    bool set_seed(uint64_t seed) const;
    bool set_params(Ref<tree_sketch_params> params = nullptr) const;
    bool set_templates(Maybe<tree_templates> templates = nullptr) const;
    bool set_obstacles(Maybe<tree_volume> obstacles = nullptr) const;
    bool infer_anew() const;
    bool redo_from(tree_sketch_stage stage) const;
    size_t add_stroke(Ref<tree_sketch_stroke> stroke = nullptr, Ref<tree_control> control = nullptr) const;
    size_t erase_stroke(size_t stroke, Ref<tree_control> control, Span<uint32_t> gone) const;
    bool set_depth(size_t stroke, const Floats<2> &at, float depth, Ref<tree_control> control = nullptr) const;
    Drawing drawing() const;
    uint64_t seed() const;
    SketchParams get_params() const &;
    SketchParams get_params() const && = delete;
    uint32_t runs(tree_sketch_stage stage) const;
    Plan plan(Ref<tree_control> control = nullptr) const;
    Crown crown(Ref<tree_control> control = nullptr) const;
    size_t choices(Ref<tree_control> control, Span<tree_template_choice> choices) const;
    Templates template_taken(Ref<tree_control> control = nullptr) const;
    Inferred inferred(Ref<tree_control> control = nullptr) const;
    SketchBranches branches(Ref<tree_control> control = nullptr, tree_sketch_propagate_report *report = nullptr) const;
    Skeleton wood(Ref<tree_control> control = nullptr) const;
    Tree tree(Ref<tree_control> control = nullptr, tree_sketch_report *report = nullptr) const;
    Lines warnings(Ref<tree_control> control = nullptr) const;
};

class Stand : public detail::Object<tree_stand, tree_stand_free> {
public:
    using Object::Object;
    static Stand of_drawing(const OutlineDrawing &drawing, Ref<tree_stand_params> params, uint64_t seed, Ref<tree_control> control = nullptr);
    StandWhole view() const;
    Lines notes() const;
    StandTree at(size_t index) const &;
    StandTree at(size_t index) const && = delete;
    std::tuple<SilhouetteGrown, Tree> grown(size_t index) const;
    SilhouetteSession silhouette(size_t index, tree_silhouette_play_report *report = nullptr) const;
};

class StreamReader : public detail::Object<tree_stream_reader, tree_stream_reader_free> {
public:
    using Object::Object;
    static StreamReader make(Ref<tree_control> control = nullptr);
    StreamReport push(Span<const uint8_t> data) const;
    StreamReport received() const;
    Multires multires(Ref<tree_control> control = nullptr) const;
};

class Strokes : public detail::Object<tree_strokes, tree_strokes_free> {
public:
    using Object::Object;
    static Strokes from_svg(std::string_view svg, float width, float height, Ref<tree_control> control = nullptr);
    StrokesColumns view() const &;
    StrokesColumns view() const && = delete;
    static Strokes outline(Span<const float> spots, Ref<tree_sketch_outline_params> params = nullptr, Ref<tree_control> control = nullptr);
};

class Swc : public detail::Object<tree_swc, tree_swc_free> {
public:
    using Object::Object;
    static Swc read(std::string_view path, Ref<tree_swc_options> options = nullptr, Ref<tree_control> control = nullptr);
    static Swc from_text(std::string_view text, Ref<tree_swc_options> options = nullptr, Ref<tree_control> control = nullptr);
    Skeleton skeleton() const;
    SwcContents view() const &;
    SwcContents view() const && = delete;
};

class Templates : public detail::Object<tree_templates, tree_templates_free> {
public:
    using Object::Object;
    SketchOmega omega(size_t index) const;
    std::vector<tree_template_choice> select(const Plan &plan, Maybe<tree_crown> crown = nullptr, Ref<tree_template_select_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    bool select(const Plan &plan, Maybe<tree_crown> crown, Ref<tree_template_select_params> params, Ref<tree_control> control, Span<tree_template_choice> choices) const;
    static Templates builtin();
    static Templates from_text(std::string_view text, Ref<tree_control> control = nullptr);
    Bytes to_text() const;
    static Templates of_tree(std::string_view name, std::string_view species, const Tree &tree, Ref<tree_template_params> params = nullptr, Ref<tree_control> control = nullptr);
    Templates join(const Templates &others) const;
    size_t count() const;
    size_t find(std::string_view name) const;
    TemplateView view(size_t index) const &;
    TemplateView view(size_t index) const && = delete;
    TemplateSide side(size_t index, size_t number) const &;
    TemplateSide side(size_t index, size_t number) const && = delete;
};

class Texture : public detail::Object<tree_texture, tree_texture_free> {
public:
    using Object::Object;
    static Texture bark_with(Ref<tree_bark_style> style, uint32_t size, Ref<tree_control> control = nullptr);
    static std::tuple<LeafCard, Texture> leaf_with(Ref<tree_leaf_shape> shape, uint32_t size, Ref<tree_control> control = nullptr);
    static Texture from_pixels(Ref<tree_texture_pixels> pixels, Ref<tree_control> control = nullptr);
    static Texture from_bytes(std::string_view name, Span<const uint8_t> data, Ref<tree_control> control = nullptr);
    static Texture read(std::string_view path, Ref<tree_control> control = nullptr);
    static Texture bark(std::string_view name, uint32_t size, Ref<tree_control> control = nullptr);
    static std::tuple<LeafCard, Texture> leaf(std::string_view name, uint32_t size, Ref<tree_control> control = nullptr);
    TexturePixels view() const &;
    TexturePixels view() const && = delete;
    Bytes to_png() const;
    bool write_png(std::string_view path) const;
};

class Tiers : public detail::Object<tree_tiers, tree_tiers_free> {
public:
    using Object::Object;
    static Tiers of_mesh(const Mesh &mesh, const Elements &elements, Ref<tree_tiers_params> params = nullptr, Ref<tree_control> control = nullptr);
    static Tiers full(const Mesh &mesh, const Elements &elements);
    static Tiers from_columns(const Mesh &mesh, const Elements &elements, Span<const tree_tier_columns> columns, Ref<tree_control> control = nullptr);
    size_t count() const;
    TierColumns view(size_t tier) const &;
    TierColumns view(size_t tier) const && = delete;
};

class Traces : public detail::Object<tree_traces, tree_traces_free> {
public:
    using Object::Object;
    Skeleton grow_wood(float height, float trunk_radius, Ref<tree_finish_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    static Traces flow(const Way &way, Span<const tree_flow_view> views, Span<const float> starts, float height, Ref<tree_flow_params> params = nullptr, Ref<tree_control> control = nullptr, tree_flow_report *report = nullptr);
    TracesColumns view() const &;
    TracesColumns view() const && = delete;
    Skeleton skeleton(Ref<tree_control> control = nullptr) const;
};

class Tree : public detail::Object<tree_tree, tree_tree_free> {
public:
    using Object::Object;
    Tree grow_leaves(Ref<tree_leaf_params> params, const Field &density, bool with_stalks, uint64_t seed, Ref<tree_control> control = nullptr, tree_leaf_report *report = nullptr) const;
    Tree grow_twigs(Ref<tree_twig_params> params, const Field &density, uint64_t seed, Ref<tree_control> control = nullptr, tree_twig_report *report = nullptr) const;
    std::vector<uint32_t> leaf_bearers_of_tree(const Mesh &mesh, const Elements &elements) const;
    bool leaf_bearers_of_tree(const Mesh &mesh, const Elements &elements, Span<uint32_t> bearers) const;
    Word to_word(Ref<tree_chain_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    static Tree make(const Skeleton &skeleton, Ref<tree_foliage> foliage = nullptr, Ref<tree_species> species = nullptr, Ref<tree_control> control = nullptr);
    Skeleton skeleton() const;
    Foliage foliage() const &;
    Foliage foliage() const && = delete;
    Species species() const &;
    Species species() const && = delete;
};

class Trimap : public detail::Object<tree_trimap, tree_trimap_free> {
public:
    using Object::Object;
    static Trimap from_levels(uint32_t width, uint32_t height, Span<const uint8_t> levels, Ref<tree_control> control = nullptr);
    static Trimap of_photo(const Photo &photo);
    static Trimap from_strokes(uint32_t width, uint32_t height, Span<const tree_trimap_stroke> strokes, Ref<tree_control> control = nullptr);
    static Trimap from_colors(const Photo &photo, Ref<tree_color_samples> samples, Ref<tree_control> control = nullptr);
    TrimapColumns view() const &;
    TrimapColumns view() const && = delete;
};

class TurtleTrace : public detail::Object<tree_turtle_trace, tree_turtle_trace_free> {
public:
    using Object::Object;
    TurtlePolygons view() const &;
    TurtlePolygons view() const && = delete;
    std::tuple<std::string_view, size_t> skipped(size_t index) const &;
    std::tuple<std::string_view, size_t> skipped(size_t index) const && = delete;
    Lines warnings() const;
};

class Twigs : public detail::Object<tree_twigs, tree_twigs_free> {
public:
    using Object::Object;
    static Twigs build(const Tree &tree, Maybe<tree_look> look, Ref<tree_mesh_params> mesh_params, Ref<tree_instancing_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_instancing_report *report = nullptr);
    size_t count() const;
    InstancingReport measure() const;
    Mesh base() const;
    Mesh mesh(size_t number) const;
    TwigInstances instances(size_t number) const &;
    TwigInstances instances(size_t number) const && = delete;
    static Twigs from_parts(const Mesh &base, const Handles<tree_mesh> &meshes, Span<const tree_twig_instances> instances, Ref<tree_control> control = nullptr);
    Mesh flatten(Ref<tree_control> control = nullptr) const;
};

class Unpacked : public detail::Object<tree_unpacked, tree_unpacked_free> {
public:
    using Object::Object;
    UnpackedColumns view() const &;
    UnpackedColumns view() const && = delete;
};

class Volume : public detail::Object<tree_volume, tree_volume_free> {
public:
    using Object::Object;
    GraphNodes graph_strew(Ref<tree_strew_params> params, uint64_t seed, Ref<tree_control> control = nullptr) const;
    static Volume from_svg(std::string_view svg, Ref<tree_profile_options> options, const Floats<3> &base, Ref<tree_control> control = nullptr);
    bool obstacle_is_free(float clearance, const Floats<3> &a, const Floats<3> &b) const;
    static Volume union_(const Handles<tree_volume> &volumes);
    static Volume intersection(const Handles<tree_volume> &volumes);
    Volume difference(const Volume &without) const;
    Volume transformed(const Floats<12> &columns) const;
    std::vector<uint8_t> contains(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool contains(Span<const float> points, Ref<tree_control> control, Span<uint8_t> inside) const;
    std::vector<float> distance(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool distance(Span<const float> points, Ref<tree_control> control, Span<float> distances) const;
    bool distance_is_exact() const;
    std::array<float, 6> bounds() const;
    bool is_bounded() const;
    float measure() const;
    float estimate_measure(uint32_t n_samples, Ref<tree_control> control = nullptr) const;
    std::vector<float> sample(size_t n_points, uint32_t attempts, uint64_t seed, Ref<tree_control> control = nullptr) const;
    bool sample(size_t n_points, uint32_t attempts, uint64_t seed, Ref<tree_control> control, Span<float> points) const;
    static Volume sphere(const Floats<3> &center, float radius);
    static Volume ellipsoid(const Floats<3> &center, const Floats<3> &radii);
    static Volume cylinder(const Floats<3> &base, const Floats<3> &top, float radius);
    static Volume frustum(const Floats<3> &base, const Floats<3> &top, float base_radius, float top_radius);
    static Volume cone(const Floats<3> &base, const Floats<3> &apex, float base_radius);
    static Volume capsule(const Floats<3> &start, const Floats<3> &end, float radius);
    static Volume box(const Floats<3> &min, const Floats<3> &max);
    static Volume half_space(const Floats<3> &point, const Floats<3> &normal);
    static Volume sector(const Floats<3> &apex, const Floats<3> &axis, float angle, float radius);
    static Volume revolution(const Floats<3> &base, const Floats<3> &axis, Span<const float> profile, Ref<tree_control> control = nullptr);
    static Volume closed_mesh(Span<const float> positions, Span<const uint32_t> indices, Ref<tree_control> control = nullptr);
    Solid view() const &;
    Solid view() const && = delete;
    Volume part(size_t index) const;
};

class Way : public detail::Object<tree_way, tree_way_free> {
public:
    using Object::Object;
    static Way make(const Grid &density, Ref<tree_flow_params> params = nullptr, Ref<tree_control> control = nullptr);
    Grid costs() const;
    std::vector<float> sample(Span<const float> points, Ref<tree_control> control = nullptr) const;
    bool sample(Span<const float> points, Ref<tree_control> control, Span<float> directions) const;
    std::vector<float> directions(Span<const tree_flow_view> views, Span<const float> points, Ref<tree_flow_params> params = nullptr, Ref<tree_control> control = nullptr) const;
    bool directions(Span<const tree_flow_view> views, Span<const float> points, Ref<tree_flow_params> params, Ref<tree_control> control, Span<float> directions) const;
};

class WindBranches : public detail::Object<tree_wind_branches, tree_wind_branches_free> {
public:
    using Object::Object;
    Span<const tree_wind_branch> view() const &;
    Span<const tree_wind_branch> view() const && = delete;
};

class Word : public detail::Object<tree_word, tree_word_free> {
public:
    using Object::Object;
    std::tuple<std::string_view, size_t> kind(uint16_t kind) const &;
    std::tuple<std::string_view, size_t> kind(uint16_t kind) const && = delete;
    uint16_t find_kind(std::string_view name, size_t n_params) const;
    std::tuple<TurtleTrace, Tree> interpret(Ref<tree_turtle_params> turtle = nullptr, Ref<tree_control> control = nullptr, tree_turtle_report *report = nullptr) const;
    std::tuple<std::vector<float>, size_t> lines(Ref<tree_turtle_params> turtle = nullptr, Ref<tree_control> control = nullptr) const;
    size_t lines(Ref<tree_turtle_params> turtle, Ref<tree_control> control, Span<float> lines) const;
    static Word from_text(std::string_view text, Ref<tree_control> control = nullptr, tree_grammar_report *report = nullptr);
    WordColumns view() const &;
    WordColumns view() const && = delete;
    WordHistory past() const &;
    WordHistory past() const && = delete;
    Bytes to_text() const;
    bool check() const;
};

std::array<float, 2> murray_angles(float r0, float r1, float r2);
std::array<float, 2> pipe_angles(float exponent, float r1, float r2);
std::array<float, 2> strand_angles(uint64_t s1, uint64_t s2, float sum);
std::string_view status_name(tree_status status);
bool capsule_contains(const tree_capsule &capsule, const Floats<3> &point);
double capsule_volume(const tree_capsule &capsule);
ConventionTraits convention_view(tree_convention convention);
std::vector<float> convert_positions(tree_convention convention, tree_convert way, Span<const float> from);
bool convert_positions(tree_convention convention, tree_convert way, Span<const float> from, Span<float> to);
std::vector<float> convert_directions(tree_convention convention, tree_convert way, Span<const float> from);
bool convert_directions(tree_convention convention, tree_convert way, Span<const float> from, Span<float> to);
std::vector<float> convert_tangents(tree_convention convention, tree_convert way, Span<const float> from);
bool convert_tangents(tree_convention convention, tree_convert way, Span<const float> from, Span<float> to);
std::vector<float> convert_uvs(tree_convention convention, Span<const float> from);
bool convert_uvs(tree_convention convention, Span<const float> from, Span<float> to);
std::vector<uint32_t> convert_triangles(tree_convention convention, Span<const uint32_t> from);
bool convert_triangles(tree_convention convention, Span<const uint32_t> from, Span<uint32_t> to);
float wind_sway(float reach);
float wind_leaf_phase(uint32_t leaf);
size_t foliage_preset_count();
std::string_view foliage_preset_name(size_t index);
std::tuple<LeafParams, TwigParams, std::string_view> foliage_preset(std::string_view name);
std::array<float, 6> card_weights(const Floats<3> &half, const Floats<3> &direction);
std::array<float, 2> card_interval(const Floats<6> &weights, uint32_t plane);
float card_noise(const Floats<2> &pixel);
bool gltf_write_glb(Span<const tree_gltf_level> levels, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr);
Bytes gltf_to_glb(Span<const tree_gltf_level> levels, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr);
bool gltf_write_files(Span<const tree_gltf_level> levels, std::string_view path, Ref<tree_glb_options> options = nullptr, Ref<tree_control> control = nullptr);
std::string_view note_text(tree_note note);
tree_lod_distance lod_distance_cook();
tree_lod_distance lod_distance_from_samples(Span<const float> lambdas);
std::vector<float> lod_distance_places();
bool lod_distance_places(Span<float> places);
float lod_distance_lambda(const tree_lod_distance &distance, float d);
bool order_check(Span<const uint32_t> order, size_t n_elements);
std::string_view prune_shader(tree_shader language);
std::array<float, 3> prune_position(const Floats<3> &vertex, const Floats<4> &center_rank, float growth, float lambda, float fade);
std::array<float, 3> prune_color(const Floats<3> &rgb, const Floats<3> &mean, float contrast);
float lod_cook_scale(float lambda);
float lod_cook_lambda(float d);
float lod_size_lambda(float pixels, float full, float h);
float lod_drop_and_resize(uint32_t n, uint32_t k, float w);
float lod_contrast(float lambda, float scale);
std::tuple<double, double, double> score_quality(const tree_score &score);
double score_mean_quality(Span<const tree_score> scores);
bool lod_plan(Ref<tree_lod_subject> subject, Ref<tree_control> control, Span<uint32_t> kept);
BarkStyle bark_style_of(std::string_view name);
LeafShape leaf_shape_of(std::string_view name);
Span<const tree_str> bark_names();
Span<const tree_str> leaf_names();
size_t lsystem_preset_count();
LsystemPresetInfo lsystem_preset_view(size_t index);
std::tuple<std::string_view, double> lsystem_preset_constant(size_t index, size_t constant);
std::tuple<TurtleParams, Grammar> lsystem_preset(std::string_view name);
TurtleParams chain_turtle();
uint64_t memory_used();
uint64_t memory_peak();
void memory_reset_peak();
void memory_set_budget(uint64_t bytes);
uint64_t memory_budget();
bool memory_set_allocator(Ref<tree_allocator> allocator = nullptr);
FinishParams finish_params_find(std::string_view name);
FinishParams finish_params_of(std::string_view name);
Tree from_photos(Span<const tree_photo_shot> shots, Ref<tree_photo_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_photo_report *report = nullptr);
Tree path_grow(Ref<tree_path_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_path_report *report = nullptr);
std::tuple<Bytes, Tree> path_grow_with_levels(Ref<tree_path_params> params, uint64_t seed, Ref<tree_control> control = nullptr, tree_path_report *report = nullptr);
float path_level_radius(Ref<tree_path_params> params, size_t index);
size_t path_preset_count();
std::tuple<std::string_view, std::string_view> path_preset_name(size_t index);
float path_preset_paper_seconds(size_t index);
PathParams path_preset(std::string_view name);
Lines align_warnings_text(Span<const tree_align_warning> warnings);
Aligned align_all(const Handles<tree_matte> &mattes, Span<const tree_align_params> params, float height, Ref<tree_control> control = nullptr);
Concentration sites_privileged(Span<const tree_site> sites, const tree_arrangement &arrangement, Ref<tree_control> control = nullptr);
std::tuple<size_t, float> branch_infer(Span<const float> parent, Maybe<tree_outline> outline, Ref<tree_branching_angles> angles, const Floats<2> &end, const Floats<2> &tangent, float from, float to, Ref<tree_branch_infer_params> params, Ref<tree_control> control, Span<float> points);
std::tuple<float, float, bool> branch_base(Span<const float> parent, Span<const float> branch, Ref<tree_control> control = nullptr);
std::tuple<std::vector<float>, size_t, Outline> branch_carry(Span<const float> branch, bool left, const Outline &outline, const tree_branch_span &span, Ref<tree_control> control = nullptr, tree_branch_shape_report *report = nullptr);
std::tuple<size_t, Outline> branch_carry(Span<const float> branch, bool left, const Outline &outline, const tree_branch_span &span, Ref<tree_control> control, tree_branch_shape_report *report, Span<float> points);
float line_length(Span<const float> line, Ref<tree_control> control = nullptr);
std::tuple<std::vector<float>, std::vector<float>> line_at(Span<const float> line, Span<const float> places, Ref<tree_control> control = nullptr);
bool line_at(Span<const float> line, Span<const float> places, Ref<tree_control> control, Span<float> points, Span<float> tangents);
std::tuple<std::vector<float>, std::vector<float>> line_nearest(Span<const float> line, Span<const float> spots, Ref<tree_control> control = nullptr);
bool line_nearest(Span<const float> line, Span<const float> spots, Ref<tree_control> control, Span<float> shares, Span<float> distances);
size_t line_part(Span<const float> line, float from, float to, uint32_t count, Ref<tree_control> control, Span<float> points);
tree_arrangement arrangement_from_text(std::string_view text);
Bytes arrangement_to_text(const tree_arrangement &arrangement);
ArrangementNumbers arrangement_measure(const tree_arrangement &arrangement);
tree_domain domain_drawn(float along, bool left);
bool domain_contains(const tree_domain &domain, float along, float azimuth);
float domain_outside(const tree_domain &domain, float azimuth);
Scanned skeletonize_scan(Span<const double> points, Ref<tree_scan_params> params = nullptr, Ref<tree_control> control = nullptr, tree_scan_report *report = nullptr);
Tree skeletonize(Span<const tree_mesh_part> parts, Ref<tree_skeletonize_params> params = nullptr, Ref<tree_control> control = nullptr, tree_skeletonize_report *report = nullptr);
size_t exemplar_count();
std::tuple<std::string_view, std::string_view, std::string_view> exemplar_name(size_t index);
Tree exemplar_grow(std::string_view name, uint64_t seed, Ref<tree_control> control = nullptr);
std::vector<float> footprint_of(Span<const float> spots, Ref<tree_control> control = nullptr);
bool footprint_of(Span<const float> spots, Ref<tree_control> control, Span<float> distances);
float footprint_difference(Span<const float> first, Span<const float> second);
std::tuple<std::vector<float>, size_t> convex_hull(Span<const float> spots, Ref<tree_control> control = nullptr);
size_t convex_hull(Span<const float> spots, Ref<tree_control> control, Span<float> corners);
SketchOmega sketch_omega_of_relations(Span<const tree_sketch_relation> relations, Ref<tree_control> control = nullptr);
uint32_t abi_version();
std::string_view version();
size_t live_objects();

namespace detail {

inline void rethrow(const tree_link_params *params) {
    if (!params) return;
    if (params->cost == Field::call) static_cast<Field *>(params->cost_user)->rethrow();
}
inline void rethrow(const tree_path_params *params) {
    if (!params) return;
    if (params->cost == Field::call) static_cast<Field *>(params->cost_user)->rethrow();
    rethrow(params->roots);
}

// What every call ends with: whether it went well.
template <class... With>
bool done(tree_status code, const With &...with) {
    (rethrow(with), ...);
    return tree::check(code);
}

} // namespace detail

inline std::array<float, 2> murray_angles(float r0, float r1, float r2) {
    std::array<float, 2> angles{};
    detail::done(tree_murray_angles(r0, r1, r2, reinterpret_cast<float(*)[2]>(angles.data())));
    return angles;
}
inline std::array<float, 2> pipe_angles(float exponent, float r1, float r2) {
    std::array<float, 2> angles{};
    detail::done(tree_pipe_angles(exponent, r1, r2, reinterpret_cast<float(*)[2]>(angles.data())));
    return angles;
}
inline std::array<float, 2> strand_angles(uint64_t s1, uint64_t s2, float sum) {
    std::array<float, 2> angles{};
    detail::done(tree_strand_angles(s1, s2, sum, reinterpret_cast<float(*)[2]>(angles.data())));
    return angles;
}
inline std::vector<float> Skeleton::radii(Ref<tree_radius_rule> rule) const {
    std::vector<float> radii(view().n_nodes);
    if (!(detail::done(tree_skeleton_radii(get(), rule, radii.data(), radii.size())))) { radii.clear(); }
    return radii;
}
inline bool Skeleton::radii(Ref<tree_radius_rule> rule, Span<float> radii) const {
    return detail::done(tree_skeleton_radii(get(), rule, radii.data(), radii.size()));
}
inline Skeleton Skeleton::with_rule(Ref<tree_radius_rule> rule) const {
    Skeleton changed;
    detail::done(tree_skeleton_with_rule(get(), rule, changed.place()));
    return changed;
}
inline std::vector<float> Skeleton::radii_at_levels(Span<const uint32_t> levels, Ref<tree_radius_rule> rule) const {
    std::vector<float> radii(view().n_nodes);
    if (!(detail::done(tree_skeleton_radii_at_levels(get(), levels.data(), levels.size(), rule, radii.data(), radii.size())))) { radii.clear(); }
    return radii;
}
inline bool Skeleton::radii_at_levels(Span<const uint32_t> levels, Ref<tree_radius_rule> rule, Span<float> radii) const {
    return detail::done(tree_skeleton_radii_at_levels(get(), levels.data(), levels.size(), rule, radii.data(), radii.size()));
}
inline std::vector<uint64_t> Skeleton::strands(Ref<tree_radius_rule> rule) const {
    std::vector<uint64_t> strands(view().n_nodes);
    if (!(detail::done(tree_skeleton_strands(get(), rule, strands.data(), strands.size())))) { strands.clear(); }
    return strands;
}
inline bool Skeleton::strands(Ref<tree_radius_rule> rule, Span<uint64_t> strands) const {
    return detail::done(tree_skeleton_strands(get(), rule, strands.data(), strands.size()));
}
inline bool RadiusRule::check() const {
    return detail::done(tree_radius_rule_check(this));
}
inline std::string_view status_name(tree_status status) {
    return tree_status_name(status);
}
inline Limits Limits::for_memory(uint64_t bytes) {
    Limits limits;
    if (!(detail::done(tree_limits_for_memory(&limits, sizeof(tree_limits), bytes)))) { limits.struct_size = 0; }
    return limits;
}
inline Cancel Cancel::make() {
    Cancel cancel;
    detail::done(tree_cancel_new(cancel.place()));
    return cancel;
}
inline bool Cancel::set() const {
    return detail::done(tree_cancel_set(get()));
}
inline Span<const tree_edit_pair> EditPairs::view() const & {
    const tree_edit_pair *rows = nullptr;
    size_t n_pairs = 0;
    detail::done(tree_edit_pairs_view(get(), &rows, &n_pairs));
    return Span<const tree_edit_pair>(rows, n_pairs);
}
inline EditDistance Skeleton::distance(const Skeleton &second, Ref<tree_edit_params> params, Ref<tree_control> control) const {
    EditDistance distance;
    if (!(detail::done(tree_skeleton_distance(get(), second.get(), params, control, &distance), control))) { distance.struct_size = 0; }
    return distance;
}
inline std::tuple<EditDistance, EditPairs> Skeleton::distance_pairs(const Skeleton &second, Ref<tree_edit_params> params, Ref<tree_control> control) const {
    EditDistance distance;
    EditPairs pairs;
    if (!(detail::done(tree_skeleton_distance_pairs(get(), second.get(), params, control, &distance, pairs.place()), control))) { distance.struct_size = 0; }
    return {std::move(distance), std::move(pairs)};
}
inline EditDistance EditTree::distance(const EditTree &second, Ref<tree_edit_costs> costs, Ref<tree_control> control) const {
    EditDistance distance;
    if (!(detail::done(tree_edit_tree_distance(get(), second.get(), costs, control, &distance), control))) { distance.struct_size = 0; }
    return distance;
}
inline std::tuple<EditDistance, EditPairs> EditTree::distance_pairs(const EditTree &second, Ref<tree_edit_costs> costs, Ref<tree_control> control) const {
    EditDistance distance;
    EditPairs pairs;
    if (!(detail::done(tree_edit_tree_distance_pairs(get(), second.get(), costs, control, &distance, pairs.place()), control))) { distance.struct_size = 0; }
    return {std::move(distance), std::move(pairs)};
}
inline EditTree EditTree::of_skeleton(const Skeleton &skeleton, Ref<tree_edit_params> params) {
    EditTree tree;
    detail::done(tree_edit_tree_of_skeleton(skeleton.get(), params, tree.place()));
    return tree;
}
inline EditTree EditTree::from_columns(Ref<tree_edit_columns> columns, Ref<tree_control> control) {
    EditTree tree;
    detail::done(tree_edit_tree_from_columns(columns, control, tree.place()), control);
    return tree;
}
inline EditColumns EditTree::view() const & {
    EditColumns columns;
    if (!(detail::done(tree_edit_tree_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline BranchMotion Mesh::branch_motion(size_t branch) const {
    BranchMotion motion;
    if (!(detail::done(tree_mesh_branch_motion(get(), branch, &motion)))) { motion.struct_size = 0; }
    return motion;
}
inline float Mesh::branch_reach(size_t branch, const Floats<3> &point) const {
    float reach{};
    detail::done(tree_mesh_branch_reach(get(), branch, point, &reach));
    return reach;
}
inline WindBranches Skeleton::wind_branches(tree_continuation continuation) const {
    WindBranches branches;
    detail::done(tree_skeleton_wind_branches(get(), continuation, branches.place()));
    return branches;
}
inline Span<const tree_wind_branch> WindBranches::view() const & {
    const tree_wind_branch *rows = nullptr;
    size_t n = 0;
    detail::done(tree_wind_branches_view(get(), &rows, &n));
    return Span<const tree_wind_branch>(rows, n);
}
inline Capsules Skeleton::capsules(Ref<tree_capsule_params> params, Ref<tree_control> control, tree_capsule_report *report) const {
    Capsules capsules;
    detail::done(tree_skeleton_capsules(get(), params, control, report, capsules.place()), control);
    return capsules;
}
inline Span<const tree_capsule> Capsules::view() const & {
    const tree_capsule *rows = nullptr;
    size_t n = 0;
    detail::done(tree_capsules_view(get(), &rows, &n));
    return Span<const tree_capsule>(rows, n);
}
inline bool capsule_contains(const tree_capsule &capsule, const Floats<3> &point) {
    uint32_t inside = 0;
    detail::done(tree_capsule_contains(&capsule, point, &inside));
    return inside != 0;
}
inline double capsule_volume(const tree_capsule &capsule) {
    double volume{};
    detail::done(tree_capsule_volume(&capsule, &volume));
    return volume;
}
inline ConventionTraits convention_view(tree_convention convention) {
    ConventionTraits traits;
    if (!(detail::done(tree_convention_view(convention, &traits)))) { traits.struct_size = 0; }
    return traits;
}
inline std::vector<float> convert_positions(tree_convention convention, tree_convert way, Span<const float> from) {
    std::vector<float> to(from.size());
    if (!(detail::expect(from.size() % 3 == 0, TREE_ERROR_BUFFER, "from: must have 3 numbers for each item")
        && detail::done(tree_convert_positions(convention, way, from.data(), from.size() / 3, to.data())))) { to.clear(); }
    return to;
}
inline bool convert_positions(tree_convention convention, tree_convert way, Span<const float> from, Span<float> to) {
    return detail::expect(from.size() % 3 == 0, TREE_ERROR_BUFFER, "from: must have 3 numbers for each item")
        && detail::expect((!to.data() || to.size() >= (from.size())), TREE_ERROR_BUFFER, "to: not room enough")
        && detail::done(tree_convert_positions(convention, way, from.data(), from.size() / 3, to.data()));
}
inline std::vector<float> convert_directions(tree_convention convention, tree_convert way, Span<const float> from) {
    std::vector<float> to(from.size());
    if (!(detail::expect(from.size() % 3 == 0, TREE_ERROR_BUFFER, "from: must have 3 numbers for each item")
        && detail::done(tree_convert_directions(convention, way, from.data(), from.size() / 3, to.data())))) { to.clear(); }
    return to;
}
inline bool convert_directions(tree_convention convention, tree_convert way, Span<const float> from, Span<float> to) {
    return detail::expect(from.size() % 3 == 0, TREE_ERROR_BUFFER, "from: must have 3 numbers for each item")
        && detail::expect((!to.data() || to.size() >= (from.size())), TREE_ERROR_BUFFER, "to: not room enough")
        && detail::done(tree_convert_directions(convention, way, from.data(), from.size() / 3, to.data()));
}
inline std::vector<float> convert_tangents(tree_convention convention, tree_convert way, Span<const float> from) {
    std::vector<float> to(from.size());
    if (!(detail::expect(from.size() % 4 == 0, TREE_ERROR_BUFFER, "from: must have 4 numbers for each item")
        && detail::done(tree_convert_tangents(convention, way, from.data(), from.size() / 4, to.data())))) { to.clear(); }
    return to;
}
inline bool convert_tangents(tree_convention convention, tree_convert way, Span<const float> from, Span<float> to) {
    return detail::expect(from.size() % 4 == 0, TREE_ERROR_BUFFER, "from: must have 4 numbers for each item")
        && detail::expect((!to.data() || to.size() >= (from.size())), TREE_ERROR_BUFFER, "to: not room enough")
        && detail::done(tree_convert_tangents(convention, way, from.data(), from.size() / 4, to.data()));
}
inline std::vector<float> convert_uvs(tree_convention convention, Span<const float> from) {
    std::vector<float> to(from.size());
    if (!(detail::expect(from.size() % 2 == 0, TREE_ERROR_BUFFER, "from: must have 2 numbers for each item")
        && detail::done(tree_convert_uvs(convention, from.data(), from.size() / 2, to.data())))) { to.clear(); }
    return to;
}
inline bool convert_uvs(tree_convention convention, Span<const float> from, Span<float> to) {
    return detail::expect(from.size() % 2 == 0, TREE_ERROR_BUFFER, "from: must have 2 numbers for each item")
        && detail::expect((!to.data() || to.size() >= (from.size())), TREE_ERROR_BUFFER, "to: not room enough")
        && detail::done(tree_convert_uvs(convention, from.data(), from.size() / 2, to.data()));
}
inline std::vector<uint32_t> convert_triangles(tree_convention convention, Span<const uint32_t> from) {
    std::vector<uint32_t> to(from.size());
    if (!(detail::expect(from.size() % 3 == 0, TREE_ERROR_BUFFER, "from: must have 3 numbers for each item")
        && detail::done(tree_convert_triangles(convention, from.data(), from.size() / 3, to.data())))) { to.clear(); }
    return to;
}
inline bool convert_triangles(tree_convention convention, Span<const uint32_t> from, Span<uint32_t> to) {
    return detail::expect(from.size() % 3 == 0, TREE_ERROR_BUFFER, "from: must have 3 numbers for each item")
        && detail::expect((!to.data() || to.size() >= (from.size())), TREE_ERROR_BUFFER, "to: not room enough")
        && detail::done(tree_convert_triangles(convention, from.data(), from.size() / 3, to.data()));
}
inline Packed Mesh::pack(size_t surface, tree_layout layout, Ref<tree_control> control) const {
    Packed packed;
    detail::done(tree_mesh_pack(get(), surface, layout, control, packed.place()), control);
    return packed;
}
inline PackedColumns Packed::view() const & {
    PackedColumns columns;
    if (!(detail::done(tree_packed_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Pivots Packed::pivots() const & {
    Pivots pivots;
    if (!(detail::done(tree_packed_pivots(get(), &pivots)))) { pivots.struct_size = 0; }
    return pivots;
}
inline PivotElement Packed::pivot_element(uint32_t number) const {
    PivotElement element;
    if (!(detail::done(tree_packed_pivot_element(get(), number, &element)))) { element.struct_size = 0; }
    return element;
}
inline Unpacked Packed::unpack(Maybe<tree_mesh> mesh) const {
    Unpacked unpacked;
    static_cast<void>(detail::expect(mesh.fits(), TREE_ERROR_NULL, "mesh: empty; leave it out, or hand over nullptr")
        && detail::done(tree_packed_unpack(get(), mesh, unpacked.place())));
    return unpacked;
}
inline UnpackedColumns Unpacked::view() const & {
    UnpackedColumns columns;
    if (!(detail::done(tree_unpacked_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline PackedVertices Packed::vertices_view() const & {
    PackedVertices vertices;
    if (!(detail::done(tree_packed_vertices_view(get(), &vertices)))) { vertices.struct_size = 0; }
    return vertices;
}
inline std::vector<tree_vertex_wind> Mesh::wind(size_t surface) const {
    std::vector<tree_vertex_wind> rows(this->surface(surface).n_vertices);
    if (!(detail::done(tree_mesh_wind(get(), surface, rows.data(), rows.size())))) { rows.clear(); }
    return rows;
}
inline bool Mesh::wind(size_t surface, Span<tree_vertex_wind> rows) const {
    return detail::done(tree_mesh_wind(get(), surface, rows.data(), rows.size()));
}
inline std::vector<float> Mesh::bend(Ref<tree_wind> wind, float seconds, size_t surface) const {
    std::vector<float> positions(3 * this->surface(surface).n_vertices);
    if (!(detail::done(tree_mesh_bend(get(), wind, seconds, surface, positions.data(), positions.size())))) { positions.clear(); }
    return positions;
}
inline bool Mesh::bend(Ref<tree_wind> wind, float seconds, size_t surface, Span<float> positions) const {
    return detail::done(tree_mesh_bend(get(), wind, seconds, surface, positions.data(), positions.size()));
}
inline float wind_sway(float reach) {
    float sway{};
    detail::done(tree_wind_sway(reach, &sway));
    return sway;
}
inline float wind_leaf_phase(uint32_t leaf) {
    float phase{};
    detail::done(tree_wind_leaf_phase(leaf, &phase));
    return phase;
}
inline Tree Tree::grow_leaves(Ref<tree_leaf_params> params, const Field &density, bool with_stalks, uint64_t seed, Ref<tree_control> control, tree_leaf_report *report) const {
    Tree grown;
    detail::done(tree_tree_grow_leaves(get(), params, density.function(), density.user(), with_stalks ? 1u : 0u, seed, control, report, grown.place()), density, control);
    return grown;
}
inline Tree Tree::grow_twigs(Ref<tree_twig_params> params, const Field &density, uint64_t seed, Ref<tree_control> control, tree_twig_report *report) const {
    Tree grown;
    detail::done(tree_tree_grow_twigs(get(), params, density.function(), density.user(), seed, control, report, grown.place()), density, control);
    return grown;
}
inline bool LeafParams::check(size_t n_kinds) const {
    return detail::done(tree_leaf_params_check(this, n_kinds));
}
inline size_t foliage_preset_count() {
    return tree_foliage_preset_count();
}
inline std::string_view foliage_preset_name(size_t index) {
    tree_str name{};
    detail::done(tree_foliage_preset_name(index, &name));
    return detail::text(name);
}
inline std::tuple<LeafParams, TwigParams, std::string_view> foliage_preset(std::string_view name) {
    LeafParams leaves;
    TwigParams twigs;
    tree_str leaf_kind{};
    if (!(detail::done(tree_foliage_preset(name.data() ? name.data() : "", name.size(), &leaves, &twigs, &leaf_kind)))) { leaves.struct_size = 0; twigs.struct_size = 0; }
    return {std::move(leaves), std::move(twigs), detail::text(leaf_kind)};
}
inline Span<const uint32_t> Rows::view() const & {
    const uint32_t *first = nullptr;
    size_t n = 0;
    detail::done(tree_rows_view(get(), &first, &n));
    return Span<const uint32_t>(first, n);
}
inline std::tuple<Rows, Skeleton> Skeleton::refine(float bearing, float spacing, Ref<tree_control> control) const {
    Rows rows;
    Skeleton refined;
    detail::done(tree_skeleton_refine(get(), bearing, spacing, control, rows.place(), refined.place()), control);
    return {std::move(rows), std::move(refined)};
}
inline bool TwigParams::check() const {
    return detail::done(tree_twig_params_check(this));
}
inline Grown Growth::grow(Ref<tree_growth_params> params, uint64_t seed, Ref<tree_control> control) {
    Grown grown;
    detail::done(tree_growth_grow(params, seed, control, grown.place()), control);
    return grown;
}
inline Tree Grown::tree() const {
    Tree tree;
    detail::done(tree_grown_tree(get(), tree.place()));
    return tree;
}
inline GrownColumns Grown::view() const & {
    GrownColumns columns;
    if (!(detail::done(tree_grown_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline bool GrowthParams::check() const {
    return detail::done(tree_growth_params_check(this));
}
inline size_t Growth::preset_count() {
    return tree_growth_preset_count();
}
inline std::string_view Growth::preset_name(size_t index) {
    tree_str name{};
    detail::done(tree_growth_preset_name(index, &name));
    return detail::text(name);
}
inline GrowthParams Growth::preset(std::string_view name) {
    GrowthParams params;
    if (!(detail::done(tree_growth_preset(name.data() ? name.data() : "", name.size(), &params, sizeof(tree_growth_params))))) { params.struct_size = 0; }
    return params;
}
inline Growth Growth::make(Ref<tree_growth_world> world, Span<const tree_growth_plant> plants, uint64_t seed, Ref<tree_control> control) {
    Growth growth;
    detail::done(tree_growth_new(world, plants.data(), plants.size(), seed, control, growth.place()), control);
    return growth;
}
inline Growth Growth::stand(Ref<tree_growth_world> world, Span<const tree_growth_plant> plants, uint32_t iterations, uint64_t seed, Ref<tree_control> control) {
    Growth growth;
    detail::done(tree_growth_stand(world, plants.data(), plants.size(), iterations, seed, control, growth.place()), control);
    return growth;
}
inline bool Growth::step(uint32_t iterations, Ref<tree_control> control) const {
    return detail::done(tree_growth_step(get(), iterations, control), control);
}
inline GrowthCounts Growth::measure() const {
    GrowthCounts counts;
    if (!(detail::done(tree_growth_measure(get(), &counts)))) { counts.struct_size = 0; }
    return counts;
}
inline std::vector<float> Growth::light(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> light(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_growth_light(get(), points.data(), points.size() / 3, control, light.data()), control))) { light.clear(); }
    return light;
}
inline bool Growth::light(Span<const float> points, Ref<tree_control> control, Span<float> light) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::expect((!light.data() || light.size() >= (points.size() / 3)), TREE_ERROR_BUFFER, "light: not room enough")
        && detail::done(tree_growth_light(get(), points.data(), points.size() / 3, control, light.data()), control);
}
inline Grown Growth::grown(size_t index, Ref<tree_control> control) const {
    Grown grown;
    detail::done(tree_growth_grown(get(), index, control, grown.place()), control);
    return grown;
}
inline Growth Growth::copy() const {
    Growth copy;
    detail::done(tree_growth_copy(get(), copy.place()));
    return copy;
}
inline HybridChoice HybridChoice::make(const Hybrid &hybrid) {
    HybridChoice choice;
    detail::done(tree_hybrid_choice_new(hybrid.get(), choice.place()));
    return choice;
}
inline HybridChoice HybridChoice::for_height(const Hybrid &hybrid, float pixels) {
    HybridChoice choice;
    detail::done(tree_hybrid_choice_for_height(hybrid.get(), pixels, choice.place()));
    return choice;
}
inline HybridChoiceReport HybridChoice::update(const Floats<3> &eye, float pixels_per_metre) const {
    HybridChoiceReport report;
    if (!(detail::done(tree_hybrid_choice_update(get(), eye, pixels_per_metre, &report)))) { report.struct_size = 0; }
    return report;
}
inline HybridChoiceReport HybridChoice::measure() const {
    HybridChoiceReport report;
    if (!(detail::done(tree_hybrid_choice_measure(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline bool HybridChoice::boxes(Span<uint32_t> boxes) const {
    return detail::done(tree_hybrid_choice_boxes(get(), boxes.data(), boxes.size()));
}
inline bool HybridChoice::ranges(Span<tree_leaf_range> ranges) const {
    return detail::done(tree_hybrid_choice_ranges(get(), ranges.data(), ranges.size()));
}
inline Mesh HybridChoice::mesh(Ref<tree_control> control) const {
    Mesh mesh;
    detail::done(tree_hybrid_choice_mesh(get(), control, mesh.place()), control);
    return mesh;
}
inline Bytes Hybrid::to_glb_levels(Span<const float> heights, float screen, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_hybrid_to_glb_levels(get(), heights.data(), heights.size(), screen, options, control, bytes.place()), control);
    return bytes;
}
inline bool Hybrid::write_glb_levels(Span<const float> heights, float screen, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    return detail::done(tree_hybrid_write_glb_levels(get(), heights.data(), heights.size(), screen, path.data() ? path.data() : "", path.size(), options, control), control);
}
inline Hybrid Hybrid::make(const Tree &tree, Maybe<tree_look> look, Ref<tree_hybrid_params> params, Ref<tree_control> control) {
    Hybrid hybrid;
    static_cast<void>(detail::expect(look.fits(), TREE_ERROR_NULL, "look: empty; leave it out, or hand over nullptr")
        && detail::done(tree_hybrid_make(tree.get(), look, params, control, hybrid.place()), control));
    return hybrid;
}
inline HybridTotals Hybrid::measure() const {
    HybridTotals totals;
    if (!(detail::done(tree_hybrid_measure(get(), &totals)))) { totals.struct_size = 0; }
    return totals;
}
inline Mesh Hybrid::mesh() const {
    Mesh mesh;
    detail::done(tree_hybrid_mesh(get(), mesh.place()));
    return mesh;
}
inline Multires Hybrid::multires() const {
    Multires multires;
    detail::done(tree_hybrid_multires(get(), multires.place()));
    return multires;
}
inline MultiMesh Hybrid::wood() const {
    MultiMesh wood;
    detail::done(tree_hybrid_wood(get(), wood.place()));
    return wood;
}
inline Cards Hybrid::cards() const {
    Cards cards;
    detail::done(tree_hybrid_cards(get(), cards.place()));
    return cards;
}
inline tree_index_window Hybrid::leaf_window(size_t number, uint32_t first_leaf, uint32_t n_leaves) const {
    tree_index_window window{};
    detail::done(tree_hybrid_leaf_window(get(), number, first_leaf, n_leaves, &window));
    return window;
}
inline float Hybrid::level(float pixels_per_metre) const {
    float level{};
    detail::done(tree_hybrid_level(get(), pixels_per_metre, &level));
    return level;
}
inline bool HybridParams::check() const {
    return detail::done(tree_hybrid_params_check(this));
}
inline std::vector<uint32_t> Tree::leaf_bearers_of_tree(const Mesh &mesh, const Elements &elements) const {
    std::vector<uint32_t> bearers(elements.view().n_elements);
    if (!(detail::done(tree_leaf_bearers_of_tree(get(), mesh.get(), elements.get(), bearers.data(), bearers.size())))) { bearers.clear(); }
    return bearers;
}
inline bool Tree::leaf_bearers_of_tree(const Mesh &mesh, const Elements &elements, Span<uint32_t> bearers) const {
    return detail::done(tree_leaf_bearers_of_tree(get(), mesh.get(), elements.get(), bearers.data(), bearers.size()));
}
inline std::vector<uint32_t> Skeleton::leaf_bearers_nearest(const Elements &elements, Ref<tree_control> control) const {
    std::vector<uint32_t> bearers(elements.view().n_elements);
    if (!(detail::done(tree_leaf_bearers_nearest(get(), elements.get(), control, bearers.data(), bearers.size()), control))) { bearers.clear(); }
    return bearers;
}
inline bool Skeleton::leaf_bearers_nearest(const Elements &elements, Ref<tree_control> control, Span<uint32_t> bearers) const {
    return detail::done(tree_leaf_bearers_nearest(get(), elements.get(), control, bearers.data(), bearers.size()), control);
}
inline bool LeafBoxParams::check() const {
    return detail::done(tree_leaf_box_params_check(this));
}
inline LeafBoxes LeafBoxes::along(const Skeleton &skeleton, const Mesh &mesh, const Elements &elements, Span<const uint32_t> bearers, Ref<tree_leaf_box_params> params, Ref<tree_control> control, tree_leaf_boxes_report *report) {
    LeafBoxes boxes;
    detail::done(tree_leaf_boxes_along(skeleton.get(), mesh.get(), elements.get(), bearers.data(), bearers.size(), params, control, report, boxes.place()), control);
    return boxes;
}
inline LeafBoxesReport LeafBoxes::measure() const {
    LeafBoxesReport report;
    if (!(detail::done(tree_leaf_boxes_measure(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline LeafBox LeafBoxes::get_(uint32_t number) const {
    LeafBox leaf_box;
    if (!(detail::done(tree_leaf_boxes_get(get(), number, &leaf_box)))) { leaf_box.struct_size = 0; }
    return leaf_box;
}
inline Span<const uint32_t> LeafBoxes::order() const & {
    const uint32_t *order = nullptr;
    size_t n_leaves = 0;
    detail::done(tree_leaf_boxes_order(get(), &order, &n_leaves));
    return Span<const uint32_t>(order, n_leaves);
}
inline float LeafBoxes::distance(uint32_t number, const Floats<3> &point) const {
    float metres{};
    detail::done(tree_leaf_boxes_distance(get(), number, point, &metres));
    return metres;
}
inline std::vector<tree_card_plane> LeafBoxes::planes(uint32_t number) const {
    std::vector<tree_card_plane> planes(6);
    if (!(detail::done(tree_leaf_boxes_planes(get(), number, planes.data(), planes.size())))) { planes.clear(); }
    return planes;
}
inline bool LeafBoxes::planes(uint32_t number, Span<tree_card_plane> planes) const {
    return detail::done(tree_leaf_boxes_planes(get(), number, planes.data(), planes.size()));
}
inline bool CardParams::check() const {
    return detail::done(tree_card_params_check(this));
}
inline Cards Cards::bake(const Mesh &mesh, const Elements &elements, const LeafBoxes &boxes, Ref<tree_card_params> params, Ref<tree_control> control, tree_cards_report *report) {
    Cards cards;
    detail::done(tree_cards_bake(mesh.get(), elements.get(), boxes.get(), params, control, report, cards.place()), control);
    return cards;
}
inline CardsReport Cards::measure() const {
    CardsReport report;
    if (!(detail::done(tree_cards_measure(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline LeafBoxes Cards::boxes() const {
    LeafBoxes boxes;
    detail::done(tree_cards_boxes(get(), boxes.place()));
    return boxes;
}
inline float Cards::texel(uint32_t number) const {
    float metres{};
    detail::done(tree_cards_texel(get(), number, &metres));
    return metres;
}
inline Pixels Cards::pixels(tree_impostor_map map) const & {
    Pixels pixels;
    if (!(detail::done(tree_cards_pixels(get(), map, &pixels)))) { pixels.struct_size = 0; }
    return pixels;
}
inline Picture Cards::picture(tree_impostor_map map, Ref<tree_control> control) const {
    Picture picture;
    detail::done(tree_cards_picture(get(), map, control, picture.place()), control);
    return picture;
}
inline Picture Cards::lit(Ref<tree_control> control) const {
    Picture picture;
    detail::done(tree_cards_lit(get(), control, picture.place()), control);
    return picture;
}
inline Mesh Cards::mesh(Span<const uint32_t> boxes, Ref<tree_control> control) const {
    Mesh mesh;
    detail::done(tree_cards_mesh(get(), boxes.data(), boxes.size(), control, mesh.place()), control);
    return mesh;
}
inline Mesh Cards::plain(Span<const uint32_t> boxes, Ref<tree_control> control) const {
    Mesh mesh;
    detail::done(tree_cards_plain(get(), boxes.data(), boxes.size(), control, mesh.place()), control);
    return mesh;
}
inline Mesh Cards::mesh_of_planes(Span<const uint32_t> boxes, Span<const uint32_t> planes, Ref<tree_control> control) const {
    Mesh mesh;
    detail::done(tree_cards_mesh_of_planes(get(), boxes.data(), boxes.size(), planes.data(), planes.size(), control, mesh.place()), control);
    return mesh;
}
inline Picture Cards::view(Span<const uint32_t> boxes, Ref<tree_view> view, Ref<tree_control> control) const {
    Picture picture;
    detail::done(tree_cards_view(get(), boxes.data(), boxes.size(), view, control, picture.place()), control);
    return picture;
}
inline Bytes Cards::to_glb(Span<const uint32_t> boxes, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_cards_to_glb(get(), boxes.data(), boxes.size(), options, control, bytes.place()), control);
    return bytes;
}
inline bool Cards::write_glb(Span<const uint32_t> boxes, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    return detail::done(tree_cards_write_glb(get(), boxes.data(), boxes.size(), path.data() ? path.data() : "", path.size(), options, control), control);
}
inline std::string_view Cards::shader(tree_shader language) {
    tree_str text{};
    detail::done(tree_cards_shader(language, &text));
    return detail::text(text);
}
inline bool CardChooseParams::check() const {
    return detail::done(tree_card_choose_params_check(this));
}
inline CardChoice CardChoice::make(const Cards &cards) {
    CardChoice choice;
    detail::done(tree_card_choice_new(cards.get(), choice.place()));
    return choice;
}
inline CardChoiceReport CardChoice::update(const Cards &cards, const Floats<3> &eye, float pixels_per_metre, Ref<tree_card_choose_params> params) const {
    CardChoiceReport report;
    if (!(detail::done(tree_card_choice_update(get(), cards.get(), eye, pixels_per_metre, params, &report)))) { report.struct_size = 0; }
    return report;
}
inline CardChoiceReport CardChoice::measure() const {
    CardChoiceReport report;
    if (!(detail::done(tree_card_choice_measure(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline std::vector<uint32_t> CardChoice::boxes() const {
    std::vector<uint32_t> boxes(measure().n_boxes);
    if (!(detail::done(tree_card_choice_boxes(get(), boxes.data(), boxes.size())))) { boxes.clear(); }
    return boxes;
}
inline bool CardChoice::boxes(Span<uint32_t> boxes) const {
    return detail::done(tree_card_choice_boxes(get(), boxes.data(), boxes.size()));
}
inline std::vector<tree_leaf_range> CardChoice::ranges() const {
    std::vector<tree_leaf_range> ranges(measure().n_ranges);
    if (!(detail::done(tree_card_choice_ranges(get(), ranges.data(), ranges.size())))) { ranges.clear(); }
    return ranges;
}
inline bool CardChoice::ranges(Span<tree_leaf_range> ranges) const {
    return detail::done(tree_card_choice_ranges(get(), ranges.data(), ranges.size()));
}
inline std::array<float, 2> Octahedral::encode(const Floats<3> &direction, bool hemi) {
    std::array<float, 2> place{};
    detail::done(tree_octahedral_encode(direction, hemi ? 1u : 0u, reinterpret_cast<float(*)[2]>(place.data())));
    return place;
}
inline std::array<float, 3> Octahedral::decode(const Floats<2> &place, bool hemi) {
    std::array<float, 3> direction{};
    detail::done(tree_octahedral_decode(place, hemi ? 1u : 0u, reinterpret_cast<float(*)[3]>(direction.data())));
    return direction;
}
inline std::vector<tree_octahedral_frame> Octahedral::frames(const Floats<3> &direction, uint32_t grid, bool hemi) {
    std::vector<tree_octahedral_frame> frames(3);
    if (!(detail::done(tree_octahedral_frames(direction, grid, hemi ? 1u : 0u, frames.data(), frames.size())))) { frames.clear(); }
    return frames;
}
inline bool Octahedral::frames(const Floats<3> &direction, uint32_t grid, bool hemi, Span<tree_octahedral_frame> frames) {
    return detail::done(tree_octahedral_frames(direction, grid, hemi ? 1u : 0u, frames.data(), frames.size()));
}
inline std::tuple<std::array<float, 3>, std::array<float, 3>, std::array<float, 3>> Octahedral::axes(uint32_t column, uint32_t row, uint32_t grid, bool hemi) {
    std::array<float, 3> right{};
    std::array<float, 3> up{};
    std::array<float, 3> toward{};
    detail::done(tree_octahedral_axes(column, row, grid, hemi ? 1u : 0u, reinterpret_cast<float(*)[3]>(right.data()), reinterpret_cast<float(*)[3]>(up.data()), reinterpret_cast<float(*)[3]>(toward.data())));
    return {std::move(right), std::move(up), std::move(toward)};
}
inline Mips Mips::of_picture(const Picture &picture, size_t most, Ref<tree_control> control) {
    Mips mips;
    detail::done(tree_mips_of_picture(picture.get(), most, control, mips.place()), control);
    return mips;
}
inline size_t Mips::count() const {
    size_t n_levels{};
    detail::done(tree_mips_count(get(), &n_levels));
    return n_levels;
}
inline Pixels Mips::view(size_t number) const & {
    Pixels pixels;
    if (!(detail::done(tree_mips_view(get(), number, &pixels)))) { pixels.struct_size = 0; }
    return pixels;
}
inline Octahedral Octahedral::bake(const Mesh &mesh, Ref<tree_octahedral_params> params, Ref<tree_control> control, tree_octahedral_report *report) {
    Octahedral octahedral;
    detail::done(tree_octahedral_bake(mesh.get(), params, control, report, octahedral.place()), control);
    return octahedral;
}
inline Octahedral Octahedral::from_pictures(Ref<tree_octahedral_meta> meta, const Picture &color, const Picture &detail, Ref<tree_control> control) {
    Octahedral octahedral;
    detail::done(tree_octahedral_from_pictures(meta, color.get(), detail.get(), control, octahedral.place()), control);
    return octahedral;
}
inline OctahedralReport Octahedral::measure() const {
    OctahedralReport report;
    if (!(detail::done(tree_octahedral_measure(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline OctahedralMeta Octahedral::describe() const {
    OctahedralMeta meta;
    if (!(detail::done(tree_octahedral_describe(get(), &meta)))) { meta.struct_size = 0; }
    return meta;
}
inline Bytes Octahedral::to_json() const {
    Bytes bytes;
    detail::done(tree_octahedral_to_json(get(), bytes.place()));
    return bytes;
}
inline Pixels Octahedral::pixels(tree_impostor_map map) const & {
    Pixels pixels;
    if (!(detail::done(tree_octahedral_pixels(get(), map, &pixels)))) { pixels.struct_size = 0; }
    return pixels;
}
inline Picture Octahedral::picture(tree_impostor_map map, Ref<tree_control> control) const {
    Picture picture;
    detail::done(tree_octahedral_picture(get(), map, control, picture.place()), control);
    return picture;
}
inline Picture Octahedral::view(Ref<tree_view> view, Ref<tree_control> control) const {
    Picture picture;
    detail::done(tree_octahedral_view(get(), view, control, picture.place()), control);
    return picture;
}
inline Mask Octahedral::mask(Ref<tree_view> view, Ref<tree_control> control) const {
    Mask mask;
    detail::done(tree_octahedral_mask(get(), view, control, mask.place()), control);
    return mask;
}
inline std::string_view Octahedral::shader(tree_shader language) {
    tree_str text{};
    detail::done(tree_octahedral_shader(language, &text));
    return detail::text(text);
}
inline bool OctahedralMeta::check() const {
    return detail::done(tree_octahedral_meta_check(this));
}
inline std::tuple<std::array<float, 2>, float> OctahedralMeta::extent(float y) const {
    std::array<float, 2> half{};
    float reach{};
    detail::done(tree_octahedral_meta_extent(this, y, reinterpret_cast<float(*)[2]>(half.data()), &reach));
    return {std::move(half), std::move(reach)};
}
inline bool OctahedralParams::check() const {
    return detail::done(tree_octahedral_params_check(this));
}
inline std::array<float, 6> card_weights(const Floats<3> &half, const Floats<3> &direction) {
    std::array<float, 6> weights{};
    detail::done(tree_card_weights(half, direction, reinterpret_cast<float(*)[6]>(weights.data())));
    return weights;
}
inline std::array<float, 2> card_interval(const Floats<6> &weights, uint32_t plane) {
    std::array<float, 2> interval{};
    detail::done(tree_card_interval(weights, plane, reinterpret_cast<float(*)[2]>(interval.data())));
    return interval;
}
inline float card_noise(const Floats<2> &pixel) {
    float share{};
    detail::done(tree_card_noise(pixel, &share));
    return share;
}
inline Twigs Twigs::build(const Tree &tree, Maybe<tree_look> look, Ref<tree_mesh_params> mesh_params, Ref<tree_instancing_params> params, uint64_t seed, Ref<tree_control> control, tree_instancing_report *report) {
    Twigs twigs;
    static_cast<void>(detail::expect(look.fits(), TREE_ERROR_NULL, "look: empty; leave it out, or hand over nullptr")
        && detail::done(tree_twigs_build(tree.get(), look, mesh_params, params, seed, control, report, twigs.place()), control));
    return twigs;
}
inline size_t Twigs::count() const {
    size_t n_twigs{};
    detail::done(tree_twigs_count(get(), &n_twigs));
    return n_twigs;
}
inline InstancingReport Twigs::measure() const {
    InstancingReport report;
    if (!(detail::done(tree_twigs_measure(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline Mesh Twigs::base() const {
    Mesh base;
    detail::done(tree_twigs_base(get(), base.place()));
    return base;
}
inline Mesh Twigs::mesh(size_t number) const {
    Mesh mesh;
    detail::done(tree_twigs_mesh(get(), number, mesh.place()));
    return mesh;
}
inline TwigInstances Twigs::instances(size_t number) const & {
    TwigInstances instances;
    if (!(detail::done(tree_twigs_instances(get(), number, &instances)))) { instances.struct_size = 0; }
    return instances;
}
inline Twigs Twigs::from_parts(const Mesh &base, const Handles<tree_mesh> &meshes, Span<const tree_twig_instances> instances, Ref<tree_control> control) {
    Twigs twigs;
    static_cast<void>(detail::expect(meshes.size() == instances.size(), TREE_ERROR_BUFFER, "meshes and instances must be of one length")
        && detail::done(tree_twigs_from_parts(base.get(), meshes.data(), instances.data(), meshes.size(), control, twigs.place()), control));
    return twigs;
}
inline Mesh Twigs::flatten(Ref<tree_control> control) const {
    Mesh mesh;
    detail::done(tree_twigs_flatten(get(), control, mesh.place()), control);
    return mesh;
}
inline Span<const uint8_t> Bytes::view() const & {
    const uint8_t *data = nullptr;
    size_t len = 0;
    detail::done(tree_bytes_view(get(), &data, &len));
    return Span<const uint8_t>(data, len);
}
inline Cloud Cloud::read(std::string_view path, Ref<tree_control> control) {
    Cloud cloud;
    detail::done(tree_cloud_read(path.data() ? path.data() : "", path.size(), control, cloud.place()), control);
    return cloud;
}
inline Cloud Cloud::from_bytes(tree_cloud_format format, Span<const uint8_t> data, Ref<tree_control> control) {
    Cloud cloud;
    detail::done(tree_cloud_from_bytes(format, data.data(), data.size(), control, cloud.place()), control);
    return cloud;
}
inline CloudColumns Cloud::view() const & {
    CloudColumns columns;
    if (!(detail::done(tree_cloud_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline bool Mesh::write_glb(std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    return detail::done(tree_mesh_write_glb(get(), path.data() ? path.data() : "", path.size(), options, control), control);
}
inline Bytes Mesh::to_glb(Ref<tree_glb_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_mesh_to_glb(get(), options, control, bytes.place()), control);
    return bytes;
}
inline bool gltf_write_glb(Span<const tree_gltf_level> levels, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) {
    return detail::done(tree_gltf_write_glb(levels.data(), levels.size(), path.data() ? path.data() : "", path.size(), options, control), control);
}
inline Bytes gltf_to_glb(Span<const tree_gltf_level> levels, Ref<tree_glb_options> options, Ref<tree_control> control) {
    Bytes bytes;
    detail::done(tree_gltf_to_glb(levels.data(), levels.size(), options, control, bytes.place()), control);
    return bytes;
}
inline bool gltf_write_files(Span<const tree_gltf_level> levels, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) {
    return detail::done(tree_gltf_write_files(levels.data(), levels.size(), path.data() ? path.data() : "", path.size(), options, control), control);
}
inline std::tuple<Mesh, GltfLeaves> Mesh::build_instanced(const Tree &tree, Maybe<tree_look> look, Ref<tree_mesh_params> params, Ref<tree_control> control) {
    Mesh bark;
    GltfLeaves leaves;
    static_cast<void>(detail::expect(look.fits(), TREE_ERROR_NULL, "look: empty; leave it out, or hand over nullptr")
        && detail::done(tree_mesh_build_instanced(tree.get(), look, params, control, bark.place(), leaves.place()), control));
    return {std::move(bark), std::move(leaves)};
}
inline Span<const tree_gltf_instances> GltfLeaves::view() const & {
    const tree_gltf_instances *rows = nullptr;
    size_t n = 0;
    detail::done(tree_gltf_leaves_view(get(), &rows, &n));
    return Span<const tree_gltf_instances>(rows, n);
}
inline bool Mesh::write_glb_moving(Ref<tree_glb_motion> motion, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    return detail::done(tree_mesh_write_glb_moving(get(), motion, path.data() ? path.data() : "", path.size(), options, control), control);
}
inline Bytes Mesh::to_glb_moving(Ref<tree_glb_motion> motion, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_mesh_to_glb_moving(get(), motion, options, control, bytes.place()), control);
    return bytes;
}
inline GltfAttributes Mesh::gltf_wind(Ref<tree_control> control) const {
    GltfAttributes attributes;
    detail::done(tree_mesh_gltf_wind(get(), control, attributes.place()), control);
    return attributes;
}
inline Span<const tree_gltf_attribute> GltfAttributes::view() const & {
    const tree_gltf_attribute *rows = nullptr;
    size_t n = 0;
    detail::done(tree_gltf_attributes_view(get(), &rows, &n));
    return Span<const tree_gltf_attribute>(rows, n);
}
inline std::string_view note_text(tree_note note) {
    tree_str text{};
    detail::done(tree_note_text(note, &text));
    return detail::text(text);
}
inline bool Mesh::write_obj(std::string_view path, Ref<tree_control> control) const {
    return detail::done(tree_mesh_write_obj(get(), path.data() ? path.data() : "", path.size(), control), control);
}
inline std::tuple<Bytes, Bytes> Mesh::to_obj(std::string_view stem, Ref<tree_control> control) const {
    Bytes obj;
    Bytes mtl;
    detail::done(tree_mesh_to_obj(get(), stem.data() ? stem.data() : "", stem.size(), control, obj.place(), mtl.place()), control);
    return {std::move(obj), std::move(mtl)};
}
inline bool Mesh::write_ply(std::string_view path, Ref<tree_ply_options> options, Ref<tree_control> control) const {
    return detail::done(tree_mesh_write_ply(get(), path.data() ? path.data() : "", path.size(), options, control), control);
}
inline Bytes Mesh::to_ply(Ref<tree_ply_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_mesh_to_ply(get(), options, control, bytes.place()), control);
    return bytes;
}
inline Mesh Mesh::read(std::string_view path, Ref<tree_import_options> options, Ref<tree_control> control, tree_import_report *report) {
    Mesh mesh;
    detail::done(tree_mesh_read(path.data() ? path.data() : "", path.size(), options, control, report, mesh.place()), control);
    return mesh;
}
inline Mesh Mesh::from_bytes(tree_mesh_format format, Span<const uint8_t> data, Span<const uint8_t> mtl, Ref<tree_control> control, tree_import_report *report) {
    Mesh mesh;
    detail::done(tree_mesh_from_bytes(format, data.data(), data.size(), mtl.data(), mtl.size(), control, report, mesh.place()), control);
    return mesh;
}
inline tree_lod_distance lod_distance_cook() {
    tree_lod_distance distance{};
    detail::done(tree_lod_distance_cook(&distance));
    return distance;
}
inline tree_lod_distance LodTable::lod_distance_for_quality(float near, float far) const {
    tree_lod_distance distance{};
    detail::done(tree_lod_distance_for_quality(get(), near, far, &distance));
    return distance;
}
inline tree_lod_distance LodTable::lod_distance_parity(const LodTable &cook) const {
    tree_lod_distance distance{};
    detail::done(tree_lod_distance_parity(get(), cook.get(), &distance));
    return distance;
}
inline tree_lod_distance lod_distance_from_samples(Span<const float> lambdas) {
    tree_lod_distance distance{};
    detail::done(tree_lod_distance_from_samples(lambdas.data(), lambdas.size(), &distance));
    return distance;
}
inline std::vector<float> lod_distance_places() {
    std::vector<float> places(TREE_LOD_DISTANCE_SAMPLES);
    if (!(detail::done(tree_lod_distance_places(places.data(), places.size())))) { places.clear(); }
    return places;
}
inline bool lod_distance_places(Span<float> places) {
    return detail::done(tree_lod_distance_places(places.data(), places.size()));
}
inline float lod_distance_lambda(const tree_lod_distance &distance, float d) {
    float lambda{};
    detail::done(tree_lod_distance_lambda(&distance, d, &lambda));
    return lambda;
}
inline Elements Elements::of_mesh(const Mesh &mesh, Span<const uint32_t> surfaces, tree_grain grain, Ref<tree_control> control) {
    Elements elements;
    detail::done(tree_elements_of_mesh(mesh.get(), surfaces.data(), surfaces.size(), grain, control, elements.place()), control);
    return elements;
}
inline Elements Elements::from_columns(const Mesh &mesh, Ref<tree_elements_columns> columns, Ref<tree_control> control) {
    Elements elements;
    detail::done(tree_elements_from_columns(mesh.get(), columns, control, elements.place()), control);
    return elements;
}
inline ElementsColumns Elements::view() const & {
    ElementsColumns columns;
    if (!(detail::done(tree_elements_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline float Elements::plant_height() const {
    float metres{};
    detail::done(tree_elements_plant_height(get(), &metres));
    return metres;
}
inline bool HullParams::check() const {
    return detail::done(tree_hull_params_check(this));
}
inline Hull Hull::of_metaballs(const Metaballs &metaballs, Ref<tree_hull_params> params, Ref<tree_control> control) {
    Hull hull;
    detail::done(tree_hull_of_metaballs(metaballs.get(), params, control, hull.place()), control);
    return hull;
}
inline Hull Hull::of_elements(const Elements &elements, Ref<tree_order_params> params, Ref<tree_control> control) {
    Hull hull;
    detail::done(tree_hull_of_elements(elements.get(), params, control, hull.place()), control);
    return hull;
}
inline HullColumns Hull::view() const & {
    HullColumns columns;
    if (!(detail::done(tree_hull_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Mesh Hull::mesh() const {
    Mesh mesh;
    detail::done(tree_hull_mesh(get(), mesh.place()));
    return mesh;
}
inline std::tuple<std::vector<float>, std::vector<float>> Hull::sample(size_t n_samples, uint64_t seed, Ref<tree_control> control) const {
    std::vector<float> positions(3 * n_samples);
    std::vector<float> normals(3 * n_samples);
    if (!(detail::done(tree_hull_sample(get(), n_samples, seed, control, positions.data(), positions.size(), normals.data(), normals.size()), control))) { positions.clear(); normals.clear(); }
    return {std::move(positions), std::move(normals)};
}
inline bool Hull::sample(size_t n_samples, uint64_t seed, Ref<tree_control> control, Span<float> positions, Span<float> normals) const {
    return detail::done(tree_hull_sample(get(), n_samples, seed, control, positions.data(), positions.size(), normals.data(), normals.size()), control);
}
inline std::tuple<std::vector<float>, std::vector<float>> Hull::nearest(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> positions(points.size());
    std::vector<float> normals(points.size());
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_hull_nearest(get(), points.data(), points.size() / 3, control, positions.data(), positions.size(), normals.data(), normals.size()), control))) { positions.clear(); normals.clear(); }
    return {std::move(positions), std::move(normals)};
}
inline bool Hull::nearest(Span<const float> points, Ref<tree_control> control, Span<float> positions, Span<float> normals) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_hull_nearest(get(), points.data(), points.size() / 3, control, positions.data(), positions.size(), normals.data(), normals.size()), control);
}
inline Bits Bits::of_mesh(const Mesh &mesh, Ref<tree_view> view, Ref<tree_control> control) {
    Bits bits;
    detail::done(tree_bits_of_mesh(mesh.get(), view, control, bits.place()), control);
    return bits;
}
inline BitsSize Bits::measure() const {
    BitsSize found;
    if (!(detail::done(tree_bits_measure(get(), &found)))) { found.struct_size = 0; }
    return found;
}
inline std::vector<uint64_t> Bits::words() const {
    std::vector<uint64_t> words(measure().n_words);
    if (!(detail::done(tree_bits_words(get(), words.data(), words.size())))) { words.clear(); }
    return words;
}
inline bool Bits::words(Span<uint64_t> words) const {
    return detail::done(tree_bits_words(get(), words.data(), words.size()));
}
inline std::vector<uint8_t> Bits::bytes() const {
    std::vector<uint8_t> bytes(measure().n_pixels);
    if (!(detail::done(tree_bits_bytes(get(), bytes.data(), bytes.size())))) { bytes.clear(); }
    return bytes;
}
inline bool Bits::bytes(Span<uint8_t> bytes) const {
    return detail::done(tree_bits_bytes(get(), bytes.data(), bytes.size()));
}
inline tree_score Bits::score(const Bits &full) const {
    tree_score score{};
    detail::done(tree_bits_score(get(), full.get(), &score));
    return score;
}
inline Metaballs Metaballs::make(Span<const float> points, float radius, Ref<tree_control> control) {
    Metaballs metaballs;
    static_cast<void>(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_metaballs_new(points.data(), points.size() / 3, radius, control, metaballs.place()), control));
    return metaballs;
}
inline Metaballs Metaballs::of_elements(const Elements &elements, float radius, float height, Ref<tree_control> control) {
    Metaballs metaballs;
    detail::done(tree_metaballs_of_elements(elements.get(), radius, height, control, metaballs.place()), control);
    return metaballs;
}
inline float Metaballs::radius() const {
    float radius{};
    detail::done(tree_metaballs_radius(get(), &radius));
    return radius;
}
inline size_t Metaballs::count() const {
    size_t n_points{};
    detail::done(tree_metaballs_count(get(), &n_points));
    return n_points;
}
inline std::array<float, 6> Metaballs::bounds() const {
    std::array<float, 6> min_max{};
    detail::done(tree_metaballs_bounds(get(), reinterpret_cast<float(*)[6]>(min_max.data())));
    return min_max;
}
inline std::vector<float> Metaballs::values(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> values(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_metaballs_values(get(), points.data(), points.size() / 3, control, values.data(), values.size()), control))) { values.clear(); }
    return values;
}
inline bool Metaballs::values(Span<const float> points, Ref<tree_control> control, Span<float> values) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_metaballs_values(get(), points.data(), points.size() / 3, control, values.data(), values.size()), control);
}
inline std::vector<float> Metaballs::gradients(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> gradients(points.size());
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_metaballs_gradients(get(), points.data(), points.size() / 3, control, gradients.data(), gradients.size()), control))) { gradients.clear(); }
    return gradients;
}
inline bool Metaballs::gradients(Span<const float> points, Ref<tree_control> control, Span<float> gradients) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_metaballs_gradients(get(), points.data(), points.size() / 3, control, gradients.data(), gradients.size()), control);
}
inline std::vector<uint32_t> Elements::order_stochastic(uint64_t seed) const {
    std::vector<uint32_t> order(view().n_elements);
    if (!(detail::done(tree_order_stochastic(get(), seed, order.data(), order.size())))) { order.clear(); }
    return order;
}
inline bool Elements::order_stochastic(uint64_t seed, Span<uint32_t> order) const {
    return detail::done(tree_order_stochastic(get(), seed, order.data(), order.size()));
}
inline std::vector<uint32_t> Elements::order_golden() const {
    std::vector<uint32_t> order(view().n_elements);
    if (!(detail::done(tree_order_golden(get(), order.data(), order.size())))) { order.clear(); }
    return order;
}
inline bool Elements::order_golden(Span<uint32_t> order) const {
    return detail::done(tree_order_golden(get(), order.data(), order.size()));
}
inline std::vector<uint32_t> Elements::order_density(Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control) const {
    std::vector<uint32_t> order(view().n_elements);
    if (!(detail::done(tree_order_density(get(), params, seed, control, order.data(), order.size()), control))) { order.clear(); }
    return order;
}
inline bool Elements::order_density(Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control, Span<uint32_t> order) const {
    return detail::done(tree_order_density(get(), params, seed, control, order.data(), order.size()), control);
}
inline std::vector<uint32_t> Elements::order_orientation(const Hull &hull, Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control) const {
    std::vector<uint32_t> order(view().n_elements);
    if (!(detail::done(tree_order_orientation(get(), hull.get(), params, seed, control, order.data(), order.size()), control))) { order.clear(); }
    return order;
}
inline bool Elements::order_orientation(const Hull &hull, Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control, Span<uint32_t> order) const {
    return detail::done(tree_order_orientation(get(), hull.get(), params, seed, control, order.data(), order.size()), control);
}
inline std::vector<uint32_t> Elements::order_combined(Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control) const {
    std::vector<uint32_t> order(view().n_elements);
    if (!(detail::done(tree_order_combined(get(), params, seed, control, order.data(), order.size()), control))) { order.clear(); }
    return order;
}
inline bool Elements::order_combined(Ref<tree_order_params> params, uint64_t seed, Ref<tree_control> control, Span<uint32_t> order) const {
    return detail::done(tree_order_combined(get(), params, seed, control, order.data(), order.size()), control);
}
inline std::tuple<std::vector<uint32_t>, std::vector<float>> Mesh::order_coverage(const Elements &elements, Maybe<tree_tiers> tiers, size_t tier, Ref<tree_coverage_params> params, Ref<tree_control> control) const {
    std::vector<uint32_t> order(elements.view().n_elements);
    std::vector<float> pivots(3 * elements.view().n_elements);
    if (!(detail::expect(tiers.fits(), TREE_ERROR_NULL, "tiers: empty; leave it out, or hand over nullptr")
        && detail::done(tree_order_coverage(get(), elements.get(), tiers, tier, params, control, order.data(), order.size(), pivots.data(), pivots.size()), control))) { order.clear(); pivots.clear(); }
    return {std::move(order), std::move(pivots)};
}
inline bool Mesh::order_coverage(const Elements &elements, Maybe<tree_tiers> tiers, size_t tier, Ref<tree_coverage_params> params, Ref<tree_control> control, Span<uint32_t> order, Span<float> pivots) const {
    return detail::expect(tiers.fits(), TREE_ERROR_NULL, "tiers: empty; leave it out, or hand over nullptr")
        && detail::done(tree_order_coverage(get(), elements.get(), tiers, tier, params, control, order.data(), order.size(), pivots.data(), pivots.size()), control);
}
inline bool order_check(Span<const uint32_t> order, size_t n_elements) {
    return detail::done(tree_order_check(order.data(), order.size(), n_elements));
}
inline bool OrderParams::check() const {
    return detail::done(tree_order_params_check(this));
}
inline bool CoverageParams::check() const {
    return detail::done(tree_coverage_params_check(this));
}
inline PrunedTotals Pruned::measure() const {
    PrunedTotals totals;
    if (!(detail::done(tree_pruned_measure(get(), &totals)))) { totals.struct_size = 0; }
    return totals;
}
inline Mesh Pruned::mesh() const {
    Mesh mesh;
    detail::done(tree_pruned_mesh(get(), mesh.place()));
    return mesh;
}
inline PrunedPart Pruned::part_view(size_t number) const & {
    PrunedPart part;
    if (!(detail::done(tree_pruned_part_view(get(), number, &part)))) { part.struct_size = 0; }
    return part;
}
inline LodTable Pruned::table() const {
    LodTable table;
    detail::done(tree_pruned_table(get(), table.place()));
    return table;
}
inline std::vector<uint32_t> Pruned::kept() const {
    std::vector<uint32_t> kept(measure().n_tiers);
    if (!(detail::done(tree_pruned_kept(get(), kept.data(), kept.size())))) { kept.clear(); }
    return kept;
}
inline bool Pruned::kept(Span<uint32_t> kept) const {
    return detail::done(tree_pruned_kept(get(), kept.data(), kept.size()));
}
inline tree_lod_cut Pruned::cut(float lambda) const {
    tree_lod_cut cut{};
    detail::done(tree_pruned_cut(get(), lambda, &cut));
    return cut;
}
inline tree_lod_cut Pruned::step(uint64_t step) const {
    tree_lod_cut cut{};
    detail::done(tree_pruned_step(get(), step, &cut));
    return cut;
}
inline float Pruned::lambda_of(uint64_t n_triangles) const {
    float lambda{};
    detail::done(tree_pruned_lambda_of(get(), n_triangles, &lambda));
    return lambda;
}
inline float Pruned::lambda_of_rank(uint32_t rank) const {
    float lambda{};
    detail::done(tree_pruned_lambda_of_rank(get(), rank, &lambda));
    return lambda;
}
inline bool LodScreen::check() const {
    return detail::done(tree_lod_screen_check(this));
}
inline float LodScreen::coverage(float lambda, float size) const {
    float coverage{};
    detail::done(tree_lod_screen_coverage(this, lambda, size, &coverage));
    return coverage;
}
inline Bytes Pruned::to_glb(Ref<tree_glb_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_pruned_to_glb(get(), options, control, bytes.place()), control);
    return bytes;
}
inline bool Pruned::write_glb(std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    return detail::done(tree_pruned_write_glb(get(), path.data() ? path.data() : "", path.size(), options, control), control);
}
inline Bytes Pruned::to_glb_levels(Span<const float> lambdas, Ref<tree_lod_screen> screen, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_pruned_to_glb_levels(get(), lambdas.data(), lambdas.size(), screen, options, control, bytes.place()), control);
    return bytes;
}
inline bool Pruned::write_glb_levels(Span<const float> lambdas, Ref<tree_lod_screen> screen, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    return detail::done(tree_pruned_write_glb_levels(get(), lambdas.data(), lambdas.size(), screen, path.data() ? path.data() : "", path.size(), options, control), control);
}
inline std::tuple<tree_lod_level, std::vector<tree_lod_window>> Pruned::level(float lambda) const {
    tree_lod_level level{};
    std::vector<tree_lod_window> windows(measure().n_parts);
    if (!(detail::done(tree_pruned_level(get(), lambda, &level, windows.data(), windows.size())))) { windows.clear(); }
    return {std::move(level), std::move(windows)};
}
inline tree_lod_level Pruned::level(float lambda, Span<tree_lod_window> windows) const {
    tree_lod_level level{};
    detail::done(tree_pruned_level(get(), lambda, &level, windows.data(), windows.size()));
    return level;
}
inline std::tuple<std::vector<tree_lod_level>, std::vector<tree_lod_window>, size_t> Pruned::levels(size_t n) const {
    std::vector<tree_lod_level> levels(n);
    std::vector<tree_lod_window> windows(n * measure().n_parts);
    size_t n_levels{};
    if (!(detail::done(tree_pruned_levels(get(), n, levels.data(), levels.size(), windows.data(), windows.size(), &n_levels)))) { levels.clear(); windows.clear(); }
    levels.resize(n_levels);
    windows.resize(n_levels * measure().n_parts);
    return {std::move(levels), std::move(windows), std::move(n_levels)};
}
inline size_t Pruned::levels(size_t n, Span<tree_lod_level> levels, Span<tree_lod_window> windows) const {
    size_t n_levels{};
    detail::done(tree_pruned_levels(get(), n, levels.data(), levels.size(), windows.data(), windows.size(), &n_levels));
    return n_levels;
}
inline Mesh Pruned::mesh_at(float lambda, Ref<tree_control> control) const {
    Mesh mesh;
    detail::done(tree_pruned_mesh_at(get(), lambda, control, mesh.place()), control);
    return mesh;
}
inline Mesh Pruned::mesh_of(const tree_lod_level &level, Span<const tree_lod_window> windows, Ref<tree_control> control) const {
    Mesh mesh;
    detail::done(tree_pruned_mesh_of(get(), &level, windows.data(), windows.size(), control, mesh.place()), control);
    return mesh;
}
inline Bytes Pruned::to_json(Span<const tree_lod_level> levels, Span<const tree_lod_window> windows) const {
    Bytes bytes;
    detail::done(tree_pruned_to_json(get(), levels.data(), levels.size(), windows.data(), windows.size(), bytes.place()));
    return bytes;
}
inline bool PruneParams::check() const {
    return detail::done(tree_prune_params_check(this));
}
inline Pruned Pruned::make(const Mesh &mesh, Ref<tree_prune_make_params> params, Ref<tree_control> control) {
    Pruned pruned;
    detail::done(tree_pruned_make(mesh.get(), params, control, pruned.place()), control);
    return pruned;
}
inline Pruned Pruned::make(Ref<tree_lod_subject> subject, const LodTable &table, Ref<tree_prune_params> params, Ref<tree_control> control) {
    Pruned pruned;
    detail::done(tree_pruned_new(subject, table.get(), params, control, pruned.place()), control);
    return pruned;
}
inline SceneLevels Pruned::scene_levels(size_t n, const tree_lod_distance &distance) const {
    SceneLevels levels;
    detail::done(tree_pruned_scene_levels(get(), n, &distance, levels.place()));
    return levels;
}
inline SceneModel SceneLevels::model() const & {
    SceneModel model;
    if (!(detail::done(tree_scene_levels_model(get(), &model)))) { model.struct_size = 0; }
    return model;
}
inline std::string_view prune_shader(tree_shader language) {
    tree_str text{};
    detail::done(tree_prune_shader(language, &text));
    return detail::text(text);
}
inline std::array<float, 3> prune_position(const Floats<3> &vertex, const Floats<4> &center_rank, float growth, float lambda, float fade) {
    std::array<float, 3> drawn{};
    detail::done(tree_prune_position(vertex, center_rank, growth, lambda, fade, reinterpret_cast<float(*)[3]>(drawn.data())));
    return drawn;
}
inline std::array<float, 3> prune_color(const Floats<3> &rgb, const Floats<3> &mean, float contrast) {
    std::array<float, 3> drawn{};
    detail::done(tree_prune_color(rgb, mean, contrast, reinterpret_cast<float(*)[3]>(drawn.data())));
    return drawn;
}
inline float lod_cook_scale(float lambda) {
    float scale{};
    detail::done(tree_lod_cook_scale(lambda, &scale));
    return scale;
}
inline float lod_cook_lambda(float d) {
    float lambda{};
    detail::done(tree_lod_cook_lambda(d, &lambda));
    return lambda;
}
inline float lod_size_lambda(float pixels, float full, float h) {
    float lambda{};
    detail::done(tree_lod_size_lambda(pixels, full, h, &lambda));
    return lambda;
}
inline float lod_drop_and_resize(uint32_t n, uint32_t k, float w) {
    float growth{};
    detail::done(tree_lod_drop_and_resize(n, k, w, &growth));
    return growth;
}
inline float lod_contrast(float lambda, float scale) {
    float contrast{};
    detail::done(tree_lod_contrast(lambda, scale, &contrast));
    return contrast;
}
inline std::tuple<double, double, double> score_quality(const tree_score &score) {
    double precision{};
    double recall{};
    double quality{};
    detail::done(tree_score_quality(&score, &precision, &recall, &quality));
    return {std::move(precision), std::move(recall), std::move(quality)};
}
inline double score_mean_quality(Span<const tree_score> scores) {
    double quality{};
    detail::done(tree_score_mean_quality(scores.data(), scores.size(), &quality));
    return quality;
}
inline bool Mesh::score(const Mesh &full, Ref<tree_around> around, Ref<tree_control> control, Span<tree_score> scores) const {
    return detail::done(tree_mesh_score(get(), full.get(), around, control, scores.data(), scores.size()), control);
}
inline Scene Scene::make(Span<const tree_scene_model> models, Span<const tree_scene_instance> instances, Ref<tree_control> control) {
    Scene scene;
    detail::done(tree_scene_new(models.data(), models.size(), instances.data(), instances.size(), control, scene.place()), control);
    return scene;
}
inline bool Scene::set_instances(size_t first, Span<const tree_scene_instance> instances) const {
    return detail::done(tree_scene_set_instances(get(), first, instances.data(), instances.size()));
}
inline SceneNeeds Scene::measure() const {
    SceneNeeds needs;
    if (!(detail::done(tree_scene_measure(get(), &needs)))) { needs.struct_size = 0; }
    return needs;
}
inline SceneState SceneState::make(const Scene &scene, Ref<tree_control> control) {
    SceneState state;
    detail::done(tree_scene_state_new(scene.get(), control, state.place()), control);
    return state;
}
inline size_t SceneState::count_drawn() const {
    size_t n_drawn{};
    detail::done(tree_scene_state_count_drawn(get(), &n_drawn));
    return n_drawn;
}
inline tree_scene_shown SceneState::shown(const Scene &scene, size_t instance) const {
    tree_scene_shown shown{};
    detail::done(tree_scene_state_shown(get(), scene.get(), instance, &shown));
    return shown;
}
inline bool SceneParams::check() const {
    return detail::done(tree_scene_params_check(this));
}
inline bool Scene::eye_check(const Floats<16> &view, const Floats<16> &projection) {
    uint32_t is_reversed = 0;
    detail::done(tree_scene_eye_check(view, projection, &is_reversed));
    return is_reversed != 0;
}
inline SceneReport SceneState::select(const Scene &scene, Ref<tree_scene_frame> frame, Ref<tree_scene_params> params) const {
    SceneReport report;
    if (!(detail::done(tree_scene_state_select(get(), scene.get(), frame, params, &report)))) { report.struct_size = 0; }
    return report;
}
inline bool SceneModel::check() const {
    return detail::done(tree_scene_model_check(this));
}
inline std::tuple<size_t, size_t> SceneState::draws(const Scene &scene, Span<tree_draw_indexed> draws, Span<tree_instance_lod> rows) const {
    size_t n_draws{};
    size_t n_rows{};
    detail::done(tree_scene_state_draws(get(), scene.get(), draws.data(), draws.size(), rows.data(), rows.size(), &n_draws, &n_rows));
    return {std::move(n_draws), std::move(n_rows)};
}
inline std::tuple<size_t, size_t> SceneState::batches(const Scene &scene, Span<tree_draw_indexed> draws, Span<tree_instance_lod> rows) const {
    size_t n_draws{};
    size_t n_rows{};
    detail::done(tree_scene_state_batches(get(), scene.get(), draws.data(), draws.size(), rows.data(), rows.size(), &n_draws, &n_rows));
    return {std::move(n_draws), std::move(n_rows)};
}
inline bool LodSubject::scores(Span<const float> lambdas, Span<const float> scales, Ref<tree_around> around, Ref<tree_control> control, Span<tree_score> scores) const {
    return detail::done(tree_lod_subject_scores(this, lambdas.data(), lambdas.size(), scales.data(), scales.size(), around, control, scores.data(), scores.size()), control);
}
inline bool lod_plan(Ref<tree_lod_subject> subject, Ref<tree_control> control, Span<uint32_t> kept) {
    return detail::done(tree_lod_plan(subject, control, kept.data(), kept.size()), control);
}
inline bool LodTableParams::check() const {
    return detail::done(tree_lod_table_params_check(this));
}
inline LodTable LodTable::from_rows(Span<const tree_lod_row> rows) {
    LodTable table;
    detail::done(tree_lod_table_from_rows(rows.data(), rows.size(), table.place()));
    return table;
}
inline LodTable LodTable::measure(Ref<tree_lod_subject> subject, Ref<tree_lod_table_params> params, Ref<tree_control> control) {
    LodTable table;
    detail::done(tree_lod_table_measure(subject, params, control, table.place()), control);
    return table;
}
inline Span<const tree_lod_row> LodTable::rows() const & {
    const tree_lod_row *rows = nullptr;
    size_t n_rows = 0;
    detail::done(tree_lod_table_rows(get(), &rows, &n_rows));
    return Span<const tree_lod_row>(rows, n_rows);
}
inline tree_lod_row LodTable::at(float lambda) const {
    tree_lod_row row{};
    detail::done(tree_lod_table_at(get(), lambda, &row));
    return row;
}
inline float LodTable::lambda_for(float quality) const {
    float lambda{};
    detail::done(tree_lod_table_lambda_for(get(), quality, &lambda));
    return lambda;
}
inline bool TiersParams::check() const {
    return detail::done(tree_tiers_params_check(this));
}
inline Tiers Tiers::of_mesh(const Mesh &mesh, const Elements &elements, Ref<tree_tiers_params> params, Ref<tree_control> control) {
    Tiers tiers;
    detail::done(tree_tiers_of_mesh(mesh.get(), elements.get(), params, control, tiers.place()), control);
    return tiers;
}
inline Tiers Tiers::full(const Mesh &mesh, const Elements &elements) {
    Tiers tiers;
    detail::done(tree_tiers_full(mesh.get(), elements.get(), tiers.place()));
    return tiers;
}
inline Tiers Tiers::from_columns(const Mesh &mesh, const Elements &elements, Span<const tree_tier_columns> columns, Ref<tree_control> control) {
    Tiers tiers;
    detail::done(tree_tiers_from_columns(mesh.get(), elements.get(), columns.data(), columns.size(), control, tiers.place()), control);
    return tiers;
}
inline size_t Tiers::count() const {
    size_t n_tiers{};
    detail::done(tree_tiers_count(get(), &n_tiers));
    return n_tiers;
}
inline TierColumns Tiers::view(size_t tier) const & {
    TierColumns columns;
    if (!(detail::done(tree_tiers_view(get(), tier, &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Around Around::for_order(size_t n_triangles) {
    Around around;
    if (!(detail::done(tree_around_for_order(&around, sizeof(tree_around), n_triangles)))) { around.struct_size = 0; }
    return around;
}
inline Around Around::for_table(size_t n_triangles) {
    Around around;
    if (!(detail::done(tree_around_for_table(&around, sizeof(tree_around), n_triangles)))) { around.struct_size = 0; }
    return around;
}
inline bool Around::check() const {
    return detail::done(tree_around_check(this));
}
inline size_t Around::count() const {
    size_t n_views{};
    detail::done(tree_around_count(this, &n_views));
    return n_views;
}
inline View Around::view(size_t number) const {
    View view;
    if (!(detail::done(tree_around_view(this, number, &view)))) { view.struct_size = 0; }
    return view;
}
inline Look Look::built_in(Ref<tree_species> species) {
    Look look;
    detail::done(tree_look_built_in(species, look.place()));
    return look;
}
inline Look Look::plain(Ref<tree_species> species) {
    Look look;
    detail::done(tree_look_plain(species, look.place()));
    return look;
}
inline Look Look::of_tree(const Tree &tree, bool plain) {
    Look look;
    detail::done(tree_look_of_tree(tree.get(), plain ? 1u : 0u, look.place()));
    return look;
}
inline Look Look::make(Ref<tree_material> bark, Span<const tree_leaf_look> leaves, Ref<tree_control> control) {
    Look look;
    detail::done(tree_look_new(bark, leaves.data(), leaves.size(), control, look.place()), control);
    return look;
}
inline Look Look::with_leaf(size_t kind, Ref<tree_leaf_look> leaf, Ref<tree_control> control) const {
    Look changed;
    detail::done(tree_look_with_leaf(get(), kind, leaf, control, changed.place()), control);
    return changed;
}
inline size_t Look::leaf_count() const {
    size_t n_leaves{};
    detail::done(tree_look_leaf_count(get(), &n_leaves));
    return n_leaves;
}
inline Material Look::material(size_t number) const & {
    Material material;
    if (!(detail::done(tree_look_material(get(), number, &material)))) { material.struct_size = 0; }
    return material;
}
inline Texture Look::texture(size_t number) const {
    Texture texture;
    detail::done(tree_look_texture(get(), number, texture.place()));
    return texture;
}
inline LeafLook Look::leaf(size_t kind) const & {
    LeafLook leaf;
    if (!(detail::done(tree_look_leaf(get(), kind, &leaf)))) { leaf.struct_size = 0; }
    return leaf;
}
inline bool Look::check(Ref<tree_species> species) const {
    return detail::done(tree_look_check(get(), species));
}
inline BarkStyle bark_style_of(std::string_view name) {
    BarkStyle style;
    if (!(detail::done(tree_bark_style_of(name.data() ? name.data() : "", name.size(), &style)))) { style.struct_size = 0; }
    return style;
}
inline Texture Texture::bark_with(Ref<tree_bark_style> style, uint32_t size, Ref<tree_control> control) {
    Texture texture;
    detail::done(tree_texture_bark_with(style, size, control, texture.place()), control);
    return texture;
}
inline LeafModel Look::leaf_model(size_t kind, Ref<tree_control> control, tree_leaf_model_report *report) const {
    LeafModel model;
    detail::done(tree_look_leaf_model(get(), kind, control, report, model.place()), control);
    return model;
}
inline LeafMesh LeafModel::view() const & {
    LeafMesh mesh;
    if (!(detail::done(tree_leaf_model_view(get(), &mesh)))) { mesh.struct_size = 0; }
    return mesh;
}
inline LeafMesh Look::leaf_mesh(size_t kind) const & {
    LeafMesh mesh;
    if (!(detail::done(tree_look_leaf_mesh(get(), kind, &mesh)))) { mesh.struct_size = 0; }
    return mesh;
}
inline LeafShape leaf_shape_of(std::string_view name) {
    LeafShape shape;
    if (!(detail::done(tree_leaf_shape_of(name.data() ? name.data() : "", name.size(), &shape)))) { shape.struct_size = 0; }
    return shape;
}
inline bool LeafShape::autumn(float progress) {
    return detail::done(tree_leaf_shape_autumn(this, progress));
}
inline std::tuple<LeafCard, Texture> Texture::leaf_with(Ref<tree_leaf_shape> shape, uint32_t size, Ref<tree_control> control) {
    LeafCard card;
    Texture texture;
    if (!(detail::done(tree_texture_leaf_with(shape, size, control, &card, texture.place()), control))) { card.struct_size = 0; }
    return {std::move(card), std::move(texture)};
}
inline Span<const tree_str> bark_names() {
    const tree_str *names = nullptr;
    size_t n_names = 0;
    detail::done(tree_bark_names(&names, &n_names));
    return Span<const tree_str>(names, n_names);
}
inline Span<const tree_str> leaf_names() {
    const tree_str *names = nullptr;
    size_t n_names = 0;
    detail::done(tree_leaf_names(&names, &n_names));
    return Span<const tree_str>(names, n_names);
}
inline Texture Texture::from_pixels(Ref<tree_texture_pixels> pixels, Ref<tree_control> control) {
    Texture texture;
    detail::done(tree_texture_from_pixels(pixels, control, texture.place()), control);
    return texture;
}
inline Texture Texture::from_bytes(std::string_view name, Span<const uint8_t> data, Ref<tree_control> control) {
    Texture texture;
    detail::done(tree_texture_from_bytes(name.data() ? name.data() : "", name.size(), data.data(), data.size(), control, texture.place()), control);
    return texture;
}
inline Texture Texture::read(std::string_view path, Ref<tree_control> control) {
    Texture texture;
    detail::done(tree_texture_read(path.data() ? path.data() : "", path.size(), control, texture.place()), control);
    return texture;
}
inline Texture Texture::bark(std::string_view name, uint32_t size, Ref<tree_control> control) {
    Texture texture;
    detail::done(tree_texture_bark(name.data() ? name.data() : "", name.size(), size, control, texture.place()), control);
    return texture;
}
inline std::tuple<LeafCard, Texture> Texture::leaf(std::string_view name, uint32_t size, Ref<tree_control> control) {
    LeafCard card;
    Texture texture;
    if (!(detail::done(tree_texture_leaf(name.data() ? name.data() : "", name.size(), size, control, &card, texture.place()), control))) { card.struct_size = 0; }
    return {std::move(card), std::move(texture)};
}
inline TexturePixels Texture::view() const & {
    TexturePixels pixels;
    if (!(detail::done(tree_texture_view(get(), &pixels)))) { pixels.struct_size = 0; }
    return pixels;
}
inline Bytes Texture::to_png() const {
    Bytes png;
    detail::done(tree_texture_to_png(get(), png.place()));
    return png;
}
inline bool Texture::write_png(std::string_view path) const {
    return detail::done(tree_texture_write_png(get(), path.data() ? path.data() : "", path.size()));
}
inline std::tuple<std::string_view, size_t> Grammar::kind(uint16_t kind) const & {
    tree_str name{};
    size_t n_params{};
    detail::done(tree_grammar_kind(get(), kind, &name, &n_params));
    return {detail::text(name), std::move(n_params)};
}
inline uint16_t Grammar::find_kind(std::string_view name, size_t n_params) const {
    uint16_t kind{};
    detail::done(tree_grammar_find_kind(get(), name.data() ? name.data() : "", name.size(), n_params, &kind));
    return kind;
}
inline std::tuple<std::string_view, size_t> Word::kind(uint16_t kind) const & {
    tree_str name{};
    size_t n_params{};
    detail::done(tree_word_kind(get(), kind, &name, &n_params));
    return {detail::text(name), std::move(n_params)};
}
inline uint16_t Word::find_kind(std::string_view name, size_t n_params) const {
    uint16_t kind{};
    detail::done(tree_word_find_kind(get(), name.data() ? name.data() : "", name.size(), n_params, &kind));
    return kind;
}
inline Word Skeleton::to_word(Ref<tree_foliage> foliage, Ref<tree_chain_params> params, Ref<tree_control> control) const {
    Word word;
    detail::done(tree_skeleton_to_word(get(), foliage, params, control, word.place()), control);
    return word;
}
inline Word Tree::to_word(Ref<tree_chain_params> params, Ref<tree_control> control) const {
    Word word;
    detail::done(tree_tree_to_word(get(), params, control, word.place()), control);
    return word;
}
inline Word Grammar::derive(uint32_t steps, uint64_t seed, Ref<tree_control> control) const {
    Word word;
    detail::done(tree_grammar_derive(get(), steps, seed, control, word.place()), control);
    return word;
}
inline Word Grammar::step(const Word &word, uint32_t step, uint32_t of, uint64_t seed, Ref<tree_control> control) const {
    Word next;
    detail::done(tree_grammar_step(get(), word.get(), step, of, seed, control, next.place()), control);
    return next;
}
inline Word Grammar::interpretation(const Word &word, uint64_t seed, Ref<tree_control> control) const {
    Word seen;
    detail::done(tree_grammar_interpretation(get(), word.get(), seed, control, seen.place()), control);
    return seen;
}
inline std::tuple<TurtleTrace, Tree> Word::interpret(Ref<tree_turtle_params> turtle, Ref<tree_control> control, tree_turtle_report *report) const {
    TurtleTrace trace;
    Tree tree;
    detail::done(tree_word_interpret(get(), turtle, control, report, trace.place(), tree.place()), control);
    return {std::move(trace), std::move(tree)};
}
inline std::tuple<std::vector<float>, size_t> Word::lines(Ref<tree_turtle_params> turtle, Ref<tree_control> control) const {
    std::vector<float> lines(6 * view().n_modules);
    size_t n_lines{};
    if (!(detail::done(tree_word_lines(get(), turtle, control, lines.data(), lines.size(), &n_lines), control))) { lines.clear(); }
    lines.resize(6 * n_lines);
    return {std::move(lines), std::move(n_lines)};
}
inline size_t Word::lines(Ref<tree_turtle_params> turtle, Ref<tree_control> control, Span<float> lines) const {
    size_t n_lines{};
    detail::done(tree_word_lines(get(), turtle, control, lines.data(), lines.size(), &n_lines), control);
    return n_lines;
}
inline std::tuple<Word, TurtleTrace, Tree> Grammar::lsystem_grow(uint32_t steps, Ref<tree_turtle_params> turtle, uint64_t seed, Ref<tree_control> control, tree_turtle_report *report) const {
    Word word;
    TurtleTrace trace;
    Tree tree;
    detail::done(tree_lsystem_grow(get(), steps, turtle, seed, control, report, word.place(), trace.place(), tree.place()), control);
    return {std::move(word), std::move(trace), std::move(tree)};
}
inline Grammar Grammar::from_text(std::string_view text, Ref<tree_control> control, tree_grammar_report *report) {
    Grammar grammar;
    detail::done(tree_grammar_from_text(text.data() ? text.data() : "", text.size(), control, report, grammar.place()), control);
    return grammar;
}
inline Grammar Grammar::read(std::string_view path, Ref<tree_control> control, tree_grammar_report *report) {
    Grammar grammar;
    detail::done(tree_grammar_read(path.data() ? path.data() : "", path.size(), control, report, grammar.place()), control);
    return grammar;
}
inline GrammarInfo Grammar::view() const & {
    GrammarInfo info;
    if (!(detail::done(tree_grammar_view(get(), &info)))) { info.struct_size = 0; }
    return info;
}
inline std::tuple<std::string_view, double> Grammar::constant(size_t index) const & {
    tree_str name{};
    double value{};
    detail::done(tree_grammar_constant(get(), index, &name, &value));
    return {detail::text(name), std::move(value)};
}
inline Grammar Grammar::with_constant(std::string_view name, double value, tree_grammar_report *report) const {
    Grammar changed;
    detail::done(tree_grammar_with_constant(get(), name.data() ? name.data() : "", name.size(), value, report, changed.place()));
    return changed;
}
inline size_t lsystem_preset_count() {
    return tree_lsystem_preset_count();
}
inline LsystemPresetInfo lsystem_preset_view(size_t index) {
    LsystemPresetInfo info;
    if (!(detail::done(tree_lsystem_preset_view(index, &info)))) { info.struct_size = 0; }
    return info;
}
inline std::tuple<std::string_view, double> lsystem_preset_constant(size_t index, size_t constant) {
    tree_str name{};
    double value{};
    detail::done(tree_lsystem_preset_constant(index, constant, &name, &value));
    return {detail::text(name), std::move(value)};
}
inline std::tuple<TurtleParams, Grammar> lsystem_preset(std::string_view name) {
    TurtleParams turtle;
    Grammar grammar;
    if (!(detail::done(tree_lsystem_preset(name.data() ? name.data() : "", name.size(), &turtle, sizeof(tree_turtle_params), grammar.place())))) { turtle.struct_size = 0; }
    return {std::move(turtle), std::move(grammar)};
}
inline TurtlePolygons TurtleTrace::view() const & {
    TurtlePolygons polygons;
    if (!(detail::done(tree_turtle_trace_view(get(), &polygons)))) { polygons.struct_size = 0; }
    return polygons;
}
inline std::tuple<std::string_view, size_t> TurtleTrace::skipped(size_t index) const & {
    tree_str name{};
    size_t n_times{};
    detail::done(tree_turtle_trace_skipped(get(), index, &name, &n_times));
    return {detail::text(name), std::move(n_times)};
}
inline Lines TurtleTrace::warnings() const {
    Lines warnings;
    detail::done(tree_turtle_trace_warnings(get(), warnings.place()));
    return warnings;
}
inline bool TurtleParams::check() const {
    return detail::done(tree_turtle_params_check(this));
}
inline TurtleParams Grammar::turtle() const & {
    TurtleParams params;
    if (!(detail::done(tree_grammar_turtle(get(), &params, sizeof(tree_turtle_params))))) { params.struct_size = 0; }
    return params;
}
inline TurtleParams chain_turtle() {
    TurtleParams params;
    if (!(detail::done(tree_chain_turtle(&params, sizeof(tree_turtle_params))))) { params.struct_size = 0; }
    return params;
}
inline Word Word::from_text(std::string_view text, Ref<tree_control> control, tree_grammar_report *report) {
    Word word;
    detail::done(tree_word_from_text(text.data() ? text.data() : "", text.size(), control, report, word.place()), control);
    return word;
}
inline Word Grammar::word(std::string_view text, Ref<tree_control> control, tree_grammar_report *report) const {
    Word word;
    detail::done(tree_grammar_word(get(), text.data() ? text.data() : "", text.size(), control, report, word.place()), control);
    return word;
}
inline Word Grammar::word_from_columns(Ref<tree_word_columns> columns, Ref<tree_control> control, tree_grammar_report *report) const {
    Word word;
    detail::done(tree_grammar_word_from_columns(get(), columns, control, report, word.place()), control);
    return word;
}
inline Word Grammar::axiom() const {
    Word word;
    detail::done(tree_grammar_axiom(get(), word.place()));
    return word;
}
inline WordColumns Word::view() const & {
    WordColumns columns;
    if (!(detail::done(tree_word_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline WordHistory Word::past() const & {
    WordHistory history;
    if (!(detail::done(tree_word_past(get(), &history)))) { history.struct_size = 0; }
    return history;
}
inline Bytes Word::to_text() const {
    Bytes text;
    detail::done(tree_word_to_text(get(), text.place()));
    return text;
}
inline bool Word::check() const {
    return detail::done(tree_word_check(get()));
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
inline bool memory_set_allocator(Ref<tree_allocator> allocator) {
    return detail::done(tree_memory_set_allocator(allocator));
}
inline Span<const tree_wind_branch> Mesh::branches() const & {
    const tree_wind_branch *branches = nullptr;
    size_t n_branches = 0;
    detail::done(tree_mesh_branches(get(), &branches, &n_branches));
    return Span<const tree_wind_branch>(branches, n_branches);
}
inline Mesh Mesh::build(const Tree &tree, Maybe<tree_look> look, Ref<tree_mesh_params> params, Ref<tree_control> control, tree_mesh_report *report) {
    Mesh mesh;
    static_cast<void>(detail::expect(look.fits(), TREE_ERROR_NULL, "look: empty; leave it out, or hand over nullptr")
        && detail::done(tree_mesh_build(tree.get(), look, params, control, report, mesh.place()), control));
    return mesh;
}
inline Mesh Mesh::build_leaves(const Tree &tree, Maybe<tree_look> look, Ref<tree_mesh_params> params, Ref<tree_control> control) {
    Mesh mesh;
    static_cast<void>(detail::expect(look.fits(), TREE_ERROR_NULL, "look: empty; leave it out, or hand over nullptr")
        && detail::done(tree_mesh_build_leaves(tree.get(), look, params, control, mesh.place()), control));
    return mesh;
}
inline Mesh Mesh::subdivide(size_t number, Ref<tree_subdivide_params> params, Ref<tree_control> control) const {
    Mesh subdivided;
    detail::done(tree_mesh_subdivide(get(), number, params, control, subdivided.place()), control);
    return subdivided;
}
inline Mesh Mesh::displace(size_t number, Ref<tree_displace_params> params, uint64_t seed, Ref<tree_control> control) const {
    Mesh displaced;
    detail::done(tree_mesh_displace(get(), number, params, seed, control, displaced.place()), control);
    return displaced;
}
inline Mesh Mesh::bake_occlusion(Ref<tree_occlusion_params> params, Ref<tree_control> control) const {
    Mesh baked;
    detail::done(tree_mesh_bake_occlusion(get(), params, control, baked.place()), control);
    return baked;
}
inline Mesh Mesh::weld(size_t number, Ref<tree_control> control) const {
    Mesh welded;
    detail::done(tree_mesh_weld(get(), number, control, welded.place()), control);
    return welded;
}
inline Mesh Mesh::from_surfaces(Span<const tree_surface> surfaces, Span<const tree_material> materials, Span<const tree_wind_branch> branches, Ref<tree_control> control) {
    Mesh mesh;
    detail::done(tree_mesh_from_surfaces(surfaces.data(), surfaces.size(), materials.data(), materials.size(), branches.data(), branches.size(), control, mesh.place()), control);
    return mesh;
}
inline Material Mesh::material(size_t number) const & {
    Material material;
    if (!(detail::done(tree_mesh_material(get(), number, &material)))) { material.struct_size = 0; }
    return material;
}
inline Texture Mesh::texture(size_t number) const {
    Texture texture;
    detail::done(tree_mesh_texture(get(), number, texture.place()));
    return texture;
}
inline bool MeshParams::check() const {
    return detail::done(tree_mesh_params_check(this));
}
inline float MeshParams::error() const {
    float metres{};
    detail::done(tree_mesh_params_error(this, &metres));
    return metres;
}
inline Topology Mesh::examine(size_t number, Ref<tree_control> control) const {
    Topology topology;
    if (!(detail::done(tree_mesh_examine(get(), number, control, &topology), control))) { topology.struct_size = 0; }
    return topology;
}
inline std::tuple<std::vector<uint32_t>, std::vector<uint32_t>, size_t> Mesh::points(size_t number) const {
    std::vector<uint32_t> of_vertex(this->surface(number).n_vertices);
    std::vector<uint32_t> first(this->surface(number).n_vertices);
    size_t n_points{};
    if (!(detail::done(tree_mesh_points(get(), number, of_vertex.data(), of_vertex.size(), first.data(), first.size(), &n_points)))) { of_vertex.clear(); first.clear(); }
    first.resize(n_points);
    return {std::move(of_vertex), std::move(first), std::move(n_points)};
}
inline size_t Mesh::points(size_t number, Span<uint32_t> of_vertex, Span<uint32_t> first) const {
    size_t n_points{};
    detail::done(tree_mesh_points(get(), number, of_vertex.data(), of_vertex.size(), first.data(), first.size(), &n_points));
    return n_points;
}
inline Crossings Mesh::crossings(size_t number, Ref<tree_control> control) const {
    Crossings crossings;
    detail::done(tree_mesh_crossings(get(), number, control, crossings.place()), control);
    return crossings;
}
inline CrossingPairs Crossings::view() const & {
    CrossingPairs pairs;
    if (!(detail::done(tree_crossings_view(get(), &pairs)))) { pairs.struct_size = 0; }
    return pairs;
}
inline MeshTotals Mesh::measure() const {
    MeshTotals totals;
    if (!(detail::done(tree_mesh_measure(get(), &totals)))) { totals.struct_size = 0; }
    return totals;
}
inline size_t Mesh::surface_count() const {
    size_t n_surfaces{};
    detail::done(tree_mesh_surface_count(get(), &n_surfaces));
    return n_surfaces;
}
inline Surface Mesh::surface(size_t number) const & {
    Surface surface;
    if (!(detail::done(tree_mesh_surface(get(), number, &surface)))) { surface.struct_size = 0; }
    return surface;
}
inline Bounds Mesh::surface_bounds(size_t number) const {
    Bounds bounds;
    if (!(detail::done(tree_mesh_surface_bounds(get(), number, &bounds)))) { bounds.struct_size = 0; }
    return bounds;
}
inline Bounds Mesh::bounds() const {
    Bounds bounds;
    if (!(detail::done(tree_mesh_bounds(get(), &bounds)))) { bounds.struct_size = 0; }
    return bounds;
}
inline bool Mesh::check() const {
    return detail::done(tree_mesh_check(get()));
}
inline bool Mesh::check_surface(size_t number) const {
    return detail::done(tree_mesh_check_surface(get(), number));
}
inline bool Mesh::check_colors() const {
    return detail::done(tree_mesh_check_colors(get()));
}
inline bool Mesh::check_normals() const {
    return detail::done(tree_mesh_check_normals(get()));
}
inline Adt Adt::of_tokens(Ref<tree_token_columns> columns, Ref<tree_control> control) {
    Adt adt;
    detail::done(tree_adt_of_tokens(columns, control, adt.place()), control);
    return adt;
}
inline Adt Adt::of_skeleton(const Skeleton &skeleton, Ref<tree_control> control) {
    Adt adt;
    detail::done(tree_adt_of_skeleton(skeleton.get(), control, adt.place()), control);
    return adt;
}
inline Adt Adt::of_tree(const Tree &tree, Ref<tree_control> control) {
    Adt adt;
    detail::done(tree_adt_of_tree(tree.get(), control, adt.place()), control);
    return adt;
}
inline AdtColumns Adt::view() const & {
    AdtColumns columns;
    if (!(detail::done(tree_adt_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Span<const uint32_t> Adt::modules(uint32_t branch) const & {
    const uint32_t *modules = nullptr;
    size_t n_modules = 0;
    detail::done(tree_adt_modules(get(), branch, &modules, &n_modules));
    return Span<const uint32_t>(modules, n_modules);
}
inline Span<const uint32_t> Adt::children(uint32_t branch) const & {
    const uint32_t *children = nullptr;
    size_t n_children = 0;
    detail::done(tree_adt_children(get(), branch, &children, &n_children));
    return Span<const uint32_t>(children, n_children);
}
inline MultiChain MultiChain::make(const MultiPaths &paths, Ref<tree_control> control) {
    MultiChain chain;
    detail::done(tree_multi_chain_new(paths.get(), control, chain.place()), control);
    return chain;
}
inline MultiChainColumns MultiChain::view() const & {
    MultiChainColumns columns;
    if (!(detail::done(tree_multi_chain_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Bytes MultiChain::to_text(size_t n_levels, std::string_view text, Span<const uint32_t> ends, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_multi_chain_to_text(get(), n_levels, text.data() ? text.data() : "", text.size(), ends.data(), ends.size(), control, bytes.place()), control);
    return bytes;
}
inline Bytes MultiMesh::to_glb(Ref<tree_glb_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_multi_mesh_to_glb(get(), options, control, bytes.place()), control);
    return bytes;
}
inline bool MultiMesh::write_glb(std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    return detail::done(tree_multi_mesh_write_glb(get(), path.data() ? path.data() : "", path.size(), options, control), control);
}
inline Bytes MultiMesh::to_glb_levels(Span<const tree_level_share> levels, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_multi_mesh_to_glb_levels(get(), levels.data(), levels.size(), options, control, bytes.place()), control);
    return bytes;
}
inline bool MultiMesh::write_glb_levels(Span<const tree_level_share> levels, std::string_view path, Ref<tree_glb_options> options, Ref<tree_control> control) const {
    return detail::done(tree_multi_mesh_write_glb_levels(get(), levels.data(), levels.size(), path.data() ? path.data() : "", path.size(), options, control), control);
}
inline std::string_view MultiMesh::shader(tree_shader language) {
    tree_str text{};
    detail::done(tree_multi_mesh_shader(language, &text));
    return detail::text(text);
}
inline std::array<float, 3> MultiMesh::position(const Floats<3> &vertex, const Floats<4> &branch, float level) {
    std::array<float, 3> drawn{};
    detail::done(tree_multi_mesh_position(vertex, branch, level, reinterpret_cast<float(*)[3]>(drawn.data())));
    return drawn;
}
inline MultiMesh MultiMesh::make(const Multires &multires, Maybe<tree_look> look, Ref<tree_mesh_params> params, Ref<tree_control> control) {
    MultiMesh multi_mesh;
    static_cast<void>(detail::expect(look.fits(), TREE_ERROR_NULL, "look: empty; leave it out, or hand over nullptr")
        && detail::done(tree_multi_mesh_new(multires.get(), look, params, control, multi_mesh.place()), control));
    return multi_mesh;
}
inline MultiMeshTotals MultiMesh::measure() const {
    MultiMeshTotals totals;
    if (!(detail::done(tree_multi_mesh_measure(get(), &totals)))) { totals.struct_size = 0; }
    return totals;
}
inline Mesh MultiMesh::mesh() const {
    Mesh mesh;
    detail::done(tree_multi_mesh_mesh(get(), mesh.place()));
    return mesh;
}
inline MultiMeshColumn MultiMesh::branches(size_t number) const & {
    MultiMeshColumn column;
    if (!(detail::done(tree_multi_mesh_branches(get(), number, &column)))) { column.struct_size = 0; }
    return column;
}
inline std::tuple<std::vector<tree_multi_draw>, uint64_t> MultiMesh::draws(float level) const {
    std::vector<tree_multi_draw> draws(measure().n_surfaces);
    uint64_t n_triangles{};
    if (!(detail::done(tree_multi_mesh_draws(get(), level, draws.data(), draws.size(), &n_triangles)))) { draws.clear(); }
    return {std::move(draws), std::move(n_triangles)};
}
inline uint64_t MultiMesh::draws(float level, Span<tree_multi_draw> draws) const {
    uint64_t n_triangles{};
    detail::done(tree_multi_mesh_draws(get(), level, draws.data(), draws.size(), &n_triangles));
    return n_triangles;
}
inline uint32_t MultiMesh::wood_indices(float level) const {
    uint32_t n_indices{};
    detail::done(tree_multi_mesh_wood_indices(get(), level, &n_indices));
    return n_indices;
}
inline size_t MultiMesh::level_of_wood(uint64_t n_triangles) const {
    size_t n_levels{};
    detail::done(tree_multi_mesh_level_of_wood(get(), n_triangles, &n_levels));
    return n_levels;
}
inline Mesh MultiMesh::mesh_at(float level, Ref<tree_control> control) const {
    Mesh mesh;
    detail::done(tree_multi_mesh_mesh_at(get(), level, control, mesh.place()), control);
    return mesh;
}
inline Multires Multires::make(const Tree &tree, Ref<tree_metric_params> params, uint64_t seed, Ref<tree_control> control) {
    Multires multires;
    detail::done(tree_multires_new(tree.get(), params, seed, control, multires.place()), control);
    return multires;
}
inline std::tuple<Rows, Rows, Multires> Multires::of_paths(const Tree &tree, const MultiPaths &paths, Ref<tree_control> control) {
    Rows nodes;
    Rows leaves;
    Multires multires;
    detail::done(tree_multires_of_paths(tree.get(), paths.get(), control, nodes.place(), leaves.place(), multires.place()), control);
    return {std::move(nodes), std::move(leaves), std::move(multires)};
}
inline size_t Multires::count() const {
    size_t n_levels{};
    detail::done(tree_multires_count(get(), &n_levels));
    return n_levels;
}
inline std::tuple<size_t, size_t> Multires::level_counts(size_t n_levels) const {
    size_t n_nodes{};
    size_t n_leaves{};
    detail::done(tree_multires_level_counts(get(), n_levels, &n_nodes, &n_leaves));
    return {std::move(n_nodes), std::move(n_leaves)};
}
inline std::tuple<SkeletonColumns, Foliage> Multires::level(size_t n_levels) const & {
    SkeletonColumns columns;
    Foliage foliage;
    if (!(detail::done(tree_multires_level(get(), n_levels, &columns, &foliage)))) { columns.struct_size = 0; foliage.struct_size = 0; }
    return {std::move(columns), std::move(foliage)};
}
inline Tree Multires::tree_at(size_t n_levels, Ref<tree_control> control) const {
    Tree tree;
    detail::done(tree_multires_tree_at(get(), n_levels, control, tree.place()), control);
    return tree;
}
inline size_t Multires::level_of_nodes(size_t n_nodes) const {
    size_t n_levels{};
    detail::done(tree_multires_level_of_nodes(get(), n_nodes, &n_levels));
    return n_levels;
}
inline MultiPaths MultiPaths::make(const Adt &adt, Ref<tree_metric_params> params, uint64_t seed, Ref<tree_control> control) {
    MultiPaths paths;
    detail::done(tree_multi_paths_new(adt.get(), params, seed, control, paths.place()), control);
    return paths;
}
inline size_t MultiPaths::count() const {
    size_t n_paths{};
    detail::done(tree_multi_paths_count(get(), &n_paths));
    return n_paths;
}
inline Span<const uint32_t> MultiPaths::branches() const & {
    const uint32_t *branches = nullptr;
    size_t n_branches = 0;
    detail::done(tree_multi_paths_branches(get(), &branches, &n_branches));
    return Span<const uint32_t>(branches, n_branches);
}
inline Span<const uint32_t> MultiPaths::path(size_t number) const & {
    const uint32_t *branches = nullptr;
    size_t n_branches = 0;
    detail::done(tree_multi_paths_path(get(), number, &branches, &n_branches));
    return Span<const uint32_t>(branches, n_branches);
}
inline StreamReader StreamReader::make(Ref<tree_control> control) {
    StreamReader reader;
    detail::done(tree_stream_reader_new(control, reader.place()), control);
    return reader;
}
inline StreamReport StreamReader::push(Span<const uint8_t> data) const {
    StreamReport report;
    if (!(detail::done(tree_stream_reader_push(get(), data.data(), data.size(), &report)))) { report.struct_size = 0; }
    return report;
}
inline StreamReport StreamReader::received() const {
    StreamReport report;
    if (!(detail::done(tree_stream_reader_received(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline Multires StreamReader::multires(Ref<tree_control> control) const {
    Multires multires;
    detail::done(tree_stream_reader_multires(get(), control, multires.place()), control);
    return multires;
}
inline bool StreamParams::check() const {
    return detail::done(tree_stream_params_check(this));
}
inline Bytes Multires::to_stream(size_t n_levels, Ref<tree_stream_params> params, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_multires_to_stream(get(), n_levels, params, control, bytes.place()), control);
    return bytes;
}
inline bool Multires::write_stream(size_t n_levels, std::string_view path, Ref<tree_stream_params> params, Ref<tree_control> control) const {
    return detail::done(tree_multires_write_stream(get(), n_levels, path.data() ? path.data() : "", path.size(), params, control), control);
}
inline Bytes Multires::to_bracketed(Ref<tree_stream_params> params, Ref<tree_control> control) const {
    Bytes bytes;
    detail::done(tree_multires_to_bracketed(get(), params, control, bytes.place()), control);
    return bytes;
}
inline Multires Multires::from_stream(Span<const uint8_t> data, Ref<tree_control> control, tree_stream_report *report) {
    Multires multires;
    detail::done(tree_multires_from_stream(data.data(), data.size(), control, report, multires.place()), control);
    return multires;
}
inline Multires Multires::read_stream(std::string_view path, Ref<tree_control> control, tree_stream_report *report) {
    Multires multires;
    detail::done(tree_multires_read_stream(path.data() ? path.data() : "", path.size(), control, report, multires.place()), control);
    return multires;
}
inline std::tuple<std::vector<tree_density_view>, Grid> Grid::from_views(Span<const tree_particle_view> views, Ref<tree_density_params> params, Ref<tree_control> control, tree_density_report *report) {
    std::vector<tree_density_view> rows(views.size());
    Grid grid;
    if (!(detail::done(tree_grid_from_views(views.data(), views.size(), params, control, report, rows.data(), rows.size(), grid.place()), control))) { rows.clear(); }
    return {std::move(rows), std::move(grid)};
}
inline Grid Grid::from_views(Span<const tree_particle_view> views, Ref<tree_density_params> params, Ref<tree_control> control, tree_density_report *report, Span<tree_density_view> rows) {
    Grid grid;
    detail::done(tree_grid_from_views(views.data(), views.size(), params, control, report, rows.data(), rows.size(), grid.place()), control);
    return grid;
}
inline Carved Carved::make(Span<const tree_particle_view> views, Ref<tree_density_params> params, Ref<tree_control> control) {
    Carved carved;
    detail::done(tree_carved_new(views.data(), views.size(), params, control, carved.place()), control);
    return carved;
}
inline CarvedColumns Carved::view() const & {
    CarvedColumns columns;
    if (!(detail::done(tree_carved_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Grid Carved::alpha() const {
    Grid grid;
    detail::done(tree_carved_alpha(get(), grid.place()));
    return grid;
}
inline std::tuple<std::vector<tree_density_view>, Grid> Carved::solve(Span<const tree_particle_view> views, Ref<tree_density_params> params, Ref<tree_control> control, tree_density_report *report) const {
    std::vector<tree_density_view> rows(views.size());
    Grid grid;
    if (!(detail::done(tree_carved_solve(get(), views.data(), views.size(), params, control, report, rows.data(), rows.size(), grid.place()), control))) { rows.clear(); }
    return {std::move(rows), std::move(grid)};
}
inline Grid Carved::solve(Span<const tree_particle_view> views, Ref<tree_density_params> params, Ref<tree_control> control, tree_density_report *report, Span<tree_density_view> rows) const {
    Grid grid;
    detail::done(tree_carved_solve(get(), views.data(), views.size(), params, control, report, rows.data(), rows.size(), grid.place()), control);
    return grid;
}
inline Equations Equations::make(const Carved &carved, Span<const tree_particle_view> views, Ref<tree_density_params> params, Ref<tree_control> control) {
    Equations equations;
    detail::done(tree_equations_new(carved.get(), views.data(), views.size(), params, control, equations.place()), control);
    return equations;
}
inline EquationsColumns Equations::view() const & {
    EquationsColumns columns;
    if (!(detail::done(tree_equations_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Matte Grid::look_through(Ref<tree_particle_camera> camera, Ref<tree_control> control) const {
    Matte matte;
    detail::done(tree_grid_look_through(get(), camera, control, matte.place()), control);
    return matte;
}
inline double Grid::crown_volume(float threshold) const {
    double measure{};
    detail::done(tree_grid_crown_volume(get(), threshold, &measure));
    return measure;
}
inline double Grid::overlap(float threshold, const Grid &other, float other_threshold) const {
    double measure{};
    detail::done(tree_grid_overlap(get(), threshold, other.get(), other_threshold, &measure));
    return measure;
}
inline std::vector<float> Grid::draw_points(uint32_t n_points, const Field &weight, uint64_t seed, Ref<tree_control> control) const {
    std::vector<float> points(3 * static_cast<size_t>(n_points));
    if (!(detail::done(tree_grid_draw_points(get(), n_points, weight.function(), weight.user(), seed, control, points.data(), points.size()), weight, control))) { points.clear(); }
    return points;
}
inline bool Grid::draw_points(uint32_t n_points, const Field &weight, uint64_t seed, Ref<tree_control> control, Span<float> points) const {
    return detail::done(tree_grid_draw_points(get(), n_points, weight.function(), weight.user(), seed, control, points.data(), points.size()), weight, control);
}
inline Matte Matte::paint(Span<const tree_density_stroke> strokes, Ref<tree_control> control) const {
    Matte painted;
    detail::done(tree_matte_paint(get(), strokes.data(), strokes.size(), control, painted.place()), control);
    return painted;
}
inline Grid Grid::paint(Span<const tree_density_brush> brushes, Ref<tree_control> control) const {
    Grid painted;
    detail::done(tree_grid_paint(get(), brushes.data(), brushes.size(), control, painted.place()), control);
    return painted;
}
inline bool DensityParams::check() const {
    return detail::done(tree_density_params_check(this));
}
inline bool FieldParams::check() const {
    return detail::done(tree_field_params_check(this));
}
inline float FieldParams::blend_at(float distance) const {
    float measure{};
    detail::done(tree_field_params_blend_at(this, distance, &measure));
    return measure;
}
inline DirectionField DirectionField::make(const Attractor &attractor, float width, float height, float base_x, float base_y, Ref<tree_field_params> params, Ref<tree_control> control) {
    DirectionField field;
    detail::done(tree_direction_field_new(attractor.get(), width, height, base_x, base_y, params, control, field.place()), control);
    return field;
}
inline DirectionFieldColumns DirectionField::view() const & {
    DirectionFieldColumns columns;
    if (!(detail::done(tree_direction_field_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline std::vector<float> DirectionField::sample(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<float> directions(spots.size());
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_direction_field_sample(get(), spots.data(), spots.size() / 2, control, directions.data(), directions.size()), control))) { directions.clear(); }
    return directions;
}
inline bool DirectionField::sample(Span<const float> spots, Ref<tree_control> control, Span<float> directions) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_direction_field_sample(get(), spots.data(), spots.size() / 2, control, directions.data(), directions.size()), control);
}
inline Photo DirectionField::picture() const {
    Photo picture;
    detail::done(tree_direction_field_picture(get(), picture.place()));
    return picture;
}
inline Photo DirectionField::draw_over(const Photo &photo, uint32_t color) const {
    Photo drawn;
    detail::done(tree_direction_field_draw_over(get(), photo.get(), color, drawn.place()));
    return drawn;
}
inline Skeleton Traces::grow_wood(float height, float trunk_radius, Ref<tree_finish_params> params, Ref<tree_control> control) const {
    Skeleton wood;
    detail::done(tree_traces_grow_wood(get(), height, trunk_radius, params, control, wood.place()), control);
    return wood;
}
inline Tree Skeleton::grow_crown(const Grid &density, Span<const tree_particle_view> views, float height, Ref<tree_finish_params> params, uint64_t seed, Ref<tree_control> control, tree_crown_report *report) const {
    Tree tree;
    detail::done(tree_skeleton_grow_crown(get(), density.get(), views.data(), views.size(), height, params, seed, control, report, tree.place()), control);
    return tree;
}
inline FinishParams finish_params_find(std::string_view name) {
    FinishParams params;
    if (!(detail::done(tree_finish_params_find(name.data() ? name.data() : "", name.size(), &params, sizeof(tree_finish_params))))) { params.struct_size = 0; }
    return params;
}
inline FinishParams finish_params_of(std::string_view name) {
    FinishParams params;
    if (!(detail::done(tree_finish_params_of(name.data() ? name.data() : "", name.size(), &params, sizeof(tree_finish_params))))) { params.struct_size = 0; }
    return params;
}
inline bool FinishParams::check() const {
    return detail::done(tree_finish_params_check(this));
}
inline bool FlowParams::check() const {
    return detail::done(tree_flow_params_check(this));
}
inline Traces Traces::flow(const Way &way, Span<const tree_flow_view> views, Span<const float> starts, float height, Ref<tree_flow_params> params, Ref<tree_control> control, tree_flow_report *report) {
    Traces traces;
    static_cast<void>(detail::expect(starts.size() % 3 == 0, TREE_ERROR_BUFFER, "starts: must have 3 numbers for each item")
        && detail::done(tree_traces_flow(way.get(), views.data(), views.size(), starts.data(), starts.size() / 3, height, params, control, report, traces.place()), control));
    return traces;
}
inline TracesColumns Traces::view() const & {
    TracesColumns columns;
    if (!(detail::done(tree_traces_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Skeleton Traces::skeleton(Ref<tree_control> control) const {
    Skeleton skeleton;
    detail::done(tree_traces_skeleton(get(), control, skeleton.place()), control);
    return skeleton;
}
inline Way Way::make(const Grid &density, Ref<tree_flow_params> params, Ref<tree_control> control) {
    Way way;
    detail::done(tree_way_new(density.get(), params, control, way.place()), control);
    return way;
}
inline Grid Way::costs() const {
    Grid grid;
    detail::done(tree_way_costs(get(), grid.place()));
    return grid;
}
inline std::vector<float> Way::sample(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> directions(points.size());
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_way_sample(get(), points.data(), points.size() / 3, control, directions.data(), directions.size()), control))) { directions.clear(); }
    return directions;
}
inline bool Way::sample(Span<const float> points, Ref<tree_control> control, Span<float> directions) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_way_sample(get(), points.data(), points.size() / 3, control, directions.data(), directions.size()), control);
}
inline std::vector<float> Way::directions(Span<const tree_flow_view> views, Span<const float> points, Ref<tree_flow_params> params, Ref<tree_control> control) const {
    std::vector<float> directions(points.size());
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_way_directions(get(), views.data(), views.size(), points.data(), points.size() / 3, params, control, directions.data(), directions.size()), control))) { directions.clear(); }
    return directions;
}
inline bool Way::directions(Span<const tree_flow_view> views, Span<const float> points, Ref<tree_flow_params> params, Ref<tree_control> control, Span<float> directions) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_way_directions(get(), views.data(), views.size(), points.data(), points.size() / 3, params, control, directions.data(), directions.size()), control);
}
inline Grid Grid::make(const Floats<3> &corner, float voxel, uint32_t nx, uint32_t ny, uint32_t nz, Span<const float> values, Ref<tree_control> control) {
    Grid grid;
    detail::done(tree_grid_new(corner, voxel, nx, ny, nz, values.data(), values.size(), control, grid.place()), control);
    return grid;
}
inline GridColumns Grid::view() const & {
    GridColumns columns;
    if (!(detail::done(tree_grid_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline std::array<float, 6> Grid::bounds() const {
    std::array<float, 6> min_max{};
    detail::done(tree_grid_bounds(get(), reinterpret_cast<float(*)[6]>(min_max.data())));
    return min_max;
}
inline size_t Grid::index(int32_t x, int32_t y, int32_t z) const {
    size_t index{};
    detail::done(tree_grid_index(get(), x, y, z, &index));
    return index;
}
inline std::array<int32_t, 3> Grid::voxel_at(const Floats<3> &point) const {
    std::array<int32_t, 3> voxel{};
    detail::done(tree_grid_voxel_at(get(), point, reinterpret_cast<int32_t(*)[3]>(voxel.data())));
    return voxel;
}
inline std::vector<float> Grid::sample(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> values(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_grid_sample(get(), points.data(), points.size() / 3, control, values.data(), values.size()), control))) { values.clear(); }
    return values;
}
inline bool Grid::sample(Span<const float> points, Ref<tree_control> control, Span<float> values) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_grid_sample(get(), points.data(), points.size() / 3, control, values.data(), values.size()), control);
}
inline std::vector<float> Grid::nearest(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> values(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_grid_nearest(get(), points.data(), points.size() / 3, control, values.data(), values.size()), control))) { values.clear(); }
    return values;
}
inline bool Grid::nearest(Span<const float> points, Ref<tree_control> control, Span<float> values) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_grid_nearest(get(), points.data(), points.size() / 3, control, values.data(), values.size()), control);
}
inline PhotoSession PhotoSession::make(Span<const tree_photo_shot> shots, Ref<tree_photo_params> params, uint64_t seed, Ref<tree_control> control) {
    PhotoSession session;
    detail::done(tree_photo_session_new(shots.data(), shots.size(), params, seed, control, session.place()), control);
    return session;
}
inline PhotoSession PhotoSession::copy() const {
    PhotoSession copy;
    detail::done(tree_photo_session_copy(get(), copy.place()));
    return copy;
}
inline bool PhotoSession::set_seed(uint64_t seed) const {
    return detail::done(tree_photo_session_set_seed(get(), seed));
}
inline bool PhotoSession::set_params(Ref<tree_photo_params> params, Ref<tree_control> control) const {
    return detail::done(tree_photo_session_set_params(get(), params, control), control);
}
inline bool PhotoSession::set_placing(size_t view, Ref<tree_photo_placing> placing) const {
    return detail::done(tree_photo_session_set_placing(get(), view, placing));
}
inline bool PhotoSession::paint(size_t view, Span<const tree_density_stroke> strokes, Ref<tree_control> control) const {
    return detail::done(tree_photo_session_paint(get(), view, strokes.data(), strokes.size(), control), control);
}
inline bool PhotoSession::set_matte(size_t view, const Matte &matte) const {
    return detail::done(tree_photo_session_set_matte(get(), view, matte.get()));
}
inline bool PhotoSession::paint_volume(Span<const tree_density_brush> brushes, Ref<tree_control> control) const {
    return detail::done(tree_photo_session_paint_volume(get(), brushes.data(), brushes.size(), control), control);
}
inline bool PhotoSession::set_density(const Grid &density) const {
    return detail::done(tree_photo_session_set_density(get(), density.get()));
}
inline bool PhotoSession::set_branches(size_t view, Ref<tree_photo_branches> branches, Ref<tree_control> control) const {
    return detail::done(tree_photo_session_set_branches(get(), view, branches, control), control);
}
inline bool PhotoSession::edit_attractor(size_t view, const Attractor &attractor, Ref<tree_control> control) const {
    return detail::done(tree_photo_session_edit_attractor(get(), view, attractor.get(), control), control);
}
inline bool PhotoSession::redo_from(tree_photo_stage stage) const {
    return detail::done(tree_photo_session_redo_from(get(), stage));
}
inline size_t PhotoSession::count() const {
    size_t n_shots{};
    detail::done(tree_photo_session_count(get(), &n_shots));
    return n_shots;
}
inline size_t PhotoSession::count_views(Ref<tree_control> control) const {
    size_t n_views{};
    detail::done(tree_photo_session_count_views(get(), control, &n_views), control);
    return n_views;
}
inline uint64_t PhotoSession::seed() const {
    uint64_t seed{};
    detail::done(tree_photo_session_seed(get(), &seed));
    return seed;
}
inline PhotoParams PhotoSession::get_params() const & {
    PhotoParams params;
    if (!(detail::done(tree_photo_session_get_params(get(), &params)))) { params.struct_size = 0; }
    return params;
}
inline uint32_t PhotoSession::runs(tree_photo_stage stage) const {
    uint32_t n_runs{};
    detail::done(tree_photo_session_runs(get(), stage, &n_runs));
    return n_runs;
}
inline Matte PhotoSession::matte(size_t view) const {
    Matte matte;
    detail::done(tree_photo_session_matte(get(), view, matte.place()));
    return matte;
}
inline Photo PhotoSession::photo(size_t view) const {
    Photo photo;
    detail::done(tree_photo_session_photo(get(), view, photo.place()));
    return photo;
}
inline ParticleCamera PhotoSession::camera(size_t view, Ref<tree_control> control) const {
    ParticleCamera camera;
    if (!(detail::done(tree_photo_session_camera(get(), view, control, &camera), control))) { camera.struct_size = 0; }
    return camera;
}
inline Attractor PhotoSession::attractor(size_t view, Ref<tree_control> control) const {
    Attractor attractor;
    detail::done(tree_photo_session_attractor(get(), view, control, attractor.place()), control);
    return attractor;
}
inline Strokes PhotoSession::strokes(size_t view, Ref<tree_control> control) const {
    Strokes strokes;
    detail::done(tree_photo_session_strokes(get(), view, control, strokes.place()), control);
    return strokes;
}
inline Grid PhotoSession::density(Ref<tree_control> control) const {
    Grid density;
    detail::done(tree_photo_session_density(get(), control, density.place()), control);
    return density;
}
inline DirectionField PhotoSession::field(size_t view, Ref<tree_control> control) const {
    DirectionField field;
    detail::done(tree_photo_session_field(get(), view, control, field.place()), control);
    return field;
}
inline Traces PhotoSession::traces(Ref<tree_control> control) const {
    Traces traces;
    detail::done(tree_photo_session_traces(get(), control, traces.place()), control);
    return traces;
}
inline Skeleton PhotoSession::wood(Ref<tree_control> control) const {
    Skeleton wood;
    detail::done(tree_photo_session_wood(get(), control, wood.place()), control);
    return wood;
}
inline Tree PhotoSession::tree(Ref<tree_control> control, tree_photo_report *report) const {
    Tree tree;
    detail::done(tree_photo_session_tree(get(), control, report, tree.place()), control);
    return tree;
}
inline PhotoViewReport PhotoSession::view_report(size_t view, Ref<tree_control> control) const {
    PhotoViewReport report;
    if (!(detail::done(tree_photo_session_view_report(get(), view, control, &report), control))) { report.struct_size = 0; }
    return report;
}
inline bool PhotoSession::gaps(size_t view, Ref<tree_control> control, Span<float> gaps) const {
    return detail::done(tree_photo_session_gaps(get(), view, control, gaps.data(), gaps.size()), control);
}
inline size_t PhotoSession::disagreements(Ref<tree_control> control, Span<tree_align_warning> warnings) const {
    size_t n_warnings{};
    detail::done(tree_photo_session_disagreements(get(), control, warnings.data(), warnings.size(), &n_warnings), control);
    return n_warnings;
}
inline Lines PhotoSession::warnings(Ref<tree_control> control) const {
    Lines warnings;
    detail::done(tree_photo_session_warnings(get(), control, warnings.place()), control);
    return warnings;
}
inline bool PhotoParams::check(Ref<tree_control> control) const {
    return detail::done(tree_photo_params_check(this, control), control);
}
inline Photo PhotoSession::draw_matte(size_t view) const {
    Photo picture;
    detail::done(tree_photo_session_draw_matte(get(), view, picture.place()));
    return picture;
}
inline Photo PhotoSession::draw_attractor(size_t view, Ref<tree_control> control) const {
    Photo picture;
    detail::done(tree_photo_session_draw_attractor(get(), view, control, picture.place()), control);
    return picture;
}
inline Photo PhotoSession::draw_field(size_t view, Ref<tree_control> control) const {
    Photo picture;
    detail::done(tree_photo_session_draw_field(get(), view, control, picture.place()), control);
    return picture;
}
inline Photo PhotoSession::draw_traces(size_t view, Ref<tree_control> control) const {
    Photo picture;
    detail::done(tree_photo_session_draw_traces(get(), view, control, picture.place()), control);
    return picture;
}
inline Photo PhotoSession::draw_density(Ref<tree_control> control) const {
    Photo picture;
    detail::done(tree_photo_session_draw_density(get(), control, picture.place()), control);
    return picture;
}
inline Tree from_photos(Span<const tree_photo_shot> shots, Ref<tree_photo_params> params, uint64_t seed, Ref<tree_control> control, tree_photo_report *report) {
    Tree tree;
    detail::done(tree_from_photos(shots.data(), shots.size(), params, seed, control, report, tree.place()), control);
    return tree;
}
inline Graph Graph::link(const GraphNodes &nodes, Ref<tree_link_params> params, uint64_t seed, Ref<tree_control> control) {
    Graph graph;
    detail::done(tree_graph_link(nodes.get(), params, seed, control, graph.place()), params, control);
    return graph;
}
inline Graph Graph::from_edges(Span<const float> positions, Span<const uint32_t> edges, Span<const float> costs, Ref<tree_control> control) {
    Graph graph;
    static_cast<void>(detail::expect(positions.size() % 3 == 0, TREE_ERROR_BUFFER, "positions: must have 3 numbers for each item")
        && detail::expect(edges.size() % 2 == 0, TREE_ERROR_BUFFER, "edges: must have 2 numbers for each item")
        && detail::expect(edges.size() / 2 == costs.size(), TREE_ERROR_BUFFER, "edges and costs must be of one length")
        && detail::done(tree_graph_from_edges(positions.data(), positions.size() / 3, edges.data(), costs.data(), edges.size() / 2, control, graph.place()), control));
    return graph;
}
inline GraphColumns Graph::view() const & {
    GraphColumns columns;
    if (!(detail::done(tree_graph_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline std::tuple<std::vector<float>, std::vector<uint32_t>> Graph::search(uint32_t root, Ref<tree_control> control) const {
    std::vector<float> costs(view().n_nodes);
    std::vector<uint32_t> predecessors(view().n_nodes);
    if (!(detail::done(tree_graph_search(get(), root, control, costs.data(), predecessors.data(), detail::shortest({{costs.data(), costs.size()}, {predecessors.data(), predecessors.size()}})), control))) { costs.clear(); predecessors.clear(); }
    return {std::move(costs), std::move(predecessors)};
}
inline bool Graph::search(uint32_t root, Ref<tree_control> control, Span<float> costs, Span<uint32_t> predecessors) const {
    return detail::done(tree_graph_search(get(), root, control, costs.data(), predecessors.data(), detail::shortest({{costs.data(), costs.size()}, {predecessors.data(), predecessors.size()}})), control);
}
inline Tree path_grow(Ref<tree_path_params> params, uint64_t seed, Ref<tree_control> control, tree_path_report *report) {
    Tree tree;
    detail::done(tree_path_grow(params, seed, control, report, tree.place()), params, control);
    return tree;
}
inline std::tuple<Bytes, Tree> path_grow_with_levels(Ref<tree_path_params> params, uint64_t seed, Ref<tree_control> control, tree_path_report *report) {
    Bytes node_levels;
    Tree tree;
    detail::done(tree_path_grow_with_levels(params, seed, control, report, node_levels.place(), tree.place()), params, control);
    return {std::move(node_levels), std::move(tree)};
}
inline GraphNodes Volume::graph_strew(Ref<tree_strew_params> params, uint64_t seed, Ref<tree_control> control) const {
    GraphNodes nodes;
    detail::done(tree_graph_strew(get(), params, seed, control, nodes.place()), control);
    return nodes;
}
inline GraphNodesColumns GraphNodes::view() const & {
    GraphNodesColumns columns;
    if (!(detail::done(tree_graph_nodes_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline bool PathParams::check(Ref<tree_control> control) const {
    return detail::done(tree_path_params_check(this, control), control);
}
inline float path_level_radius(Ref<tree_path_params> params, size_t index) {
    float radius{};
    detail::done(tree_path_level_radius(params, index, &radius), params);
    return radius;
}
inline size_t path_preset_count() {
    return tree_path_preset_count();
}
inline std::tuple<std::string_view, std::string_view> path_preset_name(size_t index) {
    tree_str name{};
    tree_str title{};
    detail::done(tree_path_preset_name(index, &name, &title));
    return {detail::text(name), detail::text(title)};
}
inline float path_preset_paper_seconds(size_t index) {
    float seconds{};
    detail::done(tree_path_preset_paper_seconds(index, &seconds));
    return seconds;
}
inline PathParams path_preset(std::string_view name) {
    PathParams params;
    if (!(detail::done(tree_path_preset(name.data() ? name.data() : "", name.size(), &params, sizeof(tree_path_params))))) { params.struct_size = 0; }
    return params;
}
inline Profile Profile::from_svg(std::string_view svg, Ref<tree_profile_options> options, Ref<tree_control> control) {
    Profile profile;
    detail::done(tree_profile_from_svg(svg.data() ? svg.data() : "", svg.size(), options, control, profile.place()), control);
    return profile;
}
inline ProfileColumns Profile::view() const & {
    ProfileColumns columns;
    if (!(detail::done(tree_profile_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Volume Profile::volume(const Floats<3> &base) const {
    Volume volume;
    detail::done(tree_profile_volume(get(), base, volume.place()));
    return volume;
}
inline Volume Volume::from_svg(std::string_view svg, Ref<tree_profile_options> options, const Floats<3> &base, Ref<tree_control> control) {
    Volume volume;
    detail::done(tree_volume_from_svg(svg.data() ? svg.data() : "", svg.size(), options, base, control, volume.place()), control);
    return volume;
}
inline bool Volume::obstacle_is_free(float clearance, const Floats<3> &a, const Floats<3> &b) const {
    uint32_t is_free = 0;
    detail::done(tree_obstacle_is_free(get(), clearance, a, b, &is_free));
    return is_free != 0;
}
inline Lines align_warnings_text(Span<const tree_align_warning> warnings) {
    Lines lines;
    detail::done(tree_align_warnings_text(warnings.data(), warnings.size(), lines.place()));
    return lines;
}
inline std::tuple<ParticleCamera, AlignReport> Matte::align(Ref<tree_align_params> params, Ref<tree_control> control) const {
    ParticleCamera camera;
    AlignReport report;
    if (!(detail::done(tree_align(get(), params, control, &camera, &report), control))) { camera.struct_size = 0; report.struct_size = 0; }
    return {std::move(camera), std::move(report)};
}
inline Aligned align_all(const Handles<tree_matte> &mattes, Span<const tree_align_params> params, float height, Ref<tree_control> control) {
    Aligned aligned;
    static_cast<void>(detail::expect(mattes.size() == params.size(), TREE_ERROR_BUFFER, "mattes and params must be of one length")
        && detail::done(tree_align_all(mattes.data(), params.data(), mattes.size(), height, control, aligned.place()), control));
    return aligned;
}
inline size_t Aligned::count() const {
    size_t n_views{};
    detail::done(tree_aligned_count(get(), &n_views));
    return n_views;
}
inline std::tuple<ParticleCamera, AlignReport> Aligned::camera(size_t index) const {
    ParticleCamera camera;
    AlignReport report;
    if (!(detail::done(tree_aligned_camera(get(), index, &camera, &report)))) { camera.struct_size = 0; report.struct_size = 0; }
    return {std::move(camera), std::move(report)};
}
inline Span<const tree_align_warning> Aligned::warnings() const & {
    const tree_align_warning *warnings = nullptr;
    size_t n_warnings = 0;
    detail::done(tree_aligned_warnings(get(), &warnings, &n_warnings));
    return Span<const tree_align_warning>(warnings, n_warnings);
}
inline Attractor Attractor::from_columns(Ref<tree_attractor_columns> columns, Ref<tree_control> control) {
    Attractor attractor;
    detail::done(tree_attractor_from_columns(columns, control, attractor.place()), control);
    return attractor;
}
inline AttractorColumns Attractor::view() const & {
    AttractorColumns columns;
    if (!(detail::done(tree_attractor_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline AttractorNearestPoint Attractor::nearest(const Floats<2> &at_pixel) const {
    AttractorNearestPoint nearest;
    if (!(detail::done(tree_attractor_nearest(get(), at_pixel, &nearest)))) { nearest.struct_size = 0; }
    return nearest;
}
inline float Attractor::length() const {
    float length{};
    detail::done(tree_attractor_length(get(), &length));
    return length;
}
inline Rows Attractor::tips() const {
    Rows tips;
    detail::done(tree_attractor_tips(get(), tips.place()));
    return tips;
}
inline Photo Attractor::draw(const Photo &photo, float width, uint32_t rgba) const {
    Photo drawn;
    detail::done(tree_attractor_draw(get(), photo.get(), width, rgba, drawn.place()));
    return drawn;
}
inline std::tuple<Trimap, Lines, Matte> Matte::automatic(const Photo &photo, Ref<tree_automatic_params> params, Ref<tree_control> control, tree_automatic_report *report) {
    Trimap trimap;
    Lines warnings;
    Matte matte;
    detail::done(tree_matte_automatic(photo.get(), params, control, report, trimap.place(), warnings.place(), matte.place()), control);
    return {std::move(trimap), std::move(warnings), std::move(matte)};
}
inline bool ParticleCamera::check() const {
    return detail::done(tree_particle_camera_check(this));
}
inline std::tuple<std::array<float, 3>, std::array<float, 3>, std::array<float, 3>> ParticleCamera::frame() const {
    std::array<float, 3> right{};
    std::array<float, 3> up{};
    std::array<float, 3> forward{};
    detail::done(tree_particle_camera_frame(this, reinterpret_cast<float(*)[3]>(right.data()), reinterpret_cast<float(*)[3]>(up.data()), reinterpret_cast<float(*)[3]>(forward.data())));
    return {std::move(right), std::move(up), std::move(forward)};
}
inline Photo Photo::draw(Span<const tree_mark> marks, Ref<tree_control> control) const {
    Photo drawn;
    detail::done(tree_photo_draw(get(), marks.data(), marks.size(), control, drawn.place()), control);
    return drawn;
}
inline Photo Photo::blank(uint32_t width, uint32_t height, uint32_t rgba, Ref<tree_control> control) {
    Photo photo;
    detail::done(tree_photo_blank(width, height, rgba, control, photo.place()), control);
    return photo;
}
inline Photo Photo::of_matte(const Matte &matte) {
    Photo photo;
    detail::done(tree_photo_of_matte(matte.get(), photo.place()));
    return photo;
}
inline std::tuple<float, Attractor> Attractor::add_stroke(Span<const float> stroke, Ref<tree_stroke_params> params, Ref<tree_control> control, tree_stroke_report *report) const {
    float gap{};
    Attractor changed;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_attractor_add_stroke(get(), stroke.data(), stroke.size() / 2, params, control, report, &gap, changed.place()), control));
    return {std::move(gap), std::move(changed)};
}
inline Attractor Attractor::erase(Span<const float> eraser, float radius, tree_cut_off cut_off, tree_erase_report *report) const {
    Attractor changed;
    static_cast<void>(detail::expect(eraser.size() % 2 == 0, TREE_ERROR_BUFFER, "eraser: must have 2 numbers for each item")
        && detail::done(tree_attractor_erase(get(), eraser.data(), eraser.size() / 2, radius, cut_off, report, changed.place())));
    return changed;
}
inline Attractor Attractor::move_near(const Floats<2> &at_pixel, const Floats<2> &by_pixels, float radius) const {
    Attractor changed;
    detail::done(tree_attractor_move_near(get(), at_pixel, by_pixels, radius, changed.place()));
    return changed;
}
inline Attractor Attractor::mirrored(float width) const {
    Attractor changed;
    detail::done(tree_attractor_mirrored(get(), width, changed.place()));
    return changed;
}
inline Span<const tree_str> Lines::view() const & {
    const tree_str *texts = nullptr;
    size_t n_texts = 0;
    detail::done(tree_lines_view(get(), &texts, &n_texts));
    return Span<const tree_str>(texts, n_texts);
}
inline Attractor Attractor::livewire(const Matte &matte, Maybe<tree_photo> photo, const Floats<2> &base_pixel, Span<const float> seeds, Ref<tree_livewire_params> params, Ref<tree_control> control, tree_livewire_report *report) {
    Attractor attractor;
    static_cast<void>(detail::expect(photo.fits(), TREE_ERROR_NULL, "photo: empty; leave it out, or hand over nullptr")
        && detail::expect(seeds.size() % 2 == 0, TREE_ERROR_BUFFER, "seeds: must have 2 numbers for each item")
        && detail::done(tree_attractor_livewire(matte.get(), photo, base_pixel, seeds.data(), seeds.size() / 2, params, control, report, attractor.place()), control));
    return attractor;
}
inline std::tuple<std::vector<float>, size_t> Matte::seeds(const Floats<2> &base_pixel, uint32_t most, Ref<tree_seed_params> params, uint64_t seed, Ref<tree_control> control) const {
    std::vector<float> seeds(2 * static_cast<size_t>(most));
    size_t n_seeds{};
    if (!(detail::done(tree_matte_seeds(get(), base_pixel, most, params, seed, control, seeds.data(), seeds.size(), &n_seeds), control))) { seeds.clear(); }
    seeds.resize(2 * n_seeds);
    return {std::move(seeds), std::move(n_seeds)};
}
inline size_t Matte::seeds(const Floats<2> &base_pixel, uint32_t most, Ref<tree_seed_params> params, uint64_t seed, Ref<tree_control> control, Span<float> seeds) const {
    size_t n_seeds{};
    detail::done(tree_matte_seeds(get(), base_pixel, most, params, seed, control, seeds.data(), seeds.size(), &n_seeds), control);
    return n_seeds;
}
inline Matte Matte::from_alpha(uint32_t width, uint32_t height, Span<const float> alpha, Ref<tree_control> control) {
    Matte matte;
    detail::done(tree_matte_from_alpha(width, height, alpha.data(), alpha.size(), control, matte.place()), control);
    return matte;
}
inline Matte Matte::of_photo(const Photo &photo) {
    Matte matte;
    detail::done(tree_matte_of_photo(photo.get(), matte.place()));
    return matte;
}
inline MatteColumns Matte::view() const & {
    MatteColumns columns;
    if (!(detail::done(tree_matte_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline std::vector<float> Matte::sample(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<float> values(spots.size() / 2);
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_matte_sample(get(), spots.data(), spots.size() / 2, control, values.data(), values.size()), control))) { values.clear(); }
    return values;
}
inline bool Matte::sample(Span<const float> spots, Ref<tree_control> control, Span<float> values) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_matte_sample(get(), spots.data(), spots.size() / 2, control, values.data(), values.size()), control);
}
inline Matte Matte::mirrored() const {
    Matte mirrored;
    detail::done(tree_matte_mirrored(get(), mirrored.place()));
    return mirrored;
}
inline std::tuple<ParticleCamera, Photo, Matte> Matte::turned(Maybe<tree_photo> photo, Ref<tree_particle_camera> camera) const {
    ParticleCamera turned_camera;
    Photo turned_photo;
    Matte turned;
    if (!(detail::expect(photo.fits(), TREE_ERROR_NULL, "photo: empty; leave it out, or hand over nullptr")
        && detail::done(tree_matte_turned(get(), photo, camera, &turned_camera, turned_photo.place(), turned.place())))) { turned_camera.struct_size = 0; }
    return {std::move(turned_camera), std::move(turned_photo), std::move(turned)};
}
inline Bytes Matte::to_png() const {
    Bytes bytes;
    detail::done(tree_matte_to_png(get(), bytes.place()));
    return bytes;
}
inline bool Matte::write_png(std::string_view path) const {
    return detail::done(tree_matte_write_png(get(), path.data() ? path.data() : "", path.size()));
}
inline std::tuple<Lines, Matte> Matte::natural(const Photo &photo, const Trimap &trimap, Ref<tree_natural_params> params, Ref<tree_control> control, tree_natural_report *report) {
    Lines warnings;
    Matte matte;
    detail::done(tree_matte_natural(photo.get(), trimap.get(), params, control, report, warnings.place(), matte.place()), control);
    return {std::move(warnings), std::move(matte)};
}
inline Matte Matte::screen(const Photo &photo, Ref<tree_screen_params> params, Ref<tree_control> control) {
    Matte matte;
    detail::done(tree_matte_screen(photo.get(), params, control, matte.place()), control);
    return matte;
}
inline Matte Matte::difference(const Photo &photo, const Photo &plate, Ref<tree_difference_params> params, Ref<tree_control> control) {
    Matte matte;
    detail::done(tree_matte_difference(photo.get(), plate.get(), params, control, matte.place()), control);
    return matte;
}
inline Photo Photo::from_pixels(uint32_t width, uint32_t height, Span<const uint8_t> pixels, Ref<tree_control> control) {
    Photo photo;
    detail::done(tree_photo_from_pixels(width, height, pixels.data(), pixels.size(), control, photo.place()), control);
    return photo;
}
inline Photo Photo::read(std::string_view path, Ref<tree_control> control) {
    Photo photo;
    detail::done(tree_photo_read(path.data() ? path.data() : "", path.size(), control, photo.place()), control);
    return photo;
}
inline Photo Photo::from_bytes(Span<const uint8_t> data, Ref<tree_control> control) {
    Photo photo;
    detail::done(tree_photo_from_bytes(data.data(), data.size(), control, photo.place()), control);
    return photo;
}
inline Pixels Photo::view() const & {
    Pixels pixels;
    if (!(detail::done(tree_photo_view(get(), &pixels)))) { pixels.struct_size = 0; }
    return pixels;
}
inline bool Photo::has_alpha() const {
    uint32_t is_translucent = 0;
    detail::done(tree_photo_has_alpha(get(), &is_translucent));
    return is_translucent != 0;
}
inline Photo Photo::mirrored() const {
    Photo mirrored;
    detail::done(tree_photo_mirrored(get(), mirrored.place()));
    return mirrored;
}
inline Bytes Photo::to_png() const {
    Bytes bytes;
    detail::done(tree_photo_to_png(get(), bytes.place()));
    return bytes;
}
inline bool Photo::write_png(std::string_view path) const {
    return detail::done(tree_photo_write_png(get(), path.data() ? path.data() : "", path.size()));
}
inline std::vector<float> ParticleCamera::project(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> spots(points.size() / 3 * 2);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_particle_camera_project(this, points.data(), points.size() / 3, control, spots.data(), spots.size()), control))) { spots.clear(); }
    return spots;
}
inline bool ParticleCamera::project(Span<const float> points, Ref<tree_control> control, Span<float> spots) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_particle_camera_project(this, points.data(), points.size() / 3, control, spots.data(), spots.size()), control);
}
inline std::vector<float> ParticleCamera::pixel_sizes(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> sizes(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_particle_camera_pixel_sizes(this, points.data(), points.size() / 3, control, sizes.data(), sizes.size()), control))) { sizes.clear(); }
    return sizes;
}
inline bool ParticleCamera::pixel_sizes(Span<const float> points, Ref<tree_control> control, Span<float> sizes) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_particle_camera_pixel_sizes(this, points.data(), points.size() / 3, control, sizes.data(), sizes.size()), control);
}
inline std::vector<float> ParticleCamera::rays(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<float> rays(spots.size() / 2 * 6);
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_particle_camera_rays(this, spots.data(), spots.size() / 2, control, rays.data(), rays.size()), control))) { rays.clear(); }
    return rays;
}
inline bool ParticleCamera::rays(Span<const float> spots, Ref<tree_control> control, Span<float> rays) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_particle_camera_rays(this, spots.data(), spots.size() / 2, control, rays.data(), rays.size()), control);
}
inline ParticleStand ParticleCamera::stand() const {
    ParticleStand stand;
    if (!(detail::done(tree_particle_camera_stand(this, &stand)))) { stand.struct_size = 0; }
    return stand;
}
inline View ParticleCamera::view() const {
    View view;
    if (!(detail::done(tree_particle_camera_view(this, &view)))) { view.struct_size = 0; }
    return view;
}
inline std::tuple<std::vector<float>, Attractor> Attractor::from_strokes(Ref<tree_strokes_columns> columns, const Floats<2> &base_pixel, Ref<tree_stroke_params> params, Ref<tree_control> control, tree_stroke_report *report) {
    std::vector<float> gaps(columns ? columns->n_strokes : 0);
    Attractor attractor;
    if (!(detail::done(tree_attractor_from_strokes(columns, base_pixel, params, control, report, gaps.data(), gaps.size(), attractor.place()), control))) { gaps.clear(); }
    return {std::move(gaps), std::move(attractor)};
}
inline Attractor Attractor::from_strokes(Ref<tree_strokes_columns> columns, const Floats<2> &base_pixel, Ref<tree_stroke_params> params, Ref<tree_control> control, tree_stroke_report *report, Span<float> gaps) {
    Attractor attractor;
    detail::done(tree_attractor_from_strokes(columns, base_pixel, params, control, report, gaps.data(), gaps.size(), attractor.place()), control);
    return attractor;
}
inline Strokes Strokes::from_svg(std::string_view svg, float width, float height, Ref<tree_control> control) {
    Strokes strokes;
    detail::done(tree_strokes_from_svg(svg.data() ? svg.data() : "", svg.size(), width, height, control, strokes.place()), control);
    return strokes;
}
inline StrokesColumns Strokes::view() const & {
    StrokesColumns columns;
    if (!(detail::done(tree_strokes_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Trimap Trimap::from_levels(uint32_t width, uint32_t height, Span<const uint8_t> levels, Ref<tree_control> control) {
    Trimap trimap;
    detail::done(tree_trimap_from_levels(width, height, levels.data(), levels.size(), control, trimap.place()), control);
    return trimap;
}
inline Trimap Trimap::of_photo(const Photo &photo) {
    Trimap trimap;
    detail::done(tree_trimap_of_photo(photo.get(), trimap.place()));
    return trimap;
}
inline Trimap Trimap::from_strokes(uint32_t width, uint32_t height, Span<const tree_trimap_stroke> strokes, Ref<tree_control> control) {
    Trimap trimap;
    detail::done(tree_trimap_from_strokes(width, height, strokes.data(), strokes.size(), control, trimap.place()), control);
    return trimap;
}
inline Trimap Trimap::from_colors(const Photo &photo, Ref<tree_color_samples> samples, Ref<tree_control> control) {
    Trimap trimap;
    detail::done(tree_trimap_from_colors(photo.get(), samples, control, trimap.place()), control);
    return trimap;
}
inline TrimapColumns Trimap::view() const & {
    TrimapColumns columns;
    if (!(detail::done(tree_trimap_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Adapted PlasticScene::adapted(uint64_t id, Ref<tree_control> control, tree_adapted_report *report) const {
    Adapted adapted;
    detail::done(tree_plastic_scene_adapted(get(), id, control, report, adapted.place()), control);
    return adapted;
}
inline Tree Adapted::tree() const {
    Tree tree;
    detail::done(tree_adapted_tree(get(), tree.place()));
    return tree;
}
inline AdaptedColumns Adapted::view() const & {
    AdaptedColumns columns;
    if (!(detail::done(tree_adapted_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Plastic Plastic::make(const Tree &tree, Ref<tree_plastic_params> params, Ref<tree_control> control, tree_plastic_report *report) {
    Plastic plastic;
    detail::done(tree_plastic_new(tree.get(), params, control, report, plastic.place()), control);
    return plastic;
}
inline PlasticReport Plastic::measure() const {
    PlasticReport report;
    if (!(detail::done(tree_plastic_measure(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline PlasticParams Plastic::get_params() const {
    PlasticParams params;
    if (!(detail::done(tree_plastic_get_params(get(), &params)))) { params.struct_size = 0; }
    return params;
}
inline Tree Plastic::tree() const {
    Tree tree;
    detail::done(tree_plastic_tree(get(), tree.place()));
    return tree;
}
inline PlasticColumns Plastic::view() const & {
    PlasticColumns columns;
    if (!(detail::done(tree_plastic_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline PlasticClusters PlasticClusters::of_season(const Plastic &plastic, uint32_t season) {
    PlasticClusters clusters;
    detail::done(tree_plastic_clusters_of_season(plastic.get(), season, clusters.place()));
    return clusters;
}
inline PlasticClusters PlasticScene::clusters(uint64_t id) const {
    PlasticClusters clusters;
    detail::done(tree_plastic_scene_clusters(get(), id, clusters.place()));
    return clusters;
}
inline Span<const tree_plastic_cluster> PlasticClusters::view() const & {
    const tree_plastic_cluster *rows = nullptr;
    size_t n_rows = 0;
    detail::done(tree_plastic_clusters_view(get(), &rows, &n_rows));
    return Span<const tree_plastic_cluster>(rows, n_rows);
}
inline uint64_t PlasticScene::add_tree(const Plastic &plastic, const tree_pose &pose) const {
    uint64_t id{};
    detail::done(tree_plastic_scene_add_tree(get(), plastic.get(), &pose, &id));
    return id;
}
inline bool PlasticScene::move_tree(uint64_t id, const tree_pose &pose) const {
    return detail::done(tree_plastic_scene_move_tree(get(), id, &pose));
}
inline bool PlasticScene::remove_tree(uint64_t id) const {
    return detail::done(tree_plastic_scene_remove_tree(get(), id));
}
inline uint64_t PlasticScene::add_obstacle(const Volume &volume, const tree_pose &pose) const {
    uint64_t id{};
    detail::done(tree_plastic_scene_add_obstacle(get(), volume.get(), &pose, &id));
    return id;
}
inline bool PlasticScene::move_obstacle(uint64_t id, const tree_pose &pose) const {
    return detail::done(tree_plastic_scene_move_obstacle(get(), id, &pose));
}
inline bool PlasticScene::remove_obstacle(uint64_t id) const {
    return detail::done(tree_plastic_scene_remove_obstacle(get(), id));
}
inline std::vector<tree_plastic_motion> PlasticScene::motions(uint64_t id) const {
    std::vector<tree_plastic_motion> motions([&] { const auto nodes = this->model(id).tree().skeleton(); return nodes.view().n_nodes; }());
    if (!(detail::done(tree_plastic_scene_motions(get(), id, motions.data(), motions.size())))) { motions.clear(); }
    return motions;
}
inline bool PlasticScene::motions(uint64_t id, Span<tree_plastic_motion> motions) const {
    return detail::done(tree_plastic_scene_motions(get(), id, motions.data(), motions.size()));
}
inline bool PlasticParams::check() const {
    return detail::done(tree_plastic_params_check(this));
}
inline PlasticSky PlasticScene::get_sky() const {
    PlasticSky sky;
    if (!(detail::done(tree_plastic_scene_get_sky(get(), &sky)))) { sky.struct_size = 0; }
    return sky;
}
inline PlasticResponse PlasticScene::get_response() const {
    PlasticResponse response;
    if (!(detail::done(tree_plastic_scene_get_response(get(), &response)))) { response.struct_size = 0; }
    return response;
}
inline Span<const uint64_t> PlasticScene::trees() const & {
    const uint64_t *ids = nullptr;
    size_t n_ids = 0;
    detail::done(tree_plastic_scene_trees(get(), &ids, &n_ids));
    return Span<const uint64_t>(ids, n_ids);
}
inline Span<const uint64_t> PlasticScene::obstacles() const & {
    const uint64_t *ids = nullptr;
    size_t n_ids = 0;
    detail::done(tree_plastic_scene_obstacles(get(), &ids, &n_ids));
    return Span<const uint64_t>(ids, n_ids);
}
inline Span<const uint64_t> PlasticScene::changed() const & {
    const uint64_t *ids = nullptr;
    size_t n_ids = 0;
    detail::done(tree_plastic_scene_changed(get(), &ids, &n_ids));
    return Span<const uint64_t>(ids, n_ids);
}
inline tree_pose PlasticScene::pose(uint64_t id) const {
    tree_pose pose{};
    detail::done(tree_plastic_scene_pose(get(), id, &pose));
    return pose;
}
inline Plastic PlasticScene::model(uint64_t id) const {
    Plastic plastic;
    detail::done(tree_plastic_scene_model(get(), id, plastic.place()));
    return plastic;
}
inline PlasticRegrowth Plastic::regrowth_of() const & {
    PlasticRegrowth params;
    if (!(detail::done(tree_plastic_regrowth_of(get(), &params, sizeof(tree_plastic_regrowth))))) { params.struct_size = 0; }
    return params;
}
inline std::tuple<PlasticRegrown, Tree> PlasticScene::regrown(uint64_t id, Ref<tree_plastic_regrowth> params, uint64_t seed, Ref<tree_control> control) const {
    PlasticRegrown report;
    Tree tree;
    if (!(detail::done(tree_plastic_scene_regrown(get(), id, params, seed, control, &report, tree.place()), control))) { report.struct_size = 0; }
    return {std::move(report), std::move(tree)};
}
inline PlasticScene PlasticScene::make(Ref<tree_plastic_sky> sky, Ref<tree_plastic_response> response) {
    PlasticScene scene;
    detail::done(tree_plastic_scene_new(sky, response, scene.place()));
    return scene;
}
inline PlasticScene PlasticScene::copy() const {
    PlasticScene copy;
    detail::done(tree_plastic_scene_copy(get(), copy.place()));
    return copy;
}
inline bool PlasticScene::set_sky(Ref<tree_plastic_sky> sky) const {
    return detail::done(tree_plastic_scene_set_sky(get(), sky));
}
inline bool PlasticScene::set_response(Ref<tree_plastic_response> response) const {
    return detail::done(tree_plastic_scene_set_response(get(), response));
}
inline PlasticUpdate PlasticScene::update(Ref<tree_control> control) const {
    PlasticUpdate update;
    if (!(detail::done(tree_plastic_scene_update(get(), control, &update), control))) { update.struct_size = 0; }
    return update;
}
inline std::tuple<std::vector<uint16_t>, std::vector<float>, size_t> Skeleton::ages(float internode, uint32_t most) const {
    std::vector<uint16_t> seasons(view().n_nodes);
    std::vector<float> rates(view().n_nodes);
    size_t n_seasons{};
    if (!(detail::done(tree_skeleton_ages(get(), internode, most, seasons.data(), rates.data(), detail::shortest({{seasons.data(), seasons.size()}, {rates.data(), rates.size()}}), &n_seasons)))) { seasons.clear(); rates.clear(); }
    return {std::move(seasons), std::move(rates), std::move(n_seasons)};
}
inline size_t Skeleton::ages(float internode, uint32_t most, Span<uint16_t> seasons, Span<float> rates) const {
    size_t n_seasons{};
    detail::done(tree_skeleton_ages(get(), internode, most, seasons.data(), rates.data(), detail::shortest({{seasons.data(), seasons.size()}, {rates.data(), rates.size()}}), &n_seasons));
    return n_seasons;
}
inline PlasticSky PlasticSky::towards(float azimuth, float elevation) {
    PlasticSky sky;
    if (!(detail::done(tree_plastic_sky_towards(&sky, sizeof(tree_plastic_sky), azimuth, elevation)))) { sky.struct_size = 0; }
    return sky;
}
inline Pool Pool::make(Ref<tree_pool_options> options) {
    Pool pool;
    detail::done(tree_pool_new(options, pool.place()));
    return pool;
}
inline uint32_t Pool::threads() const {
    uint32_t n_threads{};
    detail::done(tree_pool_threads(get(), &n_threads));
    return n_threads;
}
inline MaskColumns Mask::view() const & {
    MaskColumns columns;
    if (!(detail::done(tree_mask_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline std::vector<uint8_t> Mask::bits() const {
    std::vector<uint8_t> bits(view().n_pixels);
    if (!(detail::done(tree_mask_bits(get(), bits.data(), bits.size())))) { bits.clear(); }
    return bits;
}
inline bool Mask::bits(Span<uint8_t> bits) const {
    return detail::done(tree_mask_bits(get(), bits.data(), bits.size()));
}
inline Picture Mask::picture() const {
    Picture picture;
    detail::done(tree_mask_picture(get(), picture.place()));
    return picture;
}
inline Picture Picture::from_pixels(uint32_t width, uint32_t height, Span<const uint8_t> pixels, Ref<tree_control> control) {
    Picture picture;
    detail::done(tree_picture_from_pixels(width, height, pixels.data(), pixels.size(), control, picture.place()), control);
    return picture;
}
inline Pixels Picture::view() const & {
    Pixels pixels;
    if (!(detail::done(tree_picture_view(get(), &pixels)))) { pixels.struct_size = 0; }
    return pixels;
}
inline bool Picture::write_png(std::string_view path) const {
    return detail::done(tree_picture_write_png(get(), path.data() ? path.data() : "", path.size()));
}
inline Bytes Picture::to_png() const {
    Bytes bytes;
    detail::done(tree_picture_to_png(get(), bytes.place()));
    return bytes;
}
inline Picture Mesh::render(Ref<tree_view> view, Ref<tree_style> style, Ref<tree_control> control) const {
    Picture picture;
    detail::done(tree_render(get(), view, style, control, picture.place()), control);
    return picture;
}
inline Mask Mesh::render_mask(Ref<tree_view> view, Ref<tree_control> control) const {
    Mask mask;
    detail::done(tree_render_mask(get(), view, control, mask.place()), control);
    return mask;
}
inline Picture Mesh::render_silhouette(Ref<tree_view> view, Ref<tree_control> control) const {
    Picture picture;
    detail::done(tree_render_silhouette(get(), view, control, picture.place()), control);
    return picture;
}
inline Style Style::studio() {
    Style style;
    if (!(detail::done(tree_style_studio(&style, sizeof(tree_style))))) { style.struct_size = 0; }
    return style;
}
inline View View::place(const Mesh &mesh) const {
    View placed;
    if (!(detail::done(tree_view_place(this, mesh.get(), &placed)))) { placed.struct_size = 0; }
    return placed;
}
inline bool GibbsParams::check() const {
    return detail::done(tree_gibbs_params_check(this));
}
inline Arranged Arranged::make(Span<const tree_domain> domains, const tree_arrangement &arrangement, Ref<tree_gibbs_params> params, uint64_t seed, Ref<tree_control> control, tree_arranged_report *report) {
    Arranged arranged;
    detail::done(tree_arranged_new(domains.data(), domains.size(), &arrangement, params, seed, control, report, arranged.place()), control);
    return arranged;
}
inline Arranged Arranged::ready(uint32_t n, const tree_arrangement &arrangement, uint64_t variant, uint64_t seed, Ref<tree_control> control) {
    Arranged arranged;
    detail::done(tree_arranged_ready(n, &arrangement, variant, seed, control, arranged.place()), control);
    return arranged;
}
inline Span<const tree_site> Arranged::sites() const & {
    const tree_site *sites = nullptr;
    size_t n_sites = 0;
    detail::done(tree_arranged_sites(get(), &sites, &n_sites));
    return Span<const tree_site>(sites, n_sites);
}
inline Span<const float> Arranged::trace() const & {
    const float *costs = nullptr;
    size_t n_costs = 0;
    detail::done(tree_arranged_trace(get(), &costs, &n_costs));
    return Span<const float>(costs, n_costs);
}
inline Concentration sites_privileged(Span<const tree_site> sites, const tree_arrangement &arrangement, Ref<tree_control> control) {
    Concentration concentration;
    if (!(detail::done(tree_sites_privileged(sites.data(), sites.size(), &arrangement, control, &concentration), control))) { concentration.struct_size = 0; }
    return concentration;
}
inline std::vector<float> BranchingAngles::at(Span<const float> places, Ref<tree_control> control) const {
    std::vector<float> values(places.size());
    if (!(detail::done(tree_branching_angles_at(this, places.data(), places.size(), control, values.data(), values.size()), control))) { values.clear(); }
    return values;
}
inline bool BranchingAngles::at(Span<const float> places, Ref<tree_control> control, Span<float> values) const {
    return detail::done(tree_branching_angles_at(this, places.data(), places.size(), control, values.data(), values.size()), control);
}
inline std::tuple<std::vector<float>, size_t> BranchingAngles::set(float place, float angle) const {
    std::vector<float> samples(2 * this->n_samples + 8);
    size_t n_samples{};
    if (!(detail::done(tree_branching_angles_set(this, place, angle, samples.data(), samples.size(), &n_samples)))) { samples.clear(); }
    samples.resize(2 * n_samples);
    return {std::move(samples), std::move(n_samples)};
}
inline size_t BranchingAngles::set(float place, float angle, Span<float> samples) const {
    size_t n_samples{};
    detail::done(tree_branching_angles_set(this, place, angle, samples.data(), samples.size(), &n_samples));
    return n_samples;
}
inline bool BranchInferParams::check() const {
    return detail::done(tree_branch_infer_params_check(this));
}
inline std::tuple<size_t, float> branch_infer(Span<const float> parent, Maybe<tree_outline> outline, Ref<tree_branching_angles> angles, const Floats<2> &end, const Floats<2> &tangent, float from, float to, Ref<tree_branch_infer_params> params, Ref<tree_control> control, Span<float> points) {
    size_t n_points{};
    float share{};
    static_cast<void>(detail::expect(parent.size() % 2 == 0, TREE_ERROR_BUFFER, "parent: must have 2 numbers for each item")
        && detail::expect(outline.fits(), TREE_ERROR_NULL, "outline: empty; leave it out, or hand over nullptr")
        && detail::done(tree_branch_infer(parent.data(), parent.size() / 2, outline, angles, end, tangent, from, to, params, control, points.data(), points.size(), &n_points, &share), control));
    return {std::move(n_points), std::move(share)};
}
inline std::tuple<float, float, bool> branch_base(Span<const float> parent, Span<const float> branch, Ref<tree_control> control) {
    float share{};
    float angle{};
    uint32_t is_left = 0;
    static_cast<void>(detail::expect(parent.size() % 2 == 0, TREE_ERROR_BUFFER, "parent: must have 2 numbers for each item")
        && detail::expect(branch.size() % 2 == 0, TREE_ERROR_BUFFER, "branch: must have 2 numbers for each item")
        && detail::done(tree_branch_base(parent.data(), parent.size() / 2, branch.data(), branch.size() / 2, control, &share, &angle, &is_left), control));
    return {std::move(share), std::move(angle), is_left != 0};
}
inline std::tuple<std::vector<float>, size_t, Outline> branch_carry(Span<const float> branch, bool left, const Outline &outline, const tree_branch_span &span, Ref<tree_control> control, tree_branch_shape_report *report) {
    std::vector<float> points(branch.size());
    size_t n_points{};
    Outline carried;
    if (!(detail::expect(branch.size() % 2 == 0, TREE_ERROR_BUFFER, "branch: must have 2 numbers for each item")
        && detail::done(tree_branch_carry(branch.data(), branch.size() / 2, left ? 1u : 0u, outline.get(), &span, control, report, points.data(), points.size(), &n_points, carried.place()), control))) { points.clear(); }
    points.resize(2 * n_points);
    return {std::move(points), std::move(n_points), std::move(carried)};
}
inline std::tuple<size_t, Outline> branch_carry(Span<const float> branch, bool left, const Outline &outline, const tree_branch_span &span, Ref<tree_control> control, tree_branch_shape_report *report, Span<float> points) {
    size_t n_points{};
    Outline carried;
    static_cast<void>(detail::expect(branch.size() % 2 == 0, TREE_ERROR_BUFFER, "branch: must have 2 numbers for each item")
        && detail::done(tree_branch_carry(branch.data(), branch.size() / 2, left ? 1u : 0u, outline.get(), &span, control, report, points.data(), points.size(), &n_points, carried.place()), control));
    return {std::move(n_points), std::move(carried)};
}
inline bool BumpParams::check() const {
    return detail::done(tree_bump_params_check(this));
}
inline Bumps Outline::bumps(Ref<tree_bump_params> params, Ref<tree_control> control) const {
    Bumps bumps;
    detail::done(tree_outline_bumps(get(), params, control, bumps.place()), control);
    return bumps;
}
inline Span<const tree_bump> Bumps::view() const & {
    const tree_bump *rows = nullptr;
    size_t n_rows = 0;
    detail::done(tree_bumps_view(get(), &rows, &n_rows));
    return Span<const tree_bump>(rows, n_rows);
}
inline std::tuple<SilhouetteGrown, Tree> OutlinePlan::grow(Ref<tree_silhouette_grow_params> params, uint64_t seed, Ref<tree_control> control) const {
    SilhouetteGrown report;
    Tree tree;
    if (!(detail::done(tree_outline_plan_grow(get(), params, seed, control, &report, tree.place()), control))) { report.struct_size = 0; }
    return {std::move(report), std::move(tree)};
}
inline LeafOutline LeafOutline::of(const Outline &outline, const Floats<2> &base, const Floats<2> &tip) {
    LeafOutline leaf;
    detail::done(tree_leaf_outline_of(outline.get(), base, tip, leaf.place()));
    return leaf;
}
inline LeafOutline LeafOutline::guess(const Outline &outline) {
    LeafOutline leaf;
    detail::done(tree_leaf_outline_guess(outline.get(), leaf.place()));
    return leaf;
}
inline std::tuple<std::array<float, 2>, std::array<float, 2>> Outline::leaf_outline_ends() const {
    std::array<float, 2> base{};
    std::array<float, 2> tip{};
    detail::done(tree_leaf_outline_ends(get(), reinterpret_cast<float(*)[2]>(base.data()), reinterpret_cast<float(*)[2]>(tip.data())));
    return {std::move(base), std::move(tip)};
}
inline LeafOutlineColumns LeafOutline::view() const & {
    LeafOutlineColumns columns;
    if (!(detail::done(tree_leaf_outline_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline LeafModel LeafOutline::model() const {
    LeafModel model;
    detail::done(tree_leaf_outline_model(get(), model.place()));
    return model;
}
inline float line_length(Span<const float> line, Ref<tree_control> control) {
    float length{};
    static_cast<void>(detail::expect(line.size() % 2 == 0, TREE_ERROR_BUFFER, "line: must have 2 numbers for each item")
        && detail::done(tree_line_length(line.data(), line.size() / 2, control, &length), control));
    return length;
}
inline std::tuple<std::vector<float>, std::vector<float>> line_at(Span<const float> line, Span<const float> places, Ref<tree_control> control) {
    std::vector<float> points(2 * places.size());
    std::vector<float> tangents(2 * places.size());
    if (!(detail::expect(line.size() % 2 == 0, TREE_ERROR_BUFFER, "line: must have 2 numbers for each item")
        && detail::done(tree_line_at(line.data(), line.size() / 2, places.data(), places.size(), control, points.data(), tangents.data(), detail::shortest({{points.data(), points.size()}, {tangents.data(), tangents.size()}})), control))) { points.clear(); tangents.clear(); }
    return {std::move(points), std::move(tangents)};
}
inline bool line_at(Span<const float> line, Span<const float> places, Ref<tree_control> control, Span<float> points, Span<float> tangents) {
    return detail::expect(line.size() % 2 == 0, TREE_ERROR_BUFFER, "line: must have 2 numbers for each item")
        && detail::done(tree_line_at(line.data(), line.size() / 2, places.data(), places.size(), control, points.data(), tangents.data(), detail::shortest({{points.data(), points.size()}, {tangents.data(), tangents.size()}})), control);
}
inline std::tuple<std::vector<float>, std::vector<float>> line_nearest(Span<const float> line, Span<const float> spots, Ref<tree_control> control) {
    std::vector<float> shares(spots.size() / 2);
    std::vector<float> distances(spots.size() / 2);
    if (!(detail::expect(line.size() % 2 == 0, TREE_ERROR_BUFFER, "line: must have 2 numbers for each item")
        && detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_line_nearest(line.data(), line.size() / 2, spots.data(), spots.size() / 2, control, shares.data(), distances.data(), detail::shortest({{shares.data(), shares.size()}, {distances.data(), distances.size()}})), control))) { shares.clear(); distances.clear(); }
    return {std::move(shares), std::move(distances)};
}
inline bool line_nearest(Span<const float> line, Span<const float> spots, Ref<tree_control> control, Span<float> shares, Span<float> distances) {
    return detail::expect(line.size() % 2 == 0, TREE_ERROR_BUFFER, "line: must have 2 numbers for each item")
        && detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_line_nearest(line.data(), line.size() / 2, spots.data(), spots.size() / 2, control, shares.data(), distances.data(), detail::shortest({{shares.data(), shares.size()}, {distances.data(), distances.size()}})), control);
}
inline size_t line_part(Span<const float> line, float from, float to, uint32_t count, Ref<tree_control> control, Span<float> points) {
    size_t n_points{};
    static_cast<void>(detail::expect(line.size() % 2 == 0, TREE_ERROR_BUFFER, "line: must have 2 numbers for each item")
        && detail::done(tree_line_part(line.data(), line.size() / 2, from, to, count, control, points.data(), points.size(), &n_points), control));
    return n_points;
}
inline std::vector<uint8_t> Outline::contains(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<uint8_t> inside(spots.size() / 2);
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_outline_contains(get(), spots.data(), spots.size() / 2, control, inside.data(), inside.size()), control))) { inside.clear(); }
    return inside;
}
inline bool Outline::contains(Span<const float> spots, Ref<tree_control> control, Span<uint8_t> inside) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_outline_contains(get(), spots.data(), spots.size() / 2, control, inside.data(), inside.size()), control);
}
inline std::vector<float> Outline::exits(Span<const float> rays, Ref<tree_control> control) const {
    std::vector<float> exits(rays.size() / 4);
    if (!(detail::expect(rays.size() % 4 == 0, TREE_ERROR_BUFFER, "rays: must have 4 numbers for each item")
        && detail::done(tree_outline_exits(get(), rays.data(), rays.size() / 4, control, exits.data(), exits.size()), control))) { exits.clear(); }
    return exits;
}
inline bool Outline::exits(Span<const float> rays, Ref<tree_control> control, Span<float> exits) const {
    return detail::expect(rays.size() % 4 == 0, TREE_ERROR_BUFFER, "rays: must have 4 numbers for each item")
        && detail::done(tree_outline_exits(get(), rays.data(), rays.size() / 4, control, exits.data(), exits.size()), control);
}
inline std::tuple<std::vector<float>, std::vector<float>> Outline::nearest(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<float> lengths(spots.size() / 2);
    std::vector<float> distances(spots.size() / 2);
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_outline_nearest(get(), spots.data(), spots.size() / 2, control, lengths.data(), distances.data(), detail::shortest({{lengths.data(), lengths.size()}, {distances.data(), distances.size()}})), control))) { lengths.clear(); distances.clear(); }
    return {std::move(lengths), std::move(distances)};
}
inline bool Outline::nearest(Span<const float> spots, Ref<tree_control> control, Span<float> lengths, Span<float> distances) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_outline_nearest(get(), spots.data(), spots.size() / 2, control, lengths.data(), distances.data(), detail::shortest({{lengths.data(), lengths.size()}, {distances.data(), distances.size()}})), control);
}
inline std::tuple<std::vector<float>, std::vector<float>> Outline::along(Span<const float> lengths, Ref<tree_control> control) const {
    std::vector<float> points(2 * lengths.size());
    std::vector<float> tangents(2 * lengths.size());
    if (!(detail::done(tree_outline_along(get(), lengths.data(), lengths.size(), control, points.data(), tangents.data(), detail::shortest({{points.data(), points.size()}, {tangents.data(), tangents.size()}})), control))) { points.clear(); tangents.clear(); }
    return {std::move(points), std::move(tangents)};
}
inline bool Outline::along(Span<const float> lengths, Ref<tree_control> control, Span<float> points, Span<float> tangents) const {
    return detail::done(tree_outline_along(get(), lengths.data(), lengths.size(), control, points.data(), tangents.data(), detail::shortest({{points.data(), points.size()}, {tangents.data(), tangents.size()}})), control);
}
inline std::tuple<std::vector<float>, size_t> Outline::part(float from, float to) const {
    std::vector<float> points(2 * view().n_points + 4);
    size_t n_points{};
    if (!(detail::done(tree_outline_part(get(), from, to, points.data(), points.size(), &n_points)))) { points.clear(); }
    points.resize(2 * n_points);
    return {std::move(points), std::move(n_points)};
}
inline size_t Outline::part(float from, float to, Span<float> points) const {
    size_t n_points{};
    detail::done(tree_outline_part(get(), from, to, points.data(), points.size(), &n_points));
    return n_points;
}
inline std::tuple<float, float> Outline::overlap(const Outline &other) const {
    float area{};
    float iou{};
    detail::done(tree_outline_overlap(get(), other.get(), &area, &iou));
    return {std::move(area), std::move(iou)};
}
inline std::vector<uint8_t> Outline::mask(const Floats<2> &low, const Floats<2> &high, uint32_t width, uint32_t height, Ref<tree_control> control) const {
    std::vector<uint8_t> cells(static_cast<size_t>(width) * height);
    if (!(detail::done(tree_outline_mask(get(), low, high, width, height, control, cells.data(), cells.size()), control))) { cells.clear(); }
    return cells;
}
inline bool Outline::mask(const Floats<2> &low, const Floats<2> &high, uint32_t width, uint32_t height, Ref<tree_control> control, Span<uint8_t> cells) const {
    return detail::done(tree_outline_mask(get(), low, high, width, height, control, cells.data(), cells.size()), control);
}
inline bool OutlineCloseParams::check() const {
    return detail::done(tree_outline_close_params_check(this));
}
inline Outline Outline::close(Span<const float> stroke, std::string_view name, Ref<tree_outline_close_params> params, Ref<tree_control> control) {
    Outline outline;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_outline_close(stroke.data(), stroke.size() / 2, name.data() ? name.data() : "", name.size(), params, control, outline.place()), control));
    return outline;
}
inline Outline Outline::from_points(Span<const float> spots, Ref<tree_control> control) {
    Outline outline;
    static_cast<void>(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_outline_from_points(spots.data(), spots.size() / 2, control, outline.place()), control));
    return outline;
}
inline OutlineColumns Outline::view() const & {
    OutlineColumns columns;
    if (!(detail::done(tree_outline_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Span<const tree_outline_repair> Outline::repairs() const & {
    const tree_outline_repair *repairs = nullptr;
    size_t n_repairs = 0;
    detail::done(tree_outline_repairs(get(), &repairs, &n_repairs));
    return Span<const tree_outline_repair>(repairs, n_repairs);
}
inline Lines Outline::repairs_text() const {
    Lines lines;
    detail::done(tree_outline_repairs_text(get(), lines.place()));
    return lines;
}
inline Outline Outline::resampled(uint32_t n_points, Ref<tree_control> control) const {
    Outline resampled;
    detail::done(tree_outline_resampled(get(), n_points, control, resampled.place()), control);
    return resampled;
}
inline Outline Outline::transformed(const Floats<6> &affine) const {
    Outline transformed;
    detail::done(tree_outline_transformed(get(), affine, transformed.place()));
    return transformed;
}
inline bool SilhouetteParams::check() const {
    return detail::done(tree_silhouette_params_check(this));
}
inline tree_arrangement arrangement_from_text(std::string_view text) {
    tree_arrangement arrangement{};
    detail::done(tree_arrangement_from_text(text.data() ? text.data() : "", text.size(), &arrangement));
    return arrangement;
}
inline Bytes arrangement_to_text(const tree_arrangement &arrangement) {
    Bytes bytes;
    detail::done(tree_arrangement_to_text(&arrangement, bytes.place()));
    return bytes;
}
inline ArrangementNumbers arrangement_measure(const tree_arrangement &arrangement) {
    ArrangementNumbers numbers;
    if (!(detail::done(tree_arrangement_measure(&arrangement, &numbers)))) { numbers.struct_size = 0; }
    return numbers;
}
inline tree_domain domain_drawn(float along, bool left) {
    tree_domain domain{};
    detail::done(tree_domain_drawn(along, left ? 1u : 0u, &domain));
    return domain;
}
inline bool domain_contains(const tree_domain &domain, float along, float azimuth) {
    uint32_t inside = 0;
    detail::done(tree_domain_contains(&domain, along, azimuth, &inside));
    return inside != 0;
}
inline float domain_outside(const tree_domain &domain, float azimuth) {
    float angle{};
    detail::done(tree_domain_outside(&domain, azimuth, &angle));
    return angle;
}
inline OutlinePlanColumns OutlinePlan::view() const & {
    OutlinePlanColumns columns;
    if (!(detail::done(tree_outline_plan_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline size_t OutlinePlan::find(uint32_t id) const {
    size_t row{};
    detail::done(tree_outline_plan_find(get(), id, &row));
    return row;
}
inline OutlineBranch OutlinePlan::branch(uint32_t id) const & {
    OutlineBranch branch;
    if (!(detail::done(tree_outline_plan_branch(get(), id, &branch)))) { branch.struct_size = 0; }
    return branch;
}
inline OutlineSystem OutlinePlan::system(uint32_t id) const & {
    OutlineSystem system;
    if (!(detail::done(tree_outline_plan_system(get(), id, &system)))) { system.struct_size = 0; }
    return system;
}
inline std::tuple<float, Outline> OutlinePlan::section(uint32_t id, size_t section) const {
    float azimuth{};
    Outline outline;
    detail::done(tree_outline_plan_section(get(), id, section, &azimuth, outline.place()));
    return {std::move(azimuth), std::move(outline)};
}
inline Outline OutlinePlan::outline(uint32_t id) const {
    Outline outline;
    detail::done(tree_outline_plan_outline(get(), id, outline.place()));
    return outline;
}
inline uint32_t OutlinePlan::count_levels() const {
    uint32_t n_levels{};
    detail::done(tree_outline_plan_count_levels(get(), &n_levels));
    return n_levels;
}
inline std::tuple<float, LeafOutline> OutlinePlan::leaf() const {
    float length{};
    LeafOutline leaf;
    detail::done(tree_outline_plan_leaf(get(), &length, leaf.place()));
    return {std::move(length), std::move(leaf)};
}
inline OutlineDrawing OutlineDrawing::make(Span<const tree_drawn_stroke> strokes, std::string_view name, float trunk_width, Ref<tree_control> control) {
    OutlineDrawing drawing;
    detail::done(tree_outline_drawing_new(strokes.data(), strokes.size(), name.data() ? name.data() : "", name.size(), trunk_width, control, drawing.place()), control);
    return drawing;
}
inline OutlineDrawing OutlineDrawing::from_svg(std::string_view svg, Ref<tree_control> control) {
    OutlineDrawing drawing;
    detail::done(tree_outline_drawing_from_svg(svg.data() ? svg.data() : "", svg.size(), control, drawing.place()), control);
    return drawing;
}
inline OutlineDrawing OutlineDrawing::of_matte(const Matte &matte, float threshold, Ref<tree_control> control) {
    OutlineDrawing drawing;
    detail::done(tree_outline_drawing_of_matte(matte.get(), threshold, control, drawing.place()), control);
    return drawing;
}
inline OutlineDrawing OutlineDrawing::of_photo(const Photo &photo, Ref<tree_control> control) {
    OutlineDrawing drawing;
    detail::done(tree_outline_drawing_of_photo(photo.get(), control, drawing.place()), control);
    return drawing;
}
inline Matte Photo::mask(Ref<tree_control> control) const {
    Matte matte;
    detail::done(tree_photo_mask(get(), control, matte.place()), control);
    return matte;
}
inline size_t OutlineDrawing::count() const {
    size_t n_trees{};
    detail::done(tree_outline_drawing_count(get(), &n_trees));
    return n_trees;
}
inline DrawnTree OutlineDrawing::tree(size_t index) const & {
    DrawnTree tree;
    if (!(detail::done(tree_outline_drawing_tree(get(), index, &tree)))) { tree.struct_size = 0; }
    return tree;
}
inline DrawnStroke OutlineDrawing::stroke(size_t number, size_t index) const & {
    DrawnStroke stroke;
    if (!(detail::done(tree_outline_drawing_stroke(get(), number, index, &stroke)))) { stroke.struct_size = 0; }
    return stroke;
}
inline Span<const tree_drawn_repair> OutlineDrawing::repairs() const & {
    const tree_drawn_repair *repairs = nullptr;
    size_t n_repairs = 0;
    detail::done(tree_outline_drawing_repairs(get(), &repairs, &n_repairs));
    return Span<const tree_drawn_repair>(repairs, n_repairs);
}
inline Lines OutlineDrawing::repairs_text() const {
    Lines lines;
    detail::done(tree_outline_drawing_repairs_text(get(), lines.place()));
    return lines;
}
inline Revolved Revolved::of(Span<const float> axis, const Handles<tree_outline> &outlines, Span<const float> azimuths, Ref<tree_control> control) {
    Revolved revolved;
    static_cast<void>(detail::expect(axis.size() % 2 == 0, TREE_ERROR_BUFFER, "axis: must have 2 numbers for each item")
        && detail::expect(outlines.size() == azimuths.size(), TREE_ERROR_BUFFER, "outlines and azimuths must be of one length")
        && detail::done(tree_revolved_of(axis.data(), axis.size() / 2, outlines.data(), azimuths.data(), outlines.size(), control, revolved.place()), control));
    return revolved;
}
inline RevolvedFrame Revolved::view() const {
    RevolvedFrame frame;
    if (!(detail::done(tree_revolved_view(get(), &frame)))) { frame.struct_size = 0; }
    return frame;
}
inline std::vector<float> Revolved::to_frame(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<float> places(spots.size());
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_revolved_to_frame(get(), spots.data(), spots.size() / 2, control, places.data(), places.size()), control))) { places.clear(); }
    return places;
}
inline bool Revolved::to_frame(Span<const float> spots, Ref<tree_control> control, Span<float> places) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_revolved_to_frame(get(), spots.data(), spots.size() / 2, control, places.data(), places.size()), control);
}
inline size_t Revolved::half(float azimuth, Span<float> points) const {
    size_t n_points{};
    detail::done(tree_revolved_half(get(), azimuth, points.data(), points.size(), &n_points));
    return n_points;
}
inline Outline Revolved::profile(float azimuth) const {
    Outline outline;
    detail::done(tree_revolved_profile(get(), azimuth, outline.place()));
    return outline;
}
inline std::vector<float> Revolved::exits(Span<const float> rays, Span<const float> azimuths, Ref<tree_control> control) const {
    std::vector<float> exits(rays.size() / 4);
    if (!(detail::expect(rays.size() % 4 == 0, TREE_ERROR_BUFFER, "rays: must have 4 numbers for each item")
        && detail::expect(rays.size() / 4 == azimuths.size(), TREE_ERROR_BUFFER, "rays and azimuths must be of one length")
        && detail::done(tree_revolved_exits(get(), rays.data(), azimuths.data(), rays.size() / 4, control, exits.data(), exits.size()), control))) { exits.clear(); }
    return exits;
}
inline bool Revolved::exits(Span<const float> rays, Span<const float> azimuths, Ref<tree_control> control, Span<float> exits) const {
    return detail::expect(rays.size() % 4 == 0, TREE_ERROR_BUFFER, "rays: must have 4 numbers for each item")
        && detail::expect(rays.size() / 4 == azimuths.size(), TREE_ERROR_BUFFER, "rays and azimuths must be of one length")
        && detail::done(tree_revolved_exits(get(), rays.data(), azimuths.data(), rays.size() / 4, control, exits.data(), exits.size()), control);
}
inline std::vector<uint8_t> Revolved::contains(Span<const float> points, Ref<tree_control> control) const {
    std::vector<uint8_t> inside(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_revolved_contains(get(), points.data(), points.size() / 3, control, inside.data(), inside.size()), control))) { inside.clear(); }
    return inside;
}
inline bool Revolved::contains(Span<const float> points, Ref<tree_control> control, Span<uint8_t> inside) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_revolved_contains(get(), points.data(), points.size() / 3, control, inside.data(), inside.size()), control);
}
inline SilhouetteSession SilhouetteSession::make(Ref<tree_silhouette_params> params, uint64_t seed) {
    SilhouetteSession silhouette;
    detail::done(tree_silhouette_session_new(params, seed, silhouette.place()));
    return silhouette;
}
inline SilhouetteSession SilhouetteSession::of_drawing(const OutlineDrawing &drawing, size_t tree, Ref<tree_silhouette_params> params, uint64_t seed, Ref<tree_control> control, tree_silhouette_play_report *report) {
    SilhouetteSession silhouette;
    detail::done(tree_silhouette_session_of_drawing(drawing.get(), tree, params, seed, control, report, silhouette.place()), control);
    return silhouette;
}
inline SilhouetteSession SilhouetteSession::copy() const {
    SilhouetteSession copy;
    detail::done(tree_silhouette_session_copy(get(), copy.place()));
    return copy;
}
inline SilhouetteChangeColumns SilhouetteChange::view() const & {
    SilhouetteChangeColumns columns;
    if (!(detail::done(tree_silhouette_change_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline SilhouetteChange SilhouetteSession::draw_trunk(Span<const float> stroke, Ref<tree_control> control) const {
    SilhouetteChange change;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_silhouette_session_draw_trunk(get(), stroke.data(), stroke.size() / 2, control, change.place()), control));
    return change;
}
inline SilhouetteChange SilhouetteSession::draw_crown(Span<const float> stroke, Ref<tree_control> control) const {
    SilhouetteChange change;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_silhouette_session_draw_crown(get(), stroke.data(), stroke.size() / 2, control, change.place()), control));
    return change;
}
inline SilhouetteChange SilhouetteSession::draw_section(float azimuth, Span<const float> stroke, Ref<tree_control> control) const {
    SilhouetteChange change;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_silhouette_session_draw_section(get(), azimuth, stroke.data(), stroke.size() / 2, control, change.place()), control));
    return change;
}
inline SilhouetteChange SilhouetteSession::refine(uint32_t level, Span<const float> stroke, Ref<tree_control> control) const {
    SilhouetteChange change;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_silhouette_session_refine(get(), level, stroke.data(), stroke.size() / 2, control, change.place()), control));
    return change;
}
inline SilhouetteChange SilhouetteSession::refine_branch(uint32_t id, Span<const float> stroke, Ref<tree_control> control) const {
    SilhouetteChange change;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_silhouette_session_refine_branch(get(), id, stroke.data(), stroke.size() / 2, control, change.place()), control));
    return change;
}
inline SilhouetteChange SilhouetteSession::redraw(uint32_t level, Span<const float> stroke, tree_transfer transfer, Span<const uint32_t> only, Ref<tree_control> control) const {
    SilhouetteChange change;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_silhouette_session_redraw(get(), level, stroke.data(), stroke.size() / 2, transfer, only.data(), only.size(), control, change.place()), control));
    return change;
}
inline SilhouetteChange SilhouetteSession::redraw_from(float yaw, float pitch, Span<const float> stroke, tree_transfer transfer, Span<const uint32_t> only, Ref<tree_control> control) const {
    SilhouetteChange change;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_silhouette_session_redraw_from(get(), yaw, pitch, stroke.data(), stroke.size() / 2, transfer, only.data(), only.size(), control, change.place()), control));
    return change;
}
inline SilhouetteChange SilhouetteSession::remove(uint32_t id) const {
    SilhouetteChange change;
    detail::done(tree_silhouette_session_remove(get(), id, change.place()));
    return change;
}
inline SilhouetteChange SilhouetteSession::draw_leaf(Span<const float> stroke, Ref<tree_control> control) const {
    SilhouetteChange change;
    static_cast<void>(detail::expect(stroke.size() % 2 == 0, TREE_ERROR_BUFFER, "stroke: must have 2 numbers for each item")
        && detail::done(tree_silhouette_session_draw_leaf(get(), stroke.data(), stroke.size() / 2, control, change.place()), control));
    return change;
}
inline SilhouetteChange SilhouetteSession::copy_style(uint32_t source, Span<const uint32_t> targets) const {
    SilhouetteChange change;
    detail::done(tree_silhouette_session_copy_style(get(), source, targets.data(), targets.size(), change.place()));
    return change;
}
inline SilhouetteChange SilhouetteSession::set_params(Ref<tree_silhouette_params> params) const {
    SilhouetteChange change;
    detail::done(tree_silhouette_session_set_params(get(), params, change.place()));
    return change;
}
inline bool SilhouetteSession::set_seed(uint64_t seed) const {
    return detail::done(tree_silhouette_session_set_seed(get(), seed));
}
inline SilhouetteChange SilhouetteSession::undo() const {
    SilhouetteChange change;
    detail::done(tree_silhouette_session_undo(get(), change.place()));
    return change;
}
inline SilhouetteChange SilhouetteSession::redo() const {
    SilhouetteChange change;
    detail::done(tree_silhouette_session_redo(get(), change.place()));
    return change;
}
inline uint64_t SilhouetteSession::seed() const {
    uint64_t seed{};
    detail::done(tree_silhouette_session_seed(get(), &seed));
    return seed;
}
inline SilhouetteParams SilhouetteSession::get_params() const & {
    SilhouetteParams params;
    if (!(detail::done(tree_silhouette_session_get_params(get(), &params)))) { params.struct_size = 0; }
    return params;
}
inline std::tuple<size_t, size_t> SilhouetteSession::depth() const {
    size_t n_undo{};
    size_t n_redo{};
    detail::done(tree_silhouette_session_depth(get(), &n_undo, &n_redo));
    return {std::move(n_undo), std::move(n_redo)};
}
inline std::tuple<float, float> SilhouetteSession::coverage() const {
    float by_bumps{};
    float by_all{};
    detail::done(tree_silhouette_session_coverage(get(), &by_bumps, &by_all));
    return {std::move(by_bumps), std::move(by_all)};
}
inline Lines SilhouetteSession::repairs() const {
    Lines lines;
    detail::done(tree_silhouette_session_repairs(get(), lines.place()));
    return lines;
}
inline Lines SilhouetteSession::refused() const {
    Lines lines;
    detail::done(tree_silhouette_session_refused(get(), lines.place()));
    return lines;
}
inline OutlinePlan SilhouetteSession::plan() const {
    OutlinePlan plan;
    detail::done(tree_silhouette_session_plan(get(), plan.place()));
    return plan;
}
inline std::tuple<SilhouetteGrown, Tree> SilhouetteSession::tree(Ref<tree_control> control) const {
    SilhouetteGrown report;
    Tree tree;
    if (!(detail::done(tree_silhouette_session_tree(get(), control, &report, tree.place()), control))) { report.struct_size = 0; }
    return {std::move(report), std::move(tree)};
}
inline bool StandParams::check() const {
    return detail::done(tree_stand_params_check(this));
}
inline Stand Stand::of_drawing(const OutlineDrawing &drawing, Ref<tree_stand_params> params, uint64_t seed, Ref<tree_control> control) {
    Stand stand;
    detail::done(tree_stand_of_drawing(drawing.get(), params, seed, control, stand.place()), control);
    return stand;
}
inline StandWhole Stand::view() const {
    StandWhole whole;
    if (!(detail::done(tree_stand_view(get(), &whole)))) { whole.struct_size = 0; }
    return whole;
}
inline Lines Stand::notes() const {
    Lines lines;
    detail::done(tree_stand_notes(get(), lines.place()));
    return lines;
}
inline StandTree Stand::at(size_t index) const & {
    StandTree row;
    if (!(detail::done(tree_stand_at(get(), index, &row)))) { row.struct_size = 0; }
    return row;
}
inline std::tuple<SilhouetteGrown, Tree> Stand::grown(size_t index) const {
    SilhouetteGrown report;
    Tree tree;
    if (!(detail::done(tree_stand_grown(get(), index, &report, tree.place())))) { report.struct_size = 0; }
    return {std::move(report), std::move(tree)};
}
inline SilhouetteSession Stand::silhouette(size_t index, tree_silhouette_play_report *report) const {
    SilhouetteSession silhouette;
    detail::done(tree_stand_silhouette(get(), index, report, silhouette.place()));
    return silhouette;
}
inline bool SubParams::check() const {
    return detail::done(tree_sub_params_check(this));
}
inline float SubParams::opening(float radius, float span) const {
    float angle{};
    detail::done(tree_sub_params_opening(this, radius, span, &angle));
    return angle;
}
inline Outline Outline::sub(Span<const float> branch, float radius, const Floats<2> &stretch, Ref<tree_sub_params> params, Ref<tree_control> control, tree_sub_report *report) const {
    Outline sub;
    static_cast<void>(detail::expect(branch.size() % 2 == 0, TREE_ERROR_BUFFER, "branch: must have 2 numbers for each item")
        && detail::done(tree_outline_sub(get(), branch.data(), branch.size() / 2, radius, stretch, params, control, report, sub.place()), control));
    return sub;
}
inline Skeleton Skeleton::from_columns(Ref<tree_skeleton_columns> columns, Ref<tree_control> control) {
    Skeleton skeleton;
    detail::done(tree_skeleton_from_columns(columns, control, skeleton.place()), control);
    return skeleton;
}
inline std::tuple<std::vector<uint32_t>, Skeleton> Skeleton::from_unordered(Ref<tree_skeleton_columns> columns, Ref<tree_control> control) {
    std::vector<uint32_t> rows(columns ? columns->n_nodes : 0);
    Skeleton skeleton;
    if (!(detail::done(tree_skeleton_from_unordered(columns, control, rows.data(), skeleton.place()), control))) { rows.clear(); }
    return {std::move(rows), std::move(skeleton)};
}
inline Skeleton Skeleton::from_unordered(Ref<tree_skeleton_columns> columns, Ref<tree_control> control, Span<uint32_t> rows) {
    Skeleton skeleton;
    static_cast<void>(detail::expect((!rows.data() || rows.size() >= (columns ? columns->n_nodes : 0)), TREE_ERROR_BUFFER, "rows: not room enough")
        && detail::done(tree_skeleton_from_unordered(columns, control, rows.data(), skeleton.place()), control));
    return skeleton;
}
inline SkeletonColumns Skeleton::view() const & {
    SkeletonColumns columns;
    if (!(detail::done(tree_skeleton_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline std::array<float, 6> Skeleton::bounds() const {
    std::array<float, 6> min_max{};
    detail::done(tree_skeleton_bounds(get(), reinterpret_cast<float(*)[6]>(min_max.data())));
    return min_max;
}
inline Axes Skeleton::axes(tree_continuation rule) const {
    Axes axes;
    detail::done(tree_skeleton_axes(get(), rule, axes.place()));
    return axes;
}
inline AxisColumns Axes::view() const & {
    AxisColumns columns;
    if (!(detail::done(tree_axes_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline BranchingReport Skeleton::branching() const {
    BranchingReport report;
    if (!(detail::done(tree_skeleton_branching(get(), &report)))) { report.struct_size = 0; }
    return report;
}
inline std::vector<uint32_t> Skeleton::strahler_orders() const {
    std::vector<uint32_t> orders(view().n_nodes);
    if (!(detail::done(tree_skeleton_strahler_orders(get(), orders.data(), orders.size())))) { orders.clear(); }
    return orders;
}
inline bool Skeleton::strahler_orders(Span<uint32_t> orders) const {
    return detail::done(tree_skeleton_strahler_orders(get(), orders.data(), orders.size()));
}
inline std::tuple<std::vector<tree_strahler_order>, size_t> Skeleton::strahler_counts() const {
    std::vector<tree_strahler_order> rows(view().n_nodes);
    size_t n_rows{};
    if (!(detail::done(tree_skeleton_strahler_counts(get(), rows.data(), rows.size(), &n_rows)))) { rows.clear(); }
    rows.resize(n_rows);
    return {std::move(rows), std::move(n_rows)};
}
inline size_t Skeleton::strahler_counts(Span<tree_strahler_order> rows) const {
    size_t n_rows{};
    detail::done(tree_skeleton_strahler_counts(get(), rows.data(), rows.size(), &n_rows));
    return n_rows;
}
inline std::tuple<std::vector<tree_unbranched_run>, size_t> Skeleton::runs() const {
    std::vector<tree_unbranched_run> runs(view().n_nodes);
    size_t n_runs{};
    if (!(detail::done(tree_skeleton_runs(get(), runs.data(), runs.size(), &n_runs)))) { runs.clear(); }
    runs.resize(n_runs);
    return {std::move(runs), std::move(n_runs)};
}
inline size_t Skeleton::runs(Span<tree_unbranched_run> runs) const {
    size_t n_runs{};
    detail::done(tree_skeleton_runs(get(), runs.data(), runs.size(), &n_runs));
    return n_runs;
}
inline std::vector<uint32_t> Skeleton::run_of() const {
    std::vector<uint32_t> run_of(view().n_nodes);
    if (!(detail::done(tree_skeleton_run_of(get(), run_of.data(), run_of.size())))) { run_of.clear(); }
    return run_of;
}
inline bool Skeleton::run_of(Span<uint32_t> run_of) const {
    return detail::done(tree_skeleton_run_of(get(), run_of.data(), run_of.size()));
}
inline std::tuple<std::vector<double>, size_t> Skeleton::pipe_exponents() const {
    std::vector<double> exponents(view().n_nodes);
    size_t n_exponents{};
    if (!(detail::done(tree_skeleton_pipe_exponents(get(), exponents.data(), exponents.size(), &n_exponents)))) { exponents.clear(); }
    exponents.resize(n_exponents);
    return {std::move(exponents), std::move(n_exponents)};
}
inline size_t Skeleton::pipe_exponents(Span<double> exponents) const {
    size_t n_exponents{};
    detail::done(tree_skeleton_pipe_exponents(get(), exponents.data(), exponents.size(), &n_exponents));
    return n_exponents;
}
inline std::tuple<std::vector<tree_lateral_angle>, size_t> Skeleton::lateral_angles(tree_continuation rule, float reach) const {
    std::vector<tree_lateral_angle> laterals(view().n_nodes);
    size_t n_laterals{};
    if (!(detail::done(tree_skeleton_lateral_angles(get(), rule, reach, laterals.data(), laterals.size(), &n_laterals)))) { laterals.clear(); }
    laterals.resize(n_laterals);
    return {std::move(laterals), std::move(n_laterals)};
}
inline size_t Skeleton::lateral_angles(tree_continuation rule, float reach, Span<tree_lateral_angle> laterals) const {
    size_t n_laterals{};
    detail::done(tree_skeleton_lateral_angles(get(), rule, reach, laterals.data(), laterals.size(), &n_laterals));
    return n_laterals;
}
inline Skeleton Skeleton::with_radii(Span<const float> radii) const {
    Skeleton changed;
    detail::done(tree_skeleton_with_radii(get(), radii.data(), radii.size(), changed.place()));
    return changed;
}
inline Skeleton Skeleton::with_positions(Span<const float> positions) const {
    Skeleton changed;
    static_cast<void>(detail::expect(positions.size() % 3 == 0, TREE_ERROR_BUFFER, "positions: must have 3 numbers for each item")
        && detail::done(tree_skeleton_with_positions(get(), positions.data(), positions.size() / 3, changed.place())));
    return changed;
}
inline std::vector<float> Skeleton::segment_lengths() const {
    std::vector<float> lengths(view().n_nodes);
    if (!(detail::done(tree_skeleton_segment_lengths(get(), lengths.data(), lengths.size())))) { lengths.clear(); }
    return lengths;
}
inline bool Skeleton::segment_lengths(Span<float> lengths) const {
    return detail::done(tree_skeleton_segment_lengths(get(), lengths.data(), lengths.size()));
}
inline std::vector<float> Skeleton::distances_to_root() const {
    std::vector<float> distances(view().n_nodes);
    if (!(detail::done(tree_skeleton_distances_to_root(get(), distances.data(), distances.size())))) { distances.clear(); }
    return distances;
}
inline bool Skeleton::distances_to_root(Span<float> distances) const {
    return detail::done(tree_skeleton_distances_to_root(get(), distances.data(), distances.size()));
}
inline std::vector<float> Skeleton::distances_to_tip() const {
    std::vector<float> distances(view().n_nodes);
    if (!(detail::done(tree_skeleton_distances_to_tip(get(), distances.data(), distances.size())))) { distances.clear(); }
    return distances;
}
inline bool Skeleton::distances_to_tip(Span<float> distances) const {
    return detail::done(tree_skeleton_distances_to_tip(get(), distances.data(), distances.size()));
}
inline std::vector<uint32_t> Skeleton::subtree_sizes() const {
    std::vector<uint32_t> sizes(view().n_nodes);
    if (!(detail::done(tree_skeleton_subtree_sizes(get(), sizes.data(), sizes.size())))) { sizes.clear(); }
    return sizes;
}
inline bool Skeleton::subtree_sizes(Span<uint32_t> sizes) const {
    return detail::done(tree_skeleton_subtree_sizes(get(), sizes.data(), sizes.size()));
}
inline std::vector<uint32_t> Skeleton::tip_counts() const {
    std::vector<uint32_t> counts(view().n_nodes);
    if (!(detail::done(tree_skeleton_tip_counts(get(), counts.data(), counts.size())))) { counts.clear(); }
    return counts;
}
inline bool Skeleton::tip_counts(Span<uint32_t> counts) const {
    return detail::done(tree_skeleton_tip_counts(get(), counts.data(), counts.size()));
}
inline std::tuple<std::vector<uint32_t>, std::vector<uint32_t>> Skeleton::children() const {
    std::vector<uint32_t> starts(view().n_nodes + 1);
    std::vector<uint32_t> nodes(view().n_nodes);
    if (!(detail::done(tree_skeleton_children(get(), starts.data(), starts.size(), nodes.data(), nodes.size())))) { starts.clear(); nodes.clear(); }
    nodes.resize(starts.empty() ? 0 : starts.back());
    return {std::move(starts), std::move(nodes)};
}
inline bool Skeleton::children(Span<uint32_t> starts, Span<uint32_t> nodes) const {
    return detail::done(tree_skeleton_children(get(), starts.data(), starts.size(), nodes.data(), nodes.size()));
}
inline Swc Swc::read(std::string_view path, Ref<tree_swc_options> options, Ref<tree_control> control) {
    Swc swc;
    detail::done(tree_swc_read(path.data() ? path.data() : "", path.size(), options, control, swc.place()), control);
    return swc;
}
inline Swc Swc::from_text(std::string_view text, Ref<tree_swc_options> options, Ref<tree_control> control) {
    Swc swc;
    detail::done(tree_swc_from_text(text.data() ? text.data() : "", text.size(), options, control, swc.place()), control);
    return swc;
}
inline Skeleton Swc::skeleton() const {
    Skeleton skeleton;
    detail::done(tree_swc_skeleton(get(), skeleton.place()));
    return skeleton;
}
inline SwcContents Swc::view() const & {
    SwcContents contents;
    if (!(detail::done(tree_swc_view(get(), &contents)))) { contents.struct_size = 0; }
    return contents;
}
inline bool Skeleton::write_swc(std::string_view path, Ref<tree_swc_options> options) const {
    return detail::done(tree_skeleton_write_swc(get(), path.data() ? path.data() : "", path.size(), options));
}
inline Bytes Skeleton::to_swc(Ref<tree_swc_options> options) const {
    Bytes text;
    detail::done(tree_skeleton_to_swc(get(), options, text.place()));
    return text;
}
inline bool ScanParams::check() const {
    return detail::done(tree_scan_params_check(this));
}
inline Scanned skeletonize_scan(Span<const double> points, Ref<tree_scan_params> params, Ref<tree_control> control, tree_scan_report *report) {
    Scanned scanned;
    static_cast<void>(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_skeletonize_scan(points.data(), points.size() / 3, params, control, report, scanned.place()), control));
    return scanned;
}
inline Scanned Cloud::skeletonize_cloud(Ref<tree_scan_params> params, Ref<tree_control> control, tree_scan_report *report) const {
    Scanned scanned;
    detail::done(tree_skeletonize_cloud(get(), params, control, report, scanned.place()), control);
    return scanned;
}
inline size_t Scanned::count() const {
    size_t n_trees{};
    detail::done(tree_scanned_count(get(), &n_trees));
    return n_trees;
}
inline Skeleton Scanned::skeleton(size_t index) const {
    Skeleton skeleton;
    detail::done(tree_scanned_skeleton(get(), index, skeleton.place()));
    return skeleton;
}
inline ScannedColumns Scanned::view(size_t index) const & {
    ScannedColumns columns;
    if (!(detail::done(tree_scanned_view(get(), index, &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline std::tuple<float, size_t> Scanned::bridge(size_t index) const {
    float length{};
    size_t n_points{};
    detail::done(tree_scanned_bridge(get(), index, &length, &n_points));
    return {std::move(length), std::move(n_points)};
}
inline FoundLeaves Separation::leaves(const Skeleton &skeleton, Ref<tree_control> control) const {
    FoundLeaves leaves;
    detail::done(tree_separation_leaves(get(), skeleton.get(), control, leaves.place()), control);
    return leaves;
}
inline Foliage FoundLeaves::foliage() const & {
    Foliage foliage;
    if (!(detail::done(tree_found_leaves_foliage(get(), &foliage)))) { foliage.struct_size = 0; }
    return foliage;
}
inline LeafKinds FoundLeaves::view() const & {
    LeafKinds kinds;
    if (!(detail::done(tree_found_leaves_view(get(), &kinds)))) { kinds.struct_size = 0; }
    return kinds;
}
inline Pieces Separation::follow(Ref<tree_skeletonize_params> params, Ref<tree_control> control) const {
    Pieces pieces;
    detail::done(tree_separation_follow(get(), params, control, pieces.place()), control);
    return pieces;
}
inline Pieces Pieces::make(const Handles<tree_skeleton> &skeletons, Span<const tree_piece> rows, Ref<tree_control> control) {
    Pieces pieces;
    static_cast<void>(detail::expect(skeletons.size() == rows.size(), TREE_ERROR_BUFFER, "skeletons and rows must be of one length")
        && detail::done(tree_pieces_new(skeletons.data(), rows.data(), skeletons.size(), control, pieces.place()), control));
    return pieces;
}
inline size_t Pieces::count() const {
    size_t n_pieces{};
    detail::done(tree_pieces_count(get(), &n_pieces));
    return n_pieces;
}
inline std::tuple<tree_piece, Skeleton> Pieces::piece(size_t index) const {
    tree_piece row{};
    Skeleton skeleton;
    detail::done(tree_pieces_piece(get(), index, &row, skeleton.place()));
    return {std::move(row), std::move(skeleton)};
}
inline std::tuple<std::vector<uint8_t>, Skeleton> Pieces::link(Ref<tree_skeletonize_params> params, Ref<tree_control> control) const {
    std::vector<uint8_t> reached(count());
    Skeleton skeleton;
    if (!(detail::done(tree_pieces_link(get(), params, control, reached.data(), reached.size(), skeleton.place()), control))) { reached.clear(); }
    return {std::move(reached), std::move(skeleton)};
}
inline Skeleton Pieces::link(Ref<tree_skeletonize_params> params, Ref<tree_control> control, Span<uint8_t> reached) const {
    Skeleton skeleton;
    detail::done(tree_pieces_link(get(), params, control, reached.data(), reached.size(), skeleton.place()), control);
    return skeleton;
}
inline Separation Separation::make(Span<const tree_mesh_part> parts, Ref<tree_skeletonize_params> params, Ref<tree_control> control) {
    Separation separation;
    detail::done(tree_separation_new(parts.data(), parts.size(), params, control, separation.place()), control);
    return separation;
}
inline Separation Separation::of_mesh(const Mesh &mesh, Span<const tree_hint> hints, Ref<tree_skeletonize_params> params, Ref<tree_control> control) {
    Separation separation;
    detail::done(tree_separation_of_mesh(mesh.get(), hints.data(), hints.size(), params, control, separation.place()), control);
    return separation;
}
inline SeparationColumns Separation::view() const & {
    SeparationColumns columns;
    if (!(detail::done(tree_separation_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Separation Separation::with_classes(Span<const tree_class> classes) const {
    Separation other;
    detail::done(tree_separation_with_classes(get(), classes.data(), classes.size(), other.place()));
    return other;
}
inline Skeleton Separation::outward(const Skeleton &skeleton) const {
    Skeleton outward;
    detail::done(tree_separation_outward(get(), skeleton.get(), outward.place()));
    return outward;
}
inline Tree skeletonize(Span<const tree_mesh_part> parts, Ref<tree_skeletonize_params> params, Ref<tree_control> control, tree_skeletonize_report *report) {
    Tree tree;
    detail::done(tree_skeletonize(parts.data(), parts.size(), params, control, report, tree.place()), control);
    return tree;
}
inline Tree Mesh::skeletonize_mesh(Span<const tree_hint> hints, Ref<tree_skeletonize_params> params, Ref<tree_control> control, tree_skeletonize_report *report) const {
    Tree tree;
    detail::done(tree_skeletonize_mesh(get(), hints.data(), hints.size(), params, control, report, tree.place()), control);
    return tree;
}
inline SketchBranches SketchBranches::from_columns(Ref<tree_sketch_branches_columns> columns, Ref<tree_control> control) {
    SketchBranches branches;
    detail::done(tree_sketch_branches_from_columns(columns, control, branches.place()), control);
    return branches;
}
inline SketchBranchesColumns SketchBranches::view() const & {
    SketchBranchesColumns columns;
    if (!(detail::done(tree_sketch_branches_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline std::vector<uint32_t> SketchBranches::orders() const {
    std::vector<uint32_t> orders(view().n_segments);
    if (!(detail::done(tree_sketch_branches_orders(get(), orders.data(), orders.size())))) { orders.clear(); }
    return orders;
}
inline bool SketchBranches::orders(Span<uint32_t> orders) const {
    return detail::done(tree_sketch_branches_orders(get(), orders.data(), orders.size()));
}
inline bool CleanParams::check() const {
    return detail::done(tree_clean_params_check(this));
}
inline Plan Drawing::clean(Ref<tree_clean_params> params, Ref<tree_control> control) const {
    Plan plan;
    detail::done(tree_drawing_clean(get(), params, control, plan.place()), control);
    return plan;
}
inline bool CrownParams::check() const {
    return detail::done(tree_crown_params_check(this));
}
inline Crown Crown::close(Ref<tree_strokes_columns> columns, Span<const float> spots, Ref<tree_crown_params> params, Ref<tree_control> control) {
    Crown crown;
    static_cast<void>(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_crown_close(columns, spots.data(), spots.size() / 2, params, control, crown.place()), control));
    return crown;
}
inline Crown Crown::from_polygons(Ref<tree_strokes_columns> columns, float depth, Ref<tree_control> control) {
    Crown crown;
    detail::done(tree_crown_from_polygons(columns, depth, control, crown.place()), control);
    return crown;
}
inline StrokesColumns Crown::polygons() const & {
    StrokesColumns columns;
    if (!(detail::done(tree_crown_polygons(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline CrownMeasures Crown::measure() const {
    CrownMeasures measures;
    if (!(detail::done(tree_crown_measure(get(), &measures)))) { measures.struct_size = 0; }
    return measures;
}
inline Span<const tree_crown_repair> Crown::repairs() const & {
    const tree_crown_repair *repairs = nullptr;
    size_t n_repairs = 0;
    detail::done(tree_crown_repairs(get(), &repairs, &n_repairs));
    return Span<const tree_crown_repair>(repairs, n_repairs);
}
inline Lines Crown::repairs_text() const {
    Lines lines;
    detail::done(tree_crown_repairs_text(get(), lines.place()));
    return lines;
}
inline std::vector<uint8_t> Crown::contains(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<uint8_t> inside(spots.size() / 2);
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_crown_contains(get(), spots.data(), spots.size() / 2, control, inside.data(), inside.size()), control))) { inside.clear(); }
    return inside;
}
inline bool Crown::contains(Span<const float> spots, Ref<tree_control> control, Span<uint8_t> inside) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_crown_contains(get(), spots.data(), spots.size() / 2, control, inside.data(), inside.size()), control);
}
inline std::vector<float> Crown::levels(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> levels(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_crown_levels(get(), points.data(), points.size() / 3, control, levels.data(), levels.size()), control))) { levels.clear(); }
    return levels;
}
inline bool Crown::levels(Span<const float> points, Ref<tree_control> control, Span<float> levels) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_crown_levels(get(), points.data(), points.size() / 3, control, levels.data(), levels.size()), control);
}
inline std::vector<float> Crown::exits(Span<const float> ways, Ref<tree_control> control) const {
    std::vector<float> exits(ways.size() / 6);
    if (!(detail::expect(ways.size() % 6 == 0, TREE_ERROR_BUFFER, "ways: must have 6 numbers for each item")
        && detail::done(tree_crown_exits(get(), ways.data(), ways.size() / 6, control, exits.data(), exits.size()), control))) { exits.clear(); }
    return exits;
}
inline bool Crown::exits(Span<const float> ways, Ref<tree_control> control, Span<float> exits) const {
    return detail::expect(ways.size() % 6 == 0, TREE_ERROR_BUFFER, "ways: must have 6 numbers for each item")
        && detail::done(tree_crown_exits(get(), ways.data(), ways.size() / 6, control, exits.data(), exits.size()), control);
}
inline Strokes Strokes::outline(Span<const float> spots, Ref<tree_sketch_outline_params> params, Ref<tree_control> control) {
    Strokes strokes;
    static_cast<void>(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_strokes_outline(spots.data(), spots.size() / 2, params, control, strokes.place()), control));
    return strokes;
}
inline Drawing Drawing::make(Span<const tree_sketch_stroke> strokes, Ref<tree_control> control) {
    Drawing drawing;
    detail::done(tree_drawing_new(strokes.data(), strokes.size(), control, drawing.place()), control);
    return drawing;
}
inline Drawing Drawing::with_strokes(Span<const tree_sketch_stroke> strokes, Ref<tree_control> control) const {
    Drawing more;
    detail::done(tree_drawing_with_strokes(get(), strokes.data(), strokes.size(), control, more.place()), control);
    return more;
}
inline Drawing Drawing::from_svg(std::string_view svg, Ref<tree_control> control) {
    Drawing drawing;
    detail::done(tree_drawing_from_svg(svg.data() ? svg.data() : "", svg.size(), control, drawing.place()), control);
    return drawing;
}
inline Drawing Drawing::from_json(std::string_view json, Ref<tree_control> control) {
    Drawing drawing;
    detail::done(tree_drawing_from_json(json.data() ? json.data() : "", json.size(), control, drawing.place()), control);
    return drawing;
}
inline Bytes Drawing::to_json() const {
    Bytes bytes;
    detail::done(tree_drawing_to_json(get(), bytes.place()));
    return bytes;
}
inline size_t Drawing::count() const {
    size_t n_strokes{};
    detail::done(tree_drawing_count(get(), &n_strokes));
    return n_strokes;
}
inline SketchStroke Drawing::stroke(size_t index) const & {
    SketchStroke stroke;
    if (!(detail::done(tree_drawing_stroke(get(), index, &stroke)))) { stroke.struct_size = 0; }
    return stroke;
}
inline Drawings Drawings::from_ndjson(std::string_view ndjson, Ref<tree_control> control) {
    Drawings drawings;
    detail::done(tree_drawings_from_ndjson(ndjson.data() ? ndjson.data() : "", ndjson.size(), control, drawings.place()), control);
    return drawings;
}
inline size_t Drawings::count() const {
    size_t n_drawings{};
    detail::done(tree_drawings_count(get(), &n_drawings));
    return n_drawings;
}
inline Drawing Drawings::at(size_t index) const {
    Drawing drawing;
    detail::done(tree_drawings_at(get(), index, drawing.place()));
    return drawing;
}
inline size_t exemplar_count() {
    return tree_exemplar_count();
}
inline std::tuple<std::string_view, std::string_view, std::string_view> exemplar_name(size_t index) {
    tree_str name{};
    tree_str title{};
    tree_str species{};
    detail::done(tree_exemplar_name(index, &name, &title, &species));
    return {detail::text(name), detail::text(title), detail::text(species)};
}
inline Tree exemplar_grow(std::string_view name, uint64_t seed, Ref<tree_control> control) {
    Tree tree;
    detail::done(tree_exemplar_grow(name.data() ? name.data() : "", name.size(), seed, control, tree.place()), control);
    return tree;
}
inline bool MainBranchParams::check() const {
    return detail::done(tree_main_branch_params_check(this));
}
inline Drawing Drawing::of_tree(const Tree &tree, float yaw, bool with_crown, Ref<tree_main_branch_params> main, Ref<tree_sketch_outline_params> outline, Ref<tree_control> control) {
    Drawing drawing;
    detail::done(tree_drawing_of_tree(tree.get(), yaw, with_crown ? 1u : 0u, main, outline, control, drawing.place()), control);
    return drawing;
}
inline Skeleton SketchBranches::wood(Ref<tree_sketch_finish_params> params, Ref<tree_control> control) const {
    Skeleton wood;
    detail::done(tree_sketch_branches_wood(get(), params, control, wood.place()), control);
    return wood;
}
inline Tree Skeleton::sketch_grow_crown(Maybe<tree_crown> crown, Ref<tree_sketch_finish_params> params, uint64_t seed, Ref<tree_control> control, tree_sketch_finish_report *report) const {
    Tree tree;
    static_cast<void>(detail::expect(crown.fits(), TREE_ERROR_NULL, "crown: empty; leave it out, or hand over nullptr")
        && detail::done(tree_sketch_grow_crown(get(), crown, params, seed, control, report, tree.place()), control));
    return tree;
}
inline std::vector<float> footprint_of(Span<const float> spots, Ref<tree_control> control) {
    std::vector<float> distances(TREE_FOOTPRINT_DIRECTIONS);
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_footprint_of(spots.data(), spots.size() / 2, control, distances.data(), distances.size()), control))) { distances.clear(); }
    return distances;
}
inline bool footprint_of(Span<const float> spots, Ref<tree_control> control, Span<float> distances) {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_footprint_of(spots.data(), spots.size() / 2, control, distances.data(), distances.size()), control);
}
inline float footprint_difference(Span<const float> first, Span<const float> second) {
    float difference{};
    detail::done(tree_footprint_difference(first.data(), first.size(), second.data(), second.size(), &difference));
    return difference;
}
inline std::tuple<std::vector<float>, size_t> convex_hull(Span<const float> spots, Ref<tree_control> control) {
    std::vector<float> corners(spots.size());
    size_t n_corners{};
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_convex_hull(spots.data(), spots.size() / 2, control, corners.data(), corners.size(), &n_corners), control))) { corners.clear(); }
    corners.resize(2 * n_corners);
    return {std::move(corners), std::move(n_corners)};
}
inline size_t convex_hull(Span<const float> spots, Ref<tree_control> control, Span<float> corners) {
    size_t n_corners{};
    static_cast<void>(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_convex_hull(spots.data(), spots.size() / 2, control, corners.data(), corners.size(), &n_corners), control));
    return n_corners;
}
inline bool SketchInferParams::thesis() {
    return detail::done(tree_sketch_infer_params_thesis(this));
}
inline Inferred Plan::sketch_infer(Ref<tree_sketch_omega> omega, Span<const tree_sketch_pin> pins, const Crown &crown, Ref<tree_sketch_infer_params> params, uint64_t seed, Ref<tree_control> control) const {
    Inferred inferred;
    detail::done(tree_sketch_infer(get(), omega, pins.data(), pins.size(), crown.get(), params, seed, control, inferred.place()), control);
    return inferred;
}
inline InferredColumns Inferred::view() const & {
    InferredColumns columns;
    if (!(detail::done(tree_inferred_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline SketchBranches Inferred::branches() const {
    SketchBranches branches;
    detail::done(tree_inferred_branches(get(), branches.place()));
    return branches;
}
inline SketchOmega Inferred::omega() const {
    SketchOmega omega;
    if (!(detail::done(tree_inferred_omega(get(), &omega)))) { omega.struct_size = 0; }
    return omega;
}
inline FactorGraph FactorGraph::make(const Plan &plan, Ref<tree_sketch_omega> omega, Ref<tree_sketch_infer_params> params, uint64_t seed, Ref<tree_control> control) {
    FactorGraph graph;
    detail::done(tree_factor_graph_new(plan.get(), omega, params, seed, control, graph.place()), control);
    return graph;
}
inline Span<const uint32_t> FactorGraph::parents() const & {
    const uint32_t *parents = nullptr;
    size_t n_segments = 0;
    detail::done(tree_factor_graph_parents(get(), &parents, &n_segments));
    return Span<const uint32_t>(parents, n_segments);
}
inline double FactorGraph::length(uint32_t segment) const {
    double metres{};
    detail::done(tree_factor_graph_length(get(), segment, &metres));
    return metres;
}
inline tree_sketch_posterior FactorGraph::posterior(Ref<tree_sketch_omega> omega, Span<const double> depths, Span<const tree_sketch_label> labels, Ref<tree_control> control) const {
    tree_sketch_posterior posterior{};
    static_cast<void>(detail::expect(depths.size() == labels.size(), TREE_ERROR_BUFFER, "depths and labels must be of one length")
        && detail::done(tree_factor_graph_posterior(get(), omega, depths.data(), labels.data(), depths.size(), control, &posterior), control));
    return posterior;
}
inline Midlines Midlines::of(Ref<tree_strokes_columns> columns, Ref<tree_midline_params> params, Ref<tree_control> control) {
    Midlines midlines;
    detail::done(tree_midlines_of(columns, params, control, midlines.place()), control);
    return midlines;
}
inline StrokesColumns Midlines::view() const & {
    StrokesColumns columns;
    if (!(detail::done(tree_midlines_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Span<const float> Midlines::half_widths() const & {
    const float *half_widths = nullptr;
    size_t n_points = 0;
    detail::done(tree_midlines_half_widths(get(), &half_widths, &n_points));
    return Span<const float>(half_widths, n_points);
}
inline bool SketchOmega::check() const {
    return detail::done(tree_sketch_omega_check(this));
}
inline SketchOmega SketchBranches::sketch_omega_fit() const {
    SketchOmega omega;
    if (!(detail::done(tree_sketch_omega_fit(get(), &omega)))) { omega.struct_size = 0; }
    return omega;
}
inline SketchOmega Templates::omega(size_t index) const {
    SketchOmega omega;
    if (!(detail::done(tree_templates_omega(get(), index, &omega)))) { omega.struct_size = 0; }
    return omega;
}
inline SketchOmega sketch_omega_of_relations(Span<const tree_sketch_relation> relations, Ref<tree_control> control) {
    SketchOmega omega;
    if (!(detail::done(tree_sketch_omega_of_relations(relations.data(), relations.size(), control, &omega), control))) { omega.struct_size = 0; }
    return omega;
}
inline SketchOmega SketchOmega::without_orders() const {
    SketchOmega whole;
    if (!(detail::done(tree_sketch_omega_without_orders(this, &whole)))) { whole.struct_size = 0; }
    return whole;
}
inline std::tuple<std::vector<tree_sketch_relation>, size_t> SketchBranches::relations() const {
    std::vector<tree_sketch_relation> relations(view().n_segments);
    size_t n_relations{};
    if (!(detail::done(tree_sketch_branches_relations(get(), relations.data(), relations.size(), &n_relations)))) { relations.clear(); }
    relations.resize(n_relations);
    return {std::move(relations), std::move(n_relations)};
}
inline size_t SketchBranches::relations(Span<tree_sketch_relation> relations) const {
    size_t n_relations{};
    detail::done(tree_sketch_branches_relations(get(), relations.data(), relations.size(), &n_relations));
    return n_relations;
}
inline Plan Plan::from_columns(Ref<tree_plan_columns> columns, Ref<tree_control> control) {
    Plan plan;
    detail::done(tree_plan_from_columns(columns, control, plan.place()), control);
    return plan;
}
inline PlanColumns Plan::view() const & {
    PlanColumns columns;
    if (!(detail::done(tree_plan_view(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline StrokesColumns Plan::crown() const & {
    StrokesColumns columns;
    if (!(detail::done(tree_plan_crown(get(), &columns)))) { columns.struct_size = 0; }
    return columns;
}
inline Span<const uint32_t> Plan::crown_strokes() const & {
    const uint32_t *strokes = nullptr;
    size_t n_strokes = 0;
    detail::done(tree_plan_crown_strokes(get(), &strokes, &n_strokes));
    return Span<const uint32_t>(strokes, n_strokes);
}
inline Span<const tree_clean_repair> Plan::repairs() const & {
    const tree_clean_repair *repairs = nullptr;
    size_t n_repairs = 0;
    detail::done(tree_plan_repairs(get(), &repairs, &n_repairs));
    return Span<const tree_clean_repair>(repairs, n_repairs);
}
inline Lines Plan::repairs_text() const {
    Lines lines;
    detail::done(tree_plan_repairs_text(get(), lines.place()));
    return lines;
}
inline Plan Plan::scaled(float factor) const {
    Plan scaled;
    detail::done(tree_plan_scaled(get(), factor, scaled.place()));
    return scaled;
}
inline std::vector<float> Plan::points_to_drawing(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<float> drawn(spots.size());
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_plan_points_to_drawing(get(), spots.data(), spots.size() / 2, control, drawn.data(), drawn.size()), control))) { drawn.clear(); }
    return drawn;
}
inline bool Plan::points_to_drawing(Span<const float> spots, Ref<tree_control> control, Span<float> drawn) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_plan_points_to_drawing(get(), spots.data(), spots.size() / 2, control, drawn.data(), drawn.size()), control);
}
inline std::vector<float> Plan::points_from_drawing(Span<const float> spots, Ref<tree_control> control) const {
    std::vector<float> planned(spots.size());
    if (!(detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_plan_points_from_drawing(get(), spots.data(), spots.size() / 2, control, planned.data(), planned.size()), control))) { planned.clear(); }
    return planned;
}
inline bool Plan::points_from_drawing(Span<const float> spots, Ref<tree_control> control, Span<float> planned) const {
    return detail::expect(spots.size() % 2 == 0, TREE_ERROR_BUFFER, "spots: must have 2 numbers for each item")
        && detail::done(tree_plan_points_from_drawing(get(), spots.data(), spots.size() / 2, control, planned.data(), planned.size()), control);
}
inline SketchBranches SketchBranches::propagate(Ref<tree_sketch_omega> omega, Maybe<tree_crown> crown, Maybe<tree_volume> obstacles, Ref<tree_sketch_propagate_params> params, uint64_t seed, Ref<tree_control> control, tree_sketch_propagate_report *report) const {
    SketchBranches grown;
    static_cast<void>(detail::expect(crown.fits(), TREE_ERROR_NULL, "crown: empty; leave it out, or hand over nullptr")
        && detail::expect(obstacles.fits(), TREE_ERROR_NULL, "obstacles: empty; leave it out, or hand over nullptr")
        && detail::done(tree_sketch_branches_propagate(get(), omega, crown, obstacles, params, seed, control, report, grown.place()), control));
    return grown;
}
inline bool TemplateSelectParams::check() const {
    return detail::done(tree_template_select_params_check(this));
}
inline std::vector<tree_template_choice> Templates::select(const Plan &plan, Maybe<tree_crown> crown, Ref<tree_template_select_params> params, Ref<tree_control> control) const {
    std::vector<tree_template_choice> choices(count());
    if (!(detail::expect(crown.fits(), TREE_ERROR_NULL, "crown: empty; leave it out, or hand over nullptr")
        && detail::done(tree_templates_select(get(), plan.get(), crown, params, control, choices.data(), choices.size()), control))) { choices.clear(); }
    return choices;
}
inline bool Templates::select(const Plan &plan, Maybe<tree_crown> crown, Ref<tree_template_select_params> params, Ref<tree_control> control, Span<tree_template_choice> choices) const {
    return detail::expect(crown.fits(), TREE_ERROR_NULL, "crown: empty; leave it out, or hand over nullptr")
        && detail::done(tree_templates_select(get(), plan.get(), crown, params, control, choices.data(), choices.size()), control);
}
inline SketchSession SketchSession::make(const Drawing &drawing, Ref<tree_sketch_params> params, uint64_t seed) {
    SketchSession session;
    detail::done(tree_sketch_session_new(drawing.get(), params, seed, session.place()));
    return session;
}
inline SketchSession SketchSession::copy() const {
    SketchSession copy;
    detail::done(tree_sketch_session_copy(get(), copy.place()));
    return copy;
}
inline bool SketchSession::set_seed(uint64_t seed) const {
    return detail::done(tree_sketch_session_set_seed(get(), seed));
}
inline bool SketchSession::set_params(Ref<tree_sketch_params> params) const {
    return detail::done(tree_sketch_session_set_params(get(), params));
}
inline bool SketchSession::set_templates(Maybe<tree_templates> templates) const {
    return detail::expect(templates.fits(), TREE_ERROR_NULL, "templates: empty; leave it out, or hand over nullptr")
        && detail::done(tree_sketch_session_set_templates(get(), templates));
}
inline bool SketchSession::set_obstacles(Maybe<tree_volume> obstacles) const {
    return detail::expect(obstacles.fits(), TREE_ERROR_NULL, "obstacles: empty; leave it out, or hand over nullptr")
        && detail::done(tree_sketch_session_set_obstacles(get(), obstacles));
}
inline bool SketchSession::infer_anew() const {
    return detail::done(tree_sketch_session_infer_anew(get()));
}
inline bool SketchSession::redo_from(tree_sketch_stage stage) const {
    return detail::done(tree_sketch_session_redo_from(get(), stage));
}
inline size_t SketchSession::add_stroke(Ref<tree_sketch_stroke> stroke, Ref<tree_control> control) const {
    size_t number{};
    detail::done(tree_sketch_session_add_stroke(get(), stroke, control, &number), control);
    return number;
}
inline size_t SketchSession::erase_stroke(size_t stroke, Ref<tree_control> control, Span<uint32_t> gone) const {
    size_t n_gone{};
    detail::done(tree_sketch_session_erase_stroke(get(), stroke, control, gone.data(), gone.size(), &n_gone), control);
    return n_gone;
}
inline bool SketchSession::set_depth(size_t stroke, const Floats<2> &at, float depth, Ref<tree_control> control) const {
    return detail::done(tree_sketch_session_set_depth(get(), stroke, at, depth, control), control);
}
inline Drawing SketchSession::drawing() const {
    Drawing drawing;
    detail::done(tree_sketch_session_drawing(get(), drawing.place()));
    return drawing;
}
inline uint64_t SketchSession::seed() const {
    uint64_t seed{};
    detail::done(tree_sketch_session_seed(get(), &seed));
    return seed;
}
inline SketchParams SketchSession::get_params() const & {
    SketchParams params;
    if (!(detail::done(tree_sketch_session_get_params(get(), &params)))) { params.struct_size = 0; }
    return params;
}
inline uint32_t SketchSession::runs(tree_sketch_stage stage) const {
    uint32_t n_runs{};
    detail::done(tree_sketch_session_runs(get(), stage, &n_runs));
    return n_runs;
}
inline Plan SketchSession::plan(Ref<tree_control> control) const {
    Plan plan;
    detail::done(tree_sketch_session_plan(get(), control, plan.place()), control);
    return plan;
}
inline Crown SketchSession::crown(Ref<tree_control> control) const {
    Crown crown;
    detail::done(tree_sketch_session_crown(get(), control, crown.place()), control);
    return crown;
}
inline size_t SketchSession::choices(Ref<tree_control> control, Span<tree_template_choice> choices) const {
    size_t n_choices{};
    detail::done(tree_sketch_session_choices(get(), control, choices.data(), choices.size(), &n_choices), control);
    return n_choices;
}
inline Templates SketchSession::template_taken(Ref<tree_control> control) const {
    Templates taken;
    detail::done(tree_sketch_session_template_taken(get(), control, taken.place()), control);
    return taken;
}
inline Inferred SketchSession::inferred(Ref<tree_control> control) const {
    Inferred inferred;
    detail::done(tree_sketch_session_inferred(get(), control, inferred.place()), control);
    return inferred;
}
inline SketchBranches SketchSession::branches(Ref<tree_control> control, tree_sketch_propagate_report *report) const {
    SketchBranches branches;
    detail::done(tree_sketch_session_branches(get(), control, report, branches.place()), control);
    return branches;
}
inline Skeleton SketchSession::wood(Ref<tree_control> control) const {
    Skeleton wood;
    detail::done(tree_sketch_session_wood(get(), control, wood.place()), control);
    return wood;
}
inline Tree SketchSession::tree(Ref<tree_control> control, tree_sketch_report *report) const {
    Tree tree;
    detail::done(tree_sketch_session_tree(get(), control, report, tree.place()), control);
    return tree;
}
inline Lines SketchSession::warnings(Ref<tree_control> control) const {
    Lines warnings;
    detail::done(tree_sketch_session_warnings(get(), control, warnings.place()), control);
    return warnings;
}
inline bool SketchParams::check() const {
    return detail::done(tree_sketch_params_check(this));
}
inline Tree Drawing::from_sketch(Maybe<tree_templates> templates, Maybe<tree_volume> obstacles, Ref<tree_sketch_params> params, uint64_t seed, Ref<tree_control> control, tree_sketch_report *report) const {
    Tree tree;
    static_cast<void>(detail::expect(templates.fits(), TREE_ERROR_NULL, "templates: empty; leave it out, or hand over nullptr")
        && detail::expect(obstacles.fits(), TREE_ERROR_NULL, "obstacles: empty; leave it out, or hand over nullptr")
        && detail::done(tree_from_sketch(get(), templates, obstacles, params, seed, control, report, tree.place()), control));
    return tree;
}
inline Templates Templates::builtin() {
    Templates templates;
    detail::done(tree_templates_builtin(templates.place()));
    return templates;
}
inline Templates Templates::from_text(std::string_view text, Ref<tree_control> control) {
    Templates templates;
    detail::done(tree_templates_from_text(text.data() ? text.data() : "", text.size(), control, templates.place()), control);
    return templates;
}
inline Bytes Templates::to_text() const {
    Bytes bytes;
    detail::done(tree_templates_to_text(get(), bytes.place()));
    return bytes;
}
inline bool TemplateParams::check() const {
    return detail::done(tree_template_params_check(this));
}
inline Templates Templates::of_tree(std::string_view name, std::string_view species, const Tree &tree, Ref<tree_template_params> params, Ref<tree_control> control) {
    Templates templates;
    detail::done(tree_templates_of_tree(name.data() ? name.data() : "", name.size(), species.data() ? species.data() : "", species.size(), tree.get(), params, control, templates.place()), control);
    return templates;
}
inline Templates Templates::join(const Templates &others) const {
    Templates joined;
    detail::done(tree_templates_join(get(), others.get(), joined.place()));
    return joined;
}
inline size_t Templates::count() const {
    size_t n_templates{};
    detail::done(tree_templates_count(get(), &n_templates));
    return n_templates;
}
inline size_t Templates::find(std::string_view name) const {
    size_t index{};
    detail::done(tree_templates_find(get(), name.data() ? name.data() : "", name.size(), &index));
    return index;
}
inline TemplateView Templates::view(size_t index) const & {
    TemplateView view;
    if (!(detail::done(tree_templates_view(get(), index, &view)))) { view.struct_size = 0; }
    return view;
}
inline TemplateSide Templates::side(size_t index, size_t number) const & {
    TemplateSide side;
    if (!(detail::done(tree_templates_side(get(), index, number, &side)))) { side.struct_size = 0; }
    return side;
}
inline Tree Tree::make(const Skeleton &skeleton, Ref<tree_foliage> foliage, Ref<tree_species> species, Ref<tree_control> control) {
    Tree tree;
    detail::done(tree_tree_new(skeleton.get(), foliage, species, control, tree.place()), control);
    return tree;
}
inline Skeleton Tree::skeleton() const {
    Skeleton skeleton;
    detail::done(tree_tree_skeleton(get(), skeleton.place()));
    return skeleton;
}
inline Foliage Tree::foliage() const & {
    Foliage foliage;
    if (!(detail::done(tree_tree_foliage(get(), &foliage)))) { foliage.struct_size = 0; }
    return foliage;
}
inline Species Tree::species() const & {
    Species species;
    if (!(detail::done(tree_tree_species(get(), &species)))) { species.struct_size = 0; }
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
inline Volume Volume::union_(const Handles<tree_volume> &volumes) {
    Volume volume;
    detail::done(tree_volume_union(volumes.data(), volumes.size(), volume.place()));
    return volume;
}
inline Volume Volume::intersection(const Handles<tree_volume> &volumes) {
    Volume volume;
    detail::done(tree_volume_intersection(volumes.data(), volumes.size(), volume.place()));
    return volume;
}
inline Volume Volume::difference(const Volume &without) const {
    Volume volume;
    detail::done(tree_volume_difference(get(), without.get(), volume.place()));
    return volume;
}
inline Volume Volume::transformed(const Floats<12> &columns) const {
    Volume volume;
    detail::done(tree_volume_transformed(get(), columns, volume.place()));
    return volume;
}
inline std::vector<uint8_t> Volume::contains(Span<const float> points, Ref<tree_control> control) const {
    std::vector<uint8_t> inside(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_volume_contains(get(), points.data(), points.size() / 3, control, inside.data()), control))) { inside.clear(); }
    return inside;
}
inline bool Volume::contains(Span<const float> points, Ref<tree_control> control, Span<uint8_t> inside) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::expect((!inside.data() || inside.size() >= (points.size() / 3)), TREE_ERROR_BUFFER, "inside: not room enough")
        && detail::done(tree_volume_contains(get(), points.data(), points.size() / 3, control, inside.data()), control);
}
inline std::vector<float> Volume::distance(Span<const float> points, Ref<tree_control> control) const {
    std::vector<float> distances(points.size() / 3);
    if (!(detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::done(tree_volume_distance(get(), points.data(), points.size() / 3, control, distances.data()), control))) { distances.clear(); }
    return distances;
}
inline bool Volume::distance(Span<const float> points, Ref<tree_control> control, Span<float> distances) const {
    return detail::expect(points.size() % 3 == 0, TREE_ERROR_BUFFER, "points: must have 3 numbers for each item")
        && detail::expect((!distances.data() || distances.size() >= (points.size() / 3)), TREE_ERROR_BUFFER, "distances: not room enough")
        && detail::done(tree_volume_distance(get(), points.data(), points.size() / 3, control, distances.data()), control);
}
inline bool Volume::distance_is_exact() const {
    uint32_t is_exact = 0;
    detail::done(tree_volume_distance_is_exact(get(), &is_exact));
    return is_exact != 0;
}
inline std::array<float, 6> Volume::bounds() const {
    std::array<float, 6> min_max{};
    detail::done(tree_volume_bounds(get(), reinterpret_cast<float(*)[6]>(min_max.data())));
    return min_max;
}
inline bool Volume::is_bounded() const {
    uint32_t is_bounded = 0;
    detail::done(tree_volume_is_bounded(get(), &is_bounded));
    return is_bounded != 0;
}
inline float Volume::measure() const {
    float measure{};
    detail::done(tree_volume_measure(get(), &measure));
    return measure;
}
inline float Volume::estimate_measure(uint32_t n_samples, Ref<tree_control> control) const {
    float measure{};
    detail::done(tree_volume_estimate_measure(get(), n_samples, control, &measure), control);
    return measure;
}
inline std::vector<float> Volume::sample(size_t n_points, uint32_t attempts, uint64_t seed, Ref<tree_control> control) const {
    std::vector<float> points(3 * n_points);
    if (!(detail::done(tree_volume_sample(get(), n_points, attempts, seed, control, points.data()), control))) { points.clear(); }
    return points;
}
inline bool Volume::sample(size_t n_points, uint32_t attempts, uint64_t seed, Ref<tree_control> control, Span<float> points) const {
    return detail::expect((!points.data() || points.size() >= (3 * n_points)), TREE_ERROR_BUFFER, "points: not room enough")
        && detail::done(tree_volume_sample(get(), n_points, attempts, seed, control, points.data()), control);
}
inline Volume Volume::sphere(const Floats<3> &center, float radius) {
    Volume volume;
    detail::done(tree_volume_sphere(center, radius, volume.place()));
    return volume;
}
inline Volume Volume::ellipsoid(const Floats<3> &center, const Floats<3> &radii) {
    Volume volume;
    detail::done(tree_volume_ellipsoid(center, radii, volume.place()));
    return volume;
}
inline Volume Volume::cylinder(const Floats<3> &base, const Floats<3> &top, float radius) {
    Volume volume;
    detail::done(tree_volume_cylinder(base, top, radius, volume.place()));
    return volume;
}
inline Volume Volume::frustum(const Floats<3> &base, const Floats<3> &top, float base_radius, float top_radius) {
    Volume volume;
    detail::done(tree_volume_frustum(base, top, base_radius, top_radius, volume.place()));
    return volume;
}
inline Volume Volume::cone(const Floats<3> &base, const Floats<3> &apex, float base_radius) {
    Volume volume;
    detail::done(tree_volume_cone(base, apex, base_radius, volume.place()));
    return volume;
}
inline Volume Volume::capsule(const Floats<3> &start, const Floats<3> &end, float radius) {
    Volume volume;
    detail::done(tree_volume_capsule(start, end, radius, volume.place()));
    return volume;
}
inline Volume Volume::box(const Floats<3> &min, const Floats<3> &max) {
    Volume volume;
    detail::done(tree_volume_box(min, max, volume.place()));
    return volume;
}
inline Volume Volume::half_space(const Floats<3> &point, const Floats<3> &normal) {
    Volume volume;
    detail::done(tree_volume_half_space(point, normal, volume.place()));
    return volume;
}
inline Volume Volume::sector(const Floats<3> &apex, const Floats<3> &axis, float angle, float radius) {
    Volume volume;
    detail::done(tree_volume_sector(apex, axis, angle, radius, volume.place()));
    return volume;
}
inline Volume Volume::revolution(const Floats<3> &base, const Floats<3> &axis, Span<const float> profile, Ref<tree_control> control) {
    Volume volume;
    static_cast<void>(detail::expect(profile.size() % 2 == 0, TREE_ERROR_BUFFER, "profile: must have 2 numbers for each item")
        && detail::done(tree_volume_revolution(base, axis, profile.data(), profile.size() / 2, control, volume.place()), control));
    return volume;
}
inline Volume Volume::closed_mesh(Span<const float> positions, Span<const uint32_t> indices, Ref<tree_control> control) {
    Volume volume;
    static_cast<void>(detail::expect(positions.size() % 3 == 0, TREE_ERROR_BUFFER, "positions: must have 3 numbers for each item")
        && detail::expect(indices.size() % 3 == 0, TREE_ERROR_BUFFER, "indices: must have 3 numbers for each item")
        && detail::done(tree_volume_closed_mesh(positions.data(), positions.size() / 3, indices.data(), indices.size() / 3, control, volume.place()), control));
    return volume;
}
inline Solid Volume::view() const & {
    Solid solid;
    if (!(detail::done(tree_volume_view(get(), &solid)))) { solid.struct_size = 0; }
    return solid;
}
inline Volume Volume::part(size_t index) const {
    Volume part;
    detail::done(tree_volume_part(get(), index, part.place()));
    return part;
}

} // namespace tree

#endif // TREE_HPP
