#include "assets/animation_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"

namespace lampyris::assets {
namespace {

/// Between two keys; the same one twice where a key holds.
struct Segment {
    size_t before = 0, after = 0;
    double share = 0.0;    ///< 0 at the key before, under 1
    double seconds = 0.0;  ///< from key to key
};

Segment segmentAt(const AnimationSampler& sampler, double seconds) {
    const std::vector<float>& times = sampler.times;
    const size_t last = times.size() - 1;
    if (!(seconds > static_cast<double>(times.front()))) return {};
    if (seconds >= static_cast<double>(times.back())) return {last, last};
    const auto after =
        std::upper_bound(times.begin(), times.end(), seconds,
                         [](double at, float time) { return at < static_cast<double>(time); });
    Segment segment;
    segment.after = static_cast<size_t>(after - times.begin());
    segment.before = segment.after - 1;
    const auto start = static_cast<double>(times[segment.before]);
    segment.seconds = static_cast<double>(times[segment.after]) - start;
    segment.share = (seconds - start) / segment.seconds;
    return segment;
}

/// In double: neither sums nor products of floats leave its range.
class Keys {
 public:
    explicit Keys(const AnimationSampler& sampler)
        : sampler_(sampler), cubic_(sampler.interpolation == Interpolation::CubicSpline) {}

    [[nodiscard]] double value(size_t key, size_t i) const { return at(key, cubic_ ? 1 : 0, i); }
    [[nodiscard]] double inTangent(size_t key, size_t i) const { return at(key, 0, i); }
    [[nodiscard]] double outTangent(size_t key, size_t i) const { return at(key, 2, i); }

    /// One component, whatever the others are.
    [[nodiscard]] double between(const Segment& s, size_t i) const {
        const double from = value(s.before, i);
        if (s.before == s.after || sampler_.interpolation == Interpolation::Step) return from;
        const double to = value(s.after, i);
        const double t = s.share;
        if (!cubic_) return (1.0 - t) * from + t * to;
        const double t2 = t * t;
        const double t3 = t2 * t;
        return (2.0 * t3 - 3.0 * t2 + 1.0) * from +
               (t3 - 2.0 * t2 + t) * s.seconds * outTangent(s.before, i) +
               (3.0 * t2 - 2.0 * t3) * to + (t3 - t2) * s.seconds * inTangent(s.after, i);
    }

 private:
    [[nodiscard]] double at(size_t key, size_t part, size_t i) const {
        const size_t element = key * (cubic_ ? 3 : 1) + part;
        return static_cast<double>(sampler_.values[element * sampler_.components + i]);
    }

    const AnimationSampler& sampler_;
    bool cubic_;
};

glm::dquat unitOr(const glm::dquat& q, const glm::dquat& other) {
    const double length = glm::length(q);
    return length > 0.0 && std::isfinite(length) ? q / length : other;
}

/// Both unit. By the shorter way; nearly equal ones straight, where the sine's quotient is noise.
glm::dquat sphericalBetween(const glm::dquat& from, glm::dquat to, double share) {
    double cosine = glm::dot(from, to);
    if (cosine < 0.0) {
        to = -to;
        cosine = -cosine;
    }
    constexpr double kStraight = 1.0 - 1e-9;  // [chosen: the error is under a float's]
    if (cosine > kStraight) return unitOr(from * (1.0 - share) + to * share, from);
    const double angle = std::acos(cosine);
    return (from * std::sin((1.0 - share) * angle) + to * std::sin(share * angle)) /
           std::sin(angle);
}

}  // namespace

void sampleNumbers(const AnimationSampler& sampler, double seconds, std::span<float> values) {
    CHECK(values.size() == sampler.components);
    const Segment segment = segmentAt(sampler, seconds);
    const Keys keys(sampler);
    for (size_t i = 0; i < values.size(); ++i) {
        const double value = keys.between(segment, i);
        const bool fits = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
        values[i] = static_cast<float>(fits ? value : keys.value(segment.before, i));
    }
}

glm::vec3 sampleVector(const AnimationSampler& sampler, double seconds) {
    glm::vec3 result;
    sampleNumbers(sampler, seconds, {&result[0], 3});
    return result;
}

glm::quat sampleRotation(const AnimationSampler& sampler, double seconds) {
    CHECK(sampler.components == 4u);
    const Segment segment = segmentAt(sampler, seconds);
    const Keys keys(sampler);
    const glm::dquat none(1.0, 0.0, 0.0, 0.0);
    const auto key = [&](size_t k) {
        return unitOr({keys.value(k, 3), keys.value(k, 0), keys.value(k, 1), keys.value(k, 2)},
                      none);
    };
    const glm::dquat from = key(segment.before);
    if (sampler.interpolation == Interpolation::Linear && segment.before != segment.after)
        return glm::quat(sphericalBetween(from, key(segment.after), segment.share));
    const glm::dquat q(keys.between(segment, 3), keys.between(segment, 0), keys.between(segment, 1),
                       keys.between(segment, 2));
    return glm::quat(unitOr(q, from));
}

}  // namespace lampyris::assets
