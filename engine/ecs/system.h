/// \file What a system's parameters mean. A system is a function whose parameter types declare its
/// access.
///
///     void moveLights(ecs::Write<Transform>, ecs::Read<LightPath>, ecs::With<SphereLight>,
///     FrameTime);
///
/// Read, Write, With, Without (by value): the function is called once for each entity that matches
/// them all. With none of them it is called once. Besides these it may take, in any order:
///     Entity                  the entity it is called for
///     T or const T&, T&       a resource of the world, read or written
///     Commands&               changes put off until all its calls are done
///     const World&, World&    everything, read or written
#pragma once

#include "ecs/commands.h"

namespace lampyris::ecs {

/// A component to be read.
template <Component C>
class Read {
 public:
    explicit Read(const C& value) : value_(&value) {}
    const C& operator*() const { return *value_; }
    const C* operator->() const { return value_; }

 private:
    const C* value_;
};

/// A component to be written. `*` and `->` mark it changed; get() looks without doing so. onChange
/// observers are told once, when the system has been called for all its entities.
template <Component C>
class Write {
 public:
    Write(Pool<C>& pool, Entity entity, Tick now, std::vector<Entity>& changed)
        : pool_(&pool),
          at_(pool.position(entity)),
          entity_(entity),
          now_(now),
          changed_(&changed) {}
    [[nodiscard]] const C& get() const { return pool_->at(at_); }
    const C& operator*() const { return get(); }
    const C* operator->() const { return &get(); }
    C& operator*() { return touch(); }
    C* operator->() { return &touch(); }

 private:
    C& touch() {
        if (!touched_) {
            pool_->stamp(at_, now_);
            changed_->push_back(entity_);
            touched_ = true;
        }
        return pool_->at(at_);
    }

    Pool<C>* pool_;
    uint32_t at_;
    Entity entity_;
    Tick now_;
    std::vector<Entity>* changed_;
    bool touched_ = false;
};

/// Asks for entities with these components.
template <Component... Cs>
struct With {};

struct TypeUse {
    uint32_t type;
    std::string_view name;
};

/// What a system touches.
struct Access {
    std::vector<TypeUse> reads, writes;
    bool readsAll = false;   ///< takes const World&
    bool writesAll = false;  ///< takes World& or Commands&

    template <typename T>
    void read() {
        reads.push_back({typeIndex<T>(), typeName<T>()});
    }
    template <typename T>
    void write() {
        writes.push_back({typeIndex<T>(), typeName<T>()});
    }
};

/// The names of what two systems may not touch at once; empty where they are independent.
std::vector<std::string_view> conflicts(const Access& a, const Access& b);

}  // namespace lampyris::ecs
