// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "endmill/process/cutting_coefficients.h"

// The coefficients by a second route: slices of the engaged region across the pick feed
// (docs/methods/ball-end-milling.md, section 3.1).
//
// In the slice at y a point of the ball is (rho cos chi, y, rho sin chi), rho^2 = 1 -
// y^2. The engaged part is one interval of chi with closed ends, and the integrals over
// it are closed, by Legendre's elliptic integrals. The integral over y is evaluated in
// long double by the double-exponential rule, between the places at which the formula of
// an end changes. These places are found by comparing many slices. The code shares
// nothing with the library.
namespace endmill::test {

using SlicedSums = std::array<long double, 8>;

class SlicedBall {
public:
    SlicedBall(const BallEngagement& engagement, ChipModel chip)
        : e_{engagement},
          chip_{chip},
          lambda_{engagement.lambda},
          a_{engagement.pick_feed_ratio * std::cos(static_cast<long double>(e_.mu))},
          b_{engagement.pick_feed_ratio * std::sin(static_cast<long double>(e_.mu))},
          top_{std::max(0.0L, 1 - static_cast<long double>(engagement.depth_ratio))}
    {
    }

    SlicedSums sums() const
    {
        SlicedSums total{};
        const std::vector<long double> ends = breaks();
        for (std::size_t k = 1; k < ends.size(); ++k)
            add_piece(ends[k - 1], ends[k], total);
        return total;
    }

private:
    static constexpr long double pi = std::numbers::pi_v<long double>;

    struct Slice {
        long double from;
        long double to;
        int form;  // number of the valid formulas; 0 if the slice is empty
    };

    Slice slice(long double y) const
    {
        const long double rho2 = (1 - y) * (1 + y);
        if (rho2 <= top_ * top_ || rho2 <= 0)
            return {0, 0, 0};
        const long double rho = std::sqrt(rho2);
        const long double t = std::asin(top_ / rho);
        Slice s{std::max(lambda_ - pi / 2, -pi + t), -t, 1};
        if (lambda_ - pi / 2 > -pi + t)
            s.form += 1;
        if (e_.previous == PreviousPass::Edge && y < 0)
            return {0, 0, 0};
        const long double across = y + a_;
        if (e_.previous == PreviousPass::Beside && std::abs(across) < 1) {
            const long double q = (-b_ - std::sqrt((1 - across) * (1 + across))) / rho;
            if (q <= -1)
                return {0, 0, 0};
            s.form += 10;
            if (q < 1 && lambda_ + std::asin(q) < s.to) {
                s.to = lambda_ + std::asin(q);
                s.form += 100;
            }
        }
        // A slice through the region behind the axis is split into two parts.
        s.form += s.from < -pi / 2 ? 1000 : 0;
        s.form += s.to < -pi / 2 ? 2000 : 0;
        return s.from < s.to ? s : Slice{0, 0, 0};
    }

    std::vector<long double> breaks() const
    {
        constexpr int looks = 6000;
        std::vector<long double> found{-1, 0};
        // The samples are dense where slices are thin.
        const auto look = [](int k) { return -std::cos(pi * (k + 0.3L) / looks); };
        for (int k = 1; k < looks; ++k) {
            long double low = look(k - 1);
            long double high = look(k);
            const int form = slice(high).form;
            if (slice(low).form == form)
                continue;
            for (int j = 0; j < 70; ++j) {
                const long double middle = (low + high) / 2;
                (slice(middle).form == form ? high : low) = middle;
            }
            found.push_back(high);
        }
        found.push_back(1);
        std::sort(found.begin(), found.end());
        return found;
    }

