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

