// SPDX-License-Identifier: GPL-3.0-or-later
// The program endmill. It parses the command line, runs one command, and reports errors by
// a message and an exit code.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include <gmp.h>
#include <unistd.h>

#include "build_facts.h"
#include "cli/cad_files.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/help_formatter.h"
#include "cli/interrupt.h"
#include "cli/mpi_launch.h"
#include "cli/program_ranks.h"
#include "cli/usage_message.h"
#include "endmill/files/output_folder.h"

namespace endmill {
namespace {

constexpr const char* footer =
    "Example:\n"
    "  endmill info datasets/surfaces/saddle.json\n"
    "  endmill plan datasets/surfaces/saddle.json --strategy iso -o saddle\n"
    "  endmill verify saddle/u/toolpath.csv --resolution 0.5\n\n"
    "Exit status:\n"
    "  0  success, or the answer is yes    4  the geometry does not allow the task\n"
    "  1  the answer is no, or a gouge     5  output not written\n"
    "  2  wrong command line               6  a limit was reached, such as memory\n"
    "  3  missing or malformed input file  7  a fault of endmill\n"
    "  128 + N  ended by signal N: 130 interrupted, 143 terminated";

// The words of the command line.
std::span<char*> arguments;

bool is_json_errors(const char* word)
{
    return std::string_view{word} == "--json-errors";
}

ExitCode run(int argc, char** argv, bool json_errors)
{
    CLI::App program{"Plans, checks and posts tool paths for free-form surfaces.",
                     "endmill"};
    program.formatter(std::make_shared<HelpFormatter>());
    program.footer(footer);
    program.set_version_flag(
        "--version",
        "endmill " + std::string{program_version} +
            (mpi_program().empty() ? " (without endmill-mpi" : " (with endmill-mpi") +
            (cad_program().empty() ? ", without endmill-cad)" : ", with endmill-cad)"));
    program.require_subcommand(1);
    Action action;
    add_info_command(program, action);
    add_import_command(program, action);
    add_sample_command(program, action);
    add_plan_command(program, action);
    add_trim_command(program, action);
    add_verify_command(program, action);
    add_post_command(program, action);
    add_feed_command(program, action);
    add_coefficients_command(program, action);
    add_toollife_command(program, action);
    add_setup_command(program, action);
    add_machine_command(program, action);
    add_eval_command(program, action);
    add_cite_command(program, action);
    add_run_command(program, action);
    add_demo_command(program, action);
    add_sweep_command(program, action);
    add_view_command(program, action);
    try {
        program.parse(argc, argv);
    } catch (const CLI::CallForVersion& version) {
        print(std::string{version.what()} + "\n");
        return ExitCode::Yes;
    } catch (const CLI::ParseError& error) {
        const bool is_help = dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr;
        if (is_help && !names_unknown_command(program)) {
            print(program.help());
            return ExitCode::Yes;
        }
        report_error("E_PARAM", usage_message(program, error), ExitCode::Usage,
                     json_errors);
        return ExitCode::Usage;
    }
    if (const auto message = empty_text_message(program)) {
        report_error("E_PARAM", *message, ExitCode::Usage, json_errors);
        return ExitCode::Usage;
    }
    return action();
}

// Whether the program ends because it got no memory. There may be none for an exception either.
bool lacks_memory()
{
    if (!std::current_exception()) {
        void* const some = std::malloc(1);
        std::free(some);
        return !some;
    }
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return false;
    }
}

[[noreturn]] void end_without_memory()
{
    OutputFolder::abandon_all_unless_busy();
    report_lack_of_memory(std::ranges::any_of(arguments, is_json_errors));
    _exit(static_cast<int>(ExitCode::Limit));
}

// Functions of libraries that must not throw, such as destructors, allocate memory. If there
// is none, the language ends the program here.
[[noreturn]] void end_after_terminate()
{
    if (lacks_memory())
        end_without_memory();
    std::abort();
}

void* checked(void* some)
{
    if (!some)
        end_without_memory();
    return some;
}

// GMP, which computes exact numbers, would abort if it gets no memory.
void end_if_numbers_lack_memory()
{
    mp_set_memory_functions([](std::size_t bytes) { return checked(std::malloc(bytes)); },
                            [](void* some, std::size_t, std::size_t bytes) {
                                return checked(std::realloc(some, bytes));
                            },
                            [](void* some, std::size_t) { std::free(some); });
}

}  // namespace
}  // namespace endmill

int main(int argc, char** argv)
{
    using namespace endmill;
    arguments = {argv, static_cast<std::size_t>(argc)};
    std::set_terminate(end_after_terminate);
    end_if_numbers_lack_memory();
    handle_interrupts();
    const bool json_errors = std::ranges::any_of(arguments, is_json_errors);
    try {
        begin_ranks(arguments);
        return static_cast<int>(end_ranks(run(argc, argv, json_errors)));
    } catch (...) {
        wait_if_interrupted();
        return static_cast<int>(end_ranks_by_exception(json_errors));
    }
}
