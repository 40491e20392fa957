// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/drop_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/drop_cutter/detail/drop_entries.h"

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr double largest_length = 1e9;    // mm; squares and their products stay finite
constexpr double smallest_radius = 1e-6;  // mm
constexpr double largest_radius = 1e6;    // mm
// share by which half a move is enlarged, for rounding errors
constexpr float float_share = 1e-6F;
// Each term of a bound contains at most eight roundings of floats, each of half of 2^-23.
constexpr double float_rounding = 8 * 0x1p-24;
constexpr double piece_radii = 0.5;  // size of a triangle's piece in cutter radii

float rounded_up(double value)
{
    return -rounded_down(-value);
}

}  // namespace

DropTree::DropTree(const TriangleMesh& mesh, const Cutter& cutter)
    : mesh_{&mesh},
      cutter_{cutter},
      no_tops_{FloatLanes::Constant(std::numeric_limits<float>::infinity())}
{
    require(smallest_radius <= cutter.radius() && cutter.radius() <= largest_radius,
            "DropTree: the cutter's radius must be within 1e-6 … 1e6 mm");
    Eigen::AlignedBox3d box;
    for (const Vec3& point : mesh.points()) {
        require(point.lpNorm<Eigen::Infinity>() <= largest_length,
                "DropTree: coordinates must be within 1e9 mm");
        box.extend(point);
    }
    if (mesh.triangles().empty())
        return;
    origin_ = box.center();
    half_ = box.sizes().head<2>() / 2;
    reach_ = rounded_up(cutter.radius() +
                        float_rounding * (half_.sum() + 2 * cutter.radius()));
    build(DropEntries{mesh, origin_, piece_radii * cutter.radius()});
}

void DropTree::build(DropEntries entries)
{
    const double margin =
        box_margin_share * (origin_.cwiseAbs().sum() + half_.sum() + cutter_.radius());
    std::size_t span = 1;  // number of entries in a node
    std::size_t count = entries.count();
    do {
        count = (entries.count() + span - 1) / span;
        Level& level = levels_.emplace_back();
        const auto nothing =
            FloatLanes::Constant(-std::numeric_limits<float>::infinity());
        const auto zero = FloatLanes::Zero();
        level.nodes.assign((count + float_lanes - 1) / float_lanes,
                           {zero, zero, zero, zero, nothing, zero, zero, zero});
        if (!cutter_.is_ball())
            level.tops.assign(level.nodes.size(), nothing);
        for (std::size_t k = 0; k < count; ++k)
            set_node(level, k,
                     entries.whole(k * span, std::min((k + 1) * span, entries.count()),
                                   margin));
        span *= float_lanes;
    } while (count > float_lanes);
    order_ = std::move(entries).into_triangles();
}

void DropTree::set_node(Level& level, std::size_t number, const DropEntry& whole) const
{
    Nodes& nodes = level.nodes[number / float_lanes];
    const auto k = static_cast<Eigen::Index>(number % float_lanes);
    const double R = cutter_.radius();
    const double r = cutter_.corner_radius();
    const double c = cutter_.flat_radius();
    // Boxes are enlarged by the rounding error of a touching point.
    const double place_rounding = float_rounding * (half_.maxCoeff() + 2 * R);
    nodes.low_x[k] = rounded_down(whole.box.min().x() - place_rounding);
    nodes.low_y[k] = rounded_down(whole.box.min().y() - place_rounding);
    nodes.high_x[k] = rounded_up(whole.box.max().x() + place_rounding);
    nodes.high_y[k] = rounded_up(whole.box.max().y() + place_rounding);
    if (!level.tops.empty())
        level.tops[number / float_lanes][k] = rounded_up(whole.top);
    const double g = whole.slope.norm();
    const double n = std::sqrt(1 + g * g);
    const double height = whole.height + g * c + r * g * g / (n + 1) +
                          whole.slope.dot(Vec2{nodes.low_x[k], nodes.low_y[k]});
    nodes.height[k] =
        rounded_up(height + 2 * float_rounding * std::abs(height) +
                   float_rounding * n * (half_.sum() + whole.box.sizes().sum() + 4 * R));
    if (g == 0 && c > 0)
        return;  // the plane touches the whole flat bottom, and `fall` stays 0
    const double reach_per_slope = (g > 0 ? c / g : 0) + r / n;
    nodes.offset_x[k] = static_cast<float>(reach_per_slope * whole.slope.x());
    nodes.offset_y[k] = static_cast<float>(reach_per_slope * whole.slope.y());
    nodes.fall[k] = static_cast<float>(1 / (2 * reach_per_slope));
}

// Over the plane alone the rise is largest at an end of the move. The boxes are enlarged
// by half the move, so that they are compared with its middle only.
FloatLanes DropTree::rise_bounds(const Nodes& nodes, const FloatLanes& tops,
                                 const FloatMove& move) const
{
    const Eigen::Array2f middle = (move.from + move.to) / 2;
    const Eigen::Array2f half = (move.to - move.from).abs() * (0.5F + float_share);
    const auto outside = [](const FloatLanes& low, const FloatLanes& high,
                            const FloatLanes& place, float grown) -> FloatLanes {
        return ((low - place).max(place - high) - grown).max(0.0F);
    };
    const auto lift = [&](const Eigen::Array2f& place) -> FloatLanes {
        return 2 * (nodes.offset_x * (place.x() - nodes.low_x) +
                    nodes.offset_y * (place.y() - nodes.low_y));
    };
    const FloatLanes away_x =
        outside(nodes.low_x, nodes.high_x, nodes.offset_x + middle.x(), half.x());
    const FloatLanes away_y =
        outside(nodes.low_y, nodes.high_y, nodes.offset_y + middle.y(), half.y());
    const FloatLanes away2 = away_x * away_x + away_y * away_y;
    const FloatLanes over_plane =
        nodes.height + nodes.fall * (lift(move.from) - away2) - move.from_z;
    const FloatLanes over_plane_at_end =
        nodes.height + nodes.fall * (lift(move.to) - away2) - move.to_z;
    const FloatLanes over_top = tops - std::min(move.from_z, move.to_z);
    const FloatLanes gap_x =
        outside(nodes.low_x, nodes.high_x, FloatLanes::Constant(middle.x()), half.x());
    const FloatLanes gap_y =
        outside(nodes.low_y, nodes.high_y, FloatLanes::Constant(middle.y()), half.y());
    return (gap_x * gap_x + gap_y * gap_y <= reach_ * reach_)
        .select(over_plane.max(over_plane_at_end).min(over_top),
                -std::numeric_limits<float>::infinity());
}

// Subtracts from the stored height what the shape of the cutter contributed.
DropTree::Plane DropTree::plane(const Nodes& nodes, Eigen::Index k) const
{
    const Vec2 low{nodes.low_x[k], nodes.low_y[k]};
    const Vec2 high{nodes.high_x[k], nodes.high_y[k]};
    const Vec2 offset{nodes.offset_x[k], nodes.offset_y[k]};
    Plane plane;
    plane.is_empty = !std::isfinite(nodes.height[k]);
    plane.half_size = (high - low) / 2;
    plane.slope = 2 * double{nodes.fall[k]} * offset;
    const double g2 = plane.slope.squaredNorm();
    const double lift = std::sqrt(g2) * cutter_.flat_radius() +
                        cutter_.corner_radius() * g2 / (std::sqrt(1 + g2) + 1);
    plane.middle << low + plane.half_size,
        nodes.height[k] - lift + plane.slope.dot(plane.half_size);
    return plane;
}

}  // namespace endmill
