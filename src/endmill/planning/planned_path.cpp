// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/planned_path.h"

#include <algorithm>
#include <atomic>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/planning/iso_parametric.h"

namespace endmill {
namespace {

// Factor within which estimated_points is right.
constexpr double estimate_margin = 2;
// Share of the memory that paths may need together to be planned at the same time. The
// rest is for the measurement of the paths, and for estimates that are too low.
constexpr double share_of_all = 0.25;

// Options of the planner of the paper whose steps and intervals are about as long.
IsoParametricOptions similar_options(const PlannerOptions& options)
{
    if (const auto* paper = std::get_if<IsoParametricOptions>(&options))
        return *paper;
    const auto& verified = std::get<VerifiedOptions>(options);
    const auto [inner, outer] = verified.tolerances;
    return {
        .direction = verified.direction,
        // A one-sided tolerance is used as a whole, whatever the sign of the curvature.
        .chord_tolerance = verified.tolerances.is_one_sided() ? std::max(inner, outer)
                                                              : std::min(inner, outer),
        .scallop_height = verified.scallop_height,
        .patch_borders = verified.patch_borders,
        .link = verified.link,
    };
}

// Adds to an error about too many points how much memory the whole path would need.
// \param done share of the path that had been planned; 0: not known.
std::string with_memory(const LimitError& error, std::size_t most_points, double done)
{
    const double gib =
        static_cast<double>(most_points) * bytes_per_path_point / bytes_per_gib;
    std::ostringstream message;
    message << std::setprecision(2) << error.what() << "; the path would need "
            << (done > 0 ? "about " : "more than ") << (done > 0 ? gib / done : gib)
            << " GiB; expected at most " << gib
            << " GiB (--max-memory); larger tolerances need fewer points";
    return message.str();
}

PlannedPath planned(std::span<const Surface> surfaces, const BallCutter& cutter,
                    const PlannerOptions& options)
{
    if (const auto* paper = std::get_if<IsoParametricOptions>(&options))
        return {plan_iso_parametric(surfaces, cutter, *paper).path};
    VerifiedPlan plan =
        plan_verified(surfaces, cutter, std::get<VerifiedOptions>(options));
    return {std::move(plan.path), plan.lifted_links, std::move(plan.uncovered)};
}

}  // namespace

PlannedPath plan_path(std::span<const Surface> surfaces, const BallCutter& cutter,
                      const PlannerOptions& options)
{
    std::atomic<double> done = 0;
    PlannerOptions own = options;
    const std::size_t most_points = std::visit(
        [&](auto& chosen) {
            chosen.progress = [&done, report = chosen.progress](double share) {
                done = share;
                if (report)
                    report(share);
            };
            return chosen.most_points;
        },
        own);
    try {
        return planned(surfaces, cutter, own);
    } catch (const LimitError& error) {
        throw LimitError{with_memory(error, most_points, done)};
    }
}

double estimated_points(std::span<const Surface> surfaces, const BallCutter& cutter,
                        const PlannerOptions& options)
{
    const IsoParametricOptions similar = similar_options(options);
    double points = 0;
    for (const Surface& surface : surfaces)
        points += estimated_points(surface, cutter, similar);
    return points;
}

std::size_t most_path_points(double memory_gib)
{
    const double points = memory_gib * bytes_per_gib / bytes_per_path_point;
    constexpr auto most = std::numeric_limits<std::size_t>::max();
    return points < static_cast<double>(most) ? static_cast<std::size_t>(points) : most;
}

void require_path_memory(double points, double memory_gib)
{
    const auto most = static_cast<double>(most_path_points(memory_gib));
    if (points <= estimate_margin * most)
        return;
    std::ostringstream message;
    message << std::setprecision(2) << "about " << points
            << " CL points would need about "
            << points * bytes_per_path_point / bytes_per_gib << " GiB; expected at most "
            << to_text(memory_gib) << " GiB (--max-memory), enough for " << most
            << " points; larger tolerances need fewer points";
    throw LimitError{message.str()};
}

bool fit_together(std::span<const double> points, double memory_gib)
{
    double sum = 0;
    for (const double own : points) {
        require_path_memory(own, memory_gib);
        sum += own;
    }
    return sum <= share_of_all * static_cast<double>(most_path_points(memory_gib));
}

}  // namespace endmill
