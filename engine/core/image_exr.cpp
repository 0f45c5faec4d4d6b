#include <tinyexr.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <span>

#include "core/check.h"
#include "core/file.h"
#include "core/image_io.h"

namespace lampyris::core {
namespace {

Error exrError(const std::filesystem::path& path, const char* message) {
    Error failure =
        error("{}: EXR: {}", path.string(), message != nullptr ? message : "unreadable");
    if (message != nullptr) FreeEXRErrorMessage(message);
    return failure;
}

}  // namespace

Result<void> writeExr(const std::filesystem::path& path, const Image& image) {
    CHECK(image.channels != 2u);
    const size_t pixels = size_t{image.width} * image.height;
    // EXR readers expect channels in alphabetical order: B, G, R.
    std::array<std::vector<float>, 3> planes;
    for (size_t c = 0; c < 3; ++c) {
        planes[c].resize(pixels);
        const size_t source = image.channels == 1 ? 0 : 2 - c;
        for (size_t p = 0; p < pixels; ++p)
            planes[c][p] = image.values[p * image.channels + source];
    }
    std::array<unsigned char*, 3> pointers{};
    for (size_t c = 0; c < 3; ++c) pointers[c] = reinterpret_cast<unsigned char*>(planes[c].data());

    std::array<EXRChannelInfo, 3> channels{};
    channels[0].name[0] = 'B';
    channels[1].name[0] = 'G';
    channels[2].name[0] = 'R';
    std::array<int, 3> types{TINYEXR_PIXELTYPE_FLOAT, TINYEXR_PIXELTYPE_FLOAT,
                             TINYEXR_PIXELTYPE_FLOAT};

    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = 3;
    header.channels = channels.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    EXRImage exr;
    InitEXRImage(&exr);
    exr.num_channels = 3;
    exr.images = pointers.data();
    exr.width = static_cast<int>(image.width);
    exr.height = static_cast<int>(image.height);

    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const size_t bytes = SaveEXRImageToMemory(&exr, &header, &memory, &message);
    if (bytes == 0) return exrError(path, message);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owned{memory, &std::free};
    return writeFile(path, std::span<const uint8_t>{memory, bytes});
}

}  // namespace lampyris::core
