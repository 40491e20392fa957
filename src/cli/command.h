// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/exit_code.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/read_file.h"

namespace endmill {

/// A summary: keys stay in the order in which they are added.
using Json = nlohmann::ordered_json;

/// The work of the chosen command. It runs after the whole command line has been parsed.
using Action = std::function<ExitCode()>;

/// Bytes of a GiB, the unit of --max-memory.
inline constexpr double one_gib = 0x1p30;

/// The options that every command has.
struct CommonOptions {
    std::string output;  ///< folder; empty: the command's default
    bool json = false;
    bool quiet = false;
    FullFolder full_folder = FullFolder::Refuse;  ///< Accept with --force
    std::optional<int> threads;                   ///< empty: all cores
    bool html = false;           ///< with --html: also write a page of the results
    bool json_progress = false;  ///< progress as lines of JSON, for programs
    bool json_errors = false;    ///< main also finds it itself, since parsing may fail
    ReadLimits limits;
    std::set<std::string>
        given;  ///< names of the options on the command line, as "--gap"
};

/// Adds the common options to `command`. --threads takes effect when it is parsed.
void add_common_options(CLI::App& command, CommonOptions& options);

/// Adds the option --html to a command that writes a folder of results.
void add_html_option(CLI::App& command, CommonOptions& options);

/// Each function adds one command to `program`. The chosen command sets `action`.
void add_info_command(CLI::App& program, Action& action);    ///< report on a part
void add_import_command(CLI::App& program, Action& action);  ///< import a CAD file
void add_sample_command(CLI::App& program, Action& action);  ///< sample as a mesh
void add_plan_command(CLI::App& program, Action& action);    ///< plan a path
void add_trim_command(CLI::App& program, Action& action);    ///< trim offset sections
void add_verify_command(CLI::App& program, Action& action);  ///< simulate and verify
void add_post_command(CLI::App& program, Action& action);    ///< write a machine program
void add_eval_command(CLI::App& program, Action& action);    ///< evaluate a formula
void add_feed_command(CLI::App& program, Action& action);    ///< plan feeds
void add_coefficients_command(CLI::App& program,
                              Action& action);  ///< cutting coefficients
void add_toollife_command(CLI::App& program,
                          Action& action);                    ///< economic tool life
void add_machine_command(CLI::App& program, Action& action);  ///< report on a machine
void add_setup_command(CLI::App& program, Action& action);    ///< find a setup
void add_sweep_command(CLI::App& program, Action& action);    ///< run many cases
void add_cite_command(CLI::App& program, Action& action);     ///< list the sources
void add_run_command(CLI::App& program, Action& action);      ///< run a job
void add_demo_command(CLI::App& program, Action& action);     ///< run an example
void add_view_command(CLI::App& program, Action& action);     ///< write a page

}  // namespace endmill
