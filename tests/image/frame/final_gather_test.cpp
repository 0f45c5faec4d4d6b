// The final gather against the reference and against what must hold.
#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/rel_mse.h"
#include "photons/irradiance_grid.h"
#include "reference/reference.h"
#include "support/frame_test.h"
#include "support/small_scenes.h"

namespace lampyris {
namespace {

class FinalGather : public test::FrameTest {
 protected:
    static double meanOf(const core::Image& image) {
        double sum = 0.0;
        for (size_t i = 1; i < image.values.size(); i += image.channels)
            sum += static_cast<double>(image.values[i]);
        return sum / (static_cast<double>(image.values.size()) / image.channels);
    }
    /// relMSE.
    static double errorOf(const core::Image& image, const core::Image& truth) {
        const auto a = test::need(evaluation::fromLinear("image", image, {}));
        const auto b = test::need(evaluation::fromLinear("truth", truth, {}));
        return test::need(evaluation::relMse(a, b)).value;
    }
};

TEST_F(FinalGather, TendsToTheReferenceAtEveryStep) {
    const auto snapshot = test::builtinSnapshot("cornell");
    const auto& camera = snapshot.cameras.front();
    reference::Settings exact;
    exact.width = 96;
    exact.height = 54;
    exact.samplesPerPixel = 1024;
    const auto truth = test::need(reference::render(snapshot, camera, exact));
    double last = 1e9;
    for (uint32_t step = 0; step < 6; ++step) {
        auto wanted = request(exact.width, exact.height, camera);
        wanted.settings.gatherDivisor = 1;
        wanted.settings.filterLevels = 0;
        wanted.settings.gatherRays = 8u << step;
        wanted.settings.photonPaths = 1000u << (2 * step);
        wanted.settings.radiusMetres = 2.0f * std::pow(0.7f, static_cast<float>(step));
        wanted.settings.gridColumns = 16;
        const auto drawn = render(snapshot, wanted, "indirect");
        const double error = errorOf(drawn.image, truth.indirect);
        EXPECT_LT(error, last) << "step " << step;
        last = error;
    }
    EXPECT_LE(last, 0.002);
}

TEST_F(FinalGather, LightDoesNotLeakThroughAWallOfFiveCentimetres) {
    const auto snapshot = test::twoClosedRooms();
    const auto meanSeen = [&](float x, float target) {
        double sum = 0.0;
        for (uint32_t seed = 1; seed <= 4; ++seed) {
            auto wanted =
                request(160, 96, test::lookFrom({x, 1.5f, 0.0f}, {target, 1.0f, 0.0f}, 80.0f));
            wanted.settings.seed = seed;
            sum += meanOf(render(snapshot, wanted, "irradiance_indirect").image);
        }
        return sum;
    };
    const double before = meanSeen(-3.5f, 0.0f);
    const double behind = meanSeen(3.5f, 0.0f);
    EXPECT_GT(before, 1.0);
    EXPECT_LT(behind, 0.005 * before);
}

TEST_F(FinalGather, AMeanOverFramesHasLessNoiseAndKeepsTheLight) {
    const auto snapshot = test::builtinSnapshot("cornell");
    test::SceneRenderer renderer(device(), snapshot);
    auto wanted = request(160, 90, snapshot.cameras.front());
    wanted.settings.history = 16;
    const auto draw = [&](uint64_t frame) {
        wanted.frameNumber = frame;
        return render(renderer, wanted, "indirect").image;
    };
    // The truth: many paths and rays, one level of the filter.
    auto many = wanted;
    many.settings.history = 0;
    many.settings.photonPaths = 300000;
    many.settings.gatherRays = 64;
    many.settings.filterLevels = 1;
    const auto truth = render(snapshot, many, "indirect").image;
    const double alone = errorOf(draw(0), truth);
    core::Image last;
    for (uint64_t frame = 1; frame < 16; ++frame) last = draw(frame);
    EXPECT_LT(errorOf(last, truth), 0.4 * alone);
    EXPECT_NEAR(meanOf(last), meanOf(truth), 0.03 * meanOf(truth));
}

TEST_F(FinalGather, ARemovedLightLeavesNoneBehind) {
    auto snapshot = test::builtinSnapshot("cornell");
    test::addLight(snapshot, {0.0f, 0.3f, 3.5f}, 0.1f, 300.0f);
    snapshot.lightVersion = 100;
    test::SceneRenderer renderer(device(), snapshot);
    auto wanted = request(160, 90, snapshot.cameras.front());
    wanted.settings.history = 32;
    const auto draw = [&] {
        ++wanted.frameNumber;
        return render(renderer, wanted, "irradiance_indirect").image;
    };
    for (int i = 0; i < 3; ++i) EXPECT_GT(meanOf(draw()), 0.1);
    snapshot.lights.clear();
    snapshot.lightVersion = 101;
    test::need(renderer.update(snapshot));
    EXPECT_EQ(meanOf(draw()), 0.0);
}

TEST_F(FinalGather, AMeanThatBeganAnewIsNotTakenForStale) {
    auto snapshot = test::builtinSnapshot("cornell");
    test::SceneRenderer renderer(device(), snapshot);
    auto wanted = request(320, 180, snapshot.cameras.front());
    wanted.settings.history = 80;
    /// The fewest frames in the mean of a texel that sees something.
    const auto draw = [&] {
        ++wanted.frameNumber;
        graph::Frame frame;
        const auto drawn = test::need(renderer.declare(frame, wanted));
        frame.publish("mean", drawn.insides.mean);
        frame.output(drawn.insides.mean);
        const auto mean = test::need(renderer.run(frame, drawn, "mean")).image;
        float fewest = 1e9f;
        for (size_t i = 0; i < mean.values.size(); i += 4)
            if (mean.values[i] > 0.0f) fewest = std::min(fewest, mean.values[i + 3]);
        return fewest;
    };
    for (int i = 1; i <= 20; ++i) EXPECT_EQ(draw(), static_cast<float>(i));
    snapshot.lights[0].positionWorld.x += 1.1f;
    snapshot.lights[0].version = snapshot.lightVersion += 100;
    test::need(renderer.update(snapshot));
    for (int i = 1; i <= 40; ++i) EXPECT_GE(draw(), static_cast<float>(i));
}

TEST_F(FinalGather, AFrameThatOverflowedLeavesNothingInTheMean) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto wanted = request(96, 54, snapshot.cameras.front());
    wanted.settings.history = 32;
    wanted.settings.photonPaths = 30000;
    wanted.settings.radiusMetres = 0.2f;  // more cells than the first guess has room for
    const auto drawIn = [&](uint32_t slots) {
        test::SceneRenderer renderer(device(), snapshot);
        renderer.capacities().gridSlots = slots;
        return render(renderer, wanted, "indirect");
    };
    const auto roomy = drawIn(1u << 20);
    EXPECT_GT(roomy.report.counters.cells, photons::cellsIn(1u << 14));
    EXPECT_EQ(drawIn(1u << 14).image.values, roomy.image.values);
}

TEST_F(FinalGather, AGridThatCannotGrowIsOneError) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto wanted = request(96, 54, snapshot.cameras.front());
    wanted.settings.photonPaths = 30000;
    wanted.settings.radiusMetres = 0.2f;
    test::SceneRenderer renderer(device(), snapshot);
    renderer.capacities().gridSlots = renderer.capacities().mostGridSlots = 1u << 14;
    const auto draw = [&] {
        graph::Frame frame;
        const auto drawn = test::need(renderer.declare(frame, wanted));
        return renderer.run(frame, drawn, "indirect");
    };
    auto outcome = draw();
    while (outcome.ok() && !outcome.value().report.valid) outcome = draw();  // photons grow first
    ASSERT_FALSE(outcome.ok());
    EXPECT_NE(outcome.error().message.find("--radius"), std::string::npos);
    wanted.settings.radiusMetres = 2.0f;
    EXPECT_TRUE(draw().ok());
}

