/// \file The device: everything else in gpu/ is made from one. It must outlive all of it.
#pragma once

#include <vulkan/vulkan.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "gpu/adopted_device.h"
#include "gpu/device_info.h"
#include "gpu/instance.h"
#include "gpu/memory.h"
#include "gpu/pipeline_cache.h"

namespace lampyris::gpu {

struct DeviceOptions {
    std::string substring{};   ///< part of the device's name, any case; empty: the best there is
    bool validation = false;   ///< core and synchronization validation
    bool presentable = false;  ///< able to show images in a window
};

class Device {
 public:
    /// An Error lists the devices where none matches, or names the missing layer, feature or limit.
    static core::Result<std::unique_ptr<Device>> create(const DeviceOptions& options);
    /// A device that somebody else made and keeps: this only uses it, and destroys nothing of it.
    /// An Error names what it lacks. waitIdle() waits for all its queues, so nobody may submit to
    /// any of them meanwhile.
    static core::Result<std::unique_ptr<Device>> adopt(const AdoptedDevice& made);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] VkDevice get() const { return device_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] VkInstance instance() const { return instance_.get(); }
    [[nodiscard]] VkQueue queue() const { return queue_; }
    [[nodiscard]] uint32_t queueFamily() const { return queueFamily_; }
    [[nodiscard]] MemoryAllocator& memory() { return *memory_; }
    [[nodiscard]] PipelineCache& pipelineCache() { return pipelineCache_; }
    [[nodiscard]] const DeviceInfo& info() const { return info_; }
    [[nodiscard]] const Limits& limits() const { return info_.limits; }

    /// Names an object for the validation layer and for debuggers.
    void setName(VkObjectType type, uint64_t object, const std::string& name) const;
    /// Of class Label.
    void beginLabel(VkCommandBuffer commands, const std::string& name) const;
    void endLabel(VkCommandBuffer commands) const;
    /// Waits until the device has done all it was given.
    core::Result<void> waitIdle();
    /// The same before what it uses is destroyed, where no Error can be returned: that it cannot is
    /// a warning. A lost device is none: the call that met it has said so.
    void settle();

    /// Whether it can show images in a window.
    [[nodiscard]] bool presentable() const { return presentable_; }
    /// Whether the validation layer watches, and its messages are kept here.
    [[nodiscard]] bool validated() const { return instance_.log() != nullptr; }
    /// Warnings and errors of the validation layer so far; empty without validation.
    [[nodiscard]] std::vector<std::string> validationMessages() const;
    void clearValidationMessages();

 private:
    explicit Device(Instance instance) : instance_(std::move(instance)) {}
    core::Result<void> createDevice(const DeviceOptions& options);
    /// What every device has, whoever made it.
    core::Result<void> begin();

    Instance instance_;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    uint32_t queueFamily_ = 0;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    bool adopted_ = false;
    bool presentable_ = false;
    DeviceInfo info_;
    std::unique_ptr<MemoryAllocator> memory_;
    PipelineCache pipelineCache_;
    PFN_vkSetDebugUtilsObjectNameEXT setObjectName_ = nullptr;  ///< these three: all or none
    PFN_vkCmdBeginDebugUtilsLabelEXT beginLabel_ = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT endLabel_ = nullptr;
};

/// Device::setName for any handle type.
template <typename T>
void setName(const Device& device, VkObjectType type, T object, const std::string& name) {
    device.setName(type, reinterpret_cast<uint64_t>(object), name);
}

}  // namespace lampyris::gpu
