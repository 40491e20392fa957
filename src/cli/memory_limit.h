// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace endmill {

/// Lets the operating system refuse memory to this process once it has taken a tenth more
/// than `gib` from now on, so that an allocation beyond it fails with std::bad_alloc. What
/// can be estimated is checked before it is allocated; this limit stops what grows beyond
/// its estimate. It counts what the process has allocated, whether used or not. The stacks of
/// `threads` threads and 32 MiB for everything small are added.
///
/// It has no effect where the system does not know such a limit, and with sanitizers, which
/// take memory of their own.
/// \param gib the limit, GiB.
/// \param threads number of threads; nothing: one for each core.
/// \param command name of the command, for the message.
void limit_memory(double gib, std::optional<int> threads, const std::string& command);

/// Replaces what the message advises. \pre limit_memory was called before.
/// \param advice what needs less memory, such as "a smaller file needs less".
void advise_less_memory(const std::string& advice);

/// The message for memory that is not available: the limit and the options of the command
/// that need less. The limit is --max-memory, or that of the system if it is lower. It needs
/// no memory.
/// \param as_json whether as a JSON object. \return one line with its end.
const char* lack_of_memory_message(bool as_json) noexcept;

}  // namespace endmill
