// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_sections.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/files/csv.h"

namespace endmill {
namespace {

constexpr std::size_t most_section_points = 2'000'000;

// The curves of a plane, and its position across the feed, mm.
struct Plane {
    std::vector<std::vector<float>> curves = {};  // s, z of each point
    std::optional<double> position = {};
};

// The direction of the feed that a summary beside the sections names.
std::optional<Angle> feed_direction(const ViewInput& input)
{
    std::vector<std::string> files{input.sections};
    for (const TrimmedSections& trimmed : input.trimmed)
        files.push_back(trimmed.file);
    for (const std::string& file : files) {
        const ViewSummary* const beside = summary_beside(input, file);
        if (!beside)
            continue;
        const auto found = beside->content.find("direction_deg");
        if (found != beside->content.end() && found->is_number())
            return Angle::degrees(found->get<double>());
    }
    return std::nullopt;
}

double number_of_plane(const CsvTable& table, std::size_t row, const std::string& file)
{
    constexpr double most_planes = 1e7;
    const double plane = table.number(row, "plane").value_or(-1);
    if (!(plane >= 0 && plane < most_planes && plane == std::floor(plane)))
        throw FormatError{"E_CSV",
                          {shown_path(file), std::to_string(row + 2),
                           "plane " + table.cell(row, "plane"),
                           "a whole number from 0, below 10000000"}};
    return plane;
}

using Planes = std::map<double, Plane>;

// \param points the number of points of the page so far, which grows.
Planes planes_of(const std::string& file, const ReadLimits& limits,
                 const std::optional<Angle>& direction, std::size_t& points)
{
    const CsvTable table = read_csv(file, limits);
    for (const char* column : {"plane", "curve", "s_mm", "z_mm"})
        if (std::ranges::find(table.columns(), column) == table.columns().end())
            throw FormatError{"E_CSV",
                              {shown_path(file), "1", std::string{"no column "} + column,
                               "plane,curve,point,s_mm,x_mm,y_mm,z_mm"}};
    points += table.rows();
    if (points > most_section_points)
        throw LimitError{shown_path(file) + ": with it the sections have " +
                         std::to_string(points) + " points; a page shows at most " +
                         std::to_string(most_section_points)};
    Planes planes;
    std::optional<double> last_curve;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        Plane& plane = planes[number_of_plane(table, row, file)];
        const double curve = table.number(row, "curve").value_or(-1);
        if (plane.curves.empty() || last_curve != curve)
            plane.curves.emplace_back();
        last_curve = curve;
        for (const char* column : {"s_mm", "z_mm"})
            plane.curves.back().push_back(
                static_cast<float>(table.number(row, column).value_or(0)));
        if (plane.position || !direction)
            continue;
        const auto x = table.number(row, "x_mm");
        const auto y = table.number(row, "y_mm");
        if (x && y)
            plane.position =
                *y * std::cos(direction->radians()) - *x * std::sin(direction->radians());
    }
    return planes;
}

Json curves_json(const std::vector<std::vector<float>>& curves, ViewFrame& frame)
{
    Json list = Json::array();
    for (const std::vector<float>& curve : curves)
        list.push_back(array_json(frame.numbers.add(curve)));
    return list;
}

}  // namespace

Json sections_view(const ViewInput& input, const ReadLimits& limits, ViewFrame& frame)
{
    const std::optional<Angle> direction = feed_direction(input);
    std::size_t points = 0;
    Planes before = planes_of(input.sections, limits, direction, points);
    std::vector<Planes> after;
    Json methods = Json::array();
    for (const auto& [method, file] : input.trimmed) {
        methods.push_back(method);
        after.push_back(planes_of(file, limits, direction, points));
        for (const auto& [number, plane] : after.back())
            if (Plane& known = before[number]; !known.position)
                known.position = plane.position;
    }
    if (before.empty())
        throw FormatError{"E_EMPTY",
                          {shown_path(input.sections), "", "no curve", "a section"}};
    Json planes = Json::array();
    for (const auto& [number, plane] : before) {
        Json view{{"number", static_cast<int>(number)},
                  {"before", curves_json(plane.curves, frame)},
                  {"after", Json::array()}};
        for (Planes& of_method : after)
            view["after"].push_back(curves_json(of_method[number].curves, frame));
        if (plane.position)
            view["position_mm"] = *plane.position;
        planes.push_back(std::move(view));
    }
    return {{"methods", std::move(methods)}, {"planes", std::move(planes)}};
}

}  // namespace endmill
