/// \file A fixture with an overlay, for what is drawn into it.
#pragma once

#include <optional>

#include "overlay/overlay.h"
#include "support/gpu_test.h"

namespace lampyris::test {

class OverlayTest : public GpuTest {
 protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (!IsSkipped()) overlay_.emplace(need(overlay::Overlay::create(device())));
    }
    void TearDown() override {
        overlay_.reset();
        GpuTest::TearDown();
    }

    std::optional<overlay::Overlay> overlay_;
};

}  // namespace lampyris::test
