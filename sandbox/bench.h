/// \file The project's measurements, a function each; `lampyris bench NAME` calls one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/result.h"
#include "options.h"
#include "race.h"

namespace lampyris::sandbox {

struct BenchCall {
    Options options;            ///< what is left empty is the benchmark's own choice
    std::filesystem::path out;  ///< a folder; empty: print alone
    bool quick = false;         ///< smaller and fewer
    // Of the Thesis' tables alone:
    std::string scene;                ///< empty: the table's own
    std::filesystem::path reference;  ///< an EXR file that errors are measured against; or empty
    std::optional<uint32_t> samplesPerPixel;  ///< of the reference that is rendered instead
};

core::Result<void> benchNodes(
    const BenchCall& call);  ///< frame rate and every node, both pipelines
core::Result<void> benchBinning(const BenchCall& call);  ///< photons to tiles: full beside thesis
core::Result<void> benchBudget(const BenchCall& call);   ///< a budget kept under steps of load
core::Result<void> benchRays(const BenchCall& call);     ///< the shader's traversal beside Embree's
core::Result<void> benchAccel(const BenchCall& call);    ///< BVH builds and memory, a scene each
core::Result<void> benchRefit(const BenchCall& call);    ///< what deforming meshes cost the BVH
core::Result<void> benchMotion(const BenchCall& call);   ///< what motion costs, and stillness saves
core::Result<void> benchSoak(const BenchCall& call);     ///< whether memory grows over many frames

// The Thesis' evaluation again; see sandbox/thesis/README.md.
core::Result<void> benchParameterScaling(const BenchCall& call);
core::Result<void> benchFixedBudget(const BenchCall& call);
core::Result<void> benchSceneComplexity(const BenchCall& call);
core::Result<void> benchSystemComparison(const BenchCall& call);

}  // namespace lampyris::sandbox
