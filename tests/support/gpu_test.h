/// \file A fixture for tests on the device: one device a process, under core and synchronization
/// validation. One message of the layer fails the test.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/result.h"
#include "gpu/device.h"

namespace lampyris::test {

/// The value, or a failed test that says why.
template <typename T>
T need(core::Result<T> result) {
    if (!result.ok()) throw std::runtime_error(result.error().message);
    return std::move(result).value();
}
inline void need(const core::Result<void>& result) {
    if (!result.ok()) throw std::runtime_error(result.error().message);
}

/// The message of a result that must be an error.
template <typename T>
std::string errorOf(const core::Result<T>& result) {
    if (result.ok()) return "no error";
    return result.error().message;
}

template <typename T>
std::vector<T> valuesOf(std::span<const std::byte> bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

/// Made at the first call; an Error where there is no device, or no validation layer.
inline core::Result<std::unique_ptr<gpu::Device>>& sharedDevice() {
    static core::Result<std::unique_ptr<gpu::Device>> device =
        gpu::Device::create({.validation = true});
    return device;
}

class GpuTest : public ::testing::Test {
 protected:
    void SetUp() override {
        if (!sharedDevice().ok()) GTEST_SKIP() << sharedDevice().error().message;
        device().clearValidationMessages();
    }

    void TearDown() override {
        if (!sharedDevice().ok()) return;
        const auto idle = device().waitIdle();
        EXPECT_TRUE(idle.ok());
        for (const std::string& message : device().validationMessages()) ADD_FAILURE() << message;
    }

    [[nodiscard]] static gpu::Device& device() { return *sharedDevice().value(); }

    /// Messages so far, which then no longer fail the test.
    static std::vector<std::string> takeMessages() {
        auto messages = device().validationMessages();
        device().clearValidationMessages();
        return messages;
    }
};

}  // namespace lampyris::test
