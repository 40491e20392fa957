// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/axis_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/setup/detail/setup_order.h"

// How the best range about an axis is found: branch and bound over pairs of levels (m0,
// m1).
//
// 1. Only levels of cells can be optimal, so that m0 and m1 are chosen from sorted lists.
//    A box is a pair of intervals of these lists.
// 2. The cells up to the upper levels of a box are swept once about the axis. This gives
//    the least window w that meets all cones with these cells.
// 3. (w, upper levels) is a range that meets all cones, and a candidate. (w, lower
//    levels) is a lower bound for all ranges of the box.
// 4. The box of least bound is split in the middle of its longer side, until no bound is
//    below the best candidate.

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

/// Relative decrease of the objective that a step of a descent must reach.
constexpr double least_gain = 1e-7;

/// rad; azimuths about one axis are computed in one way, so that only their differences
/// and whole turns are rounded, by 1e-15.
constexpr double range_rounding = 1e-12;

/// The unit vector perpendicular to an axis, at an azimuth about it.
Vec3 at_azimuth(const Vec3& axis, double azimuth)
{
    const Vec3 zero = azimuth_zero(axis);
    return std::cos(azimuth) * zero + std::sin(azimuth) * axis.cross(zero);
}

/// A range of this width that 0 divides in the ratio in which it divides `limits`.
RotaryRange divided_as(double width, const RotaryRange& limits)
{
    const double whole = limits.to - limits.from;
    const double below = whole > 0 ? width * (-limits.from / whole) : 0;
    return {-below, width - below};
}

/// Tests whether the part must be turned by 180 degrees: only the negated range fits the
/// limits, or the limits do not decide and the larger end is negative.
bool is_turned(const RotaryRange& range, const RotaryRange& limits)
{
    const RotaryRange other{-range.to, -range.from};
    if (is_within(range, limits) != is_within(other, limits))
        return is_within(other, limits);
    return -range.from > range.to;
}

/// Cells of a view that has no radius in a window with levels up to those of `ranges`.
/// Cells that exceed it by `range_rounding` or less belong to it.
std::vector<std::uint32_t> cells_within(const AxisView& view, const AzimuthWindow& window,
                                        const PoseRanges& ranges)
{
    const std::array<double, 2> levels{ranges.m0, ranges.m1};
    std::vector<std::uint32_t> within;
    for (const SeenCell& cell : view.free)
        if (cell.level <= levels[cell.side])
            within.push_back(cell.cell);
    for (const SeenCell& cell : view.swept) {
        if (cell.level > levels[cell.side])
            continue;
        double from_begin = cell.begin - window.begin + range_rounding;
        from_begin -= 2 * pi * std::floor(from_begin / (2 * pi));
        if (from_begin <= window.width + 2 * range_rounding)
            within.push_back(cell.cell);
    }
    return within;
}

}  // namespace

struct AxisFitter::Later {
    bool operator()(const RankBox& a, const RankBox& b) const
    {
        return a.bound > b.bound;
    }
};

AxisFitter::AxisFitter(const ConeFitting& fitting, GrowCones grow)
    : fitting_{fitting},
      grow_{std::move(grow)},
      sweep_{*fitting.cones},
      table_{*fitting.cones}
{
}

void AxisFitter::list_levels(const FitRequest& request)
{
    for (std::size_t side = 0; side < 2; ++side)
        levels_[side].assign(1, request.low[side]);
    for (const auto* cells : {&view_.swept, &view_.free})
        for (const SeenCell& cell : *cells)
            if (cell.level > request.low[cell.side])
                levels_[cell.side].push_back(cell.level);
    for (auto& levels : levels_) {
        std::sort(levels.begin(), levels.end());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    }
}

double AxisFitter::low(const RankBox& box, std::size_t side) const
{
    return levels_[side][box.first[side]];
}

double AxisFitter::high(const RankBox& box, std::size_t side) const
{
    return levels_[side][box.last[side]];
}

