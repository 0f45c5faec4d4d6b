/// \file Whether a shader's new words can stand where its old ones did: C++ binds by what the build
/// found in those.
#pragma once

#include <cstdint>
#include <span>

#include "core/result.h"
#include "graph/shader.h"

namespace lampyris::shader_reload {

/// An Error names the slot (its number and name), the workgroup's size or the push constants that
/// differ. Names of slots may change.
core::Result<void> checkInterface(const graph::Shader& built, std::span<const uint32_t> words);

}  // namespace lampyris::shader_reload
