#include "unit/house/house.h"

#include <algorithm>
#include <sstream>

namespace lampyris::house {
namespace {

// Outside libraries: how their headers begin, and the folders that may include them. GLM's are
// those that reach math, "*" is all.
struct Library {
    const char* name;
    std::vector<std::string> headers;
    std::set<std::string> folders;
};

const std::vector<Library>& libraries() {
    static const std::vector<Library> list = {
        {"fmt", {"fmt/"}, {"*"}},
        {"spdlog", {"spdlog/"}, {"core"}},
        {"nlohmann-json",
         {"nlohmann/"},
         {"ecs", "assets", "scene", "graph", "execute", "evaluation", "overlay", "sandbox"}},
        {"stb", {"stb/"}, {"core", "assets", "residency"}},
        {"tinyexr", {"tinyexr.h"}, {"core"}},
        {"tinygltf", {"tiny_gltf.h"}, {"assets"}},
        {"Vulkan", {"vulkan/"}, {"gpu", "execute", "window", "overlay"}},
        {"Embree", {"embree3/"}, {"accel", "reference"}},
        {"TBB", {"tbb/", "oneapi/tbb"}, {"accel"}},
        {"meshoptimizer", {"meshoptimizer.h"}, {"assets", "accel"}},
        {"GLFW", {"GLFW/"}, {"window", "overlay"}},
        {"Xlib", {"X11/"}, {"window"}},
        {"Dear ImGui", {"imgui", "misc/cpp/imgui", "implot"}, {"overlay"}},
        {"CLI11", {"CLI/"}, {"sandbox"}},
        {"SPIRV-Cross", {"spirv_cross"}, {"embed"}},
        {"glslang", {"glslang/"}, {"shader_reload"}},
    };
    return list;
}

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

// Headers without a dot are the C++ standard's; these are the system's.
bool isStandard(std::string_view header) {
    static const std::set<std::string_view> posix = {"unistd.h", "fcntl.h", "dlfcn.h", "termios.h",
                                                     "poll.h"};
    return header.find('.') == std::string_view::npos || startsWith(header, "sys/") ||
           posix.contains(header);
}

std::string head(std::string_view path) {
    return std::string(path.substr(0, path.find('/')));
}

// What forbids the library header, or an empty text.
std::string libraryViolation(const std::string& folder, const std::string& header) {
    if (startsWith(header, "glm/"))
        return opened(folder).contains("math") ? ""
                                               : "GLM stands from math upwards, not in " + folder;
    for (const Library& library : libraries()) {
        const bool matches =
            std::any_of(library.headers.begin(), library.headers.end(),
                        [&](const std::string& start) { return startsWith(header, start); });
        if (!matches) continue;
        const bool allowed = library.folders.contains("*") || library.folders.contains(folder);
        return allowed ? "" : std::string(library.name) + " has no room in " + folder;
    }
    return isStandard(header) ? "" : "<" + header + "> is of no library in the house's list";
}

void open(const std::string& folder, std::set<std::string>& reached) {
    const auto found = arrows().find(folder);
    if (found == arrows().end()) return;
    for (const std::string& target : found->second) {
        if (target == "gpu" || !reached.insert(target).second) continue;
        open(target, reached);
    }
}

template <typename Judge>
std::vector<std::string> violations(std::string_view path, std::string_view text,
                                    const Judge& judge) {
    std::vector<std::string> found;
    for (const Include& include : includesOf(text)) {
        const std::string why = judge(include);
        if (!why.empty())
            found.push_back(std::string(path) + ":" + std::to_string(include.line) + ": " +
                            include.name + ": " + why);
    }
    return found;
}

}  // namespace

const std::map<std::string, std::set<std::string>>& arrows() {
    static const std::map<std::string, std::set<std::string>> list = {
        // engine/
        {"core", {}},
        {"math", {"core"}},
        {"ecs", {"core"}},
        {"assets", {"core", "math"}},
        {"scene", {"ecs", "assets", "math"}},
        {"graph", {"core"}},
        {"gpu", {"core"}},
        {"execute", {"graph", "gpu"}},
        {"window", {"core", "gpu"}},
        {"shader_reload", {"execute", "embed"}},
        // modules/
        {"residency", {"scene", "graph", "gpu", "execute"}},
        {"accel", {"residency", "scene", "graph"}},
        {"deferred", {"accel", "residency", "graph"}},
        {"photons", {"accel", "residency", "graph"}},
        {"photon_gi", {"photons", "deferred", "graph"}},
        {"reference", {"scene", "core"}},
        {"evaluation", {"core"}},
        {"overlay", {"modules", "window", "execute", "shader_reload", "gpu", "ecs"}},
        // shaders/: shared/ is open to all; embed/ is the build-time tool, and its reflection
        {"shared", {"math"}},
        {"lib", {}},
        {"embed", {"core"}},
        // the program, its game scene and the tests
        {"courtyard", {"scene"}},
        {"sandbox", {"everything"}},
        {"tests", {"everything"}},
    };
    return list;
}

std::set<std::string> opened(const std::string& folder) {
    std::set<std::string> reached{folder, "shared"};
    open(folder, reached);
    const auto& own = arrows().at(folder);
    if (own.contains("gpu")) reached.insert("gpu");
    if (own.contains("modules"))
        for (const char* module : {"residency", "accel", "deferred", "photons", "photon_gi",
                                   "reference", "evaluation"}) {
            reached.insert(module);
            open(module, reached);
        }
    if (own.contains("everything"))
        for (const auto& [name, targets] : arrows()) reached.insert(name);
    return reached;
}

std::string folderOf(std::string_view path) {
    std::string top = head(path);
    if (startsWith(path, "sandbox/courtyard/")) return "courtyard";
    if (top == "sandbox" || top == "tests") return top;
    if (top != "engine" && top != "modules" && top != "shaders") return "";
    const std::string_view rest = path.substr(top.size() + 1);
    return rest.find('/') == std::string_view::npos ? "" : head(rest);
}

std::vector<Include> includesOf(std::string_view text) {
    std::vector<Include> found;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        char hash = 0;
        std::string directive;
        if (!(words >> hash) || hash != '#' || !(words >> directive) ||
            !startsWith(directive, "include"))
            continue;
        const size_t start = line.find_first_of("\"<");
        if (start == std::string::npos) continue;
        const bool quoted = line[start] == '"';
        const size_t end = line.find(quoted ? '"' : '>', start + 1);
        if (end != std::string::npos)
            found.push_back({line.substr(start + 1, end - start - 1), quoted, number});
    }
    return found;
}

