#include "assets/gltf_container.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace lampyris::assets {
namespace {

constexpr uint32_t kMagic = 0x46546c67;      // "glTF"
constexpr uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
constexpr uint32_t kBinChunk = 0x004e4942;   // "BIN"
constexpr size_t kHeaderBytes = 12;
constexpr size_t kChunkHeaderBytes = 8;

using Bytes = std::span<const uint8_t>;

uint32_t littleEndian(Bytes bytes, size_t offset) {
    return uint32_t{bytes[offset]} | uint32_t{bytes[offset + 1]} << 8u |
           uint32_t{bytes[offset + 2]} << 16u | uint32_t{bytes[offset + 3]} << 24u;
}

struct Chunk {
    uint32_t type = 0;
    Bytes bytes;
};

/// The chunk at `offset`, which moves behind it (and behind the padding to four bytes).
core::Result<Chunk> nextChunk(Bytes file, size_t& offset, const GltfContext& context) {
    if (file.size() - offset < kChunkHeaderBytes)
        return context.error("", "the GLB ends at byte {}, inside a chunk's header", file.size());
    const uint32_t length = littleEndian(file, offset);
    const uint32_t type = littleEndian(file, offset + 4);
    const size_t begin = offset + kChunkHeaderBytes;
    if (length > file.size() - begin)
        return context.error("", "the GLB chunk at byte {} reaches byte {} of a file of {}", offset,
                             uint64_t{begin} + length, file.size());
    offset = std::min(file.size(), begin + (size_t{length} + 3) / 4 * 4);
    return Chunk{type, file.subspan(begin, length)};
}

/// Brackets open at once at most, strings left out.
size_t deepestNesting(std::string_view text) {
    size_t depth = 0;
    size_t deepest = 0;
    bool inString = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') ++i;
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            deepest = std::max(deepest, ++depth);
        } else if ((c == '}' || c == ']') && depth > 0) {
            --depth;
        }
    }
    return deepest;
}

core::Result<Json> parseJson(Bytes bytes, const GltfContext& context) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (deepestNesting(text) > kDeepestNesting)
        return context.error("", "its JSON is nested deeper than {} levels", kDeepestNesting);
    try {
        Json json = Json::parse(text.begin(), text.end());
        if (!json.is_object()) return context.error("", "is no glTF: its JSON is no object");
        return json;
    } catch (const Json::exception& exception) {
        const std::string_view what = exception.what();
        return context.error("", "is no glTF: {}", what.substr(what.find(']') + 2));
    }
}

core::Result<GltfContainer> openGlb(Bytes bytes, const GltfContext& context) {
    if (bytes.size() < kHeaderBytes)
        return context.error("", "the GLB ends at byte {}, inside its header", bytes.size());
    const uint32_t version = littleEndian(bytes, 4);
    const uint32_t length = littleEndian(bytes, 8);
    if (version != 2) return context.error("", "is GLB version {}; only 2 is read", version);
    if (length > bytes.size())
        return context.error("", "the GLB's header says {} bytes, and the file has {}", length,
                             bytes.size());
    if (length < kHeaderBytes)
        return context.error("", "the GLB's header says {} bytes, fewer than itself", length);
    const Bytes file = bytes.first(length);

    size_t offset = kHeaderBytes;
    TRY(const Chunk first, nextChunk(file, offset, context));
    if (first.type != kJsonChunk) return context.error("", "the GLB's first chunk is not JSON");
    GltfContainer container;
    TRY(container.json, parseJson(first.bytes, context));
    while (offset < file.size()) {
        TRY(const Chunk chunk, nextChunk(file, offset, context));
        if (chunk.type == kBinChunk && !container.binary) container.binary = chunk.bytes;
    }
    return container;
}

}  // namespace

core::Result<GltfContainer> openContainer(Bytes bytes, const GltfContext& context) {
    if (bytes.empty()) return context.error("", "is empty");
    if (bytes.size() >= 4 && littleEndian(bytes, 0) == kMagic) return openGlb(bytes, context);
    TRY(Json json, parseJson(bytes, context));
    return GltfContainer{std::move(json), {}};
}

}  // namespace lampyris::assets
