// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace endmill {

/// Calls `body(begin, end)` on ranges that together cover the numbers from 0 to count - 1
/// once, on all threads that are allowed.
///
/// The division into ranges and the thread that processes a range vary from run to run. A
/// body must therefore write its results by index.
///
/// \throws whatever a body throws. If several throw, the exception of the lowest range is
///         rethrown. It is the one for the lowest index if each body processes its range
///         in order and stops at its first fault.
void parallel_for(std::size_t count,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Calls `work(i)` for the numbers from 0 to count - 1 once, on all threads that are allowed,
/// and `finish(i)` after it. The calls of `finish` follow one another in the order of the
/// numbers, as soon as the work before is done, while other threads still work. Numbers near
/// the end may be worked on before the first is finished, so their results need memory.
///
/// \param finish is called by any of the threads.
/// \throws what the calls throw if they are made in the order work(0), finish(0), work(1),
///         finish(1) and so on. Nothing is finished after the call that throws.
void parallel_in_order(std::size_t count, const std::function<void(std::size_t i)>& work,
                       const std::function<void(std::size_t i)>& finish);

/// Limits `parallel_for` to `count` threads, from now on and for the whole process.
/// \throws DomainError unless 1 <= count <= 1024.
void set_thread_count(int count);

}  // namespace endmill
