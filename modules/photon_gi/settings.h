/// \file What a frame of photon_gi is made with.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "math/glm.h"
#include "photons/irradiance_grid.h"

namespace lampyris::photon_gi {

enum class Pipeline : uint8_t {
    Full,    ///< everything the project can do
    Thesis,  ///< each step as the Thesis does it, mended: the yardstick
    Direct,  ///< full's shadowed direct light, nothing else
};

/// How `full` looks indirect light up.
enum class Gather : uint8_t {
    Tiles,  ///< photons binned to tiles, as the Thesis does
    Final,  ///< a few rays a texel into a world-space grid of the photons
};

/// What becomes of what cannot have changed since the frame before.
enum class Retrace : uint8_t {
    Auto,  ///< `full` keeps it
    All,   ///< everything is traced anew in every frame
};

/// What options, files and panels call them, in their order.
inline constexpr std::array kPipelineNames{"full", "thesis", "direct"};
inline constexpr std::array kGatherNames{"tiles", "final"};
inline constexpr std::array kRetraceNames{"auto", "all"};
[[nodiscard]] constexpr const char* name(Pipeline p) {
    return kPipelineNames[static_cast<size_t>(p)];
}
[[nodiscard]] constexpr const char* name(Gather g) {
    return kGatherNames[static_cast<size_t>(g)];
}
[[nodiscard]] constexpr const char* name(Retrace r) {
    return kRetraceNames[static_cast<size_t>(r)];
}

/// Defaults are those of the program's options.
struct Settings {
    Pipeline pipeline = Pipeline::Full;
    uint32_t photonPaths = 2500;    ///< emitted a frame
    float radiusMetres = 1.0f;      ///< of a photon's influence; the grid's cells are as wide
    uint32_t maxBounces = 8;        ///< `thesis`: 1
    Gather gather = Gather::Final;  ///< `thesis`: tiles
    uint32_t gatherDivisor = 8;     ///< low resolution, an axis
    uint32_t gatherRays = 3;        ///< final gather: a texel
    uint32_t filterLevels = 2;      ///< final gather: of the à-trous filter
    uint32_t history = 80;          ///< final gather: most frames in the mean; 0: each stands alone
    uint32_t gridColumns = 8;       ///< final gather: rays that measure a grid cell's surface
    float lightCutoff = 0.001f;     ///< of the frame's mean direct irradiance
    uint32_t seed = 1;
    bool reseed = true;  ///< paths are drawn anew every frame
    Retrace retrace = Retrace::Auto;
    bool guiding = true;         ///< final gather: photons go where earlier frames looked them up
    bool shadows = true;         ///< `full` and `direct`
    uint32_t shadowDivisor = 4;  ///< low resolution of the shadows, an axis
    uint32_t shadowRays = 8;     ///< a texel and light
    uint32_t largestBatch = 0xffffffffu;  ///< paths traced in one go, at most

    bool operator==(const Settings&) const = default;
};

/// Room for what a frame makes; grows after an overflow.
struct Capacities {
    uint32_t photons = 0;                              ///< of the largest batch
    uint32_t pairs = 0;                                ///< (tile, photon), of the largest batch
    uint32_t gridSlots = 1u << 16;                     ///< of the irradiance grid
    uint32_t mostGridSlots = photons::kMostGridSlots;  ///< that it may grow to
};

[[nodiscard]] inline bool finalGathers(const Settings& s) {
    return s.pipeline == Pipeline::Full && s.gather == Gather::Final;
}
/// Same paths every frame leave nothing to learn from.
[[nodiscard]] inline bool guided(const Settings& s) {
    return finalGathers(s) && s.guiding && s.reseed && s.maxBounces > 0;
}
/// Most frames in the mean: with the same paths every frame, one.
[[nodiscard]] inline uint32_t historyFrames(const Settings& s) {
    return s.reseed ? s.history : std::min(s.history, 1u);
}

/// Whether frames go on from what earlier ones drew, beyond the mean.
[[nodiscard]] inline bool keepsUnchanged(const Settings& s) {
    return finalGathers(s) && s.retrace == Retrace::Auto;
}

/// Puts right what cannot be had together: the Thesis's pipeline has one bounce, and tiles.
void mend(Settings& settings);

/// Whether the mean over frames goes on from frames drawn with `before`: they hold the same light,
/// if with more noise or less. What ends it: low resolution, bounces, seeds, ways of gathering.
[[nodiscard]] bool meanGoesOn(Settings before, const Settings& now);
/// Whether paths drawn up with `before` can be kept: they are as many, and drawn alike.
[[nodiscard]] bool pathsGoOn(Settings before, const Settings& now);
/// Whether surfaces and direct light are the same with both.
[[nodiscard]] bool sameDirectLight(const Settings& a, const Settings& b);

/// The seed of a frame's random numbers.
[[nodiscard]] uint32_t frameSeed(const Settings& settings, uint64_t frameNumber);

}  // namespace lampyris::photon_gi
