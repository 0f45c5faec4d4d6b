/// \file Which entities have all of some components and none of others.
#pragma once

#include <array>
#include <tuple>

#include "ecs/pool.h"

namespace lampyris::ecs {

/// Asks for entities without these components: in world.view<A>(without<B, C>) and as a system's
/// parameter.
template <typename... Cs>
struct Without {};
template <typename... Cs>
inline constexpr Without<Cs...> without{};

/// The sets that an entity must be in, and those it must not be in. Walks the smallest, in dense
/// order.
class Query {
 public:
    static constexpr size_t kMaxTerms = 16;

    /// Null is a pool that no entity was ever in.
    void include(const SparseSet* set);
    void exclude(const SparseSet* set);

    /// The entities to be tried, of which `matches` picks.
    [[nodiscard]] std::span<const Entity> candidates() const {
        return driver_ == nullptr ? std::span<const Entity>{} : driver_->entities();
    }
    [[nodiscard]] bool matches(Entity e) const;
    /// Differs as soon as a set of the query gains or loses an entity.
    [[nodiscard]] uint64_t structureVersion() const;
    /// Ends the program where the structure changed while the query was walked; Commands put such
    /// changes off.
    void checkUnchanged(uint64_t version) const;

    /// Calls function(Entity) for every match.
    template <typename F>
    void each(F&& function) const {
        const uint64_t version = structureVersion();
        const std::span<const Entity> tried = candidates();
        for (const Entity e : tried) {
            if (!matches(e)) continue;
            function(e);
            checkUnchanged(version);
        }
    }

 private:
    std::array<const SparseSet*, kMaxTerms>
        sets_{};  ///< included from the front, excluded from the back
    size_t included_ = 0;
    size_t excluded_ = 0;
    const SparseSet* driver_ = nullptr;
    bool nothing_ = false;  ///< an included pool does not exist
};

/// Reads components: for (auto [entity, a, b] : world.view<A, B>()) or .each([](Entity, const A&,
/// const B&) {}). Values may be changed through World::edit meanwhile; adding or removing one of
/// the view's components is caught at the next step, so leave the loop after it, or use Commands.
template <Component... Cs>
class View {
 public:
    View(std::tuple<const Pool<Cs>*...> pools, std::initializer_list<const SparseSet*> excluded)
        : pools_(pools) {
        (query_.include(std::get<const Pool<Cs>*>(pools_)), ...);
        for (const SparseSet* set : excluded) query_.exclude(set);
    }

    class Iterator {
     public:
        Iterator(const View& view, size_t at)
            : view_(&view), at_(at), version_(view.query_.structureVersion()) {
            skip();
        }
        std::tuple<Entity, const Cs&...> operator*() const {
            return view_->row(view_->query_.candidates()[at_]);
        }
        Iterator& operator++() {
            view_->query_.checkUnchanged(version_);
            ++at_;
            skip();
            return *this;
        }
        bool operator==(const Iterator& other) const { return at_ == other.at_; }

     private:
        void skip() {
            const std::span<const Entity> tried = view_->query_.candidates();
            while (at_ < tried.size() && !view_->query_.matches(tried[at_])) ++at_;
        }
        const View* view_;
        size_t at_;
        uint64_t version_;
    };

    [[nodiscard]] Iterator begin() const { return {*this, 0}; }
    [[nodiscard]] Iterator end() const { return {*this, query_.candidates().size()}; }

    template <typename F>
    void each(F&& function) const {
        query_.each([&](Entity e) { std::apply(function, row(e)); });
    }
    [[nodiscard]] size_t count() const {
        size_t matches = 0;
        query_.each([&](Entity) { ++matches; });
        return matches;
    }

 private:
    [[nodiscard]] std::tuple<Entity, const Cs&...> row(Entity e) const {
        return {e, *std::get<const Pool<Cs>*>(pools_)->find(e)...};
    }

    std::tuple<const Pool<Cs>*...> pools_;
    Query query_;
};

}  // namespace lampyris::ecs
