// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/step_study.h"

#include <cmath>
#include <numeric>
#include <span>

#include "endmill/planning/detail/segment_distance.h"
#include "endmill/planning/detail/verified_pass.h"
#include "endmill/planning/path_error.h"
#include "endmill/planning/step_length.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// `surface` with its parameters exchanged if needed, so that passes run along u.
MarchedSurface marched(const Surface& surface, Parameter direction)
{
    const double side = tool_side_sign(surface, Vec3::UnitZ());
    if (direction == Parameter::U)
        return {surface, side};
    return {transposed(surface), -side};
}

// The constant parameter of each pass of `path`.
std::vector<double> pass_parameters(const ToolPath& path, Parameter direction)
{
    std::vector<double> parameters;
    int last_pass = -1;
    for (const PathPoint& point : path.points) {
        if (!point.contact() || point.pass == last_pass)
            continue;
        last_pass = point.pass;
        parameters.push_back(direction == Parameter::U ? point.contact()->v
                                                       : point.contact()->u);
    }
    return parameters;
}

// Intervals between samples of a pass, many times the number of steps of a planned pass.
constexpr int pass_samples = 4096;

// The contact curve of a pass and its curve of ball centres, by samples.
struct PassLine {
    std::vector<Vec3> contacts;
    std::vector<Vec3> centres;    // ball centres
    std::vector<double> bending;  // curvature, 1/mm
};

PassLine pass_line(const MarchedSurface& on, double v, const PassSettings& settings)
{
    const Interval range = on.surface.range(Parameter::U);
    PassLine line;
    for (int k = 0; k <= pass_samples; ++k) {
        const double u = std::lerp(range.low, range.high, k / double(pass_samples));
        const SurfaceJet jet = on.surface.jet(u, v);
        line.contacts.push_back(jet.point);
        line.centres.push_back(jet.point + settings.ball.radius() *
                                               fundamental_forms(jet, on.side).normal);
        line.bending.push_back(curve_curvature(jet.du, jet.duu));
    }
    return line;
}

bool is_within(std::span<const Vec3> samples, double tolerance)
{
    for (const Vec3& sample : samples)
        if (segment_distance(sample, samples.front(), samples.back()) > tolerance)
            return false;
    return true;
}

// One past the last sample within the paper's step length of sample `first`.
std::size_t beyond_paper_step(const PassLine& line, std::size_t first, double tolerance)
{
    const double longest = step_length(line.bending[first], tolerance).chord;
    std::size_t end = first + 2;
    while (end < line.contacts.size() &&
           (line.contacts[end] - line.contacts[first]).norm() <= longest)
        ++end;
    return end;
}

// Last sample to which a step from sample `first` satisfies the rule. Bisection finds it,
// on the assumption that the error grows with the length of the step.
std::size_t end_of_step(const PassLine& line, std::size_t first, double tolerance,
                        const StepRule& rule)
{
    std::size_t low = first + 1;
    std::size_t high = rule.longest == LongestStep::Paper
                           ? beyond_paper_step(line, first, tolerance)
                           : line.contacts.size();
    while (high - low > 1) {
        const std::size_t middle = std::midpoint(low, high);
        const auto holds = [&](std::span<const Vec3> samples) {
            return is_within(samples.subspan(first, middle - first + 1), tolerance);
        };
        const bool is_good =
            holds(line.contacts) &&
            (rule.limited == LimitedCurves::Contacts || holds(line.centres));
        (is_good ? low : high) = middle;
    }
    return low;
}

}  // namespace

std::vector<StepErrors> step_errors(const Surface& surface, const ToolPath& path,
                                    const PassSettings& settings)
{
    const std::span<const Surface> surfaces{&surface, 1};
    std::vector<StepErrors> errors;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        if (path.points[k].move != Move::Cut)
            continue;
        const ToolPath step{{path.points[k - 1], path.points[k]}};
        const MotionError motion =
            motion_error(surfaces, step, settings.ball, settings.direction);
        errors.push_back({chord_error(surfaces, step, settings.direction).greatest_mm,
                          motion.gouge.greatest_mm});
    }
    return errors;
}

ToolPath rolled_path(const Surface& surface, const ToolPath& path, const BallCutter& ball,
                     int pieces)
{
    const double side = tool_side_sign(surface, Vec3::UnitZ());
    const MarchedSurface on{surface, side};
    ToolPath rolled;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& end = path.points[k];
        for (int piece = 1; end.move == Move::Cut && piece < pieces; ++piece) {
            const SurfaceContact& from = *path.points[k - 1].contact();
            const double share = piece / double(pieces);
            const SurfacePoint at{std::lerp(from.u, end.contact()->u, share),
                                  std::lerp(from.v, end.contact()->v, share)};
            PathPoint between = end;
            const SurfaceContact contact = contact_at(on, at, Parameter::U);
            between.known_contact = contact;
            between.location = locate(ball, contact.contact, end.location.axis);
            rolled.points.push_back(between);
        }
        rolled.points.push_back(end);
    }
    return rolled;
}

std::size_t verified_points(const Surface& surface, const ToolPath& path,
                            const PassSettings& settings)
{
    const std::span<const Surface> surfaces{&surface, 1};
    const MarchedSurface on = marched(surface, settings.direction);
    const ClearMoves clear{surfaces, tool_side_signs(surfaces, Vec3::UnitZ()),
                           settings.ball, Vec3::UnitZ(), settings.tolerance};
    const OffsetBounds bounds{on.surface};
    const StripCover line_cover{on, bounds, settings.ball, settings.tolerance};
    const VerifiedSurface verified{
        .marched = on,
        .clear = clear,
        .line_cover = line_cover,
        .tolerances = {settings.tolerance, settings.tolerance},
        .direction = settings.direction,
        .patch_borders = PatchBorders::Cross,
        .most_points = 10 * path.points.size(),
    };
    std::size_t points = 0;
    for (const double v : pass_parameters(path, settings.direction))
        for (const Pass& piece : verified_pass(verified, v, {}).pieces)
            points += piece.size();
    return points;
}

std::size_t greedy_points(const Surface& surface, const ToolPath& path,
                          const PassSettings& settings, const StepRule& rule)
{
    const MarchedSurface on = marched(surface, settings.direction);
    std::size_t points = 0;
    for (const double v : pass_parameters(path, settings.direction)) {
        const PassLine line = pass_line(on, v, settings);
        ++points;
        for (std::size_t at = 0; at + 1 < line.contacts.size(); ++points)
            at = end_of_step(line, at, settings.tolerance, rule);
    }
    return points;
}

}  // namespace endmill
