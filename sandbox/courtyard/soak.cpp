#include "courtyard/soak.h"

#include <vector>

#include "courtyard/figure.h"
#include "courtyard/floor_plan.h"
#include "courtyard/forms.h"
#include "courtyard/movements.h"
#include "courtyard/visitors.h"
#include "scene/builtin/numbers.h"
#include "scene/motion.h"

namespace lampyris::courtyard {
namespace {

/// A kind's living, oldest first.
using Crowd = std::vector<ecs::Entity>;

struct Soak {
    uint32_t seed = 1;
    uint32_t frame = 0;
    Crowd things, lights, figures;
};

/// Numbers of one frame, one after the other.
class Dice {
 public:
    explicit Dice(uint32_t seed) : seed_(seed) {}
    float unit() { return scene::builtin::hashUnit(seed_, count_++); }
    uint32_t below(size_t count) {
        return scene::builtin::hashBits(seed_, count_++) % static_cast<uint32_t>(count);
    }
    glm::vec3 place(float y) {
        const Room& room = unit() < 0.7f ? kSquare : (unit() < 0.5f ? kArcade : kWorkshop);
        const glm::vec3 share(unit(), 0.0f, unit());
        const glm::vec3 at = glm::mix(room.lower + 0.5f, room.upper - 0.5f, share);
        return {at.x, y, at.z};
    }

 private:
    uint32_t seed_;
    uint32_t count_ = 0;
};

ecs::Entity makeThing(ecs::World& world, Dice& dice) {
    const auto& stock = world.resource<Stock>();
    const bool crate = dice.unit() < 0.5f;
    const ecs::Entity thing =
        scene::spawn(world, "soak's thing",
                     {dice.place(0.3f + 2.0f * dice.unit()),
                      turned({0.0f, 1.0f, 0.0f}, dice.unit()), glm::vec3(0.5f + dice.unit())});
    world.add(thing,
              scene::MeshInstance{crate ? stock.crate : stock.leaf, stock.dyes[dice.below(4)]});
    if (dice.unit() < 0.5f) world.add(thing, Spin{{0.0f, 1.0f, 0.0f}, 0.5f * dice.unit()});
    return thing;
}

ecs::Entity makeLight(ecs::World& world, Dice& dice) {
    const glm::vec3 power = 150.0f * glm::vec3(dice.unit(), dice.unit(), dice.unit());
    return scene::spawnLight(world, "soak's light", dice.place(0.5f + 2.0f * dice.unit()),
                             {.radiusMetres = 0.02f + 0.2f * dice.unit(), .powerWatts = power});
}

ecs::Entity makeFigure(ecs::World& world, Dice& dice) {
    const auto& stock = world.resource<Stock>();
    const scene::Transform place{dice.place(0.035f), turned({0.0f, 1.0f, 0.0f}, dice.unit())};
    return spawnFigure(world, world.resource<Figures>(), stock.dyes[dice.below(4)], place,
                       dice.unit());
}

/// Every other frame or so one goes and one comes, up to `most`.
template <typename Make>
void churn(ecs::World& world, Crowd& crowd, size_t most, Dice& dice, const Make& make) {
    const bool goes = dice.unit() < 0.4f;
    const bool comes = dice.unit() < 0.55f;
    if (goes && !crowd.empty()) {
        const uint32_t who = dice.below(crowd.size());
        world.destroy(crowd[who]);
        crowd.erase(crowd.begin() + who);
    }
    if (comes && crowd.size() < most) {
        crowd.push_back(make(world, dice));
        world.add(crowd.back(), Soaked{});
    }
}

void soak(ecs::World& world) {
    auto& state = world.resource<Soak>();
    Dice dice(scene::builtin::hashBits(state.seed, state.frame++));
    churn(world, state.things, kMostSoakThings, dice, makeThing);
    churn(world, state.things, kMostSoakThings, dice, makeThing);
    churn(world, state.lights, kMostSoakLights, dice, makeLight);
    churn(world, state.figures, kMostSoakFigures, dice, makeFigure);
}

}  // namespace

void addSoak(ecs::World& world, uint32_t seed) {
    world.setResource(Soak{seed, 0, {}, {}, {}});
    world.resource<scene::Motion>().systems.add("soak", soak);
}

}  // namespace lampyris::courtyard
