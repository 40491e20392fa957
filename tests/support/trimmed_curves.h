// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "endmill/trimming/trimming_methods.h"

// Curves to trim, and access to their trimmed results.
namespace endmill::test {

/// An open curve through `points`.
inline SectionCurve open_curve(std::vector<SectionPoint> points)
{
    return {std::move(points), false};
}

/// The method with this name.
inline const TrimmingMethod& trimming_method(std::string_view name)
{
    for (const TrimmingMethod& method : trimming_methods()) {
        if (method.name == name)
            return method;
    }
    throw std::runtime_error{"no method " + std::string{name}};
}

/// The result of method `name` for one curve.
inline Trimmed trim(std::string_view name, const SectionCurve& curve,
                    const TrimmingOptions& options = {})
{
    return trimming_method(name).trim({&curve, 1}, options);
}

/// The scan lines of method 1 as in docs/methods/interference.md, section 1: a
/// thousandth of the z-extent apart.
inline TrimmingOptions options_for(const SectionCurve& curve, FoldDetection detection)
{
    double low = curve.points.front().y();
    double high = low;
    for (const SectionPoint& point : curve.points) {
        low = std::min(low, point.y());
        high = std::max(high, point.y());
    }
    const double step = (high - low) / 1000;
    return {.detection = detection, .scan_step = step, .scan_threshold = 4 * step};
}

/// The points of a curve without their origins.
inline std::vector<SectionPoint> places(const TrimmedCurve& curve)
{
    std::vector<SectionPoint> points;
    for (const TrimmedPoint& point : curve.points)
        points.push_back(point.at);
    return points;
}

/// The points of the only curve of a result.
inline std::vector<SectionPoint> points_left(const Trimmed& trimmed)
{
    EXPECT_EQ(trimmed.curves.size(), 1U);
    return trimmed.curves.empty() ? std::vector<SectionPoint>{}
                                  : places(trimmed.curves.front());
}

inline void expect_points(const std::vector<SectionPoint>& points,
                          const std::vector<SectionPoint>& expected, double tolerance)
{
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_LE((points[i] - expected[i]).cwiseAbs().maxCoeff(), tolerance)
            << "at " << i;
}

}  // namespace endmill::test
