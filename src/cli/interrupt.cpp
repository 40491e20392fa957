// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.h"

#include <atomic>
#include <csignal>
#include <ctime>
#include <exception>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>

#include "endmill/files/output_folder.h"
#include "endmill/job/child_process.h"

namespace endmill {
namespace {

std::atomic<bool> is_interrupted = false;

bool is_ignored(int signal_number)
{
    struct sigaction action {};
    return sigaction(signal_number, nullptr, &action) == 0 &&
           action.sa_handler == SIG_IGN;
}

// Ends the program at the first of the signals.
void wait_for(const sigset_t& signals)
{
    int number = 0;
    if (sigwait(&signals, &number) != 0)
        return;
    is_interrupted = true;
    abandon_children();
    OutputFolder::abandon_all();
    _exit(128 + number);
}

// At a hard limit of processor time the system kills without a signal that can be
// handled. Where the soft limit, which is signalled, is the same, as `ulimit -t` sets it,
// a timer sends the signal while there is time left to remove what is unfinished.
void signal_before_hard_limit()
{
    constexpr long time_left_ns = 200'000'000;
    rlimit limit{};
    if (getrlimit(RLIMIT_CPU, &limit) != 0 || limit.rlim_max == RLIM_INFINITY ||
        limit.rlim_max == 0 || limit.rlim_cur < limit.rlim_max)
        return;
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGXCPU;
    timer_t timer{};
    if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer) != 0)
        return;
    itimerspec when{};
    when.it_value.tv_sec = static_cast<std::time_t>(limit.rlim_max - 1);
    when.it_value.tv_nsec = 1'000'000'000 - time_left_ns;
    timer_settime(timer, TIMER_ABSTIME, &when, nullptr);
}

}  // namespace

void handle_interrupts()
{
    std::signal(SIGXFSZ, SIG_IGN);
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU})
        if (!is_ignored(number))  // nohup and shells with background jobs set SIG_IGN
            sigaddset(&signals, number);
    // Block the signals here and in all later threads. Only the waiting thread receives
    // them, and unlike a signal handler it may take locks and free memory.
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    signal_before_hard_limit();
    try {
        std::thread{[signals] { wait_for(signals); }}.detach();
    } catch (const std::exception&) {
        // Without a thread the signals end the program at once. The next one that writes
        // to the same place removes what is left.
        pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    }
}

void wait_if_interrupted()
{
    while (is_interrupted)
        pause();
}

}  // namespace endmill
