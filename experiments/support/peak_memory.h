// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace endmill {

/// Rise of the peak resident memory in bytes by `work`: the peak of a child process that
/// does `work`, minus the peak of a child process that does nothing.
/// \pre this process has no other thread.
/// \throws LimitError if a child process cannot be made, or if it fails.
double peak_memory_bytes(const std::function<void()>& work);

}  // namespace endmill
