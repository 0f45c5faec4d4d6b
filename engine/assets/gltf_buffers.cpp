#include "assets/gltf_buffers.h"

#include "assets/gltf_uri.h"

namespace lampyris::assets {
namespace {

core::Result<GltfBuffer> readBuffer(const Place& place, bool isFirst,
                                    const GltfContainer& container,
                                    const std::optional<std::filesystem::path>& folder,
                                    GltfContext& context) {
    const uint64_t byteLength = place.whole("byteLength");
    const std::string uri = place.text("uri", "");
    if (!place.ok()) return GltfBuffer{};
    GltfBuffer buffer;
    if (place.has("uri")) {
        auto bytes = readUri(uri, folder);
        if (!bytes) return context.error(place.pointer() + "/uri", "{}", bytes.error().message);
        buffer.owned = std::move(bytes).value();
        buffer.bytes = buffer.owned;
        TRY_VOID(context.takeBytes(place.pointer(), buffer.owned.size()));
    } else if (isFirst && container.binary) {
        buffer.bytes = *container.binary;
    } else {
        return context.error(place.pointer(), "has no uri, and there is no GLB chunk for it");
    }
    if (byteLength == 0) return context.error(place.pointer(), "has a byteLength of 0");
    if (byteLength > buffer.bytes.size())
        return context.error(place.pointer(), "has a byteLength of {}, and its data {} bytes",
                             byteLength, buffer.bytes.size());
    buffer.bytes = buffer.bytes.first(byteLength);
    return buffer;
}

}  // namespace

core::Result<std::vector<GltfBuffer>> readBuffers(
    const GltfContainer& container, const std::optional<std::filesystem::path>& folder,
    GltfContext& context) {
    Complaint complaint;
    const Place root(container.json, complaint);
    std::vector<GltfBuffer> buffers;
    const size_t count = root.length("buffers");
    for (size_t i = 0; i < count && root.ok(); ++i) {
        TRY(GltfBuffer buffer,
            readBuffer(root.element("buffers", i), i == 0, container, folder, context));
        buffers.push_back(std::move(buffer));
    }
    if (!root.ok()) return context.error(complaint.place, "{}", complaint.message);
    return buffers;
}

}  // namespace lampyris::assets
