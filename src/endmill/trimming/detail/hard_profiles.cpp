// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/profile_families.h"

#include <cmath>

namespace endmill {
namespace {

double sign(double x)
{
    return (x > 0) - (x < 0);
}

double sech2(double x)
{
    return 1 / (std::cosh(x) * std::cosh(x));
}

}  // namespace

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

}  // namespace endmill
