/// \file A table of results, for people and for programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

namespace lampyris::sandbox {

struct Table {
    std::string name;   ///< of its files
    std::string title;  ///< one line: what was measured, where, how often
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;  ///< as long as the header
};

/// Aligned columns: the first to the left, the others to the right.
[[nodiscard]] std::string toText(const Table& table);
[[nodiscard]] std::string toMarkdown(const Table& table);
[[nodiscard]] std::string toCsv(const Table& table);

/// Prints to stdout; where a folder is named, writes <name>.csv and <name>.md there.
core::Result<void> publish(const Table& table, const std::filesystem::path& folder);

}  // namespace lampyris::sandbox
