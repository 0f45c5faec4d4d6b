/// \file How a node touches a resource. Barriers follow from pairs of these.
#pragma once

#include <cstdint>

namespace lampyris::graph {

enum class Access : uint8_t {
    None,           ///< contents undefined or unknown to the graph
    Uniform,        ///< uniform buffer
    TexelRead,      ///< uniform texel buffer
    StorageRead,    ///< storage buffer or image, read
    StorageWrite,   ///< storage buffer, image or texel buffer, written
    StorageUpdate,  ///< the same, read and written
    Sampled,        ///< combined image sampler
    ColorWrite,     ///< colour attachment
    DepthWrite,     ///< depth attachment, tested and written
    DepthRead,      ///< depth attachment, tested only
    VertexRead,
    IndexRead,
    IndirectRead,
    TransferRead,
    TransferWrite,
    HostRead,
    Present,
};

[[nodiscard]] bool writes(Access access);
[[nodiscard]] bool reads(Access access);
[[nodiscard]] const char* name(Access access);

/// Where in the pipeline a node's shaders run.
enum class NodeKind : uint8_t { Compute, Raster, Transfer, Host };

[[nodiscard]] const char* name(NodeKind kind);

}  // namespace lampyris::graph
