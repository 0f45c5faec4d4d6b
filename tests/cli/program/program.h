/// \file Runs the built program as a user does.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "unit/core/scratch_folder.h"

namespace lampyris::test {

using core::ScratchFolder;
using Arguments = std::vector<std::string>;

struct Ran {
    int code = -1;   ///< exit code; -1 where a signal ended it
    int signal = 0;  ///< that signal
    std::string out, err;
    [[nodiscard]] size_t errorLines() const;
};

/// A program that was started. It is ended when this goes.
class Process {
 public:
    /// `variables` are added to the environment ("NAME=value").
    Process(const Arguments& command, const std::vector<std::string>& variables = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    [[nodiscard]] bool running();
    /// Of standard output.
    [[nodiscard]] std::string outputSoFar() const;
    [[nodiscard]] std::string errorsSoFar() const;
    /// Waits for its end; a failure of the test, and the end of the process, after so many seconds.
    Ran wait(int seconds);

 private:
    bool endsWithin(int seconds);
    void kill();
    void reap(int status);
    std::filesystem::path out_, err_;
    pid_t pid_ = -1;
    bool ended_ = false;
    Ran ran_;
};

/// The path of the program under test.
[[nodiscard]] std::string programPath();

/// Runs `lampyris` to its end; every call here needs seconds.
Ran lampyris(const Arguments& arguments, const std::vector<std::string>& variables = {});

/// Renders at 160x90 with more arguments, to a picture of that path.
Ran render(const std::string& scene, const std::filesystem::path& picture,
           const Arguments& more = {});

/// Runs something else of the system, without looking at what came of it.
Ran run(const Arguments& command, const std::vector<std::string>& variables = {});

[[nodiscard]] std::string textOf(const std::filesystem::path& path);
[[nodiscard]] nlohmann::json jsonOf(const std::filesystem::path& path);

/// Exit 1 with one line that holds `what`, and nothing on standard output.
void expectFailure(const Ran& ran, const std::string& what);
/// Exit 2 with one line that holds `what`.
void expectWrongCall(const Ran& ran, const std::string& what);

}  // namespace lampyris::test
