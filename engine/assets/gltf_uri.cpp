#include "assets/gltf_uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "core/file.h"

namespace lampyris::assets {
namespace {

constexpr std::string_view kDataScheme = "data:";
constexpr std::string_view kBase64Mark = ";base64,";

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

core::Result<std::string> decodePercent(std::string_view text) {
    std::string decoded;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        const int high = i + 2 < text.size() ? hexDigit(text[i + 1]) : -1;
        const int low = i + 2 < text.size() ? hexDigit(text[i + 2]) : -1;
        if (high < 0 || low < 0) return core::error("has a % that no two hex digits follow");
        decoded += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return decoded;
}

/// A name and a colon before any slash, as in http: or C:
bool hasScheme(std::string_view uri) {
    const size_t colon = uri.find(':');
    return colon != std::string_view::npos && colon < uri.find('/');
}

std::array<int8_t, 256> base64Table() {
    std::array<int8_t, 256> table{};
    table.fill(-1);
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < digits.size(); ++i)
        table[static_cast<uint8_t>(digits[i])] = static_cast<int8_t>(i);
    return table;
}

core::Result<std::vector<uint8_t>> decodeBase64(std::string_view text) {
    static const std::array<int8_t, 256> kTable = base64Table();
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::vector<uint8_t> bytes;
    bytes.reserve(text.size() * 3 / 4);
    uint32_t bits = 0;
    int bitCount = 0;
    for (const char c : text) {
        const int8_t digit = kTable[static_cast<uint8_t>(c)];
        if (digit < 0) return core::error("is a data: URI with characters that are no base64");
        bits = bits << 6u | static_cast<uint32_t>(digit);
        bitCount += 6;
        if (bitCount >= 8) {
            bitCount -= 8;
            bytes.push_back(static_cast<uint8_t>(bits >> static_cast<uint32_t>(bitCount)));
        }
    }
    return bytes;
}

}  // namespace

core::Result<GltfUri> parseUri(const std::string& uri) {
    if (uri.starts_with(kDataScheme)) return GltfUri{true, {}};
    if (uri.empty()) return core::error("is empty");
    if (hasScheme(uri)) return core::error("\"{}\" is no relative path", uri.substr(0, 80));
    TRY(const std::string decoded, decodePercent(uri));
    if (decoded.find('\0') != std::string::npos || decoded.find('\\') != std::string::npos)
        return core::error("\"{}\" is no file name", uri.substr(0, 80));
    const std::filesystem::path path(decoded);
    if (path.is_absolute()) return core::error("\"{}\" is no relative path", decoded);
    if (std::find(path.begin(), path.end(), "..") != path.end())
        return core::error("\"{}\" leaves the file's folder", decoded);
    return GltfUri{false, path};
}

core::Result<std::vector<uint8_t>> readUri(const std::string& uri,
                                           const std::optional<std::filesystem::path>& folder) {
    TRY(const GltfUri parsed, parseUri(uri));
    if (parsed.isData) {
        const size_t mark = uri.find(kBase64Mark);
        if (mark == std::string::npos) return core::error("is a data: URI without ;base64,");
        return decodeBase64(std::string_view(uri).substr(mark + kBase64Mark.size()));
    }
    if (!folder) return core::error("{} lies beside a file that has no folder", uri);
    const std::filesystem::path path = *folder / parsed.path;
    std::error_code code;
    if (!std::filesystem::exists(path, code)) return core::error("{} is missing", path.string());
    if (!std::filesystem::is_regular_file(path, code))
        return core::error("{} is no plain file", path.string());
    return core::readFile(path);
}

}  // namespace lampyris::assets
