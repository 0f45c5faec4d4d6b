/// \file Ids that cannot be mixed up: MeshId and MaterialId are different types.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace lampyris::core {

/// A 32-bit index into a table of things of one kind; the default is "none".
template <typename Tag>
struct Id {
    static constexpr uint32_t kNone = 0xffffffffu;
    uint32_t value = kNone;

    [[nodiscard]] bool valid() const { return value != kNone; }
    // NOLINTNEXTLINE(modernize-use-nullptr): seen in the comparison that the compiler writes
    auto operator<=>(const Id&) const = default;
};

}  // namespace lampyris::core

template <typename Tag>
struct std::hash<lampyris::core::Id<Tag>> {
    size_t operator()(lampyris::core::Id<Tag> id) const noexcept {
        return std::hash<uint32_t>{}(id.value);
    }
};
