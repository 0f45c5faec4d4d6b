#include "gpu/query_pool.h"

#include "core/check.h"
#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

core::Result<TimestampPool> TimestampPool::create(Device& device, uint32_t capacity) {
    TimestampPool pool;
    auto info = vulkanStruct<VkQueryPoolCreateInfo>(VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO);
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = capacity;
    VkQueryPool object = VK_NULL_HANDLE;
    VK_TRY(vkCreateQueryPool(device.get(), &info, nullptr, &object));
    pool.pool_ = {device.get(), object};
    setName(device, VK_OBJECT_TYPE_QUERY_POOL, object, "timestamps");
    const Limits& limits = device.limits();
    pool.capacity_ = capacity;
    pool.millisecondsPerTick_ = static_cast<double>(limits.core.timestampPeriod) * 1e-6;
    pool.mask_ = limits.timestampValidBits >= 64 ? UINT64_MAX
                                                 : (uint64_t{1} << limits.timestampValidBits) - 1;
    return pool;
}

void TimestampPool::reset(VkCommandBuffer commands) const {
    vkCmdResetQueryPool(commands, pool_.get(), 0, capacity_);
}

void TimestampPool::write(VkCommandBuffer commands, uint32_t index) const {
    CHECK(index < capacity_);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_.get(), index);
}

core::Result<std::vector<double>> TimestampPool::readIntervalsMilliseconds(uint32_t count) const {
    CHECK(count <= capacity_);
    std::vector<uint64_t> stamps(count);
    std::vector<double> intervals;
    if (count == 0) return intervals;
    VK_TRY(vkGetQueryPoolResults(pool_.device(), pool_.get(), 0, count,
                                 stamps.size() * sizeof(uint64_t), stamps.data(), sizeof(uint64_t),
                                 VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT));
    for (uint32_t i = 0; i + 1 < count; ++i)
        // The mask makes a counter that wrapped around come out right.
        intervals.push_back(static_cast<double>((stamps[i + 1] - stamps[i]) & mask_) *
                            millisecondsPerTick_);
    return intervals;
}

}  // namespace lampyris::gpu
