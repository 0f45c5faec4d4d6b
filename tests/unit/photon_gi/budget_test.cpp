// The budget against devices that are made up: slower or faster than the model, of other shape,
// trembling, under loads that step.
#include "photon_gi/budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace lampyris::photon_gi {
namespace {

constexpr graph::Extent kSize{640, 360};
constexpr graph::Extent k720p{1280, 720};

Settings fine() {
    Settings s;
    s.photonPaths = 16000;
    s.radiusMetres = 0.5f;
    s.gatherDivisor = 4;
    s.gatherRays = 6;
    s.gridColumns = 12;
    return s;
}

/// Many paths and rays; and few, where rays outweigh paths.
struct Case {
    Settings asked;
    graph::Extent size;
};
std::vector<Case> cases() {
    return {{fine(), kSize}, {Settings{}, k720p}};
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
Range rangeOf(const Device& device, const Settings& asked = fine(), graph::Extent size = kSize) {
    CostCurve curve(asked, size);
    const auto costAt = [&](const Place& place) {
        return device(modelCost(curve.settingsAt(place), size));
    };
    const IndirectCost most = costAt({});
    const IndirectCost model = modelCost(asked, size);
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
    for (const auto& [asked, size] : cases())
        for (const auto& [name, device] : devices())
            for (const double share : {0.2, 0.4, 0.6, 0.8}) {
                const auto [most, least] = rangeOf(device, asked, size);
                Budget budget(std::pow(most, share) * std::pow(least, 1.0 - share));
                Frames frames(budget, device, 0.05);
                frames.draw(60, 1.0, size, asked);
                const BudgetState before = budget.state();
                frames.draw(1000, 1.0, size, asked);
                EXPECT_LE(budget.state().begun - before.begun, 2u) << name << ", " << share;
                EXPECT_LE(budget.state().changes - before.changes, 8u) << name << ", " << share;
            }
}

// There, one step is wider than a move: on devices that are steeper than the model too.
TEST(Budget, DoesNotHuntWhereRaysOutweighPaths) {
    for (const auto& [name, device] : devices()) {
        const double most = rangeOf(device, Settings{}, k720p).most;
        for (int percent = 40; percent < 105; percent += 2) {
            const double share = 0.01 * percent;
            Budget budget(share * most);
            Frames frames(budget, device, 0.0);
            frames.draw(200, 1.0, k720p, Settings{});
            const uint32_t changes = budget.state().changes;
            frames.draw(300, 1.0, k720p, Settings{});
            EXPECT_LE(budget.state().changes - changes, 1u) << name << ", " << share;
        }
    }
}

TEST(Budget, GivesBackAllThatWasAskedForAndNoMore) {
    for (const auto& [asked, size] : cases())
        for (const double share : {0.35, 0.5}) {
            const double most = modelCost(asked, size).sum();
            Budget budget(share * most);
            Frames frames(budget, devices()[0].second, 0.05);
            frames.draw(100, 1.0, size, asked);
            EXPECT_LT(budget.state().given.gatherRays, asked.gatherRays);
            EXPECT_LT(budget.state().quality, 1.0);
            EXPECT_NE(whatWasGivenUp(asked, budget.state().given), "");
            budget.setMilliseconds(10.0 * most);
            frames.draw(200, 1.0, size, asked);
            EXPECT_EQ(budget.state().given, asked);
            EXPECT_EQ(budget.state().quality, 1.0);
            EXPECT_EQ(whatWasGivenUp(asked, budget.state().given), "");
        }
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

TEST(Budget, LearnsWhileTheSizeChangesAllTheTime) {
    const double wanted = 0.5 * modelCost(fine(), kSize).sum();
    for (const uint32_t alike : {1u, 2u, 5u}) {
        Budget budget(wanted);
        Frames frames(budget, devices()[0].second, 0.05);
        for (const double load : {2.0, 1.3}) {
            for (uint32_t i = 0; i < 300 / alike; ++i)
                frames.draw(alike, load, i % 2 == 0 ? kSize : graph::Extent{560, 315});
            EXPECT_LT(frames.median(40) / wanted, 1.1) << alike << ", " << load;
            // Frames that change their paths take longer than the quiet ones that are looked at.
            EXPECT_GT(frames.median(40) / wanted, alike <= 2 ? 0.7 : 0.9) << alike << ", " << load;
        }
    }
}

TEST(Budget, SettingsThatCostNothingBeginNothingAnew) {
    const double wanted = 0.5 * modelCost(fine(), kSize).sum();
    Budget budget(wanted);
    Frames frames(budget, devices()[0].second, 0.05);
    Settings asked = fine();
    const auto draw = [&](uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            asked.seed += 1;
            asked.shadowRays = 4 + i % 3;
            asked.history = 60 + i % 2;
            frames.draw(1, 2.0, kSize, asked);
            EXPECT_EQ(budget.state().given.seed, asked.seed);
        }
    };
    draw(100);
    EXPECT_NEAR(frames.median() / wanted, 1.0, 0.1);
    const uint32_t changes = budget.state().changes;
    draw(500);
    EXPECT_NEAR(frames.median() / wanted, 1.0, 0.1);
    EXPECT_LE(budget.state().changes - changes, 5u);
}

TEST(Budget, OtherPathsBeginTheWayAnew) {
    Budget budget(0.3 * modelCost(fine(), kSize).sum());
    Frames frames(budget, devices()[0].second, 0.0);
    frames.draw(100);
    ASSERT_LT(budget.state().given.gatherRays, 6u);
    Settings fewer = fine();
    fewer.photonPaths = 300;
    fewer.gatherRays = 2;
    frames.draw(1, 1.0, kSize, fewer);
    EXPECT_EQ(budget.state().given, fewer);
}

TEST(Budget, TakesNoNumberThatIsNone) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double endless = std::numeric_limits<double>::infinity();
    Budget budget(0.5 * modelCost(fine(), kSize).sum());
    Frames frames(budget, devices()[0].second, 0.0);
    frames.draw(60);
    const Settings given = budget.state().given;
    const double took = budget.state().milliseconds;
    for (const double wrong : {none, endless, -1.0}) {
        for (int i = 0; i < 50; ++i) {
            EXPECT_EQ(budget.next(fine(), kSize), given);
            budget.learn({1.0, wrong, -1.0});
        }
        EXPECT_EQ(budget.state().milliseconds, took);
    }
    for (const double wrong : {none, -endless, -1.0}) {
        budget.setMilliseconds(wrong);
        EXPECT_EQ(budget.state().wantedMilliseconds, 0.0);
        EXPECT_EQ(Budget(wrong).state().wantedMilliseconds, 0.0);
    }
    frames.draw(200);
    EXPECT_EQ(budget.state().quality, 0.0);
    EXPECT_TRUE(budget.state().outOfReach);
}

TEST(Budget, LeavesNoPathsAsTheyAre) {
    Settings none = fine();
    none.photonPaths = 0;
    Budget budget(0.001);
    for (int i = 0; i < 50; ++i) {
        EXPECT_EQ(budget.next(none, kSize), none);
        budget.learn({0.0, 100.0, 100.0});
    }
    EXPECT_EQ(budget.state().quality, 1.0);
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

TEST(Budget, BeginsAnewBehindSettingsThatItDoesNotSteer) {
    Budget budget(0.2 * modelCost(fine(), kSize).sum());
    Frames frames(budget, eachPart([](double ms) { return ms; }), 0.0);
    frames.draw(200);
    ASSERT_NE(budget.next(fine(), kSize).gatherRays, fine().gatherRays);
    Settings short_ = fine();  // of a way of one step
    short_.gatherRays = 1;
    short_.gatherDivisor = 16;
    Settings direct = short_;
    direct.pipeline = Pipeline::Direct;
    EXPECT_EQ(budget.next(direct, kSize), direct);
    budget.setMilliseconds(10.0 * modelCost(short_, kSize).sum());
    const uint32_t changes = budget.state().changes;
    EXPECT_EQ(budget.next(short_, kSize), short_);
    EXPECT_EQ(budget.state().changes, changes) << "it was at the way's begin, not on its way back";
}

TEST(Budget, TellsWhatWasGivenUp) {
    Settings given = fine();
    given.photonPaths = 9000;
    given.radiusMetres = 0.6f;
    given.gatherRays = 4;
    given.gatherDivisor = 5;
    EXPECT_EQ(whatWasGivenUp(fine(), given),
              "paths 9000 instead of 16000, radius 0.6 instead of 0.5, gather rays 4 instead of 6, "
              "gather divisor 5 instead of 4");
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
    for (const auto& [asked, size] : cases()) {
        const CostCurve way(asked, size);
        for (size_t level = 1; level <= way.least().level; ++level) {
            const double taken = way.costAt({level - 1, CostCurve::kStepShare});
            EXPECT_EQ(way.find(0.99 * taken, {level - 1, 1.0}).level, level);
            EXPECT_EQ(way.find(1.04 * taken, {level, 1.0}).level, level);
            EXPECT_GE(way.costOfStepBack(level), 1.04 * taken);
            const double back = std::max(way.costOfStepBack(level), way.costAt({level, 1.0}));
            EXPECT_EQ(way.find(1.01 * back, {level, 1.0}).level, level - 1);
        }
    }
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
