/// \file A small number and a readable name for every type of component and resource.
#pragma once

#include <cstdint>
#include <string_view>

namespace lampyris::ecs {

namespace detail {
uint32_t nextTypeIndex();
std::string_view bareTypeName(std::string_view signature);

template <typename T>
constexpr std::string_view signatureOf() {
    return __PRETTY_FUNCTION__;
}
}  // namespace detail

/// 0, 1, 2, … in the order of first use in this process; never stored in files.
template <typename T>
uint32_t typeIndex() {
    static const uint32_t index = detail::nextTypeIndex();
    return index;
}

/// The type's name without its namespaces; for messages and drawings.
template <typename T>
std::string_view typeName() {
    return detail::bareTypeName(detail::signatureOf<T>());
}

}  // namespace lampyris::ecs
