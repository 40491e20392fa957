// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace endmill {

/// A partition of the numbers from 0 to count - 1 into sets that can be joined
/// (union-find). A set is named by its least member, so that the result does not depend
/// on the order in which sets were joined. Uses 4 bytes a number.
class DisjointSets {
public:
    /// Every number alone in its set. \pre count <= 2^31 - 1.
    explicit DisjointSets(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), std::int32_t{0});
    }

    /// The least member of the set of `number`. Shortens the path to it on the way.
    std::int32_t least(std::int32_t number)
    {
        while (parent_[number] != number)
            number = parent_[number] = parent_[parent_[number]];
        return number;
    }

    /// Joins the sets of `a` and `b`. \return whether they were two sets.
    bool join(std::int32_t a, std::int32_t b)
    {
        const auto [low, high] = std::minmax({least(a), least(b)});
        parent_[high] = low;
        return low != high;
    }

private:
    std::vector<std::int32_t>
        parent_;  // at most the number itself; equal in a least member
};

}  // namespace endmill
