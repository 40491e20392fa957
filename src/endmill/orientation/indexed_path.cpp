// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/indexed_path.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

// Sine of the turn below which two axes count as equal or opposite: the great arc between them
// would have no direction.
constexpr double least_sine = 1e-6;

// Any unit vector perpendicular to `axis`.
Vec3 perpendicular(const Vec3& axis)
{
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    return axis.cross(Vec3::Unit(least)).normalized();
}

// The axes on the great arc from one axis to another, without the first, in equal steps.
std::vector<Vec3> turning_axes(const Vec3& from, const Vec3& to)
{
    const Vec3 normal = from.cross(to);
    const double turn = std::atan2(normal.norm(), from.dot(to));
    const bool has_arc = normal.norm() > least_sine;
    if (!has_arc && from.dot(to) > 0)
        return {to};
    const Vec3 about = has_arc ? Vec3{normal.normalized()} : perpendicular(from);
    const double step = Angle::degrees(turning_step_deg).radians();
    const int steps = std::max(1, static_cast<int>(std::ceil(turn / step)));
    std::vector<Vec3> axes;
    axes.reserve(static_cast<std::size_t>(steps));
    for (int k = 1; k < steps; ++k)
        axes.emplace_back(
            (Eigen::AngleAxisd{turn * k / steps, about} * from).normalized());
    axes.push_back(to);
    return axes;
}

// Appends stretches and the moves between them.
class IndexedBuilder {
public:
    // The ball grows so that chords between its points stay outside the given one.
    explicit IndexedBuilder(const ClearBall& ball)
        : centre_{ball.centre},
          distance_{ball.radius /
                    std::cos(Angle::degrees(turning_step_deg).radians() / 2)}
    {
    }

    void add(const IndexedStretch& stretch)
    {
        require_below_safe_height(stretch);
        const int first_pass = stretch.path.points.front().pass;
        if (!path_.points.empty())
            lead_to(stretch);
        const int passes = next_pass_ - first_pass;
        for (PathPoint point : stretch.path.points) {
            point.pass += passes;
            if (point.pass == next_pass_)
                point.point += led_;
            path_.points.push_back(point);
        }
        int last = 0;
        for (const PathPoint& point : stretch.path.points)
            last = std::max(last, point.pass);
        next_pass_ = last + passes + 1;
        safe_height_ = stretch.safe_height;
        led_ = 0;
    }

    // The path, at whose end the tool is lifted to the safe height.
    ToolPath take()
    {
        if (path_.points.empty())
            return {};
        const PathPoint end = path_.points.back();
        const auto& [tip, axis] = end.location;
        if (tip.dot(axis) < safe_height_)
            path_.points.push_back({end.pass,
                                    end.point + 1,
                                    Move::Retract,
                                    0,
                                    {raised(tip, axis, safe_height_), axis}});
        return std::move(path_);
    }

private:
    static void require_below_safe_height(const IndexedStretch& stretch)
    {
        const Vec3& axis = stretch.path.points.front().location.axis;
        for (const PathPoint& point : stretch.path.points) {
            require((point.location.axis - axis).norm() <= unit_vector_rounding,
                    "indexed_path: need a constant axis in each stretch");
            const double height = point.location.tip.dot(axis);
            // points at the safe height are rounded
            if (height > stretch.safe_height +
                             safe_height_rounding * (1 + std::abs(stretch.safe_height)))
                throw GeometryError{"the safe height " + to_text(stretch.safe_height) +
                                    " mm lies below the path, which reaches " +
                                    to_text(height) + " mm"};
        }
    }

    void add_move(Move move, const Vec3& tip, const Vec3& axis)
    {
        path_.points.push_back({next_pass_, led_++, move, 0, {tip, axis}});
    }

    // The place over `tip` at a height along the axis.
    static Vec3 raised(const Vec3& tip, const Vec3& axis, double height)
    {
        return tip + (height - tip.dot(axis)) * axis;
    }

    // The height along an axis from which the tool is outside the ball.
    double outside(const Vec3& axis) const { return centre_.dot(axis) + distance_; }

    void lead_to(const IndexedStretch& stretch)
    {
        const CutterLocation last = path_.points.back().location;
        const CutterLocation next = stretch.path.points.front().location;
        const double clear = std::max(outside(last.axis), safe_height_);
        add_move(Move::Retract, raised(last.tip, last.axis, safe_height_), last.axis);
        if (clear > safe_height_)
            add_move(Move::Rapid, raised(last.tip, last.axis, clear), last.axis);
        add_move(Move::Rapid, raised(centre_, last.axis, clear), last.axis);
        if (clear > outside(last.axis))
            add_move(Move::Rapid, centre_ + distance_ * last.axis, last.axis);
        for (const Vec3& axis : turning_axes(last.axis, next.axis))
            add_move(Move::Rapid, centre_ + distance_ * axis, axis);
        const double over = std::max(outside(next.axis), stretch.safe_height);
        if (over > outside(next.axis))
            add_move(Move::Rapid, raised(centre_, next.axis, over), next.axis);
        add_move(Move::Rapid, raised(next.tip, next.axis, over), next.axis);
        if (over > stretch.safe_height)
            add_move(Move::Rapid, raised(next.tip, next.axis, stretch.safe_height),
                     next.axis);
    }

    // Relative rounding of the heights of lifted points.
    static constexpr double safe_height_rounding = 1e-9;

    Vec3 centre_;
    double distance_;
    ToolPath path_;
    int next_pass_ = 0;
    int led_ = 0;  // moves that lead to the next stretch
    double safe_height_ = 0;
};

}  // namespace

ToolPath indexed_path(std::span<const IndexedStretch> stretches, const ClearBall& ball)
{
    require(ball.centre.allFinite() && std::isfinite(ball.radius) && ball.radius > 0,
            "indexed_path: need a ball with a radius above 0");
    IndexedBuilder builder{ball};
    for (const IndexedStretch& stretch : stretches) {
        require(!stretch.path.points.empty(), "indexed_path: need points in a stretch");
        builder.add(stretch);
    }
    return builder.take();
}

}  // namespace endmill
