// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "test_surfaces.h"

// The height of a cutter over a part that is a closed form z(x, y) over a rectangle. It
// is found by dense samples in polar coordinates about the axis and by golden-section
// search around the best of them. It uses no derivatives, patches or parameters.
namespace endmill::test {

/// A part in closed form.
struct PlanPart {
    Rectangle over;
    std::function<double(double, double)> height;  ///< z in mm at x, y
    /// Lines in x and y along which the part has a crease; samples would miss maxima on
    /// them.
    std::vector<std::array<Eigen::Vector2d, 2>> creases = {};
};

inline double value_at(const Polynomial& polynomial, double x, double y)
{
    const Eigen::Vector4d in_x{1, x, x * x, x * x * x};
    const Eigen::Vector4d in_y{1, y, y * y, y * y * y};
    return in_x.dot(polynomial * in_y);
}

/// The part of `graph`.
inline PlanPart plan_graph(const Polynomial& height, const Rectangle& over)
{
    return {over, [height](double x, double y) { return value_at(height, x, y); }, {}};
}

/// The largest value of `f` between two places, if `f` has a single maximum there.
template <class Function>
double golden_top(const Function& f, double low, double high)
{
    constexpr double accuracy = 1e-9;
    const double share = (std::sqrt(5.0) - 1) / 2;
    double top = std::max(f(low), f(high));
    double one = high - share * (high - low);
    double two = low + share * (high - low);
    double at_one = f(one);
    double at_two = f(two);
    while (high - low > accuracy) {
        top = std::max({top, at_one, at_two});
        if (at_one > at_two) {
            high = two;
            two = one;
            at_two = at_one;
            one = high - share * (high - low);
            at_one = f(one);
        } else {
            low = one;
            one = two;
            at_one = at_two;
            two = low + share * (high - low);
            at_two = f(two);
        }
    }
    return top;
}

/// A cutter that is lowered at a position.
class DenseDrop {
public:
    DenseDrop(const PlanPart& part, const Cutter& cutter, double x, double y)
        : part_{part},
          cutter_{cutter},
          x_{x},
          y_{y}
    {
    }

    /// z of its reference point, mm.
    double height() const
    {
        double top = borders_top();
        std::vector<double> samples(turns * rings, lowest);
        for (int i = 0; i < turns; ++i)
            for (int j = 0; j < rings; ++j)
                samples[i * rings + j] = sample(i * turn, j * ring());
        top = std::max(top, *std::ranges::max_element(samples));
        const double low = top - near_share * cutter_.radius();
        for (int i = 0; i < turns; ++i)
            for (int j = 0; j < rings; ++j)
                if (samples[i * rings + j] >= low && is_hill(samples, i, j))
                    top = std::max(top, hill_top(i, j));
        return top;
    }

private:
    static constexpr int turns = 144;
    static constexpr int rings = 61;
    static constexpr int border_samples = 400;
    static constexpr double turn = 2 * std::numbers::pi / turns;
    static constexpr double near_share = 0.02;  // share of R that samples miss at most
    static constexpr double lowest = -std::numeric_limits<double>::max();

    double ring() const { return cutter_.radius() / (rings - 1); }

    // The profile of the cutter, but finite just beyond its rim.
    double on_point(double x, double y) const
    {
        const double rho = std::min(std::hypot(x - x_, y - y_), cutter_.radius());
        return part_.height(x, y) + cutter_.corner_radius() - cutter_.profile(rho);
    }

    double sample(double angle, double rho) const
    {
        const double x = x_ + rho * std::cos(angle);
        const double y = y_ + rho * std::sin(angle);
        const auto& [in_x, in_y] = part_.over;
        return in_x.low <= x && x <= in_x.high && in_y.low <= y && y <= in_y.high
                   ? on_point(x, y)
                   : lowest;
    }

    static bool is_hill(const std::vector<double>& samples, int i, int j)
    {
        for (const int a : {turns - 1, 0, 1})
            for (int b = std::max(j - 1, 0); b <= std::min(j + 1, rings - 1); ++b)
                if (samples[(i + a) % turns * rings + b] > samples[i * rings + j])
                    return false;
        return true;
    }

    double hill_top(int i, int j) const
    {
        constexpr double around = 1.5;
        return golden_top(
            [&](double angle) {
                return ray_top(angle, {(j - around) * ring(), (j + around) * ring()});
            },
            (i - around) * turn, (i + around) * turn);
    }

    // The maximum along a ray from the axis, over the part.
    double ray_top(double angle, Interval rho) const
    {
        Interval over{0, cutter_.radius()};
        const Eigen::Vector2d way{std::cos(angle), std::sin(angle)};
        const std::array<Interval, 2> sides{part_.over.x, part_.over.y};
        const std::array<double, 2> axis{x_, y_};
        for (int k = 0; k < 2; ++k) {
            const double one = (sides[k].low - axis[k]) / way[k];
            const double two = (sides[k].high - axis[k]) / way[k];
            over.low = std::max(over.low, std::min(one, two));
            over.high = std::min(over.high, std::max(one, two));
        }
        if (!(over.low <= over.high))
            return lowest;
        return golden_top(
            [&](double at) { return on_point(x_ + at * way.x(), y_ + at * way.y()); },
            std::clamp(rho.low, over.low, over.high),
            std::clamp(rho.high, over.low, over.high));
    }

    double borders_top() const
    {
        const auto& [x, y] = part_.over;
        const std::array<Eigen::Vector2d, 5> corners{{{x.low, y.low},
                                                      {x.high, y.low},
                                                      {x.high, y.high},
                                                      {x.low, y.high},
                                                      {x.low, y.low}}};
        double top = lowest;
        for (int k = 0; k < 4; ++k)
            top = std::max(top, border_top(corners[k], corners[k + 1]));
        for (const auto& [from, to] : part_.creases)
            top = std::max(top, border_top(from, to));
        return top;
    }

    // The maximum along the part of a side or a crease that is below the cutter.
    double border_top(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
    {
        const double length = (to - from).norm();
        const Eigen::Vector2d way = (to - from) / length;
        const Eigen::Vector2d axis = Eigen::Vector2d{x_, y_} - from;
        const double beside2 = axis.squaredNorm() - std::pow(axis.dot(way), 2);
        const double half2 = cutter_.radius() * cutter_.radius() - beside2;
        if (half2 < 0)
            return lowest;
        const double low = std::max(0.0, axis.dot(way) - std::sqrt(half2));
        const double high = std::min(length, axis.dot(way) + std::sqrt(half2));
        if (low > high)
            return lowest;
        const auto at = [&](double along) {
            const Eigen::Vector2d place = from + along * way;
            return on_point(place.x(), place.y());
        };
        double top = lowest;
        const double step = (high - low) / border_samples;
        for (int k = 0; k <= border_samples; ++k)
            top = std::max(top, at(low + k * step));
        for (int k = 0; k < border_samples; ++k)
            if (at(low + (k + 0.5) * step) >= top - near_share * cutter_.radius())
                top = std::max(top,
                               golden_top(at, low + std::max(k - 1, 0) * step,
                                          low + std::min(k + 2, border_samples) * step));
        return top;
    }

    const PlanPart& part_;
    const Cutter& cutter_;
    double x_;
    double y_;
};

}  // namespace endmill::test
