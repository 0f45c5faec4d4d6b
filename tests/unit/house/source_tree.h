/// \file The repository's files, as the tests read them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/file.h"

namespace lampyris::house {

inline std::filesystem::path root() {
    return LAMPYRIS_SOURCE_DIR;
}

/// Files below these folders of the repository with one of the endings, relative to it, in order.
inline std::vector<std::string> filesBelow(const std::vector<std::string>& folders,
                                           const std::vector<std::string>& endings) {
    std::vector<std::string> found;
    for (const std::string& folder : folders) {
        if (!std::filesystem::is_directory(root() / folder)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root() / folder)) {
            const std::string path = entry.path().lexically_relative(root()).generic_string();
            const auto ends = [&](const std::string& ending) { return path.ends_with(ending); };
            if (entry.is_regular_file() && std::any_of(endings.begin(), endings.end(), ends))
                found.push_back(path);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

inline std::string textOf(const std::string& path) {
    const auto bytes = core::readFile(root() / path);
    if (!bytes.ok()) {
        ADD_FAILURE() << bytes.error().message;
        return {};
    }
    return {bytes->begin(), bytes->end()};
}

}  // namespace lampyris::house
