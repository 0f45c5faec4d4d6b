#include "overlay/truth_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <span>
#include <thread>

#include "scene/builtin/builtin.h"
#include "scene/extract.h"

namespace lampyris::overlay {
namespace {

const scene::SceneSnapshot& cornell() {
    static const scene::SceneSnapshot snapshot =
        scene::extract(scene::builtinScene("cornell").value(), {}, 0);
    return snapshot;
}

TruthView cornellView() {
    return {cornell(), cornell().cameras.front(), 64, 36};
}

/// As many frames of a view as it takes to begin its reference.
void stand(TruthWorker& worker, const TruthView& view) {
    for (uint32_t i = 0; i <= TruthWorker::kStandingFrames; ++i) worker.follow(view);
}

bool eventually(const auto& question) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
        if (question()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

execute::RawImage raw(uint32_t width, uint32_t height, const std::vector<float>& values) {
    execute::RawImage image{{graph::Format::RGBA32Float, {width, height}}, {}};
    const auto bytes = std::as_bytes(std::span(values));
    image.bytes.assign(bytes.begin(), bytes.end());
    return image;
}

execute::RawImage grey(uint32_t width, uint32_t height, float value) {
    return raw(width, height, std::vector<float>(size_t{4} * width * height, value));
}

/// With a fourth channel, as the device has it.
execute::RawImage raw(const core::Image& image) {
    std::vector<float> values;
    for (size_t i = 0; i < image.values.size(); ++i) {
        values.push_back(image.values[i]);
        if (i % 3 == 2) values.push_back(1.0f);
    }
    return raw(image.width, image.height, values);
}

TEST(TruthWorker, RefinesTheReferenceOfAViewThatStands) {
    TruthWorker worker;
    const TruthView view = cornellView();
    stand(worker, view);
    ASSERT_TRUE(eventually([&] { return worker.state().samples >= 2; }));
    const TruthState early = worker.state();
    EXPECT_TRUE(worker.follow(view)) << "the same: goes on";
    ASSERT_TRUE(eventually([&] { return worker.state().samples >= 16 * early.samples; }));
    const TruthState late = worker.state();
    EXPECT_GT(early.relativeError, 0.0);
    EXPECT_LT(late.relativeError, 0.6 * early.relativeError);
}

TEST(TruthWorker, BeginsAnewWhereTheViewChanges) {
    TruthWorker worker;
    TruthView view = cornellView();
    stand(worker, view);
    ASSERT_TRUE(eventually([&] { return worker.wantsFrame(); }));
    worker.measure({grey(64, 36, 0.5f), {}, {}});
    ASSERT_TRUE(eventually([&] { return !worker.state().figures.empty(); }));
    view.camera.cameraToWorld[3].x += 0.5f;
    EXPECT_FALSE(worker.follow(view));
    EXPECT_TRUE(worker.state().figures.empty());
    EXPECT_EQ(worker.state().samples, 0u);
    stand(worker, view);
    EXPECT_TRUE(eventually([&] { return worker.state().samples > 0; }));
}

TEST(TruthWorker, MeasuresFramesAsCompareDoes) {
    TruthWorker worker;
    const TruthView view = cornellView();
    stand(worker, view);
    ASSERT_TRUE(eventually([&] { return worker.state().samples >= 64; }));
    // A frame as good as its reference, and a black one behind it.
    reference::Settings settings;
    settings.width = 64;
    settings.height = 36;
    settings.seed = 77777;
    const auto frame = raw(reference::render(view.snapshot, view.camera, settings).value().final);
    worker.measure({frame, frame, {}});
    ASSERT_TRUE(eventually([&] { return worker.state().figures.size() == 1; }));
    worker.measure({grey(64, 36, 0.0f), frame, {}});
    ASSERT_TRUE(eventually([&] { return worker.state().figures.size() == 2; }));
    const TruthState state = worker.state();
    EXPECT_LT(20.0 * state.figures[0].mse, state.figures[1].mse);
    EXPECT_GT(state.figures[0].mssim, state.figures[1].mssim);
    EXPECT_EQ(state.figures[0].change, 0.0) << "the frame before was the same";
    EXPECT_GT(state.figures[1].change.value_or(0.0), 5.0);
    EXPECT_EQ(state.reference->width, 64u);
    EXPECT_EQ(state.difference->values.size(), size_t{64} * 36 * 3);
}

TEST(TruthWorker, SaysWhatItCannotMeasure) {
    TruthWorker worker;
    stand(worker, cornellView());
    ASSERT_TRUE(eventually([&] { return worker.wantsFrame(); }));
    worker.measure({grey(32, 18, 0.5f), {}, {}});  // of another size
    ASSERT_TRUE(eventually([&] { return !worker.state().measureError.empty(); }));
}

TEST(TruthWorker, GoesOnBehindAFrameThatIsNoPicture) {
    TruthWorker worker;
    stand(worker, cornellView());
    ASSERT_TRUE(eventually([&] { return worker.wantsFrame(); }));
    worker.measure({grey(64, 36, std::numeric_limits<float>::quiet_NaN()), {}, {}});
    ASSERT_TRUE(eventually([&] { return !worker.state().measureError.empty(); }));
    const uint32_t samples = worker.state().samples;
    EXPECT_TRUE(eventually([&] { return worker.state().samples > samples; }));
    worker.measure({grey(64, 36, 0.5f), {}, {}});
    ASSERT_TRUE(eventually([&] { return !worker.state().figures.empty(); }));
    EXPECT_EQ(worker.state().measureError, "");
}

TEST(TruthWorker, KeepsWhatItRenderedWhileItRests) {
    TruthWorker worker;
    stand(worker, cornellView());
    ASSERT_TRUE(eventually([&] { return worker.state().samples > 0; }));
    worker.rest();
    const uint32_t before = worker.state().samples;
    EXPECT_TRUE(worker.follow(cornellView()));
    EXPECT_GE(worker.state().samples, before);
    EXPECT_TRUE(eventually([&] { return worker.state().samples > before; }));
    EXPECT_EQ(worker.state().error, "");
}

TEST(TruthWorker, BeginsNothingWhileTheViewMoves) {
    TruthWorker worker;
    TruthView view = cornellView();
    for (int i = 0; i < 100; ++i) {
        view.camera.cameraToWorld[3].x += 0.001f;
        worker.follow(view);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    // Time enough to render the last one, had it been begun.
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    EXPECT_EQ(worker.state().samples, 0u);
    stand(worker, view);
    EXPECT_TRUE(eventually([&] { return worker.state().samples > 0; }));
}

TEST(TruthWorker, NeverNumbersPicturesTwice) {
    TruthWorker worker;
    TruthView view = cornellView();
    uint64_t last = 0;
    for (int i = 0; i < 3; ++i) {
        view.camera.cameraToWorld[3].x += 0.1f;
        stand(worker, view);
        const TruthState begun = worker.state();
        EXPECT_GT(begun.pictures, last) << "those of another view are gone";
        EXPECT_EQ(begun.reference, nullptr);
        ASSERT_TRUE(eventually([&] { return worker.wantsFrame(); }));
        worker.measure({grey(64, 36, 0.5f), {}, {}});
        ASSERT_TRUE(eventually([&] { return worker.state().reference != nullptr; }));
        last = worker.state().pictures;
        EXPECT_GT(last, begun.pictures);
    }
    worker.forgetFigures();
    EXPECT_TRUE(worker.state().figures.empty());
    EXPECT_EQ(worker.state().difference, nullptr);
    EXPECT_GT(worker.state().pictures, last);
    EXPECT_GT(worker.state().samples, 0u) << "the reference knows no display";
}

TEST(TruthWorker, EndsWhileItRenders) {
    TruthView view = cornellView();
    view.width = 640;
    view.height = 360;
    TruthWorker worker;
    stand(worker, view);
}

}  // namespace
}  // namespace lampyris::overlay
