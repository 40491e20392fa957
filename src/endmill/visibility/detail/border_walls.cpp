// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/border_walls.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// Least sine of the angle between rays and walls. Below it, the projected walls are too
// short to tell which rays meet them.
constexpr double least_sine = 1e-3;

// More border edges than one for so many facets have no walls.
constexpr std::size_t facets_per_wall = 8;

// A ray or a box near more pieces or strips than these gets no answer.
constexpr std::uint32_t most_pieces = 64;
constexpr std::size_t most_strips = 64;

// Calls `visit(low, high, sense)` for the sides of all triangles: the ends, and 1 if the
// triangle goes from the lower to the higher number, -1 otherwise.
template <typename Visit>
void for_each_side(const TriangleMesh& part, const Visit& visit)
{
    for (const Triangle& triangle : part.triangles())
        for (int k = 0; k < 3; ++k) {
            const std::int32_t from = triangle[k];
            const std::int32_t to = triangle[(k + 1) % 3];
            visit(std::min(from, to), std::max(from, to), from < to ? 1 : -1);
        }
}

struct BorderEdge {
    std::int32_t low;
    std::int32_t high;
    int uses;  // from low to high, less those from high to low
};

// The sides are sorted by their lower end, then by their higher one.
std::vector<BorderEdge> border_edges(const TriangleMesh& part)
{
    struct Use {
        std::int32_t high;
        std::int32_t sense;
    };
    std::vector<std::uint32_t> begin(part.points().size() + 1);
    for_each_side(part, [&](std::int32_t low, std::int32_t, int) { ++begin[low]; });
    std::inclusive_scan(begin.begin(), begin.end(), begin.begin());
    std::vector<Use> uses(begin.back());
    for_each_side(part, [&](std::int32_t low, std::int32_t high, int sense) {
        uses[--begin[low]] = {high, sense};
    });
    std::vector<BorderEdge> edges;
    for (std::size_t low = 0; low + 1 < begin.size(); ++low) {
        const auto here =
            std::span{uses}.subspan(begin[low], begin[low + 1] - begin[low]);
        std::ranges::sort(here, {}, &Use::high);
        for (std::size_t k = 0; k < here.size();) {
            const std::int32_t high = here[k].high;
            int sum = 0;
            for (; k < here.size() && here[k].high == high; ++k)
                sum += here[k].sense;
            if (sum != 0 && high != static_cast<std::int32_t>(low))
                edges.push_back({static_cast<std::int32_t>(low), high, sum});
        }
    }
    return edges;
}

Vec3 area_vector(const TriangleMesh& part)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < part.triangles().size(); ++k) {
        const auto& [a, b, c] = part.corners(k);
        sum += (b - a).cross(c - a);
    }
    return sum;
}

}  // namespace

BorderWalls::BorderWalls(const TriangleMesh& part)
{
    const std::vector<BorderEdge> border = border_edges(part);
    are_too_many_ = border.size() > part.triangles().size() / facets_per_wall;
    if (are_too_many_)
        return;
    edges_.reserve(border.size());
    for (const auto& [low, high, uses] : border)
        edges_.push_back({{part.points()[low], part.points()[high]}, uses});
    const Vec3 up = edges_.empty() ? Vec3::UnitZ() : area_vector(part);
    const double size = up.stableNorm();
    if (size > 0 && std::isfinite(size))
        up_ = up / size;
}

// A wall goes from its projected edge along `down_`, and its points rise by `slope_` per
// length. So z - slope * along is constant down the wall.
Eigen::Vector3d BorderWalls::seen(const Eigen::Vector3d& projected) const
{
    const double across = projected.x() * down_.y() - projected.y() * down_.x();
    const double along = projected.x() * down_.x() + projected.y() * down_.y();
    return {across, along, projected.z() - slope_ * along};
}

