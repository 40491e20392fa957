// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/boundary_strips.h"

#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "offset_parts.h"

namespace endmill {
namespace {

struct Strips {
    std::vector<SheetSide> sides;
    OffsetDraft draft;
    std::vector<ContactChain> seams;
};

// Vertices of sheets by their own normals, then strips only.
Strips crease_strips(const std::vector<Surface>& part, int lines)
{
    const std::vector<double> tool_sides(part.size(), 1);
    const auto sheets = offset_sheets(part, tool_sides, lines);
    Strips strips{
        sheet_sides(part, sheets, 1e-6), {Cutter::ball(2), 1e-3, {}, {}, {}}, {}};
    for (const OffsetSheet& sheet : sheets)
        for (std::int32_t j = 0; j < sheet.rows(); ++j)
            for (std::int32_t i = 0; i < sheet.columns(); ++i) {
                const Surface& surface = part[sheet.surface];
                const SurfaceTangents at = tangents_at(sheet, surface, i, j);
                strips.draft.add(at.point, {{0, 0},
                                            normal_at(sheet, surface, i, j, at),
                                            sheet.surface,
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

// Strips over a convex crease look up, those over a concave one down.
TEST(CreaseStrips, TurnWithTheCrease)
{
    EXPECT_GT(volume_above(crease_strips(test::pyramid(10, 0.3), 3).draft, 100), 0);
    EXPECT_LT(volume_above(crease_strips(test::pyramid(10, -0.3), 3).draft, 100), 0);
}

TEST(CreaseStrips, SayWhatTheCreaseIsLike)
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
        EXPECT_GT(on_crease, 20U);  // five vertices of each of four facets, and strips
    }
}

// A seam's chain runs from the side's vertex to the mate's, back from the other side.
TEST(CreaseStrips, GiveTheChainsOverTheEndsOfSeams)
{
    const Strips strips = crease_strips(test::pyramid(10, 0.3), 3);
    for (std::size_t number = 0; number < strips.sides.size(); ++number) {
        const SheetSide& side = strips.sides[number];
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

// Around a level square of 2 by 2 and the radius 2: a quarter pipe along each side and an
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

}  // namespace
}  // namespace endmill
