// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/border_walls.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

// Mean number of walls that end in a strip. With the walls that cross it, there are few
// strips with more than one block of walls.
constexpr float ends_per_strip = 3;

// Error bounds in accuracies h of the projected coordinates. u, half the last place of 1 in
// floats, is at most 2 h. Across and along:
//
// 1. The coordinates of starts err by h, so that the sums of two err by 1.5 h; the products
//    and sums of floats add 4.5 u. Ends of walls are computed in doubles and err by 1.5 h
//    and, rounded to floats, u. So a start moves against a wall by at most 14 h.
// 2. The place of a segment beside a start, first + slope * (across - first), has one
//    difference of at most 3, one product and two sums: 10 u and, for the slope, 4 u times
//    the slope.
//
// The sum is at most 34 h, and 22 h times the slope of the segment. The depth is z - s *
// along, where s is the rise of the walls: its errors are at most 1 + 1.5 |s| times as
// large.
constexpr double accuracies = 40;

// A segment that no place across is beside: they are all within [-1.5, 1.5].
constexpr WallLanes no_walls = [] {
    WallLanes lanes{};
    lanes.first.fill(8);
    lanes.last.fill(-8);
    return lanes;
}();

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
    std::size_t count = 0;
    for (const BorderEdge& edge : border)
        count += std::abs(edge.uses);
    are_too_many_ = count > part.triangles().size() / facets_per_wall;
    if (are_too_many_ || count == 0)
        return;
    std::vector<std::int32_t> number(part.points().size(), -1);
    const auto numbered = [&](std::int32_t point) {
        if (number[point] < 0) {
            number[point] = static_cast<std::int32_t>(points_.size());
            points_.push_back(part.points()[point]);
        }
        return static_cast<std::uint32_t>(number[point]);
    };
    edges_.reserve(count);
    for (const auto& [low, high, uses] : border) {
        const std::uint32_t from = numbered(uses > 0 ? low : high);
        const std::uint32_t to = numbered(uses > 0 ? high : low);
        edges_.insert(edges_.end(), std::abs(uses), Edge{{from, to}});
    }
    const Vec3 up = area_vector(part);
    const double size = up.stableNorm();
    if (size > 0 && std::isfinite(size))
        up_ = up / size;
}

// A wall goes down from its projected edge, and its points rise by `slope` per length. So
// its depth, z - slope * along, is constant all the way down.
void BorderWalls::look_along(const Eigen::Matrix3d& rows, const Vec3& centre,
                             double accuracy)
{
    if (edges_.empty())
        return;
    const Eigen::Vector3d sense = (rows * -up_).normalized();
    const double sine = sense.head<2>().norm();
    is_along_ = !(sine >= least_sine);
    if (is_along_)
        return;
    const Eigen::Vector2d down = sense.head<2>() / sine;
    const double slope = sense.z() / sine;
    frame_ << down.y(), -down.x(), 0,  //
        down.x(), down.y(), 0,         //
        -slope * down.x(), -slope * down.y(), 1;
    doubt_ = static_cast<float>(accuracies * accuracy);
    doubt_of_depth_ =
        static_cast<float>(accuracies * accuracy * (1 + 1.5 * std::abs(slope)));
    project(rows, centre);
    choose_strips();
    const auto for_each_strip = [&](const auto& visit) {
        const WallStrips all = strips();
        for (const Wall& wall : walls_) {
            const std::uint32_t last = all.strip_at(wall.ends[1].x() + 2 * doubt_);
            for (std::uint32_t strip = all.strip_at(wall.ends[0].x() - 2 * doubt_);
                 strip <= last; ++strip)
                visit(wall, strip);
        }
    };
    for_each_strip([&](const Wall&, std::uint32_t strip) { ++count_[strip]; });
    std::uint32_t blocks = 0;
    for (std::size_t strip = 0; strip < count_.size(); ++strip) {
        begin_[strip] = blocks;
        blocks += (count_[strip] + float_lanes - 1) / float_lanes;
        count_[strip] = 0;
    }
    begin_.back() = blocks;
    blocks_.assign(blocks, no_walls);
    for_each_strip([&](const Wall& wall, std::uint32_t strip) {
        const std::uint32_t place = count_[strip]++;
        put(wall, blocks_[begin_[strip] + place / float_lanes], place % float_lanes);
    });
}

