// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/drop_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/interference/hilbert_curve.h"

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;
using Corners = std::array<Vec3, 3>;

constexpr double largest_length = 1e9;    // mm: squares and their products stay finite
constexpr double smallest_radius = 1e-6;  // mm
constexpr double largest_radius = 1e6;    // mm
// Of a node's plane: steeper ones bound no better, and rounding would tell.
constexpr double steepest = 16;
constexpr double least_slope = 1e-9;  // a plane with less counts as level
// By which boxes are larger, of the size of the mesh: far above the rounding of doubles.
constexpr double box_margin = 1e-12;
constexpr float float_share = 1e-6F;  // by which half a move is longer: its roundings
// At most so many roundings of floats, of half of 2^-23 each, are in any term of a bound.
constexpr double float_rounding = 8 * 0x1p-24;
// Long thin triangles lie in boxes that they hardly fill, and are cut for that.
constexpr double empty_share = 16;   // box over triangle, in plan: from there on
constexpr double piece_radii = 0.5;  // size of a piece in cutter radii: down to there
constexpr int most_cuts = 8;         // one after the other
constexpr std::size_t spare_pieces = 100'000;
constexpr std::size_t fitted_entries = 64;  // for a node's slope, spread over it

float rounded_down(double value)
{
    const auto rounded = static_cast<float>(value);
    return rounded <= value
               ? rounded
               : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

float rounded_up(double value)
{
    return -rounded_down(-value);
}

Vec2 in_plan(const Vec3& point)
{
    return point.head<2>();
}

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

Eigen::AlignedBox2d box_in_plan(const Corners& corners)
{
    Eigen::AlignedBox2d box;
    for (const Vec3& corner : corners)
        box.extend(in_plan(corner));
    return box;
}

// Whether the triangle leaves so much of its box empty that it should be cut.
bool is_long_and_thin(const Corners& corners, double least_size)
{
    const auto& [a, b, c] = corners;
    const Vec2 size = box_in_plan(corners).sizes();
    if (size.minCoeff() < least_size / 2 || size.maxCoeff() < least_size)
        return false;
    const double area2 = std::abs(cross(in_plan(b - a), in_plan(c - a)));
    return 2 * size.prod() > empty_share * area2;
}

// The corner that faces the longest side in plan.
int corner_of_longest_side(const Corners& corners)
{
    double longest = -1;
    int facing = 0;
    for (int k = 0; k < 3; ++k) {
        const double length =
            in_plan(corners[(k + 2) % 3] - corners[(k + 1) % 3]).squaredNorm();
        if (length > longest) {
            longest = length;
            facing = k;
        }
    }
    return facing;
}

// Slope of a triangle's plane; of a steep one, that of its longest side along it.
Vec2 slope_of(const Corners& corners)
{
    const auto& [a, b, c] = corners;
    const Vec3 normal = (b - a).cross(c - a);
    const Vec2 level = in_plan(normal);
    if (level.norm() < steepest * std::abs(normal.z()))
        return -level / normal.z();
    const int facing = corner_of_longest_side(corners);
    const Vec3 side = corners[(facing + 2) % 3] - corners[(facing + 1) % 3];
    const double length2 = in_plan(side).squaredNorm();
    const Vec2 slope = side.z() / length2 * in_plan(side);
    return slope.squaredNorm() <= steepest * steepest ? slope
                                                      : Vec2::Zero();  // no NaN is
}

// Sums for the plane that fits points best, about the first of them.
class PlaneFit {
public:
    void add(const Vec3& point)
    {
        if (count_ == 0)
            about_ = point;
        const Vec3 p = point - about_;
        ++count_;
        sum_ += p;
        products_ += p * p.transpose();
    }

    // Level if the points do not tell, limited to the steepest.
    Vec2 slope() const
    {
        const Vec3 mean = sum_ / count_;
        const Eigen::Matrix3d spread = products_ / count_ - mean * mean.transpose();
        const double xx = spread(0, 0);
        const double xy = spread(0, 1);
        const double yy = spread(1, 1);
        const double determinant = xx * yy - xy * xy;
        constexpr double on_a_line = 1e-6;  // of the product of the spreads
        if (!(determinant > on_a_line * (xx + yy) * (xx + yy)))
            return Vec2::Zero();
        Vec2 slope{yy * spread(0, 2) - xy * spread(1, 2),
                   xx * spread(1, 2) - xy * spread(0, 2)};
        slope /= determinant;
        const double length = slope.norm();
        return length <= steepest ? slope : slope * (steepest / length);
    }

private:
    int count_ = 0;
    Vec3 about_ = Vec3::Zero();
    Vec3 sum_ = Vec3::Zero();
    Eigen::Matrix3d products_ = Eigen::Matrix3d::Zero();
};

}  // namespace

// What a node holds.
struct DropTree::Entry {
    Eigen::AlignedBox2d box;
    Vec2 slope;
    double height;  // of the plane at the origin
    double top;     // greatest z
};

