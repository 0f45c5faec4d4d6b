/// \file What a README claims to exist.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lampyris::house {

struct PathClaim {
    std::string path;
    int line = 0;
};

/// Paths of the repository that a README names, in backticks or as a link's target: what ends in a
/// source file's ending or a slash, or begins with a folder of the top level. Code blocks,
/// commands, globs, placeholders, URLs and what a build or a run produces (build/, out/) claim
/// nothing.
std::vector<PathClaim> pathClaims(std::string_view readme);

}  // namespace lampyris::house
