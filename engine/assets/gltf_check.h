/// \file Every range and reference of a document, checked before anything is decoded. Private to
/// assets.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "assets/gltf_buffers.h"

namespace lampyris::assets {

/// Whether files may require the extension: it is read.
bool understands(std::string_view extension);

/// Checks what kind of file this is. Errors: no asset, a version other than 2, a required extension
/// that is not understood.
core::Result<void> checkHeader(const Json& json, const GltfContext& context);

/// Checks the whole document against the bytes its buffers really have. Errors name the JSON place:
/// a range outside its data, an index outside its table, a value of the wrong type, a node with two
/// parents or in a cycle.
core::Result<void> checkDocument(const Json& json, const std::vector<GltfBuffer>& buffers,
                                 const GltfContext& context);

/// How many elements each table of the document has.
struct TableSizes {
    size_t accessors, animations, bufferViews, cameras, images, lights, materials, meshes, nodes,
        samplers, scenes, skins, textures;
};
TableSizes tableSizes(const Place& root);

// The parts of checkDocument; each files its complaints at the place that is wrong.
void checkData(const Place& root, const std::vector<GltfBuffer>& buffers);  ///< views to images
void checkReferences(const Place& root,
                     const TableSizes& sizes);                ///< materials, meshes, animations …
void checkNodes(const Place& root, const TableSizes& sizes);  ///< nodes, scenes, skins, cycles

/// KHR_lights_punctual of the document.
Place lightsExtension(const Place& root);

/// Bytes of an element of an accessor's type and componentType, columns padded; 0 where either is
/// unknown.
size_t elementBytes(const std::string& type, uint64_t componentType);

/// [chosen] elements of an accessor with neither view nor values: as many as a large sparse morph
/// target has, and far fewer than would hurt.
constexpr uint64_t kMostImpliedZeros = uint64_t{1} << 24;

}  // namespace lampyris::assets
