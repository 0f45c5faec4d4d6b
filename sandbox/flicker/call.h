/// \file What a call of `lampyris flicker` asks for.
#pragma once

#include <algorithm>
#include <filesystem>

#include "options.h"

namespace lampyris::sandbox::flicker {

constexpr graph::Extent kStillSize{640, 360};
constexpr graph::Extent kMovingSize{320, 180};  // [DESIGN.md] of dynamic flicker
constexpr uint32_t kStillFrames = 64;           // [DESIGN.md]
constexpr uint32_t kMovingFrames = 32;          // [DESIGN.md]
constexpr uint32_t kPastHistory = 8;            // [chosen] frames of warm-up after the history
/// Frames after a change until the mean over frames is full, where its length is the default. Rows
/// without a history wait as long: all are measured at one moment.
constexpr uint32_t kSettled = photon_gi::Settings{}.history + kPastHistory;
constexpr double kTimestep = 1.0 / 60.0;  // seconds
constexpr uint32_t kStillSamples = 64;    // [chosen] a pixel of the reference: a minute
constexpr uint32_t kMovingSamples = 16;   // [chosen] 64 pictures in some minutes

struct Call {
    Options options;        ///< what is left empty is chosen here
    bool oneAlone = false;  ///< --pipeline was given: no other is measured
    bool sweep = false;     ///< over photons and radius
    std::filesystem::path map, csv, plot, reference;
    std::filesystem::path out;  ///< of tables, and of references for the next call; or empty
    std::optional<uint32_t> samplesPerPixel;  ///< of the references

    [[nodiscard]] graph::Extent stillSize() const { return options.size.value_or(kStillSize); }
    [[nodiscard]] graph::Extent movingSize() const {
        const graph::Extent size = stillSize();
        return {std::min(size.width, kMovingSize.width), std::min(size.height, kMovingSize.height)};
    }
    [[nodiscard]] uint32_t stillFrames() const { return options.frames.value_or(kStillFrames); }
    [[nodiscard]] uint32_t movingFrames() const { return options.frames.value_or(kMovingFrames); }
    [[nodiscard]] uint32_t warmup() const {
        const uint32_t learns = settingsOf(options).history + kPastHistory;
        return options.warmup.value_or(std::max(kSettled, learns));
    }
    [[nodiscard]] double timestep() const { return options.timestep.value_or(kTimestep); }
};

}  // namespace lampyris::sandbox::flicker
