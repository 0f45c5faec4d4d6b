#include "reference/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace lampyris::reference {

void shareOut(uint32_t count, uint32_t threads, const std::function<void(uint32_t)>& visit) {
    std::atomic<uint64_t> next{0};
    std::mutex mutex;
    std::exception_ptr thrown;
    const auto work = [&] {
        try {
            for (uint64_t i = next++; i < count; i = next++) visit(static_cast<uint32_t>(i));
        } catch (...) {
            const std::lock_guard lock(mutex);
            thrown = std::current_exception();
            next = count;
        }
    };
    const uint32_t wanted = threads > 0 ? threads : std::thread::hardware_concurrency();
    std::vector<std::thread> others;
    others.reserve(wanted);
    try {
        while (others.size() + 1 < std::min(wanted, count)) others.emplace_back(work);
    } catch (const std::system_error&) {
        // The system gives no more threads: those there are do it all.
    }
    work();
    for (std::thread& other : others) other.join();
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace lampyris::reference
