#include "courtyard/route.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace lampyris::courtyard {
namespace {

constexpr size_t kSamples = 32;  // [chosen] a piece; a corner of 1 m is round to a millimetre

glm::vec3 catmullRom(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d,
                     float t) {
    return 0.5f * (2.0f * b + (c - a) * t + (2.0f * a - 5.0f * b + 4.0f * c - d) * (t * t) +
                   (3.0f * b - a - 3.0f * c + d) * (t * t * t));
}

}  // namespace

Route::Route(std::span<const glm::vec3> through) {
    CHECK(through.size() >= 3u);
    const size_t count = through.size();
    for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < kSamples; ++k) {
            const float t = static_cast<float>(k) / kSamples;
            points_.push_back(catmullRom(through[(i + count - 1) % count], through[i],
                                         through[(i + 1) % count], through[(i + 2) % count], t));
        }
    }
    points_.push_back(points_.front());
    along_.push_back(0.0);
    for (size_t i = 1; i < points_.size(); ++i)
        along_.push_back(along_.back() + glm::length(glm::dvec3(points_[i] - points_[i - 1])));
}

Stance Route::at(double metres) const {
    const double length = lengthMetres();
    const double wanted = metres - length * std::floor(metres / length);
    const auto above = std::upper_bound(along_.begin() + 1, along_.end() - 1, wanted);
    const auto next = static_cast<size_t>(above - along_.begin());
    const double t = (wanted - along_[next - 1]) / (along_[next] - along_[next - 1]);
    const auto directionOf = [&](size_t piece) { return points_[piece + 1] - points_[piece]; };
    const size_t pieces = points_.size() - 1;
    // Between the pieces' middles, so that it turns without a jerk.
    const size_t here = next - 1;
    const size_t other = t < 0.5 ? (here + pieces - 1) % pieces : (here + 1) % pieces;
    const auto share = static_cast<float>(std::abs(t - 0.5));
    glm::vec3 forward =
        glm::mix(glm::normalize(directionOf(here)), glm::normalize(directionOf(other)), share);
    forward.y = 0.0f;
    return {glm::mix(points_[here], points_[next], static_cast<float>(t)), glm::normalize(forward)};
}

}  // namespace lampyris::courtyard
