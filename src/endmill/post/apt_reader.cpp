// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/apt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/text.h"
#include "endmill/post/detail/feed_move.h"
#include "endmill/post/detail/plain_number.h"
#include "endmill/post/detail/text_lines.h"
#include "endmill/post/detail/unit_axis.h"

// The reader handles one statement per line, or per group of lines of which all but the
// last end with $:
// 1. `statement_of` splits the text without comment into a word and its rest, after
//    `continued_statement` has joined the lines.
// 2. GOTO appends a point with the feed and speed in force. FEDRAT and SPINDL change
//    these until the next such statement; RAPID makes the next GOTO a rapid.
// 3. FINI ends the path. After it, `finish` checks that there is a path and adds remarks
//    on missing statements.
// Any unknown statement is an error, because it might move the tool.

namespace endmill {
namespace {

constexpr const char* known_statements =
    "PARTNO, UNITS, MULTAX, CUTTER, SPINDL, FEDRAT, RAPID, GOTO, FINI, REMARK, PPRINT, "
    "LOADTL, "
    "COOLNT, STOP or a comment after $$";

// `text` without surrounding blanks, which have no meaning in APT outside texts.
std::string_view trimmed(std::string_view text)
{
    text = without_indent(text);
    while (!text.empty() && is_blank(text.back()))
        text.remove_suffix(1);
    return text;
}

char upper(char letter)
{
    return 'a' <= letter && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A')
                                          : letter;
}

// Whether `text` equals `word`, which is in capitals, in any case.
bool is_word(std::string_view text, std::string_view word)
{
    return std::ranges::equal(text, word, {}, upper);
}

// A statement of the form WORD, WORD/REST or, for texts, WORD REST.
struct Statement {
    std::string_view word;
    std::string_view rest;
    bool has_slash = false;

    bool is(std::string_view name) const { return is_word(word, name); }
    bool is_any(std::span<const std::string_view> names) const
    {
        return std::ranges::any_of(names, [&](std::string_view n) { return is(n); });
    }
};

// The line without its comment and without surrounding blanks.
std::string_view without_comment(std::string_view line)
{
    return trimmed(line.substr(0, line.find("$$")));
}

// The statement of a line without comment. The word is the run of letters at its
// beginning, which handles "RAPID/", "PARTNO x" and "GOTO /1" alike. A line that does not
// begin with a letter has an empty word.
Statement statement_of(std::string_view line)
{
    const auto end = std::ranges::find_if_not(
        line, [](char c) { return 'A' <= upper(c) && upper(c) <= 'Z'; });
    const auto length = static_cast<std::size_t>(end - line.begin());
    Statement statement{line.substr(0, length), without_indent(line.substr(length))};
    if (statement.rest.starts_with('/')) {
        statement.has_slash = true;
        statement.rest = without_indent(statement.rest.substr(1));
    }
    return statement;
}

// Statements whose rest is text for people.
constexpr std::array<std::string_view, 3> text_words{"PARTNO", "REMARK", "PPRINT"};
// Statements about the machine, which have no effect on the path.
constexpr std::array<std::string_view, 2> ignored_words{"COOLNT", "STOP"};
// Statements that define the path.
constexpr std::array<std::string_view, 9> read_words{
    "UNITS", "MULTAX", "CUTTER", "LOADTL", "SPINDL", "FEDRAT", "RAPID", "GOTO", "FINI"};
// Controls accept tool numbers of at most five digits.
constexpr double greatest_tool = 99999;

// A typical statement GOTO has about this length.
constexpr std::size_t likely_bytes_per_statement = 32;

// Runs the statements and stores what is in force: feed and speed until they change,
// RAPID until the next GOTO.
class AptReader {
public:
    AptReader(std::string_view text, const std::string& file,
              const AptReadOptions& options)
        : lines_{text, {file, "E_APT"}},
          options_{options}
    {
        const std::size_t likely_points = text.size() / likely_bytes_per_statement;
        reserve_in_large_pages(program_.path.points,
                               std::min(likely_points, options.most_points));
    }

