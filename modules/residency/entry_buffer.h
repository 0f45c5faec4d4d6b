/// \file A storage buffer of equal entries, of which only those that changed go over.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "residency/resident_buffer.h"

namespace lampyris::residency {

template <typename T>
class EntryBuffer {
 public:
    /// Entries with equal keys are equal.
    using Key = std::array<uint64_t, 4>;

    EntryBuffer(Device& device, std::string name) : buffer_(device, std::move(name)) {}

    /// Packs and stages the entries whose key is new. \return the bytes staged.
    template <typename KeyOf, typename Pack>
    core::Result<uint64_t> follow(size_t count, const KeyOf& keyOf, const Pack& pack) {
        TRY_VOID(buffer_.reserve(std::max<size_t>(count, 1) * sizeof(T)));
        const size_t known = std::min(keys_.size(), count);
        keys_.resize(count);
        std::vector<T> run;
        uint64_t bytes = 0;
        for (size_t i = 0; i <= count; ++i) {
            const bool changed = i < count && (i >= known || keys_[i] != keyOf(i));
            if (changed) {
                keys_[i] = keyOf(i);
                run.push_back(pack(i));
            } else if (!run.empty()) {
                TRY_VOID(
                    buffer_.stage((i - run.size()) * sizeof(T), std::as_bytes(std::span(run))));
                bytes += run.size() * sizeof(T);
                run.clear();
            }
        }
        return bytes;
    }

    [[nodiscard]] graph::Buffer import(graph::Frame& frame, const std::string& node) {
        return buffer_.import(frame, node);
    }
    [[nodiscard]] uint64_t bytes() const { return buffer_.bytes(); }

 private:
    ResidentBuffer buffer_;
    std::vector<Key> keys_;
};

}  // namespace lampyris::residency
