#include "unit/house/readme.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

namespace lampyris::house {
namespace {

constexpr std::array kEndings = {".h",  ".cpp", ".comp", ".vert",  ".frag", ".glsl",
                                 ".md", ".sh",  ".txt",  ".cmake", ".yml"};
constexpr std::array kTop = {"engine", "modules", "shaders", "sandbox", "tests", "cmake", ".ci"};

bool isPathCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_.+-/").find(c) != std::string::npos;
}

bool claims(const std::string& text) {
    const bool plain = !text.empty() && text.front() != '/' &&
                       text.find("//") == std::string::npos &&
                       std::all_of(text.begin(), text.end(), isPathCharacter);
    const std::string head = text.substr(0, text.find('/'));
    const bool produced = head == "build" || head == "out" || text.ends_with("/shaders.h");
    if (!plain || produced) return false;
    if (text.back() == '/') return true;
    if (head != text && std::find(kTop.begin(), kTop.end(), head) != kTop.end()) return true;
    return std::any_of(kEndings.begin(), kEndings.end(), [&](const std::string& ending) {
        return text.size() > ending.size() && text.ends_with(ending);
    });
}

// `frame.h:12`, `a.md#why` and `tile_bin.h/.cpp` name frame.h, a.md and tile_bin.h.
std::string trimmed(std::string text) {
    text.resize(std::min(text.find('#'), text.size()));
    const size_t colon = text.rfind(':');
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    if (colon != std::string::npos &&
        std::all_of(text.begin() + static_cast<std::ptrdiff_t>(colon) + 1, text.end(), digit))
        text.resize(colon);
    const size_t slash = text.rfind('/');
    const bool second =
        slash != std::string::npos && slash > 0 &&
        std::find(kEndings.begin(), kEndings.end(), text.substr(slash + 1)) != kEndings.end();
    if (second) text.resize(slash);
    return text;
}

// What stands between `open` and `close`, each time it does.
std::vector<std::string> between(const std::string& line, const std::string& open,
                                 const std::string& close) {
    std::vector<std::string> found;
    for (size_t at = line.find(open); at != std::string::npos;) {
        const size_t start = at + open.size();
        const size_t end = line.find(close, start);
        if (end == std::string::npos) break;
        found.push_back(line.substr(start, end - start));
        at = line.find(open, end + close.size());
    }
    return found;
}

}  // namespace

std::vector<PathClaim> pathClaims(std::string_view readme) {
    std::vector<PathClaim> found;
    std::istringstream lines{std::string(readme)};
    std::string line;
    bool code = false;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (line.find("```") != std::string::npos) code = !code;
        if (code) continue;
        for (const std::string& quoted : between(line, "`", "`"))
            if (const std::string path = trimmed(quoted); claims(path))
                found.push_back({path, number});
        for (const std::string& link : between(line, "](", ")"))
            if (const std::string path = trimmed(link);
                !path.empty() && path.find(':') == std::string::npos)
                found.push_back({path, number});
    }
    return found;
}

}  // namespace lampyris::house
