#include "gpu/device_features.h"

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
    LAMPYRIS_FEATURE(v13, synchronization2, true),           // every barrier and submit
    LAMPYRIS_FEATURE(v13, dynamicRendering, true),           // raster nodes have no VkRenderPass
    LAMPYRIS_FEATURE(v13, maintenance4, true),               // memory requirements before creation
    LAMPYRIS_FEATURE(core.features, geometryShader, false),  // gl_PrimitiveID in fragment shaders
    LAMPYRIS_FEATURE(core.features, fragmentStoresAndAtomics,
                     false),  // statistics in fragment shaders
};

#undef LAMPYRIS_FEATURE

}  // namespace

FeatureChain::FeatureChain() {
    core.pNext = &v12;
    v12.pNext = &v13;
}

std::optional<std::string> missingFeature(VkPhysicalDevice physical) {
    FeatureChain there;
    vkGetPhysicalDeviceFeatures2(physical, &there.core);
    for (const Feature& feature : kFeatures)
        if (feature.required && feature.in(there) != VK_TRUE) return feature.name;
    return std::nullopt;
}

std::vector<std::string> chooseFeatures(VkPhysicalDevice physical, FeatureChain& chain) {
    FeatureChain there;
    vkGetPhysicalDeviceFeatures2(physical, &there.core);
    std::vector<std::string> names;
    for (const Feature& feature : kFeatures) {
        if (feature.in(there) != VK_TRUE) continue;
        feature.in(chain) = VK_TRUE;
        names.emplace_back(feature.name);
    }
    return names;
}

}  // namespace lampyris::gpu
