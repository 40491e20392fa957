// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/curve_shares.h"

#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/offset/section_curve.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

// A folded curve of random points, whose s lies between `from` and `from` + 10.
SectionCurve random_curve(std::mt19937& random, double from, bool is_closed)
{
    const auto below = [&](int limit) { return static_cast<double>(random() % limit); };
    SectionCurve curve;
    for (int i = 0; i < 12; ++i)
        curve.points.emplace_back(from + std::min(10.0, i + below(3) / 2), below(40) / 4);
    if (is_closed)
        curve.points.push_back(curve.points.front());
    curve.is_closed = is_closed;
    return curve;
}

enum class Spacing { Apart, Overlapping };

std::vector<SectionCurve> random_curves(unsigned seed, Spacing spacing, int closed_one_in)
{
    std::mt19937 random{seed};
    std::vector<SectionCurve> curves;
    for (int k = 0; k < 20; ++k) {
        const double from = spacing == Spacing::Apart ? 3.5 * k : 4;
        const bool is_closed = closed_one_in > 0 && random() % closed_one_in == 0;
        curves.push_back(random_curve(random, from, is_closed));
    }
    // Gaps, behind every fifth curve.
    if (spacing == Spacing::Apart)
        for (std::size_t k = 0; k < curves.size(); ++k)
            for (SectionPoint& point : curves[k].points)
                point.x() += 20 * static_cast<double>(k / 5);
    return arranged(std::move(curves));
}

void expect_equal(const Trimmed& found, const Trimmed& expected)
{
    EXPECT_EQ(found.unresolved, expected.unresolved);
    EXPECT_EQ(found.rule, expected.rule);
    EXPECT_EQ(found.rules.size(), expected.rules.size());
    ASSERT_EQ(found.curves.size(), expected.curves.size());
    for (std::size_t k = 0; k < found.curves.size(); ++k) {
        const TrimmedCurve& one = found.curves[k];
        const TrimmedCurve& other = expected.curves[k];
        EXPECT_EQ(one.is_closed, other.is_closed);
        ASSERT_EQ(one.points.size(), other.points.size());
        for (std::size_t i = 0; i < one.points.size(); ++i) {
            EXPECT_EQ(one.points[i].at, other.points[i].at);
            EXPECT_EQ(one.points[i].on, other.points[i].on);
            EXPECT_EQ(one.points[i].across, other.points[i].across);
            EXPECT_EQ(one.points[i].kind, other.points[i].kind);
        }
    }
}

Trimmed trimmed_by_shares(std::span<const SectionCurve> curves,
                          const TrimmingMethod& method, const TrimmingOptions& options,
                          std::span<const CurveShare> shares)
{
    std::vector<Trimmed> results;
    for (const CurveShare& share : shares)
        results.push_back(method.trim(curves.subspan(share.first, share.count), options));
    return joined(shares, std::move(results));
}

class CurveSharesOf : public testing::TestWithParam<int> {};

TEST_P(CurveSharesOf, GiveTheResultOfAllCurvesTogether)
{
    for (const Spacing spacing : {Spacing::Apart, Spacing::Overlapping})
        for (const FoldDetection detection :
             {FoldDetection::Guarded, FoldDetection::Literal})
            for (unsigned seed = 0; seed < 2; ++seed) {
                const std::vector<SectionCurve> curves =
                    random_curves(seed, spacing, GetParam());
                TrimmingOptions options{.scan_step = 0.05, .scan_threshold = 0.2};
                options.detection = detection;
                for (const TrimmingMethod& method : trimming_methods()) {
                    SCOPED_TRACE(method.name);
                    const auto shares = curve_shares(curves, method.coupling, 4);
                    expect_equal(trimmed_by_shares(curves, method, options, shares),
                                 method.trim(curves, options));
                }
            }
}

// No closed curve, one in four, only closed ones.
INSTANTIATE_TEST_SUITE_P(OpenAndClosed, CurveSharesOf, testing::Values(0, 4, 1));

TEST(CurveShares, AreContiguousAndAboutEquallyLong)
{
    const std::vector<SectionCurve> curves = random_curves(1, Spacing::Overlapping, 0);
    const auto shares = curve_shares(curves, CurveCoupling::None, 4);
    ASSERT_EQ(shares.size(), 4U);
    std::size_t next = 0;
    for (const CurveShare& share : shares) {
        EXPECT_EQ(share.first, next);
        EXPECT_NEAR(static_cast<double>(share.count), 5, 1);
        next += share.count;
    }
    EXPECT_EQ(next, curves.size());
}

TEST(CurveShares, EndAtGapsIfCurvesThatOverlapAreTrimmedTogether)
{
    const auto apart = random_curves(2, Spacing::Apart, 0);
    const auto shares = curve_shares(apart, CurveCoupling::Overlapping, 3);
    ASSERT_EQ(shares.size(), 3U);
    EXPECT_EQ(shares[1].first % 5, 0U);
    EXPECT_EQ(shares[2].first % 5, 0U);
    const auto together = random_curves(2, Spacing::Overlapping, 0);
    EXPECT_EQ(curve_shares(together, CurveCoupling::Overlapping, 3).size(), 1U);
    EXPECT_EQ(curve_shares(apart, CurveCoupling::Plane, 3).size(), 1U);
}

TEST(CurveShares, HaveAnOpenCurveEachIfThereAreClosedOnes)
{
    const auto closed = random_curves(3, Spacing::Apart, 1);
    EXPECT_EQ(curve_shares(closed, CurveCoupling::Overlapping, 3).size(), 1U);
    EXPECT_EQ(curve_shares(closed, CurveCoupling::None, 3).size(), 1U);
}

TEST(CurveShares, AreNotMoreThanCurves)
{
    std::mt19937 random{4};
    const std::vector<SectionCurve> one{random_curve(random, 0, false)};
    EXPECT_EQ(curve_shares(one, CurveCoupling::None, 3).size(), 1U);
    EXPECT_TRUE(curve_shares({}, CurveCoupling::None, 3).empty());
    EXPECT_TRUE(joined({}, {}).curves.empty());
}

TEST(CurveShares, RefuseNoShareAndAMissingResult)
{
    EXPECT_THROW(curve_shares({}, CurveCoupling::None, 0), DomainError);
    const std::vector<CurveShare> shares{{0, 1}};
    EXPECT_THROW(joined(shares, {}), DomainError);
}

}  // namespace
}  // namespace endmill
