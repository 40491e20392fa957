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

constexpr std::size_t message_size = 384;
std::array<char, message_size> message{"endmill: error: out of memory\n"};
std::array<char, message_size> json_message{
    R"({"error":{"code":"E_LIMIT","exit":6,"message":"out of memory"}})"
    "\n"};

// What limits the memory of this process.
struct Limit {
    double gib = 0;
    const char* name = "--max-memory";
};
Limit in_force;

void prepare_messages(const std::string& advice)
{
    const char* const mark = advice.empty() ? "" : "; ";
    std::snprintf(message.data(), message.size(),
                  "endmill: error: out of memory; expected at most %.4g GiB (%s)%s%s\n",
                  in_force.gib, in_force.name, mark, advice.c_str());
    std::snprintf(json_message.data(), json_message.size(),
                  R"({"error":{"code":"E_LIMIT","exit":6,"message":"out of memory; )"
                  R"(expected at most %.4g GiB (%s)%s%s"}})"
                  "\n",
                  in_force.gib, in_force.name, mark, advice.c_str());
}

std::string advice_for(const std::string& command)
{
    const auto* const found = std::ranges::find(advices, command, &LessMemory::command);
    return found != advices.end() ? found->advice : "";
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// The bytes of this process; nothing if the system does not tell them.
struct ProcessSize {
    double address_space;
    double allocated;
};
std::optional<ProcessSize> process_size()
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
    const auto page = static_cast<double>(sysconf(_SC_PAGESIZE));
    return ProcessSize{size * page, writable * page};
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

// Names the limit of the system that leaves this process less than `more` bytes, if any does.
void name_lower_limit(double more, const ProcessSize& size)
{
    const auto consider = [&](auto resource, const char* name, double taken) {
        rlimit limit{};
        if (::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ||
            static_cast<double>(limit.rlim_cur) - taken >= more)
            return;
        more = static_cast<double>(limit.rlim_cur) - taken;
        in_force = {static_cast<double>(limit.rlim_cur) / one_gib, name};
    };
    consider(RLIMIT_AS, "the address space that the system allows, ulimit -v",
             size.address_space);
    consider(RLIMIT_DATA, "the data that the system allows, ulimit -d", size.allocated);
}

void limit_allocation(double gib, int threads)
{
    constexpr double most = 9e18;  // below 2^63
    const auto size = process_size();
    rlimit limit{};
    if (!size || ::getrlimit(RLIMIT_DATA, &limit) != 0)
        return;
    const double more =
        share_of_limit * gib * one_gib + spare_bytes + (threads + 1) * bytes_a_stack();
    name_lower_limit(more, *size);
    limit.rlim_cur = std::min(
        limit.rlim_cur, static_cast<rlim_t>(std::min(size->allocated + more, most)));
    ::setrlimit(RLIMIT_DATA, &limit);
}
#else
void limit_allocation(double, int) {}
#endif

}  // namespace

void limit_memory(double gib, std::optional<int> threads, const std::string& command)
{
    in_force = {.gib = gib};
    limit_allocation(
        gib, threads.value_or(static_cast<int>(std::thread::hardware_concurrency())));
    prepare_messages(advice_for(command));
}

void advise_less_memory(const std::string& advice)
{
    prepare_messages(advice);
}

const char* lack_of_memory_message(bool as_json) noexcept
{
    return as_json ? json_message.data() : message.data();
}

}  // namespace endmill
