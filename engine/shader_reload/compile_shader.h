/// \file GLSL to SPIR-V while the program runs, with the options of the build (cmake/
/// LampyrisShaders.cmake): the same file gives the same words.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

namespace lampyris::shader_reload {

struct ShaderSource {
    std::filesystem::path folder;            ///< of all shaders; includes are looked up there
    std::string file;                        ///< below it; its ending tells the stage
    std::vector<std::string> definitions{};  ///< as for -D: "MASKED=1"
};

/// Files that an include of `includer` may mean, the first that exists first; below the folder.
[[nodiscard]] std::vector<std::string> includeCandidates(const std::string& includer,
                                                         const std::string& name);

/// An Error is the compiler's first message, with its place: "lib/rng.glsl:12: …", and how many
/// more there are. Any thread may call this.
core::Result<std::vector<uint32_t>> compileShader(const ShaderSource& source);

}  // namespace lampyris::shader_reload
