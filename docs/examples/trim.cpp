// SPDX-License-Identifier: GPL-3.0-or-later
// Trims a curve that crosses itself by every method of the library and by one of its own.

#include <iostream>
#include <utility>

#include "endmill/trimming.h"

using namespace endmill;

// The method of docs/guide/extend.md: removes every point that lies behind an earlier one.
Trimmed forward_trimming(std::span<const SectionCurve> curves, const TrimmingOptions&)
{
    Trimmed trimmed;
    trimmed.rule = "behind";  // the rule of every cut
    for (std::int32_t c = 0; c < std::ssize(curves); ++c) {
        const std::vector<SectionPoint>& points = curves[c].points;
        TrimmedCurve kept;
        for (std::int32_t i = 0; i < std::ssize(points); ++i)
            if (kept.points.empty() || points[i].x() >= kept.points.back().at.x())
                kept.points.push_back({points[i], {c, i}, {c, i}, TrimmedKind::Vertex});
        if (kept.points.size() >= 2)  // a curve needs two
            trimmed.curves.push_back(std::move(kept));
    }
    return trimmed;
}

// Prints the number of points that each method keeps.
int main()
{
    // One loop below the self-intersection at s = 0, z = 0.
    const std::vector<SectionCurve> curves{
        {{{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}}}};
    const TrimmingOptions options{.scan_step = 0.01, .scan_threshold = 0.04};
    for (const TrimmingMethod& method : trimming_methods())
        std::cout << method.name << ": "
                  << method.trim(curves, options).curves.front().points.size() << '\n';
    std::cout << "forward: "
              << forward_trimming(curves, options).curves.front().points.size() << '\n';
}
