/// \file EXR files as other programs write them: half floats, other channels, other compressions.
#pragma once

#include <tinyexr.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace lampyris::core {

struct ExrChannel {
    std::string name;
    float first = 0.0f;  ///< pixel p holds first + p / 8
    int kind = TINYEXR_PIXELTYPE_FLOAT;
};

constexpr int kExrWidth = 9;
constexpr int kExrHeight = 35;  // a block of rows and a part of one, in every compression

inline float exrValue(float first, uint32_t x, uint32_t y) {
    return first + static_cast<float>(y * kExrWidth + x) / 8.0f;
}

/// A file of 9x35 pixels. Channels must come in alphabetical order.
inline std::vector<uint8_t> exrFile(const std::vector<ExrChannel>& channels,
                                    int compression = TINYEXR_COMPRESSIONTYPE_ZIP) {
    const size_t count = channels.size();
    std::vector<std::vector<float>> planes(count);
    std::vector<unsigned char*> pointers;
    std::vector<EXRChannelInfo> infos(count);
    std::vector<int> given(count, TINYEXR_PIXELTYPE_FLOAT);
    std::vector<int> kinds;
    for (size_t c = 0; c < count; ++c) {
        for (uint32_t p = 0; p < kExrWidth * kExrHeight; ++p)
            planes[c].push_back(exrValue(channels[c].first, p, 0));
        pointers.push_back(reinterpret_cast<unsigned char*>(planes[c].data()));
        std::copy_n(channels[c].name.c_str(), channels[c].name.size() + 1, infos[c].name);
        kinds.push_back(channels[c].kind);
        if (channels[c].kind == TINYEXR_PIXELTYPE_UINT) given[c] = TINYEXR_PIXELTYPE_UINT;
    }
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = static_cast<int>(count);
    header.channels = infos.data();
    header.pixel_types = given.data();
    header.requested_pixel_types = kinds.data();
    header.compression_type = compression;
    EXRImage image;
    InitEXRImage(&image);
    image.num_channels = header.num_channels;
    image.images = pointers.data();
    image.width = kExrWidth;
    image.height = kExrHeight;
    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
    std::vector<uint8_t> bytes(memory, memory + size);
    std::free(memory);
    return bytes;
}

inline std::vector<uint8_t> rgbExrFile(int kind = TINYEXR_PIXELTYPE_FLOAT,
                                       int compression = TINYEXR_COMPRESSIONTYPE_ZIP) {
    return exrFile({{"B", 30.0f, kind}, {"G", 20.0f, kind}, {"R", 10.0f, kind}}, compression);
}

/// Where the value of a header's attribute begins, behind name, type and length.
inline size_t exrAttribute(const std::vector<uint8_t>& bytes, const std::string& name,
                           const std::string& type) {
    std::string key = name + '\0' + type + '\0';
    const auto found = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
    return static_cast<size_t>(found - bytes.begin()) + key.size() + sizeof(uint32_t);
}

}  // namespace lampyris::core
