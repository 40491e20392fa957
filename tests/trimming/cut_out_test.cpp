// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/cut_out.h"

#include <gtest/gtest.h>

#include "endmill/trimming/detail/clipped_sections.h"
#include "endmill/trimming/detail/profile_families.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

std::vector<CutOut> cut_from(const SectionCurve& curve, std::string_view method,
                             const CreaseTest& is_on_crease = {})
{
    return cut_out({&curve, 1}, test::trim(method, curve), is_on_crease);
}

void expect_stretch(const CutOut& cut, int first, int last, CutCause cause)
{
    EXPECT_EQ(cut.first_point, first);
    EXPECT_EQ(cut.last_point, last);
    EXPECT_EQ(cut.cause, cause);
}

const SectionCurve loop = test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}});

TEST(CutOut, OfALoopIsAFoldAtTheCrossing)
{
    const auto cuts = cut_from(loop, "3");
    ASSERT_EQ(cuts.size(), 1U);
    expect_stretch(cuts[0], 1, 3, CutCause::Fold);
    EXPECT_EQ(cuts[0].place, SectionPoint(0, 0));
    EXPECT_EQ(cuts[0].rule, "valley");
}

TEST(CutOut, OfALoopWithACreaseIsACrease)
{
    const auto at = [](int point) {
        return [=](SegmentNumber number) { return number.point == point; };
    };
    EXPECT_EQ(cut_from(loop, "3", at(2))[0].cause, CutCause::Crease);
    EXPECT_EQ(cut_from(loop, "3", at(3))[0].cause, CutCause::Crease);
    EXPECT_EQ(cut_from(loop, "3", at(4))[0].cause, CutCause::Fold);
}

TEST(CutOut, OfATailIsAnEnd)
{
    const auto behind = cut_from(test::open_curve({{-6, 6}, {2, -2}, {0, -1}}), "3r");
    ASSERT_EQ(behind.size(), 1U);
    expect_stretch(behind[0], 2, 2, CutCause::End);
    EXPECT_EQ(behind[0].place, SectionPoint(2, -2));
    EXPECT_EQ(behind[0].rule, "E1");
    const auto front = cut_from(test::open_curve({{0, -1}, {-2, -2}, {6, 6}}), "3r");
    ASSERT_EQ(front.size(), 1U);
    expect_stretch(front[0], 0, 0, CutCause::End);
    EXPECT_EQ(front[0].place, SectionPoint(-2, -2));
    EXPECT_EQ(front[0].rule, "E2");
}

TEST(CutOut, IsAFoldWhereTheCrossingIsAVertex)
{
    const SectionCurve touching =
        test::open_curve({{-4, 4}, {0, 0}, {1, -1}, {0, -0.5}, {-1, -1}, {0, 0}, {4, 4}});
    for (const int kept : {1, 5}) {
        Trimmed trimmed;
        trimmed.curves.emplace_back();
        for (const int i : {0, kept, 6})
            trimmed.curves[0].points.push_back(
                {touching.points[i], {0, i}, {0, i}, TrimmedKind::Vertex});
        const auto cuts = cut_out({&touching, 1}, trimmed);
        ASSERT_EQ(cuts.size(), 1U);
        expect_stretch(cuts[0], kept == 1 ? 2 : 1, kept == 1 ? 5 : 4, CutCause::Fold);
        EXPECT_EQ(cuts[0].place, SectionPoint(0, 0));
    }
}

// The envelope of an overhang: from vertex 1 vertically down to segment 3.
TEST(CutOut, OfAVerticalStepIsAnEnd)
{
    const SectionCurve overhang =
        test::open_curve({{-4, 4}, {2, 1}, {1, 1.25}, {0, 0.5}, {6, -2.5}});
    Trimmed trimmed;
    trimmed.curves.push_back({{{{-4, 4}, {0, 0}, {0, 0}, TrimmedKind::Vertex},
                               {{2, 1}, {0, 1}, {0, 1}, TrimmedKind::Vertex},
                               {{2, -0.5}, {0, 3}, {0, 1}, TrimmedKind::Link},
                               {{6, -2.5}, {0, 4}, {0, 4}, TrimmedKind::Vertex}}});
    const auto cuts = cut_out({&overhang, 1}, trimmed);
    ASSERT_EQ(cuts.size(), 1U);
    expect_stretch(cuts[0], 2, 3, CutCause::End);
    EXPECT_EQ(cuts[0].place, SectionPoint(2, -0.5));
    EXPECT_TRUE(cuts[0].rule.empty());
}

TEST(CutOut, OfWholeCurvesHasAPlaceOnlyBesideTrimmedCurves)
{
    const SectionCurve closed{{{0, 0}, {1, 1}, {1, -1}, {0, 0}}, true};
    Trimmed dropped;
    dropped.rules.push_back({0, 0, 3, "closed"});
    const auto whole = cut_out({&closed, 1}, dropped);
    ASSERT_EQ(whole.size(), 1U);
    expect_stretch(whole[0], 0, 3, CutCause::Closed);
    EXPECT_FALSE(whole[0].place);
    EXPECT_EQ(whole[0].rule, "closed");
    const auto open = cut_out({&loop, 1}, {});
    ASSERT_EQ(open.size(), 1U);
    expect_stretch(open[0], 0, 4, CutCause::End);
    EXPECT_FALSE(open[0].place);
}

// The ends of a closed curve are one point; the result may contain either of them.
TEST(CutOut, TakesTheEndsOfAClosedCurveForOne)
{
    const SectionCurve closed{{{0, 0}, {1, 1}, {2, 0}, {1, -1}, {0, 0}}, true};
    Trimmed trimmed;
    trimmed.curves.push_back({{{{0, 0}, {0, 4}, {0, 4}, TrimmedKind::Vertex},
                               {{1, 1}, {0, 1}, {0, 1}, TrimmedKind::Vertex},
                               {{2, 0}, {0, 2}, {0, 2}, TrimmedKind::Vertex}}});
    const auto cuts = cut_out({&closed, 1}, trimmed);
    ASSERT_EQ(cuts.size(), 1U);
    expect_stretch(cuts[0], 3, 3, CutCause::End);
}

