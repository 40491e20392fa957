// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/path_options.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/files/csv.h"
#include "endmill/files/machining_data.h"
#include "endmill/page/reduction.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// What a browser that draws by software turns smoothly; see docs/guide/view.md.
constexpr std::size_t most_path_points_drawn = 50'000;
constexpr std::size_t most_points_of_a_series = 2'000;
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

// Lengths of the path of the tip up to each point.
std::vector<double> path_lengths(const ToolPath& path)
{
    std::vector<double> lengths(path.points.size());
    for (std::size_t k = 1; k < lengths.size(); ++k)
        lengths[k] =
            lengths[k - 1] +
            (path.points[k].location.tip - path.points[k - 1].location.tip).norm();
    return lengths;
}

float feed_at(const PathPoint& point)
{
    const std::optional<double>& feed = point.conditions.feed_mm_per_min;
    return feed ? static_cast<float>(*feed) : unknown;
}

class PathArrays {
public:
    PathArrays(const ToolPath& path, ViewFrame& frame)
        : path_{path},
          frame_{frame},
          lengths_{path_lengths(path)},
          reduced_{reduced_path(path, most_path_points_drawn)}
    {
    }

    Json json(const std::optional<Cutter>& cutter)
    {
        Json json{{"tips", picked<double>(3, [&](std::size_t k, int c) {
                       return path_.points[k].location.tip[c];
                   })}};
        json["length_mm"] =
            picked<double>(1, [&](std::size_t k, int) { return lengths_[k]; });
        json["numbers"] = picked<std::uint32_t>(
            1, [](std::size_t k, int) { return static_cast<std::uint32_t>(k); });
        if (const std::optional<Vec3> fixed = fixed_axis(path_))
            json["axis"] = vector_json(*fixed);
        else
            json["axes"] = picked<float>(3, [&](std::size_t k, int c) {
                return static_cast<float>(path_.points[k].location.axis[c]);
            });
        add_kinds(json);
        if (cutter)
            json["cutter"] = {{"radius_mm", cutter->radius()},
                              {"corner_radius_mm", cutter->corner_radius()},
                              {"word", cutter_word(*cutter)}};
        if (reduced_.points.size() < path_.points.size())
            json["note"] = note();
        return json;
    }

    // The limit of the feed at each point that is drawn.
    void add_limits(Json& json,
                    const std::function<std::string(std::size_t point)>& limit_of)
    {
        std::vector<std::string> names{""};
        const auto numbers = picked<std::uint8_t>(1, [&](std::size_t k, int) {
            const std::string word = limit_of(k);
            const auto known = std::ranges::find(names, word);
            const auto number = static_cast<std::uint8_t>(known - names.begin());
            if (known == names.end() && names.size() < 255)
                names.push_back(word);
            return number;
        });
        for (std::string& name : names)
            std::ranges::replace(name, '_', ' ');
        json["limit_names"] = names;
        json["limits"] = numbers;
    }

    // The positions of the machine's axes at each point that is drawn.
    void add_positions(Json& json, std::span<const AxisPositions> positions)
    {
        json["positions"] = picked<double>(5, [&](std::size_t k, int c) {
            const AxisPositions& at = positions[k];
            return c < 3 ? at.xyz[c]
                         : Angle::radians(at.rotary[static_cast<std::size_t>(c - 3)])
                               .degrees();
        });
    }

    const std::vector<double>& lengths() const { return lengths_; }

private:
    // An array of `width` numbers for each point that is drawn.
    template <typename Number, typename ValueOf>
    Json picked(int width, const ValueOf& value_of)
    {
        std::vector<Number> values;
        values.reserve(static_cast<std::size_t>(width) * reduced_.points.size());
        for (const std::size_t k : reduced_.points)
            for (int c = 0; c < width; ++c)
                values.push_back(value_of(k, c));
        return array_json(frame_.numbers.add(values));
    }

