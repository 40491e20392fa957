// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

/// From here on SIGINT, SIGTERM and SIGHUP remove all unpublished output and end the program with
/// 128 + the signal's number; a write past the file size limit is an error, not a signal.
/// Call once, before any thread is started.
void handle_interrupts();

/// Returns at once, unless an interrupt is being handled: then it never does, so that the
/// errors which the interrupt causes are not reported as such.
void wait_if_interrupted();

}  // namespace endmill
