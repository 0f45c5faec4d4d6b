// A game that keeps its things in a plain array: `own_storage OUT.png FRAMES` draws it as it moves.
#include "core/image_io.h"
#include "core/log.h"
#include "photon_gi/renderer.h"
#include "scene/builtin/shapes.h"
#include "scene/live_snapshot.h"
#include "scene/mirror.h"
#include "scene/spawn.h"

using namespace lampyris;

// The game's own storage, which knows nothing of entities.
struct Crate {
    uint64_t id;
    glm::vec3 place;  // metres
    float metresPerSecond;
};

struct Game {
    std::vector<Crate> crates;
    glm::vec3 lamp{-2.0f, 3.0f, 1.0f};

    void play(float seconds) {
        for (Crate& crate : crates) crate.place.x += crate.metresPerSecond * seconds;
        std::erase_if(crates, [](const Crate& crate) { return crate.place.x > 3.0f; });
    }
};

// What the engine is shown of it. Numbers of things must differ; these take the crates' from 100
// on.
class Shown : public scene::EntitySource {
 public:
    Shown(const Game& game, scene::MeshInstance floor, scene::MeshInstance crate)
        : game_(&game), floor_(floor), crate_(crate) {}

    void forEach(const std::function<void(const scene::EntityState&)>& show) const override {
        show({.id = 0, .transform = {{0, -0.1f, 0}}, .mesh = floor_});
        show({.id = 1, .transform = {game_->lamp}, .light = lamp_});
        show({.id = 2, .transform = camera_, .camera = scene::Camera{}});
        for (const Crate& crate : game_->crates)
            show({.id = 100 + crate.id, .transform = {crate.place}, .mesh = crate_});
    }

 private:
    const Game* game_;
    scene::MeshInstance floor_, crate_;
    scene::SphereLight lamp_{.radiusMetres = 0.1f, .powerWatts = glm::vec3(400)};
    scene::Transform camera_{{0, 4, 9}, scene::rotationFacing({0, 3, 9})};
};

core::Result<void> play(const std::string& picture, uint64_t frames) {
    TRY(const auto device, gpu::Device::create({}));
    TRY(auto executor, execute::Executor::create(*device));
    photon_gi::Renderer renderer(executor);
    ecs::World world = scene::newWorld();
    auto& library = world.resource<scene::Library>();
    const auto red = library.addMaterial(scene::lambertian("red", {0.7f, 0.1f, 0.1f}));
    Game game{{{1, {-3, 0.5f, 0}, 1.0f}, {2, {0, 0.5f, -1}, 0.0f}, {3, {2.5f, 0.5f, 1}, 6.0f}}};
    const Shown shown(game, {library.addMesh(scene::builtin::boxMesh({4, 0.1f, 4})), {}},
                      {library.addMesh(scene::builtin::boxMesh(glm::vec3(0.5f))), red});
    scene::Mirror mirror;
    scene::LiveSnapshot live;
    for (uint64_t number = 0; number < frames; ++number) {
        game.play(1.0f / 60.0f);
        mirror.follow(world,
                      shown);  // edits the crates that moved, and takes away the one that left
        const auto& now = live.follow(world, static_cast<double>(number) / 60.0);
        TRY(const auto drawn,
            renderer.draw(now, {.frameNumber = number, .camera = now.cameras[0]}, "final"));
        if (drawn.report.valid) TRY_VOID(core::writeImage(picture, drawn.image, {}));
    }
    return {};
}

int main(int argc, char** argv) {
    const auto played =
        play(argc > 1 ? argv[1] : "own_storage.png", argc > 2 ? std::stoul(argv[2]) : 30);
    if (!played.ok()) core::logError("{}", played.error().message);
    return played.ok() ? 0 : 1;
}
