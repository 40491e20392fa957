// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/path_memory.h"

#include <iomanip>
#include <limits>
#include <sstream>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr double bytes_per_gib = 0x1p30;
// Factor within which estimated_points is right.
constexpr double estimate_margin = 2;

}  // namespace

std::size_t most_path_points(double memory_gib)
{
    const double points = memory_gib * bytes_per_gib / bytes_per_path_point;
    constexpr auto most = std::numeric_limits<std::size_t>::max();
    return points < static_cast<double>(most) ? static_cast<std::size_t>(points) : most;
}

void require_path_memory(double points, double memory_gib)
{
    const auto most = static_cast<double>(most_path_points(memory_gib));
    if (points <= estimate_margin * most)
        return;
    std::ostringstream message;
    message << std::setprecision(2) << "about " << points
            << " CL points would need about "
            << points * bytes_per_path_point / bytes_per_gib << " GiB; expected at most "
            << to_text(memory_gib) << " GiB (--max-memory), enough for " << most
            << " points; larger tolerances need fewer points";
    throw LimitError{message.str()};
}

}  // namespace endmill
