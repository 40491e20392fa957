// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/exit_code.h"
#include "endmill/files/read_file.h"

namespace endmill {

/// A summary: keys stay in the order in which they are added.
using Json = nlohmann::ordered_json;

/// What the command line asked for; runs after it was understood as a whole.
using Action = std::function<ExitCode()>;

/// The options that every command has.
struct CommonOptions {
    std::string output;  ///< folder; empty: the command's default
    bool json = false;
    bool quiet = false;
    bool force = false;
    bool json_errors = false;  ///< main looks for it itself: parsing may fail
    ReadLimits limits;
    std::set<std::string>
        given;  ///< names of the options on the command line, as "--gap"
};

/// Adds them to `command`; --threads takes effect at once.
void add_common_options(CLI::App& command, CommonOptions& options);

/// The commands. Each adds itself to `program` and sets `action` when it is chosen.
void add_info_command(CLI::App& program, Action& action);    ///< facts of a part
void add_sample_command(CLI::App& program, Action& action);  ///< a surface as a mesh
void add_plan_command(CLI::App& program, Action& action);    ///< a path for a part
void add_trim_command(CLI::App& program, Action& action);    ///< trim
void add_verify_command(CLI::App& program, Action& action);  ///< what a path leaves
void add_post_command(CLI::App& program, Action& action);    ///< a path for a machine
void add_eval_command(CLI::App& program, Action& action);    ///< a formula by its name
void add_feed_command(CLI::App& program, Action& action);    ///< how fast a path may go
void add_coefficients_command(CLI::App& program,
                              Action& action);  ///< of one engagement
void add_toollife_command(CLI::App& program,
                          Action& action);                    ///< economic cutting speed
void add_machine_command(CLI::App& program, Action& action);  ///< of a machine's axes
void add_setup_command(CLI::App& program, Action& action);    ///< how a part is to stand
void add_cite_command(CLI::App& program, Action& action);     ///< the sources

}  // namespace endmill
