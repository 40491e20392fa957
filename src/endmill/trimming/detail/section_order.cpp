// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/section_order.h"

namespace endmill {
namespace {

// No product of two lengths below it overflows.
constexpr double largest_coordinate = 0x1p+250;
// Added to a bound where underflow may take part of a product.
constexpr double underflow = std::numeric_limits<double>::min();

// A height with a bound of its error, mm.
struct BoundedHeight {
    double z;
    double error;
};

// The height of a line at s, where s lies between the line's points.
BoundedHeight height(const SectionLine& line, double s)
{
    const double share = (s - line.a[0]) / (line.b[0] - line.a[0]);
    const double whole_rise = line.b[1] - line.a[1];
    const double z = line.a[1] + share * whole_rise;
    return {z, 0x1p-50 * std::abs(whole_rise) + 0x1p-52 * std::abs(z)};
}

}  // namespace

SectionOrder::SectionOrder(const SectionPoints& section)
    : points_{section.points},
      slack_{section.largest_at_most < largest_coordinate
                 ? underflow
                 : std::numeric_limits<double>::infinity()}
{
}

int SectionOrder::height_order(std::int32_t p, std::int32_t q, double s) const
{
    const BoundedHeight at_p = height(line(p), s);
    const BoundedHeight at_q = height(line(q), s);
    const double difference = at_p.z - at_q.z;
    if (std::abs(difference) > bound_margin * (at_p.error + at_q.error) + slack_)
        return difference > 0 ? 1 : -1;
    return exact_height_order(line(p), line(q), s);
}

EnvelopeCrossing SectionOrder::crossing(std::int32_t p, std::int32_t q) const
{
    // Let f be the signed area above p. The crossing divides q as f(a) : -f(b).
    const SectionPoint& a = points_[p];
    const SectionPoint& b = points_[p + 1];
    const SectionPoint& c = points_[q];
    const SectionPoint& d = points_[q + 1];
    const double ds = b[0] - a[0];
    const double dz = b[1] - a[1];
    const double left_c = ds * (c[1] - a[1]);
    const double right_c = dz * (c[0] - a[0]);
    const double left_d = ds * (d[1] - a[1]);
    const double right_d = dz * (d[0] - a[0]);
    const double area_c = left_c - right_c;
    const double span = area_c - (left_d - right_d);
    const double doubt = 0x1p-51 * std::max(std::abs(left_c) + std::abs(right_c),
                                            std::abs(left_d) + std::abs(right_d)) +
                         slack_;
    const double share_doubt = doubt / std::abs(span);
    // beyond it the lines are nearly parallel, and the exact result is better
    constexpr double useful = 0x1p-20;
    if (!(share_doubt < useful)) {
        const SectionPoint point = exact_crossing(line(p), line(q));
        const double size = std::max(std::abs(point[0]), std::abs(point[1]));
        return {point[0], point[1], 0x1p-53 * size + underflow, p, q};
    }
    const double share = area_c / span;
    const double run = d[0] - c[0];
    const double rise = d[1] - c[1];
    const double reach = std::max(std::abs(run), std::abs(rise));
    const double size = std::max({std::abs(c[0]), std::abs(c[1]), reach});
    const double error =
        reach * (bound_margin * share_doubt + 0x1p-50) + 0x1p-51 * size + underflow;
    return {c[0] + share * run, c[1] + share * rise, error, p, q};
}

}  // namespace endmill
