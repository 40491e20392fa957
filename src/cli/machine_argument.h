// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/read_file.h"
#include "endmill/machine/kinematics.h"

namespace endmill {

/// A machine of the command line.
struct MachineArgument {
    Machine machine;
    std::string file;  ///< that it was read from; empty: it was a word
};

/// The machine that `text` is a file of, or the word of; a word has no offsets and no limits.
/// \throws FormatError as `read_machine` for what ends in .json or is there as a file;
///         DomainError for another text that is no word. It may be valid or not.
MachineArgument machine_argument(const std::string& text, const ReadLimits& limits);

}  // namespace endmill
