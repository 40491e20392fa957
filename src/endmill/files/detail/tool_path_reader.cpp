// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_path_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "endmill/core/angle.h"
#include "endmill/core/detail/large_pages.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/csv_lines.h"
#include "endmill/files/detail/tool_path_columns.h"
#include "endmill/files/read_file.h"
#include "endmill/post/detail/unit_axis.h"

// A path may have millions of rows, so the text is read in place and by several threads.
//
// 1. The header is read and checked (`path_columns`).
// 2. Memory for all points is allocated at once, after counting the lines and a check of
//    the limit. Row i of the file becomes point i of the path, whichever thread reads it.
// 3. The text is divided into runs of whole lines; each thread reads runs with a
//    PathRowReader, which converts the cells in place.
// 4. Remarks state what was assumed or ignored.
//
// The first error in the order of the file is reported, as `parallel_for` rethrows it.

namespace endmill {
namespace {

using enum PathColumn;

constexpr std::size_t longest_echo = 40;
// mm and rad, largest difference of a pose and that of the positions beside it.
constexpr double largest_pose_error = 1e-6;

// Reads the rows of one run of lines, without copying cells.
class PathRowReader {
public:
    // \param lines_before number of lines of the file before the first run.
    PathRowReader(const CsvRun& run, const PathColumns& columns, const std::string& file,
                  const ReadLimits& limits, std::size_t lines_before)
        : columns_{columns},
          limits_{limits},
          lines_{run.text, file, lines_before + run.first_line}
    {
    }

    bool next() { return lines_.next(); }

    // The point of the current row. `number` is its index in the file, which numbers the
    // points of a file without the column point.
    PathPoint point(std::size_t number) const
    {
        if (lines_.cells().size() != columns_.count())
            throw lines_.complaint("E_CSV",
                                   "row has " + counted(lines_.cells().size(), "cell"),
                                   std::to_string(columns_.count()));
        PathPoint point{.pass = whole_number(Pass).value_or(0),
                        .point = whole_number(Point).value_or(static_cast<int>(number)),
                        .move = move(),
                        .location = location()};
        if (const auto whole = contact())
            point.known_contact = *whole;
        point.patch = whole_number(Patch).value_or(0);
        if (columns_.has(NormalX) && !point.contact())
            if (const auto normal = direction(NormalX))
                point.known_contact = *normal;
        point.conditions = {positive(Feed), positive(Speed), whole_number(Tool)};
        return point;
    }

    // The positions of the machine in the current row, which must be those of `location`.
    AxisPositions positions(const CutterLocation& location,
                            const MachineMotion& machine) const
    {
        const std::optional<Vec3> xyz = place(AxisPositionX);
        if (!xyz)
            refuse(AxisPositionX, "a number: " + interpolated(machine));
        AxisPositions at{.xyz = *xyz};
        for (int k = 0; k < 2; ++k) {
            const PathColumn column = following(FirstRotary, k);
            const std::optional<double> degrees = number(column);
            if (!degrees)
                refuse(column, "a number: " + interpolated(machine));
            at.rotary[static_cast<std::size_t>(k)] = Angle::degrees(*degrees).radians();
        }
        const CutterLocation pose = tool_location(machine.setup, at);
        const double off = std::max((pose.tip - location.tip).norm(),
                                    angle_between(pose.axis, location.axis));
        if (!(off <= largest_pose_error))
            throw lines_.complaint("E_CSV",
                                   "the positions of the machine are " + to_text(off) +
                                       " mm or rad off the tip and the axis",
                                   "at most " + to_text(largest_pose_error));
        return at;
    }

    // For messages: why positions are needed.
    static std::string interpolated(const MachineMotion& machine)
    {
        return "the interpolation of the path is " +
               std::string{interpolation_name(machine.interpolation)};
    }

private:
    // The cell of a column; empty if the table has no such column.
    std::string_view cell(PathColumn column) const
    {
        return columns_.has(column) ? lines_.cells()[columns_.place(column)]
                                    : std::string_view{};
    }

    // Reports the cell of a column: the name of the column, its text, and what is
    // expected.
    [[noreturn]] void refuse(PathColumn column, const std::string& expected) const
    {
        const std::string_view text = cell(column);
        const std::string found =
            text.empty() ? "empty" : '"' + printable(text, longest_echo) + '"';
        throw lines_.complaint("E_CSV", std::string{column_name(column)} + " is " + found,
                               expected);
    }

