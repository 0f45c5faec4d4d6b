/// \file The templates of World; included by world.h alone.
#pragma once

#include <string>

#include "ecs/world.h"

namespace lampyris::ecs {

template <Component C>
Pool<C>& World::pool() {
    const uint32_t type = typeIndex<C>();
    if (type >= pools_.size()) pools_.resize(type + 1);
    if (!pools_[type]) pools_[type] = std::make_unique<Pool<C>>();
    return static_cast<Pool<C>&>(*pools_[type]);
}

template <Component C>
const Pool<C>* World::findPool() const {
    const uint32_t type = typeIndex<C>();
    return type < pools_.size() ? static_cast<const Pool<C>*>(pools_[type].get()) : nullptr;
}

template <Component C>
uint32_t World::demand(const Pool<C>& pool, Entity e, const char* call) const {
    const uint32_t at = pool.position(e);
    if (at == SparseSet::kAbsent) fail(e, call, typeName<C>());
    return at;
}

template <Component C>
Pool<C>& World::insert(Entity e, C value, const char* call) {
    Pool<C>& pool = this->pool<C>();
    if (!alive(e) || pool.contains(e)) fail(e, call, typeName<C>());
    pool.insert(e, std::move(value), tick_);
    if (!pool.added.empty()) pool.added.notifyWhile([&] { return pool.contains(e); }, *this, e);
    return pool;
}

template <Component C>
void World::announceChange(Entity e) {
    Pool<C>& pool = this->pool<C>();
    if (!pool.changed.empty()) pool.changed.notifyWhile([&] { return pool.contains(e); }, *this, e);
}

template <Component C>
C& World::add(Entity e, C value) {
    Pool<C>& pool = insert(e, std::move(value), "add");
    return pool.at(demand(pool, e, "add"));
}

template <Component C>
void World::set(Entity e, C value) {
    Pool<C>& pool = this->pool<C>();
    const uint32_t at = pool.position(e);
    if (at == SparseSet::kAbsent) {
        insert(e, std::move(value), "set");
        return;
    }
    pool.at(at) = std::move(value);
    pool.stamp(at, tick_);
    announceChange<C>(e);
}

template <Component C>
const C* World::find(Entity e) const {
    const Pool<C>* pool = findPool<C>();
    return pool == nullptr ? nullptr : pool->find(e);
}

template <Component C>
const C& World::get(Entity e) const {
    const C* found = find<C>(e);
    if (found == nullptr) fail(e, "get", typeName<C>());
    return *found;
}

template <Component C>
C& World::edit(Entity e) {
    Pool<C>& pool = this->pool<C>();
    pool.stamp(demand(pool, e, "edit"), tick_);
    announceChange<C>(e);
    return pool.at(demand(pool, e, "edit"));
}

template <Component C, typename F>
void World::edit(Entity e, const F& write) {
    Pool<C>& pool = this->pool<C>();
    const uint32_t at = demand(pool, e, "edit");
    pool.stamp(at, tick_);
    write(pool.at(at));
    announceChange<C>(e);
}

template <Component C>
bool World::take(Entity e) {
    Pool<C>& pool = this->pool<C>();
    if (!pool.contains(e)) return false;
    const C value = pool.take(e, tick_);
    pool.announceRemoval(*this, e, value);
    return true;
}

template <Component C>
bool World::remove(Entity e) {
    static_assert(!std::is_same_v<C, Parent> && !std::is_same_v<C, Children>,
                  "use setParent and clearParent");
    return take<C>(e);
}

template <Component... Cs, typename... Xs>
View<Cs...> World::view(Without<Xs...>) const {
    return View<Cs...>({findPool<Cs>()...}, {findPool<Xs>()...});
}

template <Component C>
bool World::changedSince(Entity e, Tick since) const {
    const Pool<C>* pool = findPool<C>();
    const uint32_t at = pool == nullptr ? SparseSet::kAbsent : pool->position(e);
    return at != SparseSet::kAbsent && pool->changedAt(at) > since;
}

template <Component C>
std::vector<Entity> World::changedSince(Tick since) const {
    const Pool<C>* pool = findPool<C>();
    return pool == nullptr ? std::vector<Entity>{} : pool->changedSince(since);
}

template <Component C>
std::vector<Entity> World::removedSince(Tick since) const {
    const Pool<C>* pool = findPool<C>();
    return pool == nullptr ? std::vector<Entity>{} : pool->removedSince(since);
}

template <Component C, typename F>
Connection World::onRemove(F function) {
    if constexpr (std::is_invocable_v<F, World&, Entity, const C&>) {
        return pool<C>().removed.connect(std::move(function));
    } else {
        return pool<C>().removed.connect(
            [call = std::move(function)](World& world, Entity e, const C&) { call(world, e); });
    }
}

template <typename T>
void World::setResource(T value) {
    const uint32_t type = typeIndex<T>();
    if (type >= resources_.size()) resources_.resize(type + 1);
    if (T* present = static_cast<T*>(resources_[type].get())) {
        *present = std::move(value);  // references to it stay valid
    } else {
        resources_[type] = std::make_shared<T>(std::move(value));
    }
}

template <typename T>
const T* World::findResource() const {
    const uint32_t type = typeIndex<T>();
    return type < resources_.size() ? static_cast<const T*>(resources_[type].get()) : nullptr;
}

template <typename T>
const T& World::resource() const {
    const T* found = findResource<T>();
    if (found == nullptr) fail(Entity{}, "resource", typeName<T>());
    return *found;
}

template <typename T>
T& World::resource() {
    return const_cast<T&>(std::as_const(*this).template resource<T>());
}

}  // namespace lampyris::ecs
