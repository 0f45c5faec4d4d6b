#include "residency/range_allocator.h"

#include <iterator>

#include "core/check.h"

namespace lampyris::residency {

uint64_t RangeAllocator::take(uint64_t length) {
    if (length == 0) return 0;
    used_ += length;
    for (auto gap = gaps_.begin(); gap != gaps_.end(); ++gap) {
        if (gap->second < length) continue;
        const auto [first, size] = *gap;
        gaps_.erase(gap);
        if (size > length) gaps_.emplace(first + length, size - length);
        return first;
    }
    // The last gap, where it touches the end, is the start of what grows.
    uint64_t first = capacity_;
    if (!gaps_.empty()) {
        const auto last = std::prev(gaps_.end());
        if (last->first + last->second == capacity_) {
            first = last->first;
            gaps_.erase(last);
        }
    }
    capacity_ = first + length;
    return first;
}

void RangeAllocator::give(uint64_t first, uint64_t length) {
    if (length == 0) return;
    CHECK((first + length) <= capacity_);
    CHECK(length <= used_);
    used_ -= length;
    auto [gap, added] = gaps_.emplace(first, length);
    CHECK(added);
    const auto next = std::next(gap);
    if (next != gaps_.end() && gap->first + gap->second == next->first) {
        gap->second += next->second;
        gaps_.erase(next);
    }
    if (gap == gaps_.begin()) return;
    const auto previous = std::prev(gap);
    if (previous->first + previous->second == gap->first) {
        previous->second += gap->second;
        gaps_.erase(gap);
    }
}

}  // namespace lampyris::residency
