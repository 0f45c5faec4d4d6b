/// \file Elements of a checked accessor: any component type, normalised or not, interleaved,
/// sparse. Private to assets.
#pragma once

#include <array>
#include <vector>

#include "assets/gltf_source.h"

namespace lampyris::assets {

/// Elements first … first + count − 1 of an accessor.
struct ElementRange {
    size_t first = 0;
    size_t count = 0;
};

/// How many numbers an element of the accessor has.
size_t componentCount(const tinygltf::Accessor& accessor);

/// The elements as floats, `components` each, appended end to end. Integers are normalised where
/// the accessor says so. Errors: another number of components, sparse indices out of order or
/// range.
core::Result<std::vector<float>> readFloats(GltfSource& source, int accessor, size_t components,
                                            ElementRange range);

/// The same for unsigned integers: errors also for other component types.
core::Result<std::vector<uint32_t>> readUnsigned(GltfSource& source, int accessor,
                                                 size_t components, ElementRange range);

/// The whole of an accessor.
ElementRange allOf(const GltfSource& source, int accessor);

/// Floats as vectors of Vector::length() components.
template <typename Vector>
core::Result<std::vector<Vector>> readVectors(GltfSource& source, int accessor,
                                              ElementRange range) {
    constexpr size_t kComponents = sizeof(Vector) / sizeof(float);
    TRY(const std::vector<float> floats, readFloats(source, accessor, kComponents, range));
    std::vector<Vector> vectors(range.count);
    for (size_t i = 0; i < range.count; ++i)
        for (size_t c = 0; c < kComponents; ++c) (&vectors[i][0])[c] = floats[i * kComponents + c];
    return vectors;
}

}  // namespace lampyris::assets
