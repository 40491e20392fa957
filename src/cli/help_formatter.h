// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace endmill {

/// The layout of --help. Unlike CLI11's own it marks an option as "(required)", does not
/// call the value of an operand TEXT, and leaves out the lists of options that exclude or
/// need each other: the description of an option states them where they matter.
class HelpFormatter : public CLI::Formatter {
public:
    /// The whole help text, with at most one empty line between its parts.
    std::string make_help(const CLI::App* command, std::string name,
                          CLI::AppFormatMode mode) const override;

    /// The lines of one option. The description begins on a line of its own if fewer than
    /// two blanks would separate it from the name.
    std::string make_option(const CLI::Option* option, bool is_positional) const override;

    /// What follows the name of an option.
    std::string make_option_opts(const CLI::Option* option) const override;
};

}  // namespace endmill
