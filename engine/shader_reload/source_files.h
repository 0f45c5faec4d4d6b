/// \file The files that shaders are made from, includes and all, and which of them changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace lampyris::shader_reload {

/// Files are named as below the folder. A change is another time or size, or that a file came or
/// went.
class SourceFiles {
 public:
    explicit SourceFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// From now on changed() tells of this shader's file; at once where it, or what it includes,
    /// was written since this was made.
    void follow(const std::string& file);
    /// Those followed whose own file, or one that it includes, changed since it was last asked.
    /// Costs a look at each file's time.
    [[nodiscard]] std::set<std::string> changed();

 private:
    struct Stamp {
        std::filesystem::file_time_type time{};
        uintmax_t bytes = 0;  ///< and no time: there is no such file
        bool operator==(const Stamp&) const = default;
    };
    struct File {
        Stamp stamp;
        std::vector<std::string> includes;  ///< all that its #include lines may mean
    };
    [[nodiscard]] Stamp stampOf(const std::string& file) const;
    /// Reads its #include lines, and follows what they name.
    void scan(const std::string& file);
    /// As scan(), of a file that was not known.
    void meet(const std::string& file);
    [[nodiscard]] bool reaches(const std::string& file, const std::set<std::string>& wanted,
                               std::set<std::string>& seen) const;

    std::filesystem::path folder_;
    std::filesystem::file_time_type begun_ = std::filesystem::file_time_type::clock::now();
    std::set<std::string> followed_;
    std::map<std::string, File> files_;
};

}  // namespace lampyris::shader_reload
