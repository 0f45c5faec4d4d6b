/// \file Moments in a file: a line of JSON each, behind a line that says what was viewed, and how.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "view/moment.h"

namespace lampyris::sandbox::view {

/// What was viewed: a replay must be of the same, as these are no part of the state.
struct InputHead {
    std::string scene, camera, animation;  ///< as the options name them
};

/// Kept in memory and written at the end, in one step.
class InputRecorder {
 public:
    /// \param state  that the view began with, as JSON text
    InputRecorder(const InputHead& head, const std::string& state);
    void add(const Moment& moment);
    [[nodiscard]] core::Result<void> write(const std::filesystem::path& path) const;

 private:
    std::string text_;
};

struct InputLog {
    std::string state;  ///< as InputRecorder was given it
    std::vector<Moment> moments;
};

/// Errors name the file and the line: no such log, another scene's or camera's.
core::Result<InputLog> readInputLog(const std::filesystem::path& path, const InputHead& head);

}  // namespace lampyris::sandbox::view