void BorderWalls::look_along(const Eigen::Matrix3d& rows, const Vec3& centre,
                             double accuracy)
{
    if (edges_.empty())
        return;
    const Eigen::Vector3d down = (rows * -up_).normalized();
    const double sine = down.head<2>().norm();
    is_along_ = !(sine >= least_sine);
    if (is_along_)
        return;
    down_ = down.head<2>() / sine;
    slope_ = down.z() / sine;
    // `across` and `along` are sums of two coordinates of at most 1 times the sine or cosine
    // of an angle, so that they err by at most 1.5 accuracies; the depth errs by 1 + 1.5
    // |slope| of them. Rounded to a float, they err by two accuracies more of 1 + 1.5
    // |slope|. Walls and starts are rounded, so that the bound holds twice.
    constexpr double accuracies = 16;
    doubt_ = accuracies * accuracy;
    doubt_of_depth_ = accuracies * accuracy * (1 + std::abs(slope_));

    walls_.clear();
    for (const auto& [ends, uses] : edges_) {
        Wall& wall = walls_.emplace_back(Wall{
            {seen(rows * (ends[0] - centre)), seen(rows * (ends[1] - centre))}, uses});
        // A wall uses the edge in the opposite sense to the facet beside it.
        if (wall.ends[0].x() > wall.ends[1].x())
            std::swap(wall.ends[0], wall.ends[1]);
        else
            wall.exits = -wall.exits;
    }
    choose_strips();
    const auto for_each_strip = [&](const auto& visit) {
        for (std::uint32_t k = 0; k < walls_.size(); ++k) {
            const std::size_t last = strip_at(walls_[k].ends[1].x() + doubt_);
            for (std::size_t strip = strip_at(walls_[k].ends[0].x() - doubt_);
                 strip <= last; ++strip)
                visit(k, strip);
        }
    };
    for_each_strip([&](std::uint32_t, std::size_t strip) { ++begin_[strip]; });
    std::inclusive_scan(begin_.begin(), begin_.end(), begin_.begin());
    pieces_.resize(begin_.back());
    for_each_strip([&](std::uint32_t wall, std::size_t strip) {
        pieces_[--begin_[strip]] = piece(wall, strip);
    });
    for (std::size_t strip = 0; strip + 1 < begin_.size(); ++strip)
        std::ranges::sort(
            std::span{pieces_}.subspan(begin_[strip], begin_[strip + 1] - begin_[strip]),
            std::greater{}, [](const Piece& piece) { return piece.depth[1]; });
}

// About as many strips as walls, but wider than the error bound, and so few that the
// pieces are at most a few times as many as the walls.
void BorderWalls::choose_strips()
{
    low_ = walls_.front().ends[0].x();
    double high = walls_.front().ends[1].x();
    double widths = 0;
    for (const auto& [ends, exits] : walls_) {
        low_ = std::min(low_, ends[0].x());
        high = std::max(high, ends[1].x());
        widths += ends[1].x() - ends[0].x();
    }
    const auto count = static_cast<double>(walls_.size());
    const double extent = high - low_;
    constexpr double pieces_per_wall = 4;
    const double most = std::max(1.0, std::min(count, extent / (4 * doubt_)));
    const double strips =
        widths > 0 ? std::clamp(pieces_per_wall * count * extent / widths, 1.0, most) : 1;
    strips_per_length_ = strips > 1 ? strips / extent : 0;
    begin_.assign(static_cast<std::size_t>(strips) + 1, 0);
}

std::size_t BorderWalls::strip_at(double across) const
{
    const double last = static_cast<double>(begin_.size()) - 2;
    return static_cast<std::size_t>(
        std::clamp((across - low_) * strips_per_length_, 0.0, last));
}

// The part of a wall within a strip, widened by 2 `doubt_` on both sides. The first and the
// last strip have no outer side.
BorderWalls::Piece BorderWalls::piece(std::uint32_t wall, std::size_t strip) const
{
    const auto& [ends, exits] = walls_[wall];
    const double first = ends[0].x();
    const double width = ends[1].x() - first;
    const double left =
        low_ + static_cast<double>(strip) / strips_per_length_ - 2 * doubt_;
    const double right =
        low_ + static_cast<double>(strip + 1) / strips_per_length_ + 2 * doubt_;
    const bool is_inner = strip > 0 && strip + 2 < begin_.size();
    double from = 0;
    double to = 1;
    if (is_inner && width > 0) {
        from = std::clamp((left - first) / width, 0.0, 1.0);
        to = std::clamp((right - first) / width, 0.0, 1.0);
    }
    const Eigen::Vector3d a = ends[0] + from * (ends[1] - ends[0]);
    const Eigen::Vector3d b = ends[0] + to * (ends[1] - ends[0]);
    return {{static_cast<float>(std::min(a.y(), b.y()) - doubt_),
             static_cast<float>(std::max(a.y(), b.y()) + doubt_)},
            {static_cast<float>(std::min(a.z(), b.z()) - doubt_of_depth_),
             static_cast<float>(std::max(a.z(), b.z()) + doubt_of_depth_)},
            wall,
            exits,
            is_inner && first < left && right < ends[1].x()};
}

