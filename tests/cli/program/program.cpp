#include "cli/program/program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

namespace lampyris::test {
namespace {

constexpr int kSeconds = 180;  // sanitizers are slow
constexpr int kGraceSeconds = 5;
constexpr auto kPollInterval = std::chrono::milliseconds(5);

std::filesystem::path streamFile(const char* stream) {
    static std::atomic<int> count{0};
    return std::filesystem::path(testing::TempDir()) /
           ("lampyris_" + std::to_string(::getpid()) + "_" + std::to_string(count++) + stream);
}

/// With argv and envp's null at the end.
std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> all;
    all.reserve(texts.size() + 1);
    for (std::string& text : texts) all.push_back(text.data());
    all.push_back(nullptr);
    return all;
}

}  // namespace

size_t Ran::errorLines() const {
    return static_cast<size_t>(std::count(err.begin(), err.end(), '\n'));
}

Process::Process(const Arguments& command, const std::vector<std::string>& variables)
    : out_(streamFile("_out")), err_(streamFile("_err")) {
    std::vector<std::string> arguments = command;
    std::vector<std::string> environment = variables;
    for (char** variable = environ; *variable != nullptr; ++variable)
        environment.emplace_back(*variable);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(), flags, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_.c_str(), flags, 0600);
    const int failed = ::posix_spawnp(&pid_, arguments[0].c_str(), &actions, nullptr,
                                      pointers(arguments).data(), pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    ended_ = failed != 0;
    EXPECT_EQ(failed, 0) << "cannot start " << arguments[0];
}

Process::~Process() {
    if (running()) ::kill(pid_, SIGTERM);  // a display server takes its socket away with it
    if (!endsWithin(kGraceSeconds)) kill();
    std::filesystem::remove(out_);
    std::filesystem::remove(err_);
}

bool Process::running() {
    if (ended_) return false;
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) == pid_) reap(status);
    return !ended_;
}

void Process::reap(int status) {
    ended_ = true;
    ran_.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    ran_.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

std::string Process::outputSoFar() const {
    return textOf(out_);
}

std::string Process::errorsSoFar() const {
    return textOf(err_);
}

bool Process::endsWithin(int seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    while (running() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(kPollInterval);
    return !running();
}

void Process::kill() {
    ::kill(pid_, SIGKILL);
    int status = 0;
    ::waitpid(pid_, &status, 0);
    reap(status);
}

Ran Process::wait(int seconds) {
    if (!endsWithin(seconds)) {
        ADD_FAILURE() << "still running after " << seconds << " s";
        kill();
    }
    ran_.out = textOf(out_);
    ran_.err = textOf(err_);
    return ran_;
}

std::string programPath() {
    return LAMPYRIS_BINARY_DIR "/sandbox/lampyris";
}

Ran run(const Arguments& command, const std::vector<std::string>& variables) {
    return Process(command, variables).wait(kSeconds);
}

Ran lampyris(const Arguments& arguments, const std::vector<std::string>& variables) {
    Arguments command{programPath()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run(command, variables);
}

Ran render(const std::string& scene, const std::filesystem::path& picture, const Arguments& more) {
    Arguments arguments{"render", scene, "-o", picture.string()};
    if (std::find(more.begin(), more.end(), "--size") == more.end())
        arguments.insert(arguments.end(), {"--size", "160x90"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return lampyris(arguments);
}

std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

nlohmann::json jsonOf(const std::filesystem::path& path) {
    return nlohmann::json::parse(textOf(path), nullptr, false);
}

void expectFailure(const Ran& ran, const std::string& what) {
    EXPECT_EQ(ran.code, 1) << "signal " << ran.signal << "\n" << ran.err;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_NE(ran.err.find(what), std::string::npos) << "no '" << what << "' in: " << ran.err;
    EXPECT_EQ(ran.out, "");
}

void expectWrongCall(const Ran& ran, const std::string& what) {
    EXPECT_EQ(ran.code, 2) << "signal " << ran.signal << "\n" << ran.err;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_NE(ran.err.find(what), std::string::npos) << "no '" << what << "' in: " << ran.err;
}

}  // namespace lampyris::test