std::vector<std::string> cppViolations(std::string_view path, std::string_view text) {
    const std::string folder = folderOf(path);
    if (!arrows().contains(folder)) return {std::string(path) + ": lies in no folder of the house"};
    const std::set<std::string> open = opened(folder);
    return violations(path, text, [&](const Include& include) -> std::string {
        if (!include.quoted) return libraryViolation(folder, include.name);
        const bool beside = include.name.find('/') == std::string::npos;
        const std::string target = head(include.name);
        if (include.name.find("..") != std::string::npos) return "a path that climbs";
        if (beside || open.contains(target)) return "";
        if (folder == "sandbox" && !arrows().contains(target))
            return "";  // a folder within the sandbox
        if (!arrows().contains(target)) return "no folder of the house";
        return "no arrow from " + folder + " to " + target;
    });
}

std::vector<std::string> glslViolations(std::string_view path, std::string_view text) {
    const std::string folder = folderOf(path);
    if (!arrows().contains(folder)) return {std::string(path) + ": lies in no folder of the house"};
    std::set<std::string> open = opened(folder);
    if (folder != "shared") open.insert("lib");
    return violations(path, text, [&](const Include& include) -> std::string {
        if (!include.quoted) return "shaders include with quotes";
        const std::string target = head(include.name);
        return open.contains(target) ? "" : "no arrow from " + folder + " to " + target;
    });
}

std::map<std::string, std::set<std::string>> linkedFolders(std::string_view cmakeText) {
    static const std::set<std::string> keywords = {"ROOM", "SOURCES", "FOLDERS", "LIBRARIES",
                                                   "PUBLIC_LIBRARIES"};
    std::map<std::string, std::set<std::string>> found;
    for (size_t at = cmakeText.find("lampyris_folder("); at != std::string_view::npos;
         at = cmakeText.find("lampyris_folder(", at + 1)) {
        const size_t start = at + std::string_view("lampyris_folder(").size();
        std::istringstream words{
            std::string(cmakeText.substr(start, cmakeText.find(')', start) - start))};
        std::string name;
        std::string keyword;
        words >> name;
        std::set<std::string>& folders = found[name];
        for (std::string word; words >> word;) {
            if (keywords.contains(word)) {
                keyword = word;
            } else if (keyword == "FOLDERS") {
                folders.insert(word);
            }
        }
    }
    return found;
}

}  // namespace lampyris::house
