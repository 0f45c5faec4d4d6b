/// \file Result<T>: what a function gives back that depends on the world (a file, a device, a
/// shader).
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace lampyris::core {

/// What was wrong, in one line that names the file, the place in it and the feature.
struct Error {
    std::string message;
};

/// Makes an Error from a fmt format string.
template <typename... Args>
Error error(fmt::format_string<Args...> format, Args&&... args) {
    return Error{fmt::format(format, std::forward<Args>(args)...)};
}

/// Either a value or the Error that stood in its way. Reading the wrong one is our bug
/// (terminates).
template <typename T>
class [[nodiscard]] Result {
 public:
    Result(T value) : state_(std::move(value)) {}
    Result(Error error) : state_(std::move(error)) {}

    [[nodiscard]] bool ok() const { return std::holds_alternative<T>(state_); }
    explicit operator bool() const { return ok(); }
    [[nodiscard]] T& value() & { return std::get<T>(state_); }
    [[nodiscard]] const T& value() const& { return std::get<T>(state_); }
    [[nodiscard]] T&& value() && { return std::get<T>(std::move(state_)); }
    T* operator->() { return &value(); }
    T& operator*() { return value(); }
    const T* operator->() const { return &value(); }
    const T& operator*() const { return value(); }
    [[nodiscard]] const Error& error() const { return std::get<Error>(state_); }

 private:
    std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    [[nodiscard]] bool ok() const { return !error_.has_value(); }
    explicit operator bool() const { return ok(); }
    [[nodiscard]] const Error& error() const { return *error_; }

 private:
    std::optional<Error> error_;
};

}  // namespace lampyris::core

// TRY and TRY_VOID are the only names without LAMPYRIS_ that our headers define for the
// preprocessor; check.h, which no other header includes, defines CHECK.
#define LAMPYRIS_JOIN_(a, b) a##b
#define LAMPYRIS_JOIN(a, b) LAMPYRIS_JOIN_(a, b)

/// TRY(auto x, f()): x = the value of f(), or return f()'s error from this function.
#define TRY(declaration, expression)                                                         \
    auto LAMPYRIS_JOIN(tried, __LINE__) = (expression);                                      \
    if (!LAMPYRIS_JOIN(tried, __LINE__).ok()) return LAMPYRIS_JOIN(tried, __LINE__).error(); \
    declaration = std::move(LAMPYRIS_JOIN(tried, __LINE__)).value()  // NOLINT: a declaration

/// TRY_VOID(f()): go on where f() succeeded, or return its error from this function.
#define TRY_VOID(expression)                                   \
    do {                                                       \
        auto tryVoidResult = (expression);                     \
        if (!tryVoidResult.ok()) return tryVoidResult.error(); \
    } while (false)
