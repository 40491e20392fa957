// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/points_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/bound/detail/closed_bound.h"
#include "endmill/bound/detail/simple_shape.h"
#include "endmill/core/error.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/extent.h"

namespace endmill {
namespace {

using std::numbers::pi;

// A number of moves this close to a whole number is that number, so that rounding adds no
// move.
constexpr double count_rounding = 1e-9;
// Distance of a side from its chord, as a share of the diagonal of the surface. A polynomial
// of degree p that vanishes at p + 1 places vanishes everywhere.
constexpr double straight_share = 1e-9;
// Directions of moves that are tried at each place, over half a turn.
constexpr int directions = 36;
// Places in each patch along u and along v, in the middle of equal cells.
constexpr int places_of_patch = 12;

// Whether the flank of the tool covers no more than the ball. A lifted tool covers no more
// than the tool below it that touches the part.
bool is_without_flank(const BoundProblem& problem, const SimpleShape& shape)
{
    if (problem.tool == CoveringTool::Ball)
        return true;
    const double R = problem.cutter.radius();
    const double slope = shape.steepest.radians();
    if (shape.kind == ShapeKind::Plane)
        return R - problem.scallop_height >= (R + problem.stray) * std::sin(slope);
    const auto limit = steepest_without_flank(problem, shape.curvature);
    return limit && slope <= limit->radians();
}

double whole(double count)
{
    return std::ceil(count * (1 - count_rounding));
}

// Points of a path with at least so many moves. A stretch of moves has one point more than
// moves. A path of plunges alone has at least as many points as `plunges`.
double points_of(double moves, double plunges)
{
    return std::min(moves + 1, std::max(moves, plunges));
}

// The corners of a surface in order, if its sides are straight.
std::optional<std::array<Vec3, 4>> straight_corners(const Surface& surface)
{
    const Interval u = surface.range(Parameter::U);
    const Interval v = surface.range(Parameter::V);
    const std::array<std::array<double, 2>, 4> corners{
        {{u.low, v.low}, {u.high, v.low}, {u.high, v.high}, {u.low, v.high}}};
    const double tolerance = straight_share * surface.diagonal();
    std::array<Vec3, 4> points;
    for (std::size_t k = 0; k < corners.size(); ++k)
        points[k] = surface.tangents(corners[k][0], corners[k][1]).point;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto& from = corners[k];
        const auto& to = corners[(k + 1) % corners.size()];
        const Vec3 chord = points[(k + 1) % corners.size()] - points[k];
        const Vec3 along = chord.norm() > tolerance ? chord.normalized() : Vec3::Zero();
        const Parameter parameter = k % 2 == 0 ? Parameter::U : Parameter::V;
        const int steps =
            surface.patches(parameter) * surface.patch(0, 0).degree(parameter);
        for (int step = 1; step < steps; ++step) {
            const double share = step / static_cast<double>(steps);
            const Vec3 away = surface
                                  .tangents(std::lerp(from[0], to[0], share),
                                            std::lerp(from[1], to[1], share))
                                  .point -
                              points[k];
            if ((away - away.dot(along) * along).norm() > tolerance)
                return std::nullopt;
        }
    }
    return points;
}

// The least width of a convex polygon; nothing if it is not convex. It is the distance of a
// side from the farthest corner.
std::optional<double> convex_width(const std::array<Vec3, 4>& corners, const Vec3& normal)
{
    double width = std::numeric_limits<double>::infinity();
    double turn = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3 side = corners[(k + 1) % corners.size()] - corners[k];
        if (side.isZero(0))
            continue;
        const Vec3 across = normal.cross(side).normalized();
        double least = 0;
        double greatest = 0;
        for (const Vec3& corner : corners) {
            const double distance = (corner - corners[k]).dot(across);
            least = std::min(least, distance);
            greatest = std::max(greatest, distance);
        }
        const double rounding = straight_share * (greatest - least);
        if (std::min(-least, greatest) > rounding)
            return std::nullopt;
        const double own = greatest > -least ? 1 : -1;
        if (turn * own < 0)
            return std::nullopt;
        turn = own;
        width = std::min(width, greatest - least);
    }
    return width;
}

std::optional<PointsBound> plane_points(const Surface& surface,
                                        const BoundProblem& problem)
{
    const auto corners = straight_corners(surface);
    if (!corners)
        return std::nullopt;
    const Vec3 normal =
        ((*corners)[2] - (*corners)[0]).cross((*corners)[3] - (*corners)[1]).normalized();
    const auto width = convex_width(*corners, normal);
    if (!width)
        return std::nullopt;
    const double moves = whole(*width / (2 * plane_half_width(problem)));
    // two discs lie in one strip
    return PointsBound{moves, points_of(moves, 2 * moves - 1), BoundGrade::Closed};
}

