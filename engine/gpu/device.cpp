#include "gpu/device.h"

#include <cstring>

#include "core/log.h"
#include "gpu/device_choice.h"
#include "gpu/device_features.h"
#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {
namespace {

core::Result<void> requireSwapchain(VkPhysicalDevice physical, const std::string& name) {
    uint32_t count = 0;
    VK_TRY(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr));
    std::vector<VkExtensionProperties> extensions(count);
    VK_TRY(vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data()));
    for (const VkExtensionProperties& extension : extensions)
        if (std::strcmp(extension.extensionName, VK_KHR_SWAPCHAIN_EXTENSION_NAME) == 0) return {};
    return core::error("{}: cannot show images in a window (lacks {})", name,
                       VK_KHR_SWAPCHAIN_EXTENSION_NAME);
}

}  // namespace

core::Result<std::unique_ptr<Device>> Device::create(const DeviceOptions& options) {
    TRY(auto instance, Instance::create({options.validation, options.presentable}));
    auto device = std::unique_ptr<Device>{new Device{std::move(instance)}};
    TRY_VOID(device->createDevice(options));
    return device;
}

core::Result<std::unique_ptr<Device>> Device::adopt(const AdoptedDevice& made) {
    TRY_VOID(checkAdopted(made));
    auto device =
        std::unique_ptr<Device>{new Device{Instance::adopt(made.instance, made.debugUtils)}};
    device->adopted_ = true;
    device->physical_ = made.physical;
    device->queueFamily_ = made.queueFamily;
    device->device_ = made.device;
    device->queue_ = made.queue;
    device->presentable_ = hasExtension(*made.madeWith, VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    device->info_ = readDeviceInfo(made.physical, made.queueFamily);
    FeatureChain enabled;
    readFeatures(*made.madeWith, enabled);
    device->info_.features = enabledFeatures(enabled);
    TRY_VOID(device->begin());
    return device;
}

core::Result<void> Device::createDevice(const DeviceOptions& options) {
    TRY(const ChosenDevice chosen, chooseDevice(instance_.get(), options.substring));
    physical_ = chosen.physical;
    queueFamily_ = chosen.queueFamily;
    info_ = readDeviceInfo(physical_, queueFamily_);
    FeatureChain features;
    info_.features = chooseFeatures(physical_, features);

    const float priority = 1.0f;
    auto queueInfo =
        vulkanStruct<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queueInfo.queueFamilyIndex = queueFamily_;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    const char* swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    auto info =
        vulkanStruct<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features.core);
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    if (options.presentable) {
        TRY_VOID(requireSwapchain(physical_, info_.name));
        info.enabledExtensionCount = 1;
        info.ppEnabledExtensionNames = &swapchain;
        presentable_ = true;
    }
    VK_TRY(vkCreateDevice(physical_, &info, nullptr, &device_));
    vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
    TRY_VOID(begin());
    gpu::setName(*this, VK_OBJECT_TYPE_DEVICE, device_, "device");
    gpu::setName(*this, VK_OBJECT_TYPE_QUEUE, queue_, "queue");
    return {};
}

core::Result<void> Device::begin() {
    if (instance_.canName()) {
        setObjectName_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
            vkGetDeviceProcAddr(device_, "vkSetDebugUtilsObjectNameEXT"));
        beginLabel_ = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(
            vkGetDeviceProcAddr(device_, "vkCmdBeginDebugUtilsLabelEXT"));
        endLabel_ = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(
            vkGetDeviceProcAddr(device_, "vkCmdEndDebugUtilsLabelEXT"));
    }
    memory_ =
        std::make_unique<MemoryAllocator>(physical_, device_, info_.limits.maxMemoryAllocationSize);
    TRY(pipelineCache_, PipelineCache::open(physical_, device_, defaultCacheFolder()));
    return {};
}

Device::~Device() {
    if (device_ == VK_NULL_HANDLE) return;
    settle();
    const auto saved = pipelineCache_.save();
    if (!saved.ok()) core::logDebug("pipeline cache not kept: {}", saved.error().message);
    pipelineCache_ = {};
    memory_.reset();
    if (!adopted_) vkDestroyDevice(device_, nullptr);
}

void Device::setName(VkObjectType type, uint64_t object, const std::string& name) const {
    if (setObjectName_ == nullptr) return;
    auto info = vulkanStruct<VkDebugUtilsObjectNameInfoEXT>(
        VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT);
    info.objectType = type;
    info.objectHandle = object;
    info.pObjectName = name.c_str();
    const VkResult result = setObjectName_(device_, &info);
    if (result != VK_SUCCESS)
        core::logDebug("{}", vulkanError(result, "vkSetDebugUtilsObjectNameEXT").message);
}

void Device::beginLabel(VkCommandBuffer commands, const std::string& name) const {
    if (validated()) instance_.log()->setLabel(name);
    if (beginLabel_ == nullptr) return;
    auto label = vulkanStruct<VkDebugUtilsLabelEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT);
    label.pLabelName = name.c_str();
    beginLabel_(commands, &label);
}

void Device::endLabel(VkCommandBuffer commands) const {
    if (validated()) instance_.log()->setLabel({});
    if (endLabel_ != nullptr) endLabel_(commands);
}

core::Result<void> Device::waitIdle() {
    VK_TRY(vkDeviceWaitIdle(device_));
    return {};
}

void Device::settle() {
    const VkResult result = vkDeviceWaitIdle(device_);
    if (result == VK_SUCCESS) return;
    const std::string message = vulkanError(result, "vkDeviceWaitIdle").message;
    if (result == VK_ERROR_DEVICE_LOST)
        core::logDebug("{}", message);
    else
        core::logWarning("{}", message);
}

std::vector<std::string> Device::validationMessages() const {
    return validated() ? instance_.log()->messages() : std::vector<std::string>{};
}

void Device::clearValidationMessages() {
    if (validated()) instance_.log()->clear();
}

}  // namespace lampyris::gpu