void BorderWalls::project(const Eigen::Matrix3d& rows, const Vec3& centre)
{
    const Eigen::Matrix3d map = frame_ * rows;
    ends_.clear();
    for (const Vec3& point : points_) {
        const Vec3 at = point - centre;
        const Vec3 end = map.col(0) * at.x() + map.col(1) * at.y() + map.col(2) * at.z();
        ends_.emplace_back(end.cast<float>());
    }
    walls_.clear();
    for (const auto& [ends] : edges_) {
        // A wall uses the edge in the opposite sense to the facet beside it.
        const bool is_left = ends_[ends[0]].x() > ends_[ends[1]].x();
        walls_.push_back(
            {{ends_[ends[is_left ? 1 : 0]], ends_[ends[is_left ? 0 : 1]]}, is_left});
    }
}

// The strips are wider than the error bound, and so few that there are at most a few
// entries for each wall.
void BorderWalls::choose_strips()
{
    low_ = walls_.front().ends[0].x();
    float high = low_;
    float widths = 0;
    for (const Wall& wall : walls_) {
        low_ = std::min(low_, wall.ends[0].x());
        high = std::max(high, wall.ends[1].x());
        widths += wall.ends[1].x() - wall.ends[0].x();
    }
    const auto count = static_cast<float>(walls_.size());
    const float extent = high - low_;
    constexpr float entries_per_wall = 4;
    const float most =
        std::max(1.0F, std::min(count / ends_per_strip, extent / (8 * doubt_)));
    const float strips =
        widths > 0 ? std::clamp(entries_per_wall * count * extent / widths, 1.0F, most)
                   : 1;
    strips_per_length_ = strips > 1 ? std::floor(strips) / extent : 0;
    count_.assign(static_cast<std::size_t>(strips), 0);
    begin_.assign(static_cast<std::size_t>(strips) + 1, 0);
}

// Within the doubt across, a segment changes by its slope times the doubt. A segment that
// is hardly wider counts as its middle, with a doubt of half its extent.
void BorderWalls::put(const Wall& wall, WallLanes& lanes, std::size_t lane) const
{
    const Eigen::Vector3f& first = wall.ends[0];
    const Eigen::Vector3f run = wall.ends[1] - first;
    lanes.first[lane] = first.x();
    lanes.last[lane] = wall.ends[1].x();
    const bool is_narrow = run.x() < 2 * doubt_;
    const float share = is_narrow ? 0.5F : 0;
    const float slope = is_narrow ? 0 : 1 / run.x();
    const float doubt = is_narrow ? 0.5F : doubt_ * slope;
    lanes.along[lane] = first.y() + share * run.y();
    lanes.along_slope[lane] = run.y() * slope;
    lanes.along_doubt[lane] = doubt_ + doubt * std::abs(run.y());
    lanes.depth[lane] = first.z() + share * run.z();
    lanes.depth_slope[lane] = run.z() * slope;
    lanes.depth_doubt[lane] = doubt_of_depth_ + doubt * std::abs(run.z());
    lanes.leaving |= unsigned{wall.is_left} << lane;
}

ExitLanes BorderWalls::exits(const PlaceLanes& places, unsigned asked) const
{
    if (are_too_many_ || is_along_)
        return {};
    if (edges_.empty())
        return {.none = asked};
    return ray_exits(strips(), places, frame_.cast<float>(), asked);
}

std::optional<int> BorderWalls::exits(const ProjectedBox& box) const
{
    if (are_too_many_ || is_along_)
        return std::nullopt;
    if (edges_.empty())
        return 0;
    return box_exits(strips(), box);
}

}  // namespace endmill
