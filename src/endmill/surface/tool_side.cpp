// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/tool_side.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/surface/detail/bernstein_net.h"
#include "endmill/surface/detail/collapsed_edge.h"

namespace endmill {
namespace {

using Rule = boost::math::quadrature::gauss<double, 30>;

// Share of the greatest normal up to which w^3 (du x dv) . axis counts as zero: the ball
// would touch at its equator. With weights, the least normal may itself be a small share
// of the greatest one.
constexpr double side_contact = 1e-12;
constexpr double rational_side_contact = 1e-14;
// Pieces narrower than this are judged by their corners.
constexpr double least_width = 0x1p-14;

// Order of magnitude of the greatest |w^3 (du x dv)| of a patch, from the homogeneous
// control points relative to the first one.
double greatest_normal(const BezierPatch& patch)
{
    const int p = patch.degree(Parameter::U);
    const int q = patch.degree(Parameter::V);
    const Vec3 corner = patch.control_point(0, 0);
    const auto point = [&](int i, int j) -> Vec3 {
        const Eigen::Vector4d h = patch.homogeneous_point(i, j);
        return h.head<3>() - h[3] * corner;
    };
    double du = 0;
    double dv = 0;
    double w = 0;
    for (int j = 0; j <= q; ++j)
        for (int i = 0; i <= p; ++i) {
            if (i < p)
                du = std::max(du, (point(i + 1, j) - point(i, j)).norm());
            if (j < q)
                dv = std::max(dv, (point(i, j + 1) - point(i, j)).norm());
            w = std::max(w, patch.homogeneous_point(i, j)[3]);
        }
    return p * q * du * dv * w;
}

// A corner of the piece, in the parameters of the patch, at which the polynomial is at
// most `least`; nothing if there is none.
std::optional<SurfacePoint> low_corner(const BernsteinPiece& piece, double least)
{
    for (int v = 0; v < 2; ++v)
        for (int u = 0; u < 2; ++u)
            if (!(piece.net(u * (piece.net.rows() - 1), v * (piece.net.cols() - 1)) >
                  least))
                return SurfacePoint{piece.low.u + u * piece.width_u,
                                    piece.low.v + v * piece.width_v};
    return std::nullopt;
}

// The coefficients of (du x dv) . axis, divided by the linear factors that vanish on
// collapsed edges. On such an edge the quotient has the sign of the normal's limit.
BernsteinNet reduced_normal_net(const BezierPatch& patch, const Vec3& axis)
{
    BernsteinNet net = normal_net(patch, axis);
    for (const Parameter parameter : {Parameter::U, Parameter::V})
        for (const int edge : {0, 1})
            if (is_collapsed(patch, parameter, edge))
                net = divided_by_edge(net, parameter, edge);
    return net;
}

// The integral of (du x dv) . axis. Without weights it is a Bernstein polynomial, whose
// mean is that of its coefficients. With weights it is a quotient and is integrated by
// quadrature.
double projected_area(const BezierPatch& patch, const Vec3& axis)
{
    if (!patch.is_rational())
        return normal_net(patch, axis).mean();
    const auto along_v = [&](double u) {
        return Rule::integrate(
            [&](double v) {
                const SurfaceTangents tangents = patch.tangents(u, v);
                return tangents.du.cross(tangents.dv).dot(axis);
            },
            0, 1);
    };
    return Rule::integrate(along_v, 0, 1);
}

// A place at which the polynomial is at most `least`. Pieces whose coefficients are all
// above it are discarded, the others are halved until a corner is found or they are too
// narrow.
std::optional<SurfacePoint> place_not_above(BernsteinPiece whole, double least)
{
    std::vector<BernsteinPiece> pieces{std::move(whole)};
    while (!pieces.empty()) {
        const BernsteinPiece piece = std::move(pieces.back());
        pieces.pop_back();
        if (const auto corner = low_corner(piece, least))
            return corner;
        if (piece.net.minCoeff() > least ||
            (piece.width_u < least_width && piece.width_v < least_width))
            continue;
        auto [low, high] = halves(piece);
        pieces.push_back(std::move(high));
        pieces.push_back(std::move(low));
    }
    return std::nullopt;
}

}  // namespace

double tool_side_sign(const Surface& surface, const Vec3& axis)
{
    if (surface.tool_side() != ToolSide::Up)
        return surface.tool_side() == ToolSide::DuCrossDv ? 1 : -1;
    double area = 0;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i)
            area += projected_area(surface.patch(i, j), axis);
    return area < 0 ? -1 : 1;
}

std::vector<double> tool_side_signs(std::span<const Surface> surfaces, const Vec3& axis)
{
    std::vector<double> signs;
    for (const Surface& surface : surfaces)
        signs.push_back(tool_side_sign(surface, axis));
    return signs;
}

std::optional<UnreachablePlace> find_unreachable_place(const Surface& surface,
                                                       const Vec3& axis, double side)
{
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i) {
            const BezierPatch& patch = surface.patch(i, j);
            const double share =
                patch.is_rational() ? rational_side_contact : side_contact;
            const double least = share * greatest_normal(patch);
            const auto found = place_not_above(
                {reduced_normal_net(patch, side * axis), {0, 0}, 1, 1}, least);
            if (!found)
                continue;
            const auto u = surface.breaks(Parameter::U).subspan(i, 2);
            const auto v = surface.breaks(Parameter::V).subspan(j, 2);
            const SurfaceTangents tangents = patch.tangents(found->u, found->v);
            UnreachablePlace place{
                {std::lerp(u[0], u[1], found->u), std::lerp(v[0], v[1], found->v)},
                tangents.point,
                std::nullopt};
            if (!is_singular(tangents))
                place.normal_dot_axis = side * unit_normal(tangents).dot(axis);
            return place;
        }
    return std::nullopt;
}

void require_reachable(const Surface& surface, const Vec3& axis, double side)
{
    const auto found = find_unreachable_place(surface, axis, side);
    if (!found)
        return;
    const std::string place = place_text(found->at, found->point);
    if (!found->normal_dot_axis)
        throw GeometryError{"the surface has no normal at " + place};
    throw GeometryError{"the cutter cannot touch the surface at " + place +
                        ", where normal . axis = " + to_text(*found->normal_dot_axis) +
                        "; expected above 0 everywhere"};
}

void require_reachable(std::span<const Surface> surfaces, const Vec3& axis,
                       std::span<const double> sides)
{
    if (surfaces.size() == 1)
        return require_reachable(surfaces.front(), axis, sides.front());
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        try {
            require_reachable(surfaces[number], axis, sides[number]);
        } catch (const GeometryError& error) {
            throw GeometryError{"patch " + std::to_string(number) + ": " + error.what()};
        }
}

}  // namespace endmill
