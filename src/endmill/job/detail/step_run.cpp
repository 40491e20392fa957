// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/step_run.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "endmill/core/text.h"
#include "endmill/files/detail/json_tree.h"
#include "endmill/files/read_file.h"
#include "endmill/job/child_process.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using Tree = nlohmann::json;

constexpr int limit_exit = 6;
constexpr int fault_exit = 7;
constexpr int signal_exit = 128;
constexpr std::size_t longest_line = 300;  // of what is no message of endmill

// The lines that a command wrote to its standard error, sorted.
class MessageLines {
public:
    explicit MessageLines(const StepRun& run) : run_{run} {}

    void take(std::string_view line);

    std::string code;                   // of the error
    std::string error;                  // its message
    std::string last;                   // last line that is nothing else
    std::vector<std::string> warnings;  // without the name of the program

private:
    void take_progress(const Tree& object) const;

    const StepRun& run_;
};

// A text of an object; empty if it has none under this key.
std::string text_in(const Tree& object, const char* key)
{
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::optional<double> number_in(const Tree& object, const char* key)
{
    const auto found = object.find(key);
    return found != object.end() && found->is_number()
               ? std::optional{found->get<double>()}
               : std::nullopt;
}

void MessageLines::take_progress(const Tree& object) const
{
    if (run_.progress)
        run_.progress({text_in(object, "work"), number_in(object, "share"),
                       number_in(object, "left_s")});
}

void MessageLines::take(std::string_view line)
{
    constexpr std::string_view warning = "endmill: warning: ";
    if (line.starts_with(warning)) {
        warnings.push_back(printable(line.substr(warning.size())));
        if (run_.warning)
            run_.warning(warnings.back());
        return;
    }
    const Tree tree = Tree::parse(line, nullptr, false);
    const auto object = [&](const char* key) {
        return tree.is_object() && tree.contains(key) && tree[key].is_object();
    };
    if (object("error")) {
        code = printable(text_in(tree["error"], "code"));
        error = printable(text_in(tree["error"], "message"));
    } else if (object("progress")) {
        take_progress(tree["progress"]);
    } else {
        last = printable(line, longest_line);
    }
}

// A number for a message.
std::string rounded(double number)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", number);
    return text.data();
}

// What the summary of `verify` says of its verdict.
std::string verdict_in(const fs::path& folder)
{
    const fs::path file = folder / "summary.json";
    const auto summary = json_tree(read_file(file), shown_path(file), {});
    std::string text = text_in(*summary, "verdict");
    for (const auto& [key, word] : {std::pair{"max_gouge_mm", "gouge"},
                                    std::pair{"max_scallop_mm", "remaining stock"}})
        if (const auto mm = number_in(*summary, key))
            text += std::string{", "} + word + " up to " + rounded(*mm) + " mm";
    return text;
}

// The message for an answer that is no, where the command gives none.
std::string message_of_no(const StepRun& run)
{
    switch (run.step) {
        case JobStep::Setup:
        case JobStep::Clamp:
            return "the part is not machinable as asked";
        case JobStep::Verify:
            return "the path is not clean: " + verdict_in(run.folder);
        case JobStep::Feed:
            return "some moves have no feasible feed";
        case JobStep::Plan:
        case JobStep::Trim:
        case JobStep::Post:
            return "the path is not within its tolerances";
    }
    return {};
}

int exit_of(const ChildResult& result)
{
    switch (result.end) {
        case ChildEnd::Exited:
            return result.code;
        case ChildEnd::Signalled:
            return signal_exit + result.code;
        case ChildEnd::OutOfTime:
        case ChildEnd::FileTooLong:
            return limit_exit;
        case ChildEnd::NotStarted:
            break;
    }
    return fault_exit;
}

// Why a command did not end with yes.
std::string reason_for(const StepRun& run, const ChildResult& result,
                       const MessageLines& lines, bool is_no)
{
    const std::string& message = lines.error.empty() ? lines.last : lines.error;
    if (result.end == ChildEnd::Signalled)
        return "the command was ended by signal " + std::to_string(result.code) +
               (message.empty() ? "" : ": ") + message;
    if (!message.empty())
        return message;
    return is_no ? message_of_no(run)
                 : "the command ended with exit code " + std::to_string(result.code);
}

}  // namespace

StepEnd run_step(const StepRun& run)
{
    MessageLines lines{run};
    ChildTask task{.program = run.program,
                   .arguments = {std::string{job_step_command(run.step)}}};
    task.arguments.insert(task.arguments.end(), run.arguments.begin(),
                          run.arguments.end());
    task.arguments.insert(task.arguments.end(),
                          {"--output=" + run.folder.string(), "--json", "--json-errors",
                           "--json-progress"});
    task.environment = inherited_environment();
    task.error_line = [&](std::string_view line) { lines.take(line); };
    const auto start = std::chrono::steady_clock::now();
    const ChildResult result = run_child(task);
    StepEnd end{.exit = exit_of(result),
                .is_no = result.end == ChildEnd::Exited && result.code == 1,
                .code = lines.code.empty() ? "E_STEP" : lines.code};
    end.wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (end.exit != 0)
        end.reason = reason_for(run, result, lines, end.is_no);
    end.warnings = std::move(lines.warnings);
    return end;
}

std::string advice_for(JobStep step)
{
    switch (step) {
        case JobStep::Setup:
        case JobStep::Clamp:
            return "another machine, wider limits or setup.max_setups";
        case JobStep::Plan:
            return "a smaller tool, larger tolerances or a trim step";
        case JobStep::Trim:
            return "trim.method envelope or a smaller tool";
        case JobStep::Feed:
            return "larger limits of the tool or feed.allow_infeasible";
        case JobStep::Verify:
            return "another plan, larger tolerances or a finer verify.resolution";
        case JobStep::Post:
            return "another control";
    }
    return {};
}

}  // namespace endmill
