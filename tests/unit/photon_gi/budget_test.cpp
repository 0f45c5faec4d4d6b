// The budget against devices that are made up: slower or faster than the model, of other shape,
// trembling, under loads that step.
#include "photon_gi/budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace lampyris::photon_gi {
namespace {

constexpr graph::Extent kSize{640, 360};

Settings fine() {
    Settings s;
    s.photonPaths = 16000;
    s.radiusMetres = 0.5f;
    s.gatherDivisor = 4;
    s.gatherRays = 6;
    s.gridColumns = 12;
    return s;
}

/// What it takes for what the model says.
using Device = std::function<IndirectCost(IndirectCost)>;

/// Each part by itself.
Device eachPart(double (*milliseconds)(double)) {
    return [milliseconds](IndirectCost m) -> IndirectCost {
        return {milliseconds(m.photons), milliseconds(m.gather), milliseconds(m.upsample)};
    };
}

/// What frames took on a device whose times tremble, one in fifty threefold.
class Frames {
 public:
    Frames(Budget& budget, Device device, double noise)
        : budget_(budget), device_(std::move(device)), noise_(0.0, noise) {}

    void draw(uint32_t frames, double load = 1.0, graph::Extent size = kSize,
              const Settings& asked = fine()) {
        for (uint32_t i = 0; i < frames; ++i) {
            const Settings given = budget_.next(asked, size);
            // Kept paths are traced anew where their number changes.
            const double change = given.photonPaths == last_.photonPaths ? 1.0 : 1.3;
            last_ = given;
            const IndirectCost taken = device_(modelCost(given, size)).times(load);
            quiet_.push_back(taken.sum());
            const double outlier = random_() % 50 == 0 ? 3.0 : 1.0;
            budget_.learn(taken.times(change * outlier * std::exp(noise_(random_))));
        }
    }
    /// Of the last frames, without what was trembling.
    [[nodiscard]] double median(size_t frames = 20) const {
        std::vector<double> last(quiet_.end() - static_cast<std::ptrdiff_t>(frames), quiet_.end());
        std::sort(last.begin(), last.end());
        return last[last.size() / 2];
    }

 private:
    Budget& budget_;
    Device device_;
    std::normal_distribution<double> noise_;
    std::mt19937 random_{7};
    std::vector<double> quiet_;
    Settings last_;
};

const std::vector<std::pair<const char*, Device>>& devices() {
    static const std::vector<std::pair<const char*, Device>> list{
        {"as the model", eachPart([](double m) { return m; })},
        {"fifty times as fast", eachPart([](double m) { return m / 50.0; })},
        {"flatter", eachPart([](double m) { return 3.0 * std::pow(m, 0.7); })},
        {"steeper", eachPart([](double m) { return 0.05 * std::pow(m, 1.3); })},
        {"with a cost that nothing changes", eachPart([](double m) { return 0.5 * m + 10.0; })},
        {"with few edges",
         [](IndirectCost m) {
             return m.times({1.0, 3.0, 0.2});
         }},
        {"with many edges", [](IndirectCost m) {
             return m.times({1.0, 0.3, 4.0});
         }}};
    return list;
}

struct Range {
    double most, least;
};
/// What a device takes for all that was asked for, and for the least.
Range rangeOf(const Device& device) {
    CostCurve curve(fine(), kSize);
    const auto costAt = [&](const Place& place) {
        return device(modelCost(curve.settingsAt(place), kSize));
    };
    const IndirectCost most = costAt({});
    const IndirectCost model = modelCost(fine(), kSize);
    curve.setFactors(
        {most.photons / model.photons, most.gather / model.gather, most.upsample / model.upsample});
    return {most.sum(), costAt(curve.least()).sum()};
}

TEST(Budget, MeetsTheMillisecondsWhileTheLoadSteps) {
    for (const auto& [name, device] : devices())
        for (const double noise : {0.0, 0.05, 0.1}) {
            const double loads = 1.5;
            const auto [most, least] = rangeOf(device);
            ASSERT_GT(most, 1.1 * loads * least) << name << ": no budget meets both loads";
            const double wanted = std::sqrt(most * loads * least);
            Budget budget(wanted);
            Frames frames(budget, device, noise);
            for (int step = 0; step < 6; ++step) {
                frames.draw(80, step % 2 == 0 ? 1.0 : loads);
                EXPECT_NEAR(frames.median() / wanted, 1.0, 0.1)
                    << name << ", noise " << noise << ", step " << step;
                EXPECT_FALSE(budget.state().outOfReach);
            }
        }
}

TEST(Budget, DoesNotHunt) {
    for (const auto& [name, device] : devices())
        for (const double share : {0.2, 0.4, 0.6, 0.8}) {
            const auto [most, least] = rangeOf(device);
            Budget budget(std::pow(most, share) * std::pow(least, 1.0 - share));
            Frames frames(budget, device, 0.05);
            frames.draw(60);
            const BudgetState before = budget.state();
            frames.draw(1000);
            EXPECT_LE(budget.state().begun - before.begun, 2u) << name << ", " << share;
            EXPECT_LE(budget.state().changes - before.changes, 8u) << name << ", " << share;
        }
}

TEST(Budget, GivesBackAllThatWasAskedForAndNoMore) {
    Budget budget(0.5 * modelCost(fine(), kSize).sum());
    Frames frames(budget, devices()[0].second, 0.05);
    frames.draw(100);
    EXPECT_LT(budget.state().quality, 1.0);
    EXPECT_NE(whatWasGivenUp(fine(), budget.state().given), "");
    budget.setMilliseconds(10.0 * modelCost(fine(), kSize).sum());
    frames.draw(200);
    EXPECT_EQ(budget.state().given, fine());
    EXPECT_EQ(budget.state().quality, 1.0);
    EXPECT_EQ(whatWasGivenUp(fine(), budget.state().given), "");
}

TEST(Budget, SaysWhatIsOutOfReach) {
    const CostCurve curve(fine(), kSize);
    const double least = curve.costAt(curve.least());
    Budget budget(0.5 * least);
    Frames frames(budget, devices()[0].second, 0.05);
    frames.draw(200);
    EXPECT_TRUE(budget.state().outOfReach);
    EXPECT_EQ(budget.state().quality, 0.0);
    const uint32_t changes = budget.state().changes;
    frames.draw(1000);
    EXPECT_EQ(budget.state().changes, changes);
    budget.setMilliseconds(1.2 * least);
    frames.draw(60);
    EXPECT_FALSE(budget.state().outOfReach);
}

TEST(Budget, FollowsAnotherSizeAtOnce) {
    const double wanted = 0.5 * modelCost(fine(), kSize).sum();
    Budget budget(wanted);
    Frames frames(budget, devices()[1].second, 0.02);
    budget.setMilliseconds(wanted / 50.0);
    frames.draw(80);
    const graph::Extent smaller{480, 270};
    frames.draw(1, 1.0, smaller);
    EXPECT_NEAR(frames.median(1) / (wanted / 50.0), 1.0, 0.1);
}

TEST(Budget, LearnsNothingFromFramesThatDrewNothing) {
    Budget budget(0.5 * modelCost(fine(), kSize).sum());
    Frames frames(budget, devices()[0].second, 0.0);
    frames.draw(60);
    const Settings given = budget.state().given;
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(budget.next(fine(), kSize), given);
        budget.learn({});
    }
}

