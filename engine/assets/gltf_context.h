/// \file What the reading of one glTF file shares: its name, its limits, its errors and warnings.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "assets/gltf.h"
#include "core/log.h"
#include "core/result.h"

namespace lampyris::assets {

/// Messages read "name: place: what is wrong"; a place is a JSON pointer.
class GltfContext {
 public:
    GltfContext(std::string name, const GltfLimits& limits)
        : name_(std::move(name)), limits_(limits) {}
    GltfContext(const GltfContext&) = delete;
    GltfContext& operator=(const GltfContext&) = delete;
    /// Says how many warnings were held back.
    ~GltfContext();

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const GltfLimits& limits() const { return limits_; }

    template <typename... Args>
    [[nodiscard]] core::Error error(const std::string& place, fmt::format_string<Args...> format,
                                    Args&&... args) const {
        return core::Error{line(place, fmt::format(format, std::forward<Args>(args)...))};
    }

    /// Goes to the log, up to a limit: a file of a million faults is one screen of text.
    template <typename... Args>
    void warn(const std::string& place, fmt::format_string<Args...> format, Args&&... args) {
        logWarning(line(place, fmt::format(format, std::forward<Args>(args)...)));
    }

    /// Counts memory that decoding is about to take; an error above the limit.
    [[nodiscard]] core::Result<void> takeBytes(const std::string& place, uint64_t bytes);

 private:
    [[nodiscard]] std::string line(const std::string& place, const std::string& message) const;
    void logWarning(const std::string& text);

    std::string name_;
    GltfLimits limits_;
    uint64_t bytesTaken_ = 0;
    uint32_t warnings_ = 0;
};

}  // namespace lampyris::assets
