/// \file The images of a document, decoded when they are asked for. Private to assets.
#pragma once

#include <optional>
#include <vector>

#include "assets/gltf_source.h"

namespace lampyris::assets {

/// Puts decoded images into Model::images, each once.
class ImageReader {
 public:
    ImageReader(GltfSource& source, Model& model);

    /// The image's index in the model; −1, with a warning, where its bytes are no PNG or JPEG that
    /// can be decoded. Errors: a missing file, more texels a side than the limit, no memory for it.
    core::Result<int32_t> find(size_t image);

 private:
    core::Result<int32_t> decode(size_t image);
    core::Result<std::vector<uint8_t>> fileBytes(const Place& place);

    GltfSource& source_;
    Model& model_;
    std::vector<std::optional<int32_t>> known_;
};

}  // namespace lampyris::assets