// The triangles, or what long thin ones are cut into, in order. About the origin.
class DropTree::Entries {
public:
    Entries(const TriangleMesh& mesh, const Vec3& origin, double piece_size)
        : mesh_{mesh},
          origin_{origin}
    {
        const std::size_t count = mesh.triangles().size();
        most_pieces_ = count / 2 + spare_pieces;
        std::vector<std::uint64_t> keys;
        keys.reserve(count);
        const Vec2 size = extent(mesh);
        const double scale = 65535 / std::max(size.maxCoeff(), smallest_radius);
        const auto add = [&](const Corners& corners, std::size_t number) {
            const Vec2 place = (box_in_plan(corners).center() + size / 2) * scale;
            const auto cell = [](double at) {
                return static_cast<std::uint32_t>(std::clamp(at, 0.0, 65535.0));
            };
            keys.push_back(std::uint64_t{hilbert_number(cell(place.x()), cell(place.y()))}
                               << 32U |
                           number);
        };
        for (std::size_t k = 0; k < count; ++k) {
            const Corners corners = local_corners(k);
            if (!is_long_and_thin(corners, piece_size)) {
                add(corners, k);
                continue;
            }
            const std::size_t first = pieces_.size();
            cut(corners, k, piece_size, most_cuts);
            for (std::size_t piece = first; piece < pieces_.size(); ++piece)
                add(pieces_[piece].corners, count + piece);
        }
        std::ranges::sort(keys);
        numbers_.reserve(keys.size());
        for (const std::uint64_t key : keys)
            numbers_.push_back(static_cast<std::uint32_t>(key));
    }

    std::size_t count() const { return numbers_.size(); }

    std::size_t triangle(std::size_t entry) const
    {
        const std::size_t number = numbers_[entry];
        const std::size_t triangles = mesh_.triangles().size();
        return number < triangles ? number : pieces_[number - triangles].triangle;
    }

    Corners corners(std::size_t entry) const
    {
        const std::size_t number = numbers_[entry];
        const std::size_t triangles = mesh_.triangles().size();
        return number < triangles ? local_corners(number)
                                  : pieces_[number - triangles].corners;
    }

    // Numbers of triangles in order; the entries are of no use afterwards.
    std::vector<std::int32_t> order() const
    {
        std::vector<std::int32_t> order;
        order.reserve(count());
        for (std::size_t k = 0; k < count(); ++k)
            order.push_back(static_cast<std::int32_t>(triangle(k)));
        return order;
    }

    // Box and plane of entries first … last - 1.
    Entry whole(std::size_t first, std::size_t last, double margin) const
    {
        Entry whole;
        whole.slope = slope(first, last);
        whole.height = whole.top = -std::numeric_limits<double>::infinity();
        for (std::size_t k = first; k < last; ++k)
            for (const Vec3& corner : corners(k)) {
                whole.box.extend(in_plan(corner));
                whole.top = std::max(whole.top, corner.z());
                whole.height =
                    std::max(whole.height, corner.z() - whole.slope.dot(in_plan(corner)));
            }
        whole.box.min().array() -= margin;
        whole.box.max().array() += margin;
        whole.top += margin;
        whole.height += margin * (1 + 2 * whole.slope.norm());
        return whole;
    }

private:
    struct Piece {
        std::size_t triangle;
        Corners corners;
    };

    Corners local_corners(std::size_t number) const
    {
        const auto [a, b, c] = mesh_.corners(number);
        return {a - origin_, b - origin_, c - origin_};
    }

    static Vec2 extent(const TriangleMesh& mesh)
    {
        Eigen::AlignedBox2d box;
        for (const Vec3& point : mesh.points())
            box.extend(in_plan(point));
        return box.sizes();
    }

    void cut(const Corners& corners, std::size_t triangle, double least_size, int cuts)
    {
        if (cuts == 0 || pieces_.size() >= most_pieces_ ||
            !is_long_and_thin(corners, least_size)) {
            pieces_.push_back({triangle, corners});
            return;
        }
        const int facing = corner_of_longest_side(corners);
        const Vec3& from = corners[(facing + 1) % 3];
        const Vec3& to = corners[(facing + 2) % 3];
        const Vec3 middle = from + (to - from) / 2;
        cut({corners[facing], from, middle}, triangle, least_size, cuts - 1);
        cut({corners[facing], middle, to}, triangle, least_size, cuts - 1);
    }

    Vec2 slope(std::size_t first, std::size_t last) const
    {
        Vec2 slope;
        if (last - first == 1) {
            slope = slope_of(corners(first));
        } else {
            PlaneFit fit;
            const std::size_t step = (last - first + fitted_entries - 1) / fitted_entries;
            for (std::size_t k = first; k < last; k += step)
                for (const Vec3& corner : corners(k))
                    fit.add(corner);
            slope = fit.slope();
        }
        return slope.norm() > least_slope ? slope : Vec2::Zero();
    }

    const TriangleMesh& mesh_;
    const Vec3& origin_;
    std::size_t most_pieces_;
    std::vector<Piece> pieces_;
    std::vector<std::uint32_t> numbers_;  // of triangles, then of pieces
};

