#include "core/file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace lampyris::core {
namespace {

struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

}  // namespace

Result<std::vector<uint8_t>> readFile(const std::filesystem::path& path) {
    std::error_code code;
    if (std::filesystem::is_directory(path, code))
        return error("{}: is a folder, not a file", path.string());
    const File file{std::fopen(path.c_str(), "rb")};
    if (!file) return error("{}: {}", path.string(), std::strerror(errno));
    std::vector<uint8_t> bytes;
    std::vector<uint8_t> chunk(size_t{1} << 20);
    size_t got = 0;
    while ((got = std::fread(chunk.data(), 1, chunk.size(), file.get())) > 0)
        bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(got));
    if (std::ferror(file.get()) != 0) return error("{}: {}", path.string(), std::strerror(errno));
    return bytes;
}

Result<void> writeFile(const std::filesystem::path& path, std::span<const uint8_t> bytes) {
    const std::filesystem::path beside = path.string() + "." + std::to_string(::getpid()) + ".part";
    const auto fail = [&](const char* what) {
        Error failure = error("{}: cannot {}: {}", path.string(), what, std::strerror(errno));
        std::error_code ignored;
        std::filesystem::remove(beside, ignored);
        return failure;
    };
    std::FILE* file = std::fopen(beside.c_str(), "wb");
    if (file == nullptr) return fail("write");
    // An empty span may start at null, which fwrite must not be given.
    const bool wrote =
        bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const bool closed = std::fclose(file) == 0;
    if (!wrote || !closed) return fail("write");
    if (std::rename(beside.c_str(), path.c_str()) != 0) return fail("rename into place");
    return {};
}

Result<void> writeFile(const std::filesystem::path& path, std::string_view text) {
    return writeFile(path, std::span{reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

}  // namespace lampyris::core
