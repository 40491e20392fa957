// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/stroke_comparison.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace endmill {
namespace {

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

}  // namespace

NamedCells stroke_cells(const StrokeForces& stroke)
{
    return {{"minutes", stroke.minutes},
            {"removed_mm3_per_min", stroke.removed_mm3 / stroke.minutes},
            {"force_x_n", stroke.largest.x_n},
            {"force_y_n", stroke.largest.y_n},
            {"thrust_n", stroke.largest.z_n},
            {"downhill_x_n", stroke.largest_downhill.x_n},
            {"downhill_y_n", stroke.largest_downhill.y_n},
            {"downhill_thrust_n", stroke.largest_downhill.z_n}};
}

StrokeComparison compared_strokes(const std::vector<MilledMove>& constant,
                                  const std::vector<MilledMove>& varied,
                                  const MillingJob& job, int steps)
{
    const auto of_constant = turn_ranges(constant, job, steps);
    const auto of_varied = turn_ranges(varied, job, steps);
    StrokeComparison compared{
        stroke_forces(constant, of_constant, job), stroke_forces(varied, of_varied, job),
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

bool is_faster_with_smaller_peaks(const StrokeComparison& compared)
{
    const auto& [constant, varied, along] = compared;
    return varied.minutes < constant.minutes &&
           varied.largest.x_n < constant.largest.x_n &&
           varied.largest.y_n < constant.largest.y_n;
}

bool downhill_thrust_hardly_falls(const StrokeComparison& compared)
{
    const auto& [constant, varied, along] = compared;
    if (constant.largest_downhill.z_n == 0)
        return false;
    const double thrust = varied.largest_downhill.z_n / constant.largest_downhill.z_n;
    return thrust > std::max(varied.largest.x_n / constant.largest.x_n,
                             varied.largest.y_n / constant.largest.y_n);
}

NamedCells claim_cells(const StrokeComparison& compared)
{
    const auto& [constant, varied, along] = compared;
    const CuttingForce& before = constant.largest;
    const CuttingForce& after = varied.largest;
    const CuttingForce& before_downhill = constant.largest_downhill;
    const CuttingForce& after_downhill = varied.largest_downhill;
    return {
        {"minutes", varied.minutes / constant.minutes},
        {"force_x_n", after.x_n / before.x_n},
        {"force_y_n", after.y_n / before.y_n},
        {"thrust_n", after.z_n / before.z_n},
        {"downhill_x_n", after_downhill.x_n / before_downhill.x_n},
        {"downhill_y_n", after_downhill.y_n / before_downhill.y_n},
        {"downhill_thrust_n", after_downhill.z_n / before_downhill.z_n},
        {"faster_with_smaller_peaks", word(is_faster_with_smaller_peaks(compared))},
        {"downhill_thrust_hardly_falls", word(downhill_thrust_hardly_falls(compared))}};
}

NamedCells claim_counts(const std::vector<SegmentCut>& cuts, const MillingJob& job,
                        double constant_mm, int steps)
{
    std::int64_t faster = 0;
    std::int64_t thrust = 0;
    for (int pass = 0; pass <= cuts.back().pass; ++pass) {
        std::vector<SegmentCut> stroke = cuts;
        std::erase_if(stroke, [&](const SegmentCut& cut) { return cut.pass != pass; });
        const FeedPlan plan = feed_plan(stroke, job, {});
        const StrokeComparison compared =
            compared_strokes(milled_moves(stroke, plan, constant_mm),
                             milled_moves(stroke, plan, {}), job, steps);
        faster += is_faster_with_smaller_peaks(compared) ? 1 : 0;
        thrust += downhill_thrust_hardly_falls(compared) ? 1 : 0;
    }
    return {{"faster_with_smaller_peaks", faster},
            {"downhill_thrust_hardly_falls", thrust}};
}

}  // namespace endmill
