// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/setup_options.h"
#include "endmill/machine/kinematics.h"

namespace endmill {

/// A machine, or a family of machines, for which a setup is searched.
struct SearchedMachine {
    std::string name;        ///< word, file as given, or family
    std::string file;        ///< the file that it was read from, or empty
    bool is_family = false;  ///< the machine stands for all machines of its family
    Machine machine;         ///< has the limits of the command line, if given
};

/// The machines of --machine or --family.
/// \throws DomainError unless exactly one of the two is given; FormatError for a bad
///         file, or a folder without machine files.
std::vector<SearchedMachine> setup_machines(const SetupCommandOptions& options);

}  // namespace endmill
