// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "endmill/core/detail/disjoint_sets.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr std::size_t most_numbers = std::numeric_limits<std::int32_t>::max();
// Smallest tolerance, as a share of the largest coordinate. With a smaller one the number
// of a cell would lose digits.
constexpr double least_tolerance = 1e-12;
// Side of a cell in tolerances. It is a little below 1 / sqrt(3), so that points of one
// cell are within the tolerance of each other, even with the rounding of the cell's
// number.
constexpr double cell_side = 0.577;

// Triangles by which hash slots are fetched in advance, and the points that they refer to.
constexpr std::size_t slots_ahead = 32;
constexpr std::size_t points_ahead = 16;

// Without -0, which is equal to 0.
Vec3 without_minus_zero(const Vec3& point)
{
    return point.array() + 0.0;
}

std::uint64_t hash(const Vec3& point)
{
    // Multiplication moves low bits up, and the shift brings high bits down. The factor
    // is 2^64 divided by the golden ratio: odd and without pattern.
    std::uint64_t mixed = 0;
    for (const double coordinate : point) {
        mixed = (mixed ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15U;
        mixed ^= mixed >> 32U;
    }
    return mixed;
}

// Compares bits, so that NaNs, which are refused later, do not all count as different
// points.
bool are_same(const Vec3& a, const Vec3& b)
{
    const auto bits = [](double coordinate) {
        return std::bit_cast<std::uint64_t>(coordinate);
    };
    return bits(a.x()) == bits(b.x()) && bits(a.y()) == bits(b.y()) &&
           bits(a.z()) == bits(b.z());
}

// Gives equal points equal numbers, from 0 in order of appearance. It is a hash table
// with open addressing and linear probing.
class PointNumbers {
public:
    // \param expected number of points for which memory is taken at once.
    explicit PointNumbers(std::size_t expected)
        : slots_(std::bit_ceil(expected + expected / 3 + 2))
    {
        points_.reserve(expected);
    }

    // The number of a point without -0. \param hashed its hash.
    std::int32_t number_of(const Vec3& point, std::uint64_t hashed)
    {
        const auto tag = static_cast<std::uint32_t>(hashed >> 32U);
        std::size_t slot = hashed & mask();
        for (; slots_[slot].number >= 0; slot = (slot + 1) & mask())
            if (slots_[slot].tag == tag && are_same(points_[slots_[slot].number], point))
                return slots_[slot].number;
        const auto number = static_cast<std::int32_t>(points_.size());
        slots_[slot] = {tag, number};
        points_.push_back(point);
        if (4 * points_.size() > 3 * slots_.size())
            double_slots();
        return number;
    }

    // Prefetches the slot of a hash, and then the point to which this slot refers.
    // Triangles in random order access slots and points outside all caches.
    void prefetch_slot(std::uint64_t hashed) const
    {
        __builtin_prefetch(&slots_[hashed & mask()]);
    }
    void prefetch_point(std::uint64_t hashed) const
    {
        const Slot& slot = slots_[hashed & mask()];
        if (slot.number < 0)
            return;
        __builtin_prefetch(&points_[slot.number].x());
        __builtin_prefetch(&points_[slot.number].z());  // may be on the next cache line
    }

    std::vector<Vec3> points() &&
    {
        points_.shrink_to_fit();
        return std::move(points_);
    }

private:
    struct Slot {
        // the half of the hash that distinguishes most other points
        std::uint32_t tag = 0;
        std::int32_t number = -1;
    };

    std::size_t mask() const { return slots_.size() - 1; }

    void double_slots()
    {
        slots_ = std::vector<Slot>(2 * slots_.size());
        for (std::size_t number = 0; number < points_.size(); ++number) {
            const std::uint64_t hashed = hash(points_[number]);
            std::size_t slot = hashed & mask();
            while (slots_[slot].number >= 0)
                slot = (slot + 1) & mask();
            slots_[slot] = {static_cast<std::uint32_t>(hashed >> 32U),
                            static_cast<std::int32_t>(number)};
        }
    }

    std::vector<Slot> slots_;
    std::vector<Vec3> points_;
};

// The triangles by the numbers of their corners. The hashes of some triangles in advance
// are kept in a ring.
std::vector<Triangle> numbered(std::span<const std::array<Vec3, 3>> soup,
                               PointNumbers& numbers)
{
    std::array<std::array<std::uint64_t, 3>, slots_ahead> hashes{};
    const auto hash_of = [&](std::size_t k, int corner) -> std::uint64_t& {
        return hashes[k % slots_ahead][corner];
    };
    const auto prefetch_slots = [&](std::size_t k) {
        for (int corner = 0; k < soup.size() && corner < 3; ++corner) {
            hash_of(k, corner) = hash(without_minus_zero(soup[k][corner]));
            numbers.prefetch_slot(hash_of(k, corner));
        }
    };
    for (std::size_t k = 0; k < slots_ahead; ++k)
        prefetch_slots(k);
    std::vector<Triangle> triangles(soup.size());
    for (std::size_t k = 0; k < soup.size(); ++k) {
        for (int corner = 0; corner < 3; ++corner) {
            numbers.prefetch_point(hash_of(k + points_ahead, corner));
            triangles[k][corner] = numbers.number_of(without_minus_zero(soup[k][corner]),
                                                     hash_of(k, corner));
        }
        prefetch_slots(k + slots_ahead);
    }
    return triangles;
}

using CellNumber = std::array<std::int64_t, 3>;

struct PointInCell {
    CellNumber cell;
    std::int32_t point;
};

// The points of one cell, in a list that is sorted by cell.
struct Cell {
    CellNumber number;
    std::span<const PointInCell> points;
};

std::vector<PointInCell> sorted_by_cell(std::span<const Vec3> points, double side)
{
    std::vector<PointInCell> sorted;
    sorted.reserve(points.size());
    for (const Vec3& point : points) {
        const auto along = [&](int axis) {
            return static_cast<std::int64_t>(std::floor(point[axis] / side));
        };
        sorted.push_back(
            {{along(0), along(1), along(2)}, static_cast<std::int32_t>(sorted.size())});
    }
    std::ranges::sort(sorted, [](const PointInCell& a, const PointInCell& b) {
        return std::pair{a.cell, a.point} < std::pair{b.cell, b.point};
    });
    return sorted;
}

std::vector<Cell> cells_of(std::span<const PointInCell> sorted)
{
    std::vector<Cell> cells;
    for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
        while (end < sorted.size() && sorted[end].cell == sorted[begin].cell)
            ++end;
        cells.push_back({sorted[begin].cell, sorted.subspan(begin, end - begin)});
    }
    return cells;
}

