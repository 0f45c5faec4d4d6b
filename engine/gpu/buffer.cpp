#include "gpu/buffer.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/check.h"
#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {
namespace {

constexpr VkBufferUsageFlags kEveryUsage =
    VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT |
    VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
    VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT |
    VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;

constexpr uint64_t kSmallestBuffer = 16;

VkBufferCreateInfo createInfo(uint64_t bytes) {
    auto info = vulkanStruct<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = std::max(bytes, kSmallestBuffer);
    info.usage = kEveryUsage;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    return info;
}

using ViewHandle = Handle<VkBufferView, vkDestroyBufferView>;

}  // namespace

struct Buffer::Views {
    std::map<std::tuple<VkFormat, uint64_t, uint64_t>, ViewHandle> made;
};

Buffer::Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(memory_, other.memory_);
    std::swap(buffer_, other.buffer_);
    std::swap(views_, other.views_);
    std::swap(bytes_, other.bytes_);
    std::swap(name_, other.name_);
    return *this;
}
Buffer::~Buffer() = default;

core::Result<Buffer> Buffer::createUnbound(Device& device, const BufferOptions& options) {
    const VkBufferCreateInfo info = createInfo(options.bytes);
    if (info.size > device.limits().maxBufferSize)
        return core::error("buffer {}: {} bytes are more than the device's maxBufferSize, {}",
                           options.name, info.size, device.limits().maxBufferSize);
    Buffer buffer;
    buffer.device_ = &device;
    buffer.bytes_ = info.size;
    buffer.name_ = options.name;
    buffer.views_ = std::make_unique<Views>();
    VkBuffer object = VK_NULL_HANDLE;
    VK_TRY(vkCreateBuffer(device.get(), &info, nullptr, &object));
    buffer.buffer_ = {device.get(), object};
    setName(device, VK_OBJECT_TYPE_BUFFER, object, options.name);
    return buffer;
}

core::Result<Buffer> Buffer::create(Device& device, const BufferOptions& options) {
    TRY(Buffer buffer, createUnbound(device, options));
    TRY(buffer.memory_, device.memory().allocate(buffer.memoryRequirements(), options.memory, true,
                                                 options.name.c_str()));
    VK_TRY(vkBindBufferMemory(device.get(), buffer.get(), buffer.memory_.memory(),
                              buffer.memory_.offset()));
    return buffer;
}

core::Result<void> Buffer::bind(const Allocation& memory, uint64_t offset) {
    VK_TRY(vkBindBufferMemory(device_->get(), get(), memory.memory(), memory.offset() + offset));
    return {};
}

VkMemoryRequirements Buffer::memoryRequirements() const {
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device_->get(), get(), &needs);
    return needs;
}

std::span<std::byte> Buffer::mapped() const {
    std::byte* first = memory_.valid() ? memory_.mapped() : nullptr;
    return first == nullptr ? std::span<std::byte>{} : std::span{first, bytes_};
}

core::Result<VkBufferView> Buffer::view(VkFormat format, uint32_t texelBytes, uint64_t offset,
                                        uint64_t bytes) const {
    CHECK((offset + bytes) <= bytes_);
    const uint64_t whole = (bytes == 0 ? bytes_ - offset : bytes) / texelBytes;
    const uint64_t most = device_->limits().core.maxTexelBufferElements;
    if (whole > most)
        return core::error(
            "buffer {}: {} texels are more than the device's "
            "maxTexelBufferElements, {}",
            name_, whole, most);
    ViewHandle& view = views_->made[{format, offset, whole}];
    if (view) return view.get();
    auto info = vulkanStruct<VkBufferViewCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO);
    info.buffer = get();
    info.format = format;
    info.offset = offset;
    info.range = whole * texelBytes;
    VkBufferView object = VK_NULL_HANDLE;
    VK_TRY(vkCreateBufferView(device_->get(), &info, nullptr, &object));
    view = {device_->get(), object};
    setName(*device_, VK_OBJECT_TYPE_BUFFER_VIEW, object, name_);
    return object;
}

VkMemoryRequirements bufferMemoryRequirements(const Device& device, uint64_t bytes) {
    const VkBufferCreateInfo info = createInfo(bytes);
    auto question = vulkanStruct<VkDeviceBufferMemoryRequirements>(
        VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS);
    question.pCreateInfo = &info;
    auto answer = vulkanStruct<VkMemoryRequirements2>(VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2);
    vkGetDeviceBufferMemoryRequirements(device.get(), &question, &answer);
    return answer.memoryRequirements;
}

}  // namespace lampyris::gpu
