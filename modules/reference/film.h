/// \file Samples of all pixels, added up, and the images they make.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/path_tracer.h"
#include "reference/pixel.h"

namespace lampyris::reference {

/// A pixel's samples come from this many sequences in turn, scrambled apart: their spread tells the
/// error. [chosen: more would spread each sequence's points less well]
constexpr uint32_t kSequences = 8;

/// Of one pixel.
struct PixelSums {
    LightSplit light;
    std::array<glm::vec3, kSequences> radiance{};  ///< direct + indirect, a sequence each
    std::array<float, kSequences> indirect{};      ///< mean channel of the indirect irradiance
};

/// What one pixel shows besides light.
struct PixelGuide {
    glm::vec3 albedo{0.0f}, normal{0.0f}, position{0.0f}, emission{0.0f}, disc{0.0f};
    float depthMetres = 0.0f;
    uint32_t instance = 0;
    bool surface = false, hasDisc = false;
};

/// Pixels are independent: several threads may work on different ones.
class Film {
 public:
    /// `sequences` of kSequences are in use.
    Film(uint32_t width, uint32_t height, uint32_t sequences);

    void setGuide(size_t pixel, const Pixel& seen);
    /// Adds one sample, of that sequence.
    void add(size_t pixel, uint32_t sequence, const LightSplit& light);

    /// Standard error of direct + indirect, by pixel; `samples` have been taken of each.
    [[nodiscard]] glm::vec3 standardError(size_t pixel, uint32_t samples) const;
    /// Root of the mean square of it ÷ the mean of direct + indirect; 0 where all is black.
    [[nodiscard]] double relativeError(uint32_t samples) const;

    /// Divides by the samples taken; smooths where asked.
    [[nodiscard]] Rendered develop(uint32_t samples, const PixelRays& camera,
                                   const Settings& settings) const;

 private:
    [[nodiscard]] float indirectVariance(size_t pixel, uint32_t samples) const;
    [[nodiscard]] core::Image irradianceIndirect(uint32_t samples) const;
    [[nodiscard]] core::Image smoothed(const core::Image& irradiance, uint32_t samples,
                                       const PixelRays& camera, uint32_t threads) const;

    uint32_t width_, height_, sequences_;
    std::vector<PixelSums> sums_;
    std::vector<PixelGuide> guides_;
};

}  // namespace lampyris::reference
