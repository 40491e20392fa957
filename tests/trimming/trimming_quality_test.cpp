// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimming_quality.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "trimmed_curves.h"
#include "trimming_vectors.h"

namespace endmill {
namespace {

// A result with these points, of any origin.
Trimmed result_of(const std::vector<std::vector<SectionPoint>>& curves)
{
    Trimmed result;
    for (const auto& points : curves) {
        result.curves.emplace_back();
        for (const SectionPoint& point : points)
            result.curves.back().points.push_back({point, {}, {}, TrimmedKind::Vertex});
    }
    return result;
}

TrimmingQuality quality(const SectionCurve& curve,
                        const std::vector<SectionPoint>& result)
{
    return trimming_quality({&curve, 1}, result_of({result}));
}

const SectionCurve loop = test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});

TEST(TrimmingQuality, OfTheEnvelopesOfTheVectorsIsFaultless)
{
    for (const test::TrimmingVector& vector : test::trimming_vectors()) {
        SCOPED_TRACE(vector.name);
        const TrimmingQuality found = quality(vector.curve, vector.envelope);
        EXPECT_TRUE(is_right(found, {.gouge_mm = 1e-12, .uncovered = 1e-12}));
    }
}

TEST(TrimmingQuality, MeasuresTheDepthOfALoop)
{
    // At s = 2 the tail lies 4 mm below the other branch, and falls by 1 in 2 there.
    const TrimmingQuality found = quality(loop, loop.points);
    EXPECT_DOUBLE_EQ(found.gouge_mm, 4 * 2 / std::sqrt(5));
    EXPECT_DOUBLE_EQ(found.step_back_mm, 2);
    EXPECT_EQ(found.uncovered, 0);
}

TEST(TrimmingQuality, FindsUncoveredRanges)
{
    EXPECT_DOUBLE_EQ(quality(loop, {{-6, 6}, {0, 0}}).uncovered, 0.5);
    EXPECT_DOUBLE_EQ(quality(loop, {{-3, 3}, {0, 0}, {3, 3}}).uncovered, 0.5);
    EXPECT_EQ(trimming_quality({&loop, 1}, Trimmed{}).uncovered, 1);
}

TEST(TrimmingQuality, TakesCurvesTogether)
{
    const std::vector<SectionCurve> curves{test::open_curve({{0, 0}, {4, 0}}),
                                           test::open_curve({{3, 2}, {8, 2}})};
    const auto both = result_of({{{0, 0}, {3, 0}}, {{3, 2}, {8, 2}}});
    EXPECT_TRUE(is_right(trimming_quality(curves, both), {}));
    const TrimmingQuality found = trimming_quality(curves, result_of({{{0, 0}, {4, 0}}}));
    EXPECT_EQ(found.gouge_mm, 2);
    EXPECT_DOUBLE_EQ(found.uncovered, 0.5);
}

// A vertical link and a segment that begins at its foot count as no gouge.
TEST(TrimmingQuality, TakesLimitsFromInsideASegment)
{
    const SectionCurve step = test::open_curve({{0, 0}, {1, 0}, {1, 5}, {2, 5}});
    EXPECT_TRUE(is_right(quality(step, step.points), {}));
    EXPECT_FALSE(is_right(quality(step, {{0, 0}, {1.01, 0}, {1.01, 5}, {2, 5}}), {}));
}

TEST(TrimmingQuality, AcceptsCurvesWithoutWidth)
{
    const SectionCurve vertical = test::open_curve({{1, 0}, {1, 5}});
    EXPECT_TRUE(is_right(quality(vertical, vertical.points), {}));
    EXPECT_TRUE(is_right(trimming_quality({}, {}), {}));
}

// Plane 0 is right, plane 1 lies 0.25 below its envelope, plane 2 steps back.
TEST(EnvelopeComparison, CountsTheSectionsThatAreWrong)
{
    std::vector<PlaneSection> planes(3);
    for (PlaneSection& plane : planes)
        plane.curves = {test::open_curve({{0, 1}, {4, 1}})};
    const std::vector<Trimmed> trimmed{result_of({{{0, 1}, {4, 1}}}),
                                       result_of({{{0, 0.75}, {4, 0.75}}}),
                                       result_of({{{0, 1}, {3, 1}, {2, 1}, {4, 1}}})};
    const EnvelopeComparison strict = compare_with_envelope(planes, trimmed, 0.1);
    EXPECT_EQ(strict.wrong, 2U);
    EXPECT_EQ(strict.max_gouge_mm, 0.25);
    EXPECT_EQ(compare_with_envelope(planes, trimmed, 0.25).wrong, 1U);
    EXPECT_EQ(compare_with_envelope({}, {}, 0.1).wrong, 0U);
    EXPECT_THROW(compare_with_envelope(planes, {}, 0.1), DomainError);
}

}  // namespace
}  // namespace endmill
