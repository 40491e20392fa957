// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/child_process.h"

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
#include <span>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
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
constexpr std::size_t longest_line = 65536;

// What an interruption must clean up. The mutex also guards the process numbers: one
// may be signalled only while its process has not been waited for.
struct Registry {
    std::mutex mutex;
    std::set<fs::path> folders;
    std::set<pid_t> children;
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
    OpenFile(int descriptor, const std::string& shown) : descriptor_{descriptor}
    {
        if (descriptor_ < 0)
            fail_to("open " + shown, errno);
        // If a standard stream is closed, the file gets its number, and dup2 to the same
        // number would leave it to be closed by exec.
        const int high = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
        const int error = errno;
        ::close(descriptor_);
        descriptor_ = high;
        if (descriptor_ < 0)
            fail_to("open " + shown, error);
    }
    OpenFile(const fs::path& path, int flags)
        : OpenFile{::open(path.c_str(), flags | O_CLOEXEC, 0600), shown_path(path)}
    {
    }
    ~OpenFile() { close(); }
    OpenFile(OpenFile&& other) noexcept
        : descriptor_{std::exchange(other.descriptor_, -1)}
    {
    }
    OpenFile& operator=(OpenFile&&) = delete;
    int descriptor() const { return descriptor_; }
    void close()
    {
        if (descriptor_ >= 0)
            ::close(std::exchange(descriptor_, -1));
    }

private:
    int descriptor_;
};

// Both ends of a pipe; the child inherits the end for writing.
struct Pipe {
    OpenFile reading;
    OpenFile writing;
};

Pipe new_pipe()
{
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        fail_to("open a pipe", errno);
    // The child writes as to any file: it waits until there is room.
    ::fcntl(ends[1], F_SETFL, 0);
    return {{ends[0], "a pipe"}, {ends[1], "a pipe"}};
}

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

std::vector<ResourceLimit> resource_limits(const ChildLimits& limits)
{
    std::vector<ResourceLimit> all{lowered(RLIMIT_CORE, 0)};
    const auto add = [&](decltype(RLIMIT_CPU) resource, const auto& limit) {
        if (limit)
            all.push_back(lowered(resource, whole(*limit)));
    };
    if (limits.processor_seconds)
        all.push_back(processor_time(*limits.processor_seconds));
    add(RLIMIT_AS, limits.address_space_bytes);
    add(RLIMIT_DATA, limits.data_bytes);
    add(RLIMIT_FSIZE, limits.file_bytes);
    add(RLIMIT_NOFILE, limits.open_files);
    return all;
}

// What the child needs, prepared before the fork.
struct Prepared {
    const char* program;
    char* const* arguments;
    char* const* environment;
    const char* folder;
    int input;
    int output;
    int errors;
    std::span<const ResourceLimit> limits;
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
               ::dup2(task.output, 1) == 1 && ::dup2(task.errors, 2) == 2;
    if (is_ready)
        ::execve(task.program, task.arguments, task.environment);
    ::_exit(exit_code_without_exec);
}

// A child that was started, and what it writes to its standard output and error.
class StartedChild {
public:
    explicit StartedChild(const ChildTask& task);
    ~StartedChild();
    StartedChild(const StartedChild&) = delete;
    StartedChild& operator=(const StartedChild&) = delete;

    // Waits for its end or its output, but no longer than `most_ms`.
    void wait(int most_ms) const;
    // Passes on what has come; at the `end` of the child all that is left.
    void pass_on(bool at_end);
    // The status if the child has ended. It is then waited for.
    std::optional<int> ended();
    // Ends the group of the child and waits for the child.
    void end_group();

private:
    void pass_line(std::string_view line) const;
    void pass_lines(bool at_end);
    void pass_output(bool at_end);

    const ChildTask& task_;
    std::optional<Pipe> pipe_;         // of the standard error
    std::optional<Pipe> output_pipe_;  // of the standard output
    std::string rest_;                 // of a line that is not complete
    pid_t process_ = 0;
    int process_file_ = -1;  // becomes readable at the end of the process
};

