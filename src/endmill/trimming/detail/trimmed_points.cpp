// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/trimmed_points.h"

#include "endmill/trimming/detail/rounded_crossing.h"

namespace endmill {

TrimmedPoint TrimmedPoints::crossing(std::int32_t p, std::int32_t q) const
{
    return {rounded_crossing(line(p), line(q)), plane_.number(p), plane_.number(q),
            TrimmedKind::Crossing};
}

TrimmedPoint TrimmedPoints::link(std::int32_t segment, std::int32_t vertex) const
{
    const double s = points()[vertex][0];
    return {{s, rounded_height(line(segment), s)},
            plane_.number(segment),
            plane_.number(vertex),
            TrimmedKind::Link};
}

}  // namespace endmill