DropTree::DropTree(const TriangleMesh& mesh, const Cutter& cutter)
    : mesh_{&mesh},
      cutter_{cutter},
      no_tops_{Eigen::Array4f::Constant(std::numeric_limits<float>::infinity())}
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
    half_ = in_plan(box.sizes()) / 2;
    reach_ = rounded_up(cutter.radius() +
                        float_rounding * (half_.sum() + 2 * cutter.radius()));
    build({mesh, origin_, piece_radii * cutter.radius()});
}

void DropTree::build(const Entries& entries)
{
    order_ = entries.order();
    const double margin =
        box_margin * (origin_.cwiseAbs().sum() + half_.sum() + cutter_.radius());
    std::size_t span = 1;  // entries of a node
    std::size_t count = entries.count();
    do {
        count = (entries.count() + span - 1) / span;
        Level& level = levels_.emplace_back();
        const auto nothing =
            Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity());
        const auto zero = Eigen::Array4f::Zero();
        level.nodes.assign((count + 3) / 4,
                           {zero, zero, zero, zero, nothing, zero, zero, zero});
        if (!cutter_.is_ball())
            level.tops.assign(level.nodes.size(), nothing);
        for (std::size_t k = 0; k < count; ++k)
            set_node(level, k,
                     entries.whole(k * span, std::min((k + 1) * span, entries.count()),
                                   margin));
        span *= 4;
    } while (count > 4);
}

void DropTree::set_node(Level& level, std::size_t number, const Entry& whole) const
{
    Nodes& nodes = level.nodes[number / 4];
    const auto k = static_cast<Eigen::Index>(number % 4);
    const double R = cutter_.radius();
    const double r = cutter_.corner_radius();
    const double c = cutter_.flat_radius();
    // A touching point that is off by its rounding stays as far outside.
    const double rounding = float_rounding * (half_.maxCoeff() + 2 * R);
    nodes.low_x[k] = rounded_down(whole.box.min().x() - rounding);
    nodes.low_y[k] = rounded_down(whole.box.min().y() - rounding);
    nodes.high_x[k] = rounded_up(whole.box.max().x() + rounding);
    nodes.high_y[k] = rounded_up(whole.box.max().y() + rounding);
    if (!level.tops.empty())
        level.tops[number / 4][k] = rounded_up(whole.top);
    const double g = whole.slope.norm();
    const double n = std::sqrt(1 + g * g);
    const double height = whole.height + g * c + r * g * g / (n + 1) +
                          whole.slope.dot(Vec2{nodes.low_x[k], nodes.low_y[k]});
    nodes.height[k] =
        rounded_up(height + 2 * float_rounding * std::abs(height) +
                   float_rounding * n * (half_.sum() + whole.box.sizes().sum() + 4 * R));
    if (g == 0 && c > 0)
        return;  // the plane touches the whole flat bottom: no fall
    const double reach_per_slope = (g > 0 ? c / g : 0) + r / n;
    nodes.offset_x[k] = static_cast<float>(reach_per_slope * whole.slope.x());
    nodes.offset_y[k] = static_cast<float>(reach_per_slope * whole.slope.y());
    nodes.fall[k] = static_cast<float>(1 / (2 * reach_per_slope));
}

// Over the plane alone the rise is greatest at an end; the boxes grow by half the move, so
// that they need only be seen from its middle.
Eigen::Array4f DropTree::rise_bounds(const Nodes& nodes, const Eigen::Array4f& tops,
                                     const FloatMove& move) const
{
    const Eigen::Array2f middle = (move.from + move.to) / 2;
    const Eigen::Array2f half = (move.to - move.from).abs() * (0.5F + float_share);
    const auto outside = [](const Eigen::Array4f& low, const Eigen::Array4f& high,
                            const Eigen::Array4f& place, float grown) -> Eigen::Array4f {
        return ((low - place).max(place - high) - grown).max(0.0F);
    };
    const auto lift = [&](const Eigen::Array2f& place) -> Eigen::Array4f {
        return 2 * (nodes.offset_x * (place.x() - nodes.low_x) +
                    nodes.offset_y * (place.y() - nodes.low_y));
    };
    const Eigen::Array4f away_x =
        outside(nodes.low_x, nodes.high_x, nodes.offset_x + middle.x(), half.x());
    const Eigen::Array4f away_y =
        outside(nodes.low_y, nodes.high_y, nodes.offset_y + middle.y(), half.y());
    const Eigen::Array4f away2 = away_x * away_x + away_y * away_y;
    const Eigen::Array4f at_from =
        (nodes.height + nodes.fall * (lift(move.from) - away2)).min(tops) - move.from_z;
    const Eigen::Array4f at_to =
        (nodes.height + nodes.fall * (lift(move.to) - away2)).min(tops) - move.to_z;
    const Eigen::Array4f gap_x = outside(nodes.low_x, nodes.high_x,
                                         Eigen::Array4f::Constant(middle.x()), half.x());
    const Eigen::Array4f gap_y = outside(nodes.low_y, nodes.high_y,
                                         Eigen::Array4f::Constant(middle.y()), half.y());
    return (gap_x * gap_x + gap_y * gap_y <= reach_ * reach_)
        .select(at_from.max(at_to), -std::numeric_limits<float>::infinity());
}

// The height is given back what the cutter's shape has added to it.
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
