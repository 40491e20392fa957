// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/read_file.h"
#include "endmill/machine/kinematics.h"

namespace endmill {

/// A machine that the command line names.
struct MachineArgument {
    Machine machine;
    std::string file;  ///< file of the machine; empty for a word
};

/// The machine of the file `text`, or of the configuration word `text`. A word has no
/// offsets and no limits. The configuration of the result need not be valid.
/// \throws FormatError as `read_machine` if `text` ends in .json or names an existing
///         file; DomainError if it is neither a file nor a word.
MachineArgument machine_argument(const std::string& text, const ReadLimits& limits);

}  // namespace endmill