StartedChild::StartedChild(const ChildTask& task) : task_{task}
{
    std::vector<std::string> words{task.program.string()};
    words.insert(words.end(), task.arguments.begin(), task.arguments.end());
    std::vector<std::string> environment = task.environment;
    const std::vector<char*> arguments = pointers(words);
    const std::vector<char*> variables = pointers(environment);
    const std::vector<ResourceLimit> limits = resource_limits(task.limits);
    const OpenFile input{task.input.empty() ? fs::path{"/dev/null"} : task.input,
                         O_RDONLY};
    const OpenFile output{task.log.empty() ? fs::path{"/dev/null"} : task.log,
                          task.log.empty() ? O_WRONLY : O_WRONLY | O_CREAT | O_EXCL};
    if (task.log.empty())
        pipe_.emplace(new_pipe());
    if (task.log.empty() && task.output)
        output_pipe_.emplace(new_pipe());
    const Prepared prepared{
        task.program.c_str(),
        arguments.data(),
        variables.data(),
        task.folder.c_str(),
        input.descriptor(),
        output_pipe_ ? output_pipe_->writing.descriptor() : output.descriptor(),
        pipe_ ? pipe_->writing.descriptor() : output.descriptor(),
        limits,
        ::getpid()};
    const std::lock_guard lock{registry().mutex};
    process_ = ::fork();
    if (process_ == 0)
        become(prepared);
    if (process_ < 0)
        fail_to("start " + shown_path(task.program), errno);
    ::setpgid(process_, process_);  // in both, so that it holds whichever runs first
    registry().children.insert(process_);
    process_file_ = static_cast<int>(::syscall(SYS_pidfd_open, process_, 0));
    if (pipe_)
        pipe_->writing.close();
    if (output_pipe_)
        output_pipe_->writing.close();
}

StartedChild::~StartedChild()
{
    if (process_ > 0)
        end_group();
    if (process_file_ >= 0)
        ::close(process_file_);
}

void StartedChild::wait(int most_ms) const
{
    constexpr int poll_interval_ms = 5;  // without a file for the process
    std::array<pollfd, 3> files{
        pollfd{process_file_, POLLIN, 0},
        pollfd{pipe_ ? pipe_->reading.descriptor() : -1, POLLIN, 0},
        pollfd{output_pipe_ ? output_pipe_->reading.descriptor() : -1, POLLIN, 0}};
    ::poll(files.data(), files.size(),
           process_file_ < 0 ? std::min(most_ms, poll_interval_ms) : most_ms);
}

void StartedChild::pass_line(std::string_view line) const
{
    if (task_.error_line)
        task_.error_line(line);
}

void StartedChild::pass_lines(bool at_end)
{
    std::array<char, 4096> piece{};
    while (pipe_ && pipe_->reading.descriptor() >= 0) {
        const ssize_t count =
            ::read(pipe_->reading.descriptor(), piece.data(), piece.size());
        if (count == 0)
            pipe_->reading.close();  // else it would count as readable for ever
        if (count < 0 && errno != EAGAIN && errno != EINTR)
            fail_to("read the messages of " + shown_path(task_.program), errno);
        if (count <= 0)
            break;
        rest_.append(piece.data(), static_cast<std::size_t>(count));
        for (std::size_t end = rest_.find('\n'); end != std::string::npos;
             end = rest_.find('\n')) {
            pass_line(std::string_view{rest_}.substr(0, std::min(end, longest_line)));
            rest_.erase(0, end + 1);
        }
        rest_.resize(std::min(rest_.size(), longest_line));
    }
    if (at_end && !rest_.empty())
        pass_line(std::exchange(rest_, {}));
}

// A child that writes without end is looked at in between, for its limits.
void StartedChild::pass_output(bool at_end)
{
    constexpr int most_pieces = 64;
    std::array<char, 65536> piece;
    for (int count_of_pieces = 0;
         output_pipe_ && output_pipe_->reading.descriptor() >= 0 &&
         (at_end || count_of_pieces < most_pieces);
         ++count_of_pieces) {
        const ssize_t count =
            ::read(output_pipe_->reading.descriptor(), piece.data(), piece.size());
        if (count == 0)
            output_pipe_->reading.close();
        if (count < 0 && errno != EAGAIN && errno != EINTR)
            fail_to("read the output of " + shown_path(task_.program), errno);
        if (count <= 0)
            break;
        task_.output({piece.data(), static_cast<std::size_t>(count)});
    }
}