/// Tests whether the ranges of a box need no look: they exceed the limits, they are the
/// ranges of another box with both sectors exchanged, or a higher level has the same
/// objective.
bool AxisFitter::is_needless(const RankBox& box) const
{
    const bool is_ca = fitting_.measure.family == RotaryFamily::CA;
    if (!fitting_.limits.hold(low(box, 0), low(box, 1)) ||
        (is_ca && low(box, 1) > high(box, 0)))
        return true;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t next = box.last[side] + 1;
        if (next < levels_[side].size() &&
            rises_freely(fitting_.measure, fitting_.limits, levels_[side][next],
                         low(box, 1 - side)))
            return true;
    }
    return false;
}

/// Stores a range as the best one. In C,A its sectors are exchanged if that makes m0 >=
/// m1.
void AxisFitter::take(const AzimuthWindow& window, const PoseRanges& ranges,
                      double objective)
{
    below_ = objective;
    found_ = AxisFit{Vec3::Zero(), window, ranges, objective};
    if (fitting_.measure.family == RotaryFamily::CA && ranges.m0 < ranges.m1) {
        std::swap(found_->ranges.m0, found_->ranges.m1);
        found_->window.begin += pi;
    }
}

/// The least window up to these levels. If it is better than the best range but misses
/// cones, some are added and the window is searched again.
std::optional<AzimuthWindow> AxisFitter::least_window(const PoseRanges& most, double cap)
{
    const LevelLimits upto{{most.m0, most.m1}};
    const auto places = table_.places(upto, cap);
    auto window = sweep_.least(view_, places, upto, cap);
    bool has_grown = false;
    while (window && grow_ &&
           fitting_.measure({window->width, most.m0, most.m1}) < below_ &&
           fitting_.limits.hold(most.m0, most.m1) &&
           grow_(cells_within(view_, *window, most))) {
        has_grown = true;
        window = sweep_.least(view_, places, upto, cap);
    }
    if (has_grown)
        table_.fill(view_, {levels_[0].back(), levels_[1].back()});
    return window;
}

/// Bounds a box. Takes the range of its upper levels if it is better than the best one,
/// and puts the box on the heap if its bound is.
void AxisFitter::look_at(RankBox box)
{
    const double low0 = low(box, 0);
    const double low1 = low(box, 1);
    if (is_needless(box))
        return;
    const PoseRanges most{0, high(box, 0), high(box, 1)};
    const double cap =
        std::min(fitting_.measure.useful_width(below_ * (1 - slack_), low0, low1),
                 fitting_.limits.widest());
    if (cap <= 0)
        return;
    const auto window = least_window(most, cap);
    if (!window)
        return;
    const PoseRanges ranges{window->width, most.m0, most.m1};
    const double objective = fitting_.measure(ranges);
    if (objective < below_ && fitting_.limits.hold(most.m0, most.m1))
        take(*window, ranges, objective);
    box.bound = fitting_.measure({window->width, low0, low1});
    if (box.bound < below_ * (1 - slack_) && box.first != box.last) {
        heap_.push_back(box);
        std::push_heap(heap_.begin(), heap_.end(), Later{});
    }
}

void AxisFitter::split(const RankBox& box)
{
    const std::size_t side =
        high(box, 0) - low(box, 0) >= high(box, 1) - low(box, 1) ? 0 : 1;
    const std::size_t middle = (box.first[side] + box.last[side]) / 2;
    RankBox lower = box;
    RankBox upper = box;
    lower.last[side] = middle;
    upper.first[side] = middle + 1;
    look_at(lower);
    look_at(upper);
}

std::optional<AxisFit> AxisFitter::best(const Vec3& axis, const FitRequest& request)
{
    AxisPlace place{fitting_.measure.family, axis, 0, request.high};
    for (double& reach : place.reach)
        reach = std::min(reach, fitting_.limits.farthest());
    view_ = axis_view(place, fitting_.centres);
    list_levels(request);
    table_.fill(view_, {levels_[0].back(), levels_[1].back()});
    found_.reset();
    heap_.clear();
    below_ = request.below;
    slack_ = request.slack;
    look_at({{0, 0}, {levels_[0].size() - 1, levels_[1].size() - 1}});
    while (!heap_.empty()) {
        std::pop_heap(heap_.begin(), heap_.end(), Later{});
        const RankBox box = heap_.back();
        heap_.pop_back();
        if (box.bound < below_ * (1 - slack_))
            split(box);
    }
    if (found_)
        found_->axis = axis;
    return found_;
}

