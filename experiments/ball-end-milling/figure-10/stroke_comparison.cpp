// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/figure-10/stroke_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "endmill/figures/detail/stacked_chart.h"
#include "support/path_statistics.h"
#include "support/stated_loads.h"

namespace endmill {
namespace {

double larger_magnitude(double a, double b)
{
    return std::max(std::abs(a), std::abs(b));
}

std::vector<ForceRange> turn_ranges(const std::vector<MilledMove>& moves,
                                    const MillingJob& job, int steps)
{
    std::vector<ForceRange> ranges;
    ranges.reserve(moves.size());
    for (const MilledMove& move : moves)
        ranges.push_back(turn_range(move, job, steps));
    return ranges;
}

void add_along(CsvTable& table, const std::string& feed,
               const std::vector<MilledMove>& moves,
               const std::vector<ForceRange>& ranges)
{
    double travel = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const double half = moves[i].cut.length_mm / 2;
        const auto& [least, greatest] = ranges[i];
        table.add_row({feed + ", point " + std::to_string(moves[i].cut.point),
                       travel + half, feed, least.x_n, greatest.x_n, least.y_n,
                       greatest.y_n, least.z_n, greatest.z_n});
        travel += 2 * half;
    }
}

// Coefficients of variation over the length of the largest magnitudes in a turn.
ForceVariation force_variation(const std::vector<MilledMove>& moves,
                               const std::vector<ForceRange>& ranges)
{
    std::vector<double> lengths;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> thrust;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const auto& [least, greatest] = ranges[i];
        lengths.push_back(moves[i].cut.length_mm);
        x.push_back(larger_magnitude(least.x_n, greatest.x_n));
        y.push_back(larger_magnitude(least.y_n, greatest.y_n));
        thrust.push_back(larger_magnitude(least.z_n, greatest.z_n));
    }
    return {variation(x, lengths), variation(y, lengths), variation(thrust, lengths)};
}

bool removal_rises(const StrokeComparison& compared)
{
    return compared.varied.minutes < compared.constant.minutes;
}

bool peaks_fall(const StrokeComparison& compared)
{
    const CuttingForce& before = compared.constant.largest;
    const CuttingForce& after = compared.varied.largest;
    return after.x_n < before.x_n && after.y_n < before.y_n;
}

bool is_faster_with_smaller_peaks(const StrokeComparison& compared)
{
    return removal_rises(compared) && peaks_fall(compared);
}

bool xy_forces_disperse(const StrokeComparison& compared)
{
    const ForceVariation& before = compared.constant_variation;
    const ForceVariation& after = compared.varied_variation;
    return after.x < before.x && after.y < before.y;
}

bool thrust_disperses(const StrokeComparison& compared)
{
    return compared.varied_variation.thrust < compared.constant_variation.thrust;
}

bool downhill_thrust_hardly_falls(const StrokeComparison& compared)
{
    const StrokeForces& constant = compared.constant;
    const StrokeForces& varied = compared.varied;
    if (constant.largest_downhill.z_n == 0)
        return false;
    const double thrust = varied.largest_downhill.z_n / constant.largest_downhill.z_n;
    return thrust > std::max(varied.largest.x_n / constant.largest.x_n,
                             varied.largest.y_n / constant.largest.y_n);
}

// The moves of one pass.
std::vector<SegmentCut> pass_of(const std::vector<SegmentCut>& cuts, int pass)
{
    std::vector<SegmentCut> stroke = cuts;
    std::erase_if(stroke, [&](const SegmentCut& cut) { return cut.pass != pass; });
    return stroke;
}

double minutes_of(const std::vector<MilledMove>& moves, int flutes)
{
    double minutes = 0;
    for (const auto& [cut, feed, speed] : moves)
        minutes += cut.length_mm / (flutes * feed * speed);
    return minutes;
}

using Values = std::vector<std::optional<double>>;

// One panel of a chart of both feeds.
struct TwoFeeds {
    std::string_view label;
    Values constant;
    Values varied;
};

