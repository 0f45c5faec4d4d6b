// Runs under an X server of its own (Xvfb), whose screen is a file that the test reads.
#include "window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "execute/executor.h"
#include "support/gpu_test.h"
#include "support/screen_file.h"
#include "window/monitors.h"
#include "window/presenter.h"

namespace lampyris {
namespace {

using test::need;

/// An X server without a screen; its picture is kept in a file.
class Display {
 public:
    static constexpr uint32_t kWidth = 640;
    static constexpr uint32_t kHeight = 480;

    Display()
        : folder_(std::filesystem::temp_directory_path() /
                  ("lampyris-x" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(folder_);
        int pipes[2];
        if (::pipe(pipes) != 0) return;
        process_ = ::fork();
        if (process_ == 0) serve(pipes[1]);
        ::close(pipes[1]);
        char text[16] = {};
        const auto got = ::read(pipes[0], text, sizeof text - 1);
        ::close(pipes[0]);
        if (got > 0) ::setenv("DISPLAY", fmt::format(":{}", std::atoi(text)).c_str(), 1);
        runs_ = got > 0;
    }
    ~Display() {
        if (process_ > 0) {
            ::kill(process_, SIGTERM);
            ::waitpid(process_, nullptr, 0);
        }
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    [[nodiscard]] bool runs() const { return runs_; }

    /// Red, green and blue of a pixel of the screen, from the XWD file.
    [[nodiscard]] std::array<int, 3> pixel(uint32_t x, uint32_t y) const {
        return test::ScreenFile(folder_).pixel(x, y);
    }

 private:
    [[noreturn]] void serve(int pipe) const {
        const std::string descriptor = std::to_string(pipe);
        const std::string screen = fmt::format("{}x{}x24", kWidth, kHeight);
        (void)std::freopen("/dev/null", "w", stderr);
        ::execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", screen.c_str(),
                 "-fbdir", folder_.c_str(), "-nolisten", "tcp", "-noreset", nullptr);
        ::_exit(1);
    }
    std::filesystem::path folder_;
    pid_t process_ = -1;
    bool runs_ = false;
};

class WindowTest : public ::testing::Test {
 protected:
    static void SetUpTestSuite() { display_ = new Display; }
    static void TearDownTestSuite() {
        delete display_;
        display_ = nullptr;
    }
    void SetUp() override {
        if (!display_->runs()) GTEST_SKIP() << "Xvfb is not installed";
        auto device = gpu::Device::create({.validation = true, .presentable = true});
        if (!device.ok()) GTEST_SKIP() << device.error().message;
        device_ = std::move(device).value();
    }
    void TearDown() override {
        if (device_ == nullptr) return;
        for (const std::string& message : device_->validationMessages()) ADD_FAILURE() << message;
    }

    /// Runs `command` with xdotool; whether it was there and succeeded.
    static bool xdotool(const std::string& command) {
        return std::system(("xdotool " + command + " >/dev/null 2>&1").c_str()) == 0;
    }

    /// Shows the window and gives it the keyboard; whether xdotool was there to do so.
    static bool takesKeys(window::Window& window, const std::string& name) {
        for (int i = 0; i < 10; ++i) window.poll();
        return xdotool("search --sync --name " + name + " windowfocus --sync");
    }

    static inline Display* display_ = nullptr;
    std::unique_ptr<gpu::Device> device_;
};

/// A frame that clears an image to one colour.
class Colour {
 public:
    Colour(gpu::Device& device, graph::Extent size)
        : executor_(need(execute::Executor::create(device))), size_(size) {}
    const gpu::Image& fill(std::array<float, 4> colour) {
        graph::Frame frame;
        auto node = frame.raster("clear", size_);
        const auto image = node.clearedColour(
            0, frame.image("picture", {graph::Format::RGBA16Float, size_}), colour);
        node.record({}, [](graph::RasterCommands&) {});
        frame.output(image);
        need(executor_.run(frame));
        return executor_.outputImage(image);
    }