// The answer for one piece: 0 if no ray meets it, its exits if all do.
std::optional<int> BorderWalls::exits(const Piece& piece, const Starts& starts) const
{
    if (piece.depth[1] < starts.depth[0] || starts.along[1] < piece.along[0])
        return 0;
    if (piece.is_whole && starts.depth[1] < piece.depth[0] &&
        piece.along[1] < starts.along[0])
        return piece.exits;
    return std::nullopt;
}

// The answer for one wall and one ray.
std::optional<int> BorderWalls::exits_at(const Wall& wall,
                                         const Eigen::Vector3d& start) const
{
    const auto& [ends, exits] = wall;
    const double before = start.x() - ends[0].x();
    const double after = ends[1].x() - start.x();
    if (before < -doubt_ || after < -doubt_)
        return 0;
    const double width = ends[1].x() - ends[0].x();
    const bool is_between = before > doubt_ && after > doubt_;
    const double share = is_between ? before / width : 0.5;
    const double doubt_of_share = is_between ? 2 * doubt_ / width : 0.5;
    const Eigen::Vector3d run = ends[1] - ends[0];
    const double beyond = start.y() - ends[0].y() - share * run.y();
    const double under = ends[0].z() + share * run.z() - start.z();
    const double doubt_beyond = doubt_ + doubt_of_share * std::abs(run.y());
    const double doubt_under = doubt_of_depth_ + doubt_of_share * std::abs(run.z());
    if (beyond < -doubt_beyond || under < -doubt_under)
        return 0;
    if (is_between && beyond > doubt_beyond && under > doubt_under)
        return exits;
    return std::nullopt;
}

std::optional<int> BorderWalls::exits(const Eigen::Vector3f& place) const
{
    if (are_too_many_ || is_along_)
        return std::nullopt;
    if (edges_.empty())
        return 0;
    const Eigen::Vector3d at = seen(place.cast<double>());
    const auto along = static_cast<float>(at.y());
    const auto depth = static_cast<float>(at.z());
    const Starts starts{{along, along}, {depth, depth}};
    const std::size_t strip = strip_at(at.x());
    if (begin_[strip + 1] - begin_[strip] > most_pieces)
        return std::nullopt;
    int sum = 0;
    for (std::uint32_t k = begin_[strip];
         k < begin_[strip + 1] && pieces_[k].depth[1] >= depth; ++k) {
        std::optional<int> here = exits(pieces_[k], starts);
        if (!here)
            here = exits_at(walls_[pieces_[k].wall], at);
        if (!here)
            return std::nullopt;
        sum += *here;
    }
    return sum;
}

std::optional<int> BorderWalls::exits(const ProjectedBox& box) const
{
    if (are_too_many_ || is_along_)
        return std::nullopt;
    if (edges_.empty())
        return 0;
    const Eigen::Vector3d low = box.low.cast<double>();
    const Eigen::Vector3d high = box.high.cast<double>();
    const Eigen::Vector3d middle = seen((low + high) / 2);
    const Eigen::Vector3d half = (high - low) / 2;
    const double across = half.x() * std::abs(down_.y()) + half.y() * std::abs(down_.x());
    const double along = half.x() * std::abs(down_.x()) + half.y() * std::abs(down_.y());
    const double depth = half.z() + std::abs(slope_) * along;
    const Starts starts{
        {static_cast<float>(middle.y() - along), static_cast<float>(middle.y() + along)},
        {static_cast<float>(middle.z() - depth), static_cast<float>(middle.z() + depth)}};
    const std::size_t first = strip_at(middle.x() - across);
    const std::size_t last = strip_at(middle.x() + across);
    if (last - first > most_strips ||
        begin_[last + 1] - begin_[first] > most_strips * most_pieces)
        return std::nullopt;
    std::optional<int> all;
    for (std::size_t strip = first; strip <= last; ++strip) {
        int sum = 0;
        for (std::uint32_t k = begin_[strip];
             k < begin_[strip + 1] && pieces_[k].depth[1] >= starts.depth[0]; ++k) {
            const std::optional<int> here = exits(pieces_[k], starts);
            if (!here)
                return std::nullopt;
            sum += *here;
        }
        if (all && *all != sum)
            return std::nullopt;
        all = sum;
    }
    return all;
}

}  // namespace endmill
