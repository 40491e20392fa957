// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the envelope of random curves, most of them degenerate, with the exact
// envelope of CGAL.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

// Where one segment ends and another begins, CGAL 5.5 asks for their order right of that
// point, against its own precondition, and makes an edge of length 0. The check is
// skipped here; the rest of the result is correct.
#define CGAL_NDEBUG
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Envelope_diagram_1.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/envelope_2.h>
#include <gtest/gtest.h>

#include "endmill/trimming/detail/envelope_trimming.h"
#include "random.h"

namespace endmill {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Diagram = CGAL::Envelope_diagram_1<Traits>;
using ExactPoint = Kernel::Point_2;
using ExactCurve = std::vector<ExactPoint>;

ExactPoint exact(const SectionPoint& point)
{
    return {point[0], point[1]};
}

Kernel::Line_2 line(const std::vector<SectionCurve>& curves, const SegmentNumber& segment)
{
    const auto& points = curves[segment.curve].points;
    return {exact(points[segment.point]), exact(points[segment.point + 1])};
}

// The exact position of a point, computed from its origin.
ExactPoint origin(const std::vector<SectionCurve>& curves, const TrimmedPoint& point)
{
    const auto vertex = [&](const SegmentNumber& number) {
        return exact(curves[number.curve].points[number.point]);
    };
    if (point.kind == TrimmedKind::Vertex)
        return vertex(point.on);
    if (point.kind == TrimmedKind::Crossing) {
        const auto met =
            CGAL::intersection(line(curves, point.on), line(curves, point.across));
        return *boost::get<ExactPoint>(&*met);
    }
    const auto s = vertex(point.across).x();
    return {s, line(curves, point.on).y_at_x(s)};
}

bool is_nearest(double rounded, const Kernel::FT& value)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Kernel::FT below = std::nextafter(rounded, -infinity);
    const Kernel::FT above = std::nextafter(rounded, infinity);
    return 2 * value >= below + rounded && 2 * value <= above + rounded;
}

// Appends a point; repeated points and points on a straight piece are left out.
void append(ExactCurve& curve, const ExactPoint& point)
{
    if (!curve.empty() && curve.back() == point)
        return;
    while (curve.size() > 1 &&
           CGAL::are_strictly_ordered_along_line(*(curve.end() - 2), curve.back(), point))
        curve.pop_back();
    curve.push_back(point);
}

// The highest points of vertical segments, one for each s, ordered by s.
ExactCurve tops_of_verticals(const std::vector<SectionCurve>& curves)
{
    std::map<double, double> tops;
    for (const SectionCurve& curve : curves) {
        for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
            const SectionPoint& a = curve.points[k];
            const SectionPoint& b = curve.points[k + 1];
            if (a[0] != b[0])
                continue;
            double& top = tops.try_emplace(a[0], a[1]).first->second;
            top = std::max({top, a[1], b[1]});
        }
    }
    ExactCurve result;
    for (const auto& [s, z] : tops)
        result.emplace_back(s, z);
    return result;
}

// Inserts the top of a vertical segment into an envelope that does not contain it.
void insert(std::vector<ExactCurve>& envelope, const ExactPoint& top)
{
    auto curve = envelope.begin();
    while (curve != envelope.end() && curve->back().x() < top.x())
        ++curve;
    if (curve == envelope.end() || curve->front().x() > top.x()) {
        envelope.insert(curve, {top});
        return;
    }
    auto next = curve->begin();
    while (next->x() < top.x())
        ++next;
    if (next->x() > top.x()) {  // inside a straight piece
        const Kernel::Line_2 carrier{*(next - 1), *next};
        const ExactPoint foot{top.x(), carrier.y_at_x(top.x())};
        if (top.y() > foot.y())
            curve->insert(next, {foot, top, foot});
        return;
    }
    auto behind = next;  // one or two points have this s
    bool is_above = true;
    for (; behind != curve->end() && behind->x() == top.x(); ++behind)
        is_above = is_above && top.y() > behind->y();
    if (!is_above)
        return;
    const bool is_inside = next != curve->begin() && behind != curve->end();
    const ExactPoint foot = *(behind - 1);
    if (next == curve->begin())
        curve->insert(next, top);
    else if (is_inside && behind - next == 1)
        curve->insert(behind, {top, foot});
    else
        curve->insert(next + 1, top);
}

std::vector<ExactCurve> cgal_envelope(const std::vector<SectionCurve>& curves)
{
    std::vector<Traits::X_monotone_curve_2> segments;
    for (const SectionCurve& curve : curves)
        for (std::size_t k = 0; k + 1 < curve.points.size(); ++k)
            if (curve.points[k][0] != curve.points[k + 1][0])
                segments.emplace_back(exact(curve.points[k]), exact(curve.points[k + 1]));
    Diagram diagram;
    CGAL::upper_envelope_x_monotone_2(segments.begin(), segments.end(), diagram);
    const auto height = [](const Diagram::Edge_const_handle& edge, const Kernel::FT& s) {
        return ExactPoint{s, edge->curve().line().y_at_x(s)};
    };
    std::vector<ExactCurve> result;
    bool is_gap = true;
    auto left =
        segments.empty() ? Diagram::Vertex_const_handle{} : diagram.leftmost()->right();
    while (!segments.empty() && left->right() != diagram.rightmost()) {
        const auto edge = left->right();
        const Kernel::FT from = left->point().x();
        const Kernel::FT to = edge->right()->point().x();
        left = edge->right();
        if (from == to)
            continue;
        if (is_gap && !edge->is_empty())
            result.emplace_back();
        is_gap = edge->is_empty();
        if (!is_gap)
            result.back().insert(result.back().end(),
                                 {height(edge, from), height(edge, to)});
    }
    for (const ExactPoint& top : tops_of_verticals(curves))
        insert(result, top);
    for (ExactCurve& curve : result) {
        const ExactCurve whole = std::move(curve);
        curve.clear();
        for (const ExactPoint& point : whole)
            append(curve, point);
    }
    return result;
}

