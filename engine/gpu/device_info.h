/// \file What a device is and can do, as text and numbers.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lampyris::gpu {

/// Vulkan's limits, those of the core and those that came later.
struct Limits {
    VkPhysicalDeviceLimits core{};
    uint64_t maxMemoryAllocationSize = 0;
    uint64_t maxBufferSize = 0;
    uint64_t largestHeapBytes = 0;  ///< of device-local memory
    uint32_t subgroupSize = 0;
    uint32_t timestampValidBits = 0;
};

struct DeviceInfo {
    std::string name;
    std::string kind;                   ///< "discrete", "integrated", "virtual", "cpu" or "other"
    std::string driver;                 ///< name and version, as the driver gives them
    std::string apiVersion;             ///< "1.3.230"
    std::vector<std::string> features;  ///< turned on
    Limits limits;
};

/// Asks the device; `features` is left to who turns them on.
[[nodiscard]] DeviceInfo readDeviceInfo(VkPhysicalDevice physical, uint32_t queueFamily);

/// The limits that the engine depends on, by Vulkan's names, for `lampyris info`.
[[nodiscard]] std::vector<std::pair<std::string, uint64_t>> listLimits(const Limits& limits);

}  // namespace lampyris::gpu
