#include "core/exr_check.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>

namespace lampyris::core {
namespace {

constexpr size_t kStart = 8;  // magic number, version and flags
constexpr int64_t kMaxSide = 65535;
constexpr int64_t kMaxPixels = int64_t{1} << 28;  // [chosen] 3 GiB as three floats

/// A little-endian number, or nothing where the file ends before it does.
template <typename T>
std::optional<T> numberAt(std::span<const uint8_t> bytes, uint64_t at) {
    if (at > bytes.size() || bytes.size() - at < sizeof(T)) return std::nullopt;
    T number{};
    std::memcpy(&number, bytes.data() + at, sizeof(T));
    return number;
}

/// A text and the zero behind it.
std::optional<std::string_view> textAt(std::span<const uint8_t> bytes, uint64_t at) {
    if (at >= bytes.size()) return std::nullopt;
    const auto rest = bytes.subspan(at);
    const auto end = std::find(rest.begin(), rest.end(), uint8_t{0});
    if (end == rest.end()) return std::nullopt;
    return std::string_view(reinterpret_cast<const char*>(rest.data()),
                            static_cast<size_t>(end - rest.begin()));
}

/// tinyexr aborts where the attribute `type` is there and names anything else.
Result<void> checkTypeAttribute(std::span<const uint8_t> bytes) {
    for (uint64_t at = kStart;;) {
        const auto name = textAt(bytes, at);
        if (!name) return error("the header is cut off");
        if (name->empty()) return {};
        const auto type = textAt(bytes, at + name->size() + 1);
        if (!type) return error("the header is cut off in attribute '{}'", *name);
        const uint64_t size = at + name->size() + type->size() + 2;
        const auto length = numberAt<uint32_t>(bytes, size);
        if (!length || bytes.size() - size - sizeof(uint32_t) < *length)
            return error("the header is cut off in attribute '{}'", *name);
        const std::string_view value(
            reinterpret_cast<const char*>(bytes.data() + size + sizeof(uint32_t)), *length);
        if (*name == "type" && value.substr(0, value.find('\0')) != "scanlineimage")
            return error("type '{}' is not supported, scanlineimage is", value);
        at = size + sizeof(uint32_t) + *length;
    }
}

/// Rows that are compressed together; 0 where the compression is not supported.
int64_t rowsOfBlock(int compression) {
    switch (compression) {
        case TINYEXR_COMPRESSIONTYPE_NONE:
        case TINYEXR_COMPRESSIONTYPE_RLE:
        case TINYEXR_COMPRESSIONTYPE_ZIPS:
            return 1;
        case TINYEXR_COMPRESSIONTYPE_ZIP:
            return 16;
        case TINYEXR_COMPRESSIONTYPE_PIZ:
            return 32;
        default:
            return 0;
    }
}

Result<void> checkChannels(const EXRHeader& header) {
    for (const EXRChannelInfo& c : std::span(header.channels, header.num_channels)) {
        if (c.pixel_type < TINYEXR_PIXELTYPE_UINT || c.pixel_type > TINYEXR_PIXELTYPE_FLOAT)
            return error("channel {} has samples of unknown kind {}", c.name, c.pixel_type);
        if (c.x_sampling != 1 || c.y_sampling != 1)
            return error("channel {} is subsampled, which is not supported", c.name);
    }
    return {};
}

/// Where in the file each block of rows lies is written behind the header. Rows that no block holds
/// would be left as memory was.
Result<void> checkBlocks(std::span<const uint8_t> bytes, const EXRHeader& header, int64_t rows,
                         int64_t blockRows) {
    const uint64_t table = kStart + header.header_len;
    for (int64_t row = 0; row < rows; row += blockRows) {
        const auto block =
            numberAt<uint64_t>(bytes, table + static_cast<uint64_t>(row / blockRows) * 8);
        if (!block) return error("cut off in the table of rows");
        const auto first = numberAt<int32_t>(bytes, *block);
        const auto length = numberAt<uint32_t>(bytes, *block + 4);
        if (*block == 0 || !first || !length || bytes.size() - *block - 8 < *length)
            return error("cut off at row {} of {}", row, rows);
        if (*length == 0 || int64_t{*first} != header.data_window.min_y + row)
            return error("row {} of {} is not where the file says", row, rows);
    }
    return {};
}

}  // namespace

Result<void> checkExrKind(std::span<const uint8_t> bytes) {
    EXRVersion version;
    if (bytes.size() < kStart) return error("is no EXR file, or was cut off in its first bytes");
    if (ParseEXRVersionFromMemory(&version, bytes.data(), bytes.size()) != TINYEXR_SUCCESS)
        return error("is no EXR file of version 2");
    if (version.multipart != 0) return error("several parts are not supported");
    if (version.non_image != 0) return error("deep data is not supported");
    if (version.tiled != 0) return error("tiles are not supported, scan lines are");
    return checkTypeAttribute(bytes);
}

Result<void> checkExrLayout(std::span<const uint8_t> bytes, const EXRHeader& header) {
    const auto& window = header.data_window;
    const int64_t width = int64_t{window.max_x} - window.min_x + 1;
    const int64_t height = int64_t{window.max_y} - window.min_y + 1;
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide ||
        width * height > kMaxPixels)
        return error("a picture of {}x{} pixels cannot be read", width, height);
    TRY_VOID(checkChannels(header));
    const int64_t blockRows = rowsOfBlock(header.compression_type);
    if (blockRows == 0)
        return error("compression {} is not supported; none, RLE, ZIPS, ZIP and PIZ are",
                     header.compression_type);
    return checkBlocks(bytes, header, height, blockRows);
}

}  // namespace lampyris::core
