// `lampyris info`: the device that a run would use.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "command.h"
#include "gpu/device.h"

namespace lampyris::sandbox {
namespace {

core::Result<void> printInfo(const gpu::DeviceOptions& options) {
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create(options));
    const gpu::DeviceInfo& info = device->info();
    fmt::print("device: {}\n", info.name);
    fmt::print("kind: {}\n", info.kind);
    fmt::print("driver: {}\n", info.driver);
    fmt::print("api version: {}\n", info.apiVersion);
    fmt::print("validation layer: {}\n", gpu::validationLayer().ok() ? "there" : "missing");
    for (const std::string& feature : info.features) fmt::print("feature: {}\n", feature);
    for (const auto& [name, value] : gpu::listLimits(info.limits))
        fmt::print("limit {}: {}\n", name, value);
    return {};
}

}  // namespace

void addInfo(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand("info", "Device, driver, features used, limits");
    const auto options = std::make_shared<gpu::DeviceOptions>();
    app->add_option("--device", options->substring, "part of the device's name (the best there is)")
        ->type_name("SUBSTRING");
    app->add_flag("--validation", options->validation,
                  "Vulkan core and synchronization validation");
    app->callback([options, &called] { called.run = [options] { return printInfo(*options); }; });
}

}  // namespace lampyris::sandbox