    void add_kinds(Json& json)
    {
        const auto& points = path_.points;
        std::vector<std::uint32_t> piece_of(points.size());
        std::uint32_t piece = 0;  // a run of cuts; other moves belong to the next one
        for (std::size_t k = 1; k < points.size(); ++k) {
            piece += points[k - 1].move == Move::Cut && points[k].move != Move::Cut;
            piece_of[k] = piece;
        }
        Json names = Json::array();
        for (const Move move :
             {Move::Cut, Move::Link, Move::Rapid, Move::Plunge, Move::Retract})
            names.push_back(move_name(move));
        json["move_names"] = std::move(names);
        json["moves"] = picked<std::uint8_t>(1, [&](std::size_t k, int) {
            return static_cast<std::uint8_t>(points[k].move);
        });
        json["passes"] = picked<std::uint32_t>(1, [&](std::size_t k, int) {
            return static_cast<std::uint32_t>(std::max(points[k].pass, 0));
        });
        json["pieces"] =
            picked<std::uint32_t>(1, [&](std::size_t k, int) { return piece_of[k]; });
        if (std::ranges::any_of(points, [](const PathPoint& point) {
                return point.conditions.feed_mm_per_min.has_value();
            }))
            json["feeds"] =
                picked<float>(1, [&](std::size_t k, int) { return feed_at(points[k]); });
    }

    std::string note() const
    {
        std::string note = fmt::format(
            "The path is drawn with {} of its {} points; no tip is farther than {} mm "
            "from the lines.",
            reduced_.points.size(), path_.points.size(),
            shown_bound(reduced_.tolerance_mm));
        if (reduced_.joins_moves)
            note +=
                " Its moves are so many that moves of several kinds are joined; a line "
                "has the colour of its last move.";
        return note;
    }

    const ToolPath& path_;
    ViewFrame& frame_;
    std::vector<double> lengths_;
    ReducedPath reduced_;
};

// The rows of an engagement by the points of a path.
class Engagement {
public:
    Engagement(const std::string& file, const ReadLimits& limits)
        : file_{file},
          table_{read_csv(file, limits)}
    {
        for (std::size_t row = 0; row < table_.rows(); ++row)
            rows_[{whole_number(row, "pass"), whole_number(row, "point")}] = row;
    }

    std::string limit(const PathPoint& point) const
    {
        const auto found = rows_.find({point.pass, point.point});
        return found == rows_.end() ? "" : table_.cell(found->second, "limit");
    }

    float value(const PathPoint& point, const char* column) const
    {
        const auto found = rows_.find({point.pass, point.point});
        if (found == rows_.end())
            return unknown;
        const auto number = table_.number(found->second, column);
        return number ? static_cast<float>(*number) : unknown;
    }

private:
    int whole_number(std::size_t row, const char* column) const
    {
        const double number = table_.number(row, column).value_or(-1);
        if (!(number >= -1 && number <= std::numeric_limits<int>::max()) ||
            number != std::floor(number))
            throw FormatError{"E_CSV",
                              {shown_path(file_), std::to_string(row + 2),
                               std::string{column} + " " + table_.cell(row, column),
                               "a whole number from 0"}};
        return static_cast<int>(number);
    }

    std::string file_;
    CsvTable table_;
    std::map<std::pair<int, int>, std::size_t> rows_;
};

