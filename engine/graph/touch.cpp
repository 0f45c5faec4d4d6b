#include "graph/touch.h"

#include <cstddef>

namespace lampyris::graph {
namespace {

/// The one layout for one access to an image; none where images know no such access.
std::optional<Layout> layoutFor(Access access, bool depth) {
    switch (access) {
        case Access::StorageRead:
        case Access::StorageWrite:
        case Access::StorageUpdate:
            return Layout::General;
        case Access::Sampled:
            return depth ? Layout::DepthReadOnly : Layout::ReadOnly;
        case Access::ColorWrite:
            return Layout::ColorAttachment;
        case Access::DepthWrite:
            return Layout::DepthAttachment;
        case Access::DepthRead:
            return Layout::DepthReadOnly;
        case Access::TransferRead:
            return Layout::TransferSource;
        case Access::TransferWrite:
            return Layout::TransferTarget;
        case Access::Present:
            return Layout::Present;
        case Access::HostRead:
            return Layout::General;
        default:
            return std::nullopt;
    }
}

}  // namespace

void TouchSet::add(const TouchSet& other) {
    for (uint32_t kind = 0; kind < kNodeKindCount; ++kind) kinds_[kind].add(other.kinds_[kind]);
}

bool TouchSet::anyWrites() const {
    bool any = false;
    forEach([&](Touch touch) { any = any || writes(touch.access); });
    return any;
}

AccessSet TouchSet::accesses() const {
    AccessSet all;
    for (const AccessSet set : kinds_) all.add(set);
    return all;
}

std::string describe(const TouchSet& touches) {
    std::string text;
    touches.forEach([&](Touch touch) {
        if (!text.empty()) text += " + ";
        text += std::string(name(touch.kind)) + ' ' + name(touch.access);
    });
    return text.empty() ? "nothing" : text;
}

TouchSet outsideTouches(Access access) {
    TouchSet touches;
    switch (access) {
        case Access::None:
            break;
        case Access::TransferRead:
        case Access::TransferWrite:
            touches.add({access, NodeKind::Transfer});
            break;
        case Access::HostRead:
        case Access::Present:
            touches.add({access, NodeKind::Host});
            break;
        case Access::ColorWrite:
        case Access::DepthWrite:
        case Access::DepthRead:
        case Access::VertexRead:
        case Access::IndexRead:
            touches.add({access, NodeKind::Raster});
            break;
        default:
            touches.add({access, NodeKind::Compute});
            touches.add({access, NodeKind::Raster});
    }
    return touches;
}

const char* name(Layout layout) {
    static constexpr std::array<const char*, 9> kNames{
        "Undefined",     "General",        "ReadOnly",       "ColorAttachment", "DepthAttachment",
        "DepthReadOnly", "TransferSource", "TransferTarget", "Present"};
    return kNames[static_cast<size_t>(layout)];
}

std::optional<Layout> layoutFor(AccessSet accesses, Format format) {
    std::optional<Layout> common;
    for (uint32_t bit = 0; bit < kAccessCount; ++bit) {
        const auto access = static_cast<Access>(bit);
        if (!accesses.has(access)) continue;
        const auto layout = layoutFor(access, isDepth(format));
        if (!layout || (common && *common != *layout)) return std::nullopt;
        common = layout;
    }
    return common;
}

Layout restLayout(Format format) {
    return isDepth(format) ? Layout::DepthReadOnly : Layout::ReadOnly;
}

}  // namespace lampyris::graph
