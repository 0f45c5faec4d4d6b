// Lets one header be C++ and GLSL at once. Structs in shaders/shared/ use only float, uint, int, vec2, vec4
// and mat4, padded by hand to 16 bytes, so that std430, std140 and C++ agree; a test compares the offsets.
#ifndef LAMPYRIS_SHARED_GLSL_COMPAT_H
#define LAMPYRIS_SHARED_GLSL_COMPAT_H

#ifdef __cplusplus
#include <cstdint>

#include "math/glm.h"

namespace lampyris::shared {
using uint = uint32_t;
using glm::mat4;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec4;
}  // namespace lampyris::shared

#define LAMPYRIS_SHARED_BEGIN namespace lampyris::shared {
#define LAMPYRIS_SHARED_END }
#define LAMPYRIS_SLOT(name, number) constexpr uint32_t name = number
#else
#define LAMPYRIS_SHARED_BEGIN
#define LAMPYRIS_SHARED_END
#define LAMPYRIS_SLOT(name, number) const uint name = number
#endif

#endif
