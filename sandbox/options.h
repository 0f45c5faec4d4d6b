/// \file What a user may ask for on the command line, and what a frame makes of it.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/display.h"
#include "core/result.h"
#include "graph/resource.h"
#include "photon_gi/settings.h"

namespace lampyris::sandbox {

enum class Quality : uint8_t { Fast, Fine };

/// Empty where the default hangs on the pipeline, the quality or the call.
struct Options {
    std::string scene;
    std::optional<graph::Extent> size;  ///< pixels
    std::optional<uint32_t> frames, warmup;
    photon_gi::Pipeline pipeline = photon_gi::Pipeline::Full;
    Quality quality = Quality::Fast;
    std::optional<uint32_t> photons, maxBounces, gatherDivisor;
    std::optional<float> radius;  ///< metres
    std::optional<photon_gi::Gather> gather;
    std::optional<uint32_t> gatherRays, filterLevels, shadowDivisor, shadowRays;
    std::optional<uint32_t> history;
    std::optional<bool> guiding;
    bool reseed = true;
    std::optional<photon_gi::Retrace> retrace;
    float lightCutoff = 0.001f;
    std::string camera, animation;
    double time = 0.0;               ///< seconds
    std::optional<double> timestep;  ///< seconds
    uint32_t seed = 1;
    core::DisplayTransform display;
    std::string outputNode = "final";
    std::filesystem::path output, report, graph, trace;
    bool validation = false;
    std::string device;
};

// These write to `options`, which must outlive `app`'s parsing.
/// --size, --seed.
void addSizeOptions(CLI::App& app, Options& options);
/// Options of every call that draws frames, those of addSizeOptions included.
void addFrameOptions(CLI::App& app, Options& options);
/// --exposure, --tonemap.
void addDisplayOptions(CLI::App& app, core::DisplayTransform& display);
/// --camera, --animation, --time.
void addCameraOptions(CLI::App& app, Options& options);
/// --camera, --animation, --time, --exposure, --tonemap, --report.
void addViewOptions(CLI::App& app, Options& options);
/// Those of addViewOptions, --timestep, --graph, --trace.
void addPictureOptions(CLI::App& app, Options& options);
/// A finite number from `least` to `most`; NaN is in no range.
[[nodiscard]] CLI::Validator finite(double least, double most);

/// What the options ask for together and cannot have: a wrong call.
core::Result<void> checkCall(const Options& options);
/// Whether each of these files is another one, however its path is spelt; empty paths are none.
core::Result<void> checkDistinct(const std::vector<std::filesystem::path>& files);
/// Whether a file of that path can be written; an empty path asks for none.
core::Result<void> checkTarget(const std::filesystem::path& path);
/// Whether the files that the options name can be written, before anything is drawn.
core::Result<void> checkOutputs(const Options& options);

[[nodiscard]] photon_gi::Settings settingsOf(const Options& options);
[[nodiscard]] graph::Extent sizeOf(const Options& options);

[[nodiscard]] const char* name(Quality quality);

}  // namespace lampyris::sandbox
