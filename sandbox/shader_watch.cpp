#include "shader_watch.h"

#include <filesystem>

#include "core/log.h"

namespace lampyris::sandbox {
namespace {

constexpr const char* kOff = "off";
constexpr const char* kBuiltFrom = LAMPYRIS_SHADER_FOLDER;

}  // namespace

core::Result<ShaderWatch> ShaderWatch::create(const std::string& asked) {
    ShaderWatch watch;
    if (asked == kOff || (asked.empty() && builtFrom().empty())) return watch;
    auto reloader = shader_reload::ShaderReloader::create(asked.empty() ? kBuiltFrom : asked);
    if (!reloader.ok()) return core::error("--shaders {}", reloader.error().message);
    watch.reloader_ = std::move(reloader).value();
    return watch;
}

std::filesystem::path ShaderWatch::builtFrom() {
    std::error_code code;
    return std::filesystem::is_directory(kBuiltFrom, code) ? kBuiltFrom : "";
}

void ShaderWatch::update(FrameLoop& loop) {
    if (!reloader_) return;
    bool reloaded = false;
    for (const shader_reload::ShaderStatus& status : reloader_->update(loop.executor())) {
        if (status.state == shader_reload::ShaderState::Broken) {
            core::logWarning("{} stays as it was: {}", status.name, status.error);
            continue;
        }
        core::logInfo("{} reloaded in {:.0f} ms", status.name, status.milliseconds);
        reloaded = true;
    }
    if (reloaded) loop.renderer().forget();
}

std::vector<shader_reload::ShaderStatus> ShaderWatch::status() const {
    return reloader_ ? reloader_->status() : std::vector<shader_reload::ShaderStatus>{};
}

}  // namespace lampyris::sandbox