TEST_F(FinalGather, TheMeanBeginsAnewWhenSettingsChange) {
    const auto snapshot = test::builtinSnapshot("cornell");
    test::SceneRenderer renderer(device(), snapshot);
    auto wanted = request(96, 54, snapshot.cameras.front());
    wanted.settings.history = 32;
    wanted.settings.guiding = false;
    for (; wanted.frameNumber < 4; ++wanted.frameNumber) render(renderer, wanted, "indirect");
    wanted.settings.maxBounces = 1;
    const auto after = render(renderer, wanted, "indirect");
    EXPECT_EQ(after.image.values, render(snapshot, wanted, "indirect").image.values);
}

TEST_F(FinalGather, ACameraThatMovesFindsItsPastAgain) {
    const auto snapshot = test::builtinSnapshot("cornell");
    test::SceneRenderer renderer(device(), snapshot);
    const auto ask = [&](int step, uint32_t history) {
        const float x = 0.05f * static_cast<float>(step);
        auto wanted = request(320, 180, test::lookFrom({x, 5.0f, 12.0f}, {x, 5.0f, 0.0f}));
        wanted.frameNumber = static_cast<uint64_t>(step);
        wanted.settings.history = history;
        return wanted;
    };
    core::Image moving;
    for (int step = 0; step <= 12; ++step)
        moving = render(renderer, ask(step, 16), "indirect").image;
    auto many = ask(12, 0);
    many.settings.photonPaths = 300000;
    many.settings.gatherRays = 64;
    many.settings.filterLevels = 1;
    const auto truth = render(snapshot, many, "indirect").image;
    const auto alone = render(snapshot, ask(12, 0), "indirect").image;
    EXPECT_LT(errorOf(moving, truth), 0.5 * errorOf(alone, truth));
}

