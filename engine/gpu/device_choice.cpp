#include "gpu/device_choice.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "gpu/device_features.h"
#include "gpu/vulkan_result.h"

namespace lampyris::gpu {
namespace {

std::string lower(std::string_view text) {
    std::string result{text};
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

int rank(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return 3;
        default:
            return 4;
    }
}

std::vector<VkQueueFamilyProperties> queueFamilies(VkPhysicalDevice physical) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    return families;
}

std::optional<uint32_t> findQueueFamily(VkPhysicalDevice physical) {
    const auto count = static_cast<uint32_t>(queueFamilies(physical).size());
    for (uint32_t i = 0; i < count; ++i)
        if (suits(physical, i)) return i;
    return std::nullopt;
}

struct Candidate {
    VkPhysicalDevice physical;
    VkPhysicalDeviceProperties properties;
};

core::Result<std::vector<Candidate>> listDevices(VkInstance instance) {
    uint32_t count = 0;
    VK_TRY(vkEnumeratePhysicalDevices(instance, &count, nullptr));
    std::vector<VkPhysicalDevice> devices(count);
    VK_TRY(vkEnumeratePhysicalDevices(instance, &count, devices.data()));
    std::vector<Candidate> candidates;
    for (VkPhysicalDevice physical : devices) {
        candidates.push_back({physical, {}});
        vkGetPhysicalDeviceProperties(physical, &candidates.back().properties);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) {
                         return rank(a.properties.deviceType) < rank(b.properties.deviceType);
                     });
    return candidates;
}

core::Result<ChosenDevice> qualify(const Candidate& candidate) {
    TRY_VOID(checkPhysical(candidate.physical));
    const auto family = findQueueFamily(candidate.physical);
    if (!family)
        return core::error(
            "{}: has no queue for graphics and compute with timestamps "
            "(timestampValidBits)",
            candidate.properties.deviceName);
    return ChosenDevice{candidate.physical, *family};
}

}  // namespace

core::Result<void> checkPhysical(VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(physical, &properties);
    const char* name = properties.deviceName;
    if (properties.apiVersion < VK_API_VERSION_1_3)
        return core::error("{}: has Vulkan {}.{}, needs 1.3", name,
                           VK_API_VERSION_MAJOR(properties.apiVersion),
                           VK_API_VERSION_MINOR(properties.apiVersion));
    if (const auto missing = missingFeature(physical))
        return core::error("{}: lacks the feature {}", name, *missing);
    return {};
}

bool suits(VkPhysicalDevice physical, uint32_t queueFamily) {
    const std::vector<VkQueueFamilyProperties> families = queueFamilies(physical);
    constexpr VkQueueFlags kWanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    return queueFamily < families.size() &&
           (families[queueFamily].queueFlags & kWanted) == kWanted &&
           families[queueFamily].timestampValidBits > 0;
}

core::Result<ChosenDevice> chooseDevice(VkInstance instance, std::string_view substring) {
    TRY(const auto candidates, listDevices(instance));
    if (candidates.empty()) return core::error("no Vulkan device found");
    std::string names;
    std::optional<core::Error> refusal;
    for (const Candidate& candidate : candidates) {
        const std::string_view name = candidate.properties.deviceName;
        names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name);
        if (lower(name).find(lower(substring)) == std::string::npos) continue;
        auto chosen = qualify(candidate);
        if (chosen.ok()) return chosen;
        if (!refusal) refusal = chosen.error();
    }
    if (refusal) return *refusal;
    return core::error("no device matches \"{}\"; there are: {}", substring, names);
}

}  // namespace lampyris::gpu
