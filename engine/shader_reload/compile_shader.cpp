#include "shader_reload/compile_shader.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <cstring>
#include <map>
#include <optional>
#include <sstream>

#include "core/file.h"

namespace lampyris::shader_reload {
namespace {

// [chosen] A file that includes itself ends here, long before memory does; one that does so twice
// would end after 2³² steps, and ends at so many.
constexpr size_t kMostIncludesDeep = 32;
constexpr size_t kMostIncludes = 1000;
constexpr int kDefaultVersion = 100;  // of a file that names none, as glslangValidator has it

/// glslang's tables, made at the first use and kept to the program's end.
struct Compiler {
    Compiler() { glslang::InitializeProcess(); }
    ~Compiler() { glslang::FinalizeProcess(); }
    Compiler(const Compiler&) = delete;
    Compiler& operator=(const Compiler&) = delete;
};

std::optional<std::string> textOf(const std::filesystem::path& path) {
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code)) return std::nullopt;
    const auto bytes = core::readFile(path);
    if (!bytes.ok()) return std::nullopt;
    return std::string(bytes->begin(), bytes->end());
}

std::optional<EShLanguage> stageOf(const std::string& file) {
    static const std::map<std::string, EShLanguage> stages{
        {".comp", EShLangCompute}, {".vert", EShLangVertex}, {".frag", EShLangFragment}};
    const auto found = stages.find(std::filesystem::path(file).extension().string());
    return found == stages.end() ? std::nullopt : std::optional{found->second};
}

class Includer : public glslang::TShader::Includer {
 public:
    explicit Includer(const std::filesystem::path& folder) : folder_(folder) {}

    IncludeResult* includeLocal(const char* name, const char* includer, size_t depth) override {
        ++count_;
        if (refusal(depth) != nullptr) return nullptr;
        for (const std::string& file : includeCandidates(includer, name))
            if (auto text = textOf(folder_ / file)) {
                auto* const kept = new std::string(std::move(*text));
                return new IncludeResult(file, kept->data(), kept->size(), kept);
            }
        return nullptr;
    }
    /// Asked where includeLocal() found nothing. Without a name, the text is the error.
    IncludeResult* includeSystem(const char*, const char*, size_t depth) override {
        const char* const why = refusal(depth);
        return why == nullptr ? nullptr : new IncludeResult("", why, std::strlen(why), nullptr);
    }
    void releaseInclude(IncludeResult* result) override {
        if (result == nullptr) return;
        delete static_cast<std::string*>(result->userData);
        delete result;
    }

 private:
    [[nodiscard]] const char* refusal(size_t depth) const {
        if (count_ > kMostIncludes) return "more than 1000 includes: does a file include itself?";
        if (depth > kMostIncludesDeep)
            return "includes more than 32 deep: does a file include itself?";
        return nullptr;
    }

    const std::filesystem::path& folder_;
    size_t count_ = 0;
};

/// Whether a message begins with "file:12:".
bool placed(const std::string& message) {
    const size_t colon = message.find(':');
    if (colon == std::string::npos) return false;
    const size_t end = message.find_first_not_of("0123456789", colon + 1);
    return end != std::string::npos && end > colon + 1 && message[end] == ':';
}

/// The lines of an info log that begin with "ERROR: ", save those that only sum up.
core::Error firstError(const std::string& file, const std::string& log) {
    constexpr std::string_view kMark = "ERROR: ";
    std::istringstream lines(log);
    std::string line;
    std::string first;
    size_t count = 0;
    while (std::getline(lines, line)) {
        const bool sum = line.find("compilation terminated") != std::string::npos ||
                         line.find("compilation errors") != std::string::npos;
        if (!line.starts_with(kMark) || sum) continue;
        if (count++ == 0) first = line.substr(kMark.size());
    }
    first.erase(first.find_last_not_of(" \t\r") + 1);
    if (count == 0) return core::error("{}: cannot be compiled", file);
    const std::string more = count > 1 ? fmt::format(" (and {} more)", count - 1) : "";
    return core::error("{}{}{}", placed(first) ? "" : file + ": ", first, more);
}

/// As glslangValidator does for -D.
std::string preambleOf(const std::vector<std::string>& definitions) {
    std::string text;
    for (std::string definition : definitions) {
        const size_t equals = definition.find('=');
        if (equals != std::string::npos) definition[equals] = ' ';
        text += "#define " + definition + "\n";
    }
    return text;
}

}  // namespace

std::vector<std::string> includeCandidates(const std::string& includer, const std::string& name) {
    const std::filesystem::path beside = std::filesystem::path(includer).parent_path() / name;
    std::vector<std::string> files{beside.lexically_normal().generic_string()};
    std::string below = std::filesystem::path(name).lexically_normal().generic_string();
    if (below != files.front()) files.push_back(std::move(below));
    return files;
}

core::Result<std::vector<uint32_t>> compileShader(const ShaderSource& source) {
    static const Compiler compiler;
    const auto stage = stageOf(source.file);
    if (!stage) return core::error("{}: ends in none of .comp, .vert and .frag", source.file);
    const auto text = textOf(source.folder / source.file);
    if (!text) return core::error("{}: cannot be read", (source.folder / source.file).string());
    glslang::TShader shader(*stage);
    const char* const string = text->data();
    const int length = static_cast<int>(text->size());
    const char* const name = source.file.c_str();
    shader.setStringsWithLengthsAndNames(&string, &length, &name, 1);
    const std::string preamble = preambleOf(source.definitions);
    shader.setPreamble(preamble.c_str());
    shader.setEnvInput(glslang::EShSourceGlsl, *stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    constexpr auto kRules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    Includer includer(source.folder);
    if (!shader.parse(GetDefaultResources(), kDefaultVersion, false, kRules, includer))
        return firstError(source.file, shader.getInfoLog());
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(kRules) || !program.mapIO())
        return firstError(source.file, program.getInfoLog());
    std::vector<uint32_t> words;
    glslang::SpvOptions options;  // as in the build: no debug information, nothing optimised
    options.disableOptimizer = true;
    glslang::GlslangToSpv(*program.getIntermediate(*stage), words, &options);
    return words;
}

}  // namespace lampyris::shader_reload