// Steps to the cells that the tolerance reaches, two in each direction; only one of each
// pair of opposite steps.
std::vector<CellNumber> steps_to_later_cells()
{
    std::vector<CellNumber> steps;
    for (std::int64_t x = 0; x <= 2; ++x)
        for (std::int64_t y = -2; y <= 2; ++y)
            for (std::int64_t z = -2; z <= 2; ++z)
                if (CellNumber{x, y, z} > CellNumber{0, 0, 0})
                    steps.push_back({x, y, z});
    return steps;
}

// Whether a point of `a` is within the tolerance of a point of `b`.
bool come_near(const Cell& a, const Cell& b, std::span<const Vec3> points,
               double tolerance)
{
    return std::ranges::any_of(a.points, [&](const PointInCell& p) {
        return std::ranges::any_of(b.points, [&](const PointInCell& q) {
            const Vec3 apart = points[p.point] - points[q.point];
            return std::hypot(apart.x(), apart.y(), apart.z()) <= tolerance;
        });
    });
}

// Joins the clusters of cells that are `step` apart. The cells are sorted, and so are the
// cells one step away, so that one pass with two iterators finds all pairs.
void join_cells_a_step_apart(DisjointSets& clusters, std::span<const Cell> cells,
                             const CellNumber& step, std::span<const Vec3> points,
                             double tolerance)
{
    auto other = cells.begin();
    for (const Cell& cell : cells) {
        const auto [x, y, z] = cell.number;
        const CellNumber wanted{x + step[0], y + step[1], z + step[2]};
        while (other != cells.end() && other->number < wanted)
            ++other;
        if (other == cells.end())
            return;
        const std::int32_t here = cell.points.front().point;
        const std::int32_t there = other->points.front().point;
        if (other->number == wanted && clusters.least(here) != clusters.least(there) &&
            come_near(cell, *other, points, tolerance))
            clusters.join(here, there);
    }
}

