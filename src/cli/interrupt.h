// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

/// Installs the handling of SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGXCPU, the limit of
/// processor time, which is sent 0.2 s before a hard limit: they end a child process, remove private folders and all unpublished
/// output, and end the program with 128 + the signal's number. If the system has no
/// thread left, they end the program at once. A write past the file size limit becomes
/// an error instead of a signal. Call once, before any thread is started.
void handle_interrupts();

/// Returns immediately unless an interrupt is being handled. During an interrupt it never
/// returns, so that errors which the interrupt causes are not reported.
void wait_if_interrupted();

}  // namespace endmill