// The points at which a series is drawn that keeps the extremes of every quantity.
std::vector<std::size_t> plotted_points(std::span<const std::vector<float>> series,
                                        std::size_t points)
{
    std::vector<std::size_t> chosen;
    if (points <= most_points_of_a_series) {
        for (std::size_t k = 0; k < points; ++k)
            chosen.push_back(k);
        return chosen;
    }
    for (const std::vector<float>& values : series)
        std::ranges::copy(extremes(values, most_points_of_a_series),
                          std::back_inserter(chosen));
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

// Plots of the feed and of the loads along the whole path.
Json plots_json(const ToolPath& path, const Engagement& engagement,
                std::span<const double> lengths, ViewFrame& frame)
{
    constexpr std::array<std::pair<const char*, const char*>, 4> loads{
        {{"cutting_force_n", "cutting force, N"},
         {"thrust_n", "thrust, N"},
         {"torque_n_m", "torque, N m"},
         {"power_w", "power, W"}}};
    std::array<std::vector<float>, loads.size() + 1> series;
    for (const PathPoint& point : path.points) {
        series[0].push_back(feed_at(point));
        for (std::size_t i = 0; i < loads.size(); ++i)
            series[i + 1].push_back(engagement.value(point, loads[i].first));
    }
    const std::vector<std::size_t> chosen = plotted_points(series, path.points.size());
    const auto picked = [&](const auto& values) {
        std::vector<float> shown;
        shown.reserve(chosen.size());
        for (const std::size_t k : chosen)
            shown.push_back(static_cast<float>(values[k]));
        return array_json(frame.numbers.add(shown));
    };
    Json plots{{"along_mm", picked(lengths)}, {"series", Json::array()}};
    for (std::size_t i = 0; i < series.size(); ++i)
        plots["series"].push_back(
            {{"name", i == 0 ? "feed, mm/min" : loads[i - 1].second},
             {"values", picked(series[i])}});
    if (chosen.size() < path.points.size())
        plots["note"] = fmt::format(
            "The plots have {} of {} points: of neighbours the least and the greatest "
            "value "
            "of each quantity.",
            chosen.size(), path.points.size());
    return plots;
}

// A point of a rotary axis: in the machine for an axis of the table, relative to the position of
// the tool (X, Y, Z) for one of the head. Of two axes on one side the offset separates them.
Vec3 point_of_axis(const PartOnMachine& setup, std::size_t number)
{
    const Machine& machine = setup.machine;
    const auto& axes = machine.configuration.rotary;
    const bool is_on_table = axes[number].side == MachineSide::Table;
    const bool are_on_one_side = axes.size() == 2 && axes[0].side == axes[1].side;
    const bool is_moved = are_on_one_side && number == (is_on_table ? 1 : 0);
    const Vec3 offset = is_moved ? machine.axis_offset : Vec3{0, 0, 0};
    if (is_on_table)
        return machine.table_offset + offset;
    return (machine.pivot + setup.tool_length) * Vec3::UnitZ() - offset;
}

// The pose of the part and the lines of the rotary axes.
Json machine_json(const PartOnMachine& setup, const Vec3& origin)
{
    const MachineConfiguration& configuration = setup.machine.configuration;
    Json rotary = Json::array();
    for (std::size_t k = 0; k < configuration.rotary.size(); ++k) {
        const auto& [letter, side] = configuration.rotary[k];
        rotary.push_back({{"letter", std::string{letter}},
                          {"side", side == MachineSide::Table ? "table" : "head"},
                          {"point_mm", vector_json(point_of_axis(setup, k))}});
    }
    // Points of the page are relative to its origin. The matrix is stored by columns.
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    pose.topLeftCorner<3, 3>() = setup.part_to_machine;
    pose.topRightCorner<3, 1>() = clamped_point(setup, origin);
    return {
        {"word", configuration.word},
        {"rotary", std::move(rotary)},
        {"part_to_machine", std::vector<double>(pose.data(), pose.data() + pose.size())}};
}

}  // namespace

ViewPath read_view_path(const ViewInput& input, const ViewOptions& options)
{
    const CommonOptions& common = options.common;
    PathOptions path;
    path.file = input.toolpath;
    PathSummary known = path_summary_of(path, common);
    if (const ViewSummary* const reader = summary_of_reader(input, common.limits)) {
        take_reading(path, reader->content);
        if (text_in(reader->content, "interpreter") == "linuxcnc")
            warn(common, shown_path(path.file) +
                             " was judged as LinuxCNC reads it (--interpreter linuxcnc); "
                             "the page shows it as endmill reads it");
        const auto stated = read_path_summary(reader->file, common.limits);
        if (!known.machine && stated)
            known.machine = stated->machine;
        if (!known.cutter && stated)
            known.cutter = stated->cutter;
    }
    if (!options.rotary.machine.empty())
        path.rotary = options.rotary;
    std::optional<Cutter> given;
    if (!options.tool.empty()) {
        const Tool tool = read_tool(options.tool, common.limits);
        path.tool_length = tool.length;
        given = tool.cutter;
    }
    const std::optional<Cutter> cutter = given ? given : known.cutter;
    ViewPath view{read_program_for(path, cutter, common, known.machine)};
    view.cutter = given                 ? given
                  : view.program.cutter ? view.program.cutter
                                        : known.cutter;
    return view;
}

void add_path_view(Json& head, const ViewPath& path, const ViewInput& input,
                   const ReadLimits& limits, ViewFrame& frame)
{
    const ToolPath& whole = path.program.path;
    PathArrays arrays{whole, frame};
    head["path"] = arrays.json(path.cutter);
    if (!input.engagement.empty()) {
        const Engagement engagement{input.engagement, limits};
        arrays.add_limits(head["path"], [&](std::size_t point) {
            return engagement.limit(whole.points[point]);
        });
        head["plots"] = plots_json(whole, engagement, arrays.lengths(), frame);
    }
    if (whole.machine && whole.machine->positions.size() == whole.points.size()) {
        arrays.add_positions(head["path"], whole.machine->positions);
        head["machine"] = machine_json(whole.machine->setup, frame.origin);
    }
}

}  // namespace endmill
