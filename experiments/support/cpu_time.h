// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <time.h>

namespace endmill {

/// CPU time of the calling thread so far, in s.
inline double thread_cpu_s()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// CPU time in s of `work()` on this thread: the best of at least one and at most
/// `most_repeats` executions that together take `budget_s`. The best is the least
/// disturbed by other processes.
template <typename Work>
double shortest_cpu_s(double budget_s, const Work& work)
{
    constexpr int most_repeats = 1000;
    double shortest = std::numeric_limits<double>::infinity();
    double used = 0;
    for (int k = 0; k < most_repeats && used < budget_s; ++k) {
        const double begin = thread_cpu_s();
        work();
        const double time = thread_cpu_s() - begin;
        used += time;
        shortest = std::min(shortest, time);
    }
    return shortest;
}

/// The shortest of 25 times in s of each of `count` works. The works are measured in
/// turn, so that other processes disturb all of them equally.
/// \param measure returns the time in s of work number k.
template <typename Measure>
std::vector<double> shortest_in_turns(std::size_t count, const Measure& measure)
{
    constexpr int turns = 25;
    std::vector<double> times(count, std::numeric_limits<double>::infinity());
    for (int turn = 0; turn < turns; ++turn)
        for (std::size_t k = 0; k < count; ++k)
            times[k] = std::min(times[k], measure(k));
    return times;
}

}  // namespace endmill
