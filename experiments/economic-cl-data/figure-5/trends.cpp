// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/figure-5/trends.h"

#include <algorithm>
#include <cmath>

#include "endmill/planning/path_interval.h"

namespace endmill {
namespace {

// Counts pairs, and those whose second value is greater.
struct Pairs {
    int all = 0;
    int rising = 0;

    void add(std::optional<double> first, std::optional<double> second)
    {
        if (!first || !second)
            return;
        ++all;
        rising += *second > *first ? 1 : 0;
    }
    double rising_percent() const { return 100.0 * rising / all; }
};

// The longest interval at which the balls still intersect above the section.
double longest_interval(const BallCutter& ball, double curvature)
{
    const double meeting = 2 * ball.radius() / (1 + curvature * ball.radius());
    return curvature == 0 ? meeting : std::min(meeting, 2 / std::abs(curvature));
}

}  // namespace

std::optional<double> scallop_if_any(const BallCutter& ball, double curvature,
                                     double interval)
{
    if (interval >= longest_interval(ball, curvature))
        return std::nullopt;
    return scallop_height(ball, curvature, interval);
}

std::vector<std::pair<std::string, double>> trends(const Sweep& sweep)
{
    Pairs scallop_by_curvature;
    Pairs scallop_by_falling_radius;
    Pairs interval_by_falling_curvature;
    Pairs interval_by_radius;
    const auto scallop = [&](std::size_t r, std::size_t k, double interval) {
        return scallop_if_any(BallCutter{sweep.radii[r]}, sweep.curvatures[k], interval);
    };
    const auto interval = [&](std::size_t r, std::size_t k, double height) {
        return path_interval(BallCutter{sweep.radii[r]}, sweep.curvatures[k], height)
            .chord;
    };
    for (std::size_t r = 0; r < sweep.radii.size(); ++r)
        for (std::size_t k = 1; k < sweep.curvatures.size(); ++k) {
            for (const double l : sweep.intervals)
                scallop_by_curvature.add(scallop(r, k - 1, l), scallop(r, k, l));
            for (const double h : sweep.scallops)
                interval_by_falling_curvature.add(interval(r, k, h),
                                                  interval(r, k - 1, h));
        }
    for (std::size_t k = 0; k < sweep.curvatures.size(); ++k)
        for (std::size_t r = 1; r < sweep.radii.size(); ++r) {
            for (const double l : sweep.intervals)
                scallop_by_falling_radius.add(scallop(r, k, l), scallop(r - 1, k, l));
            for (const double h : sweep.scallops)
                interval_by_radius.add(interval(r - 1, k, h), interval(r, k, h));
        }
    return {
        {"scallop rises with curvature", scallop_by_curvature.rising_percent()},
        {"scallop falls with radius", scallop_by_falling_radius.rising_percent()},
        {"interval falls with curvature", interval_by_falling_curvature.rising_percent()},
        {"interval rises with radius", interval_by_radius.rising_percent()}};
}

}  // namespace endmill
