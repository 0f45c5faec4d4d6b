#include "assets/gltf_images.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "assets/gltf_uri.h"

namespace lampyris::assets {
namespace {

using Bytes = std::span<const uint8_t>;
constexpr int kRgba = 4;  // 16-bit channels come down to 8 on the way

struct FreePixels {
    void operator()(uint8_t* pixels) const { stbi_image_free(pixels); }
};

/// glTF allows these two kinds; stb's other decoders are kept away from strangers' bytes.
bool isPngOrJpeg(Bytes bytes) {
    constexpr uint8_t kPng[] = {0x89, 'P', 'N', 'G'};
    constexpr uint8_t kJpeg[] = {0xff, 0xd8, 0xff};
    const auto startsWith = [&](Bytes mark) {
        return bytes.size() > mark.size() && std::equal(mark.begin(), mark.end(), bytes.begin());
    };
    return (startsWith(kPng) || startsWith(kJpeg)) &&
           bytes.size() <= static_cast<size_t>(std::numeric_limits<int>::max());
}

}  // namespace

ImageReader::ImageReader(GltfSource& source, Model& model)
    : source_(source), model_(model), known_(source.images.at("images").size()) {}

core::Result<int32_t> ImageReader::find(size_t image) {
    if (!known_[image]) {
        TRY(known_[image], decode(image));
    }
    return *known_[image];
}

core::Result<std::vector<uint8_t>> ImageReader::fileBytes(const Place& place) {
    auto bytes = readUri(place.text("uri", ""), source_.folder);
    if (!bytes) return source_.context.error(place.pointer() + "/uri", "{}", bytes.error().message);
    return bytes;
}

core::Result<int32_t> ImageReader::decode(size_t image) {
    Complaint complaint;
    const Place place = Place(source_.images, complaint).element("images", image);
    std::vector<uint8_t> owned;
    Bytes bytes;
    if (place.has("uri")) {
        TRY(owned, fileBytes(place));
        bytes = owned;
    } else {
        bytes = source_.view(static_cast<int>(place.whole("bufferView")));
    }
    int width = 0;
    int height = 0;
    const auto size = static_cast<int>(bytes.size());
    if (!isPngOrJpeg(bytes) ||
        stbi_info_from_memory(bytes.data(), size, &width, &height, nullptr) == 0) {
        source_.context.warn(place.pointer(), "is no PNG or JPEG; what shows it goes without");
        return -1;
    }
    const uint32_t limit = source_.context.limits().imageSide;
    if (static_cast<uint32_t>(std::max(width, height)) > limit)
        return source_.context.error(place.pointer(), "has {}x{} texels; the limit is {} a side",
                                     width, height, limit);
    const uint64_t decodedBytes =
        uint64_t{4} * static_cast<uint32_t>(width) * static_cast<uint32_t>(height);
    TRY_VOID(source_.context.takeBytes(place.pointer(), decodedBytes));
    const std::unique_ptr<uint8_t, FreePixels> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, nullptr, kRgba));
    if (!pixels) {
        source_.context.warn(place.pointer(), "is broken ({}); what shows it goes without",
                             stbi_failure_reason());
        return -1;
    }
    model_.images.push_back({place.text("name", fmt::format("image {}", image)),
                             static_cast<uint32_t>(width),
                             static_cast<uint32_t>(height),
                             {pixels.get(), pixels.get() + decodedBytes}});
    return static_cast<int32_t>(model_.images.size() - 1);
}

}  // namespace lampyris::assets
