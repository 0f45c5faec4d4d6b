// Against images of the same scene by an independent renderer, where they lie beside the
// repository.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "scene/load.h"
#include "support/frame_test.h"

namespace lampyris {
namespace {

const std::filesystem::path kTruth =
    std::filesystem::path(LAMPYRIS_SOURCE_DIR) / "../shared/scenes/cornell";

/// A colour PFM: rows from the bottom, little-endian floats.
core::Image readPfm(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    uint32_t width = 0;
    uint32_t height = 0;
    float scale = 0.0f;
    file >> magic >> width >> height >> scale;
    file.get();
    if (magic != "PF" || scale >= 0.0f)
        throw std::runtime_error("not a little-endian colour PFM: " + path.string());
    core::Image image(width, height, 3);
    for (uint32_t y = height; y-- > 0;)
        file.read(reinterpret_cast<char*>(&image.at(0, y, 0)),
                  static_cast<std::streamsize>(width) * 12);
    return image;
}

/// Whether an 8 × 8 block and the six pixels around it show one flat surface.
bool flat(const core::Image& normal, const core::Image& position, uint32_t x0, uint32_t y0) {
    for (uint32_t y = y0 - 6; y < y0 + 14; ++y)
        for (uint32_t x = x0 - 6; x < x0 + 14; ++x) {
            float across = 0.0f;
            float along = 0.0f;
            for (uint32_t c = 0; c < 3; ++c) {
                across += std::abs(normal.at(x, y, c) - normal.at(x0, y0, c));
                along += normal.at(x0, y0, c) * (position.at(x, y, c) - position.at(x0, y0, c));
            }
            if (across > 0.01f || std::abs(along) > 0.02f) return false;
        }
    return true;
}

double blockMean(const core::Image& image, uint32_t x0, uint32_t y0) {
    double sum = 0.0;
    for (uint32_t y = y0; y < y0 + 8; ++y)
        for (uint32_t x = x0; x < x0 + 8; ++x)
            for (uint32_t c = 0; c < 3; ++c) sum += static_cast<double>(image.at(x, y, c));
    return sum / (64.0 * 3.0);
}

/// Σ|a/π − b| / Σ b over flat blocks.
double relativeDifference(const core::Image& irradiance, const core::Image& truth) {
    const core::Image normal = readPfm(kTruth / "cornell.n2.normal.pfm");
    const core::Image position = readPfm(kTruth / "cornell.n2.position.pfm");
    double difference = 0.0;
    double total = 0.0;
    int blocks = 0;
    for (uint32_t y = 8; y + 16 <= truth.height; y += 8)
        for (uint32_t x = 8; x + 16 <= truth.width; x += 8) {
            if (blockMean(truth, x, y) <= 0.0 || !flat(normal, position, x, y)) continue;
            difference += std::abs(blockMean(irradiance, x, y) / M_PI - blockMean(truth, x, y));
            total += blockMean(truth, x, y);
            ++blocks;
        }
    EXPECT_GT(blocks, 200);
    return difference / total;
}

class GroundTruth : public test::FrameTest {
 protected:
    /// Draws the file's scene as the truth was drawn: 480 × 270, its camera, all Lambertian.
    static core::Image draw(uint32_t bounces, photon_gi::Gather gather,
                            const std::string& outputNode) {
        const ecs::World world = test::need(scene::loadScene((kTruth / "cornell.glb").string()));
        const auto snapshot = scene::extract(world, {}, 0);
        auto wanted = request(480, 270, snapshot.cameras.front());
        wanted.settings.maxBounces = bounces;
        const bool tiles = gather == photon_gi::Gather::Tiles;
        wanted.settings.gather = gather;
        wanted.settings.photonPaths = outputNode == "irradiance_direct" ? 100
                                      : tiles                           ? 2'000'000
                                                                        : 500'000;
        wanted.settings.radiusMetres = tiles ? 0.25f : 0.5f;
        wanted.settings.gatherDivisor = 2;
        wanted.settings.gatherRays = 64;
        wanted.settings.shadowDivisor = 1;
        return render(snapshot, wanted, outputNode).image;
    }
};

class DirectTruth : public GroundTruth {
    void TestBody() override {
        EXPECT_LT(relativeDifference(draw(1, photon_gi::Gather::Tiles, "irradiance_direct"),
                                     readPfm(kTruth / "cornell.n2.direct.pfm")),
                  0.02);
    }
};

class IndirectTruth : public GroundTruth {
 public:
    IndirectTruth(uint32_t bounces, photon_gi::Gather gather, std::string file)
        : bounces_(bounces), gather_(gather), file_(std::move(file)) {}

 private:
    // Blocks of the truth carry 1.5 to 1.8 % of noise, and the estimate some bias of its radius.
    void TestBody() override {
        EXPECT_LT(relativeDifference(draw(bounces_, gather_, "irradiance_indirect"),
                                     readPfm(kTruth / file_)),
                  0.03);
    }
    uint32_t bounces_;
    photon_gi::Gather gather_;
    std::string file_;
};

// Registered only where the truth is: the tests of a bare clone know nothing of it.
const bool kRegistered = [] {
    if (!std::filesystem::exists(kTruth / "cornell.n8.indirect.pfm")) return false;
    const auto add = [](const char* name, auto make) {
        // GoogleTest owns what it registers.
        // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks)
        ::testing::RegisterTest("GroundTruth", name, nullptr, nullptr, __FILE__, __LINE__,
                                [make]() -> GroundTruth* { return make(); });
    };
    add("DirectLight", [] { return new DirectTruth; });
    using photon_gi::Gather;
    add("OneBounceFromTiles",
        [] { return new IndirectTruth(1, Gather::Tiles, "cornell.n2.indirect.pfm"); });
    add("SevenBouncesFromTiles",
        [] { return new IndirectTruth(7, Gather::Tiles, "cornell.n8.indirect.pfm"); });
    add("OneBounceByRays",
        [] { return new IndirectTruth(1, Gather::Final, "cornell.n2.indirect.pfm"); });
    add("SevenBouncesByRays",
        [] { return new IndirectTruth(7, Gather::Final, "cornell.n8.indirect.pfm"); });
    return true;
}();

}  // namespace
}  // namespace lampyris
