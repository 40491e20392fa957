// SPDX-License-Identifier: GPL-3.0-or-later
// Trimmed offsets of polylines, against distances that are computed without an offset.
#include "endmill/trimming/trimmed_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "endmill/cutter/plane_offset.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

// A profile with `count` random heights at random distances.
std::vector<SectionPoint> random_profile(int count, unsigned seed)
{
    std::mt19937 random{seed};
    std::vector<SectionPoint> points{{0, 0}};
    for (int i = 0; i < count; ++i)
        points.emplace_back(
            points.back().x() + 0.2 + static_cast<double>(random() % 1000) / 250,
            static_cast<double>(random() % 1000) / 100);
    return points;
}

// Signed distance of `point` from the cutter at `reference`: that of the segment or half
// plane from which the corner radius keeps its distance.
double gap_at(const Cutter& cutter, const SectionPoint& reference,
              const SectionPoint& point)
{
    const double aside =
        std::max(std::abs(point.x() - reference.x()) - cutter.flat_radius(), 0.0);
    const double below = std::max(reference.y() - point.y(), 0.0);
    return std::hypot(aside, below) - cutter.corner_radius();
}

// The smallest gap between the cutter and a profile. Along a segment the distance from a
// convex body is a convex function, whose least value a ternary search finds.
double gap_over(const std::vector<SectionPoint>& profile, const Cutter& cutter,
                const SectionPoint& reference)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const SectionPoint along = profile[i + 1] - profile[i];
        const auto gap = [&](double share) {
            return gap_at(cutter, reference, profile[i] + share * along);
        };
        double low = 0;
        double high = 1;
        for (int round = 0; round < 40; ++round) {
            const double one = low + (high - low) / 3;
            const double other = high - (high - low) / 3;
            (gap(one) < gap(other) ? high : low) = gap(one) < gap(other) ? other : one;
        }
        least = std::min(least, gap((low + high) / 2));
    }
    return least;
}

TEST(TrimmedPolylines, TouchTheProfileAndDoNotGouge)
{
    constexpr double arc_tolerance = 1.25e-4;
    constexpr double rounding = 1e-5;
    constexpr std::size_t step = 8;  // between the vertices that are tested
    for (const Cutter& cutter : {Cutter::ball(2), Cutter{3, 1}})
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const std::vector<SectionPoint> profile = random_profile(9, seed);
            const PolylineOffset offset = polyline_offset(cutter, profile);
            const std::vector<PlaneSection> planes{
                {{test::open_curve(offset.points)}, {}, {}, 0}};
            const std::vector<std::optional<Interval>> ranges{
                Interval{offset.low_s, offset.high_s}};
            for (const char* method : {"envelope", "winding", "3r"}) {
                const std::vector<Trimmed> trimmed =
                    trim_planes(planes, ranges, test::trimming_method(method), {});
                for (const TrimmedCurve& curve : trimmed.front().curves)
                    for (std::size_t i = 0; i < curve.points.size(); ++i) {
                        const TrimmedPoint& point = curve.points[i];
                        if (point.kind == TrimmedKind::Vertex && i % step != 0)
                            continue;
                        const double gap = gap_over(profile, cutter, point.at);
                        ASSERT_GE(gap, -arc_tolerance) << method << ' ' << seed;
                        ASSERT_LE(gap, rounding) << method << ' ' << seed;
                    }
            }
        }
}

}  // namespace
}  // namespace endmill
