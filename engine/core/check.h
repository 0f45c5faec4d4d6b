/// \file CHECK(a < b): for our own bugs; prints both operands, stays on in release builds.
#pragma once

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <string>
#include <type_traits>

namespace lampyris::core {

/// Prints the line to stderr and aborts.
[[noreturn]] void checkFailed(const char* file, int line, const char* expression,
                              const std::string& operands);

namespace detail {

template <typename T>
std::string operandText(const T& value) {
    if constexpr (std::is_enum_v<T>) {
        return fmt::format("{}", static_cast<long long>(value));
    } else if constexpr (std::is_pointer_v<T>) {
        return fmt::format("{}", static_cast<const void*>(value));
    } else if constexpr (fmt::is_formattable<T>::value) {
        return fmt::format("{}", value);
    } else {
        return "?";
    }
}

/// The outcome of one comparison, with the operands as text where it failed.
struct Outcome {
    bool passed;
    std::string operands;
    explicit operator bool() const { return passed; }
};

template <typename L>
struct Left {
    const L& left;

    template <typename R>
    Outcome outcome(bool passed, const char* op, const R& right) const {
        return {passed, passed
                            ? std::string{}
                            : fmt::format("{} {} {}", operandText(left), op, operandText(right))};
    }
    template <typename R>
    Outcome operator==(const R& r) const {
        return outcome(left == r, "==", r);
    }
    template <typename R>
    Outcome operator!=(const R& r) const {
        return outcome(left != r, "!=", r);
    }
    template <typename R>
    Outcome operator<(const R& r) const {
        return outcome(left < r, "<", r);
    }
    template <typename R>
    Outcome operator<=(const R& r) const {
        return outcome(left <= r, "<=", r);
    }
    template <typename R>
    Outcome operator>(const R& r) const {
        return outcome(left > r, ">", r);
    }
    template <typename R>
    Outcome operator>=(const R& r) const {
        return outcome(left >= r, ">=", r);
    }
    operator Outcome() const { return {static_cast<bool>(left), operandText(left)}; }
};

struct Decompose {
    template <typename L>
    Left<L> operator->*(const L& left) const {
        return {left};
    }
};

}  // namespace detail
}  // namespace lampyris::core

#define CHECK(...)                                                          \
    do {                                                                    \
        const ::lampyris::core::detail::Outcome checkOutcome =              \
            ::lampyris::core::detail::Decompose{}->*__VA_ARGS__;            \
        if (!checkOutcome.passed)                                           \
            ::lampyris::core::checkFailed(__FILE__, __LINE__, #__VA_ARGS__, \
                                          checkOutcome.operands);           \
    } while (false)
