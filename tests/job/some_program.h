// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "endmill/job/program_options.h"

namespace endmill {

/// A description of two commands, for tests: plan has an input, and options of all kinds;
/// numbers has neither input nor files.
inline ProgramDescription some_program(const std::filesystem::path& program = "/bin/true")
{
    return {program,
            "1.2.3",
            {{"plan",
              {{"--cutter", OptionValue::Text},
               {"--scallop", OptionValue::Text},
               {"--chord-tolerance", OptionValue::Text},
               {"--max-memory", OptionValue::Text},
               {"--arcs", OptionValue::None},
               {"--tool-file", OptionValue::File}},
              true,
              true},
             {"numbers", {{"--planes", OptionValue::Text}}, false, false}}};
}

/// "CODE message" of the Error that `act` throws; "accepted" if it throws none.
template <class Act>
std::string error_of(const Act& act)
{
    try {
        act();
        return "accepted";
    } catch (const Error& error) {
        return error.code() + ' ' + error.what();
    }
}

}  // namespace endmill
