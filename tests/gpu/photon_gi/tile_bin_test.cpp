// Both ways of binning against a plain loop over tiles and photons, and against each other.
#include "photon_gi/tile_bin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "deferred/view.h"
#include "photon_gi/tile_test.h"
#include "shared/tile_bin.h"
#include "support/frame_test.h"
#include "support/scene_frame.h"

namespace lampyris {
namespace {

struct Lists {
    std::vector<glm::uvec2> ranges;
    std::vector<uint32_t> indices;
    std::vector<shared::PackedPhoton> photons;
    std::vector<glm::vec2> bounds;
    uint32_t photonCount = 0;
    shared::FrameCounters counters{};
};

struct Trial {
    graph::Extent size{200, 117};
    uint32_t paths = 500;
    uint32_t bounces = 4;
    float radius = 0.7f;
    uint32_t pairCapacity = 1u << 20;
    uint32_t photonCapacity = 4000;
    bool thesis = false;
    glm::vec3 eye{0.13f, 5.07f, 12.0f};
};

class TileBin : public test::FrameTest {
 protected:
    static Lists bin(const Trial& trial) {
        const scene::SceneSnapshot snapshot = test::builtinSnapshot("cornell");
        test::SceneFrame on(device(), snapshot);
        const auto view =
            deferred::makeView(test::lookFrom(trial.eye, {0.13f, 5.07f, 0.0f}, 50.0f), trial.size);
        const auto surface = deferred::addGBuffer(on.frame, view, on.handles, on.scene.draws());
        const auto bounds = deferred::addTileBounds(on.frame, surface);
        const auto split =
            photons::splitPaths(photons::listEmitters(snapshot.lights, {}), trial.paths);
        const auto list =
            photons::addPhotonTrace(on.frame, on.handles, on.tree, split, {0, split.paths},
                                    {trial.bounces, true, 7, trial.photonCapacity}, on.counters);
        const photon_gi::TileSettings settings{trial.radius, trial.pairCapacity};
        const auto bins = trial.thesis
                              ? photon_gi::addTileTest(on.frame, list, bounds, view, settings)
                              : photon_gi::addTileBin(on.frame, list, bounds, view, settings);
        const auto result = on.run({bins.ranges, bins.indices, list.photons, bounds.bounds,
                                    list.pathOffsets, bins.counters});
        Lists lists;
        lists.ranges = test::valuesOf<glm::uvec2>(result.buffers[0]);
        lists.indices = test::valuesOf<uint32_t>(result.buffers[1]);
        lists.photons = test::valuesOf<shared::PackedPhoton>(result.buffers[2]);
        lists.bounds = test::valuesOf<glm::vec2>(result.buffers[3]);
        lists.photonCount = test::valuesOf<uint32_t>(result.buffers[4])[split.paths];
        lists.counters = test::valuesOf<shared::FrameCounters>(result.buffers[5])[0];
        return lists;
    }

