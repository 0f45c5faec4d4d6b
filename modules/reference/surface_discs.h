/// \file Pixels around a pixel that show the same surface, disc by disc.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/glm.h"

namespace lampyris::reference {

/// Where a pixel's surface stands.
struct SmoothGuide {
    glm::vec3 position{0.0f};      ///< metres, world
    glm::vec3 normal{0.0f};        ///< unit
    float footprintMetres = 0.0f;  ///< a pixel's width there
    float variance = 0.0f;         ///< of the pixel's irradiance, mean of the channels
    uint32_t instance = 0;
    bool surface = false;
};

/// Radii of the discs in pixels; each holds about twice the pixels of the last. [chosen]
constexpr std::array<float, 9> kDiscRadii{1.5f, 2.3f, 3.3f, 4.6f, 6.5f, 9.2f, 13.0f, 18.0f, 25.5f};

/// Neighbours on the same surface: same instance, normal within 8 degrees, within a pixel's width
/// of the tangent plane.
class SurfaceDiscs {
 public:
    /// Keeps a reference to the guides of a picture of that width.
    SurfaceDiscs(const std::vector<SmoothGuide>& guides, uint32_t width);

    /// Calls visit(neighbour) for what a disc has more than the one before; the first has all but
    /// the pixel itself.
    template <typename Visit>
    void visitRing(size_t pixel, size_t disc, const Visit& visit) const {
        const SmoothGuide& centre = guides_[pixel];
        const auto x = static_cast<int>(pixel % width_), y = static_cast<int>(pixel / width_);
        for (const glm::ivec2 offset : rings_[disc]) {
            const int u = x + offset.x, v = y + offset.y;
            if (u < 0 || v < 0 || u >= static_cast<int>(width_) || v >= height_) continue;
            const size_t neighbour = static_cast<size_t>(v) * width_ + static_cast<size_t>(u);
            if (sameSurface(centre, guides_[neighbour])) visit(neighbour);
        }
    }

    /// Mean of a value over the pixel and the first `discs` discs about it.
    template <typename ValueOf>
    [[nodiscard]] double mean(size_t pixel, size_t discs, const ValueOf& valueOf) const {
        double sum = valueOf(pixel);
        int count = 1;
        for (size_t disc = 0; disc < discs; ++disc)
            visitRing(pixel, disc, [&](size_t neighbour) {
                sum += valueOf(neighbour);
                ++count;
            });
        return sum / count;
    }

 private:
    static bool sameSurface(const SmoothGuide& a, const SmoothGuide& b) {
        constexpr float kSameNormal = 0.99f;  // cosine of 8 degrees
        return b.surface && a.instance == b.instance &&
               glm::dot(a.normal, b.normal) >= kSameNormal &&
               std::abs(glm::dot(a.normal, b.position - a.position)) <= a.footprintMetres;
    }

    const std::vector<SmoothGuide>& guides_;
    uint32_t width_;
    int height_;
    std::array<std::vector<glm::ivec2>, kDiscRadii.size()> rings_;
};

}  // namespace lampyris::reference
