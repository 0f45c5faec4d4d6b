/// \file Glowing triangles as things to sample.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/ray_scene.h"

namespace lampyris::reference {

/// A point of a glowing surface.
struct EmitterSample {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};    ///< unit, to the front side
    glm::vec3 radiance{0.0f};  ///< of the side asked for, W/(m² sr)
    float density = 0.0f;      ///< a square metre
};

/// Every emissive triangle, chosen by its power: area times the mean radiance of its texels, twice
/// that where it glows on both sides. Points are uniform over a triangle, and have the radiance of
/// the texture there.
class Emitters {
 public:
    /// Keeps a reference to the scene.
    explicit Emitters(const RayScene& scene);

    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    [[nodiscard]] size_t count() const { return triangles_.size(); }

    /// Draws a point; `from` decides which side is seen.
    [[nodiscard]] EmitterSample sample(const glm::vec3& from, glm::vec3 xi) const;
    /// Density a square metre with which sample() gives points of a triangle; 0 of what does not
    /// glow.
    [[nodiscard]] float density(uint32_t instance, uint32_t primitive) const;
    /// Which triangle a number from [0, 1) chooses, counted as they stand in the scene.
    [[nodiscard]] size_t choose(float& xi) const;

 private:
    struct Triangle {
        uint32_t instance, primitive;
        float cumulative;  ///< share of all power up to and with this one; the last is 1
    };
    void add(uint32_t instance, const PlacedMesh& placed, std::vector<double>& powers);

    const RayScene* scene_;
    std::vector<Triangle> triangles_;
    std::vector<std::vector<float>> densities_;  ///< by instance, then by triangle of its mesh
};

}  // namespace lampyris::reference
