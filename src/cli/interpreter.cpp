// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interpreter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <system_error>

#include <fmt/format.h>

#include "cli/command.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/job/child_process.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/program.h"

namespace endmill {
namespace {

// The interpreter keeps at most 1000 tools.
constexpr int most_tools = 1000;
constexpr int most_listed_tools = 900;  // leaves room for greater numbers
// Share of the memory limit for its output, from which the path is then made.
constexpr double output_share = 0.25;
constexpr double most_memory_gib = 2;  // address space; rs274 needs a tenth
constexpr int most_open_files = 64;

bool is_blank_or_tab(char letter)
{
    return letter == ' ' || letter == '\t';
}

// The line without blanks and in lower case, as the interpreter compares it.
std::string squeezed(std::string_view line)
{
    std::string text;
    for (const char letter : line)
        if (!is_blank_or_tab(letter) && letter != '\r')
            text += 'A' <= letter && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a')
                                                   : letter;
    return text;
}

std::vector<std::string> squeezed_lines(std::string_view text)
{
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(squeezed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

// Refuses a CR within a line: rs274 would skip it, and a comment would not end there.
void refuse_lone_returns(const InterpreterTask& task)
{
    std::size_t number = 1;
    for (std::size_t at = 0; at < task.text.size(); ++at) {
        if (task.text[at] == '\n')
            ++number;
        if (task.text[at] != '\r')
            continue;
        const std::size_t next = task.text.find_first_not_of('\r', at);
        if (next != std::string_view::npos && task.text[next] != '\n')
            throw FormatError{"E_GCODE",
                              {task.file, std::to_string(number),
                               "a carriage return without a line feed",
                               "lines that end with LF or CRLF"}};
    }
}

// Whether the line names a subprogram with a folder, as in o<../other> call.
bool names_folder(std::string_view line)
{
    for (std::size_t at = line.find("o<"); at != std::string_view::npos;
         at = line.find("o<", at + 1)) {
        const std::string_view name =
            line.substr(at, std::min(line.find('>', at), line.size()) - at);
        if (name.find('/') != std::string_view::npos)
            return true;
    }
    return false;
}

void refuse_folders(const std::vector<std::string>& lines, const std::string& file)
{
    const auto found = std::ranges::find_if(lines, names_folder);
    if (found != lines.end())
        throw FormatError{"E_GCODE",
                          {file, std::to_string(found - lines.begin() + 1),
                           "a subprogram in another folder, " + printable(*found, 40),
                           "subprograms in the same file"}};
}

// Whether the line has the G code `code`, such as "g28", but not "g28.1" or "g280".
bool has_code(std::string_view line, std::string_view code)
{
    for (std::size_t at = line.find(code); at != std::string_view::npos;
         at = line.find(code, at + 1)) {
        const std::size_t after = at + code.size();
        if (after == line.size() ||
            std::string_view{".0123456789"}.find(line[after]) == std::string_view::npos)
            return true;
    }
    return false;
}

// Refuses what depends on data that rs274 does not have here: it would go on with zeros.
void refuse_unknown_data(const InterpreterTask& task,
                         const std::vector<std::string>& lines)
{
    const auto refuse_codes = [&](std::span<const std::string_view> codes,
                                  const std::string& found, const std::string& expected) {
        for (std::size_t k = 0; k < lines.size(); ++k)
            for (const std::string_view code : codes)
                if (has_code(lines[k], code))
                    throw FormatError{"E_GCODE",
                                      {task.file, std::to_string(k + 1),
                                       found + ' ' + printable(lines[k], 40), expected}};
    };
    constexpr std::array<std::string_view, 2> compensation{"g41", "g42"};
    if (task.tools.empty())
        refuse_codes(compensation, "cutter compensation without diameters",
                     "--tools FILE with the diameter of each tool, or a path of the tip");
}

bool has_any(const std::vector<std::string>& lines, std::string_view letters)
{
    return std::ranges::any_of(lines, [&](const std::string& line) {
        return line.find_first_of(letters) != std::string::npos;
    });
}

// The interpreter begins at 0, 0, 0, so a height that the program never states would be 0.
void require_height(const InterpreterTask& task, const std::vector<std::string>& lines)
{
    if (has_any(lines, "xy") && !has_any(lines, "z"))
        throw FormatError{
            "E_GCODE",
            {task.file, "", "no absolute Z in " + counted(lines.size(), "line"),
             "a position of X, Y and Z before the first cut"}};
}

void require_motion(const std::string& moves, const InterpreterTask& task,
                    const std::vector<std::string>& lines)
{
    for (const char* const name : {"STRAIGHT_TRAVERSE(", "STRAIGHT_FEED(", "ARC_FEED("})
        if (moves.find(name) != std::string::npos)
            return;
    throw FormatError{"E_GCODE",
                      {task.file, "", "no motion in " + counted(lines.size(), "line"),
                       "at least one G0, G1, G2 or G3 with coordinates"}};
}

// Tool numbers above `most_listed_tools` in the program, which is without comments.
std::set<int> great_tool_numbers(const std::vector<std::string>& lines)
{
    std::set<int> numbers;
    for (const std::string& line : lines)
        for (std::size_t at = line.find('t'); at != std::string::npos;
             at = line.find('t', at + 1)) {
            int number = 0;
            std::from_chars(line.data() + at + 1, line.data() + line.size(), number);
            if (number > most_listed_tools &&
                numbers.size() < std::size_t{most_tools - most_listed_tools})
                numbers.insert(number);
        }
    return numbers;
}

std::string tool_row(int number, double diameter_mm)
{
    return fmt::format("T{0} P{0} D{1:.6f} Z0\n", number,
                       diameter_mm / millimetres_per(ProgramUnit::Inch));
}

// A tool table of LinuxCNC, in inches, as rs274 reads it. Without given tools it lists
// every number, so that no tool change is refused.
std::string tool_table(const InterpreterTask& task, const std::vector<std::string>& lines)
{
    std::string text;
    for (const auto& [number, tool] : task.tools)
        text += tool_row(number, 2 * tool.cutter.radius());
    if (!task.tools.empty())
        return text;
    for (int number = 1; number <= most_listed_tools; ++number)
        text += tool_row(number, 0);
    for (const int number : great_tool_numbers(lines))
        text += tool_row(number, 0);
    return text;
}

std::string content_of(const std::filesystem::path& path)
{
    std::ifstream file{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, {}};
}

// The message of the interpreter: its last lines that are not empty, without the word
// that it always prints first. The last one is often the text of the wrong line.
struct Refusal {
    std::string message;
    std::string line;  // text of the line; may be empty
};

Refusal refusal_in(const std::string& log)
{
    std::vector<std::string> said;
    std::string_view rest = log;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string line = printable(rest.substr(0, end), 200);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (!line.empty() && line != "executing")
            said.push_back(line);
    }
    if (said.empty())
        return {"it gives no reason", ""};
    if (said.size() == 1)
        return {said.front(), ""};
    return {said[said.size() - 2], said.back()};
}

// The number of the only line with this text; empty if there is none or several.
std::string place_of(const std::string& line, const std::vector<std::string>& lines)
{
    const std::string wanted = squeezed(line);
    const auto first = std::ranges::find(lines, wanted);
    if (wanted.empty() || first == lines.end() ||
        std::find(first + 1, lines.end(), wanted) != lines.end())
        return "";
    return std::to_string(first - lines.begin() + 1);
}

[[noreturn]] void refuse(const InterpreterTask& task, const std::string& log,
                         const std::vector<std::string>& lines)
{
    const Refusal refusal = refusal_in(log);
    const std::string line = refusal.line.empty() ? "" : ": " + refusal.line;
    throw FormatError{"E_GCODE",
                      {task.file, place_of(refusal.line, lines),
                       "LinuxCNC's rs274 refuses the program: " + refusal.message + line,
                       "a program that LinuxCNC accepts"}};
}

ChildLimits limits_of(const InterpreterTask& task)
{
    return {.wall_seconds = task.most_seconds,
            .processor_seconds = task.most_seconds,
            .address_space_bytes = one_gib * most_memory_gib,
            .file_bytes = one_gib * output_share * task.limits.max_memory_gib,
            .open_files = most_open_files};
}

// Throws unless the interpreter accepted the program.
void require_accepted(const ChildResult& result, const InterpreterTask& task,
                      const std::string& log, const std::vector<std::string>& lines)
{
    switch (result.end) {
        case ChildEnd::NotStarted:
            throw OutputError{task.file +
                              ": cannot start rs274: " + refusal_in(log).message +
                              "; expected a working program and less strict limits of "
                              "the system"};
        case ChildEnd::Exited:
            if (result.code != 0)
                refuse(task, log, lines);
            return;
        case ChildEnd::OutOfTime:
            throw LimitError{fmt::format(
                "{}: LinuxCNC's rs274 was ended after {:g} s (--interpreter-seconds); "
                "expected a program without an endless loop, or a longer time",
                task.file, task.most_seconds)};
        case ChildEnd::FileTooLong:
            throw LimitError{fmt::format(
                "{}: the moves of LinuxCNC's rs274 exceed {:g} GiB; expected a program "
                "without an endless loop, or a larger --max-memory",
                task.file, output_share * task.limits.max_memory_gib)};
        case ChildEnd::Signalled:
            throw FormatError{"E_GCODE",
                              {task.file, "",
                               fmt::format("LinuxCNC's rs274 ended with a fault ({})",
                                           strsignal(result.code)),
                               "a program that LinuxCNC accepts"}};
    }
}

}  // namespace

std::string without_comments(std::string_view program)
{
    std::string text;
    text.reserve(program.size());
    bool is_inside = false;   // of ( ... )
    bool is_after = false;    // a semicolon
    std::size_t opening = 0;  // length of `text` where the comment begins
    for (const char letter : program) {
        if (letter == '\n') {
            if (is_inside) {  // the interpreter complains of a comment that is not closed
                text.resize(opening);
                text += '(';
            }
            is_inside = is_after = false;
        } else if (is_inside || is_after) {
            is_inside = is_inside && letter != ')';
            continue;
        } else if (letter == ';' || letter == '(') {
            (letter == '(' ? is_inside : is_after) = true;
            opening = text.size();
            continue;
        }
        text += letter;
    }
    if (is_inside)
        text += '(';
    return text;
}

std::string canonical_output(const InterpreterTask& task)
{
    const std::filesystem::path program = program_on_path("rs274");
    if (program.empty())
        throw DomainError{
            "--interpreter linuxcnc: the program rs274 is not installed; expected the "
            "Debian package linuxcnc-uspace"};
    refuse_lone_returns(task);
    const std::string text =
        with_far_machine_positions(without_comments(task.text), task.file);
    const std::vector<std::string> lines = squeezed_lines(text);
    refuse_folders(lines, task.file);
    refuse_unknown_data(task, lines);

    const PrivateFolder folder{task.folder};
    folder.write("program.ngc", text);
    folder.write("tools.tbl", tool_table(task, lines));
    folder.write("parameters.var", interpreter_parameters());
    ChildTask child{.program = program,
                    .arguments = {"-g", "-t", "tools.tbl", "-v", "parameters.var",
                                  "program.ngc", "moves.txt"},
                    .folder = folder.path(),
                    .log = folder.path() / "log.txt",
                    .environment = minimal_environment(folder.path()),
                    .limits = limits_of(task)};
    if (task.block_delete)
        child.arguments.insert(child.arguments.begin(), "-b");
    const ChildResult result = run_child(child);
    require_accepted(result, task, content_of(folder.path() / "log.txt"), lines);
    std::string moves = content_of(folder.path() / "moves.txt");
    require_motion(moves, task, lines);
    require_height(task, lines);
    return moves;
}

}  // namespace endmill
