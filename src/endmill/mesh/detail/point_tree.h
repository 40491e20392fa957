// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// Answers which of many points lies nearest, in about log(n) steps. Keeps a balanced
/// k-d tree in 4 bytes a point, and refers to the points, which must outlive it.
class PointTree {
public:
    /// \throws DomainError unless there is a point, and fewer than 2^31 of them.
    explicit PointTree(std::span<const Vec3> points);

    /// Index of the point nearest to `place` among those nearer than `radius` (mm); of
    /// several equally near ones, any, but the same each time.
    /// \return nothing if no point is so near.
    std::optional<std::size_t> nearest_within(const Vec3& place, double radius) const;

private:
    struct Search;
    struct Range {
        std::size_t begin;
        std::size_t end;
        int axis;  // along which its middle splits it
    };
    void build(const Range& range);
    void search(Search& search, const Range& range, const Vec3& offset) const;

    std::span<const Vec3> points_;
    std::vector<unsigned> order_;
    Vec3 low_;  // corners of the box around all points
    Vec3 high_;
};

}  // namespace endmill