std::string two_feeds_figure(const ChartFrame& frame, std::span<const double> places,
                             const std::vector<TwoFeeds>& forces)
{
    constexpr LineStyle constant_style{"#0072B2", 1.4, "6 3"};
    constexpr LineStyle varied_style{"#D55E00", 1.4, ""};
    std::vector<ChartPanel> panels;
    panels.reserve(forces.size());
    for (const TwoFeeds& force : forces)
        panels.push_back({force.label,
                          {{"0.1 mm a tooth", constant_style, force.constant},
                           {"varied feed", varied_style, force.varied}}});
    return stacked_chart(frame, places, panels);
}

// Adds the value of each row of `table` to the curve of its feed.
template <typename ValueOf>
TwoFeeds by_feed(std::string_view label, const CsvTable& table, const ValueOf& value_of)
{
    TwoFeeds found{label, {}, {}};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        Values& curve =
            table.cell(row, "feed") == "constant" ? found.constant : found.varied;
        curve.push_back(value_of(row));
    }
    return found;
}

// The abscissas of the rows of the constant feed; those of the varied feed are the same.
std::vector<double> places_of(const CsvTable& table, std::string_view column)
{
    std::vector<double> places;
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (table.cell(row, "feed") == "constant")
            places.push_back(table.number(row, column).value());
    return places;
}

}  // namespace

NamedCells stroke_cells(const StrokeForces& stroke, const ForceVariation& variation)
{
    return {{"minutes", stroke.minutes},
            {"removed_mm3_per_min", stroke.removed_mm3 / stroke.minutes},
            {"force_x_n", stroke.largest.x_n},
            {"force_y_n", stroke.largest.y_n},
            {"thrust_n", stroke.largest.z_n},
            {"downhill_x_n", stroke.largest_downhill.x_n},
            {"downhill_y_n", stroke.largest_downhill.y_n},
            {"downhill_thrust_n", stroke.largest_downhill.z_n},
            {"x_variation", variation.x},
            {"y_variation", variation.y},
            {"thrust_variation", variation.thrust}};
}

StrokeComparison compared_strokes(const std::vector<MilledMove>& constant,
                                  const std::vector<MilledMove>& varied,
                                  const MillingJob& job, int steps)
{
    const auto of_constant = turn_ranges(constant, job, steps);
    const auto of_varied = turn_ranges(varied, job, steps);
    StrokeComparison compared{
        stroke_forces(constant, of_constant, job), stroke_forces(varied, of_varied, job),
        force_variation(constant, of_constant), force_variation(varied, of_varied),
        CsvTable{{"row", "travel_mm", "feed", "least_x_n", "greatest_x_n", "least_y_n",
                  "greatest_y_n", "least_z_n", "greatest_z_n"}}};
    add_along(compared.along, "constant", constant, of_constant);
    add_along(compared.along, "varied", varied, of_varied);
    return compared;
}

CsvTable middle_turn(const std::vector<MilledMove>& constant,
                     const std::vector<MilledMove>& varied, const MillingJob& job,
                     int steps)
{
    CsvTable table{{"row", "theta_deg", "feed", "force_x_n", "force_y_n", "force_z_n"}};
    const auto add = [&](const std::string& feed, const MilledMove& move) {
        const std::vector<CuttingForce> forces = turn_forces(move, job, steps);
        for (int i = 0; i < steps; ++i) {
            const CuttingForce& force = forces[static_cast<std::size_t>(i)];
            table.add_row({feed + " " + std::to_string(i), 360.0 * i / steps, feed,
                           force.x_n, force.y_n, force.z_n});
        }
    };
    add("constant", constant[constant.size() / 2]);
    add("varied", varied[varied.size() / 2]);
    return table;
}

const std::vector<StrokeClaim>& stroke_claims()
{
    static const std::vector<StrokeClaim> claims{
        {"removal_rises", removal_rises},
        {"peaks_fall", peaks_fall},
        {"faster_with_smaller_peaks", is_faster_with_smaller_peaks},
        {"xy_forces_disperse", xy_forces_disperse},
        {"thrust_disperses", thrust_disperses},
        {"downhill_thrust_hardly_falls", downhill_thrust_hardly_falls}};
    return claims;
}

