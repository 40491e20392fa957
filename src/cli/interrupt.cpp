// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.h"

#include <atomic>
#include <csignal>
#include <exception>
#include <thread>

#include <unistd.h>

#include "cli/child_process.h"
#include "endmill/files/output_folder.h"

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
