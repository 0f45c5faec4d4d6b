// `lampyris info` and `lampyris bench`.
#include "cli/program/program.h"

namespace lampyris::test {
namespace {

TEST(Info, TellsOfTheDevice) {
    const Ran ran = lampyris({"info"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    for (const char* key : {"device: ", "driver: ", "api version: 1.3", "feature: synchronization2",
                            "limit maxStorageBufferRange: "})
        EXPECT_NE(ran.out.find(key), std::string::npos) << key << "\n" << ran.out;
}

TEST(Info, ChoosesADeviceByPartOfItsName) {
    const Ran all = lampyris({"info"});
    const size_t begin = all.out.find(": ") + 2;
    const std::string name = all.out.substr(begin, all.out.find('\n') - begin);
    const Ran ran = lampyris({"info", "--device", name.substr(0, 6)});
    EXPECT_EQ(ran.out, all.out);
    expectFailure(lampyris({"info", "--device", "no such device"}), name);
}

TEST(Bench, PrintsTablesAndWritesThem) {
    const ScratchFolder folder;
    const std::vector<std::pair<std::string, std::vector<std::string>>> benchmarks{
        {"nodes", {"nodes"}}, {"binning", {"binning", "photon_gi"}}};
    for (const auto& [name, tables] : benchmarks) {
        const std::filesystem::path out = folder / name;
        const Ran ran = lampyris({"bench", name, "--quick", "--size", "160x90", "--frames", "1",
                                  "--warmup", "0", "--out", out});
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_NE(ran.out.find("thesis"), std::string::npos);
        for (const std::string& table : tables) {
            const std::string csv = textOf(out / (table + ".csv"));
            EXPECT_NE(csv.find("thesis"), std::string::npos) << table;
            EXPECT_NE(textOf(out / (table + ".md")).find("| "), std::string::npos) << table;
        }
    }
}

}  // namespace
}  // namespace lampyris::test