 private:
    execute::Executor executor_;
    graph::Extent size_;
};

TEST_F(WindowTest, ShowsAPictureAsSrgb) {
    auto window = need(window::Window::create({"colours", 320, 240}));
    auto presenter = need(window::Presenter::create(*device_, window, window::Encoding::Linear));
    Colour colour{*device_, {320, 240}};
    // Linear 0.2140 is 0.5 in sRGB; 4 is clipped.
    const gpu::Image& image = colour.fill({4.0f, 0.2140f, 0.0f, 1.0f});
    for (int i = 0; i < 6; ++i) {
        window.poll();
        EXPECT_EQ(need(presenter.present(image)), window::Presented::Shown);
    }
    need(device_->waitIdle());
    ::usleep(200'000);
    const auto shown = display_->pixel(100, 100);
    EXPECT_EQ(shown[0], 255);
    EXPECT_NEAR(shown[1], 128, 1);
    EXPECT_EQ(shown[2], 0);
    EXPECT_FALSE(window.shouldClose());
}

TEST_F(WindowTest, FollowsItsSize) {
    auto window = need(window::Window::create({"sizes", 320, 240}));
    auto presenter = need(window::Presenter::create(*device_, window, window::Encoding::Display));
    Colour colour{*device_, {160, 120}};
    const gpu::Image& image = colour.fill({0.0f, 1.0f, 0.0f, 1.0f});
    for (const VkExtent2D size : {VkExtent2D{320, 240}, VkExtent2D{200, 300}, VkExtent2D{64, 32}}) {
        window.resize(size.width, size.height);
        for (int i = 0; i < 10; ++i) {
            window.poll();
            need(presenter.present(image));
            ::usleep(10'000);
        }
        EXPECT_EQ(window.framebufferSize().width, size.width);
        EXPECT_EQ(need(presenter.present(image)), window::Presented::Shown);
    }
}

TEST_F(WindowTest, AnotherOneTakesItsPlace) {
    auto window = need(window::Window::create({"first", 64, 64}));
    auto presenter = need(window::Presenter::create(*device_, window, window::Encoding::Display));
    Colour colour{*device_, {64, 64}};
    const gpu::Image& image = colour.fill({0.0f, 0.0f, 1.0f, 1.0f});
    EXPECT_EQ(need(presenter.present(image)), window::Presented::Shown);
    auto next = need(window::Window::create({"second", 128, 64}));
    presenter = need(window::Presenter::create(*device_, next, window::Encoding::Display));
    { const window::Window old = std::exchange(window, std::move(next)); }
    EXPECT_EQ(window.framebufferSize().width, 128u);
    window.poll();
    EXPECT_FALSE(window.shouldClose());
}

TEST_F(WindowTest, RefusesADeviceThatCannotShow) {
    auto window = need(window::Window::create({"refused", 64, 64}));
    const auto device = need(gpu::Device::create({}));
    const auto none = window::Presenter::create(*device, window, window::Encoding::Linear);
    EXPECT_NE(test::errorOf(none).find("VK_KHR_swapchain"), std::string::npos);
}

TEST_F(WindowTest, LetsOthersDrawOverThePicture) {
    auto window = need(window::Window::create({"canvas", 64, 64}));
    auto presenter = need(window::Presenter::create(*device_, window, window::Encoding::Display));
    Colour colour{*device_, {64, 64}};
    const gpu::Image& image = colour.fill({0.0f, 0.0f, 0.0f, 1.0f});
    int drawn = 0;
    for (int i = 0; i < 3; ++i)
        need(presenter.present(image, [&](const window::Canvas& canvas) {
            ++drawn;
            EXPECT_EQ(canvas.extent.width, 64u);
            EXPECT_NE(canvas.view, VkImageView{VK_NULL_HANDLE});
        }));
    EXPECT_EQ(drawn, 3);
}

TEST_F(WindowTest, EscapeCloses) {
    auto window = need(window::Window::create({"escape", 200, 200}));
    if (!takesKeys(window, "escape")) GTEST_SKIP() << "xdotool is not installed";
    ASSERT_TRUE(xdotool("key a keydown Escape"));
    bool a = false;
    for (int i = 0; i < 100 && !window.shouldClose(); ++i) {
        window.poll();
        a = a || window.input().pressed['A'];
        ::usleep(10'000);
    }
    EXPECT_TRUE(window.shouldClose());
    EXPECT_TRUE(a);
    EXPECT_TRUE(window.input().held[window::kKeyEscape]);
    xdotool("keyup Escape");
}

TEST_F(WindowTest, KeepsWhatCameWhileItWaited) {
    auto window = need(window::Window::create({"waits", 200, 200}));
    if (!takesKeys(window, "waits")) GTEST_SKIP() << "xdotool is not installed";
    ASSERT_TRUE(xdotool("key j"));
    for (int i = 0; i < 5; ++i) window.waitForEvents(0.1);
    window.poll();
    EXPECT_TRUE(window.input().wasPressed('J'));
    EXPECT_EQ(window.input().typed, U"j");
    window.waitForEvents(0.0);
    window.poll();
    EXPECT_FALSE(window.input().wasPressed('J')) << "once";
    EXPECT_TRUE(window.input().typed.empty());
}

TEST_F(WindowTest, AClickIsWhereItWasHoweverLateItIsSeen) {
    auto window = need(window::Window::create({"clicked", 200, 200}));
    if (!takesKeys(window, "clicked")) GTEST_SKIP() << "xdotool is not installed";
    ASSERT_TRUE(xdotool("search --name clicked mousemove --sync --window %1 20 30"));
    for (int i = 0; i < 5; ++i) window.waitForEvents(0.1);
    window.poll();
    ASSERT_TRUE(
        xdotool("search --name clicked mousemove --sync --window %1 50 60 mousedown 1 "
                "mousemove --sync --window %1 70 80 mouseup 1 "
                "mousemove --sync --window %1 150 160 key j"));
    for (int i = 0; i < 5; ++i) window.waitForEvents(0.1);
    window.poll();
    EXPECT_TRUE(window.input().clicked[0]);
    EXPECT_TRUE(window.input().buttons[0]);
    EXPECT_EQ(window.input().cursorX, 50.0);
    EXPECT_EQ(window.input().cursorY, 60.0);
    EXPECT_FALSE(window.input().wasPressed('J')) << "that was after it";
    window.poll();
    EXPECT_FALSE(window.input().clicked[0]);
    EXPECT_FALSE(window.input().buttons[0]);
    EXPECT_EQ(window.input().cursorX, 70.0);
    EXPECT_EQ(window.input().movedX, 20.0);
    window.poll();
    EXPECT_EQ(window.input().cursorX, 150.0);
    EXPECT_TRUE(window.input().wasPressed('J'));
}

TEST_F(WindowTest, AKeyMeansWhatWasHeldWithItHoweverLateItIsSeen) {
    auto window = need(window::Window::create({"modified", 200, 200}));
    if (!takesKeys(window, "modified")) GTEST_SKIP() << "xdotool is not installed";
    ASSERT_TRUE(xdotool("key j key shift+k key l"));
    for (int i = 0; i < 5; ++i) window.waitForEvents(0.1);
    window.poll();
    EXPECT_TRUE(window.input().wasPressed('J'));
    EXPECT_FALSE(window.input().wasPressed('K'));
    EXPECT_FALSE(window.input().shift());
    window.poll();
    EXPECT_TRUE(window.input().wasPressed('K'));
    EXPECT_TRUE(window.input().shift());
    EXPECT_EQ(window.input().typed, U"K");
    EXPECT_FALSE(window.input().wasPressed('L'));
    window.poll();
    EXPECT_TRUE(window.input().wasPressed('L'));
    EXPECT_FALSE(window.input().shift());
}

TEST_F(WindowTest, EscapeClosesNothingWhereItEndsSomethingElse) {
    auto window = need(window::Window::create({"typing", 200, 200}));
    if (!takesKeys(window, "typing")) GTEST_SKIP() << "xdotool is not installed";
    window.setEscapeCloses(false);
    ASSERT_TRUE(xdotool("key Escape"));
    for (int i = 0; i < 5; ++i) window.waitForEvents(0.1);
    window.poll();
    EXPECT_TRUE(window.input().wasPressed(window::kKeyEscape));
    EXPECT_FALSE(window.shouldClose());
}

TEST(Fitted, PicturesAreAsLargeAsFitsInTheMiddle) {
    const auto wide = window::fitted({160, 90}, {640, 480});
    EXPECT_EQ(wide.extent.width, 640u);
    EXPECT_EQ(wide.extent.height, 360u);
    EXPECT_EQ(wide.offset.x, 0);
    EXPECT_EQ(wide.offset.y, 60);
    const auto tiny = window::fitted({4000, 1}, {10, 10});
    EXPECT_EQ(tiny.extent.height, 1u);
    const auto same = window::fitted({33, 17}, {33, 17});
    EXPECT_EQ(same.extent.width, 33u);
    EXPECT_EQ(same.extent.height, 17u);
}

TEST(NoDisplay, IsAnErrorThatSaysSo) {
    const char* display = std::getenv("DISPLAY");
    const std::string kept = display == nullptr ? "" : display;
    ::unsetenv("DISPLAY");
    const auto window = window::Window::create({});
    EXPECT_NE(test::errorOf(window).find("no display"), std::string::npos);
    if (!kept.empty()) ::setenv("DISPLAY", kept.c_str(), 1);
}

TEST_F(WindowTest, LeavesGlfwToAProgramThatBeganIt) {
    const auto isBegun = [] {
        glfwGetError(nullptr);
        (void)glfwGetTime();
        return glfwGetError(nullptr) != GLFW_NOT_INITIALIZED;
    };
    EXPECT_FALSE(isBegun()) << "no window of ours is left";
    ASSERT_EQ(glfwInit(), GLFW_TRUE);
    EXPECT_TRUE(window::listMonitors().ok());
    EXPECT_TRUE(isBegun());
    (void)need(window::Window::create({"ours", 100, 100}));
    EXPECT_TRUE(isBegun());
    glfwTerminate();
    (void)need(window::Window::create({"ours", 100, 100}));
    EXPECT_TRUE(window::listMonitors().ok());
    EXPECT_FALSE(isBegun());
}

// Last: what X says of a destroyed window is remembered.
TEST_F(WindowTest, ZSurvivesItsOwnDestruction) {
    auto window = need(window::Window::create({"victim", 200, 200}));
    auto presenter = need(window::Presenter::create(*device_, window, window::Encoding::Linear));
    Colour colour{*device_, {200, 200}};
    const gpu::Image& image = colour.fill({1.0f, 0.0f, 0.0f, 1.0f});
    for (int i = 0; i < 5; ++i) {
        window.poll();
        need(presenter.present(image));
    }
    if (!xdotool("search --sync --name victim windowclose"))
        GTEST_SKIP() << "xdotool is not installed";
    // Asked before any other call told of it.
    for (int i = 0; i < 50 && window.framebufferSize().width != 0; ++i) ::usleep(10'000);
    EXPECT_EQ(window.framebufferSize().width, 0u);
    EXPECT_EQ(window.framebufferSize().height, 0u);
    EXPECT_EQ(window.size().width, 0u);
    EXPECT_TRUE(window.shouldClose());
    auto presented = window::Presented::Shown;
    for (int i = 0; i < 50 && presented != window::Presented::Closed; ++i) {
        window.poll();
        presented = need(presenter.present(image));
        ::usleep(10'000);
    }
    EXPECT_EQ(presented, window::Presented::Closed);
}

}  // namespace
}  // namespace lampyris
