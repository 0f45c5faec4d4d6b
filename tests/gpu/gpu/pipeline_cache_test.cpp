#include "gpu/pipeline_cache.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "core/file.h"
#include "support/gpu_test.h"

namespace lampyris {
namespace {

using test::need;

class PipelineCacheTest : public test::GpuTest {
 protected:
    PipelineCacheTest()
        : folder_(std::filesystem::temp_directory_path() /
                  ("lampyris-cache-" + std::to_string(::getpid()))) {}
    ~PipelineCacheTest() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    gpu::PipelineCache open() {
        return need(gpu::PipelineCache::open(device().physical(), device().get(), folder_));
    }
    std::filesystem::path folder_;
};

TEST_F(PipelineCacheTest, IsReadBackAfterItWasSaved) {
    std::filesystem::path file;
    {
        const auto first = open();
        EXPECT_FALSE(first.loaded());
        need(first.save());
        file = first.file();
    }
    EXPECT_TRUE(std::filesystem::exists(file));
    EXPECT_TRUE(open().loaded());
}

TEST_F(PipelineCacheTest, SurvivesDamage) {
    const auto path = open().file();
    need(open().save());
    const auto sound = need(core::readFile(path));
    std::vector<std::vector<uint8_t>> damaged{{}, {1, 2, 3}, sound, sound, sound};
    damaged[2].back() ^= 0xff;
    damaged[3].resize(sound.size() - 1);
    damaged[4].insert(damaged[4].end(), 100, 0);
    for (const auto& bytes : damaged) {
        need(core::writeFile(path, std::span<const uint8_t>{bytes}));
        const auto cache = open();
        EXPECT_FALSE(cache.loaded());
        EXPECT_NE(cache.get(), VkPipelineCache{VK_NULL_HANDLE});
    }
}

TEST_F(PipelineCacheTest, KeepsNothingWithoutAFolder) {
    const auto cache = need(gpu::PipelineCache::open(device().physical(), device().get(), {}));
    EXPECT_TRUE(cache.save().ok());
    EXPECT_TRUE(cache.file().empty());
}

TEST_F(PipelineCacheTest, LiesUnderTheUsersCacheFolder) {
    const char* old = std::getenv("XDG_CACHE_HOME");
    const std::string kept = old == nullptr ? "" : old;
    ::setenv("XDG_CACHE_HOME", "/somewhere", 1);
    EXPECT_EQ(gpu::defaultCacheFolder(), std::filesystem::path{"/somewhere/lampyris"});
    if (old == nullptr)
        ::unsetenv("XDG_CACHE_HOME");
    else
        ::setenv("XDG_CACHE_HOME", kept.c_str(), 1);
}

}  // namespace
}  // namespace lampyris