    Program read_all()
    {
        while (!is_finished_ && lines_.next()) {
            first_line_ = lines_.number();
            text_ = without_comment(lines_.line());
            Statement statement = statement_of(text_);
            if (text_.ends_with('$') && !statement.is_any(text_words))
                statement = continued_statement();
            if (!statement.word.empty() || !statement.rest.empty() || statement.has_slash)
                read_statement(statement);
        }
        finish();
        return std::move(program_);
    }

private:
    // The statement that begins in the current line and goes on in the next one. Texts are
    // not continued, because a $ at their end may belong to them.
    Statement continued_statement()
    {
        joined_.clear();
        for (; text_.ends_with('$'); text_ = without_comment(lines_.line())) {
            text_.remove_suffix(1);
            append(text_);
            if (!lines_.next())
                throw complaint("a $ in the last line",
                                "the rest of the statement in another line");
        }
        append(text_);
        text_ = joined_;
        return statement_of(text_);
    }

    // Appends a line to the statement that is put together.
    void append(std::string_view line)
    {
        constexpr std::size_t longest = std::size_t{1} << 20U;  // bytes, as of a line
        joined_ += line;
        joined_ += ' ';
        if (joined_.size() > longest)
            throw FormatError{"E_LIMIT",
                              {lines_.file(), std::to_string(first_line_),
                               "a statement is longer than 1 MiB",
                               "statements of at most 1048576 bytes"}};
    }

    // An error at the first line of the statement.
    FormatError complaint(const std::string& found, const std::string& expected) const
    {
        return {"E_APT", {lines_.file(), std::to_string(first_line_), found, expected}};
    }

    void read_statement(const Statement& statement)
    {
        if (statement.is("GOTO"))
            read_goto(statement);
        else if (statement.is("RAPID") || statement.is("FINI"))
            read_bare(statement);
        else if (statement.is("FEDRAT"))
            read_feed(statement);
        else if (statement.is("SPINDL"))
            read_speed(statement);
        else if (statement.is("CUTTER"))
            read_cutter(statement);
        else if (statement.is("LOADTL"))
            read_tool(statement);
        else if (statement.is("UNITS"))
            read_units(statement);
        else if (statement.is("MULTAX"))
            read_multax(statement);
        else if (!statement.is_any(text_words) && !statement.is_any(ignored_words))
            throw complaint("statement " + quoted(text_), known_statements);
    }

    // The parts between the commas after the slash, valid until the next call.
    std::span<const std::string_view> arguments(const Statement& statement)
    {
        arguments_.clear();
        std::string_view rest = statement.rest;
        if (!statement.has_slash)
            return arguments_;
        for (;;) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            arguments_.push_back(trimmed(rest.substr(0, comma)));
            if (comma == rest.size())
                return arguments_;
            rest.remove_prefix(comma + 1);
        }
    }

    double number(std::string_view text) const
    {
        const std::optional<double> value = plain_number(text);
        if (!value)
            throw complaint(quoted(text), "a number in plain decimals");
        return *value;
    }

    [[noreturn]] void refuse(const std::string& expected) const
    {
        throw complaint(quoted(text_), expected);
    }

    // GOTO is the only statement that moves the tool.
    void read_goto(const Statement& statement)
    {
        const auto parts = arguments(statement);
        if (parts.size() != 3 && parts.size() != 6)
            refuse("GOTO/x,y,z or GOTO/x,y,z,i,j,k");
        CutterLocation location{Vec3::Zero(), Vec3::UnitZ()};
        for (int c = 0; c < 3; ++c)
            location.tip[c] = coordinate(parts[static_cast<std::size_t>(c)]);
        if (parts.size() == 6)
            location.axis = axis(parts.subspan(3));
        add_point(location);
    }

    double coordinate(std::string_view text) const
    {
        const double value = number(text);
        if (std::abs(value) > options_.max_extent_mm)
            throw lines_.range_complaint(
                "coordinate " + quoted(text),
                "at most " + to_text(options_.max_extent_mm) + " mm (--max-extent)");
        return value;
    }

