// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimming_methods.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/trimming/trimming_quality.h"
#include "trimmed_curves.h"
#include "trimming_vectors.h"

namespace endmill {
namespace {

using test::ExpectedTrim;
using test::TrimmingVector;

constexpr std::array paper_methods{"1", "2", "3"};
constexpr std::array both_detections{FoldDetection::Literal, FoldDetection::Guarded};

TEST(TrimmingMethods, HaveDifferentNames)
{
    const auto methods = trimming_methods();
    for (const TrimmingMethod& method : methods) {
        EXPECT_EQ(&test::trimming_method(method.name), &method);
        EXPECT_FALSE(method.title.empty());
    }
    EXPECT_TRUE(test::trimming_method("1").has_detection);
    EXPECT_FALSE(test::trimming_method("3r").has_detection);
}

const ExpectedTrim& expected_trim(const TrimmingVector& vector, std::string_view method,
                                  FoldDetection detection)
{
    if (method == "3r")
        return vector.repaired;
    return detection == FoldDetection::Literal ? vector.literal : vector.guarded;
}

// The error bound of method 1 for the crossing of two segments.
// Source: docs/methods/interference.md, section 5.1.
SectionPoint distance_bound(const TrimmingVector& vector,
                            const test::ExpectedCrossing& at, double threshold)
{
    const auto slope = [&](int segment) {
        const auto& points = vector.curve.points;
        const SectionPoint along = points[segment + 1] - points[segment];
        return along.x() / along.y();
    };
    const double a = slope(at.segment_a);
    const double b = slope(at.segment_b);
    return {threshold / 2 * std::abs((a + b) / (b - a)), threshold / std::abs(b - a)};
}

// The tolerance for the point `expected` of a result; 0 for a vertex.
SectionPoint tolerance_of(const TrimmingVector& vector, const SectionPoint& expected,
                          double threshold)
{
    SectionPoint tolerance = SectionPoint::Zero();
    for (const test::ExpectedCrossing& crossing : vector.crossings) {
        if (crossing.at == expected)
            tolerance =
                tolerance.cwiseMax(distance_bound(vector, crossing, 1.2 * threshold));
    }
    return tolerance;
}

void expect_by_distance(const TrimmingVector& vector, const ExpectedTrim& expected,
                        const TrimmingOptions& options)
{
    const auto points = test::points_left(test::trim("1", vector.curve, options));
    ASSERT_EQ(points.size(), expected.points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SectionPoint tolerance =
            tolerance_of(vector, expected.points[i], options.scan_threshold);
        const SectionPoint error = (points[i] - expected.points[i]).cwiseAbs();
        EXPECT_LE(error.x(), tolerance.x() + 1e-15) << "at " << i;
        EXPECT_LE(error.y(), tolerance.y() + 1e-15) << "at " << i;
    }
}

TEST(TrimmingMethods, AgreeWithTheTestVectors)
{
    for (const TrimmingVector& vector : test::trimming_vectors()) {
        for (const FoldDetection detection : both_detections) {
            const TrimmingOptions options = test::options_for(vector.curve, detection);
            for (const char* method : {"2", "3", "3r"}) {
                SCOPED_TRACE(vector.name + " by " + method +
                             (detection == FoldDetection::Literal ? " literal" : ""));
                const auto points =
                    test::points_left(test::trim(method, vector.curve, options));
                test::expect_points(
                    points, expected_trim(vector, method, detection).points, 1e-12);
            }
            SCOPED_TRACE(vector.name + " by 1");
            expect_by_distance(vector, expected_trim(vector, "1", detection), options);
        }
    }
}

// The vectors list which results are right. trimming_quality must agree.
TEST(TrimmingMethods, FailOnTheKnownTestVectors)
{
    for (const TrimmingVector& vector : test::trimming_vectors()) {
        for (const FoldDetection detection : both_detections) {
            const TrimmingOptions options = test::options_for(vector.curve, detection);
            for (const char* method : {"2", "3", "3r"}) {
                SCOPED_TRACE(vector.name + " by " + method);
                const auto quality = trimming_quality(
                    {&vector.curve, 1}, test::trim(method, vector.curve, options));
                const TrimmingTolerance tolerance{.gouge_mm = 1e-9, .uncovered = 1e-9};
                EXPECT_EQ(is_right(quality, tolerance),
                          expected_trim(vector, method, detection).is_right);
            }
        }
    }
}

TEST(TrimmingMethods, NameTheSegmentsOfTheirPoints)
{
    const SectionCurve curve =
        test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});
    for (const char* method : {"2", "3", "3r"}) {
        const Trimmed trimmed = test::trim(method, curve);
        const auto& points = trimmed.curves.at(0).points;
        ASSERT_EQ(points.size(), 3U);
        EXPECT_EQ(points[0].kind, TrimmedKind::Vertex);
        EXPECT_EQ(points[0].on, (SegmentNumber{0, 0}));
        EXPECT_EQ(points[1].kind, TrimmedKind::Crossing);
        EXPECT_EQ(points[1].on, (SegmentNumber{0, 0}));
        EXPECT_EQ(points[1].across, (SegmentNumber{0, 3}));
        EXPECT_EQ(points[2].on, (SegmentNumber{0, 4}));
        ASSERT_EQ(trimmed.rules.size(), 1U);
        EXPECT_EQ(trimmed.rules[0].first_point, 1);
        EXPECT_EQ(trimmed.rules[0].last_point, 3);
        EXPECT_EQ(trimmed.unresolved, 0);
    }
}

