#include "assets/gltf_source.h"

namespace lampyris::assets {

std::span<const uint8_t> GltfSource::view(int index) const {
    const tinygltf::BufferView& view = document.bufferViews[static_cast<size_t>(index)];
    return buffers[static_cast<size_t>(view.buffer)].bytes.subspan(view.byteOffset,
                                                                   view.byteLength);
}

}  // namespace lampyris::assets
