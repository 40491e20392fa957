// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/figure-4/single_precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace endmill {
namespace {

using Floats = std::vector<float>;

// The logarithm in single precision.
float logarithm(double value)
{
    return static_cast<float>(std::log(static_cast<double>(static_cast<float>(value))));
}

Floats logarithms(const std::vector<double>& values)
{
    Floats all;
    all.reserve(values.size());
    for (const double value : values)
        all.push_back(logarithm(value));
    return all;
}

float sum(const Floats& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0F);
}

float sum_of_products(const Floats& one, const Floats& other)
{
    return std::inner_product(one.begin(), one.end(), other.begin(), 0.0F);
}

Floats less(Floats values, float amount)
{
    for (float& value : values)
        value -= amount;
    return values;
}

// The slope of the least-squares line in ten forms that are equal without rounding.
std::array<float, 10> slopes(const Floats& x, const Floats& y)
{
    const float n = static_cast<float>(x.size());
    const float sx = sum(x);
    const float sy = sum(y);
    const float sxx = sum_of_products(x, x);
    const float sxy = sum_of_products(x, y);
    const float mx = sx / n;
    const float my = sy / n;
    const Floats dx = less(x, mx);
    const float by_first = n / sx;
    const float by_second = sx / sxx;
    const float eliminated = (sy - by_second * sxy) / (n - by_second * sx);
    const float solved = (sy * sxx - sx * sxy) / (n * sxx - sx * sx);
    return {(sxy - sx * sy / n) / (sxx - sx * sx / n),
            (n * sxy - sx * sy) / (n * sxx - sx * sx),
            sum_of_products(dx, less(y, my)) / sum_of_products(dx, dx),
            sum_of_products(dx, y) / sum_of_products(dx, dx),
            (sxy - mx * sy) / (sxx - mx * sx),
            (sy - by_first * sxy) / (sx - by_first * sxx),
            (sxy - sx * eliminated) / sxx,
            (sy - n * solved) / sx,
            (sxy - sx * solved) / sxx,
            (sxy - n * mx * my) / (sxx - n * mx * mx)};
}

// The ways to obtain the abscissas ln(phi/pi).
std::vector<Floats> abscissas(const PrintedSpeeds& printed,
                              const std::vector<double>& widths, double printed_pi)
{
    std::vector<double> quotients;
    std::vector<double> by_angle;
    std::vector<double> by_width;
    for (std::size_t i = 0; i < printed.data.size(); ++i) {
        quotients.push_back(printed.data[i].phi_over_pi);
        by_angle.push_back(static_cast<float>(printed.phi_deg.at(i)) / 180.0F);
        const float cosine = 1.0F - 2.0F * static_cast<float>(widths.at(i));
        by_width.push_back(static_cast<float>(std::acos(static_cast<double>(cosine))) /
                           static_cast<float>(printed_pi));
    }
    Floats logs(printed.ln_phi_over_pi.begin(), printed.ln_phi_over_pi.end());
    return {logarithms(quotients), logs, logarithms(by_angle), logarithms(by_width)};
}

// The values in another order.
Floats ordered(const Floats& values, const std::vector<std::size_t>& order)
{
    Floats found;
    found.reserve(order.size());
    for (const std::size_t i : order)
        found.push_back(values[i]);
    return found;
}

// Adds the fits of the data in every order of summation.
void add_orders(SinglePrecisionFits& fits, const Floats& x, const Floats& y,
                double printed_alpha)
{
    constexpr double half_digit = 0.5e-7;
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    bool is_printed_order = true;
    do {
        for (const float slope : slopes(ordered(x, order), ordered(y, order))) {
            const double alpha = -static_cast<double>(slope);
            const bool is_print = std::abs(alpha - printed_alpha) <= half_digit;
            ++fits.tried;
            fits.as_printed += is_print ? 1 : 0;
            fits.in_order += is_print && is_printed_order ? 1 : 0;
            fits.least = std::min(fits.least, alpha);
            fits.greatest = std::max(fits.greatest, alpha);
        }
        is_printed_order = false;
    } while (std::ranges::next_permutation(order).found);
}

}  // namespace

SinglePrecisionFits single_precision_fits(const PrintedSpeeds& printed,
                                          const std::vector<double>& widths,
                                          double printed_pi, double printed_alpha)
{
    std::vector<double> speeds;
    speeds.reserve(printed.data.size());
    for (const CuttingSpeedDatum& datum : printed.data)
        speeds.push_back(datum.v_m_per_min);
    const std::vector<Floats> ordinates{logarithms(speeds),
                                        Floats(printed.ln_v.begin(), printed.ln_v.end())};
    SinglePrecisionFits fits;
    for (const Floats& x : abscissas(printed, widths, printed_pi))
        for (const Floats& y : ordinates)
            add_orders(fits, x, y, printed_alpha);
    return fits;
}

}  // namespace endmill
