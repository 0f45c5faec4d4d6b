/// \file The VkInstance: API version, layers, extensions, the validation log.
#pragma once

#include <vulkan/vulkan.h>

#include <memory>

#include "core/result.h"
#include "gpu/validation.h"

namespace lampyris::gpu {

struct InstanceOptions {
    bool validation =
        false;  ///< core and synchronization validation; an Error where the layer is missing
    bool presentable = false;  ///< enable the surface extensions that the loader knows
};

class Instance {
 public:
    static core::Result<Instance> create(const InstanceOptions& options);
    /// One that somebody else made and keeps; `canName`: it has VK_EXT_debug_utils.
    static Instance adopt(VkInstance instance, bool canName);
    Instance(Instance&& other) noexcept;
    Instance& operator=(Instance&&) = delete;
    ~Instance();

    [[nodiscard]] VkInstance get() const { return instance_; }
    /// Null without validation.
    [[nodiscard]] ValidationLog* log() const { return log_.get(); }
    /// Whether VK_EXT_debug_utils is on, so that objects can be named.
    [[nodiscard]] bool canName() const { return canName_; }

 private:
    Instance() = default;
    VkInstance instance_ = VK_NULL_HANDLE;
    bool adopted_ = false;
    std::unique_ptr<ValidationLog> log_;
    bool canName_ = false;
};

}  // namespace lampyris::gpu
