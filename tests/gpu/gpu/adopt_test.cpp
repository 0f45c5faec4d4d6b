// A game's own Vulkan device: it is used, checked, and left as it was.
#include "gpu/adopted_device.h"

#include <numeric>
#include <optional>

#include "gpu/device_choice.h"
#include "gpu/instance.h"
#include "gpu/staging.h"
#include "support/gpu_test.h"

namespace lampyris {
namespace {

using test::errorOf;
using test::need;

/// What a game would have: an instance, and a device that it made itself.
class AdoptTest : public ::testing::Test {
 protected:
    void SetUp() override {
        if (!test::sharedDevice().ok()) GTEST_SKIP() << test::sharedDevice().error().message;
        instance_.emplace(need(gpu::Instance::create({.validation = true})));
        const auto chosen = need(gpu::chooseDevice(instance_->get(), ""));
        gpu::chooseFeatures(chosen.physical, features_);
        queue_.queueFamilyIndex = chosen.queueFamily;
        queue_.queueCount = 1;
        queue_.pQueuePriorities = &priority_;
        info_.pNext = &features_.core;
        info_.queueCreateInfoCount = 1;
        info_.pQueueCreateInfos = &queue_;
        made_ = {.instance = instance_->get(),
                 .physical = chosen.physical,
                 .queueFamily = chosen.queueFamily,
                 .madeWith = &info_,
                 .debugUtils = instance_->canName()};
        ASSERT_EQ(vkCreateDevice(made_.physical, &info_, nullptr, &made_.device), VK_SUCCESS);
        vkGetDeviceQueue(made_.device, made_.queueFamily, 0, &made_.queue);
    }

    void TearDown() override {
        if (made_.device == VK_NULL_HANDLE) return;
        EXPECT_EQ(vkDeviceWaitIdle(made_.device), VK_SUCCESS) << "the game's device lives on";
        vkDestroyDevice(made_.device, nullptr);
        for (const std::string& message : instance_->log()->messages()) ADD_FAILURE() << message;
    }

