/// \file Ranges of a growing buffer, counted in elements: first fit, free neighbours joined.
#pragma once

#include <cstdint>
#include <map>

namespace lampyris::residency {

class RangeAllocator {
 public:
    /// The first element of a range; the capacity grows where no gap is large enough. A length of 0
    /// takes nothing.
    [[nodiscard]] uint64_t take(uint64_t length);
    /// Gives a range back, as it was taken.
    void give(uint64_t first, uint64_t length);
    /// Elements from 0 to the end of the last range ever needed.
    [[nodiscard]] uint64_t capacity() const { return capacity_; }
    [[nodiscard]] uint64_t used() const { return used_; }

 private:
    std::map<uint64_t, uint64_t> gaps_;  ///< first element → length
    uint64_t capacity_ = 0;
    uint64_t used_ = 0;
};

}  // namespace lampyris::residency
