#include "gpu/validation.h"

#include <fmt/format.h>

#include <cstring>
#include <mutex>

#include "core/log.h"
#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

struct ValidationLog::State {
    std::mutex mutex;
    std::vector<std::string> messages;
    std::string label;  ///< of the commands being recorded
};

namespace {

constexpr const char* kLayer = "VK_LAYER_KHRONOS_validation";

template <typename Function>
Function load(VkInstance instance, const char* name) {
    return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
}

}  // namespace

core::Result<const char*> validationLayer() {
    uint32_t count = 0;
    VK_TRY(vkEnumerateInstanceLayerProperties(&count, nullptr));
    std::vector<VkLayerProperties> layers(count);
    VK_TRY(vkEnumerateInstanceLayerProperties(&count, layers.data()));
    for (const VkLayerProperties& layer : layers)
        if (std::strcmp(layer.layerName, kLayer) == 0) return kLayer;
    return core::error("validation was asked for, but the layer {} is not installed", kLayer);
}

ValidationLog::ValidationLog() : state_(std::make_unique<State>()) {}

ValidationLog::~ValidationLog() {
    if (messenger_ == VK_NULL_HANDLE) return;
    load<PFN_vkDestroyDebugUtilsMessengerEXT>(instance_, "vkDestroyDebugUtilsMessengerEXT")(
        instance_, messenger_, nullptr);
}

VkDebugUtilsMessengerCreateInfoEXT ValidationLog::messengerInfo() {
    auto info = vulkanStruct<VkDebugUtilsMessengerCreateInfoEXT>(
        VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT);
    info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                           VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT |
                       VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback =
        [](VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
           const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) -> VkBool32 {
        auto& state = *static_cast<State*>(user);
        const std::scoped_lock lock{state.mutex};
        state.messages.emplace_back(data->pMessage);
        if (!state.label.empty()) state.messages.back() += fmt::format(" (in {})", state.label);
        core::logWarning("validation: {}", state.messages.back());
        return VK_FALSE;
    };
    info.pUserData = state_.get();
    return info;
}

core::Result<void> ValidationLog::watch(VkInstance instance) {
    instance_ = instance;
    const auto create =
        load<PFN_vkCreateDebugUtilsMessengerEXT>(instance, "vkCreateDebugUtilsMessengerEXT");
    if (create == nullptr) return core::error("vkCreateDebugUtilsMessengerEXT is missing");
    const VkDebugUtilsMessengerCreateInfoEXT info = messengerInfo();
    VK_TRY(create(instance, &info, nullptr, &messenger_));
    return {};
}

std::vector<std::string> ValidationLog::messages() const {
    const std::scoped_lock lock{state_->mutex};
    return state_->messages;
}

void ValidationLog::setLabel(const std::string& label) {
    const std::scoped_lock lock{state_->mutex};
    state_->label = label;
}

void ValidationLog::clear() {
    const std::scoped_lock lock{state_->mutex};
    state_->messages.clear();
}

}  // namespace lampyris::gpu
