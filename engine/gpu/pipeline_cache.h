/// \file Compiled pipelines kept on disk between runs. A missing, foreign or corrupt file is
/// ignored.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/result.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

/// $XDG_CACHE_HOME/lampyris, or $HOME/.cache/lampyris, or empty where neither is set.
[[nodiscard]] std::filesystem::path defaultCacheFolder();

class PipelineCache {
 public:
    PipelineCache() = default;
    /// Reads the device's file in `folder`; an empty folder keeps nothing on disk.
    static core::Result<PipelineCache> open(VkPhysicalDevice physical, VkDevice device,
                                            const std::filesystem::path& folder);
    [[nodiscard]] VkPipelineCache get() const { return cache_.get(); }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// Whether the file was there and sound.
    [[nodiscard]] bool loaded() const { return loaded_; }
    /// Writes the file (beside, then renamed).
    core::Result<void> save() const;

 private:
    Handle<VkPipelineCache, vkDestroyPipelineCache> cache_;
    std::filesystem::path file_;
    bool loaded_ = false;
};

}  // namespace lampyris::gpu
