#include "shader_reload/shader_reloader.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <map>
#include <optional>
#include <span>
#include <utility>

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

using Words = std::vector<uint32_t>;

/// Shaders of which one cannot be used, and those that changed with it and wait for it.
struct Held {
    std::map<const graph::Shader*, Words> waiting;
    std::map<const graph::Shader*, std::string> broken;  ///< and why

    [[nodiscard]] bool has(const graph::Shader* shader) const {
        return waiting.contains(shader) || broken.contains(shader);
    }
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
    std::vector<Held> held;
    std::map<const graph::Shader*, Words> replaced;  ///< what runs in the build's place

    explicit Parts(const std::filesystem::path& path) : folder(path), files(path) {}
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() { ends = true; }  // the batch's future then waits for one shader at most

    void follow(const execute::Executor& executor);
    void look();
    void start(const std::set<std::string>& changed);
    /// What was held together with these, and these.
    Held takeHeld(const std::vector<Compiled>& changed);
    /// All of them, or none: the one that the device refuses is broken then.
    void replaceAll(execute::Executor& executor, Held& together);
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

Held ShaderReloader::Parts::takeHeld(const std::vector<Compiled>& changed) {
    Held together;
    std::erase_if(held, [&](Held& one) {
        if (std::none_of(changed.begin(), changed.end(),
                         [&](const Compiled& compiled) { return one.has(compiled.shader); }))
            return false;
        together.waiting.merge(one.waiting);
        together.broken.merge(one.broken);
        return true;
    });
    for (const Compiled& compiled : changed) {
        together.waiting.erase(compiled.shader);
        together.broken.erase(compiled.shader);
        if (compiled.words.ok())
            together.waiting.emplace(compiled.shader, *compiled.words);
        else
            together.broken.emplace(compiled.shader, compiled.words.error().message);
    }
    return together;
}

void ShaderReloader::Parts::replaceAll(execute::Executor& executor, Held& together) {
    std::vector<const graph::Shader*> done;
    for (const auto& [shader, words] : together.waiting) {
        const auto put = executor.replaceShader(*shader, words);
        if (put.ok()) {
            done.push_back(shader);
            continue;
        }
        together.broken.emplace(shader, put.error().message);
        for (const graph::Shader* other : done) {
            const auto before = replaced.find(other);
            const std::span<const uint32_t> old =
                before == replaced.end() ? other->words : std::span<const uint32_t>(before->second);
            const auto back = executor.replaceShader(*other, old);
            if (!back.ok()) together.broken.emplace(other, back.error().message);
        }
        break;
    }
    for (const auto& [shader, error] : together.broken) together.waiting.erase(shader);
}

std::vector<ShaderStatus> ShaderReloader::Parts::putIn(execute::Executor& executor) {
    const std::vector<Compiled> changed = batch->compiled.get();
    Held together = takeHeld(changed);
    if (together.broken.empty()) replaceAll(executor, together);
    const std::chrono::duration<double, std::milli> taken = Clock::now() - batch->noticed;
    batch.reset();
    const bool whole = together.broken.empty();
    std::vector<ShaderStatus> settled;
    for (auto& [shader, words] : together.waiting) {
        ShaderStatus& status = shaders.at(shader);
        status.state = whole ? ShaderState::Ok : ShaderState::Waiting;
        status.error.clear();
        if (!whole) continue;
        status.milliseconds = taken.count();
        ++status.reloads;
        replaced.insert_or_assign(shader, std::move(words));
        settled.push_back(status);
    }
    for (const auto& [shader, error] : together.broken) {
        ShaderStatus& status = shaders.at(shader);
        if (status.state == ShaderState::Broken && status.error == error) continue;  // as before
        status.state = ShaderState::Broken;
        status.error = error;
        settled.push_back(status);
    }
    if (!whole) held.push_back(std::move(together));
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
