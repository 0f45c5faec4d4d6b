/// \file Observers: functions that are told when a component is added, changed or removed.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace lampyris::ecs {

/// Keeps an observer alive; the observer is never called again once this is gone. May outlive the
/// world.
class [[nodiscard]] Connection {
 public:
    Connection() = default;
    explicit Connection(std::shared_ptr<void> slot) : slot_(std::move(slot)) {}
    Connection(Connection&&) noexcept = default;
    Connection& operator=(Connection&&) noexcept = default;
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection() = default;

    void disconnect() { slot_.reset(); }
    [[nodiscard]] bool connected() const { return slot_ != nullptr; }

 private:
    std::shared_ptr<void> slot_;
};

/// A list of observers, called in the order in which they were connected. An observer may connect
/// and disconnect others, and itself, while it is called; one connected meanwhile is first told of
/// the next event.
template <typename... Args>
class Signal {
 public:
    using Function = std::function<void(Args...)>;

    Connection connect(Function function) {
        if (depth_ == 0) std::erase_if(slots_, [](const auto& slot) { return slot.expired(); });
        auto slot = std::make_shared<Function>(std::move(function));
        slots_.push_back(slot);
        return Connection(std::move(slot));
    }

    [[nodiscard]] bool empty() const { return slots_.empty(); }

    /// Calls the observers as long as `goOn()` holds.
    template <typename GoOn>
    void notifyWhile(const GoOn& goOn, Args... args) {
        ++depth_;
        const size_t count = slots_.size();
        for (size_t i = 0; i < count && goOn(); ++i)
            if (const std::shared_ptr<Function> slot = slots_[i].lock()) (*slot)(args...);
        --depth_;
    }

 private:
    std::vector<std::weak_ptr<Function>> slots_;
    int depth_ = 0;
};

}  // namespace lampyris::ecs
