#include "gpu/pipeline_cache.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/file.h"
#include "core/log.h"
#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {
namespace {

/// Stands before the driver's own bytes: some drivers check no more than their header, and crash on
/// the rest.
struct FileHeader {
    std::array<char, 8> magic{'L', 'M', 'P', 'Y', 'R', 'P', 'C', '1'};
    uint64_t bytes = 0;
    uint64_t hash = 0;
};

/// FNV-1a, 64 bits.
uint64_t hashOf(std::span<const uint8_t> bytes) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
    return hash;
}

std::vector<uint8_t> readPayload(const std::filesystem::path& file) {
    std::error_code code;
    if (!std::filesystem::is_regular_file(file, code)) return {};
    auto bytes = core::readFile(file);
    FileHeader header;
    const FileHeader expected;
    if (!bytes.ok() || bytes->size() < sizeof header) return {};
    std::memcpy(&header, bytes->data(), sizeof header);
    const std::span payload = std::span{*bytes}.subspan(sizeof header);
    if (header.magic != expected.magic || header.bytes != payload.size() ||
        header.hash != hashOf(payload)) {
        core::logDebug("{}: damaged, ignored", file.string());
        return {};
    }
    return {payload.begin(), payload.end()};
}

std::string fileName(VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    std::string name = fmt::format("pipelines-{:04x}-{:04x}-{:x}-", properties.vendorID,
                                   properties.deviceID, properties.driverVersion);
    for (const uint8_t byte : properties.pipelineCacheUUID) name += fmt::format("{:02x}", byte);
    return name + ".bin";
}

}  // namespace

std::filesystem::path defaultCacheFolder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache != '\0') return std::filesystem::path{cache} / "lampyris";
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home != '\0')
        return std::filesystem::path{home} / ".cache" / "lampyris";
    return {};
}

core::Result<PipelineCache> PipelineCache::open(VkPhysicalDevice physical, VkDevice device,
                                                const std::filesystem::path& folder) {
    PipelineCache cache;
    std::vector<uint8_t> payload;
    if (!folder.empty()) {
        cache.file_ = folder / fileName(physical);
        payload = readPayload(cache.file_);
    }
    auto info =
        vulkanStruct<VkPipelineCacheCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO);
    info.initialDataSize = payload.size();
    info.pInitialData = payload.empty() ? nullptr : payload.data();
    VkPipelineCache object = VK_NULL_HANDLE;
    VK_TRY(vkCreatePipelineCache(device, &info, nullptr, &object));
    cache.cache_ = {device, object};
    cache.loaded_ = !payload.empty();
    return cache;
}

core::Result<void> PipelineCache::save() const {
    if (file_.empty() || !cache_) return {};
    size_t size = 0;
    VK_TRY(vkGetPipelineCacheData(cache_.device(), cache_.get(), &size, nullptr));
    std::vector<uint8_t> bytes(sizeof(FileHeader) + size);
    VK_TRY(vkGetPipelineCacheData(cache_.device(), cache_.get(), &size,
                                  bytes.data() + sizeof(FileHeader)));
    bytes.resize(sizeof(FileHeader) + size);
    FileHeader header;
    header.bytes = size;
    header.hash = hashOf(std::span{bytes}.subspan(sizeof header));
    std::memcpy(bytes.data(), &header, sizeof header);
    std::error_code code;
    std::filesystem::create_directories(file_.parent_path(), code);
    if (code) return core::error("{}: {}", file_.parent_path().string(), code.message());
    return core::writeFile(file_, std::span<const uint8_t>{bytes});
}

}  // namespace lampyris::gpu
