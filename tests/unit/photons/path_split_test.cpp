#include "photons/path_split.h"

#include <gtest/gtest.h>

#include <numeric>

#include "photons/photon_trace.h"

namespace lampyris::photons {
namespace {

scene::SnapshotLight light(float watts, float cosOuter = -1.0f, float cosInner = -1.0f) {
    scene::SnapshotLight made;
    made.powerWatts = glm::vec3(watts, 2.0f * watts, 0.5f * watts);
    made.cosOuterCone = cosOuter;
    made.cosInnerCone = cosInner;
    return made;
}

glm::dvec3 carried(const PathSplit& split) {
    glm::dvec3 sum(0.0);
    for (const auto& range : split.ranges)
        sum += glm::dvec3(range.powerPerPath) * static_cast<double>(range.pathCount);
    return sum;
}

TEST(PathSplit, EmittedPowerSumsToThePowerOfAllLights) {
    const auto emitters = listEmitters({light(1.0f), light(700.0f), light(3.3f), light(0.01f)}, {});
    for (const uint32_t paths : {4u, 5u, 7u, 100u, 1000u, 99991u}) {
        const PathSplit split = splitPaths(emitters, paths);
        EXPECT_EQ(split.paths, paths);
        EXPECT_NEAR(carried(split).x, 704.31, 704.31 * 1e-6);
        EXPECT_NEAR(carried(split).y, 2.0 * 704.31, 704.31 * 2e-6);
    }
}

TEST(PathSplit, SharesFollowPowerAndCoverEveryPathOnce) {
    const auto emitters = listEmitters({light(1.0f), light(3.0f)}, {});
    const PathSplit split = splitPaths(emitters, 1002);
    ASSERT_EQ(split.ranges.size(), 2u);
    EXPECT_EQ(split.ranges[0].firstPath, 0u);
    EXPECT_EQ(split.ranges[0].pathCount, 251u);
    EXPECT_EQ(split.ranges[1].firstPath, 251u);
    EXPECT_EQ(split.ranges[1].pathCount, 751u);
}

TEST(PathSplit, GivesEveryEmitterAPathEvenWhereTooFewWereAskedFor) {
    const auto emitters = listEmitters({light(1.0f), light(1000.0f), light(2.0f)}, {});
    const PathSplit split = splitPaths(emitters, 1);
    EXPECT_EQ(split.paths, 3u);
    for (const auto& range : split.ranges) EXPECT_EQ(range.pathCount, 1u);
}

TEST(PathSplit, LeavesOutWhatDoesNotShine) {
    EXPECT_TRUE(listEmitters({light(0.0f)}, {}).empty());
    EXPECT_EQ(splitPaths(std::vector<Emitter>{}, 1000).paths, 0u);
    shared::GpuEmitter panel{};
    panel.power = {3.0f, 3.0f, 3.0f, 3.0f};
    panel.triangleCount = 2;
    const auto emitters = listEmitters({light(0.0f), light(1.0f)}, {panel});
    ASSERT_EQ(emitters.size(), 2u);
    EXPECT_EQ(emitters[0].index, 1u);
    EXPECT_EQ(emitters[1].kind, shared::EMIT_SURFACE);
    EXPECT_TRUE(splitPaths(emitters, 10).anySurface);
}

TEST(PathSplit, SpotPowerIsTheConesShareWithItsFalloff) {
    // Half space, no falloff: half the power. Falloff from the pole to 60°: a third of that cone's
    // quarter.
    const auto hard = listEmitters({light(8.0f, 0.0f, 0.0f)}, {});
    EXPECT_FLOAT_EQ(hard[0].powerWatts.x, 4.0f);
    const auto soft = listEmitters({light(8.0f, 0.5f, 1.0f)}, {});
    EXPECT_FLOAT_EQ(soft[0].sampledWatts.x, 2.0f);
    EXPECT_FLOAT_EQ(soft[0].powerWatts.x, 2.0f / 3.0f);
}

TEST(BatchPaths, CoversAllPathsAndStagesNoMoreThanAStorageBufferHolds) {
    PathSplit split;
    split.paths = 7654321;
    for (const uint32_t bounces : {1u, 8u, 30u}) {
        const auto batches = batchPaths(split, bounces);
        uint32_t next = 0;
        for (const auto& batch : batches) {
            EXPECT_EQ(batch.firstPath, next);
            EXPECT_LE(uint64_t{batch.pathCount} * bounces * 32, uint64_t{128} << 20);
            next += batch.pathCount;
        }
        EXPECT_EQ(next, split.paths);
    }
    EXPECT_EQ(batchPaths(split, 1, 1000000).size(), 8u);
}

}  // namespace
}  // namespace lampyris::photons
