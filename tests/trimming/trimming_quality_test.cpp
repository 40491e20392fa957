// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimming_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/trimming/detail/profile_families.h"
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

// The untrimmed loop is the result of which MeasuresTheDepthOfALoop measures the depth. At
// a tenth of the size the depth is a tenth; a curve that never steps back has none.
TEST(InterferenceDepths, AreTheDepthsOfTheUntrimmedCurves)
{
    std::vector<PlaneSection> planes(3);
    planes[0].curves = {loop};
    planes[1].curves = {loop};
    for (SectionPoint& point : planes[1].curves[0].points)
        point /= 10;
    planes[2].curves = {test::open_curve({{0, 0}, {1, 5}, {3, -2}})};
    const std::vector<double> depths = interference_depths(planes);
    ASSERT_EQ(depths.size(), 3U);
    EXPECT_DOUBLE_EQ(depths[0], 4 * 2 / std::sqrt(5));
    EXPECT_DOUBLE_EQ(depths[1], 0.4 * 2 / std::sqrt(5));
    EXPECT_NEAR(depths[2], 0, step_back_on_parts_mm / 2);
    EXPECT_TRUE(interference_depths({}).empty());
}

// docs/methods/interference.md, section 11, T1: the exact result has the vertex (0, 0).
const SectionCurve one_loop =
    test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});

CurveDifference difference_of(const Trimmed& trimmed)
{
    const std::vector<PlaneSection> planes{{{one_loop}, {}, {}, 0}};
    const std::vector<Trimmed> exact{test::trim("envelope", one_loop)};
    const std::vector<Trimmed> found{trimmed};
    return differences_from_exact(planes, exact, found).at(0);
}

TEST(CurveDifference, OfALoopThatIsLeftIsItsFarthestPoint)
{
    const CurveDifference found = difference_of(result_of({one_loop.points}));
    EXPECT_DOUBLE_EQ(found.distance_mm, std::sqrt(8));  // of (+-2, -2) from (0, 0)
    EXPECT_EQ(found.place.y(), -2);
    EXPECT_EQ(found.step_back_mm, 2);
    EXPECT_EQ(found.lost_mm, 0);
    EXPECT_FALSE(is_right(found, 1e9));
}

TEST(CurveDifference, OfALostPathIsItsLength)
{
    const CurveDifference found = difference_of(result_of({{{-6, 6}, {0, 0}}}));
    EXPECT_EQ(found.lost_mm, 6);
    EXPECT_DOUBLE_EQ(found.distance_mm, std::sqrt(72));  // of (6, 6) from (0, 0)
    EXPECT_EQ(found.place, SectionPoint(6, 6));
    EXPECT_EQ(found.below_mm, 0);
    EXPECT_TRUE(is_right(found, 6));
    EXPECT_FALSE(is_right(found, 5.9));
}

TEST(CurveDifference, OfNothingIsTheExtentOfTheExactResult)
{
    const CurveDifference found = difference_of({});
    EXPECT_DOUBLE_EQ(found.distance_mm, std::hypot(12, 6));
    EXPECT_EQ(found.lost_mm, 12);
}

TEST(CurveDifference, OfExactResultsIsZero)
{
    for (const char* method : {"envelope", "winding", "3r", "3"}) {
        const CurveDifference found = difference_of(test::trim(method, one_loop));
        EXPECT_EQ(found.distance_mm, 0) << method;
        EXPECT_TRUE(is_right(found, 0)) << method;
    }
    EXPECT_THROW(differences_from_exact({}, {}, std::vector<Trimmed>(1)), DomainError);
}

// docs/methods/interference.md, section 11, C1: the curve ends in a tail, which the
// envelope contains and a method may cut off.
TEST(CurveDifference, ATailThatIsCutOffIsRight)
{
    const SectionCurve tail = test::open_curve({{-6, 6}, {2, -2}, {0, -1}});
    const std::vector<PlaneSection> planes{{{tail}, {}, {}, 0}};
    const std::vector<Trimmed> exact{test::trim("envelope", tail)};
    const std::vector<Trimmed> cut{test::trim("winding", tail)};  // ends at (0, 0)
    const CurveDifference found = differences_from_exact(planes, exact, cut).at(0);
    EXPECT_DOUBLE_EQ(found.distance_mm, std::sqrt(8));
    EXPECT_TRUE(is_right(found, 0));
}

// Distances computed without bins: every point against every segment.
double farthest_by_brute_force(const Trimmed& from, const Trimmed& to)
{
    double farthest = 0;
    const auto measure = [&](const SectionPoint& point) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const TrimmedCurve& curve : to.curves)
            for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
                const SectionPoint& a = curve.points[i].at;
                const SectionPoint along = curve.points[i + 1].at - a;
                const double share =
                    std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (point - a - share * along).norm());
            }
        farthest = std::max(farthest, nearest);
    };
    for (const TrimmedCurve& curve : from.curves)
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            measure(curve.points[i].at);
            if (i > 0)
                measure((curve.points[i - 1].at + curve.points[i].at) / 2);
        }
    return farthest;
}

TEST(CurveDifference, AgreesWithBruteForceOnRandomProfiles)
{
    constexpr std::size_t step = 8;  // between the profiles that are tested
    const std::vector<OffsetProfile> profiles = wavy_profiles();
    int differing = 0;
    for (std::size_t k = 0; k < profiles.size(); k += step) {
        const SectionCurve curve = offset_curve(profiles[k], 101);
        const std::vector<PlaneSection> planes{{{curve}, {}, {}, 0}};
        const std::vector<Trimmed> exact{test::trim("envelope", curve)};
        const std::vector<Trimmed> found{
            test::trim("3", curve, {.detection = FoldDetection::Literal})};
        if (found[0].curves.empty())
            continue;
        const double distance =
            differences_from_exact(planes, exact, found).at(0).distance_mm;
        EXPECT_NEAR(distance,
                    std::max(farthest_by_brute_force(exact[0], found[0]),
                             farthest_by_brute_force(found[0], exact[0])),
                    1e-12);
        differing += distance > 0.01;
    }
    EXPECT_GT(differing, 10);
}

}  // namespace
}  // namespace endmill
