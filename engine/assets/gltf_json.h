/// \file Typed looks into a JSON document whose complaints name the place. Private to assets.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "core/result.h"

namespace lampyris::assets {

using Json = nlohmann::json;

/// The first thing that was wrong; empty if nothing was.
struct Complaint {
    std::string place;
    std::string message;
};

/// A value of the document and its JSON pointer. A look that fails files a complaint and gives the
/// fallback; only the first complaint is kept, so that checks read as a list of statements.
class Place {
 public:
    Place(const Json& root, Complaint& complaint) : Place(&root, "", complaint) {}

    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] const Json& json() const { return *value_; }
    /// Nothing was wrong so far, here or elsewhere.
    [[nodiscard]] bool ok() const { return complaint_->message.empty(); }
    [[nodiscard]] bool has(const char* key) const;
    /// The member, or an empty object where there is none; complains if it is no object.
    [[nodiscard]] Place object(const char* key) const;
    /// How many elements the array has, 0 where it is absent; complains if it is no array.
    [[nodiscard]] size_t length(const char* key) const;
    /// Element i of an array that has it.
    [[nodiscard]] Place element(const char* key, size_t i) const;

    /// A whole number from 0 to 2^53; complains if it is absent and has no fallback.
    [[nodiscard]] uint64_t whole(const char* key, std::optional<uint64_t> fallback = {}) const;
    /// A string; complains if it is absent and has no fallback.
    [[nodiscard]] std::string text(const char* key,
                                   const std::optional<std::string>& fallback = {}) const;
    /// A number that a float can hold; complains if it is absent and has no fallback.
    [[nodiscard]] double number(const char* key, std::optional<double> fallback = {}) const;
    /// Where present: an array of numbers that floats can hold, `count` of them (0: any).
    void numbers(const char* key, size_t count, bool negativeToo = true) const;
    /// An index under `size`, or nothing where it is absent.
    std::optional<uint32_t> index(const char* key, size_t size) const;
    /// The same, complaining where it is absent.
    std::optional<uint32_t> requiredIndex(const char* key, size_t size) const;
    /// Where present: an array of indices under `size`.
    void indices(const char* key, size_t size) const;

    /// Calls body(Place) for every element of the array, each of which must be an object.
    template <typename Body>
    void each(const char* key, Body&& body) const {
        const size_t count = length(key);
        for (size_t i = 0; i < count; ++i) {
            const Place place = element(key, i);
            if (place.isObject()) body(place);
        }
    }

    template <typename... Args>
    void complain(fmt::format_string<Args...> format, Args&&... args) const {
        if (complaint_->message.empty())
            *complaint_ = {pointer_, fmt::format(format, std::forward<Args>(args)...)};
    }

 private:
    Place(const Json* value, std::string pointer, Complaint& complaint)
        : value_(value), pointer_(std::move(pointer)), complaint_(&complaint) {}
    [[nodiscard]] Place member(const char* key) const;
    [[nodiscard]] bool isObject() const;
    void checkIndex(size_t size) const;
    void checkNumber() const;

    const Json* value_;
    std::string pointer_;
    Complaint* complaint_;
};

}  // namespace lampyris::assets
