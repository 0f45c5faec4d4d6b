#include "view/screenshot.h"

#include <fmt/format.h>

#include <cmath>

#include "core/image_io.h"

namespace lampyris::sandbox::view {

std::filesystem::path freePath(const std::filesystem::path& wanted) {
    std::filesystem::path path = wanted;
    std::error_code code;
    for (int i = 2; std::filesystem::exists(path, code); ++i)
        path = wanted.parent_path() /
               fmt::format("{}_{}{}", wanted.stem().string(), i, wanted.extension().string());
    return path;
}

core::Result<void> writeScreenshot(const std::filesystem::path& path, const core::Image& image) {
    core::DisplayImage picture{image.width, image.height, {}};
    picture.values.reserve(size_t{image.width} * image.height * 3);
    for (size_t i = 0; i < image.values.size(); ++i)
        if (i % 4 != 3)
            picture.values.push_back(static_cast<uint8_t>(std::lround(255.0f * image.values[i])));
    return core::writePng(path, picture);
}

}  // namespace lampyris::sandbox::view