// The clusters of points within the tolerance:
// 1. All points of a cell are in one cluster, because a cell is smaller than the
//    tolerance.
// 2. Two cells within reach of the tolerance are joined if two of their points are within
//    it.
DisjointSets clusters_within(std::span<const Vec3> points, double tolerance)
{
    const auto sorted = sorted_by_cell(points, cell_side * tolerance);
    const std::vector<Cell> cells = cells_of(sorted);
    DisjointSets clusters{points.size()};
    for (const Cell& cell : cells)
        for (const PointInCell& member : cell.points)
            clusters.join(cell.points.front().point, member.point);
    for (const CellNumber& step : steps_to_later_cells())
        join_cells_a_step_apart(clusters, cells, step, points, tolerance);
    return clusters;
}

void rename(std::vector<Triangle>& triangles, std::span<const std::int32_t> names)
{
    for (Triangle& triangle : triangles)
        for (std::int32_t& corner : triangle)
            corner = names[corner];
}

// Whether `a` is lexicographically less than `b`.
bool comes_before(const Vec3& a, const Vec3& b)
{
    return std::ranges::lexicographical_compare(a, b);
}

WeldedMesh weld_within(const TriangleMesh& mesh, double tolerance)
{
    const std::span<const Vec3> points = mesh.points();
    DisjointSets clusters = clusters_within(points, tolerance);
    std::vector<std::int32_t> names(points.size());
    std::vector<Vec3> chosen;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto number = static_cast<std::int32_t>(k);
        const std::int32_t first = clusters.least(number);
        if (first == number) {
            names[k] = static_cast<std::int32_t>(chosen.size());
            chosen.push_back(points[k]);
        } else {
            names[k] = names[first];
            if (comes_before(points[k], chosen[names[k]]))
                chosen[names[k]] = points[k];
        }
    }
    double largest_move = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
        largest_move = std::max(largest_move, (points[k] - chosen[names[k]]).norm());

    std::vector<Triangle> triangles{mesh.triangles().begin(), mesh.triangles().end()};
    rename(triangles, names);
    const std::size_t welded = points.size() - chosen.size();
    return {{std::move(chosen), std::move(triangles)}, welded, largest_move};
}

// Welds the rest, after equal points have become one. `count` is the number of points
// before that, `exact` the mesh after it.
WeldedMesh weld_rest(TriangleMesh exact, std::size_t count, double tolerance)
{
    const std::size_t welded = count - exact.points().size();
    if (tolerance == 0)
        return {std::move(exact), welded, 0};
    double largest = 0;
    for (const Vec3& point : exact.points())
        largest = std::max(largest, point.lpNorm<Eigen::Infinity>());
    require(std::isfinite(tolerance) && tolerance >= least_tolerance * largest,
            "weld: the tolerance must be 0, or at least 1e-12 of the largest coordinate");
    WeldedMesh result = weld_within(exact, tolerance);
    result.welded_points += welded;
    return result;
}

}  // namespace

WeldedMesh weld(std::span<const std::array<Vec3, 3>> soup, double tolerance)
{
    require(soup.size() <= most_numbers / 3, "weld: at most 715 827 882 triangles");
    require(tolerance >= 0, "weld: the tolerance must not be negative");
    PointNumbers numbers{soup.size() / 2};  // a closed mesh has no more
    std::vector<Triangle> triangles = numbered(soup, numbers);
    return weld_rest({std::move(numbers).points(), std::move(triangles)}, 3 * soup.size(),
                     tolerance);
}

WeldedMesh weld(const TriangleMesh& mesh, double tolerance)
{
    require(tolerance >= 0, "weld: the tolerance must not be negative");
    PointNumbers numbers{mesh.points().size()};
    std::vector<std::int32_t> names;
    names.reserve(mesh.points().size());
    for (const Vec3& point : mesh.points())
        names.push_back(numbers.number_of(without_minus_zero(point),
                                          hash(without_minus_zero(point))));
    std::vector<Triangle> triangles{mesh.triangles().begin(), mesh.triangles().end()};
    rename(triangles, names);
    return weld_rest({std::move(numbers).points(), std::move(triangles)},
                     mesh.points().size(), tolerance);
}

}  // namespace endmill
