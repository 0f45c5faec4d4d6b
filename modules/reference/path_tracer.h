/// \file Paths from a seen point, and the light that comes back along them.
#pragma once

#include <cstdint>

#include "reference/direct_light.h"
#include "reference/reference.h"

namespace lampyris::reference {

/// What one sample says of a seen point.
struct LightSplit {
    glm::vec3 irradianceDirect{0.0f};    ///< W/m², without albedo; sphere lights
    glm::vec3 specularDirect{0.0f};      ///< W/(m² sr) to the eye; sphere lights
    glm::vec3 irradianceIndirect{0.0f};  ///< W/m², without albedo; everything else
    glm::vec3 specularIndirect{0.0f};    ///< W/(m² sr) to the eye; Transport::Full alone
};

/// For one thread. With B bounces a path reaches B + 1 surfaces from a light, the seen one
/// included; light from emissive surfaces is indirect from the first of them on.
class PathTracer {
 public:
    PathTracer(const Stage& stage, uint32_t maxBounces, Transport transport);

    /// The seen surface, once for all its samples.
    struct Seen {
        Reflector lit;         ///< by sphere lights
        Reflector scattering;  ///< where paths go on
    };
    [[nodiscard]] Seen look(const Surface& surface, const glm::vec3& toEye) const;

    LightSplit sample(const Seen& seen, const OwenSobol& numbers);

    [[nodiscard]] uint64_t rays() const { return rays_; }

 private:
    /// Radiance that arrives along a ray which was drawn with this density.
    glm::vec3 arriving(Ray ray, float density, const OwenSobol& numbers);

    Stage stage_;
    uint32_t maxBounces_;
    bool glossyPaths_;
    uint64_t rays_ = 0;
};

}  // namespace lampyris::reference
