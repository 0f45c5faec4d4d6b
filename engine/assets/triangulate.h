/// \file Triangle lists from strips and fans.
#pragma once

#include <cstdint>
#include <vector>

namespace lampyris::assets {

enum class Topology : uint8_t { List, Strip, Fan };

/// Three indices a triangle, wound as glTF 2.0 (3.7.2.1) says. A list loses what is left of a
/// triangle.
std::vector<uint32_t> triangulate(std::vector<uint32_t> indices, Topology topology);

}  // namespace lampyris::assets
