// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Envelope_diagram_1.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/envelope_2.h>
#include <polyclipping/clipper.hpp>

#include "endmill/offset/section_curve.h"

// The upper envelope of a section by other libraries.
namespace endmill {

/// By CGAL with exact constructions. \return number of pieces.
inline std::size_t cgal_envelope(const SectionCurve& curve)
{
    using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
    using Traits = CGAL::Arr_segment_traits_2<Kernel>;
    std::vector<Traits::X_monotone_curve_2> segments;
    segments.reserve(curve.points.size());
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
        const SectionPoint& a = curve.points[k];
        const SectionPoint& b = curve.points[k + 1];
        if (a != b)
            segments.emplace_back(Kernel::Point_2{a[0], a[1]},
                                  Kernel::Point_2{b[0], b[1]});
    }
    CGAL::Envelope_diagram_1<Traits> diagram;
    CGAL::upper_envelope_x_monotone_2(segments.begin(), segments.end(), diagram);
    std::size_t pieces = 0;
    for (auto edge = diagram.leftmost(); edge != diagram.rightmost();
         edge = edge->right()->right())
        ++pieces;
    return pieces;
}

/// By polyclipping: the union of the region below the curve, closed `down` below it, on a
/// grid of 1e-6 mm. It is not exact, and no envelope where the curve overhangs. \return
/// number of points.
inline std::size_t polyclipping_union(const SectionCurve& curve, const SectionPoint& down)
{
    namespace clipper = ClipperLib;
    constexpr double per_mm = 1e6;
    clipper::Path path;
    path.reserve(curve.points.size() + 2);
    const auto add = [&](const SectionPoint& point) {
        path.emplace_back(std::llround(per_mm * point[0]),
                          std::llround(per_mm * point[1]));
    };
    for (const SectionPoint& point : curve.points)
        add(point);
    add(curve.points.back() + down);
    add(curve.points.front() + down);
    clipper::Clipper engine;
    engine.AddPath(path, clipper::ptSubject, true);
    clipper::Paths result;
    engine.Execute(clipper::ctUnion, result, clipper::pftNegative);
    std::size_t points = 0;
    for (const clipper::Path& part : result)
        points += part.size();
    return points;
}

}  // namespace endmill
