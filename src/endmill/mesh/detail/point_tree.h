// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// Finds the nearest of many points in about log(n) steps, also if many of them are equal.
/// It keeps a balanced k-d tree in at most 16 bytes a point and refers to the points,
/// which must outlive it. `TriangleTree` cannot replace it: that tree finds points of
/// triangles, and is larger.
class PointTree {
public:
    /// Builds the tree. \throws DomainError unless there are between 1 and 2^31 - 1
    /// points.
    explicit PointTree(std::span<const Vec3> points);

    /// Index of the point nearest to `place` among the points nearer than `radius` (mm).
    /// Of several equally near points any may be returned, but always the same one.
    /// \return nothing if no point is nearer than `radius`.
    std::optional<std::size_t> nearest_within(const Vec3& place, double radius) const;

private:
    struct Search;
    struct Range {
        std::size_t begin;
        std::size_t end;
        int axis;          // axis along which the middle point splits the range
        std::size_t node;  // 0 for all points; the halves of k are 2 k + 1 and 2 k + 2

        Range lower_half() const;
        Range upper_half() const;
    };
    struct Box {
        Vec3 low;  // mm
        Vec3 high;
    };
    void build(const Range& range);
    void search(Search& search, const Range& range) const;

    std::span<const Vec3> points_;
    std::vector<unsigned> order_;
    std::vector<Box> boxes_;  // around the points of each large range, by node
};

}  // namespace endmill
