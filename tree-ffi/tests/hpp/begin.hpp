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

