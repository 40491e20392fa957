// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/conclusion-5/measures.h"

#include <algorithm>

#include "support/path_statistics.h"
#include "support/stated_loads.h"

namespace endmill {
namespace {

// Mean over the length of the larger of force and thrust, each over the tool's limit.
double capacity_used(const std::vector<CuttingLoads>& loads,
                     const std::vector<double>& lengths, const LoadLimits& limits)
{
    double sum = 0;
    double length = 0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        sum += lengths[i] * std::max(loads[i].cutting_force_n / *limits.cutting_force_n,
                                     loads[i].thrust_n / *limits.thrust_n);
        length += lengths[i];
    }
    return sum / length;
}

}  // namespace

FeedMeasures feed_measures(const std::vector<MilledMove>& moves, const MillingJob& job,
                           const MeasureRules& rules)
{
    const std::vector<double> forces = peak_cutting_forces(moves, job);
    const std::vector<CuttingLoads> stated = stated_loads(moves, job, rules.peak_factor);
    std::vector<double> lengths;
    double shallow = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        lengths.push_back(moves[i].cut.length_mm);
        if (moves[i].cut.depth_mm < rules.shallow_mm)
            shallow = std::max(shallow, forces[i]);
    }
    return {.shallow_force_n = shallow,
            .force_n = std::ranges::max(forces),
            .force_variation = variation(forces, lengths),
            .stated_force_variation = variation(cutting_forces(stated), lengths),
            .stated_thrust_variation = variation(thrusts(stated), lengths),
            .capacity_used = capacity_used(stated, lengths, job.tool.limits),
            .used_life = used_life(moves, job, rules.life_min)};
}

const std::vector<FeedClaim>& feed_claims()
{
    using M = FeedMeasures;
    static const std::vector<FeedClaim> claims{
        {"shallow_force_falls",
         [](const M& a, const M& b) { return b.shallow_force_n < a.shallow_force_n; }},
        {"largest_force_falls",
         [](const M& a, const M& b) { return b.force_n < a.force_n; }},
        {"force_disperses",
         [](const M& a, const M& b) { return b.force_variation < a.force_variation; }},
        {"stated_force_disperses",
         [](const M& a, const M& b) {
             return b.stated_force_variation < a.stated_force_variation;
         }},
        {"stated_thrust_disperses",
         [](const M& a, const M& b) {
             return b.stated_thrust_variation < a.stated_thrust_variation;
         }},
        {"capacity_rises",
         [](const M& a, const M& b) { return b.capacity_used > a.capacity_used; }},
        {"used_life_falls",
         [](const M& a, const M& b) { return b.used_life < a.used_life; }}};
    return claims;
}

std::vector<std::string> measure_columns()
{
    std::vector<std::string> columns{"row"};
    for (const auto& [name, cell] : measure_cells({}))
        columns.push_back(name);
    columns.emplace_back("equal_life_rpm");
    for (const FeedClaim& claim : feed_claims())
        columns.push_back(claim.name);
    return columns;
}

NamedCells measure_cells(const FeedMeasures& measures)
{
    return {{"shallow_force_n", measures.shallow_force_n},
            {"force_n", measures.force_n},
            {"force_variation", measures.force_variation},
            {"stated_force_variation", measures.stated_force_variation},
            {"stated_thrust_variation", measures.stated_thrust_variation},
            {"capacity_used", measures.capacity_used},
            {"used_life", measures.used_life}};
}

}  // namespace endmill
