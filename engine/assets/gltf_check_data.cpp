#include <algorithm>
#include <limits>

#include "assets/gltf_check.h"
#include "assets/gltf_uri.h"

namespace lampyris::assets {
namespace {

constexpr uint64_t kUnsignedByte = 5121;
constexpr uint64_t kUnsignedShort = 5123;
constexpr uint64_t kUnsignedInt = 5125;
constexpr uint64_t kFloat = 5126;
constexpr uint64_t kLargestInt = std::numeric_limits<int32_t>::max();  // tinygltf's counts are ints

size_t componentBytes(uint64_t componentType) {
    switch (componentType) {
        case 5120:
        case kUnsignedByte:
            return 1;
        case 5122:
        case kUnsignedShort:
            return 2;
        case kUnsignedInt:
        case kFloat:
            return 4;
        default:
            return 0;
    }
}

/// What the accessors need to know of a view.
struct View {
    uint64_t byteLength = 0;
    uint64_t byteStride = 0;  ///< 0: packed
};

View checkView(const Place& place, const std::vector<GltfBuffer>& buffers) {
    const auto buffer = place.requiredIndex("buffer", buffers.size());
    const uint64_t offset = place.whole("byteOffset", 0);
    const View view{place.whole("byteLength"), place.whole("byteStride", 0)};
    const uint64_t bytes = buffer ? buffers[*buffer].bytes.size() : 0;
    if (place.ok() && view.byteLength == 0) place.complain("has a byteLength of 0");
    if (place.ok() && offset + view.byteLength > bytes)
        place.complain("reaches byte {} of a buffer of {}", offset + view.byteLength, bytes);
    if (place.has("byteStride") &&
        (view.byteStride < 4 || view.byteStride > 252 || view.byteStride % 4 != 0))
        place.complain("has a byteStride of {}, which is no multiple of 4 from 4 to 252",
                       view.byteStride);
    return view;
}

/// `count` elements of `bytes` each, `stride` apart, from byteOffset on: within the view.
void checkReach(const Place& place, const View& view, uint64_t count, uint64_t bytes,
                uint64_t stride) {
    const uint64_t offset = place.whole("byteOffset", 0);
    if (!place.ok()) return;
    const uint64_t end = offset + (count - 1) * stride + bytes;
    if (end > view.byteLength)
        place.complain("reaches byte {} of a view of {}", end, view.byteLength);
}

void checkSparse(const Place& place, const std::vector<View>& views, uint64_t accessorCount,
                 size_t bytes) {
    const uint64_t count = place.whole("count");
    if (!place.ok()) return;
    if (count == 0 || count > accessorCount)
        return place.complain("replaces {} elements of {}", count, accessorCount);

    const Place indices = place.object("indices");
    const auto indexView = indices.requiredIndex("bufferView", views.size());
    const uint64_t type = indices.whole("componentType");
    if (!place.ok()) return;
    if (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt)
        return indices.complain("has the componentType {}, which is no unsigned integer", type);
    const size_t indexBytes = componentBytes(type);
    checkReach(indices, views[*indexView], count, indexBytes, indexBytes);

    const Place values = place.object("values");
    const auto valueView = values.requiredIndex("bufferView", views.size());
    if (place.ok()) checkReach(values, views[*valueView], count, bytes, bytes);
    if (std::max(indices.whole("byteOffset", 0), values.whole("byteOffset", 0)) > kLargestInt)
        place.complain("has a byteOffset above 2^31");
}

void checkAccessor(const Place& place, const std::vector<View>& views) {
    const uint64_t count = place.whole("count");
    const uint64_t componentType = place.whole("componentType");
    const std::string type = place.text("type");
    if (place.has("normalized") && !place.json().at("normalized").is_boolean())
        place.complain("normalized must be true or false");
    if (!place.ok()) return;
    const size_t bytes = elementBytes(type, componentType);
    if (bytes == 0)
        return place.complain("has elements of {} of componentType {}", type, componentType);
    if (count == 0 || count > kLargestInt) return place.complain("has a count of {}", count);

    const auto view = place.index("bufferView", views.size());
    if (!place.ok()) return;
    if (view) {
        const uint64_t stride = views[*view].byteStride;
        if (stride != 0 && stride < bytes)
            return place.complain("has elements of {} bytes, {} apart", bytes, stride);
        checkReach(place, views[*view], count, bytes, stride == 0 ? bytes : stride);
    } else if (count > kMostImpliedZeros) {
        return place.complain("has a count of {} without a bufferView", count);
    }
    if (place.has("sparse")) checkSparse(place.object("sparse"), views, count, bytes);
}

void checkImage(const Place& place, size_t viewCount) {
    if (place.has("uri") == place.has("bufferView"))
        return place.complain("must have one of uri and bufferView");
    (void)place.text("mimeType", "");
    (void)place.index("bufferView", viewCount);
    const std::string uri = place.text("uri", "");
    if (!place.ok() || !place.has("uri")) return;
    const auto parsed = parseUri(uri);
    if (!parsed) place.complain("{}", parsed.error().message);
}

}  // namespace

size_t elementBytes(const std::string& type, uint64_t componentType) {
    const size_t bytes = componentBytes(componentType);
    const auto padded = [](size_t columnBytes) { return (columnBytes + 3) / 4 * 4; };
    if (type == "SCALAR") return bytes;
    if (type == "VEC2") return 2 * bytes;
    if (type == "VEC3") return 3 * bytes;
    if (type == "VEC4") return 4 * bytes;
    if (type == "MAT2") return 2 * padded(2 * bytes);
    if (type == "MAT3") return 3 * padded(3 * bytes);
    if (type == "MAT4") return 4 * padded(4 * bytes);
    return 0;
}

void checkData(const Place& root, const std::vector<GltfBuffer>& buffers) {
    std::vector<View> views;
    root.each("bufferViews",
              [&](const Place& place) { views.push_back(checkView(place, buffers)); });
    if (!root.ok()) return;
    root.each("accessors", [&](const Place& place) { checkAccessor(place, views); });
    root.each("images", [&](const Place& place) { checkImage(place, views.size()); });
}

}  // namespace lampyris::assets
