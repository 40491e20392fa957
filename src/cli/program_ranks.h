// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "cli/exit_code.h"
#include "endmill/job/ranks.h"

/// \file
/// The processes that share the work of a command. In `endmill` there is one
/// (one_process/program_ranks.cpp). Started by `mpirun`, `endmill` becomes `endmill-mpi`, in
/// which there are as many as `mpirun -n` says (mpi/program_ranks.cpp).
///
/// Rank 0 reads, decides, writes and prints; the others compute shares for it and print
/// nothing. A command that divides its work gives the other ranks a function of their own; it
/// may return before rank 0 ends, or serve rank 0 until the end.

namespace endmill {

/// Begins the work among ranks. In `endmill` it starts `endmill-mpi` in place of this program
/// if `mpirun` started several processes for a command that divides its work.
/// \param arguments the words of the command line, with the program's name.
/// \throws DomainError if `endmill-mpi` is not installed.
void begin_ranks(std::span<char*> arguments);

/// The ranks of this program. \pre begin_ranks was called.
Ranks& program_ranks();

/// Looks whether another rank failed, or rank 0 ended the work. Callbacks of progress call
/// it, so that no rank works in vain. It takes about a microsecond.
/// \throws on rank 0 the error of the rank that failed; elsewhere what ends that rank.
void check_ranks();

/// Ends the work of this rank. Rank 0 ends all ranks with its exit code; the others wait for
/// it.
/// \return the exit code of rank 0.
ExitCode end_ranks(ExitCode exit);

/// The same if the current exception ends this rank. Rank 0 reports the exception; the others
/// send it to rank 0, whose work it ends unless that fails itself.
ExitCode end_ranks_by_exception(bool json_errors) noexcept;

}  // namespace endmill
