/// \file How each kind of system parameter is declared, matched and fetched; included by schedule.h
/// alone.
#pragma once

#include "ecs/system.h"

namespace lampyris::ecs::detail {

/// One parameter during one run of its system.
struct AnyParameter {
    static constexpr bool kPicksEntities = false;
    static constexpr bool kNeedsEntity = false;
    void constrain(Query&) const {}
    void finish(World&) {}
};

template <typename T>
inline constexpr bool kIsTerm = false;
template <typename C>
inline constexpr bool kIsTerm<Read<C>> = true;
template <typename C>
inline constexpr bool kIsTerm<Write<C>> = true;
template <typename... Cs>
inline constexpr bool kIsTerm<With<Cs...>> = true;
template <typename... Cs>
inline constexpr bool kIsTerm<Without<Cs...>> = true;

/// A resource: T and const T& are read, T& is written.
template <typename P>
struct Parameter : AnyParameter {
    using T = std::remove_cvref_t<P>;
    static_assert(!kIsTerm<T>, "take Read, Write, With and Without by value");
    static_assert(!std::is_same_v<T, World> && !std::is_same_v<T, Commands>,
                  "take World and Commands by reference");
    static constexpr bool kWrites =
        std::is_lvalue_reference_v<P> && !std::is_const_v<std::remove_reference_t<P>>;

    explicit Parameter(World& world) : value(world.resource<T>()) {}
    static void declare(Access& access) {
        if constexpr (kWrites) {
            access.write<T>();
        } else {
            access.read<T>();
        }
    }
    std::conditional_t<kWrites, T&, const T&> at(Entity) { return value; }
    T& value;
};

template <typename C>
struct Parameter<Read<C>> : AnyParameter {
    static constexpr bool kPicksEntities = true;
    explicit Parameter(World& world) : pool(world.pool<C>()) {}
    static void declare(Access& access) { access.read<C>(); }
    void constrain(Query& query) const { query.include(&pool); }
    Read<C> at(Entity e) { return Read<C>(*pool.find(e)); }
    const Pool<C>& pool;
};

template <typename C>
struct Parameter<Write<C>> : AnyParameter {
    static constexpr bool kPicksEntities = true;
    explicit Parameter(World& world) : pool(world.pool<C>()), now(world.tick()) {}
    static void declare(Access& access) { access.write<C>(); }
    void constrain(Query& query) const { query.include(&pool); }
    Write<C> at(Entity e) { return Write<C>(pool, e, now, changed); }
    void finish(World& world) {
        for (const Entity e : changed) world.announceChange<C>(e);
    }
    Pool<C>& pool;
    Tick now;
    std::vector<Entity> changed;
};

template <typename... Cs>
struct Parameter<With<Cs...>> : AnyParameter {
    static constexpr bool kPicksEntities = true;
    explicit Parameter(World& w) : world(w) {}
    static void declare(Access& access) { (access.read<Cs>(), ...); }
    void constrain(Query& query) const { (query.include(&world.pool<Cs>()), ...); }
    With<Cs...> at(Entity) { return {}; }
    World& world;
};

template <typename... Cs>
struct Parameter<Without<Cs...>> : AnyParameter {
    static constexpr bool kNeedsEntity = true;
    explicit Parameter(World& w) : world(w) {}
    static void declare(Access& access) { (access.read<Cs>(), ...); }
    void constrain(Query& query) const { (query.exclude(&world.pool<Cs>()), ...); }
    Without<Cs...> at(Entity) { return {}; }
    World& world;
};

template <>
struct Parameter<Entity> : AnyParameter {
    static constexpr bool kNeedsEntity = true;
    explicit Parameter(World&) {}
    static void declare(Access&) {}
    Entity at(Entity e) { return e; }
};

template <>
struct Parameter<Commands&> : AnyParameter {
    explicit Parameter(World&) {}
    static void declare(Access& access) { access.writesAll = true; }
    Commands& at(Entity) { return commands; }
    void finish(World& world) { commands.apply(world); }
    Commands commands;
};

template <>
struct Parameter<World&> : AnyParameter {
    explicit Parameter(World& w) : world(w) {}
    static void declare(Access& access) { access.writesAll = true; }
    World& at(Entity) { return world; }
    World& world;
};

template <>
struct Parameter<const World&> : AnyParameter {
    explicit Parameter(World& w) : world(w) {}
    static void declare(Access& access) { access.readsAll = true; }
    const World& at(Entity) { return world; }
    const World& world;
};

/// Runs a system on the world: once, or once an entity.
template <typename... Ps>
void runSystem(World& world, const std::function<void(Ps...)>& function) {
    constexpr bool kPicks = (Parameter<Ps>::kPicksEntities || ...);
    static_assert(kPicks || !(Parameter<Ps>::kNeedsEntity || ...),
                  "Entity and Without need a Read, Write or With");
    std::tuple<Parameter<Ps>...> parameters{Parameter<Ps>(world)...};
    const auto call = [&](Entity e) {
        std::apply([&](auto&... parameter) { function(parameter.at(e)...); }, parameters);
    };
    if constexpr (kPicks) {
        Query query;
        std::apply([&](auto&... parameter) { (parameter.constrain(query), ...); }, parameters);
        query.each(call);
    } else {
        call(Entity{});
    }
    std::apply([&](auto&... parameter) { (parameter.finish(world), ...); }, parameters);
}

}  // namespace lampyris::ecs::detail
