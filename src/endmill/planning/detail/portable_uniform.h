// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>

namespace endmill {

/// Uniform random numbers that do not depend on the standard library: its generators are
/// specified exactly, its distributions are not.
class PortableUniform {
public:
    explicit PortableUniform(std::uint32_t seed) : generator_{seed} {}  ///< MT19937

    /// A number in [low, high) from 53 random bits.
    double operator()(double low, double high)
    {
        const auto upper = static_cast<double>(generator_() >> 5U);
        const auto lower = static_cast<double>(generator_() >> 6U);
        return low + (high - low) * (upper * 0x1p26 + lower) * 0x1p-53;
    }

    /// A whole number from 0 to count - 1. \pre count >= 1
    int below(int count) { return static_cast<int>((*this)(0, count)); }

    /// A number of about normal distribution with mean 0 and standard deviation 1: a sum of 12 uniform ones.
    double normal()
    {
        double sum = -6;
        for (int i = 0; i < 12; ++i)
            sum += (*this)(0, 1);
        return sum;
    }

private:
    std::mt19937 generator_;
};

}  // namespace endmill
