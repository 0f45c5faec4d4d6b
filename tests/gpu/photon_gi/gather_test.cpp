// Gathering from bins against gathering over all photons on the CPU.
#include "photon_gi/gather.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "deferred/show_surface.h"
#include "deferred/view.h"
#include "glm/gtc/packing.hpp"
#include "shared/tile_bin.h"
#include "support/frame_test.h"
#include "support/scene_frame.h"

namespace lampyris {
namespace {

glm::dvec3 directionOf(uint32_t bits) {
    const glm::dvec2 e(glm::unpackSnorm2x16(bits));
    glm::dvec3 v(e, 1.0 - std::abs(e.x) - std::abs(e.y));
    if (v.z < 0.0) {
        const glm::dvec2 p(v);
        v.x = (1.0 - std::abs(p.y)) * (p.x >= 0.0 ? 1.0 : -1.0);
        v.y = (1.0 - std::abs(p.x)) * (p.y >= 0.0 ? 1.0 : -1.0);
    }
    return glm::normalize(v);
}

/// Equation G1 over all photons, in doubles: the green channel.
double estimate(const std::vector<shared::PackedPhoton>& photons, uint32_t count,
                const glm::dvec3& position, const glm::dvec3& normal, double radius,
                double powerScale) {
    double sum = 0.0;
    for (uint32_t i = 0; i < count; ++i) {
        const auto& words = photons[i].positionPower;
        const glm::dvec3 p(std::bit_cast<float>(words.x), std::bit_cast<float>(words.y),
                           std::bit_cast<float>(words.z));
        const double d = glm::distance(p, position);
        if (d >= radius || glm::dot(directionOf(photons[i].powerDirection.y), normal) >= 0.0)
            continue;
        sum += static_cast<double>(glm::unpackHalf2x16(words.w).y) * (1.0 - d / radius);
    }
    return sum * powerScale / ((1.0 - 2.0 / 3.0) * M_PI * radius * radius);
}

class Gather : public test::FrameTest {
 protected:
    static void compare(uint32_t paths, float radius) {
        const scene::SceneSnapshot snapshot = test::builtinSnapshot("cornell");
        test::SceneFrame on(device(), snapshot);
        const auto view = deferred::makeView(
            test::lookFrom({0.0f, 9.8f, 4.5f}, {0.0f, 0.0f, 0.5f}, 60.0f), {64, 36});
        const auto surface = deferred::addGBuffer(on.frame, view, on.handles, on.scene.draws());
        deferred::publishSurface(on.frame, surface);
        const auto bounds = deferred::addTileBounds(on.frame, surface);
        const photon_gi::GatherSettings settings{radius, 1};
        auto edges = photon_gi::addEdges(on.frame, surface, on.counters, settings);
        const auto split = photons::splitPaths(photons::listEmitters(snapshot.lights, {}), paths);
        const auto list =
            photons::addPhotonTrace(on.frame, on.handles, on.tree, split, {0, split.paths},
                                    {8, true, 7, 4 * paths}, edges.counters);
        const auto bins = photon_gi::addTileBin(on.frame, list, bounds, view, {radius, 1u << 23});
        edges.counters = bins.counters;
        const auto gathered =
            photon_gi::addGather(on.frame, surface, list, bins, edges, settings, {});
        const auto result =
            on.run({list.photons, list.pathOffsets, bins.counters},
                   {gathered.coarse, on.frame.published("position"), on.frame.published("normal")});
        const core::Image e = execute::toImage(result.images[0]);
        const core::Image x = execute::toImage(result.images[1]);
        const core::Image n = execute::toImage(result.images[2]);
        const auto photons = test::valuesOf<shared::PackedPhoton>(result.buffers[0]);
        const uint32_t count = test::valuesOf<uint32_t>(result.buffers[1])[split.paths];
        const auto counted = test::valuesOf<shared::FrameCounters>(result.buffers[2])[0];
        ASSERT_EQ(counted.pairsDropped, 0u);
        ASSERT_LT(counted.mostInTile, photon_gi::kMostPhotonsInTile);
        for (uint32_t py = 0; py < 36; py += 3)
            for (uint32_t px = 0; px < 64; px += 5) {
                if (e.at(px, py, 1) == 0.0f) continue;
                const glm::dvec3 position(x.at(px, py, 0), x.at(px, py, 1), x.at(px, py, 2));
                const glm::dvec3 normal(n.at(px, py, 0), n.at(px, py, 1), n.at(px, py, 2));
                const double expected =
                    estimate(photons, count, position, normal, radius, split.powerScale);
                ASSERT_NEAR(e.at(px, py, 1), expected, 2e-3 * expected) << px << "," << py;
            }
    }
};

TEST_F(Gather, EqualsTheSumOverAllPhotons) {
    compare(2000, 0.8f);
}

TEST_F(Gather, EqualsItAtManyPhotonsAPixelToo) {
    compare(100000, 0.3f);
}

}  // namespace
}  // namespace lampyris
