#include "gpu/instance.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {
namespace {

// By name: the platform headers that define macros for these drag X11 in.
constexpr std::array kSurfaceExtensions{"VK_KHR_surface", "VK_KHR_xcb_surface",
                                        "VK_KHR_xlib_surface"};
// Mesa's device selection looks for a Wayland server wherever this is on, and complains of none.
constexpr const char* kWaylandExtension = "VK_KHR_wayland_surface";

core::Result<std::vector<const char*>> chooseExtensions(bool presentable, const char* layer) {
    std::vector<VkExtensionProperties> known;
    for (const char* source : {static_cast<const char*>(nullptr), layer}) {
        uint32_t count = 0;
        VK_TRY(vkEnumerateInstanceExtensionProperties(source, &count, nullptr));
        std::vector<VkExtensionProperties> some(count);
        VK_TRY(vkEnumerateInstanceExtensionProperties(source, &count, some.data()));
        known.insert(known.end(), some.begin(), some.end());
    }
    const auto has = [&](const char* name) {
        return std::any_of(known.begin(), known.end(), [&](const VkExtensionProperties& e) {
            return std::strcmp(e.extensionName, name) == 0;
        });
    };
    std::vector<const char*> chosen;
    if (has(VK_EXT_DEBUG_UTILS_EXTENSION_NAME)) chosen.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (layer != nullptr) chosen.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    if (!presentable) return chosen;
    std::copy_if(kSurfaceExtensions.begin(), kSurfaceExtensions.end(), std::back_inserter(chosen),
                 has);
    const bool wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
    if (wayland && has(kWaylandExtension)) chosen.push_back(kWaylandExtension);
    return chosen;
}

}  // namespace

core::Result<Instance> Instance::create(const InstanceOptions& options) {
    Instance instance;
    const char* layer = nullptr;
    if (options.validation) {
        TRY(layer, validationLayer());
        instance.log_ = std::make_unique<ValidationLog>();
    }
    TRY(const auto extensions, chooseExtensions(options.presentable, layer));
    auto application = vulkanStruct<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.pApplicationName = "lampyris";
    application.pEngineName = "lampyris";
    application.apiVersion = VK_API_VERSION_1_3;
    const VkValidationFeatureEnableEXT enabled =
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    auto features =
        vulkanStruct<VkValidationFeaturesEXT>(VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT);
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &enabled;
    VkDebugUtilsMessengerCreateInfoEXT messenger{};
    auto info = vulkanStruct<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    if (layer != nullptr) {
        messenger = instance.log_->messengerInfo();
        features.pNext = &messenger;
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &layer;
    }
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    VK_TRY(vkCreateInstance(&info, nullptr, &instance.instance_));
    instance.canName_ = !extensions.empty() &&
                        std::strcmp(extensions.front(), VK_EXT_DEBUG_UTILS_EXTENSION_NAME) == 0;
    if (instance.log_) TRY_VOID(instance.log_->watch(instance.instance_));
    return instance;
}

Instance Instance::adopt(VkInstance instance, bool canName) {
    Instance adopted;
    adopted.instance_ = instance;
    adopted.adopted_ = true;
    adopted.canName_ = canName;
    return adopted;
}

Instance::Instance(Instance&& other) noexcept
    : instance_(std::exchange(other.instance_, VK_NULL_HANDLE)),
      adopted_(other.adopted_),
      log_(std::move(other.log_)),
      canName_(other.canName_) {}

Instance::~Instance() {
    log_.reset();
    if (instance_ != VK_NULL_HANDLE && !adopted_) vkDestroyInstance(instance_, nullptr);
}

}  // namespace lampyris::gpu
