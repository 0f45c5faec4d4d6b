/// \file Sets of accesses, and the image layouts that follow from them. No Vulkan: execute/
/// translates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "graph/access.h"
#include "graph/resource.h"

namespace lampyris::graph {

/// Any number of different accesses, whoever made them; what a resource must be created for.
struct AccessSet {
    uint32_t bits = 0;
    void add(Access access) { bits |= 1u << static_cast<uint32_t>(access); }
    void add(AccessSet other) { bits |= other.bits; }
    [[nodiscard]] bool has(Access access) const {
        return (bits >> static_cast<uint32_t>(access) & 1u) != 0;
    }
    [[nodiscard]] bool empty() const { return bits == 0; }
    bool operator==(const AccessSet&) const = default;
};

constexpr uint32_t kAccessCount = static_cast<uint32_t>(Access::Present) + 1;
constexpr uint32_t kNodeKindCount = static_cast<uint32_t>(NodeKind::Host) + 1;

/// An access and the kind of node that makes it: together they give pipeline stages and access
/// mask.
struct Touch {
    Access access = Access::None;
    NodeKind kind = NodeKind::Compute;
    bool operator==(const Touch&) const = default;
};

/// Any number of different touches: one side of a barrier.
class TouchSet {
 public:
    void add(Touch touch) { kinds_[static_cast<uint32_t>(touch.kind)].add(touch.access); }
    void add(const TouchSet& other);
    [[nodiscard]] bool has(Touch touch) const {
        return kinds_[static_cast<uint32_t>(touch.kind)].has(touch.access);
    }
    [[nodiscard]] bool empty() const { return accesses().empty(); }
    [[nodiscard]] bool anyWrites() const;
    [[nodiscard]] AccessSet accesses() const;  ///< without the kinds
    /// Calls `visit(Touch)` for each, by kind and then by access.
    template <typename Visit>
    void forEach(Visit visit) const {
        for (uint32_t kind = 0; kind < kNodeKindCount; ++kind) {
            for (uint32_t access = 0; access < kAccessCount; ++access) {
                const Touch touch{static_cast<Access>(access), static_cast<NodeKind>(kind)};
                if (has(touch)) visit(touch);
            }
        }
    }
    bool operator==(const TouchSet&) const = default;

 private:
    std::array<AccessSet, kNodeKindCount> kinds_{};
};

/// "compute StorageWrite + raster Sampled", for exports and messages.
[[nodiscard]] std::string describe(const TouchSet& touches);

/// Every way the world outside the graph can make this access (Sampled: in compute and raster
/// shaders).
[[nodiscard]] TouchSet outsideTouches(Access access);

/// Where an image's texels must stand for an access.
enum class Layout : uint8_t {
    Undefined,  ///< contents lost
    General,    ///< storage images
    ReadOnly,   ///< sampled colour
    ColorAttachment,
    DepthAttachment,  ///< tested and written
    DepthReadOnly,    ///< tested, sampled, or both
    TransferSource,
    TransferTarget,
    Present,
};

[[nodiscard]] const char* name(Layout layout);

/// The one layout that serves all these accesses at once; none where there is no such layout.
[[nodiscard]] std::optional<Layout> layoutFor(AccessSet accesses, Format format);

/// The layout in which history images wait between frames: that of Sampled.
[[nodiscard]] Layout restLayout(Format format);

}  // namespace lampyris::graph