    void add_piece(long double low, long double high, SlicedSums& total) const
    {
        if (high - low < 1e-14L)
            return;
        constexpr long double step = 1.0L / 24;
        for (int k = -100; k <= 100; ++k) {
            const long double u = k * step;
            const long double v = pi / 2 * std::sinh(u);
            // Distance from the nearer end, accurate also where it is tiny.
            const long double near = (high - low) / (std::exp(2 * std::abs(v)) + 1);
            const long double y = v < 0 ? low + near : high - near;
            const long double weight = step * pi / 2 * std::cosh(u) * (high - low) / 2 /
                                       (std::cosh(v) * std::cosh(v));
            // Where y vanishes beside 1, the integrals are logarithms of y with
            // negligible weight.
            if (!(y > low && y < high) || std::abs(y) < 1e-17L)
                continue;
            add_slice(y, weight, total);
        }
    }

    void add_slice(long double y, long double weight, SlicedSums& total) const
    {
        const Slice s = slice(y);
        if (s.form == 0)
            return;
        if (chip_ == ChipModel::Paper && s.from < -pi / 2 && s.to > -pi / 2) {
            add_half(y, s.from, -pi / 2, weight, total);
            add_half(y, -pi / 2, s.to, weight, total);
        } else {
            add_half(y, s.from, s.to, weight, total);
        }
    }

    void add_half(long double y, long double from, long double to, long double weight,
                  SlicedSums& total) const
    {
        const SlicedSums high = antiderivatives(y, to);
        const SlicedSums low = antiderivatives(y, from);
        const long double side =
            chip_ == ChipModel::Paper && (from + to) / 2 < -pi / 2 ? -1 : 1;
        for (const std::size_t k : {0, 1, 4, 6})
            total[k] += weight * side * (high[k] - low[k]);
        for (const std::size_t k : {2, 3, 5, 7})
            total[k] += weight * (high[k] - low[k]);
    }

    SlicedSums antiderivatives(long double y, long double chi) const
    {
        const long double rho = std::sqrt((1 - y) * (1 + y));
        const long double s = std::sin(chi);
        const long double c = std::cos(chi);
        const long double root = std::sqrt(y * y + rho * rho * c * c);
        const long double logarithm = -std::log((1 - rho * s) / root);
        const long double square = chi - std::abs(y) * std::atan2(c, -std::abs(y) * s);
        const long double arc = std::atan2(rho * s, root);
        SlicedSums g{y * logarithm, square,  y * std::ellint_1(rho, chi), arc, arc,
                     chi,           rho * s, std::ellint_2(rho, chi)};
        if (chip_ == ChipModel::Paper)
            return g;
        const long double along = std::cos(lambda_);
        const long double down = std::sin(lambda_);
        const long double ay = std::abs(y);
        g[0] = y * (along * logarithm - down / ay * std::atan(rho * c / ay));
        g[1] = along * square - down * std::log(root);
        g[4] = along * arc - down * std::asinh(rho * c / ay);
        // The area seen along the feed: 2 pi I7 is the cross-section that a tooth
        // removes.
        g[6] = rho * std::sin(chi - lambda_);
        return g;
    }

    BallEngagement e_;
    ChipModel chip_;
    long double lambda_;
    long double a_;
    long double b_;
    long double top_;
};

/// The coefficients as an array.
inline std::array<double, 8> listed(const CuttingCoefficients& c)
{
    return {c.I1, c.I2, c.I3, c.I4, c.I5, c.I6, c.I7, c.I8};
}

/// Largest difference between two arrays.
inline double largest_difference(const std::array<double, 8>& a,
                                 const std::array<double, 8>& b)
{
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
}

/// I1 to I8 of the ball without the shank, accurate to 1e-12.
inline std::array<double, 8> sliced_coefficients(const BallEngagement& engagement,
                                                 ChipModel chip)
{
    const SlicedSums sums = SlicedBall{engagement, chip}.sums();
    std::array<double, 8> means;
    for (std::size_t k = 0; k < means.size(); ++k)
        means[k] = static_cast<double>(sums[k] / (2 * std::numbers::pi_v<long double>));
    return means;
}

}  // namespace endmill::test
