#include "gpu/device.h"

#include <algorithm>
#include <string>

#include "support/gpu_test.h"

namespace lampyris {
namespace {

class DeviceTest : public test::GpuTest {};

TEST_F(DeviceTest, SaysWhatItIs) {
    const gpu::DeviceInfo& info = device().info();
    EXPECT_FALSE(info.name.empty());
    EXPECT_FALSE(info.driver.empty());
    EXPECT_EQ(info.apiVersion.substr(0, 2), "1.");
    EXPECT_NE(std::find(info.features.begin(), info.features.end(), "synchronization2"),
              info.features.end());
    EXPECT_GE(info.limits.core.maxStorageBufferRange, 1u << 27);  // guaranteed
    const auto limits = gpu::listLimits(info.limits);
    EXPECT_TRUE(
        std::all_of(limits.begin(), limits.end(), [](const auto& l) { return l.second > 0; }));
}

TEST_F(DeviceTest, IsFoundByAPartOfItsNameInAnyCase) {
    std::string part = device().info().name.substr(0, 5);
    std::transform(part.begin(), part.end(), part.begin(), ::toupper);
    const auto again = gpu::Device::create({.substring = part});
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ((*again)->info().name, device().info().name);
}

TEST_F(DeviceTest, ListsTheDevicesWhereNoneMatches) {
    const auto none = gpu::Device::create({.substring = "no such device"});
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().message.find("\"no such device\""), std::string::npos);
    EXPECT_NE(none.error().message.find(device().info().name), std::string::npos);
}

TEST_F(DeviceTest, KeepsNoMessagesWithoutValidation) {
    const auto plain = test::need(gpu::Device::create({}));
    EXPECT_FALSE(plain->validated());
    EXPECT_TRUE(plain->validationMessages().empty());
    EXPECT_TRUE(device().validated());
}

TEST_F(DeviceTest, KeepsTheMessagesOfTheLayer) {
    // A buffer of no bytes is against the rules.
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    if (vkCreateBuffer(device().get(), &info, nullptr, &buffer) == VK_SUCCESS)
        vkDestroyBuffer(device().get(), buffer, nullptr);
    const auto messages = takeMessages();
    ASSERT_FALSE(messages.empty());
    EXPECT_NE(messages.front().find("VUID-VkBufferCreateInfo-size"), std::string::npos);
}

}  // namespace
}  // namespace lampyris