    Vec3 axis(std::span<const std::string_view> parts) const
    {
        const Vec3 read{number(parts[0]), number(parts[1]), number(parts[2])};
        const std::optional<Vec3> unit = unit_axis(read);
        if (!unit)
            throw complaint("axis of length " + brief(read.norm()),
                            "length 1 within " + to_text(axis_length_tolerance));
        return *unit;
    }

    // A tool table gives one cutter for each tool number, so that CUTTER must not change
    // without LOADTL.
    void check_cutter()
    {
        const Cutter cutter = *std::exchange(stated_cutter_, std::nullopt);
        const auto [known, is_new] = cutters_.try_emplace(conditions_.tool, cutter);
        if (!is_new && known->second != cutter)
            throw complaint(
                "another CUTTER " +
                    (conditions_.tool ? "for tool " + std::to_string(*conditions_.tool)
                                      : std::string{"without a tool number"}) +
                    ", " + cutter_word(cutter) + " after " + cutter_word(known->second),
                "LOADTL with another number before it");
    }

    // A rapid has no feed. The feed in force is kept for the move after it.
    void add_point(const CutterLocation& location)
    {
        std::vector<PathPoint>& points = program_.path.points;
        if (points.size() >= options_.most_points)
            throw LimitError{lines_.file() + ": more than " +
                             std::to_string(options_.most_points) +
                             " points; a higher --max-memory takes more"};
        if (stated_cutter_ && !is_rapid_)
            check_cutter();
        Move move = Move::Plunge;
        if (is_rapid_)
            move = Move::Rapid;
        else if (!points.empty())
            move = feed_move(points.back().location.tip, location.tip);
        points.push_back({.pass = 0,
                          .point = static_cast<int>(points.size()),
                          .move = move,
                          .location = location,
                          .conditions = conditions_});
        if (is_rapid_)
            points.back().conditions.feed_mm_per_min.reset();
        is_rapid_ = false;
    }

    // RAPID and FINI have no arguments. An argument is refused, because its meaning is
    // unknown.
    void read_bare(const Statement& statement)
    {
        if (statement.has_slash || !statement.rest.empty())
            refuse("nothing after the word");
        if (statement.is("RAPID"))
            is_rapid_ = true;
        else
            is_finished_ = true;
    }

    void read_feed(const Statement& statement)
    {
        const auto parts = arguments(statement);
        if (parts.size() != 2 || !is_word(parts[1], "MMPM"))
            refuse("FEDRAT/feed,MMPM");
        conditions_.feed_mm_per_min = number(parts[0]);
        if (!(*conditions_.feed_mm_per_min > 0))
            refuse("a feed above 0");
    }

    void read_speed(const Statement& statement)
    {
        constexpr const char* expected = "SPINDL/speed,RPM,CLW, SPINDL/ON or SPINDL/OFF";
        const auto parts = arguments(statement);
        if (parts.size() == 1 && is_word(parts[0], "OFF"))
            return conditions_.spindle_rpm.reset();
        if (parts.size() == 1 && is_word(parts[0], "ON") && speed_rpm_) {
            conditions_.spindle_rpm = speed_rpm_;
            return;
        }
        std::optional<double> speed;
        std::size_t units = 0;
        std::size_t senses = 0;
        for (const std::string_view part : parts) {
            if (is_word(part, "RPM"))
                ++units;
            else if (is_word(part, "CLW"))
                ++senses;
            else if (const auto value = plain_number(part); value && !speed)
                speed = value;
            else
                refuse(expected);
        }
        if (!speed || units > 1 || senses > 1)
            refuse(expected);
        if (!(*speed > 0))
            refuse("a speed above 0");
        speed_rpm_ = conditions_.spindle_rpm = speed;
    }

