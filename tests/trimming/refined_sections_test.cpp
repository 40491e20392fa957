// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/refined_sections.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/trimming/detail/envelope_trimming.h"
#include "test_surfaces.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

const DriveFrame along_x{Angle::degrees(0)};

// z = x^2 / 8, cut in the plane y = 3 by a ball that is too large for its bottom.
struct Trough {
    explicit Trough(BoundaryContact boundary = BoundaryContact::Contact)
        : offset{offset_mesh(part, Cutter::ball(7),
                             {.grid_lines = 21, .boundary = boundary})},
          section{slice(offset.mesh, DrivePlanes{along_x, {3}}, {offset.part_triangles})
                      .front()},
          curves{envelope_trimming(section.curves, {}).curves}
    {
    }

    RefinedCurves refine(const std::vector<TrimmedCurve>& trimmed) const
    {
        FinerPieces finer;
        return refined({section, {along_x, 3}, offset, drop, finish}, trimmed, finer);
    }

    std::vector<Surface> part{test::parabolic_cylinder(0.25, 12, 10)};
    OffsetMesh offset;
    PlaneSection section;
    std::vector<TrimmedCurve> curves;
    SmoothDrop drop{part, Cutter::ball(7)};
    std::function<void(std::size_t points)> finish = [](std::size_t) {};
};

TEST(RefinedSections, PutTheCrossingWhereTheClosedFormHasIt)
{
    // Closed form (docs/methods/interference.md, section 11): the crossing is q = (0, p / 2 + R^2 / (2 p)), here with p = 4 and R =
    // 7.
    const Trough trough;
    const RefinedCurves result = trough.refine(trough.curves);
    int crossings = 0;
    for (const TrimmedPoint& point : result.curves[0].points)
        if (point.kind == TrimmedKind::Crossing) {
            ++crossings;
            EXPECT_NEAR(point.at.x(), 0, 1e-8);
            EXPECT_NEAR(point.at.y(), 2 + 49.0 / 8, 1e-8);
        }
    EXPECT_EQ(crossings, 1);
}

TEST(RefinedSections, PutInACrossingThatWasNotSampled)
{
    const Trough trough;
    std::vector<TrimmedCurve> curves = trough.curves;
    std::erase_if(curves[0].points, [](const TrimmedPoint& point) {
        return point.kind == TrimmedKind::Crossing;
    });
    const RefinedCurves result = trough.refine(curves);
    const auto& points = result.curves[0].points;
    const auto found =
        std::ranges::find(points, TrimmedKind::Crossing, &TrimmedPoint::kind);
    ASSERT_NE(found, points.end());
    EXPECT_NEAR(found->at.y(), 2 + 49.0 / 8, 1e-8);
}

TEST(RefinedSections, StillRunForwards)
{
    const Trough trough;
    const RefinedCurves result = trough.refine(trough.curves);
    const auto& points = result.curves[0].points;
    for (std::size_t k = 1; k < points.size(); ++k)
        EXPECT_LE(points[k - 1].at.x(), points[k].at.x());
}

TEST(RefinedSections, KeepFoldsThatAMethodLeft)
{
    // Nothing is trimmed: the tails below the crossing are not at the height of the
    // cutter.
    const Trough trough;
    std::vector<TrimmedCurve> whole;
    for (std::size_t c = 0; c < trough.section.curves.size(); ++c) {
        auto& curve = whole.emplace_back();
        const auto& points = trough.section.curves[c].points;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const SegmentNumber on{static_cast<std::int32_t>(c),
                                   static_cast<std::int32_t>(k)};
            curve.points.push_back({points[k], on, on, TrimmedKind::Vertex});
        }
    }
    const RefinedCurves result = trough.refine(whole);
    EXPECT_GT(result.refined, 0U);
    EXPECT_GT(result.unrefined, 0U);
    for (const TrimmedPoint& point : whole[0].points)
        if (std::abs(point.at.x()) < 1 && point.at.y() < 7.9) {
            const auto is_kept = [&](const TrimmedPoint& other) {
                return other.at == point.at;
            };
            EXPECT_TRUE(std::ranges::any_of(result.curves[0].points, is_kept));
        }
}

TEST(RefinedSections, TouchNoEdgeIfTheOffsetHasNone)
{
    const Trough bare{BoundaryContact::None};
    const RefinedCurves result = bare.refine(bare.curves);
    EXPECT_GT(result.refined, 10U);
    // Closed form of the height over the faces alone: the contact at x is 7 mm from the
    // centre.
    for (const TrimmedPoint& point : result.curves[0].points) {
        double least = 1e300;
        for (double x = -12; x <= 12; x += 1e-3)
            least =
                std::min(least, std::hypot(x - point.at.x(), x * x / 8 - point.at.y()));
        EXPECT_GT(least, 7 - 1e-4);
    }
}

TEST(RefinedSections, EstimateTheirShiftWithoutRefining)
{
    const Trough trough;
    FinerPieces finer;
    const SampledSection sampled{
        trough.section, {along_x, 3}, trough.offset, trough.drop, trough.finish};
    const double shift = trough.refine(trough.curves).greatest_shift;
    EXPECT_GT(shift, 1e-3);
    EXPECT_DOUBLE_EQ(greatest_shift(sampled, trough.curves, 0, finer), shift);
    EXPECT_EQ(greatest_shift(sampled, trough.curves, 100, finer), 100);
}

}  // namespace
}  // namespace endmill
