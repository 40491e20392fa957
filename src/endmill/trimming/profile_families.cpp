// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/profile_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Uniform numbers in 0 … 1, two draws each; the same with every standard library.
class Uniform {
public:
    explicit Uniform(std::uint32_t seed) : engine_{seed} {}

    double operator()()
    {
        const auto low = static_cast<double>(engine_());
        const auto high = static_cast<double>(engine_());
        constexpr double below_one = 1 - 0x1p-53;
        return std::min((low + 0x1p32 * high) * 0x1p-64, below_one);
    }

private:
    std::mt19937 engine_;
};

OffsetProfile wavy_profile(Uniform& uniform)
{
    const double a1 = 0.5 * uniform();
    const double a2 = 0.8 * uniform();
    const double a3 = 0.5 * uniform();
    const double w1 = 1 + 2 * uniform();
    const double w2 = 2 + 3 * uniform();
    const double q1 = 6 * uniform();
    const double q2 = 6 * uniform();
    const double m = 1.5 * (uniform() - 0.5);
    const double R = 0.3 + 1.5 * uniform();
    const auto height = [=](double x) {
        return 0.3 * a1 * x * x + a2 * std::cos(w1 * x + q1) +
               0.5 * a3 * std::cos(w2 * x + q2) + m * x;
    };
    const auto slope = [=](double x) {
        return 0.6 * a1 * x - a2 * w1 * std::sin(w1 * x + q1) -
               0.5 * a3 * w2 * std::sin(w2 * x + q2) + m;
    };
    return {"wavy", height, slope, -4, 4, R};
}

OffsetProfile convex_profile(Uniform& uniform)
{
    const double a = 0.1 + uniform();
    const double b = 0.05 * uniform();
    const double m = 3 * (uniform() - 0.5);
    const double c = 2 * (uniform() - 0.5);
    const double R = (0.5 + 2.5 * uniform()) / (2 * a);
    const auto height = [=](double x) {
        const double t = x - c;
        return a * t * t + b * t * t * t * t + m * x;
    };
    const auto slope = [=](double x) {
        const double t = x - c;
        return 2 * a * t + 4 * b * t * t * t + m;
    };
    return {"convex", height, slope, -4 - 2 * R, 4 + 2 * R, R};
}

}  // namespace

std::vector<OffsetProfile> wavy_profiles()
{
    constexpr std::uint32_t seed = 7;
    constexpr int count = 400;
    Uniform uniform{seed};
    std::vector<OffsetProfile> result;
    for (int k = 0; k < count; ++k)
        result.push_back(wavy_profile(uniform));
    return result;
}

std::vector<OffsetProfile> convex_profiles(int points)
{
    constexpr std::uint32_t seed = 11;
    constexpr int count = 500;
    constexpr std::array sizes{41, 101, 401, 1601};  // one stream of draws for all
    const auto size = std::find(sizes.begin(), sizes.end(), points);
    require(size != sizes.end(), "convex_profiles: 41, 101, 401 or 1601 points");
    Uniform uniform{seed};
    std::vector<OffsetProfile> result;
    for (auto skipped = sizes.begin(); skipped != size; ++skipped) {
        for (int k = 0; k < count; ++k)
            convex_profile(uniform);
    }
    for (int k = 0; k < count; ++k)
        result.push_back(convex_profile(uniform));
    return result;
}

}  // namespace endmill
