#include <tinyexr.h>

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "core/exr_check.h"
#include "core/file.h"
#include "core/image_io.h"

namespace lampyris::core {
namespace {

using Planes = std::array<const float*, 3>;

struct HeaderCloser {
    void operator()(EXRHeader* header) const { FreeEXRHeader(header); }
};
struct ImageCloser {
    void operator()(EXRImage* image) const { FreeEXRImage(image); }
};

Error failure(const char* message) {
    Error told = error("{}", message != nullptr ? message : "unreadable");
    if (message != nullptr) FreeEXRErrorMessage(message);
    while (!told.message.empty() && told.message.back() == '\n') told.message.pop_back();
    return told;
}

Result<void> parseHeader(std::span<const uint8_t> bytes, EXRHeader& header) {
    TRY_VOID(checkExrKind(bytes));
    EXRVersion version;
    ParseEXRVersionFromMemory(&version, bytes.data(), bytes.size());
    const char* message = nullptr;
    if (ParseEXRHeaderFromMemory(&header, &version, bytes.data(), bytes.size(), &message) !=
        TINYEXR_SUCCESS)
        return failure(message);
    TRY_VOID(checkExrLayout(bytes, header));
    // Files with decreasing rows have the same table of rows, but tinyexr turns them upside down;
    // and their number follows from the height.
    header.line_order = 0;
    header.chunk_count = 0;
    for (int c = 0; c < header.num_channels; ++c)
        if (header.pixel_types[c] == TINYEXR_PIXELTYPE_HALF)
            header.requested_pixel_types[c] = TINYEXR_PIXELTYPE_FLOAT;
    return {};
}

/// R, G and B by name, or a grey picture's Y three times.
Result<std::array<size_t, 3>> findChannels(const EXRHeader& header) {
    const std::span channels(header.channels, static_cast<size_t>(header.num_channels));
    const auto find = [&](std::string_view name) {
        size_t c = 0;
        while (c < channels.size() && channels[c].name != name) ++c;
        return c;
    };
    const bool grey = find("R") == channels.size() && find("Y") < channels.size();
    std::array<size_t, 3> found{};
    for (size_t c = 0; c < 3; ++c) {
        const std::string_view name = grey ? "Y" : std::array{"R", "G", "B"}[c];
        found[c] = find(name);
        if (found[c] == channels.size())
            return error("has no channel {} (neither R, G, B nor Y)", name);
        if (channels[found[c]].pixel_type == TINYEXR_PIXELTYPE_UINT)
            return error("channel {} holds integers, not light", name);
    }
    if (grey && (find("RY") < channels.size() || find("BY") < channels.size()))
        return error("colours as Y, RY and BY are not supported, R, G and B are");
    return found;
}

Image interleave(const Planes& planes, int width, int height) {
    Image image(static_cast<uint32_t>(width), static_cast<uint32_t>(height), 3);
    for (size_t p = 0; p < image.values.size() / 3; ++p)
        for (size_t c = 0; c < 3; ++c) image.values[p * 3 + c] = planes[c][p];
    return image;
}

Result<Image> decode(std::span<const uint8_t> bytes) {
    EXRHeader header;
    InitEXRHeader(&header);
    const std::unique_ptr<EXRHeader, HeaderCloser> ownedHeader{&header};
    TRY_VOID(parseHeader(bytes, header));
    TRY(const auto channels, findChannels(header));
    EXRImage exr;
    InitEXRImage(&exr);
    // On failure tinyexr frees as many planes as are told here, and itself tells it too late.
    exr.num_channels = header.num_channels;
    const char* message = nullptr;
    if (LoadEXRImageFromMemory(&exr, &header, bytes.data(), bytes.size(), &message) !=
        TINYEXR_SUCCESS)
        return failure(message);
    const std::unique_ptr<EXRImage, ImageCloser> ownedImage{&exr};
    Planes planes{};
    for (size_t c = 0; c < 3; ++c)
        planes[c] = reinterpret_cast<const float*>(exr.images[channels[c]]);
    return interleave(planes, exr.width, exr.height);
}

}  // namespace

Result<Image> readExr(const std::filesystem::path& path) {
    TRY(const auto bytes, readFile(path));
    auto image = decode(bytes);
    if (!image.ok()) return error("{}: EXR: {}", path.string(), image.error().message);
    return image;
}

}  // namespace lampyris::core