    // What follows the number, such as LENGTH, is for the machine.
    void read_tool(const Statement& statement)
    {
        const auto parts = arguments(statement);
        const double tool = parts.empty() ? -1 : number(parts[0]);
        if (!(0 <= tool && tool <= greatest_tool && tool == std::floor(tool)))
            refuse("LOADTL/number, a whole number from 0 to 99999");
        conditions_.tool = static_cast<int>(tool);
        stated_cutter_.reset();
    }

    void read_cutter(const Statement& statement)
    {
        const auto parts = arguments(statement);
        if (parts.empty() || parts.size() > 2)
            refuse("CUTTER/diameter,corner_radius");
        const double radius = number(parts[0]) / 2;
        const double corner = parts.size() == 2 ? number(parts[1]) : 0;
        if (!(radius > 0 && 0 <= corner && corner <= radius))
            refuse("a diameter above 0 and a corner radius from 0 to half of it");
        // A path has one cutter; the same statement may be repeated.
        const Cutter cutter{radius, corner};
        const bool is_another = first_cutter_ && *first_cutter_ != cutter;
        if (is_another && !options_.several_cutters)
            refuse(
                "one cutter for the whole path, or --tools FILE, a table with the cutter "
                "of each tool");
        has_several_cutters_ = has_several_cutters_ || is_another;
        first_cutter_ = first_cutter_.value_or(cutter);
        stated_cutter_ = cutter;
    }

    // Other units are refused: they would also change the words of the feeds.
    void read_units(const Statement& statement)
    {
        const auto parts = arguments(statement);
        if (parts.size() != 1 || !is_word(parts[0], "MM"))
            refuse("UNITS/MM");
        has_units_ = true;
    }

    // MULTAX announces axes in GOTO, OFF ends that; a GOTO shows by itself whether it has one.
    void read_multax(const Statement& statement)
    {
        const auto parts = arguments(statement);
        const bool is_off = parts.size() == 1 && is_word(parts[0], "OFF");
        const bool is_on = statement.has_slash
                               ? parts.size() == 1 && is_word(parts[0], "ON")
                               : statement.rest.empty();
        if (!is_on && !is_off)
            refuse("MULTAX, MULTAX/ON or MULTAX/OFF");
    }

    // Completes the program at the end of the file.
    void finish()
    {
        if (program_.path.points.empty())
            throw FormatError{
                "E_APT",
                {lines_.file(), "", "no GOTO in " + counted(lines_.number(), "line"),
                 "at least one GOTO/x,y,z"}};
        if (!has_several_cutters_)
            program_.cutter = first_cutter_;
        if (!has_units_)
            program_.remarks.emplace_back("no UNITS statement: lengths are taken as mm");
        if (!is_finished_)
            program_.remarks.emplace_back(
                "no FINI at the end: the file may be cut short");
        else if (!trimmed(lines_.rest()).empty())
            program_.remarks.emplace_back("text after FINI is ignored");
    }

    TextLines lines_;
    const AptReadOptions& options_;
    std::size_t first_line_ = 0;  // of the current statement
    std::string_view text_;       // of the current statement, without comments
    std::string joined_;          // of its lines, if there are several
    std::vector<std::string_view> arguments_;
    Program program_;
    CuttingConditions conditions_;     // in force
    std::optional<double> speed_rpm_;  // of the last SPINDL with a speed
    std::optional<Cutter> first_cutter_;
    std::optional<Cutter> stated_cutter_;           // since the last LOADTL or cut
    std::map<std::optional<int>, Cutter> cutters_;  // by tool number
    bool has_several_cutters_ = false;
    bool is_rapid_ = false;
    bool is_finished_ = false;
    bool has_units_ = false;
};

}  // namespace

bool is_apt(std::string_view text)
{
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        const Statement statement = statement_of(without_comment(line));
        if (!statement.word.empty() || !statement.rest.empty())
            return statement.is_any(text_words) || statement.is_any(ignored_words) ||
                   statement.is_any(read_words);
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return false;
}

Program parse_apt(std::string_view text, const std::string& file,
                  const AptReadOptions& options)
{
    return AptReader{text, file, options}.read_all();
}

}  // namespace endmill
