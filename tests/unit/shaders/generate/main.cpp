// lampyris_shared_layout OUT_FOLDER HEADER…
// Finds every struct of shaders/shared/ and writes two files: shared_layout.comp, which binds each
// as a storage and as a uniform buffer, and shared_layout.cpp, a table of offsetof for each member.
#include <cstdio>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "core/file.h"

namespace {

using lampyris::core::Result;

struct Struct {
    std::string name;
    std::vector<std::string> members;
};

std::string withoutComments(const std::string& text) {
    return std::regex_replace(text, std::regex{"//[^\n]*"}, "");
}

/// Members of "vec4 row0, row1; uint words[4];".
std::vector<std::string> membersOf(const std::string& body) {
    std::vector<std::string> members;
    const std::regex declaration{R"(\w+\s+([^;]+);)"};
    const std::regex name{R"((\w+)\s*(\[[^\]]*\])?)"};
    for (std::sregex_iterator one{body.begin(), body.end(), declaration}, end; one != end; ++one) {
        const std::string names = (*one)[1];
        for (std::sregex_iterator each{names.begin(), names.end(), name}; each != end; ++each)
            members.push_back((*each)[1]);
    }
    return members;
}

std::vector<Struct> structsOf(const std::string& text) {
    std::vector<Struct> structs;
    const std::regex pattern{R"(struct\s+(\w+)\s*\{([^}]*)\}\s*;)"};
    for (std::sregex_iterator one{text.begin(), text.end(), pattern}, end; one != end; ++one)
        structs.push_back({(*one)[1], membersOf((*one)[2])});
    return structs;
}

std::string shaderText(const std::vector<std::string>& headers,
                       const std::vector<Struct>& structs) {
    std::string text = "#version 460\n#extension GL_GOOGLE_include_directive : require\n";
    for (const std::string& header : headers) text += "#include \"shared/" + header + "\"\n";
    text += "layout(local_size_x = 1) in;\n";
    int slot = 0;
    for (const Struct& one : structs) {
        text += fmt::format("layout(binding = {}) buffer Storage{} {{ {} values[]; }} s{};\n", slot,
                            one.name, one.name, slot);
        text += fmt::format("layout(binding = {}) uniform Uniform{} {{ {} value; }} u{};\n",
                            slot + 1, one.name, one.name, slot);
        slot += 2;
    }
    return text + "void main() {}\n";
}

std::string tableText(const std::vector<std::string>& headers, const std::vector<Struct>& structs) {
    std::string text = "#include <cstddef>\n\n#include \"unit/shaders/shared_layout.h\"\n";
    for (const std::string& header : headers) text += "#include \"shared/" + header + "\"\n";
    text +=
        "\nnamespace lampyris::test {\n\nconst std::vector<SharedStruct>& sharedStructs() {\n"
        "    using namespace lampyris::shared;\n"
        "    static const std::vector<SharedStruct> structs{\n";
    for (const Struct& one : structs) {
        text += fmt::format("        {{\"{0}\", sizeof({0}), {{\n", one.name);
        for (const std::string& member : one.members)
            text += fmt::format("            {{\"{0}\", offsetof({1}, {0})}},\n", member, one.name);
        text += "        }},\n";
    }
    return text + "    };\n    return structs;\n}\n\n}  // namespace lampyris::test\n";
}

Result<void> run(const std::filesystem::path& folder, const std::vector<std::string>& paths) {
    std::vector<std::string> headers;
    std::vector<Struct> structs;
    for (const std::string& path : paths) {
        TRY(const auto bytes, lampyris::core::readFile(path));
        const auto found = structsOf(withoutComments({bytes.begin(), bytes.end()}));
        structs.insert(structs.end(), found.begin(), found.end());
        headers.push_back(std::filesystem::path{path}.filename().string());
    }
    TRY_VOID(
        lampyris::core::writeFile(folder / "shared_layout.comp", shaderText(headers, structs)));
    return lampyris::core::writeFile(folder / "shared_layout.cpp", tableText(headers, structs));
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) return 2;
    const auto done = run(arguments[1], {arguments + 2, arguments + count});
    if (done.ok()) return 0;
    std::fprintf(stderr, "lampyris_shared_layout: %s\n", done.error().message.c_str());
    return 1;
}
