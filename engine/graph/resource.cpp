#include "graph/resource.h"

#include <array>
#include <cstddef>

namespace lampyris::graph {

uint32_t bytesPerTexel(Format format) {
    switch (format) {
        case Format::Undefined:
            return 0;
        case Format::R32Uint:
        case Format::R32Float:
        case Format::RGBA8Unorm:
        case Format::RGBA8Srgb:
        case Format::BGRA8Unorm:
        case Format::D32Float:
            return 4;
        case Format::RG32Float:
        case Format::RGBA16Float:
            return 8;
        case Format::RGBA32Float:
        case Format::RGBA32Uint:
            return 16;
    }
    return 0;
}

uint32_t channels(Format format) {
    switch (format) {
        case Format::Undefined:
            return 0;
        case Format::R32Uint:
        case Format::R32Float:
        case Format::D32Float:
            return 1;
        case Format::RG32Float:
            return 2;
        case Format::RGBA8Unorm:
        case Format::RGBA8Srgb:
        case Format::BGRA8Unorm:
        case Format::RGBA16Float:
        case Format::RGBA32Float:
        case Format::RGBA32Uint:
            return 4;
    }
    return 0;
}

const char* name(Format format) {
    static constexpr std::array<const char*, 11> kNames{
        "Undefined",  "R32Uint",     "R32Float",    "RG32Float",  "RGBA8Unorm", "RGBA8Srgb",
        "BGRA8Unorm", "RGBA16Float", "RGBA32Float", "RGBA32Uint", "D32Float"};
    return kNames[static_cast<size_t>(format)];
}

}  // namespace lampyris::graph
