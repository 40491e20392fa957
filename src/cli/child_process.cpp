// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "endmill/core/error.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/read_file.h"

// The child is forked, not spawned, because its limits must hold from its first
// instruction. Between fork and exec it calls only functions that are safe after a fork
// in a program with several threads; all memory is prepared before.

namespace endmill {
namespace {

namespace fs = std::filesystem;

constexpr int exit_code_without_exec = 127;
constexpr rlim_t most_open_files = 64;

// What an interruption must clean up. The mutex also guards the process number: it may
// be signalled only while the process has not been waited for.
struct Registry {
    std::mutex mutex;
    std::set<fs::path> folders;
    pid_t child = 0;
};

Registry& registry()
{
    static auto* const instance =
        new Registry;  // never destroyed: threads may outlive main
    return *instance;
}

[[noreturn]] void fail_to(const std::string& act, int error)
{
    throw OutputError{"cannot " + act + ": " + std::generic_category().message(error)};
}

// An open file that the child inherits by dup2 only.
class OpenFile {
public:
    OpenFile(const fs::path& path, int flags)
        : descriptor_{::open(path.c_str(), flags | O_CLOEXEC, 0600)}
    {
        if (descriptor_ < 0)
            fail_to("open " + shown_path(path), errno);
        // If a standard stream is closed, the file gets its number, and dup2 to the same
        // number would leave it to be closed by exec.
        const int high = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
        const int error = errno;
        ::close(descriptor_);
        descriptor_ = high;
        if (descriptor_ < 0)
            fail_to("open " + shown_path(path), error);
    }
    ~OpenFile() { ::close(descriptor_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    int descriptor() const { return descriptor_; }

private:
    int descriptor_;
};

// Pointers to the characters of `words`, with a null at the end.
std::vector<char*> pointers(std::vector<std::string>& words)
{
    std::vector<char*> all;
    all.reserve(words.size() + 1);
    for (std::string& word : words)
        all.push_back(word.data());
    all.push_back(nullptr);
    return all;
}

struct ResourceLimit {
    decltype(RLIMIT_CPU) resource;
    rlimit soft_and_hard;
};

using ResourceLimits = std::array<ResourceLimit, 5>;

// A limit as a whole number, at least 1.
rlim_t whole(double limit)
{
    constexpr double most = 9e18;  // below 2^63
    return static_cast<rlim_t>(std::clamp(std::ceil(limit), 1.0, most));
}

// A limit that does not exceed the hard limit of this process, which it may not raise.
ResourceLimit lowered(decltype(RLIMIT_CPU) resource, rlim_t most)
{
    rlimit own{};
    if (::getrlimit(resource, &own) != 0)
        own.rlim_max = most;
    const rlim_t soft = std::min(most, own.rlim_max);
    return {resource, {soft, soft}};
}

// The soft limit sends a signal that tells what happened, the hard one only ends.
ResourceLimit processor_time(double most_seconds)
{
    const auto [resource, both] = lowered(RLIMIT_CPU, whole(most_seconds) + 2);
    const rlim_t hard = both.rlim_max;
    return {resource, {hard > 1 ? hard - 1 : hard, hard}};
}

ResourceLimits limits_of(const ChildTask& task)
{
    return {processor_time(task.most_seconds),
            lowered(RLIMIT_AS, whole(task.most_memory_bytes)),
            lowered(RLIMIT_FSIZE, whole(task.most_file_bytes)),
            lowered(RLIMIT_NOFILE, most_open_files), lowered(RLIMIT_CORE, 0)};
}

// What the child needs, prepared before the fork.
struct Prepared {
    const char* program;
    char* const* arguments;
    char* const* environment;
    const char* folder;
    int input;
    int output;
    ResourceLimits limits;
    pid_t parent;
};

void set_signals()
{
    sigset_t none;
    sigemptyset(&none);
    for (const int number : {SIGXFSZ, SIGPIPE, SIGINT, SIGTERM, SIGHUP})
        ::signal(number, SIG_DFL);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

// The child after the fork: becomes the program, or exits.
[[noreturn]] void become(const Prepared& task)
{
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    bool is_ready = ::getppid() == task.parent;  // else it has ended already
    for (const ResourceLimit& limit : task.limits)
        is_ready = is_ready && ::setrlimit(limit.resource, &limit.soft_and_hard) == 0;
    set_signals();
    is_ready = is_ready && ::chdir(task.folder) == 0 && ::dup2(task.input, 0) == 0 &&
               ::dup2(task.output, 1) == 1 && ::dup2(task.output, 2) == 2;
    if (is_ready)
        ::execve(task.program, task.arguments, task.environment);
    ::_exit(exit_code_without_exec);
}

pid_t start(const ChildTask& task)
{
    std::vector<std::string> words{task.program.string()};
    words.insert(words.end(), task.arguments.begin(), task.arguments.end());
    std::vector<std::string> environment{"PATH=/usr/bin:/bin", "LC_ALL=C",
                                         "PYTHONNOUSERSITE=1",
                                         "HOME=" + task.folder.string()};
    const std::vector<char*> arguments = pointers(words);
    const std::vector<char*> variables = pointers(environment);
    const OpenFile input{"/dev/null", O_RDONLY};
    const OpenFile output{task.folder / "log.txt", O_WRONLY | O_CREAT | O_EXCL};
    const Prepared prepared{task.program.c_str(), arguments.data(),   variables.data(),
                            task.folder.c_str(),  input.descriptor(), output.descriptor(),
                            limits_of(task),      ::getpid()};
    const std::lock_guard lock{registry().mutex};
    const pid_t child = ::fork();
    if (child == 0)
        become(prepared);
    if (child < 0)
        fail_to("start " + shown_path(task.program), errno);
    ::setpgid(child, child);  // in both, so that it holds whichever runs first
    registry().child = child;
    return child;
}

// Waits without blocking. \return the status if the child has ended.
std::optional<int> ended(pid_t child)
{
    const std::lock_guard lock{registry().mutex};
    siginfo_t info{};
    if (::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) !=
            0 ||
        info.si_pid != child)
        return std::nullopt;
    ::kill(-child, SIGKILL);  // what it started itself, while its number is still taken
    int status = 0;
    ::waitpid(child, &status, 0);
    registry().child = 0;
    return status;
}

// Ends the group of the child and waits for the child.
void end_group(pid_t child)
{
    const std::lock_guard lock{registry().mutex};
    ::kill(-child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    registry().child = 0;
}

// Whether a file in the folder has reached its limit. The signal of the limit does not
// suffice: a program that embeds Python ignores it.
bool has_full_file(const ChildTask& task)
{
    std::error_code error;
    for (const auto& entry : fs::directory_iterator{task.folder, error}) {
        if (!entry.is_regular_file(error))
            continue;
        // The child may have renamed the file since; its size is then an error.
        const auto size = entry.file_size(error);
        if (!error && static_cast<double>(size) >= task.most_file_bytes)
            return true;
    }
    return false;
}

ChildResult result_of(int status)
{
    if (WIFEXITED(status)) {
        const int code = WEXITSTATUS(status);
        return {code == exit_code_without_exec ? ChildEnd::NotStarted : ChildEnd::Exited,
                code};
    }
    const int signal_number = WTERMSIG(status);
    if (signal_number == SIGXCPU)
        return {ChildEnd::OutOfTime, signal_number};
    if (signal_number == SIGXFSZ)
        return {ChildEnd::FileTooLong, signal_number};
    return {ChildEnd::Signalled, signal_number};
}

}  // namespace

PrivateFolder::PrivateFolder(const fs::path& parent)
{
    std::string name = (fs::absolute(parent) / ".endmill-XXXXXX").string();
    const std::lock_guard lock{registry().mutex};
    if (::mkdtemp(name.data()) == nullptr)
        fail_to("create a folder in " + shown_path(parent), errno);
    path_ = name;
    registry().folders.insert(path_);
}

PrivateFolder::~PrivateFolder()
{
    const std::lock_guard lock{registry().mutex};
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    registry().folders.erase(path_);
}

void PrivateFolder::write(const std::string& name, std::string_view content) const
{
    write_file(path_ / name, content);
}

ChildResult run_child(const ChildTask& task)
{
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds poll_interval{5};
    const auto deadline = Clock::now() + std::chrono::duration<double>(task.most_seconds);
    const pid_t child = start(task);
    while (true) {
        const auto status = ended(child);
        const bool is_too_long = has_full_file(task);
        if (status)
            return is_too_long ? ChildResult{ChildEnd::FileTooLong, SIGXFSZ}
                               : result_of(*status);
        if (is_too_long || Clock::now() >= deadline) {
            end_group(child);
            return is_too_long ? ChildResult{ChildEnd::FileTooLong, SIGXFSZ}
                               : ChildResult{ChildEnd::OutOfTime, SIGKILL};
        }
        std::this_thread::sleep_for(poll_interval);
    }
}

void abandon_children()
{
    const std::lock_guard lock{registry().mutex};
    if (registry().child > 0) {
        ::kill(-registry().child, SIGKILL);
        ::waitpid(registry().child, nullptr, 0);
        registry().child = 0;
    }
    std::error_code ignored;
    for (const fs::path& folder : registry().folders)
        fs::remove_all(folder, ignored);
}

fs::path program_on_path(const std::string& name)
{
    const char* const variable = std::getenv("PATH");
    std::string_view rest = variable ? variable : "/usr/bin:/bin";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const fs::path folder{rest.substr(0, end)};
        rest.remove_prefix(std::min(end + 1, rest.size()));
        fs::path program = folder / name;
        std::error_code ignored;
        if (folder.is_absolute() && fs::is_regular_file(program, ignored) &&
            ::access(program.c_str(), X_OK) == 0)
            return program;
    }
    return {};
}

}  // namespace endmill
