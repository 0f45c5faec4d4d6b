/// \file Changes put off until nobody iterates: recorded now, applied in order later.
#pragma once

#include <memory>
#include <vector>

#include "ecs/world.h"

namespace lampyris::ecs {

/// An entity that Commands will create; means nothing to other Commands.
struct NewEntity {
    uint32_t number = 0;
};

/// A list of changes. A change to an entity that has died by the time it is applied is dropped.
class Commands {
 public:
    /// What a command is for: an entity of the world, or one that an earlier command creates.
    class Target {
     public:
        Target(Entity entity) : entity_(entity) {}
        Target(NewEntity created) : created_(created.number), isNew_(true) {}

     private:
        friend class Commands;
        Entity entity_;
        uint32_t created_ = 0;
        bool isNew_ = false;
    };

    NewEntity create() { return {created_++}; }
    /// Adds the component, or replaces it.
    template <Component C>
    void add(Target target, C value = {}) {
        record([target, value = std::move(value)](World& world,
                                                  const std::vector<Entity>& created) mutable {
            if (const Entity e = resolve(target, created); world.alive(e))
                world.set(e, std::move(value));
        });
    }
    template <Component C>
    void remove(Target target) {
        record([target](World& world, const std::vector<Entity>& created) {
            world.remove<C>(resolve(target, created));
        });
    }
    void destroy(Target target);
    /// A parent that would close a cycle is a warning in the log, and nothing changes.
    void setParent(Target child, Target parent);

    [[nodiscard]] bool empty() const { return operations_.empty() && created_ == 0; }

    /// Carries everything out in the order of the calls (creations first) and starts an empty list.
    /// Gives back the created entities in the order of create().
    std::vector<Entity> apply(World& world);

 private:
    struct Operation {
        virtual ~Operation() = default;
        virtual void run(World& world, const std::vector<Entity>& created) = 0;
    };
    template <typename F>
    void record(F function) {
        struct Recorded final : Operation {
            explicit Recorded(F f) : call(std::move(f)) {}
            void run(World& world, const std::vector<Entity>& created) override {
                call(world, created);
            }
            F call;
        };
        operations_.push_back(std::make_unique<Recorded>(std::move(function)));
    }
    static Entity resolve(const Target& target, const std::vector<Entity>& created);

    std::vector<std::unique_ptr<Operation>> operations_;
    uint32_t created_ = 0;
};

}  // namespace lampyris::ecs
