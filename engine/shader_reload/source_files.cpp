#include "shader_reload/source_files.h"

#include <algorithm>
#include <sstream>

#include "core/file.h"
#include "shader_reload/compile_shader.h"

namespace lampyris::shader_reload {
namespace {

/// What the #include lines of a text name, whatever #if they stand in.
std::vector<std::string> includesOf(const std::string& text) {
    std::vector<std::string> names;
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) {
        const size_t hash = line.find_first_not_of(" \t");
        if (hash == std::string::npos || line[hash] != '#') continue;
        const size_t word = line.find_first_not_of(" \t", hash + 1);
        if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
        const size_t open = line.find('"', word);
        const size_t close = line.find('"', open == std::string::npos ? open : open + 1);
        if (close != std::string::npos) names.push_back(line.substr(open + 1, close - open - 1));
    }
    return names;
}

}  // namespace

SourceFiles::Stamp SourceFiles::stampOf(const std::string& file) const {
    std::error_code code;
    const auto time = std::filesystem::last_write_time(folder_ / file, code);
    if (code) return {};
    const uintmax_t bytes = std::filesystem::file_size(folder_ / file, code);
    if (code) return {};
    return {time, bytes};
}

void SourceFiles::scan(const std::string& file) {
    // The time first: what is written while it is read shows as a change later.
    File found{stampOf(file), {}};
    if (found.stamp != Stamp{}) {
        const auto bytes = core::readFile(folder_ / file);
        if (bytes.ok())
            for (const std::string& name : includesOf({bytes->begin(), bytes->end()}))
                for (std::string& candidate : includeCandidates(file, name))
                    found.includes.push_back(std::move(candidate));
    }
    const auto includes = found.includes;
    files_.insert_or_assign(file, std::move(found));
    for (const std::string& include : includes)
        if (!files_.contains(include)) meet(include);
}

void SourceFiles::meet(const std::string& file) {
    scan(file);
    Stamp& stamp = files_.at(file).stamp;
    if (stamp.time > begun_) stamp = {};  // which is not what changed() will find
}

void SourceFiles::follow(const std::string& file) {
    if (!followed_.insert(file).second || files_.contains(file)) return;
    meet(file);
}

bool SourceFiles::reaches(const std::string& file, const std::set<std::string>& wanted,
                          std::set<std::string>& seen) const {
    if (wanted.contains(file)) return true;
    if (!seen.insert(file).second) return false;
    const auto& includes = files_.at(file).includes;
    return std::any_of(includes.begin(), includes.end(),
                       [&](const std::string& include) { return reaches(include, wanted, seen); });
}

std::set<std::string> SourceFiles::changed() {
    std::set<std::string> others;
    for (const auto& [file, known] : files_)
        if (stampOf(file) != known.stamp) others.insert(file);
    std::set<std::string> changed;
    for (const std::string& file : followed_) {
        std::set<std::string> seen;
        if (reaches(file, others, seen)) changed.insert(file);
    }
    for (const std::string& file : others) scan(file);
    return changed;
}

}  // namespace lampyris::shader_reload
