// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/drop_entries.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "endmill/drop_cutter/detail/hilbert_curve.h"

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;
using Corners = DropEntries::Corners;

// Steepest slope of a node's plane. Steeper planes bound no better, and rounding errors
// would grow.
constexpr double steepest = 16;
constexpr double least_slope = 1e-9;  // planes with smaller slopes count as level
// Long thin triangles fill their boxes badly and are divided.
constexpr double empty_share = 16;  // ratio of box to triangle in plan from which on
constexpr int most_cuts = 8;        // in succession
constexpr std::size_t spare_pieces = 100'000;
constexpr std::size_t fitted_entries = 64;  // sampled to fit a plane's slope
constexpr double last_cell = 65535;         // of the Hilbert curve
// mm, smallest extent that the curve is spread over
constexpr double least_extent = 1e-6;

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

// Whether the triangle fills so little of its box that it should be divided.
bool is_long_and_thin(const Corners& corners, double least_size)
{
    const auto& [a, b, c] = corners;
    const Vec2 size = box_in_plan(corners).sizes();
    if (size.minCoeff() < least_size / 2 || size.maxCoeff() < least_size)
        return false;
    const double area2 = std::abs(cross(in_plan(b - a), in_plan(c - a)));
    return 2 * size.prod() > empty_share * area2;
}

// The corner opposite to the longest side in plan.
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

// The slope of a triangle's plane. For a steep triangle, the slope along its longest
// side.
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
                                                      // also if the slope is not a number
                                                      : Vec2::Zero();
}

// The sums for a least-squares plane. Coordinates are taken relative to the first point,
// which avoids cancellation.
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

    // The slope of the plane, limited to `steepest`; level if the points lie on a line.
    Vec2 slope() const
    {
        const Vec3 mean = sum_ / count_;
        const Eigen::Matrix3d spread = products_ / count_ - mean * mean.transpose();
        const double xx = spread(0, 0);
        const double xy = spread(0, 1);
        const double yy = spread(1, 1);
        const double determinant = xx * yy - xy * xy;
        constexpr double on_a_line = 1e-6;  // share of the product of the spreads
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

Vec2 extent(const TriangleMesh& mesh)
{
    Eigen::AlignedBox2d box;
    for (const Vec3& point : mesh.points())
        box.extend(in_plan(point));
    return box.sizes();
}

}  // namespace

DropEntries::DropEntries(const TriangleMesh& mesh, const Vec3& origin, double piece_size)
    : mesh_{mesh},
      origin_{origin}
{
    const std::size_t count = mesh.triangles().size();
    most_pieces_ = count / 2 + spare_pieces;
    std::vector<std::uint64_t> keys;
    keys.reserve(count);
    const Vec2 size = extent(mesh);
    const double scale = last_cell / std::max(size.maxCoeff(), least_extent);
    const auto add = [&](const Corners& corners, std::size_t number) {
        const Vec2 place = (box_in_plan(corners).center() + size / 2) * scale;
        const auto cell = [](double at) {
            return static_cast<std::uint32_t>(std::clamp(at, 0.0, last_cell));
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

std::size_t DropEntries::triangle(std::size_t entry) const
{
    const std::size_t number = numbers_[entry];
    const std::size_t triangles = mesh_.triangles().size();
    return number < triangles ? number : pieces_[number - triangles].triangle;
}

std::vector<std::uint32_t> DropEntries::into_triangles() &&
{
    for (std::size_t k = 0; k < numbers_.size(); ++k)
        numbers_[k] = static_cast<std::uint32_t>(triangle(k));
    return std::move(numbers_);
}

DropEntries::Corners DropEntries::corners(std::size_t entry) const
{
    const std::size_t number = numbers_[entry];
    const std::size_t triangles = mesh_.triangles().size();
    return number < triangles ? local_corners(number)
                              : pieces_[number - triangles].corners;
}

DropEntry DropEntries::whole(std::size_t first, std::size_t last, double margin) const
{
    DropEntry whole;
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

DropEntries::Corners DropEntries::local_corners(std::size_t number) const
{
    const auto [a, b, c] = mesh_.corners(number);
    return {a - origin_, b - origin_, c - origin_};
}

void DropEntries::cut(const Corners& corners, std::size_t triangle, double least_size,
                      int cuts)
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

Vec2 DropEntries::slope(std::size_t first, std::size_t last) const
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

}  // namespace endmill
