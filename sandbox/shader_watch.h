/// \file `view --shaders`: shaders that reload while the window is open.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frame_loop.h"
#include "shader_reload/shader_reloader.h"

namespace lampyris::sandbox {

class ShaderWatch {
 public:
    /// \param asked a folder; "off"; or empty: the folder that the program was built from, and
    /// nothing where that is gone. An Error names a folder that was asked for and is not there.
    static core::Result<ShaderWatch> create(const std::string& asked);

    /// The folder that the program was built from; empty where that is gone.
    [[nodiscard]] static std::filesystem::path builtFrom();

    /// Once a frame, before it is drawn. Says on stderr what was reloaded, and what is broken.
    void update(FrameLoop& loop);

    /// Of all shaders that have run so far; empty where nothing is watched.
    [[nodiscard]] std::vector<shader_reload::ShaderStatus> status() const;

 private:
    std::optional<shader_reload::ShaderReloader> reloader_;
};

}  // namespace lampyris::sandbox
