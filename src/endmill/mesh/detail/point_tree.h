// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// Finds the nearest of many points in about log(n) steps. It keeps a balanced k-d tree
/// in 4 bytes a point and refers to the points, which must outlive it. `TriangleTree`
/// cannot replace it: that tree has boxes of triangles, this one has none and is smaller.
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
        int axis;  // axis along which the middle point splits the range
    };
    void build(const Range& range);
    void search(Search& search, const Range& range, const Vec3& offset) const;

    std::span<const Vec3> points_;
    std::vector<unsigned> order_;
    Vec3 low_;  // corner of the bounding box of all points, mm
    Vec3 high_;
};

}  // namespace endmill
