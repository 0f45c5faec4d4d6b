#include "gpu/commands.h"

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

core::Result<Commands> Commands::create(Device& device, const std::string& name) {
    Commands commands;
    auto poolInfo =
        vulkanStruct<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    poolInfo.queueFamilyIndex = device.queueFamily();
    VkCommandPool pool = VK_NULL_HANDLE;
    VK_TRY(vkCreateCommandPool(device.get(), &poolInfo, nullptr, &pool));
    commands.pool_ = {device.get(), pool};
    setName(device, VK_OBJECT_TYPE_COMMAND_POOL, pool, name);
    auto info =
        vulkanStruct<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    info.commandPool = pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    VK_TRY(vkAllocateCommandBuffers(device.get(), &info, &commands.buffer_));
    setName(device, VK_OBJECT_TYPE_COMMAND_BUFFER, commands.buffer_, name);
    return commands;
}

core::Result<VkCommandBuffer> Commands::begin() {
    VK_TRY(vkResetCommandPool(pool_.device(), pool_.get(), 0));
    auto info = vulkanStruct<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    VK_TRY(vkBeginCommandBuffer(buffer_, &info));
    return buffer_;
}

core::Result<void> Commands::end() {
    VK_TRY(vkEndCommandBuffer(buffer_));
    return {};
}

Label::Label(const Device& device, VkCommandBuffer commands, const std::string& name)
    : device_(device), commands_(commands) {
    device_.beginLabel(commands_, name);
}

Label::~Label() {
    device_.endLabel(commands_);
}

core::Result<void> submit(Device& device, const Commands& commands, const SubmitOptions& options) {
    auto buffer =
        vulkanStruct<VkCommandBufferSubmitInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO);
    buffer.commandBuffer = commands.get();
    auto wait = vulkanStruct<VkSemaphoreSubmitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO);
    wait.semaphore = options.wait;
    wait.stageMask = options.waitStages;
    auto signal = vulkanStruct<VkSemaphoreSubmitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO);
    signal.semaphore = options.signal;
    signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    auto info = vulkanStruct<VkSubmitInfo2>(VK_STRUCTURE_TYPE_SUBMIT_INFO_2);
    info.waitSemaphoreInfoCount = options.wait == VK_NULL_HANDLE ? 0 : 1;
    info.pWaitSemaphoreInfos = &wait;
    info.commandBufferInfoCount = 1;
    info.pCommandBufferInfos = &buffer;
    info.signalSemaphoreInfoCount = options.signal == VK_NULL_HANDLE ? 0 : 1;
    info.pSignalSemaphoreInfos = &signal;
    VK_TRY(vkQueueSubmit2(device.queue(), 1, &info, options.fence));
    return {};
}

core::Result<void> submitAndWait(Device& device, const Commands& commands) {
    TRY(const Fence fence, createFence(device, false, "one submit"));
    TRY_VOID(submit(device, commands, {.fence = fence.get()}));
    return waitAndReset(device, fence);
}

void fullBarrier(VkCommandBuffer commands) {
    auto barrier = vulkanStruct<VkMemoryBarrier2>(VK_STRUCTURE_TYPE_MEMORY_BARRIER_2);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = barrier.srcStageMask;
    barrier.dstAccessMask = barrier.srcAccessMask;
    auto dependency = vulkanStruct<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace lampyris::gpu
