// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

/// Exit status of the program.
enum class ExitCode : int {
    Yes = 0,       ///< done, and the answer is yes
    No = 1,        ///< done, and the answer is no
    Usage = 2,     ///< the command line is wrong
    Input = 3,     ///< an input file is missing, unreadable or malformed
    Geometry = 4,  ///< the geometry does not permit the operation
    Output = 5,    ///< an output could not be written
    Limit = 6,     ///< a limit was reached
    Fault = 7,     ///< a fault of the program itself
};

}  // namespace endmill
