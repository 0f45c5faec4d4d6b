#include "overlay/setting_list.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>

namespace lampyris::overlay {
namespace {

using photon_gi::Settings;

TEST(SettingList, HasAUniqueNameAndASentenceForEach) {
    std::set<std::string> names;
    for (const SettingInfo& info : settingList()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_GT(std::strlen(info.sentence), 10u) << info.name;
        EXPECT_EQ(info.sentence[std::strlen(info.sentence) - 1], '.') << info.name;
    }
}

// A setting that was added, and not listed, would be a difference that no listed field shows.
TEST(SettingList, LeavesNoFieldOut) {
    Settings a;
    std::memset(static_cast<void*>(&a), 0, sizeof a);
    for (const SettingInfo& info : settingList())
        std::visit(
            [&](auto field) {
                auto* bytes = reinterpret_cast<unsigned char*>(&(a.*field));
                std::memset(bytes, 0xff, sizeof(a.*field));
            },
            info.field);
    size_t covered = 0;
    const auto* bytes = reinterpret_cast<const unsigned char*>(&a);
    for (size_t i = 0; i < sizeof a; ++i) covered += bytes[i] == 0xff ? 1 : 0;
    // Names every field: with another one it does not compile until that is named here, too.
    const auto& [pipeline, photonPaths, radiusMetres, maxBounces, gather, gatherDivisor, gatherRays,
                 filterLevels, history, gridColumns, lightCutoff, seed, reseed, retrace, guiding,
                 shadows, shadowDivisor, shadowRays, largestBatch] = a;
    const auto sizeOf = [](const auto&... fields) { return (sizeof(fields) + ...); };
    EXPECT_EQ(covered,
              sizeOf(pipeline, photonPaths, radiusMetres, maxBounces, gather, gatherDivisor,
                     gatherRays, filterLevels, history, gridColumns, lightCutoff, seed, reseed,
                     retrace, guiding, shadows, shadowDivisor, shadowRays, largestBatch));
}

TEST(SettingList, HoldsTheDefaultsWithinItsRanges) {
    const Settings settings;
    for (const SettingInfo& info : settingList())
        std::visit(
            [&](auto field) {
                using Value = std::remove_cvref_t<decltype(settings.*field)>;
                if constexpr (std::is_same_v<Value, uint32_t> || std::is_same_v<Value, float>) {
                    EXPECT_GE(static_cast<double>(settings.*field), info.least) << info.name;
                    EXPECT_LE(static_cast<double>(settings.*field), info.most) << info.name;
                }
            },
            info.field);
}

}  // namespace
}  // namespace lampyris::overlay
