// A lamp circles round a box, in a window. `minimal OUT.png FRAMES` keeps the last frame instead.
#include "core/image_io.h"
#include "core/log.h"
#include "photon_gi/renderer.h"
#include "scene/builtin/shapes.h"
#include "scene/live_snapshot.h"
#include "scene/motion.h"
#include "scene/spawn.h"
#include "window/presenter.h"

using namespace lampyris;

void circle(ecs::Write<scene::Transform> at, ecs::With<scene::SphereLight>, scene::FrameTime now) {
    at->translation = {2.0 * std::cos(now.seconds), 2.0, 2.0 * std::sin(now.seconds)};
}

ecs::World makeWorld() {
    ecs::World world = scene::newWorld();
    auto& library = world.resource<scene::Library>();
    const auto red = library.addMaterial(scene::lambertian("red", {0.7f, 0.1f, 0.1f}));
    scene::spawnMesh(world, scene::builtin::boxMesh({4, 0.1f, 4}), {}, {{0, -0.1f, 0}});
    scene::spawnMesh(world, scene::builtin::boxMesh({4, 2, 0.1f}), red, {{0, 2, -4}});
    scene::spawnMesh(world, scene::builtin::boxMesh({0.5f, 0.8f, 0.5f}), {}, {{0, 0.8f, 0}});
    scene::spawnLight(world, "lamp", {}, {.radiusMetres = 0.1f, .powerWatts = glm::vec3(200)});
    scene::spawnCamera(world, "camera", {0, 4, 9}, {0, 1, 0});
    world.resource<scene::Motion>().systems.add("circle", circle);
    return world;
}

core::Result<void> play(const std::string& picture, uint64_t frames) {
    TRY(const auto device, gpu::Device::create({.presentable = picture.empty()}));
    TRY(auto executor, execute::Executor::create(*device));
    std::optional<window::Window> window;
    std::optional<window::Presenter> presenter;
    if (picture.empty()) {
        TRY(window, window::Window::create({.title = "minimal"}));
        TRY(presenter, window::Presenter::create(*device, *window, window::Encoding::Linear));
    }
    photon_gi::Renderer renderer(executor, {.rebuild = {.deterministic = !window}});
    ecs::World world = makeWorld();
    scene::LiveSnapshot live;
    for (uint64_t number = 0; window ? !window->shouldClose() : number < frames; ++number) {
        if (window) window->poll();
        const auto& now = live.follow(world, static_cast<double>(number) / 60.0);
        TRY(const auto drawn, renderer.draw(now, {.frameNumber = number, .camera = now.cameras[0]},
                                            window ? "" : "final"));
        if (!drawn.report.valid) continue;  // something found no room: the next frame has more
        if (presenter) TRY_VOID(presenter->present(executor.outputImage(drawn.radiance)));
        if (!presenter) TRY_VOID(core::writeImage(picture, drawn.image, {}));
    }
    return {};
}

int main(int argc, char** argv) {
    const auto played = play(argc > 1 ? argv[1] : "", argc > 2 ? std::stoul(argv[2]) : 30);
    if (!played.ok()) core::logError("{}", played.error().message);
    return played.ok() ? 0 : 1;
}
