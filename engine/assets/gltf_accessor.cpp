#include "assets/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace lampyris::assets {
namespace {

/// Where elements lie and how.
struct Layout {
    int componentType = 0;
    bool normalized = false;
    size_t components = 0;
    size_t stride = 0;
};

std::string placeOf(int accessor) {
    return fmt::format("/accessors/{}", accessor);
}

size_t componentBytes(int componentType) {
    return static_cast<size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(componentType)));
}

template <typename Stored, typename Out>
Out convert(Stored stored, bool normalized) {
    if constexpr (std::is_floating_point_v<Out> && std::is_integral_v<Stored>) {
        if (normalized)  // glTF 2.0, section 3.6.2.2
            return std::max(
                static_cast<float>(stored) / static_cast<float>(std::numeric_limits<Stored>::max()),
                -1.0f);
    }
    return static_cast<Out>(stored);
}

template <typename Stored, typename Out>
void copyElement(const uint8_t* from, const Layout& layout, Out* to) {
    for (size_t c = 0; c < layout.components; ++c) {
        Stored stored;
        std::memcpy(&stored, from + c * sizeof(Stored), sizeof(Stored));
        to[c] = convert<Stored, Out>(stored, layout.normalized);
    }
}

template <typename Out>
using CopyElement = void (*)(const uint8_t*, const Layout&, Out*);

template <typename Out>
CopyElement<Out> copierFor(int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return copyElement<uint8_t, Out>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return copyElement<uint16_t, Out>;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return copyElement<uint32_t, Out>;
        default:
            break;
    }
    if constexpr (std::is_floating_point_v<Out>) {
        switch (componentType) {
            case TINYGLTF_COMPONENT_TYPE_BYTE:
                return copyElement<int8_t, Out>;
            case TINYGLTF_COMPONENT_TYPE_SHORT:
                return copyElement<int16_t, Out>;
            case TINYGLTF_COMPONENT_TYPE_FLOAT:
                return copyElement<float, Out>;
            default:
                break;
        }
    }
    return nullptr;
}

template <typename Out>
core::Result<void> replaceSparse(GltfSource& source, int index, const Layout& layout,
                                 ElementRange range, std::vector<Out>& out) {
    const tinygltf::Accessor& accessor = source.document.accessors[static_cast<size_t>(index)];
    const auto& sparse = accessor.sparse;
    const uint8_t* indices =
        source.view(sparse.indices.bufferView).data() + sparse.indices.byteOffset;
    const uint8_t* values = source.view(sparse.values.bufferView).data() + sparse.values.byteOffset;
    const Layout indexLayout{sparse.indices.componentType, false, 1, 0};
    const size_t indexBytes = componentBytes(indexLayout.componentType);
    const size_t valueBytes = componentBytes(layout.componentType) * layout.components;
    const auto copyIndex = copierFor<uint32_t>(indexLayout.componentType);
    const auto copyValue = copierFor<Out>(layout.componentType);
    TRY_VOID(source.context.takeBytes(  // work, not memory: many ranges of one accessor
        placeOf(index), uint64_t{sizeof(uint32_t)} * static_cast<uint32_t>(sparse.count)));
    int64_t previous = -1;
    for (size_t i = 0; i < static_cast<size_t>(sparse.count); ++i) {
        uint32_t element = 0;
        copyIndex(indices + i * indexBytes, indexLayout, &element);
        if (element >= accessor.count || int64_t{element} <= previous)
            return source.context.error(placeOf(index) + "/sparse",
                                        "index {} is {}, after {}, and there are {} elements", i,
                                        element, previous, accessor.count);
        previous = element;
        if (element < range.first || element - range.first >= range.count) continue;
        copyValue(values + i * valueBytes, layout,
                  out.data() + (element - range.first) * layout.components);
    }
    return {};
}

template <typename Out>
core::Result<std::vector<Out>> read(GltfSource& source, int index, size_t components,
                                    ElementRange range) {
    const tinygltf::Accessor& accessor = source.document.accessors[static_cast<size_t>(index)];
    const CopyElement<Out> copy = copierFor<Out>(accessor.componentType);
    if (componentCount(accessor) != components || copy == nullptr)
        return source.context.error(
            placeOf(index), "has {} components of componentType {}, and {} {} are needed",
            componentCount(accessor), accessor.componentType, components,
            std::is_floating_point_v<Out> ? "numbers" : "unsigned integers");
    TRY_VOID(
        source.context.takeBytes(placeOf(index), uint64_t{range.count} * components * sizeof(Out)));

    Layout layout{accessor.componentType, accessor.normalized, components,
                  componentBytes(accessor.componentType) * components};
    std::vector<Out> out(range.count * components);
    if (accessor.bufferView >= 0) {
        const size_t stride =
            source.document.bufferViews[static_cast<size_t>(accessor.bufferView)].byteStride;
        if (stride != 0) layout.stride = stride;
        const uint8_t* data = source.view(accessor.bufferView).data() + accessor.byteOffset;
        for (size_t i = 0; i < range.count; ++i)
            copy(data + (range.first + i) * layout.stride, layout, out.data() + i * components);
    }
    if (accessor.sparse.isSparse) TRY_VOID(replaceSparse(source, index, layout, range, out));
    return out;
}

}  // namespace

size_t componentCount(const tinygltf::Accessor& accessor) {
    return static_cast<size_t>(
        tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type)));
}

ElementRange allOf(const GltfSource& source, int accessor) {
    return {0, source.document.accessors[static_cast<size_t>(accessor)].count};
}

core::Result<std::vector<float>> readFloats(GltfSource& source, int accessor, size_t components,
                                            ElementRange range) {
    return read<float>(source, accessor, components, range);
}

core::Result<std::vector<uint32_t>> readUnsigned(GltfSource& source, int accessor,
                                                 size_t components, ElementRange range) {
    return read<uint32_t>(source, accessor, components, range);
}

}  // namespace lampyris::assets
