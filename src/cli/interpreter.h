// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/machining_data.h"
#include "endmill/files/read_file.h"

namespace endmill {

/// The interpreter that turns a G-code program into moves.
enum class Interpreter {
    Endmill,   ///< the reader of this project
    LinuxCnc,  ///< LinuxCNC's program rs274, run as a child process
};

/// A program for LinuxCNC's interpreter, and its limits.
struct InterpreterTask {
    std::string_view text;         ///< of the program
    std::string file;              ///< name of the program for messages
    std::filesystem::path folder;  ///< a private folder is created in it and removed
    bool block_delete = false;     ///< skip blocks that begin with /
    double most_seconds = 60;      ///< wall time and processor time
    ReadLimits limits = {};        ///< of the memory
    std::vector<NumberedTool> tools = {};  ///< given to the interpreter, all of length 0
};

/// Runs `rs274 -g` on a program and returns its canonical output, for `parse_canonical`.
///
/// Comments of a program can make rs274 run Python code or write log files, and a program
/// can call subprograms in other folders. rs274 therefore gets a copy without comments, and
/// a subprogram name with a folder is refused.
/// \throws DomainError if rs274 is not installed.
/// \throws FormatError E_GCODE, with the line if it is known, for a program that rs274
///         refuses, on which it crashes, or that calls a subprogram in another folder.
/// \throws LimitError at the limit of time or output; OutputError if the folder cannot be
///         used or rs274 cannot be started.
std::string canonical_output(const InterpreterTask& task);

/// `program` without comments: ( ... ) and from ; to the end of the line. The lines keep
/// their numbers.
std::string without_comments(std::string_view program);

}  // namespace endmill
