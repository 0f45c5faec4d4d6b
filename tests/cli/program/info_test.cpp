// `lampyris info`.
#include "cli/program/program.h"

namespace lampyris::test {
namespace {

TEST(Info, TellsOfTheDevice) {
    const Ran ran = lampyris({"info"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    for (const char* key : {"device: ", "driver: ", "api version: 1.3", "feature: synchronization2",
                            "limit maxStorageBufferRange: ", "refitted on: ", "worker threads: ",
                            "shaders reload from: /", "display: "})
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

}  // namespace
}  // namespace lampyris::test
