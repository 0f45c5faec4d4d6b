// `lampyris info`: the device that a run would use, and the display that a window would.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <thread>

#include "accel/accel_settings.h"
#include "command.h"
#include "gpu/device.h"
#include "shader_watch.h"
#include "window/monitors.h"

namespace lampyris::sandbox {
namespace {

void printDisplay() {
    const auto monitors = window::listMonitors();
    if (!monitors.ok()) return fmt::print("display: none, {}\n", monitors.error().message);
    if (monitors.value().empty()) fmt::print("display: without a monitor\n");
    for (const window::MonitorInfo& m : monitors.value())
        fmt::print("display: {}, {}x{}{}\n", m.name, m.width, m.height,
                   m.hertz > 0 ? fmt::format(" at {} Hz", m.hertz) : "");
}

core::Result<void> printInfo(const gpu::DeviceOptions& options) {
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create(options));
    const gpu::DeviceInfo& info = device->info();
    fmt::print("device: {}\n", info.name);
    fmt::print("kind: {}\n", info.kind);
    fmt::print("driver: {}\n", info.driver);
    fmt::print("api version: {}\n", info.apiVersion);
    fmt::print("validation layer: {}\n", gpu::validationLayer().ok() ? "there" : "missing");
    fmt::print("deforming meshes are refitted on: {}\n",
               accel::refitsOnCpu(info.kind) ? "CPU" : "device");
    fmt::print("worker threads: {}\n", std::thread::hardware_concurrency());
    printDisplay();
    const std::filesystem::path shaders = ShaderWatch::builtFrom();
    fmt::print("shaders reload from: {}\n", shaders.empty() ? "nowhere" : shaders.string());
    for (const std::string& feature : info.features) fmt::print("feature: {}\n", feature);
    for (const auto& [name, value] : gpu::listLimits(info.limits))
        fmt::print("limit {}: {}\n", name, value);
    return {};
}

}  // namespace

void addInfo(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand("info", "Device, driver, display, features used, limits");
    const auto options = std::make_shared<gpu::DeviceOptions>();
    app->add_option("--device", options->substring, "part of the device's name (the best there is)")
        ->type_name("SUBSTRING");
    app->add_flag("--validation", options->validation,
                  "Vulkan core and synchronization validation");
    app->callback([options, &called] { called.run = [options] { return printInfo(*options); }; });
}

}  // namespace lampyris::sandbox
