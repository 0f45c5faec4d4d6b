/// \file The house's list of rooms, and the rules that follow from it. Pure functions: the tests
/// feed them the repository, and planted violations.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lampyris::house {

/// folder → the folders of ours that its arrow points to.
const std::map<std::string, std::set<std::string>>& arrows();

/// What a folder may include: itself, its arrow's targets and what those open, save gpu, which must
/// be named.
std::set<std::string> opened(const std::string& folder);

/// The folder of the house that a path relative to the repository lies in:
/// engine/scene/systems/a.cpp → scene, sandbox/run.cpp → sandbox, sandbox/courtyard/a.cpp →
/// courtyard, shaders/deferred/a.comp → deferred, shaders/shared/a.h → shared. Empty outside.
std::string folderOf(std::string_view path);

/// One #include line: the name between the quotes or brackets, and which of the two.
struct Include {
    std::string name;
    bool quoted = false;
    int line = 0;
};
std::vector<Include> includesOf(std::string_view text);

/// What is wrong with the includes of a C++ file, one line each ("path:line: …"); empty when all is
/// well.
std::vector<std::string> cppViolations(std::string_view path, std::string_view text);
/// The same for GLSL.
std::vector<std::string> glslViolations(std::string_view path, std::string_view text);

/// The FOLDERS of each lampyris_folder(NAME …) in a CMakeLists.txt, by name.
std::map<std::string, std::set<std::string>> linkedFolders(std::string_view cmakeText);

}  // namespace lampyris::house
