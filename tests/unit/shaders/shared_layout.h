/// \file Every struct of shaders/shared/ as the C++ compiler lays it out; written at build time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lampyris::test {

struct SharedMember {
    std::string name;
    size_t offset = 0;
};

struct SharedStruct {
    std::string name;
    size_t bytes = 0;
    std::vector<SharedMember> members;
};

[[nodiscard]] const std::vector<SharedStruct>& sharedStructs();

}  // namespace lampyris::test
