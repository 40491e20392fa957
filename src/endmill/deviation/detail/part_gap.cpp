// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/part_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/answer.h"
#include "endmill/deviation/detail/half_space.h"

namespace endmill {
namespace {

// Times that the sides of a chart are halved; the pieces are then small against the
// chart.
constexpr int most_halvings = 6;
// The same for the search for the narrowest overlap of cutter and part.
constexpr int most_halvings_of_overlap = 12;

// Returns the distance of `place` from the reference points of the sweeps and everything
// above them, if it is less than `least`; else `least`.
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

// Lowers `least` to the gap of a cell, by halving the cell.
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

// Whether no point of the level disc with this radius lies in the half space.
bool is_clear(const HalfSpace& half, const Vec3& middle, double radius)
{
    return half.least - half.normal.dot(middle) >= radius * half.normal.head<2>().norm();
}

// Whether the sweeps that come below `top` pass over the cell, seen from above. They do if
// one covers its middle; they do not if none reaches the disc around the cell.
Answer passes_over_cell(const SweepTree& tree, const Vec3& middle, double reach,
                        double top)
{
    const Cutter& cutter = tree.sweeps().front().cutter();
    const Vec3 at_top{middle.x(), middle.y(), top};
    const Vec3 place = at_top + Vec3{0, 0, cutter.corner_radius()};
    const double around = reach + cutter.radius();
    Answer answer = Answer::No;
    tree.visit(
        place,
        [&](const Vec3& nearest) {
            return answer != Answer::Yes && nearest.z() <= place.z() &&
                   (nearest - place).head<2>().norm() <= around;
        },
        [&](std::size_t number) {
            const StraightSweep& sweep = tree.sweeps()[number];
            if (sweep.height(place.x(), place.y()) < top)
                answer = Answer::Yes;
            else if (!is_clear(half_space_beyond(sweep, at_top), at_top, reach))
                answer = Answer::Undecided;
        });
    return answer;
}

// Halves the cell while the answer is undecided.
bool passes_over(const PartCharts& charts, const SweepTree& tree, const PartCell& cell,
                 int halvings, double top)
{
    if (const auto ray = charts.ray(cell.chart, cell.centre())) {
        const Answer answer = passes_over_cell(tree, ray->point, cell.reach(*ray), top);
        if (answer != Answer::Undecided)
            return answer == Answer::Yes;
    }
    if (halvings == 0)
        return false;
    for (const PartCell& quarter : cell.quarters())
        if (passes_over(charts, tree, quarter, halvings - 1, top))
            return true;
    return false;
}

}  // namespace

bool passes_over(const PartCharts& charts, const SweepTree& tree, double top)
{
    if (tree.sweeps().empty())
        return false;
    for (std::uint32_t chart = 0; chart < charts.count(); ++chart)
        if (passes_over(charts, tree, charts.whole(chart), most_halvings_of_overlap, top))
            return true;
    return false;
}

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
