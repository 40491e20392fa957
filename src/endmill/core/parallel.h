// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace endmill {

/// Calls `body(begin, end)` on ranges that cover 0 … count once each, on all allowed
/// threads. Which thread runs a range, and how 0 … count is cut, is not defined: a body
/// writes its results by index, so that they do not depend on it.
/// Of what bodies throw the exception of the lowest range is thrown again here: if each goes
/// through its range in order, that of the lowest index at fault.
void parallel_for(std::size_t count,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Limits `parallel_for`, from here on in this process, to `count` threads.
/// \throws DomainError unless 1 <= count <= 1024.
void set_thread_count(int count);

}  // namespace endmill
