// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/border_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/planning/detail/patch_offset.h"

// Preparation:
// 1. The border consists of the sides of patches that do not meet another side.
// 2. Each side is halved until the border and the curve at the depth t below it, r - t N,
//    deviate from their chords by little. The deviations are bounded by second
//    derivatives.
// 3. A binary tree of boxes contains the pieces.
// Test of a move:
// 1. Boxes outside the swept region are skipped.
// 2. A piece is kept if its border chord or its lower chord lies outside the swept region
//    by more than its deviation. One plane bounds the distance of a chord only to the
//    square of the chord's length, so the chord is halved until that error is small.
// Source: paper/notes/border-depth.md, section 3.

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Greatest deviation of the lower curve from its chord, as a share of the depth. It is
// the accuracy of the test.
constexpr double deviation_share = 2e-3;
// Most halvings of the side of a patch. Where more would be needed, its normals are not
// bounded.
constexpr int most_halvings = 12;

// A stretch of the side of a patch, from `low` to `high` in shares of the side.
struct Stretch {
    double low;
    double high;
    int halvings;
};

// The sides of patches that belong to the border of the part.
std::vector<PatchSide> border_sides(std::span<const Surface> surfaces)
{
    std::vector<PatchSide> sides = patch_sides(surfaces);
    std::vector<bool> meets(sides.size());
    for (const auto& [one, other] : meeting_sides(sides, same_end_mm(surfaces)))
        meets[one] = meets[other] = true;
    std::vector<PatchSide> borders;
    for (std::size_t k = 0; k < sides.size(); ++k)
        if (!meets[k])
            borders.push_back(sides[k]);
    return borders;
}

// The parameters of a place inside the patch of `side`.
SurfacePoint inside_patch(const Surface& surface, const PatchSide& side)
{
    const auto middle = [&](Parameter parameter, int patch) {
        const auto range = surface.breaks(parameter).subspan(patch, 2);
        return (range[0] + range[1]) / 2;
    };
    const Parameter across = side.along == Parameter::U ? Parameter::V : Parameter::U;
    const double along = middle(side.along, side.patch);
    const double beside = middle(across, side.end == 0 ? 0 : surface.patches(across) - 1);
    return side.along == Parameter::U ? SurfacePoint{along, beside}
                                      : SurfacePoint{beside, along};
}

// Bound in mm on the deviation of the offset by `height` from its chord over a stretch of
// the side. Infinite if the stretch crosses from one rectangle of the bounds to another.
double deviation_on(const OffsetBounds& bounds, const PatchSide& side,
                    const Interval& shares, double height)
{
    const SurfacePoint low = side.at(shares.low);
    const SurfacePoint high = side.at(shares.high);
    const OffsetBends& bends = bounds.at((low.u + high.u) / 2, (low.v + high.v) / 2);
    const bool is_inside = bends.low.u <= low.u && high.u <= bends.high.u &&
                           bends.low.v <= low.v && high.v <= bends.high.v;
    return is_inside ? bends.deviation(high.u - low.u, high.v - low.v, height) : infinite;
}

// Lower bound in mm of the distance between a chord and the swept axis. It is the
// distance from the plane through the axis point nearest to the chord's middle.
double chord_bound(const Vec3& from, const Vec3& to, const SweptAxis& swept_axis)
{
    const Vec3 middle = (from + to) / 2;
    const Vec3 nearest = swept_axis.nearest(middle);
    const Vec3 away = (middle - nearest).stableNormalized();
    return std::min(away.dot(from - nearest), away.dot(to - nearest));
}

// Lower bound in mm of the distance between a box and the swept axis.
double box_bound(const Eigen::AlignedBox3d& box, const SweptAxis& swept_axis)
{
    const Vec3 middle = box.center();
    const Vec3 away = middle - swept_axis.nearest(middle);
    const double distance = away.norm();
    if (distance == 0)
        return 0;
    return distance - away.cwiseAbs().dot(box.sizes()) / (2 * distance);
}

}  // namespace

BorderDepth::BorderDepth(std::span<const Surface> surfaces, std::span<const double> sides,
                         const BallCutter& cutter, const Vec3& axis, double depth)
    : radius_{cutter.radius()},
      axis_{axis},
      depth_{depth}
{
    require(surfaces.size() == sides.size(), "BorderDepth: need a side for each surface");
    require(0 < depth && depth < radius_, "BorderDepth: need 0 < depth < cutter radius");
    const std::vector<PatchSide> borders = border_sides(surfaces);
    for (auto side = borders.begin(); side != borders.end();) {
        const std::size_t number = side->number;
        const MarchedSurface marched{surfaces[number], sides[number]};
        const OffsetBounds bounds{marched.surface};
        for (; side != borders.end() && side->number == number; ++side)
            add_pieces(marched, bounds, *side);
    }
    if (!pieces_.empty())
        add_nodes(0, pieces_.size());
}