    // The whole number in a cell; nothing if it is empty.
    std::optional<int> whole_number(PathColumn column) const
    {
        const std::string_view text = cell(column);
        if (text.empty())
            return std::nullopt;
        int number = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, number);
        if (error != std::errc{} || stop != end || number < 0)
            refuse(column, "a whole number from 0 to 2147483647");
        return number;
    }

    // The number in a cell; nothing if it is empty, which means unknown and not zero.
    std::optional<double> number(PathColumn column) const
    {
        const std::string_view text = cell(column);
        if (text.empty())
            return std::nullopt;
        const std::optional<double> number = number_from_text(text);
        if (!number)
            refuse(column, "a number");
        return number;
    }

    // The positive number in a cell; nothing if it is empty.
    std::optional<double> positive(PathColumn column) const
    {
        const std::optional<double> value = number(column);
        if (value && !(*value > 0))
            refuse(column, "a number above 0, or nothing");
        return value;
    }

    // The move of the row. Most rows have the word of the previous row, which is then not
    // looked up again.
    Move move() const
    {
        if (!columns_.has(MoveWord))
            return Move::Cut;
        const std::string_view word = cell(MoveWord);
        if (word == last_word_)
            return last_move_;
        const std::optional<Move> move = move_from_name(word);
        if (!move)
            refuse(MoveWord, "cut, link, rapid, plunge or retract");
        last_word_ = word;
        return last_move_ = *move;
    }

    // The vector in the three columns from `first` on; nothing if all its cells are
    // empty.
    std::optional<Vec3> vector(PathColumn first) const
    {
        Vec3 vector;
        int known = 0;
        for (int c = 0; c < 3; ++c)
            if (const auto component = number(following(first, c))) {
                vector[c] = *component;
                ++known;
            }
        if (known == 0)
            return std::nullopt;
        for (int c = 0; known < 3 && c < 3; ++c)
            if (cell(following(first, c)).empty())
                refuse(following(first, c),
                       "a number, as in the other columns of the vector");
        return vector;
    }

    // A point in mm, after a check of the limit.
    std::optional<Vec3> place(PathColumn first) const
    {
        std::optional<Vec3> point = vector(first);
        for (int c = 0; point && c < 3; ++c)
            if (std::abs((*point)[c]) > limits_.max_extent_mm)
                throw lines_.complaint(
                    "E_RANGE",
                    std::string{column_name(following(first, c))} + " is " +
                        to_text((*point)[c]),
                    "at most " + to_text(limits_.max_extent_mm) + " mm (--max-extent)");
        return point;
    }

    // A unit vector.
    std::optional<Vec3> direction(PathColumn first) const
    {
        const std::optional<Vec3> read = vector(first);
        if (!read)
            return std::nullopt;
        std::optional<Vec3> unit = unit_axis(*read);
        const std::string_view name =
            column_name(first);  // without "_x": the name of the vector
        if (!unit)
            throw lines_.complaint("E_CSV",
                                   std::string{name.substr(0, name.size() - 2)} +
                                       " of length " + shown_length(*read),
                                   "length 1 within " + to_text(axis_length_tolerance));
        return unit;
    }

    // The length of a vector for a message; it may overflow.
    static std::string shown_length(const Vec3& vector)
    {
        const double length = vector.norm();
        return std::isfinite(length) ? to_text(length) : "infinity";
    }

    // The tip, which must be known, and the axis, by default +z.
    CutterLocation location() const
    {
        const std::optional<Vec3> tip = place(TipX);
        if (!tip)
            refuse(TipX, "a number");
        return {*tip, direction(AxisX).value_or(Vec3::UnitZ())};
    }

    // The contact of the row: all of u, v, point and normal, or none of u, v and point.
    std::optional<SurfaceContact> contact() const
    {
        if (!columns_.has_contacts())
            return std::nullopt;
        const std::optional<double> u = number(U);
        const std::optional<double> v = number(V);
        const std::optional<Vec3> point = place(ContactX);
        const std::optional<Vec3> normal = direction(NormalX);
        if (!u && !v && !point)
            return std::nullopt;  // a normal alone is stored by `point`
        for (const PathColumn column : {U, V, ContactX, NormalX})
            if (cell(column).empty())
                refuse(column,
                       "all of u, v, contact and normal, the normal alone, or none");
        return SurfaceContact{*u, *v, {*point, *normal}};
    }

