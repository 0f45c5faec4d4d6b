/// \file What a screen of Xvfb shows, from the file that it keeps under `-fbdir`.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/file.h"

namespace lampyris::test {

/// A screen of 24 bits a pixel, as XWD has it.
class ScreenFile {
 public:
    /// \param folder  that Xvfb was given; its only screen is read
    explicit ScreenFile(const std::filesystem::path& folder) {
        const auto read = core::readFile(folder / "Xvfb_screen0");
        if (!read.ok()) return;
        bytes_ = read.value();
        const uint32_t header = word(0);
        const uint32_t colours = word(19);
        width_ = word(4);
        height_ = word(5);
        lineBytes_ = word(12);
        first_ = header + colours * kColourBytes;
    }

    [[nodiscard]] uint32_t width() const { return width_; }
    [[nodiscard]] uint32_t height() const { return height_; }
    /// Red, green, blue.
    [[nodiscard]] std::array<int, 3> pixel(uint32_t x, uint32_t y) const {
        const uint8_t* at = bytes_.data() + first_ + size_t{y} * lineBytes_ + size_t{x} * 4;
        return {at[2], at[1], at[0]};
    }
    /// Pixels of [x0, x1) by [y0, y1) that differ from another screen of the same size.
    [[nodiscard]] size_t differing(const ScreenFile& other, uint32_t x0, uint32_t y0, uint32_t x1,
                                   uint32_t y1) const {
        size_t count = 0;
        for (uint32_t y = y0; y < y1; ++y)
            for (uint32_t x = x0; x < x1; ++x) count += pixel(x, y) != other.pixel(x, y) ? 1 : 0;
        return count;
    }

 private:
    static constexpr size_t kColourBytes = 12;
    [[nodiscard]] uint32_t word(size_t index) const {
        const uint8_t* at = bytes_.data() + 4 * index;
        return uint32_t{at[0]} << 24 | uint32_t{at[1]} << 16 | uint32_t{at[2]} << 8 | at[3];
    }
    std::vector<uint8_t> bytes_;
    uint32_t width_ = 0, height_ = 0, lineBytes_ = 0;
    size_t first_ = 0;
};

}  // namespace lampyris::test