    std::optional<gpu::Instance> instance_;
    gpu::FeatureChain features_;
    float priority_ = 1.0f;
    VkDeviceQueueCreateInfo queue_ =
        gpu::vulkanStruct<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    VkDeviceCreateInfo info_ =
        gpu::vulkanStruct<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    gpu::AdoptedDevice made_;
};

TEST_F(AdoptTest, WorksAndLeavesTheDeviceToItsOwner) {
    for (int i = 0; i < 2; ++i) {
        const auto device = need(gpu::Device::adopt(made_));
        EXPECT_EQ(device->get(), made_.device);
        EXPECT_EQ(device->info().name, test::sharedDevice().value()->info().name);
        EXPECT_EQ(device->info().features, test::sharedDevice().value()->info().features);
        EXPECT_FALSE(device->presentable());
        std::vector<uint32_t> values(100);
        std::iota(values.begin(), values.end(), 1u);
        const auto buffer = need(gpu::Buffer::create(*device, {.bytes = 400, .name = "theirs"}));
        need(gpu::upload(*device, buffer, std::span<const uint32_t>{values}));
        auto staging = need(gpu::Staging::create(*device));
        const auto back = need(staging.read(buffer, 0, 400));
        EXPECT_EQ(test::valuesOf<uint32_t>(back), values);
    }
}

TEST_F(AdoptTest, NamesTheHandleThatIsMissing) {
    gpu::AdoptedDevice made = made_;
    made.queue = VK_NULL_HANDLE;
    EXPECT_NE(errorOf(gpu::Device::adopt(made)).find("AdoptedDevice::queue"), std::string::npos);
    made = made_;
    made.madeWith = nullptr;
    EXPECT_NE(errorOf(gpu::Device::adopt(made)).find("AdoptedDevice::madeWith"), std::string::npos);
}

TEST_F(AdoptTest, NamesTheQueueFamilyThatDoesNotSuit) {
    made_.queueFamily = 1000;
    EXPECT_NE(errorOf(gpu::Device::adopt(made_)).find("family 1000"), std::string::npos);
    made_.queueFamily = queue_.queueFamilyIndex;
}

TEST_F(AdoptTest, TakesNoQueueThatTheDeviceWasNotMadeWith) {
    gpu::AdoptedDevice made = made_;
    made.queue = test::sharedDevice().value()->queue();  // another device's
    EXPECT_NE(errorOf(gpu::Device::adopt(made)).find("AdoptedDevice::queue is none of family"),
              std::string::npos);
    made = made_;
    VkDeviceCreateInfo info = info_;
    made.madeWith = &info;
    info.queueCreateInfoCount = 0;
    EXPECT_NE(errorOf(gpu::Device::adopt(made)).find("without a queue of family"),
              std::string::npos);
    info.queueCreateInfoCount = 1;
    VkDeviceQueueCreateInfo queue = queue_;
    info.pQueueCreateInfos = &queue;
    queue.flags = VK_DEVICE_QUEUE_CREATE_PROTECTED_BIT;
    EXPECT_NE(errorOf(gpu::Device::adopt(made)).find("without a queue of family"),
              std::string::npos);
}

TEST_F(AdoptTest, NamesTheFeatureThatIsOff) {
    gpu::FeatureChain features;
    gpu::chooseFeatures(made_.physical, features);
    features.v13.maintenance4 = VK_FALSE;
    VkDeviceCreateInfo info = info_;
    info.pNext = &features.core;
    gpu::AdoptedDevice made = made_;
    made.madeWith = &info;
    const std::string why = errorOf(gpu::Device::adopt(made));
    EXPECT_NE(why.find("the feature maintenance4"), std::string::npos) << why;
    EXPECT_NE(why.find("chooseFeatures"), std::string::npos) << why;
    info.pNext = nullptr;
    EXPECT_NE(errorOf(gpu::Device::adopt(made)).find("synchronization2"), std::string::npos);
}

TEST(MadeWith, FeaturesAreReadFromEveryStructThatHoldsThem) {
    auto maintenance = gpu::vulkanStruct<VkPhysicalDeviceMaintenance4Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_FEATURES);
    maintenance.maintenance4 = VK_TRUE;
    auto rendering = gpu::vulkanStruct<VkPhysicalDeviceDynamicRenderingFeatures>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES, &maintenance);
    rendering.dynamicRendering = VK_TRUE;
    auto synchronization = gpu::vulkanStruct<VkPhysicalDeviceSynchronization2Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES, &rendering);
    synchronization.synchronization2 = VK_TRUE;
    auto v12 = gpu::vulkanStruct<VkPhysicalDeviceVulkan12Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &synchronization);
    v12.subgroupBroadcastDynamicId = VK_TRUE;
    VkPhysicalDeviceFeatures core{};
    core.geometryShader = VK_TRUE;
    VkDeviceCreateInfo info{};
    info.pNext = &v12;
    info.pEnabledFeatures = &core;

    gpu::FeatureChain enabled;
    gpu::readFeatures(info, enabled);
    EXPECT_FALSE(gpu::missingFeature(enabled).has_value());
    EXPECT_EQ(gpu::enabledFeatures(enabled),
              (std::vector<std::string>{"synchronization2", "dynamicRendering", "maintenance4",
                                        "subgroupBroadcastDynamicId", "geometryShader"}));
    EXPECT_EQ(enabled.core.pNext, &enabled.v12) << "the chain is its own";
    EXPECT_EQ(enabled.v12.pNext, &enabled.v13);
}

TEST(MadeWith, ExtensionsAreFoundByTheirWholeName) {
    const char* const names[] = {"VK_KHR_swapchain_mutable_format", "VK_KHR_swapchain"};
    VkDeviceCreateInfo info{};
    info.ppEnabledExtensionNames = names;
    info.enabledExtensionCount = 1;
    EXPECT_FALSE(gpu::hasExtension(info, "VK_KHR_swapchain"));
    info.enabledExtensionCount = 2;
    EXPECT_TRUE(gpu::hasExtension(info, "VK_KHR_swapchain"));
}

}  // namespace
}  // namespace lampyris