// Half the angle over which a straight line of centres covers a sphere or, in one direction,
// a surface of this curvature, from the centre of curvature.
double half_angle_of_move(const BoundProblem& problem, double curvature)
{
    const double R = problem.cutter.radius();
    const double lift = problem.scallop_height;
    if (curvature > 0) {
        const double centres = 1 / curvature + R;
        return std::acos((centres - problem.stray) / (centres + lift));
    }
    const double centres = -1 / curvature - R;
    return std::acos(std::clamp((centres - lift) / (centres + problem.stray), 0.0, 1.0));
}

std::optional<PointsBound> sphere_points(const SimpleShape& shape,
                                         const BoundProblem& problem)
{
    if (!(shape.curvature > 0))
        return std::nullopt;
    const double rho = 1 / shape.curvature;
    const double R = problem.cutter.radius();
    const double sine = plane_half_width(problem) /
                        (2 * std::sqrt((rho + problem.scallop_height) * (rho + R)));
    if (sine > std::numbers::sqrt2 / 2)
        return std::nullopt;
    const double alpha = 2 * std::asin(sine);
    const double disc = 4 * pi * rho * rho * std::pow(std::sin(alpha / 2), 2);
    const double beta = half_angle_of_move(problem, shape.curvature);
    const double cover = 4 * rho * rho * beta * std::sin(alpha) + disc;
    const double moves = whole(shape.area / cover);
    return PointsBound{moves, points_of(moves, whole(shape.area / disc)),
                       BoundGrade::Closed};
}

// The greatest area in mm^2 that a move covers at a place.
// \param longest of a move along the surface, mm.
double greatest_cover(const PrincipalCurvatures& k, const BoundProblem& problem,
                      double longest)
{
    const double R = problem.cutter.radius();
    const double a = plane_half_width(problem);
    // half the width of what the ball covers in a direction of this curvature
    const auto half_width = [&](double curvature) {
        const double shrunk =
            (1 + curvature * problem.scallop_height) * (1 + curvature * R);
        return shrunk > 0 ? std::min(a / std::sqrt(shrunk), longest) : longest;
    };
    double greatest = 0;
    for (int step = 0; step < directions; ++step) {
        const double cosine = std::cos(pi * step / directions);
        const double along =
            k.greatest * cosine * cosine + k.least * (1 - cosine * cosine);
        const double across = k.greatest + k.least - along;
        double length = longest;
        if (1 + along * R > 0 && along != 0)
            length = std::min(length,
                              2 * half_angle_of_move(problem, along) / std::abs(along));
        const double half = half_width(across);
        greatest = std::max(greatest, 2 * half * length + pi * half * half_width(along));
    }
    return greatest;
}

// The integral of one over the greatest cover of a patch, by the midpoint rule.
double estimated_moves(const BezierPatch& patch, double side, const BoundProblem& problem,
                       double longest)
{
    double sum = 0;
    for (int j = 0; j < places_of_patch; ++j)
        for (int i = 0; i < places_of_patch; ++i) {
            const SurfaceJet jet =
                patch.jet((i + 0.5) / places_of_patch, (j + 0.5) / places_of_patch);
            const double area = jet.du.cross(jet.dv).norm();
            if (!(area > 0))
                continue;
            const PrincipalCurvatures k =
                principal_curvatures(fundamental_forms(jet, side));
            sum += area / greatest_cover(k, problem, longest);
        }
    return sum / (places_of_patch * places_of_patch);
}

void require_matching(std::span<const Surface> surfaces, std::span<const double> sides,
                      const BoundProblem& problem)
{
    require(!surfaces.empty(), "points_bound: need a surface");
    require(surfaces.size() == sides.size(),
            "points_bound: need a side for each surface");
    require_valid(problem);
}

}  // namespace

PointsBound points_bound(std::span<const Surface> surfaces, std::span<const double> sides,
                         const BoundProblem& problem)
{
    require_matching(surfaces, sides, problem);
    if (surfaces.size() > 1)
        return estimated_points_bound(surfaces, sides, problem);
    const auto shape = simple_shape(surfaces.front(), sides.front());
    std::optional<PointsBound> closed;
    if (shape && is_without_flank(problem, *shape))
        closed = shape->kind == ShapeKind::Plane ? plane_points(surfaces.front(), problem)
                 : shape->kind == ShapeKind::Sphere ? sphere_points(*shape, problem)
                                                    : std::nullopt;
    return closed ? *closed : estimated_points_bound(surfaces, sides, problem);
}

PointsBound estimated_points_bound(std::span<const Surface> surfaces,
                                   std::span<const double> sides,
                                   const BoundProblem& problem)
{
    require_matching(surfaces, sides, problem);
    Vec3 size;
    for (int c = 0; c < 3; ++c) {
        const Interval along = extent(surfaces, Vec3::Unit(c));
        size[c] = along.high - along.low;
    }
    double moves = 0;
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        for (int j = 0; j < surfaces[k].patches(Parameter::V); ++j)
            for (int i = 0; i < surfaces[k].patches(Parameter::U); ++i)
                moves += estimated_moves(surfaces[k].patch(i, j), sides[k], problem,
                                         size.norm());
    return {whole(moves), whole(moves) + 1, BoundGrade::Estimated};
}

}  // namespace endmill