/// Flat strips whose normals lean to the left and to the right in turn, as if mapped; light comes
/// from the left.
scene::SceneSnapshot pleatedPanel() {
    scene::SceneSnapshot snapshot;
    test::addRoom(snapshot, 0.0f, 8.0f);
    test::addLight(snapshot, {0.6f, 1.5f, 0.0f}, 0.1f, 200.0f);
    for (int i = 0; i < 32; ++i) {
        const float x = 2.0f + 0.125f * static_cast<float>(i);
        auto strip = test::quad({x, 0.5f, -1.9f}, {x + 0.125f, 0.5f, -1.9f},
                                {x + 0.125f, 2.5f, -1.9f}, {x, 2.5f, -1.9f});
        const glm::vec3 leaning(i % 2 == 0 ? -0.6f : 0.6f, 0.0f, 0.8f);
        strip.normals.assign(4, leaning);
        test::addInstance(snapshot, strip, test::lambertian(glm::vec3(0.5f)));
    }
    return snapshot;
}

TEST_F(FinalGather, LightIsCarriedOverToSurfacesThatLean) {
    const auto snapshot = pleatedPanel();
    const auto camera = test::lookFrom({4.0f, 1.5f, 1.9f}, {4.0f, 1.5f, -2.0f}, 28.0f);
    reference::Settings exact;
    exact.width = 192;
    exact.height = 108;
    exact.samplesPerPixel = 128;
    const auto truth = test::need(reference::render(snapshot, camera, exact));
    auto wanted = request(exact.width, exact.height, camera);
    wanted.settings.gatherRays = 64;
    wanted.settings.photonPaths = 100000;
    const auto drawn = render(snapshot, wanted, "irradiance_indirect");
    /// Mean over the strips that lean to one side.
    const auto meanOver = [&](const core::Image& light, float side) {
        double sum = 0.0;
        double count = 0.0;
        for (size_t pixel = 0; pixel < size_t{exact.width} * exact.height; ++pixel) {
            if (truth.normal.values[pixel * truth.normal.channels] * side < 0.5f) continue;
            sum += static_cast<double>(light.values[pixel * light.channels + 1]);
            count += 1.0;
        }
        return sum / count;
    };
    const double left = meanOver(truth.irradianceIndirect, -1.0f);
    const double right = meanOver(truth.irradianceIndirect, 1.0f);
    EXPECT_GT(left, 1.5 * right);
    // Texels are eight pixels wide, strips six.
    EXPECT_NEAR(meanOver(drawn.image, -1.0f), left, 0.1 * left);
    EXPECT_NEAR(meanOver(drawn.image, 1.0f), right, 0.1 * right);
    EXPECT_LT(drawn.report.counters.pixelsRecomputed, 200u);
}

TEST_F(FinalGather, LowResolutionShadowsAreThoseOfManyRaysAPixel) {
    const auto snapshot = test::builtinSnapshot("cornell");
    auto wanted = request(640, 360, snapshot.cameras.front());
    wanted.settings.pipeline = photon_gi::Pipeline::Direct;
    const auto few = render(snapshot, wanted, "direct").image;
    wanted.settings.shadowDivisor = 1;
    wanted.settings.shadowRays = 31;
    const auto many = render(snapshot, wanted, "direct").image;
    const core::DisplayTransform display{-1.0f, core::Tonemap::Clip};
    const auto a = core::toDisplay(few, display);
    const auto b = core::toDisplay(many, display);
    double squares = 0.0;
    for (size_t i = 0; i < a.values.size(); ++i) {
        const double d = static_cast<double>(a.values[i]) - static_cast<double>(b.values[i]);
        squares += d * d;
    }
    // At 1280x720 it is 0.5 [measured]: what lies between texels is half as large.
    EXPECT_LT(squares / static_cast<double>(a.values.size()), 1.6);
}

}  // namespace
}  // namespace lampyris
