// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/help_formatter.h"

#include <utility>

namespace endmill {

std::string HelpFormatter::make_help(const CLI::App* command, std::string name,
                                     CLI::AppFormatMode mode) const
{
    return CLI::detail::find_and_replace(
        CLI::Formatter::make_help(command, std::move(name), mode), "\n\n\n", "\n\n");
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const
{
    const std::string& value = option->get_type_name();
    std::string text;
    if (option->get_type_size() != 0 && !value.empty() && value != "TEXT")
        text += " " + value;
    if (option->get_required())
        text += " (required)";
    return text;
}

}  // namespace endmill
