#include "unit/house/readme.h"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

namespace lampyris::house {
namespace {

constexpr std::array kEndings = {".h",  ".cpp", ".comp",  ".vert", ".frag", ".glsl",
                                 ".md", ".sh",  ".cmake", ".txt",  ".yml"};
constexpr std::array kTop = {"engine", "modules", "shaders", "sandbox", "tests", "cmake", ".ci"};

bool claims(const std::string& text) {
    static const std::regex plain("[A-Za-z0-9_.+-]+(/[A-Za-z0-9_.+-]+)*/?");
    if (!std::regex_match(text, plain)) return false;
    const std::string head = text.substr(0, text.find('/'));
    if (head == "build" || head == "out" || text.ends_with("/shaders.h")) return false;  // produced
    if (text.size() > 1 && text.back() == '/') return true;
    if (head != text && std::find(kTop.begin(), kTop.end(), head) != kTop.end()) return true;
    return std::any_of(kEndings.begin(), kEndings.end(), [&](const std::string& ending) {
        return text.size() > ending.size() && text.ends_with(ending);
    });
}

// `frame.h:12` and `tile_bin.h/.cpp` name frame.h and tile_bin.h.
std::string trimmed(std::string text) {
    static const std::regex place(":[0-9]+$|#.*$");
    text = std::regex_replace(text, place, "");
    const size_t second = text.find("/.");
    if (second != std::string::npos && second > 0 &&
        text.find('/', second + 1) == std::string::npos) {
        const std::string ending = text.substr(second + 1);
        if (std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end())
            text.resize(second);
    }
    return text;
}

}  // namespace

std::vector<PathClaim> pathClaims(std::string_view readme) {
    static const std::regex quoted("`([^`]+)`");
    static const std::regex link(R"(\]\(([^)\s]+)\))");
    std::vector<PathClaim> found;
    std::istringstream lines{std::string(readme)};
    std::string line;
    bool code = false;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (line.find("```") != std::string::npos) code = !code;
        if (code) continue;
        for (std::sregex_iterator it(line.begin(), line.end(), quoted), end; it != end; ++it) {
            const std::string text = trimmed((*it)[1]);
            if (claims(text)) found.push_back({text, number});
        }
        for (std::sregex_iterator it(line.begin(), line.end(), link), end; it != end; ++it) {
            const std::string text = trimmed((*it)[1]);
            if (!text.empty() && text.find(':') == std::string::npos)
                found.push_back({text, number});
        }
    }
    return found;
}

}  // namespace lampyris::house
