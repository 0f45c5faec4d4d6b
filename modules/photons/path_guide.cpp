#include "photons/path_guide.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.h"
#include "photons/shaders.h"

namespace lampyris::photons {
namespace {

// [chosen] Squares of an emitter's way out: 2 sides², so that each has paths enough to learn from.
constexpr uint32_t kMostSides = 8;
constexpr uint32_t kPathsPerPart = 8;
// [chosen] A frame's weight in the running means.
constexpr double kNewest = 0.1;
// [chosen] Of a part's share that follows power alone: no part loses more than three quarters
// of its paths.
constexpr double kUnguided = 0.25;

double mean(const glm::vec3& rgb) {
    return static_cast<double>(rgb.x + rgb.y + rgb.z) / 3.0;
}

/// A direction's parts are squares of its two angles; a surface's are stretches of its triangles.
void addParts(const Emitter& emitter, uint32_t sides, std::vector<EmitterPart>& parts) {
    const bool surface = emitter.kind == shared::EMIT_SURFACE;
    const uint32_t columns = surface ? 2 * sides * sides : sides;
    const uint32_t rows = surface ? 1 : 2 * sides;
    const uint32_t count = sides == 0 ? 1 : columns * rows;
    EmitterPart part{emitter};
    part.emitter.powerWatts /= static_cast<float>(count);
    part.emitter.sampledWatts /= static_cast<float>(count);
    if (!surface) part.emitter.kind = shared::EMIT_DIRECTION;
    for (uint32_t i = 0; i < count; ++i) {
        if (sides > 0) {
            const glm::vec2 size{1.0f / static_cast<float>(columns),
                                 1.0f / static_cast<float>(rows)};
            part.square = {glm::vec2(i % columns, i / columns) * size, size};
        }
        parts.push_back(part);
    }
}

}  // namespace

graph::Buffer addPathImportance(graph::Frame& frame, const PhotonList& photons,
                                const GridCells& cells, const IrradianceGrid& grid,
                                graph::Buffer lookUps) {
    auto node = frame.compute("photon_trace/importance", shaders::pathImportance);
    node.uniformData(shared::SLOT_IMPORTANCE_PARAMS, cells.params)
        .texels(shared::SLOT_IMPORTANCE_PHOTONS, photons.photons, graph::Format::RGBA32Uint)
        .read(shared::SLOT_IMPORTANCE_OFFSETS, photons.pathOffsets)
        .read(shared::SLOT_IMPORTANCE_SLOTS, cells.photonSlots)
        .read(shared::SLOT_IMPORTANCE_TABLE, grid.table)
        .read(shared::SLOT_IMPORTANCE_LOOK_UPS, lookUps);
    const graph::Buffer importance =
        node.write(shared::SLOT_IMPORTANCE,
                   frame.buffer("path importance", {uint64_t{photons.pathCount} * sizeof(float)}));
    node.dispatch((photons.pathCount + 63) / 64);
    return importance;
}

PathSplit PathGuide::split(const std::vector<Emitter>& emitters, uint32_t paths) {
    double power = 0.0;
    for (const Emitter& emitter : emitters) power += mean(emitter.powerWatts);
    std::vector<Layout> layout;
    std::vector<EmitterPart> parts;
    for (const Emitter& emitter : emitters) {
        const double own = paths * mean(emitter.powerWatts) / power;
        uint32_t sides = kMostSides;
        while (sides > 0 && own < kPathsPerPart * 2.0 * sides * sides) sides /= 2;
        layout.push_back({emitter.kind, emitter.index, sides});
        addParts(emitter, sides, parts);
    }
    if (layout != layout_) {
        layout_ = std::move(layout);
        squares_.assign(parts.size(), 0.0);
        learned_ = false;
    }
    return splitPaths(parts, paths, worthOf(parts));
}

std::vector<double> PathGuide::worthOf(const std::vector<EmitterPart>& parts) const {
    // The picture's variance is Σ (Φσ)² / n over the parts: least with n by Φσ.                [P6]
    std::vector<double> noise(parts.size());
    double power = 0.0;
    for (size_t i = 0; i < parts.size(); ++i) {
        noise[i] = mean(parts[i].emitter.sampledWatts) * std::sqrt(squares_[i]);
        power += mean(parts[i].emitter.powerWatts);
    }
    const double all = std::accumulate(noise.begin(), noise.end(), 0.0);
    if (!learned_ || all <= 0.0) return {};
    std::vector<double> worth(parts.size());
    for (size_t i = 0; i < parts.size(); ++i)
        worth[i] = kUnguided + (1.0 - kUnguided) * (noise[i] / all) /
                                   (mean(parts[i].emitter.powerWatts) / power);
    return worth;
}

void PathGuide::learn(const PathSplit& split, std::span<const float> importance) {
    CHECK(split.ranges.size() == squares_.size());
    CHECK(importance.size() == split.paths);
    for (size_t i = 0; i < split.ranges.size(); ++i) {
        const auto& range = split.ranges[i];
        double sum = 0.0;
        for (uint32_t p = 0; p < range.pathCount; ++p)
            sum += static_cast<double>(importance[range.firstPath + p]);
        const double watts =
            static_cast<double>(range.powerPerPath.w) / static_cast<double>(split.powerScale);
        if (watts <= 0.0) continue;
        const double square = sum / range.pathCount / (watts * watts);
        squares_[i] += (learned_ ? kNewest : 1.0) * (square - squares_[i]);
    }
    learned_ = true;
}

}  // namespace lampyris::photons
