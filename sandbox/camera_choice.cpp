#include "camera_choice.h"

namespace lampyris::sandbox {

core::Result<scene::SnapshotCamera> chooseCamera(const scene::SceneSnapshot& snapshot,
                                                 const std::string& name) {
    std::string names;
    for (const auto& camera : snapshot.cameras) {
        if (name.empty() || camera.name == name) return camera;
        names += fmt::format("{}'{}'", names.empty() ? "" : ", ", camera.name);
    }
    return core::error("--camera {}: the scene has no such camera; it has {}", name, names);
}

}  // namespace lampyris::sandbox
