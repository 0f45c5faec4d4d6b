// A game that made its Vulkan device itself: `own_device OUT.png` draws a picture on it.
#include "core/image_io.h"
#include "core/log.h"
#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"
#include "photon_gi/renderer.h"
#include "scene/live_snapshot.h"
#include "scene/load.h"

using namespace lampyris;
using gpu::vulkanStruct;

// What a game has of Vulkan: here the first device, and its first queue.
struct Game {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;

    Game() = default;
    Game(const Game&) = delete;
    Game& operator=(const Game&) = delete;
    ~Game() {
        vkDestroyDevice(device, nullptr);
        vkDestroyInstance(instance, nullptr);
    }
};

// Makes the game's device with what the engine needs, and lends it.
core::Result<std::unique_ptr<gpu::Device>> lendDevice(Game& game) {
    auto application = vulkanStruct<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.apiVersion = VK_API_VERSION_1_3;
    auto instanceInfo = vulkanStruct<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    instanceInfo.pApplicationInfo = &application;
    VK_TRY(vkCreateInstance(&instanceInfo, nullptr, &game.instance));
    uint32_t count = 1;
    const VkResult listed = vkEnumeratePhysicalDevices(game.instance, &count, &game.physical);
    if (listed != VK_INCOMPLETE) VK_TRY(listed);

    const float priority = 1.0f;
    auto queueInfo =
        vulkanStruct<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    gpu::FeatureChain features;                    // a game turns on what it wants itself,
    gpu::chooseFeatures(game.physical, features);  // and this adds the rest
    auto info =
        vulkanStruct<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features.core);
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    VK_TRY(vkCreateDevice(game.physical, &info, nullptr, &game.device));
    VkQueue queue = VK_NULL_HANDLE;
    vkGetDeviceQueue(game.device, 0, 0, &queue);
    return gpu::Device::adopt({game.instance, game.physical, game.device, queue, 0, &info});
}

core::Result<void> play(const std::string& picture) {
    Game game;
    TRY(const auto device, lendDevice(game));  // goes before the game's own does
    TRY(auto executor, execute::Executor::create(*device));
    photon_gi::Renderer renderer(executor);
    TRY(ecs::World world, scene::loadScene("cornell"));
    scene::LiveSnapshot live;
    const auto& now = live.follow(world, 0.0);
    TRY(const auto drawn, renderer.draw(now, {.camera = now.cameras[0]}, "final"));
    // A game goes on from executor.outputImage(drawn.radiance), on the same queue.
    return core::writeImage(picture, drawn.image, {.exposureEv = -1.0f});
}

int main(int argc, char** argv) {
    const auto played = play(argc > 1 ? argv[1] : "own_device.png");
    if (!played.ok()) core::logError("{}", played.error().message);
    return played.ok() ? 0 : 1;
}
