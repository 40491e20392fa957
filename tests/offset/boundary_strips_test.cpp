// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/boundary_strips.h"

#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/trimming/detail/envelope_trimming.h"
#include "offset_parts.h"

namespace endmill {
namespace {

struct Strips {
    std::vector<GridSide> sides;
    OffsetDraft draft;
    std::vector<ContactChain> seams;
};

// Grid vertices with their own normals, then strips only.
Strips crease_strips(const std::vector<Surface>& part, int lines)
{
    const std::vector<double> tool_sides(part.size(), 1);
    const auto grids = offset_grids(part, tool_sides, lines);
    Strips strips{grid_sides(part, grids, 1e-6), {Cutter::ball(2), 1e-3, 1'000'000}, {}};
    for (const OffsetGrid& grid : grids)
        for (std::int32_t j = 0; j < grid.rows(); ++j)
            for (std::int32_t i = 0; i < grid.columns(); ++i) {
                const Surface& surface = part[grid.surface];
                const SurfaceTangents at = tangents_at(grid, surface, i, j);
                strips.draft.add(at.point, {{0, 0},
                                            normal_at(grid, surface, i, j, at),
                                            grid.surface,
                                            ContactKind::Face});
            }
    strips.seams = add_crease_strips(strips.sides, strips.draft);
    return strips;
}

// Signed volume in mm^3 between the strips and a point of the axis far below.
double volume_above(const OffsetDraft& draft, double depth)
{
    double volume = 0;
    for (const auto& [a, b, c] : draft.triangles) {
        const Vec3 down{0, 0, depth};
        volume += (draft.points[a] + down)
                      .cross(draft.points[b] + down)
                      .dot(draft.points[c] + down) /
                  6;
    }
    return volume;
}

// Strips over a convex crease face upwards, those over a concave crease downwards.
TEST(CreaseStrips, TurnWithTheCrease)
{
    EXPECT_GT(volume_above(crease_strips(test::pyramid(10, 0.3), 3).draft, 100), 0);
    EXPECT_LT(volume_above(crease_strips(test::pyramid(10, -0.3), 3).draft, 100), 0);
}

TEST(CreaseStrips, NameTheKindOfTheCrease)
{
    for (const double slope : {0.3, -0.3}) {
        const Strips strips = crease_strips(test::pyramid(10, slope), 3);
        std::size_t on_crease = 0;
        for (const OffsetContact& contact : strips.draft.contacts)
            if (contact.kind != ContactKind::Face) {
                EXPECT_EQ(contact.kind, slope > 0 ? ContactKind::ConvexCrease
                                                  : ContactKind::ConcaveCrease);
                ++on_crease;
            }
        // five vertices of each of four facets, and those of strips
        EXPECT_GT(on_crease, 20U);
    }
}

// The chain of a seam runs from the side's vertex to the mate's; for the mate it is
// reversed.
TEST(CreaseStrips, GiveTheChainsOverTheEndsOfSeams)
{
    const Strips strips = crease_strips(test::pyramid(10, 0.3), 3);
    for (std::size_t number = 0; number < strips.sides.size(); ++number) {
        const GridSide& side = strips.sides[number];
        if (side.is_border()) {
            EXPECT_TRUE(strips.seams[number].vertices.empty());
            continue;
        }
        const ContactChain& seam = strips.seams[number];
        EXPECT_EQ(seam.vertices.front(), side.vertices.front());
        EXPECT_EQ(seam.vertices.back(), strips.sides[side.mate].vertices.back());
        EXPECT_EQ(seam.shares.front(), 0);
        EXPECT_EQ(seam.shares.back(), 1);
    }
}

// A level square of 2 by 2 mm and the radius 2: a quarter pipe along each side and an
// eighth of a ball at each corner.
TEST(BorderStrips, AroundASquareAreQuarterPipesAndEighthsOfABall)
{
    const auto level = [](double, double) { return 0.0; };
    Strips strips = crease_strips({test::facet({{-1, 1}, {-1, 1}}, level)}, 3);
    EXPECT_TRUE(strips.draft.triangles.empty());
    add_border_strips(strips.sides, strips.seams, strips.draft);
    double area = 0;
    for (const auto& [a, b, c] : strips.draft.triangles) {
        const Vec3 normal = (strips.draft.points[b] - strips.draft.points[a])
                                .cross(strips.draft.points[c] - strips.draft.points[a]);
        EXPECT_GT(normal.dot(strips.draft.contacts[a].normal), 0);
        area += normal.norm() / 2;
    }
    const double expected = 4 * std::numbers::pi * 2 + 2 * std::numbers::pi * 4;
    EXPECT_NEAR(area, expected, 2e-3 * expected);
    EXPECT_LT(area, expected);
}

// Depth of a point in a cutter, `across` mm beside its axis and `below` mm below its
// reference point; negative outside.
double depth_in(const Cutter& cutter, double across, double below)
{
    const double r = cutter.corner_radius();
    const double beyond = across - cutter.flat_radius();  // the bottom circle
    if (below < 0)
        return std::min(r - below, cutter.radius() - across);
    return r - (beyond > 0 ? std::hypot(beyond, below) : below);
}

// The largest depth of the origin, the highest corner of a part, in the cutter at the
// points of the path and halfway between them, by the closed form.
double depth_over_corner(const Cutter& cutter, const std::vector<Surface>& part)
{
    OffsetOptions options;
    options.grid_lines = 11;
    const OffsetMesh offset = offset_mesh(part, cutter, options);
    DrivePlanes planes{DriveFrame{Angle::degrees(0)}, {}};
    for (double t = -9.97; t < 0; t += 0.37)
        planes.positions.push_back(t);
    double deepest = 0;
    for (std::size_t k = 0; const PlaneSection& section : slice(offset.mesh, planes)) {
        const double t = planes.positions[k++];
        const auto compare = [&](const SectionPoint& at) {
            const double across = std::hypot(at.x(), t);
            if (at.x() <= 0)
                deepest = std::max(deepest, depth_in(cutter, across, at.y()));
        };
        for (const TrimmedCurve& curve : envelope_trimming(section.curves).curves)
            for (std::size_t i = 1; i < curve.points.size(); ++i) {
                compare(curve.points[i].at);
                compare((curve.points[i - 1].at + curve.points[i].at) / 2);
            }
    }
    return deepest;
}

// Where the normal passes the axis, the bottom circle turns about it at once.
TEST(BoundaryStrips, KeepToTheirChordErrorOverCorners)
{
    // mm, see docs/methods/interference.md, section 2.5
    constexpr double chord_error = 1e-3;
    for (const Cutter& cutter : {Cutter::ball(10), Cutter::flat(10), Cutter{10, 3},
                                 Cutter{10, 0.5}, Cutter{10, 8}}) {
        SCOPED_TRACE(cutter.corner_radius());
        for (const SectionPoint& slope :
             {SectionPoint{0.6, 0.2}, SectionPoint{2, 0.3}, SectionPoint{0.05, 0.02}}) {
            const auto height = [&](double x, double y) {
                return slope.x() * x + slope.y() * y;
            };
            EXPECT_LE(
                depth_over_corner(cutter, {test::facet({{-10, 0}, {-10, 0}}, height)}),
                chord_error)
                << slope.transpose();
        }
        for (const double slope : {0.3, 1.5})
            EXPECT_LE(depth_over_corner(cutter, test::pyramid(10, slope)), chord_error)
                << slope;
    }
}

}  // namespace
}  // namespace endmill