void StartedChild::pass_on(bool at_end)
{
    pass_output(at_end);
    pass_lines(at_end);
}

std::optional<int> StartedChild::ended()
{
    const std::lock_guard lock{registry().mutex};
    siginfo_t info{};
    if (::waitid(P_PID, static_cast<id_t>(process_), &info,
                 WEXITED | WNOHANG | WNOWAIT) != 0 ||
        info.si_pid != process_)
        return std::nullopt;
    ::kill(-process_,
           SIGKILL);  // what it started itself, while its number is still taken
    int status = 0;
    ::waitpid(process_, &status, 0);
    registry().children.erase(process_);
    process_ = 0;
    return status;
}

void StartedChild::end_group()
{
    const std::lock_guard lock{registry().mutex};
    ::kill(-process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    registry().children.erase(process_);
    process_ = 0;
}

// Whether a file in the folder has reached its limit. The signal of the limit does not
// suffice: a program that embeds Python ignores it.
bool has_full_file(const ChildTask& task)
{
    if (!task.limits.file_bytes)
        return false;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator{task.folder, error}) {
        if (!entry.is_regular_file(error))
            continue;
        // The child may have renamed the file since; its size is then an error.
        const auto size = entry.file_size(error);
        if (!error && static_cast<double>(size) >= *task.limits.file_bytes)
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
    constexpr double longest_wait_s = 1;
    constexpr double file_check_s = 0.005;  // how often the sizes of files are looked at
    const double most_seconds = task.limits.wall_seconds.value_or(HUGE_VAL);
    const auto start = Clock::now();
    const auto seconds_left = [&] {
        return most_seconds - std::chrono::duration<double>(Clock::now() - start).count();
    };
    StartedChild child{task};
    while (true) {
        const auto status = child.ended();
        const bool is_too_long = has_full_file(task);
        child.pass_on(status.has_value());
        if (status)
            return is_too_long ? ChildResult{ChildEnd::FileTooLong, SIGXFSZ}
                               : result_of(*status);
        const double left = seconds_left();
        if (is_too_long || left <= 0) {
            child.end_group();
            child.pass_on(true);
            return is_too_long ? ChildResult{ChildEnd::FileTooLong, SIGXFSZ}
                               : ChildResult{ChildEnd::OutOfTime, SIGKILL};
        }
        const double wait_s = std::min(
            {left, longest_wait_s, task.limits.file_bytes ? file_check_s : HUGE_VAL});
        child.wait(static_cast<int>(std::ceil(1000 * wait_s)));
    }
}

void abandon_children()
{
    constexpr int looks = 200;
    constexpr std::chrono::milliseconds look_interval{5};
    const std::lock_guard lock{registry().mutex};
    std::set<pid_t>& children = registry().children;
    for (const pid_t child : children)
        ::kill(-child, SIGTERM);  // they remove what they have not finished
    const auto has_ended = [](pid_t child) {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(child), &info,
                        WEXITED | WNOHANG | WNOWAIT) != 0 ||
               info.si_pid == child;
    };
    for (int look = 0; look < looks && !std::ranges::all_of(children, has_ended); ++look)
        std::this_thread::sleep_for(look_interval);
    for (const pid_t child : children) {
        ::kill(-child, SIGKILL);
        ::waitpid(child, nullptr, 0);
    }
    children.clear();
    std::error_code ignored;
    for (const fs::path& folder : registry().folders)
        fs::remove_all(folder, ignored);
}

std::vector<std::string> minimal_environment(const fs::path& home)
{
    return {"PATH=/usr/bin:/bin", "LC_ALL=C", "PYTHONNOUSERSITE=1",
            "HOME=" + home.string()};
}

std::vector<std::string> inherited_environment()
{
    constexpr std::array<std::string_view, 5> of_mpi{"OMPI_", "PMIX_", "PMI_", "PRTE_",
                                                     "OPAL_"};
    std::vector<std::string> kept;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text{*variable};
        if (std::ranges::none_of(of_mpi,
                                 [&](auto word) { return text.starts_with(word); }))
            kept.emplace_back(text);
    }
    return kept;
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

fs::path running_program()
{
    std::error_code error;
    fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error)
        throw OutputError{"cannot find the running program: " + error.message()};
    return program;
}

}  // namespace endmill
