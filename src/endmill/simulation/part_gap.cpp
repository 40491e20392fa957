// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/part_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/simulation/half_space.h"

namespace endmill {
namespace {

// Halvings of a chart's sides: its pieces are then small against it.
constexpr int most_halvings = 6;

// How far the reference points of the cutter, and all above them, are from `place`.
double distance_from_sweeps(const SweepTree& tree, const Vec3& place, double least)
{
    tree.visit(
        place, [&](const Vec3& nearest) { return (nearest - place).norm() < least; },
        [&](std::size_t number) {
            Vec3 away = nearest_reference(tree.sweeps()[number], place) - place;
            away.z() = std::max(away.z(), 0.0);
            least = std::min(least, away.norm());
        });
    return least;
}

double gap_of(const PartCharts& charts, const SweepTree& tree, const PartCell& cell,
              int halvings, double least)
{
    const auto ray = charts.ray(cell.chart, cell.centre());
    if (ray) {
        const double around = cell.reach(*ray) + tree.sweeps().front().cutter().radius();
        const double away = distance_from_sweeps(tree, ray->point, least + around);
        if (away - around >= least)
            return least;
        if (halvings == 0)
            return std::max(0.0, away - around);
    }
    if (halvings > 0)
        for (const PartCell& quarter : cell.quarters())
            least = gap_of(charts, tree, quarter, halvings - 1, least);
    return least;
}

}  // namespace

double part_gap(const PartCharts& charts, const SweepTree& tree)
{
    double least = std::numeric_limits<double>::infinity();
    if (tree.sweeps().empty())
        return least;
    for (std::uint32_t chart = 0; chart < charts.count(); ++chart)
        least = gap_of(charts, tree, charts.whole(chart), most_halvings, least);
    return least;
}

}  // namespace endmill
