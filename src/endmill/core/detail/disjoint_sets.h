// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace endmill {

/// Sets of the numbers 0 … count - 1, each at first alone; known by their least member,
/// so that the order of joining leaves no trace. 4 bytes a number.
class DisjointSets {
public:
    /// \pre count <= 2^31 - 1.
    explicit DisjointSets(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), std::int32_t{0});
    }

    /// The least member of the set that `number` is in.
    std::int32_t least(std::int32_t number)
    {
        while (parent_[number] != number)
            number = parent_[number] = parent_[parent_[number]];
        return number;
    }

    /// Makes one set of those that `a` and `b` are in. \return whether they were two.
    bool join(std::int32_t a, std::int32_t b)
    {
        const auto [low, high] = std::minmax({least(a), least(b)});
        parent_[high] = low;
        return low != high;
    }

private:
    std::vector<std::int32_t> parent_;  // never above the number itself
};

}  // namespace endmill