TEST(CutOut, HasExactlyTheRemovedPoints)
{
    for (const OffsetProfile& profile : hard_profiles()) {
        SCOPED_TRACE(profile.name);
        const SectionCurve curve = offset_curve(profile, 401);
        for (const CutOut& cut : cut_from(curve, "envelope"))
            EXPECT_EQ(cut.rule, "below the envelope");
        for (const CutOut& cut : cut_from(curve, "winding"))
            EXPECT_EQ(cut.rule, "winding number");
        const Trimmed trimmed = test::trim("3r", curve);
        std::vector<bool> seen(curve.points.size(), false);
        for (const TrimmedPoint& point : trimmed.curves.at(0).points) {
            if (point.kind == TrimmedKind::Vertex)
                seen[point.on.point] = true;
        }
        int crossings = 0;
        for (const CutOut& cut : cut_out({&curve, 1}, trimmed)) {
            crossings += cut.cause == CutCause::Fold;
            EXPECT_FALSE(cut.rule.empty());
            for (int i = cut.first_point; i <= cut.last_point; ++i) {
                EXPECT_FALSE(seen[i]);
                seen[i] = true;
            }
        }
        EXPECT_EQ(std::count(seen.begin(), seen.end(), false), 0);
        // Two crossings on one segment bound the same stretch of points.
        int bounds = 0;
        const auto& points = trimmed.curves[0].points;
        for (std::size_t i = 1; i < points.size(); ++i)
            bounds += points[i].kind == TrimmedKind::Crossing &&
                      points[i - 1].kind == TrimmedKind::Vertex;
        EXPECT_EQ(crossings, bounds);
    }
}

// The curve is clipped inside the segments 0 and 2, at the ends of a range.
TEST(CutOut, OutsideTheRangeEndsAtTheEndOfTheRange)
{
    const SectionCurve roof = test::open_curve({{0, 0}, {4, 4}, {8, 4}, {12, 0}});
    Trimmed trimmed = test::trim("envelope", roof);
    trimmed.curves = clipped(trimmed.curves, {1, 10});
    const auto cuts = cut_out({&roof, 1}, trimmed);
    ASSERT_EQ(cuts.size(), 2U);
    expect_stretch(cuts[0], 0, 0, CutCause::End);
    EXPECT_EQ(cuts[0].place, SectionPoint(1, 1));
    expect_stretch(cuts[1], 3, 3, CutCause::End);
    EXPECT_EQ(cuts[1].place, SectionPoint(10, 2));
    // The same for a piece of a single segment, which contains no vertex.
    trimmed.curves = clipped(trimmed.curves, {5, 7});
    const auto all = cut_out({&roof, 1}, trimmed);
    ASSERT_EQ(all.size(), 1U);
    expect_stretch(all[0], 0, 3, CutCause::End);
    EXPECT_EQ(all[0].place, SectionPoint(5, 4));
}

// A crossing that was moved past a vertex, and an end that was moved upwards.
TEST(CutOut, NamesPlacesAsTheyAreInTheResult)
{
    const SectionCurve folded = test::open_curve(
        {{-6, 6}, {-1, 1}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}, {7, 6}, {6.5, 7}});
    Trimmed trimmed = test::trim("3r", folded);
    auto& points = trimmed.curves.at(0).points;
    ASSERT_EQ(points.size(), 5U);
    ASSERT_EQ(points[2].kind, TrimmedKind::Crossing);
    points[2].at = {-1.5, 1.5};
    points[4].at = {7, 6.25};
    points.erase(points.begin() + 1);
    const auto cuts = cut_out({&folded, 1}, trimmed);
    ASSERT_EQ(cuts.size(), 2U);
    expect_stretch(cuts[0], 1, 4, CutCause::Fold);
    EXPECT_EQ(cuts[0].place, SectionPoint(-1.5, 1.5));
    expect_stretch(cuts[1], 7, 7, CutCause::End);
    EXPECT_EQ(cuts[1].place, SectionPoint(7, 6.25));
}

TEST(CutOut, NamesCausesAsInFiles)
{
    EXPECT_EQ(name(CutCause::Fold), "fold");
    EXPECT_EQ(name(CutCause::Crease), "crease");
    EXPECT_EQ(name(CutCause::End), "end");
    EXPECT_EQ(name(CutCause::Closed), "closed");
}

// A plane across a roof turned upside down: each vertex of the section whose mesh edge
// ends on the valley belongs to the crease, and no other.
TEST(CreaseTest, HoldsForEdgesThatEndOnAConcaveCrease)
{
    OffsetMesh offset{{}, {}, Cutter::ball(1), 0, 0, {}};
    for (const ContactKind kind : {ContactKind::Face, ContactKind::ConcaveCrease,
                                   ContactKind::Face, ContactKind::Face})
        offset.contacts.emplace_back(SurfacePoint{}, Vec3::UnitZ(), 0, kind);
    PlaneSection section;
    section.edges = {{{0, 2}, {0, 1}}, {{1, 3}, {2, 3}}};
    const CreaseTest is_on_crease = crease_test(offset, section);
    EXPECT_FALSE(is_on_crease({0, 0}));
    EXPECT_TRUE(is_on_crease({0, 1}));
    EXPECT_TRUE(is_on_crease({1, 0}));
    EXPECT_FALSE(is_on_crease({1, 1}));
}

}  // namespace
}  // namespace endmill
