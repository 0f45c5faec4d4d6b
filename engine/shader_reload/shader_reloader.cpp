#include "shader_reload/shader_reloader.h"

#include <atomic>
#include <future>
#include <map>
#include <optional>

#include "shader_reload/compile_shader.h"
#include "shader_reload/interface_check.h"
#include "shader_reload/source_files.h"

namespace lampyris::shader_reload {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kBetweenLooks = std::chrono::milliseconds(250);  // [chosen] unseen by who edits

/// A shader, and what its file gave.
struct Compiled {
    const graph::Shader* shader = nullptr;
    core::Result<std::vector<uint32_t>> words;
};

/// Of shaders whose files were seen to change in the same look.
struct Batch {
    Clock::time_point noticed;
    std::future<std::vector<Compiled>> compiled;
};

core::Result<std::vector<uint32_t>> compile(const graph::Shader& shader,
                                            const std::filesystem::path& folder) {
    ShaderSource source{folder, std::string{shader.source}};
    source.definitions.assign(shader.definitions.begin(), shader.definitions.end());
    TRY(auto words, compileShader(source));
    TRY_VOID(checkInterface(shader, words));
    return words;
}

}  // namespace

struct ShaderReloader::Parts {
    std::filesystem::path folder;
    SourceFiles files;
    std::map<const graph::Shader*, ShaderStatus> shaders;
    Clock::time_point lastLook{};
    std::atomic<bool> ends = false;
    std::optional<Batch> batch;

    explicit Parts(const std::filesystem::path& path) : folder(path), files(path) {}
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() { ends = true; }  // the batch's future then waits for one shader at most

    void follow(const execute::Executor& executor);
    void look();
    void start(const std::set<std::string>& changed);
    std::vector<ShaderStatus> putIn(execute::Executor& executor);
};

void ShaderReloader::Parts::follow(const execute::Executor& executor) {
    for (const graph::Shader* shader : executor.shaders()) {
        if (shader->source.empty() || shaders.contains(shader)) continue;
        shaders[shader].name = shader->name;
        files.follow(std::string{shader->source});
    }
}

void ShaderReloader::Parts::look() {
    const std::set<std::string> changed = files.changed();
    if (!changed.empty()) start(changed);
}

void ShaderReloader::Parts::start(const std::set<std::string>& changed) {
    std::vector<const graph::Shader*> toCompile;
    for (auto& [shader, status] : shaders) {
        if (!changed.contains(std::string{shader->source})) continue;
        status.state = ShaderState::Compiling;
        toCompile.push_back(shader);
    }
    const auto work = [this, toCompile] {
        std::vector<Compiled> all;
        for (const graph::Shader* shader : toCompile) {
            if (ends) break;
            all.push_back({shader, compile(*shader, folder)});
        }
        return all;
    };
    batch = Batch{Clock::now(), std::async(std::launch::async, work)};
}

std::vector<ShaderStatus> ShaderReloader::Parts::putIn(execute::Executor& executor) {
    std::vector<ShaderStatus> settled;
    for (const Compiled& compiled : batch->compiled.get()) {
        ShaderStatus& status = shaders.at(compiled.shader);
        const auto put = compiled.words.ok()
                             ? executor.replaceShader(*compiled.shader, *compiled.words)
                             : core::Result<void>{compiled.words.error()};
        status.state = put.ok() ? ShaderState::Ok : ShaderState::Broken;
        status.error = put.ok() ? std::string{} : put.error().message;
        if (put.ok()) {
            const std::chrono::duration<double, std::milli> taken = Clock::now() - batch->noticed;
            status.milliseconds = taken.count();
            ++status.reloads;
        }
        settled.push_back(status);
    }
    batch.reset();
    return settled;
}

core::Result<ShaderReloader> ShaderReloader::create(const std::filesystem::path& folder) {
    std::error_code code;
    if (!std::filesystem::is_directory(folder, code))
        return core::error("{}: there is no such folder of shaders", folder.string());
    return ShaderReloader(std::make_unique<Parts>(folder));
}

ShaderReloader::ShaderReloader(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ShaderReloader::ShaderReloader(ShaderReloader&&) noexcept = default;
ShaderReloader& ShaderReloader::operator=(ShaderReloader&&) noexcept = default;
ShaderReloader::~ShaderReloader() = default;

std::vector<ShaderStatus> ShaderReloader::update(execute::Executor& executor) {
    Parts& p = *parts_;
    std::vector<ShaderStatus> settled;
    if (p.batch) {
        if (p.batch->compiled.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return settled;
        settled = p.putIn(executor);
    }
    p.follow(executor);
    const auto now = Clock::now();
    if (now - p.lastLook < kBetweenLooks) return settled;
    p.lastLook = now;
    p.look();
    return settled;
}

std::vector<ShaderStatus> ShaderReloader::status() const {
    std::vector<ShaderStatus> all;
    for (const auto& [shader, status] : parts_->shaders) all.push_back(status);
    return all;
}

}  // namespace lampyris::shader_reload
