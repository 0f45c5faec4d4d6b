/// \file The handle of an entity.
#pragma once

#include <fmt/format.h>

#include <compare>
#include <cstdint>
#include <functional>

namespace lampyris::ecs {

/// 32 bits: 20 of index, 12 of generation. A handle whose entity died is stale and is detected as
/// such: a slot that has used up its generations is retired, so that no handle ever comes back.
struct Entity {
    static constexpr uint32_t kIndexBits = 20;
    static constexpr uint32_t kIndexMask = (1u << kIndexBits) - 1;
    static constexpr uint32_t kNone = 0xffffffffu;
    static constexpr uint32_t kMaxGeneration = (1u << (32 - kIndexBits)) - 1;
    static constexpr uint32_t kMaxEntities =
        kIndexMask;  ///< alive at once; the last index is kNone's
    uint32_t bits = kNone;

    [[nodiscard]] uint32_t index() const { return bits & kIndexMask; }
    [[nodiscard]] uint32_t generation() const { return bits >> kIndexBits; }
    [[nodiscard]] bool valid() const { return bits != kNone; }
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 behind <=> for a pointer
    auto operator<=>(const Entity&) const = default;
};

/// The world's clock of changes; grows, never wraps.
using Tick = uint64_t;

}  // namespace lampyris::ecs

template <>
struct std::hash<lampyris::ecs::Entity> {
    size_t operator()(lampyris::ecs::Entity e) const noexcept {
        return std::hash<uint32_t>{}(e.bits);
    }
};

/// "7v2": the second reuse of slot 7; "none" for the default handle.
template <>
struct fmt::formatter<lampyris::ecs::Entity> : fmt::formatter<std::string_view> {
    template <typename Context>
    auto format(lampyris::ecs::Entity e, Context& context) const {
        if (!e.valid()) return fmt::format_to(context.out(), "none");
        return fmt::format_to(context.out(), "{}v{}", e.index(), e.generation());
    }
};
