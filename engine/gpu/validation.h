/// \file The Khronos validation layer as an option: synchronization validation included, messages
/// kept.
#pragma once

#include <vulkan/vulkan.h>

#include <memory>
#include <string>
#include <vector>

#include "core/result.h"

namespace lampyris::gpu {

/// "VK_LAYER_KHRONOS_validation", or an Error where it is not installed.
core::Result<const char*> validationLayer();

/// Keeps every warning and error of the layer, from any thread.
class ValidationLog {
 public:
    ValidationLog();
    ~ValidationLog();
    ValidationLog(const ValidationLog&) = delete;
    ValidationLog& operator=(const ValidationLog&) = delete;

    /// To be chained to the instance's creation, so that it too is watched. Points at this.
    [[nodiscard]] VkDebugUtilsMessengerCreateInfoEXT messengerInfo();
    /// Watches the instance until this is destroyed, which must be before the instance.
    core::Result<void> watch(VkInstance instance);

    [[nodiscard]] std::vector<std::string> messages() const;
    /// Goes with every message from now on; empty: none. The layer's messages come while a command
    /// is recorded, and do not say in which node.
    void setLabel(const std::string& label);
    void clear();

 private:
    struct State;
    std::unique_ptr<State> state_;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

}  // namespace lampyris::gpu
