/// \file Moments in a file: a line of JSON each, behind a line that says what was viewed.
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
    explicit InputRecorder(const std::string& scene);
    void add(const Moment& moment);
    [[nodiscard]] core::Result<void> write(const std::filesystem::path& path) const;

 private:
    std::string text_;
};

/// All moments of a file. Errors name the file and the line: no such log, another scene's.
core::Result<std::vector<Moment>> readInputLog(const std::filesystem::path& path,
                                               const std::string& scene);

}  // namespace lampyris::sandbox::view
