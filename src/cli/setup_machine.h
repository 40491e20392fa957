// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/setup_options.h"
#include "endmill/machine/kinematics.h"

namespace endmill {

/// A machine that a part is to be set up on.
struct SetupMachine {
    std::string name;        ///< its word, or its file as given, or its family
    std::string file;        ///< that it was read from; empty: none
    bool is_family = false;  ///< stands for all machines of its family
    Machine machine;         ///< its limits those of the command line, where given
};

/// The machines of --machine or --family.
/// \throws DomainError unless one of the two is given; FormatError for a file or a folder
///         without a machine file.
std::vector<SetupMachine> setup_machines(const SetupCommandOptions& options);

}  // namespace endmill
