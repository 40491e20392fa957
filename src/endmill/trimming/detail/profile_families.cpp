// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/profile_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Uniform random numbers in 0 … 1, from two draws of the engine each. They are the same
// with every standard library, unlike those of std::uniform_real_distribution.
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

double sign(double x)
{
    return (x > 0) - (x < 0);
}

double sech2(double x)
{
    return 1 / (std::cosh(x) * std::cosh(x));
}

}  // namespace

SectionCurve offset_curve(const OffsetProfile& profile, int points)
{
    require(points >= 2, "offset_curve: need two points");
    require(profile.from < profile.to, "offset_curve: need from < to");
    require(profile.radius > 0, "offset_curve: need 0 < radius");
    const double R = profile.radius;
    SectionCurve curve;
    curve.points.reserve(static_cast<std::size_t>(points));
    for (int i = 0; i < points; ++i) {
        const double x = profile.from + (profile.to - profile.from) * i / (points - 1);
        const double m = profile.slope(x);
        const double w = std::sqrt(1 + m * m);
        const SectionPoint point{x - R * m / w, profile.height(x) + R / w};
        if (curve.points.empty() || point != curve.points.back())
            curve.points.push_back(point);
    }
    return curve;
}

std::vector<OffsetProfile> hard_profiles()
{
    return {
        {"parabola", [](double x) { return x * x / 2; }, [](double x) { return x; }, -4,
         4, 2},
        {"tilted-parabola", [](double x) { return x * x / 2 + 1.2 * x; },
         [](double x) { return x + 1.2; }, -5, 3, 1.4},
        {"parabola-small-tool", [](double x) { return x * x / 2; },
         [](double x) { return x; }, -4, 4, 0.9},
        {"gentle-wave", [](double x) { return 0.3 * std::cos(x); },
         [](double x) { return -0.3 * std::sin(x); }, -7, 7, 1},
        {"hill-and-valley", [](double x) { return 0.5 * std::sin(x); },
         [](double x) { return 0.5 * std::cos(x); }, -4, 8, 1},
        {"cosine-three-valleys", [](double x) { return -std::cos(2 * x); },
         [](double x) { return 2 * std::sin(2 * x); }, -3.9, 3.9, 0.5},
        {"w-low-ridge", [](double x) { return x * x / 4 + 0.5 * std::cos(3 * x); },
         [](double x) { return x / 2 - 1.5 * std::sin(3 * x); }, -5, 5, 2},
        {"w-nested", [](double x) { return x * x / 4 + 0.8 * std::cos(3 * x); },
         [](double x) { return x / 2 - 2.4 * std::sin(3 * x); }, -6, 6, 3},
        {"quartic-w", [](double x) { return (x * x - 1) * (x * x - 1); },
         [](double x) { return 4 * x * (x * x - 1); }, -2, 2, 0.5},
        {"quartic-w-large-tool", [](double x) { return (x * x - 1) * (x * x - 1); },
         [](double x) { return 4 * x * (x * x - 1); }, -2.1, 2.1, 1.2},
        {"many-valleys",
         [](double x) {
             return 0.2 * x * x - 0.6 * std::cos(4 * x) + 0.3 * std::sin(1.7 * x);
         },
         [](double x) {
             return 0.4 * x + 2.4 * std::sin(4 * x) + 0.51 * std::cos(1.7 * x);
         },
         -6, 6, 1.5},
        {"v-groove", [](double x) { return std::abs(x); },
         [](double x) { return sign(x); }, -4, 4, 1},
        {"ridge-crease", [](double x) { return -std::abs(x); },
         [](double x) { return -sign(x); }, -4, 4, 1},
        {"sharp-grooves", [](double x) { return 1.5 * std::abs(std::sin(x)); },
         [](double x) { return 1.5 * sign(std::sin(x)) * std::cos(x); }, -4, 4, 0.8},
        {"starts-in-loop", [](double x) { return x * x / 2; }, [](double x) { return x; },
         -0.6, 4, 2},
        {"ends-in-loop", [](double x) { return x * x / 2; }, [](double x) { return x; },
         -4, 0.6, 2},
        {"short-branch", [](double x) { return x * x / 2; }, [](double x) { return x; },
         -1.3, 4, 2},
        {"steep-valley",
         [](double x) { return 2 * x + 9.0 / 11 * std::log(std::cosh(2.2 * x)); },
         [](double x) { return 2 + 1.8 * std::tanh(2.2 * x); }, -3, 3, 1},
        {"step-wall", [](double x) { return 2 * std::tanh(4 * x); },
         [](double x) { return 8 * sech2(4 * x); }, -4, 4, 0.8},
        {"pocket",
         [](double x) { return 1.5 * (std::tanh(6 * (x - 1)) - std::tanh(6 * (x + 1))); },
         [](double x) { return 9 * (sech2(6 * (x - 1)) - sech2(6 * (x + 1))); }, -4, 4,
         0.7},
        {"pocket-wide-tool",
         [](double x) { return 1.5 * (std::tanh(6 * (x - 1)) - std::tanh(6 * (x + 1))); },
         [](double x) { return 9 * (sech2(6 * (x - 1)) - sech2(6 * (x + 1))); }, -4, 4,
         1.5},
    };
}

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
    // all sizes share one stream of draws
    constexpr std::array sizes{41, 101, 401, 1601};
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
