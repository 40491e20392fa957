// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace endmill {

/// Bytes by which `work` raises the peak of resident memory, measured in a child process
/// that does nothing else, less the peak of a child that does nothing.
/// \pre no other thread of this process runs.
/// \throws LimitError if there is no child process to be had, or if it fails.
double peak_memory_bytes(const std::function<void()>& work);

}  // namespace endmill
