#include "photons/path_split.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/check.h"

namespace lampyris::photons {
namespace {

float mean(const glm::vec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0f;
}
float largest(const glm::vec3& rgb) {
    return std::max({rgb.x, rgb.y, rgb.z});
}

Emitter sphereEmitter(uint32_t index, const scene::SnapshotLight& light) {
    Emitter emitter{shared::EMIT_SPHERE, index, light.powerWatts, light.powerWatts};
    if (light.cosOuterCone > -1.0f) {
        // Share of all directions, and of it what the squared falloff between the cones lets
        // through.
        const float outer = 0.5f * (1.0f - light.cosOuterCone);
        const float inner = 0.5f * (1.0f - light.cosInnerCone);
        emitter.sampledWatts = light.powerWatts * outer;
        emitter.powerWatts = light.powerWatts * (inner + (outer - inner) / 3.0f);
    }
    return emitter;
}

/// Whole shares that sum to `total`, at least one each.
std::vector<uint32_t> apportion(const std::vector<double>& weights, uint32_t total) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto spare = static_cast<double>(total - weights.size());
    std::vector<uint32_t> shares(weights.size(), 1);
    std::vector<double> remainders(weights.size());
    auto given = static_cast<uint32_t>(weights.size());
    for (size_t i = 0; i < weights.size(); ++i) {
        const double exact = spare * weights[i] / sum;
        const auto whole = static_cast<uint32_t>(std::floor(exact));
        shares[i] += whole;
        given += whole;
        remainders[i] = exact - whole;
    }
    std::vector<size_t> order(weights.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return remainders[a] > remainders[b]; });
    for (size_t i = 0; given < total; i = (i + 1) % order.size(), ++given) ++shares[order[i]];
    return shares;
}

}  // namespace

std::vector<Emitter> listEmitters(const std::vector<scene::SnapshotLight>& lights,
                                  const std::vector<shared::GpuEmitter>& emissive) {
    std::vector<Emitter> emitters;
    for (uint32_t i = 0; i < lights.size(); ++i) {
        const Emitter emitter = sphereEmitter(i, lights[i]);
        if (mean(emitter.powerWatts) > 0.0f) emitters.push_back(emitter);
    }
    for (uint32_t i = 0; i < emissive.size(); ++i) {
        const glm::vec3 power(emissive[i].power);
        if (mean(power) > 0.0f && emissive[i].triangleCount > 0)
            emitters.push_back({shared::EMIT_SURFACE, i, power, power});
    }
    return emitters;
}

PathSplit splitPaths(const std::vector<EmitterPart>& parts, uint32_t paths,
                     std::span<const double> worth) {
    CHECK((worth.empty() || worth.size() == parts.size()));
    PathSplit split;
    if (parts.empty() || paths == 0) return split;
    split.paths = std::max(paths, static_cast<uint32_t>(parts.size()));
    std::vector<double> weights(parts.size());
    for (size_t i = 0; i < parts.size(); ++i)
        weights[i] = static_cast<double>(mean(parts[i].emitter.powerWatts)) *
                     (worth.empty() ? 1.0 : worth[i]);
    const std::vector<uint32_t> shares = apportion(weights, split.paths);
    uint32_t first = 0;
    split.powerScale = 0.0f;
    for (size_t i = 0; i < parts.size(); ++i) {
        const Emitter& emitter = parts[i].emitter;
        const glm::vec3 perPath = emitter.sampledWatts / static_cast<float>(shares[i]);
        split.ranges.push_back({first, shares[i], emitter.kind, emitter.index,
                                glm::vec4(perPath, mean(perPath)), parts[i].square});
        first += shares[i];
        // A glowing triangle may hold all the power of a path in one channel.
        const bool surface = emitter.kind == shared::EMIT_SURFACE;
        split.powerScale =
            std::max(split.powerScale, surface ? 3.0f * mean(perPath) : largest(perPath));
        split.anySurface = split.anySurface || surface;
    }
    return split;
}

PathSplit splitPaths(const std::vector<Emitter>& emitters, uint32_t paths) {
    std::vector<EmitterPart> parts;
    parts.reserve(emitters.size());
    for (const Emitter& emitter : emitters) parts.push_back({emitter});
    return splitPaths(parts, paths);
}

bool repower(PathSplit& split, const std::vector<Emitter>& emitters) {
    // Ranges stand emitter by emitter; the parts of one have the same share of its power.
    size_t first = 0;
    std::vector<shared::PathRange> ranges = split.ranges;
    for (const Emitter& emitter : emitters) {
        size_t end = first;
        const auto isOurs = [&](const shared::PathRange& range) {
            return range.index == emitter.index &&
                   (range.kind == shared::EMIT_SURFACE) == (emitter.kind == shared::EMIT_SURFACE);
        };
        while (end < ranges.size() && isOurs(ranges[end])) ++end;
        if (end == first) return false;
        const auto parts = static_cast<float>(end - first);
        for (; first < end; ++first) {
            const glm::vec3 perPath =
                emitter.sampledWatts / parts / static_cast<float>(ranges[first].pathCount);
            // [chosen] Photons keep power as halves in units of powerScale: far from their largest.
            if (largest(perPath) > 256.0f * split.powerScale) return false;
            ranges[first].powerPerPath = glm::vec4(perPath, mean(perPath));
        }
    }
    if (first != ranges.size()) return false;
    split.ranges = std::move(ranges);
    return true;
}

}  // namespace lampyris::photons
