/// \file What changed between two snapshots, and where: what keeps light over frames asks it.
#pragma once

#include <vector>

#include "scene/snapshot.h"

namespace lampyris::scene {

/// A place where geometry moved, bent, came or went: around it before and after.
struct ChangedRegion {
    math::Bounds boundsWorld;
    float movedMetres = 0.0f;  ///< about how far its surface moved; its size where it came or went
};

/// A light that moved, changed, came or went.
struct ChangedLight {
    glm::vec3 positionWorld{0.0f};  ///< after; before where it went
    float watts = 0.0f;             ///< mean of the channels, the larger of before and after
    float changedWatts = 0.0f;      ///< of them, that came or went; all where its way to shine did
    float movedMetres = 0.0f;
};

struct SceneChanges {
    bool everything = false;           ///< materials, images: nothing can be said of where
    bool lightsCameOrWent = false;     ///< their numbers are others
    bool instancesCameOrWent = false;  ///< likewise
    std::vector<ChangedRegion> regions;
    std::vector<ChangedLight> lights;

    [[nodiscard]] bool none() const { return !everything && regions.empty() && lights.empty(); }
};

/// \param after of the same world as `before`, later
[[nodiscard]] SceneChanges changesBetween(const SceneSnapshot& before, const SceneSnapshot& after);

/// Adds later changes to earlier ones.
void add(SceneChanges& changes, SceneChanges later);

}  // namespace lampyris::scene
