/// \file All figures of flicker of one way of drawing a scene.
#pragma once

#include <map>

#include "evaluation/flicker.h"
#include "flicker/sequences.h"

namespace lampyris::sandbox::flicker {

struct FlickerCall {
    Options options;
    bool allPipelines = true;  ///< `full` and `thesis`; else the options' own
    bool sweep = false;
    uint32_t samplesPerPixel = 64;        ///< of the still reference
    uint32_t movingSamplesPerPixel = 32;  ///< of each frame of the moving one
    std::filesystem::path map, csv, plot;
};

/// What a scene looks like: for the MSSIM of averaged frames, and for what moves.
struct Truths {
    core::Image still;
    /// Two sequences of other random numbers; empty until the first moving sequence was drawn.
    std::array<Pictures, 2> moving;
    double floor = 0.0;  ///< dynamic flicker of one against the other
};

struct FlickerFigures {
    std::string name;
    uint32_t photons = 0;
    float radiusMetres = 0.0f;
    evaluation::StaticFlicker still;
    double frozen = 0.0;              ///< static flicker with the same paths in every frame
    double mssim = 0.0;               ///< of the time-averaged frame
    std::vector<double> stillFrames;  ///< mean |I_t − I_{t−1}|
    bool moves = false;
    evaluation::FrameFigures dynamic;
    std::map<std::string, evaluation::Lag> lags;  ///< by the light's change
};

/// \param whole with what moves and all changes of a light; else still pictures and `off` alone
core::Result<FlickerFigures> measure(const FlickerCall& call, const Options& options,
                                     Truths& truths, bool whole);

core::Result<core::Image> stillTruth(const FlickerCall& call);

}  // namespace lampyris::sandbox::flicker
