/// \file Whether a shader's new words can stand where its old ones did: C++ binds by what the build
/// found in those.
#pragma once

#include <cstdint>
#include <span>

#include "core/result.h"
#include "graph/shader.h"

namespace lampyris::shader_reload {

/// An Error names the slot or the stage's value (number and name), the workgroup's size, the push
/// constants that differ, or what not every device has. Names may change, and inputs of a stage may
/// go; what shares memory may share less.
core::Result<void> checkInterface(const graph::Shader& built, std::span<const uint32_t> words);

}  // namespace lampyris::shader_reload
