/// \file Moments in a file: a line of JSON each, behind a line that says what was viewed, and how.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "view/moment.h"

namespace lampyris::sandbox::view {

/// Kept in memory and written at the end, in one step.
class InputRecorder {
 public:
    /// \param state  that the view began with, as JSON text
    InputRecorder(const std::string& scene, const std::string& state);
    void add(const Moment& moment);
    [[nodiscard]] core::Result<void> write(const std::filesystem::path& path) const;

 private:
    std::string text_;
};

struct InputLog {
    std::string state;  ///< as InputRecorder was given it
    std::vector<Moment> moments;
};

/// Errors name the file and the line: no such log, another scene's.
core::Result<InputLog> readInputLog(const std::filesystem::path& path, const std::string& scene);

}  // namespace lampyris::sandbox::view
