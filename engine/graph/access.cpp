#include "graph/access.h"

#include <array>
#include <cstddef>

namespace lampyris::graph {

bool writes(Access access) {
    switch (access) {
        case Access::StorageWrite:
        case Access::StorageUpdate:
        case Access::ColorWrite:
        case Access::DepthWrite:
        case Access::TransferWrite:
            return true;
        default:
            return false;
    }
}

bool reads(Access access) {
    switch (access) {
        case Access::None:
        case Access::StorageWrite:
        case Access::ColorWrite:
        case Access::TransferWrite:
            return false;
        default:
            return true;
    }
}

const char* name(Access access) {
    static constexpr std::array<const char*, 17> kNames{
        "None",          "Uniform",   "TexelRead",    "StorageRead",  "StorageWrite",
        "StorageUpdate", "Sampled",   "ColorWrite",   "DepthWrite",   "DepthRead",
        "VertexRead",    "IndexRead", "IndirectRead", "TransferRead", "TransferWrite",
        "HostRead",      "Present"};
    return kNames[static_cast<size_t>(access)];
}

const char* name(NodeKind kind) {
    static constexpr std::array<const char*, 4> kNames{"compute", "raster", "transfer", "host"};
    return kNames[static_cast<size_t>(kind)];
}

}  // namespace lampyris::graph
