/// \file Shaders that reload while the program runs: their files are watched, compiled beside the
/// frames, and put in between two of them. Open this file first.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "execute/executor.h"

namespace lampyris::shader_reload {

enum class ShaderState : uint8_t {
    Ok,
    Compiling,
    Waiting,  ///< compiled, and held back until what changed with it can be used too
    Broken,   ///< its file cannot be used; the last words that could go on
};

struct ShaderStatus {
    std::string_view name{};  ///< "photon_gi/gather_add.comp"
    ShaderState state = ShaderState::Ok;
    std::string error{};        ///< of the last try: "lib/rng.glsl:12: …"; empty: none
    double milliseconds = 0.0;  ///< of the last reload, from noticing the file to running it
    uint32_t reloads = 0;
};

class ShaderReloader {
 public:
    /// \param folder as `source` of the shaders has it: the repository's shaders/
    /// An Error names the folder where there is none.
    static core::Result<ShaderReloader> create(const std::filesystem::path& folder);
    ShaderReloader(ShaderReloader&&) noexcept;
    ShaderReloader& operator=(ShaderReloader&&) noexcept;
    ~ShaderReloader();  ///< after the shader that is being compiled

    /// To be called between two frames: looks for files that changed, at most four times a second,
    /// and puts in what was compiled since. Shaders that changed together go in together, or, where
    /// one of them cannot be used, none does until it is mended. Follows every shader that
    /// `executor` has run.
    /// \return those put in or found broken in this call; in most there is none
    std::vector<ShaderStatus> update(execute::Executor& executor);

    /// Of all shaders followed.
    [[nodiscard]] std::vector<ShaderStatus> status() const;

 private:
    struct Parts;
    explicit ShaderReloader(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace lampyris::shader_reload