ConeFitting arc_fitting(const ConeFitting& fitting, double reach)
{
    ConeFitting arcs = fitting;
    arcs.measure.family = RotaryFamily::AB;
    arcs.limits = RangeLimits{RotaryFamily::AB, {}};
    arcs.limits.far = arcs.limits.near = reach;
    return arcs;
}

Vec3 axis_on_arc(const AxisFit& arc, const ConeFitting& fitting)
{
    const double length = arc.ranges.width;
    const double middle = arc.window.begin + std::min(length / 2, fitting.limits.near);
    const bool is_ca = fitting.measure.family == RotaryFamily::CA;
    return at_azimuth(arc.axis, is_ca ? middle : middle + pi / 2);
}

AxisFit descend(AxisFitter& fitter, const AxisFit& fit, const Descent& descent)
{
    auto best = [&fitter](const Vec3& axis, const FitRequest& request) {
        return fitter.best(axis, request);
    };
    return descend(best, fit, descent);
}

AxisFit descend(const FitAbout& best, AxisFit fit, const Descent& descent)
{
    constexpr double steps_of_levels = 3;
    double phase =
        0;  // the directions are rotated, since a valley may lie between two of them
    double step = descent.from;
    while (step > descent.to) {
        const Vec3 from = fit.axis;
        const double reach = steps_of_levels * step;
        const std::array<double, 2> levels{fit.ranges.m0, fit.ranges.m1};
        FitRequest request{fit.objective * (1 - least_gain)};
        for (std::size_t side = 0; side < 2; ++side) {
            request.low[side] = std::max(levels[side] - reach, 0.0);
            request.high[side] = levels[side] + reach;
        }
        bool has_moved = false;
        for (int k = 0; k < descent.directions && !has_moved; ++k) {
            const Vec3 towards =
                at_azimuth(from, phase + 2 * pi * k / descent.directions);
            const auto next =
                best((from + std::tan(step) * towards).normalized(), request);
            has_moved = next.has_value();
            if (next)
                fit = *next;
        }
        phase += 1;
        if (!has_moved)
            step /= 2;
    }
    return fit;
}

FittedPose fitted_pose(const AxisFit& fit, RotaryFamily family,
                       const RotaryLimits& limits)
{
    const PoseRanges& ranges = fit.ranges;
    const double area = ranges.width * ranges.height();
    FittedPose fitted{.pose = {}, .phi = {}, .theta = {}, .area = area};
    if (family == RotaryFamily::CA) {
        fitted.phi = {-ranges.m1, ranges.m0};
        fitted.theta = divided_as(ranges.width, limits.theta);
        const bool turned = is_turned(fitted.phi, limits.phi);
        if (turned)
            fitted.phi = {-ranges.m0, ranges.m1};
        const double zero = fit.window.begin - fitted.theta.from + (turned ? pi : 0);
        const Vec3 home = at_azimuth(fit.axis, zero);  // r2 x C
        fitted.pose = {fit.axis, fit.axis, fit.axis.cross(home)};
        return fitted;
    }
    fitted.theta = {-ranges.m1, ranges.m0};
    const bool turned = is_turned(fitted.theta, limits.theta);
    if (turned)
        fitted.theta = {-ranges.m0, ranges.m1};
    fitted.phi = divided_as(ranges.width, limits.phi);
    // About -axis azimuths decrease, so that the window begins at its other end.
    const double offset = turned ? ranges.width + fitted.phi.from : -fitted.phi.from;
    const Vec3 tool_axis = at_azimuth(fit.axis, fit.window.begin + offset);
    const Vec3 r1_axis = turned ? Vec3{-fit.axis} : fit.axis;
    fitted.pose = {tool_axis, r1_axis, tool_axis.cross(r1_axis)};
    return fitted;
}

}  // namespace endmill
