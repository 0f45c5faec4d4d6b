#include "core/file.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <csignal>

#include "unit/core/scratch_folder.h"

namespace lampyris::core {
namespace {

std::string textOf(const std::filesystem::path& path) {
    const auto bytes = readFile(path);
    return bytes.ok() ? std::string(bytes->begin(), bytes->end()) : bytes.error().message;
}

TEST(File, ReadsBackWhatItWrote) {
    const ScratchFolder folder;
    for (const size_t size :
         {size_t{0}, size_t{1}, (size_t{1} << 20) - 1, size_t{1} << 20, (size_t{1} << 20) + 1}) {
        std::vector<uint8_t> bytes(size);
        for (size_t i = 0; i < size; ++i) bytes[i] = static_cast<uint8_t>(i * 31);
        ASSERT_TRUE(writeFile(folder / "a.bin", bytes).ok());
        const auto read = readFile(folder / "a.bin");
        ASSERT_TRUE(read.ok());
        EXPECT_EQ(*read, bytes);
    }
    EXPECT_EQ(folder.files(), 1u);
}

TEST(File, ReplacesAnOlderFile) {
    const ScratchFolder folder;
    ASSERT_TRUE(writeFile(folder / "a.txt", "a long first text").ok());
    ASSERT_TRUE(writeFile(folder / "a.txt", "short").ok());
    EXPECT_EQ(textOf(folder / "a.txt"), "short");
}

TEST(File, NamesTheFileThatItCannotRead) {
    const ScratchFolder folder;
    const auto missing = readFile(folder / "missing.txt");
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().message,
              (folder / "missing.txt").string() + ": No such file or directory");
    const auto itself = readFile(folder / "");
    ASSERT_FALSE(itself.ok());
    EXPECT_NE(itself.error().message.find("is a folder"), std::string::npos);
}

TEST(File, NamesTheFileThatItCannotWrite) {
    const ScratchFolder folder;
    const auto nowhere = writeFile(folder / "no/such/folder.txt", "text");
    ASSERT_FALSE(nowhere.ok());
    EXPECT_EQ(nowhere.error().message.rfind(
                  (folder / "no/such/folder.txt").string() + ": cannot write: ", 0),
              0u);
}

TEST(File, LeavesNothingBehindWhereItCannotRename) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "taken/inside");
    const auto written = writeFile(folder / "taken", "text");
    ASSERT_FALSE(written.ok());
    EXPECT_NE(written.error().message.find("cannot rename into place"), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_directory(folder / "taken/inside"));
    EXPECT_EQ(folder.files(), 1u);
}

// A limit on the size of files stands in for a full disk.
class FullDisk {
 public:
    explicit FullDisk(rlim_t bytes) {
        formerHandler_ = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &former_);
        const rlimit small{bytes, former_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &former_);
        std::signal(SIGXFSZ, formerHandler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

 private:
    rlimit former_{};
    void (*formerHandler_)(int) = nullptr;
};

TEST(File, LeavesTheOldFileWhereTheDiskIsFull) {
    const ScratchFolder folder;
    ASSERT_TRUE(writeFile(folder / "a.txt", "old").ok());
    const std::vector<uint8_t> big(100000, 7);
    Result<void> written;
    {
        const FullDisk disk(10000);
        written = writeFile(folder / "a.txt", big);
    }
    ASSERT_FALSE(written.ok());
    EXPECT_NE(written.error().message.find("cannot write"), std::string::npos);
    EXPECT_EQ(textOf(folder / "a.txt"), "old");
    EXPECT_EQ(folder.files(), 1u) << "the half-written file beside it is gone";
}

}  // namespace
}  // namespace lampyris::core