double nearest(const Kernel::FT& value)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double near = CGAL::to_double(value);
    for (const double rounded :
         {near, std::nextafter(near, infinity), std::nextafter(near, -infinity)})
        if (is_nearest(rounded, value))
            return rounded;
    return std::numeric_limits<double>::quiet_NaN();
}

// The corners of an envelope as doubles, without repetitions.
std::vector<SectionPoint> rounded(const ExactCurve& curve)
{
    std::vector<SectionPoint> result;
    for (const ExactPoint& point : curve) {
        const SectionPoint next{nearest(point.x()), nearest(point.y())};
        if (result.empty() || result.back() != next)
            result.push_back(next);
    }
    return result;
}

// Expects that `curve` contains all corners of `expected` and no point outside it.
void expect_as(const TrimmedCurve& curve, const ExactCurve& expected,
               const std::vector<SectionCurve>& curves)
{
    std::size_t stretch = 0;
    std::vector<SectionPoint> points;
    for (const TrimmedPoint& point : curve.points) {
        const ExactPoint place = origin(curves, point);
        EXPECT_TRUE(is_nearest(point.at[0], place.x()));
        EXPECT_TRUE(is_nearest(point.at[1], place.y()));
        if (!points.empty()) {
            EXPECT_GE(point.at[0], points.back()[0]);
            EXPECT_NE(point.at, points.back());
        }
        while (stretch + 1 < expected.size() &&
               !Kernel::Segment_2{expected[stretch], expected[stretch + 1]}.has_on(place))
            ++stretch;
        EXPECT_LT(stretch + 1, expected.size()) << place;
        points.push_back(point.at);
    }
    auto next = points.begin();
    for (const SectionPoint& corner : rounded(expected)) {
        next = std::find(next, points.end(), corner);
        EXPECT_NE(next, points.end()) << corner.transpose();
    }
}

// Expects that the envelope of `curves` equals that of CGAL, in its points and in their
// origins.
void expect_as_cgal(const std::vector<SectionCurve>& curves)
{
    const Trimmed trimmed = envelope_trimming(curves);
    const auto expected = cgal_envelope(curves);
    ASSERT_EQ(trimmed.curves.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        if (expected[k].size() > 1) {
            expect_as(trimmed.curves[k], expected[k], curves);
        } else {  // the top of a lone vertical segment
            ASSERT_EQ(trimmed.curves[k].points.size(), 2u);
            EXPECT_EQ(exact(trimmed.curves[k].points[1].at), expected[k].front());
        }
    }
}

// Curves of a few points each. About every third point repeats an earlier one.
template <typename Coordinate>
std::vector<SectionCurve> random_curves(test::Random& random,
                                        const Coordinate& coordinate)
{
    std::vector<SectionCurve> curves(1 + random.engine()() % 3);
    std::vector<SectionPoint> seen;
    for (SectionCurve& curve : curves) {
        const std::size_t count = 2 + random.engine()() % 12;
        while (curve.points.size() < count) {
            SectionPoint point{coordinate(), coordinate()};
            if (!seen.empty() && random.engine()() % 3 == 0)
                point = seen[random.engine()() % seen.size()];
            if (curve.points.empty() || point != curve.points.back())
                curve.points.push_back(point);
            seen.push_back(point);
        }
    }
    return curves;
}

template <typename Coordinate>
void expect_many_as_cgal(unsigned seed, const Coordinate& coordinate)
{
    test::Random random{seed};
    for (int k = 0; k < 2000 && !testing::Test::HasFailure(); ++k) {
        SCOPED_TRACE(k);
        expect_as_cgal(random_curves(random, [&] { return coordinate(random); }));
    }
}

TEST(EnvelopeByCgal, IsTheSameOnASmallGrid)
{
    expect_many_as_cgal(1, [](test::Random& random) { return random.engine()() % 5; });
}

TEST(EnvelopeByCgal, IsTheSameOnALargerGrid)
{
    expect_many_as_cgal(2, [](test::Random& random) { return random.engine()() % 13; });
}

TEST(EnvelopeByCgal, IsTheSameOnAGridOfTenths)
{
    expect_many_as_cgal(
        3, [](test::Random& random) { return random.engine()() % 9 / 10.0; });
}

TEST(EnvelopeByCgal, IsTheSameOneRoundingOffAGrid)
{
    expect_many_as_cgal(4, [](test::Random& random) {
        const double step = static_cast<double>(random.engine()() % 3) - 1;
        return 1 + random.engine()() % 4 + 0x1p-50 * step;
    });
}

// Each segment passes over a large part of the envelope of the segments before it.
TEST(EnvelopeByCgal, IsTheSameOfLongTeeth)
{
    test::Random random{6};
    for (int k = 0; k < 10; ++k) {
        SectionCurve curve;
        for (int tooth = 0; tooth < 300; ++tooth) {
            const std::uint32_t side = random.engine()() % 2;
            curve.points.emplace_back(400.0 * side - 50, -30.0);
            curve.points.emplace_back(random.engine()() % 300, random.engine()() % 4);
        }
        expect_as_cgal({curve});
    }
}

TEST(EnvelopeByCgal, IsTheSameAnywhere)
{
    expect_many_as_cgal(5, [](test::Random& random) { return random.uniform(-9, 9); });
}

}  // namespace
}  // namespace endmill
