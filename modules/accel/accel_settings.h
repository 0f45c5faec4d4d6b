/// \file How trees follow what moves.
#pragma once

#include <cstdint>
#include <string_view>

namespace lampyris::accel {

/// Who refits. Automatic: the CPU where the device is one [measured, README], else the device.
enum class RefitPath : uint8_t { Automatic, Cpu, Device };

/// Frames from a rebuild's request to its landing, where that is fixed. [chosen] a million
/// triangles build in 1.5 s on two cores: eight frames of 0.2 s
constexpr uint32_t kRebuildFrames = 8;

struct RebuildPolicy {
    /// Lands exactly kRebuildFrames updates after its request, which then waits for it where it
    /// must: equal runs give equal frames. Else with the first update that finds it ready.
    bool deterministic = true;
    /// A tree is rebuilt when a ray is expected to cost so many times what it did after the last
    /// build. [chosen] half as much again
    double costRatio = 1.5;
    /// Rebuilds in flight hold at most so many triangles, or one tree. [chosen] keeps one core busy
    /// for some seconds at most
    uint64_t trianglesInFlight = 2'000'000;
};

/// \param deviceKind  as gpu::DeviceInfo::kind
[[nodiscard]] inline bool refitsOnCpu(std::string_view deviceKind,
                                      RefitPath path = RefitPath::Automatic) {
    return path == RefitPath::Automatic ? deviceKind == "cpu" : path == RefitPath::Cpu;
}

struct AccelSettings {
    RefitPath refit = RefitPath::Automatic;
    RebuildPolicy rebuild{};
};

}  // namespace lampyris::accel