    static std::vector<uint32_t> listOf(const Lists& lists, size_t tile) {
        const auto first = lists.indices.begin() + lists.ranges[tile].x;
        return {first, first + lists.ranges[tile].y};
    }
};

/// The statement itself, in doubles: how far inside the tile's frustum a photon's sphere reaches,
/// in metres.
double reachInto(const Lists& lists, const Trial& trial, const shared::View& view, size_t tile,
                 uint32_t photon) {
    const auto& words = lists.photons[photon].positionPower;
    glm::vec3 world;
    std::memcpy(&world, &words, sizeof(world));
    const glm::vec4 v = view.worldToView * glm::vec4(world, 1.0f);
    const glm::dvec3 p(v.x, v.y, -v.z);
    const auto slopeX = [&](double px) {
        return (px / view.width * 2.0 - 1.0) / static_cast<double>(view.projection.x);
    };
    const auto slopeY = [&](double py) {
        return -(py / view.height * 2.0 - 1.0) / static_cast<double>(view.projection.y);
    };
    const auto tx = static_cast<double>(tile % view.tilesX) * 8.0;
    const size_t row = tile / view.tilesX;
    const auto ty = static_cast<double>(row) * 8.0;
    const auto plane = [](double slope, double axis, double depth) {
        return (slope * depth - axis) / std::sqrt(1.0 + slope * slope);
    };
    const double outside =
        std::max({plane(slopeX(tx), p.x, p.z), -plane(slopeX(tx + 8.0), p.x, p.z),
                  plane(slopeY(ty + 8.0), p.y, p.z), -plane(slopeY(ty), p.y, p.z),
                  static_cast<double>(lists.bounds[tile].x) - p.z,
                  p.z - static_cast<double>(lists.bounds[tile].y)});
    return static_cast<double>(trial.radius) - outside;
}

TEST_F(TileBin, HoldsExactlyThePhotonsThatBruteForceFindsInPhotonOrder) {
    for (const bool thesis : {false, true}) {
        Trial trial;
        trial.thesis = thesis;
        const Lists lists = bin(trial);
        const auto view =
            deferred::makeView(test::lookFrom(trial.eye, {0.13f, 5.07f, 0.0f}, 50.0f), trial.size);
        ASSERT_GT(lists.photonCount, 500u);
        ASSERT_EQ(lists.counters.pairsDropped, 0u);
        size_t pairs = 0;
        for (size_t tile = 0; tile < lists.ranges.size(); ++tile) {
            const auto list = listOf(lists, tile);
            pairs += list.size();
            ASSERT_TRUE(std::is_sorted(list.begin(), list.end()));
            ASSERT_EQ(std::adjacent_find(list.begin(), list.end()), list.end());
            const bool empty = lists.bounds[tile].x > lists.bounds[tile].y;
            for (uint32_t photon = 0; photon < lists.photonCount; ++photon) {
                const double reach = empty ? -1.0 : reachInto(lists, trial, view, tile, photon);
                if (std::abs(reach) < 1e-4) continue;  // within rounding of the boundary
                ASSERT_EQ(std::binary_search(list.begin(), list.end(), photon), reach > 0.0)
                    << "tile " << tile << " photon " << photon << " reach " << reach << " thesis "
                    << thesis;
            }
        }
        EXPECT_GT(pairs, 3000u);
        EXPECT_EQ(lists.counters.pairs, pairs);
    }
}

TEST_F(TileBin, FullAndThesisMakeTheSameLists) {
    for (const auto size : {graph::Extent{200, 117}, graph::Extent{480, 270}, graph::Extent{8, 8},
                            graph::Extent{1, 1}})
        for (const glm::vec3 eye : {glm::vec3(0.13f, 5.07f, 12.0f), glm::vec3(0.1f, 5.0f, 0.3f)}) {
            Trial trial;
            trial.size = size;
            trial.eye = eye;
            const Lists full = bin(trial);
            trial.thesis = true;
            const Lists thesis = bin(trial);
            ASSERT_EQ(full.ranges.size(), thesis.ranges.size());
            for (size_t tile = 0; tile < full.ranges.size(); ++tile)
                ASSERT_EQ(listOf(full, tile), listOf(thesis, tile))
                    << size.width << " tile " << tile;
            EXPECT_EQ(full.counters.mostInTile, thesis.counters.mostInTile);
        }
}

// More tiles than a shader's loops have turns on lavapipe, under spheres without an outline.
TEST_F(TileBin, ManyTilesAPhotonMakeTheSameListsToo) {
    Trial trial;
    trial.size = {3840, 2160};
    trial.eye = {0.1f, 5.0f, 0.3f};
    trial.paths = 20;
    trial.radius = 4.0f;
    trial.pairCapacity = 1u << 23;
    const Lists full = bin(trial);
    trial.thesis = true;
    const Lists thesis = bin(trial);
    ASSERT_EQ(thesis.counters.pairsDropped, 0u);
    ASSERT_GT(thesis.counters.pairs, 500000u);
    EXPECT_EQ(full.counters.pairs, thesis.counters.pairs);
    EXPECT_EQ(full.ranges, thesis.ranges);
    const auto pairs = static_cast<std::ptrdiff_t>(thesis.counters.pairs);
    EXPECT_TRUE(
        std::equal(full.indices.begin(), full.indices.begin() + pairs, thesis.indices.begin()));
}

TEST_F(TileBin, ManyPhotonsATileMakeTheSameListsToo) {
    Trial trial;
    trial.size = {64, 36};
    trial.paths = 300000;
    trial.radius = 0.4f;
    trial.photonCapacity = 1500000;
    trial.pairCapacity = 1u << 24;
    const Lists full = bin(trial);
    trial.thesis = true;
    const Lists thesis = bin(trial);
    ASSERT_GT(full.counters.mostInTile, 20000u);
    for (size_t tile = 0; tile < full.ranges.size(); ++tile) {
        const auto a = listOf(full, tile);
        const auto b = listOf(thesis, tile);
        ASSERT_EQ(a.size(), b.size()) << tile;
        ASSERT_EQ(a, b) << tile;
    }
}

TEST_F(TileBin, CountsWhatDoesNotFitAndWhatWouldHaveBeenNeeded) {
    for (const bool thesis : {false, true}) {
        Trial trial;
        trial.thesis = thesis;
        const Lists whole = bin(trial);
        trial.pairCapacity = 2000;
        const Lists cut = bin(trial);
        EXPECT_EQ(cut.counters.pairs, 2000u);
        EXPECT_EQ(cut.counters.pairsDropped, whole.counters.pairs - 2000);
        EXPECT_EQ(cut.counters.pairsNeeded, whole.counters.pairs);
    }
}

TEST_F(TileBin, CountsPhotonsThatTheStoreCannotHold) {
    Trial trial;
    const Lists whole = bin(trial);
    trial.photonCapacity = 300;
    const Lists cut = bin(trial);
    EXPECT_EQ(cut.counters.photonsStored, 300u);
    EXPECT_EQ(cut.counters.photonsDropped, whole.counters.photonsStored - 300);
    EXPECT_EQ(cut.counters.photonsNeeded, whole.counters.photonsStored);
    for (size_t i = 0; i < 300; ++i)
        ASSERT_EQ(cut.photons[i].powerDirection, whole.photons[i].powerDirection);
}

}  // namespace
}  // namespace lampyris
