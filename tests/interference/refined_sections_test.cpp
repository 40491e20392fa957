// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/refined_sections.h"

#include <vector>

#include <gtest/gtest.h>

#include "endmill/interference/envelope_trimming.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr int grid = 21;
const DriveFrame along_x{Angle::degrees(0)};

// z = x^2 / 8 cut by a ball too large for its bottom, in the plane y = 3.
struct Trough {
    std::vector<Surface> part{test::parabolic_cylinder(0.25, 12, 10)};
    OffsetMesh offset = offset_mesh(part, Cutter::ball(7), {.grid_lines = grid});
    PlaneSection section =
        slice(offset.mesh, DrivePlanes{along_x, {3}}, {offset.own_triangles}).front();
    std::vector<TrimmedCurve> curves = envelope_trimming(section.curves, {}).curves;

    RefinedCurves refine(const IsAdmissible& is_admissible) const
    {
        return refined(curves, {section, 3}, along_x, SmoothOffset{offset, part, grid},
                       is_admissible);
    }
};

TEST(RefinedSections, KeepWhatIsNotAdmissible)
{
    const Trough trough;
    const RefinedCurves kept = trough.refine([](const Vec3&, double) { return false; });
    EXPECT_EQ(kept.refined, 0U);
    EXPECT_EQ(kept.greatest_shift, 0);
    ASSERT_EQ(kept.curves.size(), trough.curves.size());
    EXPECT_EQ(kept.unrefined, trough.curves[0].points.size());
    for (std::size_t k = 0; k < trough.curves[0].points.size(); ++k)
        EXPECT_EQ(kept.curves[0].points[k].at, trough.curves[0].points[k].at);
}

TEST(RefinedSections, AskAboutReferencePointsInThePlane)
{
    const Trough trough;
    trough.refine([](const Vec3& reference, double) {
        EXPECT_EQ(reference.y(), 3);
        return true;
    });
}

TEST(RefinedSections, PutTheCrossingWhereTheClosedFormHasIt)
{
    // Spec of interference, closed forms: q = (0, p / 2 + R^2 / (2 p)) with p = 4, R = 7.
    const RefinedCurves result = Trough{}.refine({});
    int crossings = 0;
    for (const TrimmedPoint& point : result.curves[0].points)
        if (point.kind == TrimmedKind::Crossing) {
            ++crossings;
            EXPECT_NEAR(point.at.x(), 0, 1e-8);
            EXPECT_NEAR(point.at.y(), 2 + 49.0 / 8, 1e-8);
        }
    EXPECT_EQ(crossings, 1);
}

TEST(RefinedSections, StillRunForwards)
{
    const RefinedCurves result = Trough{}.refine({});
    const auto& points = result.curves[0].points;
    for (std::size_t k = 1; k < points.size(); ++k)
        EXPECT_LE(points[k - 1].at.x(), points[k].at.x());
}

}  // namespace
}  // namespace endmill
