// SPDX-License-Identifier: GPL-3.0-or-later
// Trims a curve that crosses itself by every method of the library and by one of its own.

#include <iostream>

#include "endmill/trimming.h"

using namespace endmill;

// Keeps every point that lies ahead of all points before it. The path never steps back, but
// it may pass below the crossing of a loop.
Trimmed keep_points_ahead(std::span<const SectionCurve> curves, const TrimmingOptions&)
{
    Trimmed trimmed;
    for (std::int32_t c = 0; c < std::ssize(curves); ++c) {
        std::vector<TrimmedPoint>& kept = trimmed.curves.emplace_back().points;
        for (std::int32_t i = 0; i < std::ssize(curves[c].points); ++i) {
            const SectionPoint& point = curves[c].points[i];
            if (kept.empty() || point.x() >= kept.back().at.x())
                kept.push_back({point, {c, i}, {c, i}, TrimmedKind::Vertex});
        }
    }
    return trimmed;
}

int main()
{
    // One loop below the crossing at s = 0, z = 0.
    const std::vector<SectionCurve> curves{
        {{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}}}};
    const TrimmingOptions options{.scan_step = 0.01,
                                  .scan_threshold = 0.04};  // of method 1
    for (const TrimmingMethod& method : trimming_methods())
        std::cout << method.name << ": "
                  << method.trim(curves, options).curves.front().points.size()
                  << " points\n";
    std::cout << "own method: "
              << keep_points_ahead(curves, options).curves.front().points.size()
              << " points\n";
}
