#include "ecs/type.h"

#include <algorithm>
#include <atomic>

namespace lampyris::ecs::detail {

uint32_t nextTypeIndex() {
    static std::atomic<uint32_t> next{0};
    return next.fetch_add(1);
}

std::string_view bareTypeName(std::string_view signature) {
    // GCC writes "[with T = a::B; …]", Clang "[T = a::B]".
    const size_t start = signature.find("T = ") + 4;
    std::string_view name = signature.substr(start, signature.find_first_of(";]", start) - start);
    // Only the namespaces of the type itself: those of template arguments stay.
    const size_t scope = name.substr(0, name.find('<')).rfind("::");
    return scope == std::string_view::npos ? name : name.substr(scope + 2);
}

}  // namespace lampyris::ecs::detail