NamedCells claim_cells(const StrokeComparison& compared)
{
    const CuttingForce& before = compared.constant.largest;
    const CuttingForce& after = compared.varied.largest;
    const CuttingForce& before_downhill = compared.constant.largest_downhill;
    const CuttingForce& after_downhill = compared.varied.largest_downhill;
    const ForceVariation& spread_before = compared.constant_variation;
    const ForceVariation& spread_after = compared.varied_variation;
    NamedCells cells{{"minutes", compared.varied.minutes / compared.constant.minutes},
                     {"force_x_n", after.x_n / before.x_n},
                     {"force_y_n", after.y_n / before.y_n},
                     {"thrust_n", after.z_n / before.z_n},
                     {"downhill_x_n", after_downhill.x_n / before_downhill.x_n},
                     {"downhill_y_n", after_downhill.y_n / before_downhill.y_n},
                     {"downhill_thrust_n", after_downhill.z_n / before_downhill.z_n},
                     {"x_variation", spread_after.x / spread_before.x},
                     {"y_variation", spread_after.y / spread_before.y},
                     {"thrust_variation", spread_after.thrust / spread_before.thrust}};
    for (const StrokeClaim& claim : stroke_claims())
        cells.emplace_back(claim.name, word(claim.holds(compared)));
    return cells;
}

NamedCells claim_counts(const std::vector<SegmentCut>& cuts, const MillingJob& job,
                        double constant_mm, int steps)
{
    std::vector<std::int64_t> counts(stroke_claims().size());
    for (int pass = 0; pass <= cuts.back().pass; ++pass) {
        const std::vector<SegmentCut> stroke = pass_of(cuts, pass);
        const FeedPlan plan = feed_plan(stroke, job, {});
        const StrokeComparison compared =
            compared_strokes(milled_moves(stroke, plan, constant_mm),
                             milled_moves(stroke, plan, {}), job, steps);
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] += stroke_claims()[i].holds(compared) ? 1 : 0;
    }
    NamedCells cells;
    for (std::size_t i = 0; i < counts.size(); ++i)
        cells.emplace_back(stroke_claims()[i].name, counts[i]);
    return cells;
}

NamedCells stated_claim_counts(const std::vector<SegmentCut>& cuts, const MillingJob& job,
                               double constant_mm, double peak_factor)
{
    std::int64_t count = 0;
    for (int pass = 0; pass <= cuts.back().pass; ++pass) {
        const std::vector<SegmentCut> stroke = pass_of(cuts, pass);
        const FeedPlan plan = feed_plan(stroke, job, {.peak_factor = peak_factor});
        const auto constant = milled_moves(stroke, plan, constant_mm);
        const auto varied = milled_moves(stroke, plan, {});
        const auto largest = [&](const std::vector<MilledMove>& moves) {
            return std::ranges::max(
                cutting_forces(stated_loads(moves, job, peak_factor)));
        };
        const int flutes = job.tool.flutes;
        if (minutes_of(varied, flutes) < minutes_of(constant, flutes) &&
            largest(varied) < largest(constant))
            ++count;
    }
    return {{"faster_with_smaller_peaks", count}};
}

std::string along_figure(const std::string& title, const CsvTable& along)
{
    const auto panel = [&](std::string_view label, const std::string& axis) {
        return by_feed(label, along, [&](std::size_t row) {
            return larger_magnitude(along.number(row, "least_" + axis + "_n").value(),
                                    along.number(row, "greatest_" + axis + "_n").value());
        });
    };
    return two_feeds_figure(
        {title,
         {"Largest magnitude in a turn of the cutter"},
         "way along the stroke, mm"},
        places_of(along, "travel_mm"),
        {panel("force along the feed, N", "x"), panel("force across the feed, N", "y"),
         panel("thrust, N", "z")});
}

std::string turn_figure(const std::string& title, const CsvTable& turn)
{
    const auto panel = [&](std::string_view label, const std::string& column) {
        return by_feed(label, turn,
                       [&](std::size_t row) { return turn.number(row, column).value(); });
    };
    return two_feeds_figure({title, {}, "turn of the cutter, degrees"},
                            places_of(turn, "theta_deg"),
                            {panel("force along the feed, N", "force_x_n"),
                             panel("force across the feed, N", "force_y_n"),
                             panel("thrust, N", "force_z_n")});
}

}  // namespace endmill
