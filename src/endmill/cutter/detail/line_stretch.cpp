// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/line_stretch.h"

#include <algorithm>
#include <cmath>

namespace endmill {

Stretch shared(const Stretch& a, const Stretch& b)
{
    return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

Stretch spanned(const Stretch& a, const Stretch& b)
{
    if (a.is_empty())
        return b;
    if (b.is_empty())
        return a;
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

Stretch where_positive(double value, double rate)
{
    if (rate == 0)
        return value >= 0 ? Stretch{} : Stretch::none();
    Stretch stretch;
    (rate > 0 ? stretch.low : stretch.high) = -value / rate;
    return stretch;
}

Stretch within_circle(const Eigen::Vector2d& offset, const Eigen::Vector2d& rate,
                      double radius)
{
    const double a = rate.squaredNorm();
    if (a == 0)
        return offset.squaredNorm() <= radius * radius ? Stretch{} : Stretch::none();
    // The nearest point of the line first: nothing cancels for a line far away.
    const double nearest = -offset.dot(rate) / a;
    const double distance2 = (offset + nearest * rate).squaredNorm();
    const double rest = radius * radius - distance2;
    if (!(rest >= 0))
        return Stretch::none();
    const double half = std::sqrt(rest / a);
    return {nearest - half, nearest + half};
}

}  // namespace endmill
