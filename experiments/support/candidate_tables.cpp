// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/candidate_tables.h"

#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <tuple>
#include <utility>

#include "endmill/core/angle.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/spherical_hull.h"
#include "support/named_cells.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

constexpr double half_turn = std::numbers::pi;

double degrees(double radians)
{
    return Angle::radians(radians).degrees();
}

bool is_paper(const RectangleCandidate& rectangle)
{
    return rectangle.origin != RectangleOrigin::OrthographicEdge;
}

double r1_azimuth(const PoleFrame& frame, const RectangleCandidate& rectangle)
{
    const double azimuth = full_turn(
        std::atan2(rectangle.r1_axis.dot(frame.y), rectangle.r1_axis.dot(frame.x)));
    return azimuth < half_turn ? azimuth : azimuth - half_turn;  // R1 and -R1 are one
}

template <class Candidate>
NamedCells kind_cells(std::span<const Candidate> candidates)
{
    std::vector<double> areas;
    std::vector<double> angles;
    for (const Candidate& candidate : candidates) {
        areas.push_back(square_degrees(candidate.area()));
        angles.push_back(solid_angle(candidate));
    }
    if (areas.empty())
        return {};
    const auto [least, largest] = std::ranges::minmax_element(areas);
    const double at_least = angles[static_cast<std::size_t>(least - areas.begin())];
    return {{"count", static_cast<std::int64_t>(areas.size())},
            {"least_area_deg2", *least},
            {"largest_area_deg2", *largest},
            {"largest_over_least", *largest / *least},
            {"solid_angle_over_least", at_least / std::ranges::min(angles)}};
}

std::vector<RectangleCandidate> of_kind(const std::vector<RectangleCandidate>& rectangles,
                                        bool wants_paper)
{
    std::vector<RectangleCandidate> found;
    std::ranges::copy_if(rectangles, std::back_inserter(found),
                         [&](const RectangleCandidate& rectangle) {
                             return is_paper(rectangle) == wants_paper;
                         });
    return found;
}

}  // namespace

CsvTable sector_table(std::span<const SectorCandidate> sectors)
{
    std::vector<SectorCandidate> in_order{sectors.begin(), sectors.end()};
    std::ranges::stable_sort(in_order, {}, [](const SectorCandidate& sector) {
        return full_turn(sector.from);
    });
    CsvTable table{
        {"from_deg", "width_deg", "polar_deg", "opposite_polar_deg", "area_deg2"}};
    for (const SectorCandidate& sector : in_order)
        table.add_row({degrees(full_turn(sector.from)), degrees(sector.width),
                       degrees(sector.polar), degrees(sector.opposite_polar),
                       square_degrees(sector.area())});
    return table;
}

CsvTable rectangle_table(const Vec3& tool_axis,
                         std::vector<RectangleCandidate> rectangles)
{
    const PoleFrame frame{tool_axis};
    std::ranges::stable_sort(rectangles, {}, [&](const RectangleCandidate& rectangle) {
        return std::tuple{!is_paper(rectangle), r1_azimuth(frame, rectangle)};
    });
    CsvTable table{{"kind", "r1_azimuth_deg", "alpha_from_deg", "alpha_to_deg",
                    "beta_from_deg", "beta_to_deg", "area_deg2"}};
    for (const RectangleCandidate& rectangle : rectangles)
        table.add_row({is_paper(rectangle) ? "meridian through an edge"
                                           : "parallel through an edge",
                       degrees(r1_azimuth(frame, rectangle)),
                       degrees(rectangle.alpha.from), degrees(rectangle.alpha.to),
                       degrees(rectangle.beta.from), degrees(rectangle.beta.to),
                       square_degrees(rectangle.area())});
    return table;
}

double solid_angle(const SectorCandidate& sector)
{
    const double one = 1 - std::cos(sector.polar);
    const double other = 1 - std::cos(sector.opposite_polar);
    if (sector.width <= half_turn)
        return sector.width * (one + other);
    return sector.width * one + (2 * half_turn - sector.width) * other;
}

double solid_angle(const RectangleCandidate& rectangle)
{
    return (rectangle.alpha.to - rectangle.alpha.from) *
           (std::sin(rectangle.beta.to) - std::sin(rectangle.beta.from));
}

CsvTable candidate_summary(const DirectionSet& ca,
                           std::span<const SectorCandidate> sectors,
                           std::size_t paper_count, const DirectionSet& ab,
                           const std::vector<RectangleCandidate>& rectangles)
{
    CsvTable table{{"row", "count", "least_area_deg2", "largest_area_deg2",
                    "largest_over_least", "solid_angle_over_least", "share_of_pairs"}};
    const auto add_count = [&](const std::string& row, std::size_t count) {
        add_named(table, row, {{"count", static_cast<std::int64_t>(count)}});
    };
    const auto add_kind = [&](const std::string& row, const NamedCells& cells) {
        if (!cells.empty())
            add_named(table, row, cells);
    };
    add_count("C,A directions", ca.directions.size());
    add_kind("C,A sectors of the paper", kind_cells(sectors.first(paper_count)));
    add_kind("C,A sectors of 180 and wider", kind_cells(sectors.subspan(paper_count)));
    add_count("A,B directions", ab.directions.size());
    const auto meridians = of_kind(rectangles, true);
    const auto parallels = of_kind(rectangles, false);
    const auto number = static_cast<double>(ab.directions.size());
    const double share =
        static_cast<double>(meridians.size()) / (number * (number - 1) / 2);
    add_kind("A,B meridian through an edge",
             joined(kind_cells(std::span<const RectangleCandidate>{meridians}),
                    {{"share_of_pairs", share}}));
    add_kind("A,B parallel through an edge",
             kind_cells(std::span<const RectangleCandidate>{parallels}));
    for (const auto& [row, projection] :
         {std::pair{"A,B gnomonic hull", HullProjection::Gnomonic},
          std::pair{"A,B orthographic hull", HullProjection::Orthographic}})
        add_count(row, spherical_hull(ab.tool_axis, ab.directions, projection).size());
    return table;
}

}  // namespace endmill