TEST(TrimmingMethods, TrimEachOpenCurveByItselfAndSortThem)
{
    const SectionCurve low = test::open_curve({{-9, 0}, {-8, 0}});
    const SectionCurve high =
        test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});
    const std::vector<SectionCurve> curves{low, high};
    for (const char* method : paper_methods) {
        const Trimmed trimmed = test::trimming_method(method).trim(
            curves, test::options_for(high, FoldDetection::Literal));
        ASSERT_EQ(trimmed.curves.size(), 2U);
        EXPECT_EQ(trimmed.curves[0].points.size(), 2U);
        EXPECT_EQ(trimmed.curves[1].points[0].on, (SegmentNumber{1, 0}));
    }
}

TEST(TrimmingMethods, LeaveCurvesWithoutFoldsAsTheyAre)
{
    constexpr double huge = 1e150;
    constexpr double tiny = 1e-300;
    const std::vector<SectionCurve> curves{
        test::open_curve({{0, 0}, {1, 0}}),
        test::open_curve({{0, 5}, {0, 1}}),  // vertical
        // a vertical curve with reversals
        test::open_curve({{0, 0}, {0, 3}, {0, 1}, {0, 2}}),
        test::open_curve({{0, 0}, {1, 1}, {2, 2}, {3, 3}}),  // on a line
        test::open_curve({{0, 0}, {1, 0}, {1, 2}, {2, 2}}),  // a step
        test::open_curve({{-huge, huge}, {0, 0}, {huge, huge}}),
        test::open_curve({{-tiny, tiny}, {0, 0}, {tiny, tiny}}),
        test::open_curve({{1e6, 1e6}, {1e6 + 1e-9, 1e6 - 1e-9}, {1e6 + 2e-9, 1e6}}),
    };
    for (const char* method : {"1", "2", "3", "3r"}) {
        for (const SectionCurve& curve : curves) {
            auto options = test::options_for(curve, FoldDetection::Guarded);
            options.scan_step = std::max(options.scan_step, 1e-3);
            options.scan_threshold = 4 * options.scan_step;
            const Trimmed trimmed = test::trim(method, curve, options);
            EXPECT_EQ(test::points_left(trimmed), curve.points);
            EXPECT_TRUE(trimmed.rules.empty());
        }
    }
}

// Checks the meaning of TrimmedKind and the order of curves, for every method in the
// table.
void expect_in_order_and_from(const SectionCurve& curve, const Trimmed& trimmed)
{
    double smallest_s = -std::numeric_limits<double>::infinity();
    for (const TrimmedCurve& left : trimmed.curves) {
        ASSERT_GE(left.points.size(), 2U);
        double least = std::numeric_limits<double>::infinity();
        for (const TrimmedPoint& point : left.points) {
            EXPECT_TRUE(point.at.allFinite());
            ASSERT_EQ(point.on.curve, 0);
            if (point.kind == TrimmedKind::Vertex) {
                EXPECT_EQ(point.at, curve.points.at(point.on.point));
            }
            least = std::min(least, point.at.x());
        }
        EXPECT_GE(least, smallest_s);
        smallest_s = least;
    }
}

TEST(TrimmingMethods, AllKeepTheContract)
{
    for (const TrimmingMethod& method : trimming_methods()) {
        SCOPED_TRACE(method.name);
        for (const TrimmingVector& vector : test::trimming_vectors()) {
            const auto options = test::options_for(vector.curve, FoldDetection::Guarded);
            expect_in_order_and_from(vector.curve,
                                     method.trim({&vector.curve, 1}, options));
        }
        const SectionCurve wave = test::open_curve({{0, 0}, {1, 2}, {2, -1}, {3, 0}});
        const auto options = test::options_for(wave, FoldDetection::Guarded);
        EXPECT_EQ(test::points_left(method.trim({&wave, 1}, options)), wave.points);
        EXPECT_TRUE(method.trim({}, options).curves.empty());
    }
}

// A section never runs backwards as a whole. If a curve does, the fold is reported.
TEST(TrimmingMethods, ReportABackwardCurve)
{
    const SectionCurve curve = test::open_curve({{3, 0}, {2, 1}, {0, 2}});
    const Trimmed trimmed = test::trim("3", curve);
    EXPECT_EQ(test::points_left(trimmed), curve.points);
    EXPECT_EQ(trimmed.unresolved, 1);
}

TEST(TrimmingMethods, AcceptPathsThatReverseOnOneLine)
{
    const SectionCurve curve =
        test::open_curve({{0, 0}, {2, 0}, {1, 0}, {3, 0}, {2, 0}, {4, 0}});
    for (const FoldDetection detection : both_detections) {
        for (const char* method : {"1", "2", "3", "3r"}) {
            const Trimmed trimmed = test::trim(
                method, curve,
                {.detection = detection, .scan_step = 0.01, .scan_threshold = 0.04});
            EXPECT_EQ(trimmed.curves.size(), 1U);
        }
    }
}

TEST(TrimmingMethods, RefuseInvalidCurves)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const TrimmingOptions options{.scan_step = 1, .scan_threshold = 1};
    for (const char* method : {"1", "2", "3", "3r"}) {
        EXPECT_THROW(test::trim(method, test::open_curve({}), options), DomainError);
        EXPECT_THROW(test::trim(method, test::open_curve({{0, 0}}), options),
                     DomainError);
        for (const double bad : {nan, infinity, -infinity}) {
            EXPECT_THROW(
                test::trim(method, test::open_curve({{0, 0}, {bad, 1}, {2, 0}}), options),
                DomainError);
            EXPECT_THROW(
                test::trim(method, test::open_curve({{0, 0}, {1, 1}, {2, bad}}), options),
                DomainError);
        }
    }
}

}  // namespace
}  // namespace endmill
