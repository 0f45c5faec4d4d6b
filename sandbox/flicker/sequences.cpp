#include "flicker/sequences.h"

#include <algorithm>
#include <optional>

#include "evaluation/flicker.h"
#include "progress.h"
#include "scene/components.h"

namespace lampyris::sandbox::flicker {
namespace {

constexpr float kMovedMetres = 1.0f;  // [chosen] a step to the side
// [chosen] The light that is switched off comes back with this: a component of our own keeps it.
struct SwitchedOff {
    scene::SphereLight light;
};

core::Result<core::DisplayImage> drawOne(FrameLoop& loop, const core::DisplayTransform& display,
                                         uint64_t frameNumber) {
    TRY(const LoopFrame frame, loop.draw(frameNumber, true));
    return core::toDisplay(frame.outcome.image, display);
}

float watts(const scene::SphereLight& light) {
    return light.powerWatts.x + light.powerWatts.y + light.powerWatts.z;
}

std::vector<ecs::Entity> lightsByPower(const ecs::World& world) {
    std::vector<std::pair<float, ecs::Entity>> lights;
    for (const auto& [entity, light, transform] :
         world.view<scene::SphereLight, scene::Transform>())
        lights.emplace_back(-watts(light), entity);
    std::sort(lights.begin(), lights.end(), [](const auto& a, const auto& b) {
        return std::pair(a.first, a.second.bits) < std::pair(b.first, b.second.bits);
    });
    std::vector<ecs::Entity> entities;
    for (const auto& [power, entity] : lights) entities.push_back(entity);
    return entities;
}

/// Whether the world's systems, run again, leave the light as it was put.
bool staysPut(FrameLoop& loop, ecs::Entity entity) {
    const glm::vec3 put = loop.world().get<scene::Transform>(entity).translation;
    if (!loop.follow().ok()) return false;
    return loop.world().alive(entity) &&
           loop.world().get<scene::Transform>(entity).translation == put;
}

bool moveALight(FrameLoop& loop) {
    for (const ecs::Entity entity : lightsByPower(loop.world())) {
        loop.world().edit<scene::Transform>(entity).translation.x += kMovedMetres;
        if (staysPut(loop, entity)) return true;
    }
    return false;
}

bool switchALight(ecs::World& world, LightChange change) {
    if (change == LightChange::On) {
        for (const auto& [entity, kept] : world.view<SwitchedOff>()) {
            const ecs::Entity lamp = entity;
            const scene::SphereLight light = kept.light;
            world.remove<SwitchedOff>(lamp);
            world.set(lamp, light);
            return true;
        }
        return false;
    }
    const auto lights = lightsByPower(world);
    if (lights.empty()) return false;
    world.set(lights.front(), SwitchedOff{world.get<scene::SphereLight>(lights.front())});
    world.remove<scene::SphereLight>(lights.front());
    return true;
}

}  // namespace

const char* nameOf(LightChange change) {
    return change == LightChange::Off ? "off" : change == LightChange::On ? "on" : "moved";
}

core::Result<Pictures> drawStill(FrameLoop& loop, const core::DisplayTransform& display,
                                 uint32_t warmup, uint32_t frames, uint64_t& frameNumber) {
    Progress progress{"still frame", warmup + frames};
    Pictures pictures;
    for (uint32_t i = 0; i < warmup + frames; ++i) {
        progress.show(i);
        TRY(core::DisplayImage picture, drawOne(loop, display, frameNumber++));
        if (i >= warmup) pictures.push_back(std::move(picture));
    }
    return pictures;
}

core::Result<Moving> drawMoving(FrameLoop& loop, const core::DisplayTransform& display,
                                uint32_t warmup, uint32_t frames) {
    Progress progress{"moving frame", warmup + frames};
    Moving moving;
    const auto versions = [&] {
        return loop.snapshot().geometryVersion + loop.snapshot().lightVersion;
    };
    std::optional<uint64_t> before;
    for (uint32_t i = 0; i < warmup + frames; ++i) {
        progress.show(i);
        TRY(core::DisplayImage picture, drawOne(loop, display, i));
        if (i < warmup) continue;
        moving.pictures.push_back(std::move(picture));
        moving.frames.push_back({loop.snapshot(), loop.request.camera});
        moving.moves = moving.moves || (before && *before != versions());
        before = versions();
    }
    return moving;
}

core::Result<Pictures> drawChange(FrameLoop& loop, const core::DisplayTransform& display,
                                  LightChange change, uint64_t& frameNumber) {
    Progress progress{fmt::format("light {}, frame", nameOf(change)), evaluation::kLastSettled + 1};
    Pictures pictures;
    TRY(core::DisplayImage last, drawOne(loop, display, frameNumber++));
    pictures.push_back(std::move(last));
    const bool changed =
        change == LightChange::Moved ? moveALight(loop) : switchALight(loop.world(), change);
    if (!changed) return Pictures{};
    for (uint32_t i = 1; i <= evaluation::kLastSettled; ++i) {
        progress.show(i);
        TRY(core::DisplayImage picture, drawOne(loop, display, frameNumber++));
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace lampyris::sandbox::flicker
