#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <limits>
#include <memory>

#include "core/file.h"
#include "core/image_io.h"
#include "core/png_check.h"

namespace lampyris::core {
namespace {

constexpr size_t kMaxBytes = std::numeric_limits<int>::max();  // stb_image counts in int

}  // namespace

Result<void> writePng(const std::filesystem::path& path, const DisplayImage& image) {
    std::vector<uint8_t> bytes;
    const auto append = [](void* context, void* data, int size) {
        auto& out = *static_cast<std::vector<uint8_t>*>(context);
        const auto* first = static_cast<const uint8_t*>(data);
        out.insert(out.end(), first, first + size);
    };
    const int width = static_cast<int>(image.width);
    if (stbi_write_png_to_func(append, &bytes, width, static_cast<int>(image.height), 3,
                               image.values.data(), width * 3) == 0)
        return error("{}: PNG: cannot encode {}x{}", path.string(), image.width, image.height);
    return writeFile(path, bytes);
}

Result<DisplayImage> readPng(const std::filesystem::path& path) {
    TRY(const auto bytes, readFile(path));
    const auto checked = checkPng(bytes);
    if (!checked.ok()) return error("{}: PNG: {}", path.string(), checked.error().message);
    if (bytes.size() > kMaxBytes) return error("{}: PNG: is over 2 GiB", path.string());
    int width = 0;
    int height = 0;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels{
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height,
                              &channels, 3),
        &stbi_image_free};
    if (!pixels) return error("{}: PNG: {}", path.string(), stbi_failure_reason());
    DisplayImage image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    image.values.assign(pixels.get(), pixels.get() + size_t{image.width} * image.height * 3);
    return image;
}

Result<void> writeImage(const std::filesystem::path& path, const Image& image,
                        const DisplayTransform& transform) {
    if (path.extension() == ".exr") return writeExr(path, image);
    if (path.extension() == ".png") return writePng(path, toDisplay(image, transform));
    return error("{}: the file's name must end in .png or .exr", path.string());
}

}  // namespace lampyris::core
