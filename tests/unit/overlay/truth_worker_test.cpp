#include "overlay/truth_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "scene/builtin/builtin.h"
#include "scene/extract.h"

namespace lampyris::overlay {
namespace {

TruthView cornellView() {
    const ecs::World world = scene::builtinScene("cornell").value();
    TruthView view;
    view.snapshot = scene::extract(world, {}, 0);
    view.camera = view.snapshot.cameras.front();
    view.width = 64;
    view.height = 36;
    return view;
}

bool eventually(const auto& question) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
        if (question()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

core::Image grey(uint32_t width, uint32_t height, float value) {
    core::Image image(width, height, 4);
    std::fill(image.values.begin(), image.values.end(), value);
    return image;
}

TEST(TruthWorker, RefinesTheReferenceOfAViewThatStands) {
    TruthWorker worker;
    const TruthView view = cornellView();
    worker.follow(view);
    ASSERT_TRUE(eventually([&] { return worker.figures().samples >= 2; }));
    const TruthState early = worker.figures();
    worker.follow(view);  // the same: goes on
    ASSERT_TRUE(eventually([&] { return worker.figures().samples >= 16 * early.samples; }));
    const TruthState late = worker.figures();
    EXPECT_GT(early.relativeError, 0.0);
    EXPECT_LT(late.relativeError, 0.6 * early.relativeError);
}

TEST(TruthWorker, BeginsAnewWhereTheViewChanges) {
    TruthWorker worker;
    TruthView view = cornellView();
    worker.follow(view);
    ASSERT_TRUE(eventually([&] { return worker.wantsFrame(); }));
    worker.measure({grey(64, 36, 0.5f), {}, {}});
    ASSERT_TRUE(eventually([&] { return !worker.figures().figures.empty(); }));
    view.camera.cameraToWorld[3].x += 0.5f;
    worker.follow(view);
    EXPECT_TRUE(worker.figures().figures.empty());
    EXPECT_EQ(worker.figures().samples, 0u);
    EXPECT_TRUE(eventually([&] { return worker.figures().samples > 0; }));
}

TEST(TruthWorker, MeasuresFramesAsCompareDoes) {
    TruthWorker worker;
    const TruthView view = cornellView();
    worker.follow(view);
    ASSERT_TRUE(eventually([&] { return worker.figures().samples >= 64; }));
    // A frame as good as its reference, and a black one behind it.
    reference::Settings settings;
    settings.width = 64;
    settings.height = 36;
    settings.seed = 77777;
    const auto frame = reference::render(view.snapshot, view.camera, settings).value().final;
    worker.measure({frame, frame, {}});
    ASSERT_TRUE(eventually([&] { return worker.figures().figures.size() == 1; }));
    worker.measure({grey(64, 36, 0.0f), frame, {}});
    ASSERT_TRUE(eventually([&] { return worker.figures().figures.size() == 2; }));
    const TruthState state = worker.state();
    EXPECT_LT(20.0 * state.figures[0].mse, state.figures[1].mse);
    EXPECT_GT(state.figures[0].mssim, state.figures[1].mssim);
    EXPECT_EQ(state.figures[0].change, 0.0) << "the frame before was the same";
    EXPECT_GT(state.figures[1].change.value_or(0.0), 5.0);
    EXPECT_EQ(state.reference.width, 64u);
    EXPECT_EQ(state.difference.values.size(), size_t{64} * 36 * 3);
}

TEST(TruthWorker, SaysWhatItCannotMeasure) {
    TruthWorker worker;
    worker.follow(cornellView());
    ASSERT_TRUE(eventually([&] { return worker.wantsFrame(); }));
    worker.measure({grey(32, 18, 0.5f), {}, {}});  // of another size
    ASSERT_TRUE(eventually([&] { return !worker.figures().error.empty(); }));
}

TEST(TruthWorker, EndsWhileItRenders) {
    TruthView view = cornellView();
    view.width = 640;
    view.height = 360;
    TruthWorker worker;
    worker.follow(view);
}

}  // namespace
}  // namespace lampyris::overlay
