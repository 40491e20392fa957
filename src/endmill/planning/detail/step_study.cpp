// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/step_study.h"

#include <cmath>
#include <numeric>
#include <span>

#include "endmill/planning/detail/segment_distance.h"
#include "endmill/planning/detail/verified_pass.h"
#include "endmill/planning/step_length.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// The surface as it is marched on along u.
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
        if (!point.contact || point.pass == last_pass)
            continue;
        last_pass = point.pass;
        parameters.push_back(direction == Parameter::U ? point.contact->v
                                                       : point.contact->u);
    }
    return parameters;
}

// Steps between samples of a pass, fine beside the steps of any path that is looked at.
constexpr int pass_samples = 4096;

// The line of a pass, sample by sample.
struct PassLine {
    std::vector<Vec3> contacts;
    std::vector<Vec3> centres;    // of the ball
    std::vector<double> bending;  // curvature, 1/mm
};

PassLine pass_line(const MarchedSurface& on, double v, const PlanToJudge& plan)
{
    const Interval range = on.surface.range(Parameter::U);
    PassLine line;
    for (int k = 0; k <= pass_samples; ++k) {
        const double u = std::lerp(range.low, range.high, k / double(pass_samples));
        const SurfaceJet jet = on.surface.jet(u, v);
        line.contacts.push_back(jet.point);
        line.centres.push_back(jet.point + plan.ball.radius() *
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

// Number after the last sample to which the paper's step from number `first` may go.
std::size_t beyond_paper_step(const PassLine& line, std::size_t first, double tolerance)
{
    const double longest = step_length(line.bending[first], tolerance).chord;
    std::size_t end = first + 2;
    while (end < line.contacts.size() &&
           (line.contacts[end] - line.contacts[first]).norm() <= longest)
        ++end;
    return end;
}

// Number of the last sample to which a step from number `first` is found to hold: by
// halving, as errors grow with the step by and large.
std::size_t end_of_step(const PassLine& line, std::size_t first, double tolerance,
                        const StepRule& rule)
{
    std::size_t low = first + 1;
    std::size_t high =
        rule.paper ? beyond_paper_step(line, first, tolerance) : line.contacts.size();
    while (high - low > 1) {
        const std::size_t middle = std::midpoint(low, high);
        const auto holds = [&](std::span<const Vec3> samples) {
            return is_within(samples.subspan(first, middle - first + 1), tolerance);
        };
        const bool is_good = (!rule.chord || holds(line.contacts)) &&
                             (!rule.motion || holds(line.centres));
        (is_good ? low : high) = middle;
    }
    return low;
}

}  // namespace

std::vector<StepErrors> step_errors(const Surface& surface, const ToolPath& path,
                                    const PlanToJudge& plan)
{
    const std::span<const Surface> surfaces{&surface, 1};
    std::vector<StepErrors> errors;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        if (path.points[k].move != Move::Cut)
            continue;
        const ToolPath step{{path.points[k - 1], path.points[k]}};
        const MotionError motion =
            motion_error(surfaces, step, plan.ball, plan.direction);
        errors.push_back({chord_error(surfaces, step, plan.direction).greatest_mm,
                          motion.gouge.greatest_mm});
    }
    return errors;
}

ToolPath rolled_path(const Surface& surface, const ToolPath& path,
                     const PlanToJudge& plan, int pieces)
{
    const double side = tool_side_sign(surface, Vec3::UnitZ());
    const MarchedSurface on{surface, side};
    ToolPath rolled;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& end = path.points[k];
        for (int piece = 1; end.move == Move::Cut && piece < pieces; ++piece) {
            const SurfaceContact& from = *path.points[k - 1].contact;
            const double share = piece / double(pieces);
            const SurfacePoint at{std::lerp(from.u, end.contact->u, share),
                                  std::lerp(from.v, end.contact->v, share)};
            PathPoint between = end;
            between.contact = contact_at(on, at, Parameter::U);
            between.location =
                locate(plan.ball, between.contact->contact, end.location.axis);
            rolled.points.push_back(between);
        }
        rolled.points.push_back(end);
    }
    return rolled;
}

std::size_t verified_points(const Surface& surface, const ToolPath& path,
                            const PlanToJudge& plan)
{
    const std::span<const Surface> surfaces{&surface, 1};
    const MarchedSurface on = marched(surface, plan.direction);
    const ClearMoves clear{surfaces, tool_side_signs(surfaces, Vec3::UnitZ()), plan.ball,
                           Vec3::UnitZ(), plan.tolerance};
    const OffsetBounds bounds{on.surface};
    const StripCover line_cover{on, bounds, plan.ball, plan.tolerance};
    const VerifiedSurface verified{
        .marched = on,
        .clear = clear,
        .line_cover = line_cover,
        .tolerances = {plan.tolerance, plan.tolerance},
        .direction = plan.direction,
        .stop_at_borders = false,
        .most_points = 10 * path.points.size(),
    };
    std::size_t points = 0;
    for (const double v : pass_parameters(path, plan.direction))
        for (const Pass& piece : verified_pass(verified, v, {}).pieces)
            points += piece.size();
    return points;
}

std::size_t greedy_points(const Surface& surface, const ToolPath& path,
                          const PlanToJudge& plan, const StepRule& rule)
{
    const MarchedSurface on = marched(surface, plan.direction);
    std::size_t points = 0;
    for (const double v : pass_parameters(path, plan.direction)) {
        const PassLine line = pass_line(on, v, plan);
        ++points;
        for (std::size_t at = 0; at + 1 < line.contacts.size(); ++points)
            at = end_of_step(line, at, plan.tolerance, rule);
    }
    return points;
}

double area_above_percent(const Deviation& left, double height)
{
    double above = 0;
    for (std::size_t cell = 0; cell < left.left.size(); ++cell)
        if (left.left[cell] > height)
            above += left.area[cell];
    return 100 * above / left.area_mm2;
}

}  // namespace endmill
