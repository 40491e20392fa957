// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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

    /// Index of the point nearest to `place`; of several equally near ones, any, but the
    /// same each time.
    std::size_t nearest(const Vec3& place) const;

private:
    struct Search;
    void build(std::size_t begin, std::size_t end, int depth);
    void search(Search& search, std::size_t begin, std::size_t end, int depth) const;

    std::span<const Vec3> points_;
    std::vector<unsigned> order_;  // a range's middle splits it along depth mod 3
};

}  // namespace endmill