// Halves the side until both curves are known well enough. A piece whose lower curve is
// not known has an infinite deviation; then only its border can prove it outside.
void BorderDepth::add_pieces(const MarchedSurface& marched, const OffsetBounds& bounds,
                             const PatchSide& side)
{
    const SurfacePoint inside = inside_patch(marched.surface, side);
    const PatchOffset under{marched, inside, -depth_};
    const auto point_under = [&](double share) {
        const SurfacePoint at = side.at(share);
        return under.at(at.u, at.v);
    };
    std::vector<Stretch> open{{0, 1, 0}};
    while (!open.empty()) {
        const auto [low, high, halvings] = open.back();
        open.pop_back();
        const double middle = (low + high) / 2;
        const double border_deviation = deviation_on(bounds, side, {low, high}, 0);
        const double deviation = deviation_on(bounds, side, {low, high}, depth_);
        if (!(deviation <= deviation_share * depth_) && halvings < most_halvings) {
            open.push_back({middle, high, halvings + 1});
            open.push_back({low, middle, halvings + 1});
            continue;
        }
        const Chord border{side.tangents(low).point, side.tangents(high).point,
                           border_deviation};
        const auto from = point_under(low);
        const auto to = point_under(high);
        pieces_.push_back({border, from && to ? Chord{*from, *to, deviation}
                                              : Chord{border.from, border.to, infinite}});
    }
}

// Adds the subtree of the pieces first to end - 1.
void BorderDepth::add_nodes(std::size_t first, std::size_t end)
{
    const std::size_t self = nodes_.size();
    nodes_.emplace_back();
    if (end - first == 1) {
        const Chord& border = pieces_[first].border;
        Eigen::AlignedBox3d box{border.from};
        box.extend(border.to);
        nodes_[self] = {{(box.min().array() - border.deviation).matrix(),
                         (box.max().array() + border.deviation).matrix()},
                        ~static_cast<std::int32_t>(first)};
        return;
    }
    const std::size_t middle = first + (end - first) / 2;
    add_nodes(first, middle);
    const std::size_t second = nodes_.size();
    add_nodes(middle, end);
    nodes_[self] = {nodes_[self + 1].box.merged(nodes_[second].box),
                    static_cast<std::int32_t>(second)};
}

bool BorderDepth::is_kept(const BallMove& move) const
{
    if (nodes_.empty())
        return true;
    const SweptAxis swept_axis{move.from, move.to, axis_};
    std::vector<std::int32_t> open{0};
    while (!open.empty()) {
        const std::int32_t number = open.back();
        open.pop_back();
        const Node& node = nodes_[static_cast<std::size_t>(number)];
        if (box_bound(node.box, swept_axis) >= radius_)
            continue;
        if (node.link >= 0) {
            open.push_back(node.link);
            open.push_back(number + 1);
        } else if (!is_kept(pieces_[static_cast<std::size_t>(~node.link)], swept_axis)) {
            return false;
        }
    }
    return true;
}

// Whether the move is proved to leave the border of the piece, or the curve below it,
// outside the swept region.
bool BorderDepth::is_kept(const Piece& piece, const SweptAxis& swept_axis) const
{
    const auto is_outside = [&](const Chord& chord) {
        return chord_bound(chord.from, chord.to, swept_axis) - chord.deviation >=
               radius_ * (1 - radius_rounding_share);
    };
    if (is_outside(piece.border) || is_outside(piece.under))
        return true;
    const auto square = [](const Chord& chord) {
        return (chord.to - chord.from).squaredNorm();
    };
    if (std::max(square(piece.border), square(piece.under)) <=
        8 * radius_ * deviation_share * depth_)
        return false;
    const auto part = [](const Chord& chord, int half) -> Chord {
        const Vec3 middle = (chord.from + chord.to) / 2;
        return half == 0 ? Chord{chord.from, middle, chord.deviation}
                         : Chord{middle, chord.to, chord.deviation};
    };
    return std::ranges::all_of(std::array{0, 1}, [&](int half) {
        return is_kept({part(piece.border, half), part(piece.under, half)}, swept_axis);
    });
}

}  // namespace endmill
