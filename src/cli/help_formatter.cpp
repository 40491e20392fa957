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

std::string HelpFormatter::make_option(const CLI::Option* option,
                                       bool is_positional) const
{
    constexpr std::size_t least_gap = 2;
    const std::string name =
        "  " + make_option_name(option, is_positional) + make_option_opts(option);
    const std::string description = make_option_desc(option);
    if (description.empty())
        return name + "\n";
    const std::size_t width = get_column_width();
    return name.size() + least_gap > width
               ? name + "\n" + std::string(width, ' ') + description + "\n"
               : name + std::string(width - name.size(), ' ') + description + "\n";
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
