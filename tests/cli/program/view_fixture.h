/// \file `lampyris view` on a display of its own, and a user before it.
#pragma once

#include <chrono>
#include <memory>
#include <thread>

#include "cli/program/program.h"
#include "support/screen_file.h"

namespace lampyris::test {

constexpr int kViewSeconds = 60;

/// Asks again and again until the answer is yes.
inline bool eventually(const auto& question) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(kViewSeconds);
    while (std::chrono::steady_clock::now() < end) {
        if (question()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
}

class View : public testing::Test {
 protected:
    /// A display server; it chooses a number that nobody has, and says so when it is ready.
    void SetUp() override {
        server_ = std::make_unique<Process>(Arguments{"Xvfb", "-displayfd", "1", "-screen", "0",
                                                      "1360x800x24", "-nolisten", "tcp", "-noreset",
                                                      "-fbdir", (folder_ / "").string()});
        ASSERT_TRUE(eventually([&] { return server_->outputSoFar().ends_with('\n'); }));
        const std::string number = server_->outputSoFar();
        display_ = "DISPLAY=:" + number.substr(0, number.size() - 1);
    }

    [[nodiscard]] std::unique_ptr<Process> start(const Arguments& command) const {
        return std::make_unique<Process>(command, std::vector{display_});
    }
    [[nodiscard]] std::unique_ptr<Process> startView(const Arguments& more = {"--size",
                                                                              "160x90"}) const {
        Arguments command{programPath(), "view", "cornell"};
        command.insert(command.end(), more.begin(), more.end());
        return start(command);
    }
    /// Standard output of xdotool.
    std::string ask(const Arguments& arguments) const {
        Arguments command{"xdotool"};
        command.insert(command.end(), arguments.begin(), arguments.end());
        return start(command)->wait(kViewSeconds).out;
    }
    /// Waits until the window's title tells of a frame that was shown.
    [[nodiscard]] bool showsFrames(Process& view) const {
        return eventually([&] {
            return !view.running() ||
                   ask({"search", "--name", "lampyris: cornell, [0-9.]+ ms", "getwindowname"})
                           .find(" ms") != std::string::npos;
        });
    }

    /// A window manager; a window that comes while it still starts is never shown.
    [[nodiscard]] std::unique_ptr<Process> startManager() const {
        auto manager = start({"openbox", "--sm-disable", "--startup", "echo ready"});
        EXPECT_TRUE(
            eventually([&] { return manager->outputSoFar().find("ready") != std::string::npos; }));
        return manager;
    }
    [[nodiscard]] ScreenFile screen() const { return ScreenFile(folder_ / ""); }

    ScratchFolder folder_;
    std::unique_ptr<Process> server_;
    std::string display_;
};

inline void expectQuietEnd(Process& view) {
    const Ran ran = view.wait(kViewSeconds);
    EXPECT_EQ(ran.code, 0) << "signal " << ran.signal;
    EXPECT_EQ(ran.err, "");
}

}  // namespace lampyris::test
