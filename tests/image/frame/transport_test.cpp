// Statements about light that must hold in every frame of the built-in scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/display.h"
#include "support/frame_test.h"

namespace lampyris {
namespace {

class Transport : public test::FrameTest {
 protected:
    static photon_gi::FrameRequest ask(const scene::SceneSnapshot& snapshot, uint32_t width,
                                       uint32_t height) {
        return request(width, height, snapshot.cameras.front());
    }

    static double meanOf(const core::Image& image) {
        double sum = 0.0;
        for (size_t i = 0; i < image.values.size(); ++i)
            if (i % image.channels < 3) sum += static_cast<double>(image.values[i]);
        return sum / (static_cast<double>(image.width) * image.height * 3.0);
    }
};

class EveryScene : public Transport, public ::testing::WithParamInterface<const char*> {};

TEST_P(EveryScene, EnergyLedgerClosesInEveryFrame) {
    const auto snapshot = test::builtinSnapshot(GetParam());
    test::SceneRenderer renderer(device(), snapshot);
    glm::dvec3 power(0.0);
    for (const auto& light : snapshot.lights) power += glm::dvec3(light.powerWatts);
    auto wanted = ask(snapshot, 32, 18);
    for (uint64_t frame = 0; frame < 3; ++frame) {
        wanted.frameNumber = frame;
        const auto drawn = render(renderer, wanted, "final");
        EXPECT_LT(drawn.report.energy.relativeError(), 1e-4);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(drawn.report.energy.emitted[c], power[c], 1e-4 * power[c]);
        EXPECT_GT(drawn.report.energy.absorbed.x, 0.0);
        if (std::string(GetParam()) == "two_rooms") {
            EXPECT_EQ(drawn.report.energy.escaped, glm::dvec3(0.0));
        }
        if (std::string(GetParam()) == "cornell") {
            EXPECT_GT(drawn.report.energy.escaped.x, 0.0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, EveryScene,
                         ::testing::Values("cornell", "cornell_statue", "cornell_hairball",
                                           "two_rooms", "conference"));

TEST_F(Transport, RouletteIsZeroWithinFourOfItsOwnDeviations) {
    const auto snapshot = test::builtinSnapshot("two_rooms");
    test::SceneRenderer renderer(device(), snapshot);
    auto wanted = ask(snapshot, 16, 9);
    wanted.settings.photonPaths = 2000;
    constexpr int kFrames = 24;
    glm::dvec3 sum(0.0);
    glm::dvec3 squares(0.0);
    for (int frame = 0; frame < kFrames; ++frame) {
        wanted.frameNumber = static_cast<uint64_t>(frame);
        const glm::dvec3 share = render(renderer, wanted, "final").report.energy.roulette;
        sum += share;
        squares += share * share;
    }
    for (int c = 0; c < 3; ++c) {
        const double mean = sum[c] / kFrames;
        const double deviation = std::sqrt((squares[c] / kFrames - mean * mean) / (kFrames - 1));
        EXPECT_GT(deviation, 0.0);
        EXPECT_LT(std::abs(mean), 4.0 * deviation);
    }
}

TEST_F(Transport, FullAndThesisAgreeWithOneBounceAndTheSameGather) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto wanted = ask(snapshot, 320, 180);
    wanted.settings.gather = photon_gi::Gather::Tiles;
    wanted.settings.gatherDivisor = 2;
    wanted.settings.photonPaths = 1000;
    wanted.settings.maxBounces = 1;
    const auto full = render(snapshot, wanted, "indirect");
    wanted.settings.pipeline = photon_gi::Pipeline::Thesis;
    const auto thesis = render(snapshot, wanted, "indirect");
    const core::DisplayTransform display{-1.0f, core::Tonemap::Clip};
    const auto a = core::toDisplay(full.image, display);
    const auto b = core::toDisplay(thesis.image, display);
    double difference = 0.0;
    double brightness = 0.0;
    for (size_t i = 0; i < a.values.size(); ++i) {
        difference += std::abs(static_cast<double>(a.values[i]) - static_cast<double>(b.values[i]));
        brightness += static_cast<double>(b.values[i]);
    }
    EXPECT_LE(difference / static_cast<double>(a.values.size()), 1.0);
    EXPECT_GT(brightness / static_cast<double>(a.values.size()), 10.0);
}

TEST_F(Transport, SameSeedGivesTheSameBytesAndAnotherSeedOthers) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto wanted = ask(snapshot, 160, 90);
    const auto first = render(snapshot, wanted, "final");
    const auto again = render(snapshot, wanted, "final");
    EXPECT_EQ(first.image.values, again.image.values);
    EXPECT_EQ(first.report.energy.absorbed, again.report.energy.absorbed);
    wanted.settings.seed = 2;
    EXPECT_NE(render(snapshot, wanted, "final").image.values, first.image.values);
    wanted.settings.seed = 1;
    wanted.frameNumber = 5;
    EXPECT_NE(render(snapshot, wanted, "final").image.values, first.image.values);
    wanted.settings.reseed = false;
    const auto frozen = render(snapshot, wanted, "final");
    wanted.frameNumber = 6;
    EXPECT_EQ(render(snapshot, wanted, "final").image.values, frozen.image.values);
}

TEST_F(Transport, AnyLegalOrderAndPoisonedTransientsChangeNothing) {
    const auto snapshot = test::builtinSnapshot("cornell");
    // The second frame, which hangs on what the first one taught.
    const auto second = [&](const graph::CompileOptions& options) {
        test::SceneRenderer renderer(device(), snapshot);
        auto wanted = ask(snapshot, 96, 54);
        render(renderer, wanted, "final", options);
        wanted.frameNumber = 1;
        return render(renderer, wanted, "final", options).image.values;
    };
    const auto plain = second({});
    for (const uint64_t order : {1u, 2u, 3u}) {
        graph::CompileOptions options;
        options.randomOrderSeed = order;
        options.poisonTransients = true;
        EXPECT_EQ(second(options), plain);
    }
}

TEST_F(Transport, BatchesOfPhotonsAddUpToTheSamePicture) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto wanted = ask(snapshot, 96, 54);
    for (const auto gather : {photon_gi::Gather::Tiles, photon_gi::Gather::Final}) {
        wanted.settings.gather = gather;
        wanted.settings.photonPaths = 3000;
        wanted.settings.largestBatch = 0xffffffffu;
        const auto whole = render(snapshot, wanted, "irradiance_indirect");
        wanted.settings.largestBatch = 700;
        const auto parts = render(snapshot, wanted, "irradiance_indirect");
        EXPECT_EQ(parts.report.counters.photonsStored, whole.report.counters.photonsStored);
        EXPECT_EQ(parts.report.counters.pairs, whole.report.counters.pairs);
        EXPECT_EQ(parts.report.counters.cells, whole.report.counters.cells);
        for (size_t i = 0; i < whole.image.values.size(); ++i)
            ASSERT_NEAR(parts.image.values[i], whole.image.values[i],
                        2e-3f * whole.image.values[i] + 1e-5f);
    }
}

TEST_F(Transport, AnOverflowIsReportedAndTheNextFrameHasRoom) {
    const auto snapshot = test::builtinSnapshot("cornell");
    test::SceneRenderer renderer(device(), snapshot);
    auto wanted = ask(snapshot, 640, 360);
    wanted.settings.gather = photon_gi::Gather::Tiles;
    wanted.settings.photonPaths = 100;
    wanted.settings.gatherDivisor = 8;
    wanted.settings.radiusMetres = 30.0f;  // more tiles a photon than the first guess allows for
    graph::Frame first;
    const auto tooSmall =
        test::need(renderer.run(first, test::need(renderer.declare(first, wanted)), "final"));
    EXPECT_FALSE(tooSmall.report.valid);
    EXPECT_GT(tooSmall.report.counters.pairsDropped, 0u);
    graph::Frame second;
    const auto whole =
        test::need(renderer.run(second, test::need(renderer.declare(second, wanted)), "final"));
    EXPECT_TRUE(whole.report.valid);
    EXPECT_EQ(whole.report.counters.pairsDropped, 0u);
}

TEST_F(Transport, ManyLightsAreCulledByTileAndReport) {
    auto snapshot = test::builtinSnapshot("cornell");
    snapshot.lights.clear();
    for (int i = 0; i < 40; ++i)
        test::addLight(snapshot,
                       {-4.5f + 9.0f * static_cast<float>(i % 8) / 7.0f, 0.4f,
                        -4.0f + 8.0f * static_cast<float>(i >> 3) / 4.0f},
                       0.05f, 1.0f);
    auto wanted = ask(snapshot, 160, 90);
    wanted.settings.pipeline = photon_gi::Pipeline::Direct;
    const auto all = render(snapshot, wanted, "direct");
    EXPECT_EQ(all.report.cutOffWatts, glm::vec3(0.0f));
    wanted.settings.lightCutoff = 0.02f;
    const auto some = render(snapshot, wanted, "direct");
    EXPECT_GT(some.report.cutOffWatts.x, 0.0f);
    EXPECT_LT(some.report.cutOffWatts.x, 0.2f * 40.0f);
    EXPECT_NEAR(meanOf(some.image), meanOf(all.image), 0.2 * meanOf(all.image));
}

}  // namespace
}  // namespace lampyris
