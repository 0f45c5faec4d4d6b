#include "gpu/device_features.h"

#include <fmt/format.h>

#include <array>

namespace lampyris::gpu {
namespace {

struct Feature {
    const char* name;
    VkBool32& (*in)(FeatureChain& chain);
    bool required;
};

#define LAMPYRIS_FEATURE(path, name, required)                                             \
    Feature {                                                                              \
#name, [](FeatureChain & chain) -> VkBool32& { return chain.path.name; }, required \
    }

const std::array kFeatures{
    LAMPYRIS_FEATURE(v13, synchronization2, true),  // every barrier and submit
    LAMPYRIS_FEATURE(v13, dynamicRendering, true),  // raster nodes have no VkRenderPass
    LAMPYRIS_FEATURE(v13, maintenance4, true),      // memory requirements before creation
    LAMPYRIS_FEATURE(v12, subgroupBroadcastDynamicId,
                     true),  // tile binning goes through lanes in a loop
    LAMPYRIS_FEATURE(core.features, geometryShader, false),  // gl_PrimitiveID in fragment shaders
    LAMPYRIS_FEATURE(core.features, fragmentStoresAndAtomics,
                     false),  // statistics in fragment shaders
};

#undef LAMPYRIS_FEATURE

struct SubgroupOperation {
    const char* name;
    VkSubgroupFeatureFlagBits bit;
};

// In compute shaders, for the tile binning of modules/photon_gi.
constexpr std::array kSubgroupOperations{
    SubgroupOperation{"VK_SUBGROUP_FEATURE_BASIC_BIT", VK_SUBGROUP_FEATURE_BASIC_BIT},
    SubgroupOperation{"VK_SUBGROUP_FEATURE_BALLOT_BIT", VK_SUBGROUP_FEATURE_BALLOT_BIT},
    SubgroupOperation{"VK_SUBGROUP_FEATURE_SHUFFLE_BIT", VK_SUBGROUP_FEATURE_SHUFFLE_BIT},
};

std::optional<std::string> missingSubgroupOperation(VkPhysicalDevice physical) {
    auto properties =
        vulkanStruct<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    auto subgroup = vulkanStruct<VkPhysicalDeviceVulkan11Properties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES);
    properties.pNext = &subgroup;
    vkGetPhysicalDeviceProperties2(physical, &properties);
    const bool inCompute = (subgroup.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0;
    for (const SubgroupOperation& operation : kSubgroupOperations)
        if (!inCompute || (subgroup.subgroupSupportedOperations & operation.bit) == 0)
            return fmt::format("{} in compute shaders", operation.name);
    return std::nullopt;
}

}  // namespace

FeatureChain::FeatureChain() {
    core.pNext = &v12;
    v12.pNext = &v13;
}

std::optional<std::string> missingFeature(VkPhysicalDevice physical) {
    FeatureChain there;
    vkGetPhysicalDeviceFeatures2(physical, &there.core);
    const auto missing = missingFeature(there);
    return missing ? missing : missingSubgroupOperation(physical);
}

std::optional<std::string> missingFeature(FeatureChain& enabled) {
    for (const Feature& feature : kFeatures)
        if (feature.required && feature.in(enabled) != VK_TRUE) return feature.name;
    return std::nullopt;
}

std::vector<std::string> enabledFeatures(FeatureChain& enabled) {
    std::vector<std::string> names;
    for (const Feature& feature : kFeatures)
        if (feature.in(enabled) == VK_TRUE) names.emplace_back(feature.name);
    return names;
}

std::vector<std::string> chooseFeatures(VkPhysicalDevice physical, FeatureChain& chain) {
    FeatureChain there;
    vkGetPhysicalDeviceFeatures2(physical, &there.core);
    for (const Feature& feature : kFeatures)
        if (feature.in(there) == VK_TRUE) feature.in(chain) = VK_TRUE;
    return enabledFeatures(there);
}

}  // namespace lampyris::gpu
