// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/peak_memory.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

double peak_of_child(const std::function<void()>& work)
{
    const pid_t child = fork();
    if (child == 0) {
        try {
            work();
        } catch (...) {
            _exit(1);
        }
        _exit(0);
    }
    int status = 0;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0)
        throw LimitError{"peak_memory_bytes: the child process failed"};
    constexpr double bytes_a_kibibyte = 1024;  // unit of ru_maxrss
    return bytes_a_kibibyte * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

double peak_memory_bytes(const std::function<void()>& work)
{
    const double baseline = peak_of_child([] {});
    return peak_of_child(work) - baseline;
}

}  // namespace endmill
