// lampyris_shader_embed MODULE OUT_FOLDER [NAME=FILE.spv=SOURCE [-DDEFINITION]…]…
// Writes OUT_FOLDER/shaders.h and .cpp: a graph::Shader for each compiled shader of a module.
#include <cctype>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.h"
#include "embed/reflection.h"

namespace lampyris::embed {
namespace {

using core::Result;

struct Shader {
    std::string name;        ///< "deferred/gbuffer.vert"
    std::string identifier;  ///< "gbufferVert"
    std::string source;      ///< "deferred/gbuffer.vert", below the shaders' folder
    std::vector<std::string> definitions;  ///< "MASKED=1"
    std::vector<uint32_t> words;
    Reflection reflection;
};

/// gbuffer.vert → gbufferVert, photon_trace.comp → photonTrace.
std::string identifierOf(std::string_view name) {
    std::string text{name.substr(name.find_last_of('/') + 1)};
    if (text.ends_with(".comp")) text.resize(text.size() - std::strlen(".comp"));
    std::string identifier;
    bool upper = false;
    for (const char c : text) {
        const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (letter)
            identifier +=
                upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        upper = !letter;
    }
    return identifier;
}

Result<Shader> load(std::string_view argument) {
    const size_t first = argument.find('=');
    const size_t last = argument.rfind('=');
    if (first == last) return core::error("{}: want NAME=FILE=SOURCE", argument);
    Shader shader;
    shader.name = argument.substr(0, first);
    shader.identifier = identifierOf(shader.name);
    shader.source = argument.substr(last + 1);
    TRY(const auto bytes,
        core::readFile(std::string{argument.substr(first + 1, last - first - 1)}));
    shader.words.resize(bytes.size() / sizeof(uint32_t));
    std::memcpy(shader.words.data(), bytes.data(), shader.words.size() * sizeof(uint32_t));
    auto reflection = reflect(shader.words);
    if (!reflection) return core::error("{}: {}", shader.name, reflection.error().message);
    shader.reflection = std::move(reflection).value();
    return shader;
}

std::string headerText(const std::string& module, const std::vector<Shader>& shaders) {
    std::string text = fmt::format(
        "// Written by lampyris_shader_embed.\n#pragma once\n\n#include \"graph/shader.h\"\n\n"
        "namespace lampyris::{}::shaders {{\n\n",
        module);
    for (const Shader& shader : shaders)
        text += fmt::format("extern const graph::Shader {};  ///< {}\n", shader.identifier,
                            shader.name);
    return text + fmt::format("\n}}  // namespace lampyris::{}::shaders\n", module);
}

std::string quoted(const std::vector<std::string>& texts) {
    std::string list;
    for (const std::string& text : texts) list += fmt::format("\"{}\",", text);
    return list;
}

std::string definitionText(const Shader& shader) {
    const Reflection& reflection = shader.reflection;
    std::string text = fmt::format("constexpr uint32_t {}Words[] = {{", shader.identifier);
    for (const uint32_t word : shader.words) text += fmt::format("{:#x},", word);
    text += "};\n";
    if (!reflection.slots.empty()) {
        text += fmt::format("constexpr graph::ShaderSlot {}Slots[] = {{\n", shader.identifier);
        for (const Slot& slot : reflection.slots)
            text += fmt::format("    {{\"{}\", {}, graph::SlotKind::{}, {}, {}}},\n", slot.name,
                                slot.slot, slot.kind, slot.reads, slot.writes);
        text += "};\n";
    }
    if (!shader.definitions.empty())
        text += fmt::format("constexpr std::string_view {}Definitions[] = {{{}}};\n",
                            shader.identifier, quoted(shader.definitions));
    const std::string slots = reflection.slots.empty() ? "{}" : shader.identifier + "Slots";
    const std::string definitions =
        shader.definitions.empty() ? "{}" : shader.identifier + "Definitions";
    const auto& size = reflection.workgroupSize;
    return text + fmt::format(
                      "}}\nconst graph::Shader {0}{{\"{1}\", {0}Words, {2}, {{{3}, {4}, {5}}}, "
                      "{6}, \"{7}\", {8}}};\nnamespace {{\n",
                      shader.identifier, shader.name, slots, size[0], size[1], size[2],
                      reflection.pushConstantBytes, shader.source, definitions);
}

std::string sourceText(const std::string& module, const std::vector<Shader>& shaders) {
    std::string text = fmt::format(
        "// Written by lampyris_shader_embed.\n#include \"{0}/shaders.h\"\n\n"
        "namespace lampyris::{0}::shaders {{\nnamespace {{\n",
        module);
    for (const Shader& shader : shaders) text += definitionText(shader);
    return text + fmt::format("}}\n}}  // namespace lampyris::{}::shaders\n", module);
}

/// An unchanged header keeps its date, so that what includes it is not compiled again.
Result<void> writeIfChanged(const std::filesystem::path& path, const std::string& text) {
    const auto old = std::filesystem::exists(path) ? core::readFile(path)
                                                   : Result<std::vector<uint8_t>>{core::error("")};
    if (old.ok() &&
        std::string_view{reinterpret_cast<const char*>(old->data()), old->size()} == text)
        return {};
    return core::writeFile(path, text);
}

Result<void> run(const std::string& module, const std::filesystem::path& folder,
                 const std::vector<std::string_view>& arguments) {
    std::vector<Shader> shaders;
    for (const std::string_view argument : arguments) {
        if (argument.starts_with("-D") && !shaders.empty()) {
            shaders.back().definitions.emplace_back(argument.substr(2));
            continue;
        }
        TRY(Shader shader, load(argument));
        shaders.push_back(std::move(shader));
    }
    TRY_VOID(writeIfChanged(folder / "shaders.h", headerText(module, shaders)));
    return writeIfChanged(folder / "shaders.cpp", sourceText(module, shaders));
}

}  // namespace
}  // namespace lampyris::embed

int main(int count, char** arguments) {
    if (count < 3) {
        std::fputs("usage: lampyris_shader_embed MODULE OUT_FOLDER [NAME=FILE.spv=SOURCE [-DDEFINITION]…]…\n",
                   stderr);
        return 2;
    }
    const auto done =
        lampyris::embed::run(arguments[1], arguments[2], {arguments + 3, arguments + count});
    if (done.ok()) return 0;
    std::fprintf(stderr, "lampyris_shader_embed: %s\n", done.error().message.c_str());
    return 1;
}
