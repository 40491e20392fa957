// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>

// Random numbers that are the same on every machine, and the relative error of a number.
namespace endmill::test {

/// Uniform random numbers that depend on the seed only.
class Random {
public:
    explicit Random(unsigned seed) : engine_{seed} {}

    double uniform(double low, double high)
    {
        return low + (high - low) * (engine_() / 4294967296.0);
    }

    /// 10 to a uniformly distributed power, between `low` and `high`.
    double log_uniform(double low, double high)
    {
        return std::exp(uniform(std::log(low), std::log(high)));
    }

    std::mt19937& engine() { return engine_; }

private:
    std::mt19937 engine_;
};

/// |value - expected| / |expected|.
inline double relative_error(double value, double expected)
{
    return std::abs(value - expected) / std::abs(expected);
}

}  // namespace endmill::test
