#include "assets/gltf_json.h"

#include <cmath>
#include <limits>

namespace lampyris::assets {
namespace {

constexpr double kLargestWhole = 9007199254740992.0;  // 2^53: doubles and integers agree up to here
const Json kNothing = Json::object();

bool isWhole(const Json& value) {
    if (!value.is_number_integer()) return false;  // 1.0 is none: tinygltf would read it as absent
    const double number = value.get<double>();
    return number >= 0.0 && number <= kLargestWhole;
}

}  // namespace

bool Place::has(const char* key) const {
    return value_->is_object() && value_->contains(key);
}

Place Place::member(const char* key) const {
    return {has(key) ? &value_->at(key) : &kNothing, pointer_ + '/' + key, *complaint_};
}

Place Place::object(const char* key) const {
    Place place = member(key);
    if (!place.isObject()) place.value_ = &kNothing;
    return place;
}

size_t Place::length(const char* key) const {
    if (!has(key)) return 0;
    const Place place = member(key);
    if (!place.value_->is_array()) {
        place.complain("must be an array");
        return 0;
    }
    return place.value_->size();
}

Place Place::element(const char* key, size_t i) const {
    return {&value_->at(key).at(i), fmt::format("{}/{}/{}", pointer_, key, i), *complaint_};
}

uint64_t Place::whole(const char* key, std::optional<uint64_t> fallback) const {
    if (!has(key)) {
        if (!fallback) complain("{} is missing", key);
        return fallback.value_or(0);
    }
    const Place place = member(key);
    if (isWhole(*place.value_)) return static_cast<uint64_t>(place.value_->get<double>());
    place.complain("must be a whole number from 0 to 2^53");
    return fallback.value_or(0);
}

std::string Place::text(const char* key, const std::optional<std::string>& fallback) const {
    if (!has(key)) {
        if (!fallback) complain("{} is missing", key);
        return fallback.value_or("");
    }
    const Place place = member(key);
    if (place.value_->is_string()) return place.value_->get<std::string>();
    place.complain("must be a string");
    return fallback.value_or("");
}

double Place::number(const char* key, std::optional<double> fallback) const {
    if (!has(key)) {
        if (!fallback) complain("{} is missing", key);
        return fallback.value_or(0.0);
    }
    const Place place = member(key);
    place.checkNumber();
    return place.value_->is_number() ? place.value_->get<double>() : fallback.value_or(0.0);
}

void Place::numbers(const char* key, size_t count, bool negativeToo) const {
    if (!has(key)) return;
    const size_t length = this->length(key);
    if (count != 0 && length != count)
        member(key).complain("has {} numbers in place of {}", length, count);
    for (size_t i = 0; i < length; ++i) {
        const Place place = element(key, i);
        place.checkNumber();
        if (!negativeToo && place.value_->is_number() && place.value_->get<double>() < 0.0)
            place.complain("is negative");
    }
}

std::optional<uint32_t> Place::index(const char* key, size_t size) const {
    if (!has(key)) return {};
    const Place place = member(key);
    place.checkIndex(size);
    if (!isWhole(*place.value_) || place.value_->get<double>() >= static_cast<double>(size))
        return {};
    return static_cast<uint32_t>(place.value_->get<double>());
}

std::optional<uint32_t> Place::requiredIndex(const char* key, size_t size) const {
    if (!has(key)) complain("{} is missing", key);
    return index(key, size);
}

void Place::indices(const char* key, size_t size) const {
    const size_t count = length(key);
    for (size_t i = 0; i < count; ++i) element(key, i).checkIndex(size);
}

bool Place::isObject() const {
    if (value_->is_object()) return true;
    complain("must be an object");
    return false;
}

void Place::checkIndex(size_t size) const {
    if (!isWhole(*value_))
        complain("must be a whole number from 0");
    else if (value_->get<double>() >= static_cast<double>(size))
        complain("is {}, and there are {}", value_->get<double>(), size);
}

void Place::checkNumber() const {
    if (!value_->is_number())
        complain("must be a number");
    else if (!(std::abs(value_->get<double>()) <= std::numeric_limits<float>::max()))
        complain("is too large for a 32-bit float");
}

}  // namespace lampyris::assets
