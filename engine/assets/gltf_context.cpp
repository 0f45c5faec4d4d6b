#include "assets/gltf_context.h"

namespace lampyris::assets {
namespace {
constexpr uint32_t kWarningsShown = 20;  // [chosen] a screen
}

GltfContext::~GltfContext() {
    if (warnings_ > kWarningsShown)
        core::logWarning("{}: and {} more warnings", name_, warnings_ - kWarningsShown);
}

core::Result<void> GltfContext::takeBytes(const std::string& place, uint64_t bytes) {
    if (bytes > limits_.decodedBytes - bytesTaken_)
        return error(place, "needs {} bytes more, and the limit for a file is {}", bytes,
                     limits_.decodedBytes);
    bytesTaken_ += bytes;
    return {};
}

std::string GltfContext::line(const std::string& place, const std::string& message) const {
    if (place.empty()) return fmt::format("{}: {}", name_, message);
    return fmt::format("{}: {}: {}", name_, place, message);
}

void GltfContext::logWarning(const std::string& text) {
    if (++warnings_ <= kWarningsShown) core::logWarning("{}", text);
}

}  // namespace lampyris::assets
