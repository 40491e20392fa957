// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "cli/command.h"

namespace endmill {

/// The given arguments by name.
using Numbers = std::map<std::string, double>;

/// A number that a formula takes, as the option `--name`.
struct Argument {
    const char* name;
    const char* unit;  ///< as the help text shows it
    const char* help;
    bool is_positive;
};

/// A closed formula of the library.
struct Formula {
    const char* name;
    const char* help;
    const char* example;  ///< its options, such as "--radius 5"
    std::vector<Argument> arguments;
    Json (*value)(const Numbers&);  ///< evaluates it; throws like the library
};

/// All formulas of `endmill eval`, in the order of its list.
std::span<const Formula> eval_formulas();

}  // namespace endmill
