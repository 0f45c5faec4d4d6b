#include "photons/path_guide.h"

#include <gtest/gtest.h>

#include <map>

namespace lampyris::photons {
namespace {

std::vector<Emitter> twoLights() {
    scene::SnapshotLight light;
    light.powerWatts = glm::vec3(30.0f, 60.0f, 90.0f);
    scene::SnapshotLight spot = light;
    spot.cosOuterCone = 0.5f;
    spot.cosInnerCone = 0.9f;
    return listEmitters({light, spot}, {});
}

/// Importance of one for the paths of every range that `matters` picks, else nothing.
template <typename Matters>
std::vector<float> importanceOf(const PathSplit& split, Matters matters) {
    std::vector<float> importance;
    for (const auto& range : split.ranges)
        importance.insert(importance.end(), range.pathCount, matters(range) ? 1.0f : 0.0f);
    return importance;
}

std::map<uint32_t, double> wattsByLight(const PathSplit& split) {
    std::map<uint32_t, double> watts;
    for (const auto& range : split.ranges)
        watts[range.index] +=
            static_cast<double>(range.powerPerPath.y) * static_cast<double>(range.pathCount);
    return watts;
}

uint32_t pathsOf(const PathSplit& split, uint32_t light) {
    uint32_t paths = 0;
    for (const auto& range : split.ranges)
        if (range.index == light) paths += range.pathCount;
    return paths;
}

TEST(PathGuide, PartsCoverTheSquareOfEachEmitterOnce) {
    PathGuide guide;
    const auto split = guide.split(twoLights(), 4000);
    EXPECT_EQ(split.paths, 4000u);
    std::map<uint32_t, double> area;
    uint32_t next = 0;
    for (const auto& range : split.ranges) {
        area[range.index] += static_cast<double>(range.part.z * range.part.w);
        EXPECT_EQ(range.kind, shared::EMIT_DIRECTION);
        EXPECT_EQ(range.firstPath, next);
        next += range.pathCount;
        EXPECT_LE(range.part.x + range.part.z, 1.0f);
        EXPECT_LE(range.part.y + range.part.w, 1.0f);
    }
    EXPECT_EQ(next, 4000u);
    EXPECT_GT(split.ranges.size(), 64u);
    EXPECT_DOUBLE_EQ(area[0], 1.0);
    EXPECT_DOUBLE_EQ(area[1], 1.0);
}

TEST(PathGuide, MovesPathsButNoPower) {
    PathGuide guide;
    const auto emitters = twoLights();
    const auto before = guide.split(emitters, 4000);
    const auto lower = [](const shared::PathRange& range) {
        return range.index == 0 && range.part.x < 0.5f;
    };
    guide.learn(before, importanceOf(before, lower));
    const auto after = guide.split(emitters, 4000);
    ASSERT_EQ(after.ranges.size(), before.ranges.size());
    const auto watts = wattsByLight(after);
    EXPECT_NEAR(watts.at(0), 60.0, 1e-4 * 60.0);  // green, of the light that shines every way
    for (const auto& [light, expected] : wattsByLight(before))
        EXPECT_NEAR(watts.at(light), expected, 1e-5 * expected);
    for (size_t i = 0; i < after.ranges.size(); ++i) {
        const double ratio = static_cast<double>(after.ranges[i].pathCount) /
                             static_cast<double>(before.ranges[i].pathCount);
        if (lower(before.ranges[i]))
            EXPECT_GT(ratio, 1.5);
        else
            EXPECT_NEAR(ratio, 0.25, 0.15);  // the share that follows power alone; whole paths
    }
}

TEST(PathGuide, ForgetsWhatChanged) {
    PathGuide guide;
    const auto emitters = twoLights();
    const auto first = guide.split(emitters, 4000);
    const auto of0 = [](const shared::PathRange& range) { return range.index == 0; };
    const auto of1 = [](const shared::PathRange& range) { return range.index == 1; };
    guide.learn(first, importanceOf(first, of0));
    EXPECT_GT(pathsOf(guide.split(emitters, 4000), 0), pathsOf(first, 0));
    for (int frame = 0; frame < 60; ++frame) {
        const auto split = guide.split(emitters, 4000);
        guide.learn(split, importanceOf(split, of1));
    }
    EXPECT_LT(pathsOf(guide.split(emitters, 4000), 0), pathsOf(first, 0));
    // Other emitters: nothing is known of them.
    const std::vector<Emitter> one{emitters.front()};
    const auto fresh = guide.split(one, 1000);
    for (const auto& range : fresh.ranges)
        EXPECT_NEAR(range.pathCount, 1000.0 / static_cast<double>(fresh.ranges.size()), 1.0);
}

TEST(PathGuide, NothingThatMatteredLeavesTheSplitByPower) {
    PathGuide guide;
    const auto first = guide.split(twoLights(), 2000);
    guide.learn(first, std::vector<float>(2000, 0.0f));
    const auto second = guide.split(twoLights(), 2000);
    for (size_t i = 0; i < first.ranges.size(); ++i)
        EXPECT_EQ(first.ranges[i].pathCount, second.ranges[i].pathCount);
}

TEST(PathGuide, ALightTooFaintForAFloatDoesNoHarm) {
    auto emitters = twoLights();
    emitters[1].powerWatts = emitters[1].sampledWatts = glm::vec3(1e-42f);
    PathGuide guide;
    const auto first = guide.split(emitters, 2000);
    guide.learn(first, std::vector<float>(2000, 1.0f));
    const auto second = guide.split(emitters, 2000);
    ASSERT_EQ(second.ranges.size(), first.ranges.size());
    EXPECT_EQ(pathsOf(second, 1), 1u);
    EXPECT_EQ(pathsOf(second, 0), 1999u);
}

TEST(PathGuide, FewPathsAreNotCutUp) {
    PathGuide guide;
    EXPECT_EQ(guide.split(twoLights(), 6).ranges.size(), 2u);
}

}  // namespace
}  // namespace lampyris::photons
