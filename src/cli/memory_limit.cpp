// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/memory_limit.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <string_view>
#include <thread>

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include "cli/command.h"

namespace endmill {
namespace {

// The checks before an allocation estimate; this share allows for what they miss.
constexpr double share_of_limit = 1.1;
constexpr double spare_bytes = 32 * 0x1p20;

// What needs less memory, for each command that may need much.
struct LessMemory {
    std::string_view command;
    const char* advice;
};
constexpr std::array advices{
    LessMemory{"info", "a smaller file needs less"},
    LessMemory{"sample", "a larger --chord-tolerance needs less"},
    LessMemory{"plan", "a larger --chord-tolerance or --scallop needs less"},
    LessMemory{"trim",
               "fewer planes (--planes), a coarser --grid or a smaller cutter need "
               "less"},
    LessMemory{"verify", "a larger --resolution or a shorter path needs less"},
    LessMemory{"post", "a shorter path needs less"},
    LessMemory{"feed", "a larger --resolution or a shorter path needs less"},
    LessMemory{"setup", "a coarser --sphere or a larger --chord-tolerance needs less"},
};

constexpr std::size_t message_size = 256;
std::array<char, message_size> message{"endmill: error: out of memory\n"};
std::array<char, message_size> json_message{
    R"({"error":{"code":"E_LIMIT","exit":6,"message":"out of memory"}})"
    "\n"};

void prepare_messages(double gib, const std::string& command)
{
    const auto* const found = std::ranges::find(advices, command, &LessMemory::command);
    const char* const advice = found != advices.end() ? found->advice : "";
    const char* const mark = found != advices.end() ? "; " : "";
    std::snprintf(message.data(), message.size(),
                  "endmill: error: out of memory; expected at most %g GiB "
                  "(--max-memory)%s%s\n",
                  gib, mark, advice);
    std::snprintf(json_message.data(), json_message.size(),
                  R"({"error":{"code":"E_LIMIT","exit":6,"message":"out of memory; )"
                  R"(expected at most %g GiB (--max-memory)%s%s"}})"
                  "\n",
                  gib, mark, advice);
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// The bytes that count towards the limit now; nothing if the system does not tell them.
std::optional<double> allocated_bytes()
{
    std::ifstream file{"/proc/self/statm"};
    double size = 0;
    double resident = 0;
    double shared = 0;
    double text = 0;
    double library = 0;
    double writable = 0;
    if (!(file >> size >> resident >> shared >> text >> library >> writable))
        return std::nullopt;
    return writable * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double bytes_a_stack()
{
    pthread_attr_t attributes;
    std::size_t bytes = 0;
    if (pthread_getattr_default_np(&attributes) == 0) {
        pthread_attr_getstacksize(&attributes, &bytes);
        pthread_attr_destroy(&attributes);
    }
    return static_cast<double>(bytes);
}

void limit_allocation(double gib, int threads)
{
    constexpr double most = 9e18;  // below 2^63
    const auto allocated = allocated_bytes();
    rlimit limit{};
    if (!allocated || ::getrlimit(RLIMIT_DATA, &limit) != 0)
        return;
    const double bytes = *allocated + share_of_limit * gib * one_gib + spare_bytes +
                         (threads + 1) * bytes_a_stack();
    limit.rlim_cur = std::min(limit.rlim_cur, static_cast<rlim_t>(std::min(bytes, most)));
    ::setrlimit(RLIMIT_DATA, &limit);
}
#else
void limit_allocation(double, int) {}
#endif

}  // namespace

void limit_memory(double gib, std::optional<int> threads, const std::string& command)
{
    prepare_messages(gib, command);
    limit_allocation(
        gib, threads.value_or(static_cast<int>(std::thread::hardware_concurrency())));
}

const char* lack_of_memory_message(bool as_json) noexcept
{
    return as_json ? json_message.data() : message.data();
}

}  // namespace endmill