    const PathColumns& columns_;
    const ReadLimits& limits_;
    CsvLines lines_;
    mutable std::string_view last_word_ = "cut";
    mutable Move last_move_ = Move::Cut;
};

// Reads the runs of a file by several threads, each row to its place in the path.
class PathCsvReader {
public:
    PathCsvReader(std::string_view text, const std::string& file,
                  const ReadLimits& limits, const std::optional<MachineMotion>& machine)
        : file_{file},
          limits_{limits},
          header_{text, file}
    {
        header_.next();  // an empty text has no columns
        columns_ = path_columns(header_);
        program_.path.machine = machine;
        if (machine && !columns_.has_positions())
            throw header_.complaint(
                "E_CSV", "no columns x_mm, y_mm, z_mm, r1_deg and r2_deg",
                "positions of the machine: " + PathRowReader::interpolated(*machine));
    }

    // Reads the whole file.
    Program read_all()
    {
        make_room();
        const std::vector<CsvRun> runs = csv_runs(header_.rest());
        parallel_for(runs.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                read(runs[i]);
        });
        add_remarks();
        return std::move(program_);
    }

private:
    // Allocates memory for all rows at once, after a check of the limit.
    void make_room()
    {
        const std::size_t rows = line_count(header_.rest());
        if (rows == 0)
            throw header_.complaint("E_CSV", "no row after the header", "a point");
        require_memory(file_, static_cast<double>(rows) * sizeof(PathPoint), limits_);
        if (rows > std::numeric_limits<int>::max())
            throw LimitError{file_ + ": more than 2147483647 points"};
        reserve_in_large_pages(program_.path.points, rows);
        program_.path.points.resize(rows);
        if (program_.path.machine)
            program_.path.machine->positions.resize(rows);
    }

    // Reads a run.
    void read(const CsvRun& run)
    {
        PathRowReader reader{run, columns_, file_, limits_, header_.line()};
        std::optional<MachineMotion>& machine = program_.path.machine;
        for (std::size_t i = run.first_line; reader.next(); ++i) {
            program_.path.points[i] = reader.point(i);
            if (machine)
                machine->positions[i] =
                    reader.positions(program_.path.points[i].location, *machine);
        }
    }

    // States what was assumed and what was ignored.
    void add_remarks()
    {
        std::vector<std::string>& remarks = program_.remarks;
        if (!columns_.has(MoveWord))
            remarks.emplace_back("no column move: every move is assumed to be a cut");
        if (!columns_.has(AxisX))
            remarks.emplace_back("no column axis: it is assumed to be +z");
        if (!program_.path.machine && columns_.has(FirstRotary))
            remarks.emplace_back(
                "positions of a machine are ignored: the summary names no machine that "
                "interpolates the path");
        if (!columns_.has_contacts() && (columns_.has(U) || columns_.has(ContactX)))
            remarks.emplace_back(
                columns_.has(NormalX)
                    ? "only the normals of contacts are kept: contacts need u, v, "
                      "contact "
                      "and normal"
                    : "contacts are ignored: they need u, v, contact and normal");
    }

    const std::string& file_;
    const ReadLimits& limits_;
    CsvLines header_;
    PathColumns columns_;
    Program program_;
};

}  // namespace

// The rule is generous, so that a header with a misspelt column is still read as CSV and
// reported by the CSV reader.
bool is_tool_path_csv(std::string_view text)
{
    const std::string_view line = text.substr(0, text.find('\n'));
    const auto has = [&](std::string_view part) {
        return line.find(part) != std::string_view::npos;
    };
    return has("tip_") && has(",") && !has("(");  // a "(" begins a comment of G-code
}

Program parse_tool_path(std::string_view text, const std::string& file,
                        const ReadLimits& limits,
                        const std::optional<MachineMotion>& machine)
{
    return PathCsvReader{text, file, limits, machine}.read_all();
}

Program read_tool_path(const std::filesystem::path& path, const ReadLimits& limits)
{
    return parse_tool_path(read_file(path, limits), shown_path(path), limits);
}

}  // namespace endmill
