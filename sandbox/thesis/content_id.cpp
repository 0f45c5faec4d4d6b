#include "thesis/content_id.h"

#include <fmt/format.h>

#include "core/file.h"

namespace lampyris::sandbox::thesis {

std::string idOf(std::span<const uint8_t> bytes) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
    return fmt::format("{:016x}", hash);
}

std::string idOf(const std::string& text) {
    return idOf(std::span{reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

std::string idOf(const core::Image& image) {
    return idOf(std::span{reinterpret_cast<const uint8_t*>(image.values.data()),
                          image.values.size() * sizeof(float)});
}

core::Result<std::string> programId() {
    TRY(const auto bytes, core::readFile("/proc/self/exe"));
    return idOf(bytes);
}

}  // namespace lampyris::sandbox::thesis
