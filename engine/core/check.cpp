#include "core/check.h"

#include <cstdio>
#include <cstdlib>

namespace lampyris::core {

void checkFailed(const char* file, int line, const char* expression, const std::string& operands) {
    std::fflush(stdout);
    fmt::print(stderr, "lampyris: CHECK({}) failed at {}:{}: {}\n", expression, file, line,
               operands);
    std::abort();
}

}  // namespace lampyris::core