TEST(Budget, LeavesAloneWhatIsNoFinalGather) {
    Settings tiles = fine();
    tiles.gather = Gather::Tiles;
    Budget budget(0.001);
    for (int i = 0; i < 50; ++i) {
        EXPECT_EQ(budget.next(tiles, kSize), tiles);
        budget.learn({100.0, 100.0, 100.0});
    }
    EXPECT_FALSE(budget.state().outOfReach);
}

TEST(Budget, TellsWhatWasGivenUp) {
    Settings given = fine();
    given.photonPaths = 9000;
    given.radiusMetres = 0.6f;
    given.gatherRays = 4;
    given.gatherDivisor = 5;
    EXPECT_EQ(whatWasGivenUp(fine(), given),
              "paths 16000 → 9000, radius 0.5 → 0.6, gather rays 6 → 4, gather divisor 4 → 5");
}

TEST(CostCurve, FallsAllTheWayDown) {
    for (const Settings& asked : {fine(), Settings{}})
        for (const IndirectCost& factors :
             {IndirectCost{1.0, 1.0, 1.0}, {1.0, 3.0, 0.2}, {0.02, 0.1, 0.02}}) {
            CostCurve curve(asked, kSize);
            curve.setFactors(factors);
            EXPECT_EQ(curve.settingsAt({}), asked);
            EXPECT_EQ(curve.quality({}), 1.0);
            EXPECT_EQ(curve.quality(curve.least()), 0.0);
            EXPECT_TRUE(curve.isLeast(curve.least()));
            for (size_t level = 0; level <= curve.least().level; ++level) {
                for (int i = 0; i < 10; ++i)
                    EXPECT_GE(curve.costAt({level, 0.1 * (i + 1)}), curve.costAt({level, 0.1 * i}));
                if (level == 0) continue;
                EXPECT_LT(curve.costAt({level, 1.0}), curve.costAt({level - 1, 1.0}));
            }
        }
}

// A step is taken back at a cost well over that at which it was taken.
TEST(CostCurve, StepsOverlap) {
    const CostCurve curve(fine(), kSize);
    for (size_t level = 1; level <= curve.least().level; ++level)
        EXPECT_GT(curve.costAt({level, 1.0}),
                  1.08 * curve.costAt({level - 1, CostCurve::kStepShare}))
            << "level " << level;
}

TEST(CostCurve, ACoarserResolutionIsTakenOnlyWhereItSaves) {
    CostCurve curve(fine(), kSize);
    curve.setFactors({1.0, 3.0, 0.2});  // few edges
    EXPECT_GT(curve.settingsAt(curve.least()).gatherDivisor, 5u);
    curve.setFactors({1.0, 0.3, 4.0});  // many: pixels that stand alone take more than texels
    EXPECT_EQ(curve.settingsAt(curve.least()).gatherDivisor, 4u);
    EXPECT_EQ(curve.settingsAt(curve.least()).gatherRays, 1u);
}

TEST(CostCurve, FindsTheCostAndStaysWhereItCan) {
    const CostCurve curve(fine(), kSize);
    const double low = curve.costAt({2, CostCurve::kStepShare});
    const double high = curve.costAt({2, 1.0});
    const Place place = curve.find(std::sqrt(low * high), {2, 1.0});
    EXPECT_EQ(place.level, 2u);
    EXPECT_NEAR(curve.costAt(place), std::sqrt(low * high), 0.01 * high);
    EXPECT_EQ(curve.find(0.99 * low, {2, 1.0}).level, 3u);
    EXPECT_EQ(curve.find(0.99 * high, {2, 0.0}).level, 2u);
    EXPECT_EQ(curve.find(0.0, {}), curve.least());
    EXPECT_EQ(curve.find(1e9, curve.least()), Place{});
}

}  // namespace
}  // namespace lampyris::photon_gi
