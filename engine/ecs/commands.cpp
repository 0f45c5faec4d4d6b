#include "ecs/commands.h"

#include <utility>

#include "core/check.h"
#include "core/log.h"

namespace lampyris::ecs {

Entity Commands::resolve(const Target& target, const std::vector<Entity>& created) {
    if (!target.isNew_) return target.entity_;
    CHECK(target.created_ < created.size());
    return created[target.created_];
}

void Commands::destroy(Target target) {
    record([target](World& world, const std::vector<Entity>& created) {
        world.destroy(resolve(target, created));
    });
}

void Commands::setParent(Target child, Target parent) {
    record([child, parent](World& world, const std::vector<Entity>& created) {
        const Entity below = resolve(child, created);
        const Entity above = resolve(parent, created);
        if (!world.alive(below) || !world.alive(above)) return;
        const auto linked = ecs::setParent(world, below, above);
        if (!linked.ok()) core::logWarning("{}", linked.error().message);
    });
}

std::vector<Entity> Commands::apply(World& world) {
    // Taken first: an observer of what follows may record into this list again.
    const auto operations = std::exchange(operations_, {});
    std::vector<Entity> created(std::exchange(created_, 0));
    for (Entity& e : created) e = world.create();
    for (const auto& operation : operations) operation->run(world, created);
    return created;
}

}  // namespace lampyris::ecs
