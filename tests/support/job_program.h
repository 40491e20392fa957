// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "endmill/job/program_options.h"

namespace endmill {

/// The content of a file.
inline std::string content_of(const std::filesystem::path& file)
{
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

inline void put(const std::filesystem::path& file, const std::string& content)
{
    std::filesystem::create_directories(file.parent_path());
    std::ofstream{file, std::ios::binary} << content;
}

/// A shell script in place of the program. It appends its arguments to calls.txt beside it,
/// writes summary.json and toolpath.csv to its --output, and runs `more` with the name of the
/// command in $1 and that folder in $out.
inline ProgramDescription job_program(const std::filesystem::path& folder,
                                      const std::string& more = "")
{
    const std::filesystem::path script = folder / "program.sh";
    put(script,
        "#!/bin/sh\n"
        "echo \"$@\" >> '" +
            (folder / "calls.txt").string() +
            "'\n"
            "for word in \"$@\"; do case $word in --output=*) "
            "out=${word#--output=};; esac; done\n"
            "mkdir -p \"$out\"\n"
            "echo \"{\\\"made_by\\\": \\\"$1\\\", \\\"work_s\\\": $$}\" > "
            "\"$out/summary.json\"\n"
            "echo path > \"$out/toolpath.csv\"\n" +
            more + "\n");
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    const ProgramOption cutter{"--cutter", OptionValue::Text};
    const ProgramOption machine{"--machine", OptionValue::FileOrWord};
    const ProgramOption scallop{"--scallop", OptionValue::Text};
    const ProgramOption tool{"--tool", OptionValue::File};
    return {script,
            "1.0",
            {{"setup", {machine, tool, {"--max-setups", OptionValue::Text}}},
             {"plan", {cutter, scallop, {"--axis-mode", OptionValue::Text}, tool}},
             {"trim", {cutter, {"--method", OptionValue::Text}}},
             {"feed", {{"--allow-infeasible", OptionValue::None}, machine}},
             {"verify", {{"--resolution", OptionValue::Text}, tool}},
             {"post", {{"--arcs", OptionValue::None}, machine}}}};
}

}  // namespace endmill
