// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// Random numbers and random sets of directions that are the same on every machine.
class RandomSets {
public:
    explicit RandomSets(std::uint64_t seed) : bits_{seed} {}

    /// A number from `low` to `high`, evenly distributed.
    double number(double low, double high);

    /// A set of 3 to 32 directions within 85 degrees of +z: azimuths evenly distributed,
    /// polar angles 85 degrees times the root of an even distribution.
    std::vector<Vec3> directions();

private:
    std::mt19937_64 bits_;
};

}  // namespace endmill
