/// \file The camera that a user names.
#pragma once

#include <string>

#include "core/result.h"
#include "scene/snapshot.h"

namespace lampyris::sandbox {

/// The first of that name, or the first of all where the name is empty. The error lists those there
/// are.
[[nodiscard]] core::Result<scene::SnapshotCamera> chooseCamera(const scene::SceneSnapshot& snapshot,
                                                               const std::string& name);

}  // namespace lampyris::sandbox
