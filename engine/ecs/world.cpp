#include "ecs/world.h"

#include "core/check.h"

namespace lampyris::ecs {

Entity World::create() {
    uint32_t index = 0;
    if (free_.empty()) {
        CHECK(slots_.size() < Entity::kMaxEntities);
        index = static_cast<uint32_t>(slots_.size());
        slots_.emplace_back();
    } else {
        index = free_.back();
        free_.pop_back();
    }
    slots_[index].living = true;
    ++living_;
    return occupant(index);
}

Entity World::occupant(uint32_t index) const {
    if (index >= slots_.size() || !slots_[index].living) return {};
    return {(uint32_t{slots_[index].generation} << Entity::kIndexBits) | index};
}

std::vector<Entity> World::entities() const {
    std::vector<Entity> found;
    found.reserve(living_);
    for (uint32_t index = 0; index < slots_.size(); ++index)
        if (slots_[index].living) found.push_back(occupant(index));
    return found;
}

bool World::destroy(Entity e) {
    if (!alive(e)) return false;
    std::vector<std::unique_ptr<Departure>> departures;
    leaveFamily(*this, e);
    if (has<Children>(e)) {
        for (const Entity doomed : subtree(*this, e)) bury(doomed, departures);
    } else {
        bury(e, departures);
    }
    for (const auto& departure : departures) departure->announce(*this);
    return true;
}

void World::bury(Entity e, std::vector<std::unique_ptr<Departure>>& departures) {
    for (const auto& pool : pools_) {
        if (!pool || !pool->contains(e)) continue;
        if (auto departure = pool->depart(e, tick_)) departures.push_back(std::move(departure));
    }
    Slot& slot = slots_[e.index()];
    slot.living = false;
    --living_;
    if (slot.generation == Entity::kMaxGeneration)
        return;  // retired: its next handle would be an old one
    ++slot.generation;
    free_.push_back(e.index());
}

void World::forgetRemovals(Tick until) {
    for (const auto& pool : pools_)
        if (pool) pool->forgetRemovals(until);
}

void World::fail(Entity e, const char* call, std::string_view component) const {
    const Entity now = e.valid() ? occupant(e.index()) : Entity{};
    const char* why = !e.valid() ? "no such thing in the world"
                      : now != e ? "the handle is stale"
                      : std::string_view(call) == "add"
                          ? "it has one already, or an observer removed it"
                          : "the entity has none";
    core::checkFailed("ecs/world.h", 0, fmt::format("{}<{}>", call, component).c_str(),
                      fmt::format("entity {}: {} (its slot holds {})", e, why, now));
}

}  // namespace lampyris::ecs
