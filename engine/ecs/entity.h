/// \file The handle of an entity.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace lampyris::ecs {

/// 32 bits: 20 of index, 12 of generation. A handle whose entity died is stale and is detected as such.
struct Entity {
    static constexpr uint32_t kIndexBits = 20;
    static constexpr uint32_t kIndexMask = (1u << kIndexBits) - 1;
    static constexpr uint32_t kNone = 0xffffffffu;
    uint32_t bits = kNone;

    [[nodiscard]] uint32_t index() const { return bits & kIndexMask; }
    [[nodiscard]] uint32_t generation() const { return bits >> kIndexBits; }
    [[nodiscard]] bool valid() const { return bits != kNone; }
    auto operator<=>(const Entity&) const = default;
};

/// The world's clock of changes; grows, never wraps.
using Tick = uint64_t;

}  // namespace lampyris::ecs

template <>
struct std::hash<lampyris::ecs::Entity> {
    size_t operator()(lampyris::ecs::Entity e) const noexcept { return std::hash<uint32_t>{}(e.bits); }
};
