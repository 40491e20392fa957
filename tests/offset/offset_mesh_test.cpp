// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/offset_mesh.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/cutter/cutter.h"
#include "grid_mesh.h"
#include "offset_parts.h"
#include "revolved_surfaces.h"

namespace endmill {
namespace {

constexpr auto paper = BoundaryContact::None;

DrivePlanes planes_over(std::span<const Surface> part, double degrees, int count)
{
    const DriveFrame frame{Angle::degrees(degrees)};
    return drive_planes(frame, extent_across(part, frame), count);
}

TEST(OffsetMesh, OfAPlaneIsThePlaneAboveForEachCutter)
{
    const std::vector part{test::parallelogram({40, 0, 30}, {0, 20, 0})};
    const Vec3 normal = Vec3{-30, 0, 40}.normalized();
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 2}, Cutter::flat(5)}) {
        const OffsetMesh offset =
            offset_mesh(part, cutter, {.grid_lines = 7, .boundary = paper});
        ASSERT_EQ(offset.mesh.points().size(), 49U);
        ASSERT_EQ(offset.mesh.triangles().size(), 72U);
        EXPECT_EQ(offset.part_triangles, 72U);
        const double above =
            cutter.corner_radius() + cutter.flat_radius() * 0.6;  // sine of the slope
        for (const Vec3& point : offset.mesh.points())
            EXPECT_NEAR(point.dot(normal), above, 1e-12 * 50);
    }
}

TEST(OffsetMesh, HasTheContactsOfItsGridLines)
{
    const std::vector part{test::random_surface(4, {1, 1}, 1)};
    const OffsetMesh offset =
        offset_mesh(part, Cutter{3, 1}, {.grid_lines = 5, .boundary = paper});
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i) {
            const int vertex = 5 * j + i;
            const OffsetContact& contact = offset.contacts[vertex];
            EXPECT_EQ(contact.at.u, i / 4.0);
            EXPECT_EQ(contact.at.v, j / 4.0);
            EXPECT_EQ(contact.kind, ContactKind::Face);
            const SurfaceTangents tangents = part[0].tangents(i / 4.0, j / 4.0);
            EXPECT_LE((contact.normal - unit_normal(tangents)).norm(), 1e-14);
            EXPECT_LE((contact_point(offset, vertex) - tangents.point).norm(), 1e-12);
        }
    EXPECT_EQ(offset.mesh.triangles()[0], (Triangle{0, 1, 6}));
    EXPECT_EQ(offset.mesh.triangles()[1], (Triangle{0, 6, 5}));
}

TEST(OffsetMesh, OfAMirroredSurfaceIsTurnedToTheTool)
{
    // the normal points down
    const std::vector part{test::parallelogram({0, 20, 0}, {40, 0, 0})};
    const OffsetMesh offset = offset_mesh(part, Cutter::ball(2), {.grid_lines = 4});
    for (std::size_t k = 0; k < offset.surface_triangles; ++k) {
        const auto [a, b, c] = offset.mesh.corners(k);
        EXPECT_GT((b - a).cross(c - a).z(), 0);
        EXPECT_EQ(a.z(), 2);
    }
    EXPECT_EQ(test::rims(offset), 1);
}

// The counts of docs/methods/interference.md, section 3: the offset of the valley for
// a ball of radius 10, with 200 by 200 points and 100 planes. They count whole cells; the
// slicer visits fewer triangles.
class OffsetOfTheValley : public testing::TestWithParam<double> {
protected:
    std::vector<Surface> part{test::narrowing_valley()};
    OffsetMesh offset = offset_mesh(part, Cutter::ball(10), {.boundary = paper});
    DrivePlanes planes = planes_over(part, GetParam(), 100);

    // The number of planes that meet the vertices of columns i and i + 1 and of rows j …
    // last.
    std::size_t planes_across(int i, int j, int last) const
    {
        Interval range{INFINITY, -INFINITY};
        for (int row = j; row <= last; ++row)
            for (const int column : {i, i + 1}) {
                const double t =
                    planes.frame.across(offset.mesh.points()[200 * row + column]);
                range = {std::min(range.low, t), std::max(range.high, t)};
            }
        return static_cast<std::size_t>(
            std::ranges::count_if(planes.positions, [&](double position) {
                return range.low <= position && position <= range.high;
            }));
    }
};

TEST_P(OffsetOfTheValley, IsCulledToTheListedCounts)
{
    std::size_t strips = 0;
    std::size_t cells = 0;
    for (int i = 0; i < 199; ++i) {
        strips += planes_across(i, 0, 199);
        for (int j = 0; j < 199; ++j)
            cells += planes_across(i, j, j + 1);
    }
    EXPECT_EQ(2 * cells, GetParam() == 0 ? 42908U : 38774U);
    EXPECT_NEAR(static_cast<double>(strips) / 19900, GetParam() == 0 ? 0.978 : 0.785,
                5e-4);
    std::size_t crossed = 0;
    for (const PlaneSection& section : slice(offset.mesh, planes))
        crossed += section.crossed_triangles;
    EXPECT_LE(crossed, 2 * cells);
    EXPECT_GT(crossed, cells);
}

// Without contact on the border each point is the offset of its contact: its distance is
// the radius, and the range of the path contains the part.
TEST_P(OffsetOfTheValley, HasSectionsOverThePart)
{
    const auto sections = slice(offset.mesh, planes);
    const auto ranges = path_ranges(offset, planes, sections);
    std::size_t curves = 0;
    for (std::size_t k = 0; k < 100; ++k) {
        curves += sections[k].curves.size();
        ASSERT_TRUE(ranges[k]);
        if (GetParam() == 0) {
            EXPECT_LE(ranges[k]->low, 1e-9);
            EXPECT_GE(ranges[k]->high, 100 - 1e-9);
        }
    }
    EXPECT_GE(curves, 99U);
    EXPECT_LE(curves, 104U);
}

INSTANTIATE_TEST_SUITE_P(Straight, OffsetOfTheValley, testing::Values(0.0, -15.0));

double distance_to_rectangle(const Vec3& point, double x, double y)
{
    const Vec3 nearest{std::clamp(point.x(), 0.0, x), std::clamp(point.y(), 0.0, y), 0};
    return (point - nearest).norm();
}

// The offset of a rectangle with its border is the upper half of all points at distance
// R. Its rim is as long as the rounded rectangle.
TEST(OffsetMesh, OfARectangleIsRoundedAtBorderAndCorners)
{
    const std::vector part{test::plane(30, 20)};
    const OffsetMesh offset = offset_mesh(part, Cutter::ball(4), {.grid_lines = 6});
    for (const Vec3& point : offset.mesh.points())
        EXPECT_NEAR(distance_to_rectangle(point, 30, 20), 4, 1e-13);
    for (std::size_t k = 0; k < offset.mesh.triangles().size(); ++k) {
        const auto [a, b, c] = offset.mesh.corners(k);
        const double middle = distance_to_rectangle((a + b + c) / 3, 30, 20);
        EXPECT_LE(middle, 4 + 1e-13);
        EXPECT_GE(middle, 4 - 2e-3);  // one chord error in each direction
    }
    EXPECT_EQ(test::rims(offset), 1);
    double rim = 0;
    for (const auto& [edge, use] : test::edge_uses_of(offset.mesh))
        if (use.count == 1)
            rim += (offset.mesh.points()[edge.first] - offset.mesh.points()[edge.second])
                       .norm();
    const double expected = 100 + 8 * std::numbers::pi;
    EXPECT_LE(rim, expected);
    EXPECT_GE(rim, expected - 0.01);
    EXPECT_EQ(offset.part_triangles, 50U);
}

// Strips turn the normal over one contact, so that they contribute nothing to the part.
TEST(OffsetMesh, GivesThePartItselfBack)
{
    const std::vector part{test::plane(30, 20)};
    const DrivePlanes planes = planes_over(part, 30, 5);
    for (const Cutter& cutter : {Cutter::ball(4), Cutter{4, 1}, Cutter::flat(4)}) {
        const TriangleMesh mesh =
            contact_mesh(offset_mesh(part, cutter, {.grid_lines = 6, .allowance = 0.5}));
        EXPECT_EQ(mesh.triangles().size(), 50U);
        for (const Vec3& point : mesh.points())
            EXPECT_NEAR(distance_to_rectangle(point, 30, 20), 0, 1e-13);
        for (const PlaneSection& section : slice(mesh, planes)) {
            ASSERT_EQ(section.curves.size(), 1U);
            EXPECT_FALSE(section.curves[0].is_closed);
        }
    }
}

TEST(OffsetMesh, WithAllowanceStandsOffByIt)
{
    const std::vector part{test::plane(30, 20)};
    const OffsetMesh offset =
        offset_mesh(part, Cutter::ball(4), {.grid_lines = 6, .allowance = 0.5});
    for (const Vec3& point : offset.mesh.points())
        EXPECT_NEAR(distance_to_rectangle(point, 30, 20), 4.5, 1e-13);
}

// A flat cutter around a level rectangle: its middle reaches R beyond the border and
// keeps its height.
TEST(OffsetMesh, OfARectangleForAFlatCutterIsLevel)
{
    const std::vector part{test::plane(30, 20)};
    const OffsetMesh offset = offset_mesh(part, Cutter::flat(4), {.grid_lines = 6});
    Interval x{0, 0};
    for (const Vec3& point : offset.mesh.points()) {
        EXPECT_EQ(point.z(), 0);
        EXPECT_LE(distance_to_rectangle(point, 30, 20), 4 + 1e-13);
        x = {std::min(x.low, point.x()), std::max(x.high, point.x())};
    }
    EXPECT_NEAR(x.low, -4, 1e-13);
    EXPECT_NEAR(x.high, 34, 1e-13);
    EXPECT_EQ(test::rims(offset), 1);
}

// The border of a curved part: every vertex of a strip is at distance R from its own
// edge, with any cutter.
TEST(OffsetMesh, StripsOfTheValleyKeepTheirContact)
{
    const std::vector part{test::narrowing_valley()};
    for (const Cutter& cutter : {Cutter::ball(10), Cutter{10, 3}, Cutter::flat(10)}) {
        const OffsetMesh offset = offset_mesh(part, cutter, {.grid_lines = 10});
        EXPECT_EQ(test::rims(offset), 1);
        for (std::size_t k = 100; k < offset.contacts.size(); ++k) {
            const OffsetContact& contact = offset.contacts[k];
            const Vec3 edge = part[0].tangents(contact.at.u, contact.at.v).point;
            const auto vertex = static_cast<std::int32_t>(k);
            EXPECT_EQ(contact.kind, ContactKind::Border);
            EXPECT_LE((contact_point(offset, vertex) - edge).norm(), 1e-12);
            EXPECT_NEAR(contact.normal.norm(), 1, 1e-14);
            if (cutter.is_ball()) {
                EXPECT_NEAR((offset.mesh.points()[k] - edge).norm(), 10, 1e-12);
            }
        }
    }
}

// Over a ridge a pipe closes the gap: the section is an arc about the edge.
TEST(OffsetMesh, OverAConvexCreaseIsAPipe)
{
    const std::vector part{test::valley(20, 10, -0.5)};
    const OffsetMesh offset = offset_mesh(part, Cutter::ball(3), {.grid_lines = 6});
    EXPECT_EQ(test::rims(offset), 1);
    EXPECT_GT(offset.part_triangles, offset.surface_triangles);
    const auto section = slice(offset.mesh, {DriveFrame{Angle::degrees(0)}, {4.9}},
                               {.part_triangles = offset.part_triangles})[0];
    ASSERT_EQ(section.curves.size(), 1U);
    int on_pipe = 0;
    for (const SectionPoint& point : section.curves[0].points) {
        const double half = 3 * 0.5 / std::sqrt(1.25);  // end of the pipe
        if (std::abs(point.x()) < half - 1e-9) {
            EXPECT_NEAR(point.norm(), 3, 1e-3);
            EXPECT_LE(point.norm(), 3 + 1e-12);
            ++on_pipe;
        }
    }
    EXPECT_GT(on_pipe, 15);
    std::size_t kinds = 0;
    for (const OffsetContact& contact : offset.contacts)
        kinds += contact.kind == ContactKind::ConvexCrease ? 1 : 0;
    EXPECT_GT(kinds, 12U);
    EXPECT_EQ(test::runs_of_s(section.curves[0]), 1);
}

// In a valley the grids cross R sqrt(1 + slope^2) above its bottom, and the strip closes
// the loop below.
TEST(OffsetMesh, OverAConcaveCreaseCrossesAboveIt)
{
    const std::vector part{test::valley(20, 10, 0.5)};
    const OffsetMesh offset = offset_mesh(part, Cutter::ball(3), {.grid_lines = 6});
    EXPECT_EQ(test::rims(offset), 1);
    const auto section = slice(offset.mesh, {DriveFrame{Angle::degrees(0)}, {4.9}})[0];
    ASSERT_EQ(section.curves.size(), 1U);
    const auto crossings = test::crossings(section.curves[0]);
    ASSERT_EQ(crossings.size(), 1U);
    EXPECT_NEAR(crossings[0].x(), 0, 1e-13);
    EXPECT_NEAR(crossings[0].y(), 3 * std::sqrt(1.25), 1e-12);
    bool holds_crease = false;
    for (const CrossedEdge& edge : section.edges[0])
        holds_crease = holds_crease ||
                       offset.contacts[edge.below].kind == ContactKind::ConcaveCrease;
    EXPECT_TRUE(holds_crease);
    const OffsetMesh apart =
        offset_mesh(part, Cutter::ball(3), {.grid_lines = 6, .boundary = paper});
    EXPECT_EQ(slice(apart.mesh, {DriveFrame{Angle::degrees(0)}, {4.9}})[0].curves.size(),
              2U);
}

// Creases between patches of one surface and between surfaces give the same result.
TEST(OffsetMesh, ClosesTheTopOfAPyramid)
{
    for (const double slope : {0.4, -0.4}) {
        const auto part = test::pyramid(10, slope);
        for (const Cutter& cutter : {Cutter::ball(2), Cutter{2, 0.5}, Cutter::flat(2)}) {
            const OffsetMesh offset =
                offset_mesh(part, cutter, {.grid_lines = 4, .arc_tolerance = 1e-2});
            EXPECT_EQ(test::rims(offset), 1);
        }
        const OffsetMesh offset = offset_mesh(part, Cutter::ball(2), {.grid_lines = 4});
        double nearest = INFINITY;
        for (std::size_t k = 0; k < offset.part_triangles; ++k) {
            const auto [a, b, c] = offset.mesh.corners(k);
            const Vec3 middle = (a + b + c) / 3;
            if (slope > 0 && std::max(std::abs(middle.x()), std::abs(middle.y())) < 0.2) {
                EXPECT_NEAR(middle.norm(), 2, 2e-3);  // the ball around the top
                nearest = std::min(nearest, middle.norm());
            }
        }
        if (slope > 0) {
            EXPECT_LT(nearest, 2);
        }
    }
}

TEST(OffsetMesh, IsOneSheetAcrossSmoothJoints)
{
    const auto level = test::pyramid(10, 0);
    for (const auto boundary : {BoundaryContact::Contact, paper}) {
        const OffsetMesh offset =
            offset_mesh(level, Cutter::ball(2), {.grid_lines = 4, .boundary = boundary});
        EXPECT_EQ(offset.part_triangles, 72U);
        EXPECT_EQ(offset.surface_triangles, 72U);
        const auto section = slice(offset.mesh, {DriveFrame{Angle::degrees(10)}, {0.1}},
                                   {.part_triangles = offset.part_triangles})[0];
        EXPECT_EQ(section.curves.size(), 1U);
        if (boundary != paper) {
            EXPECT_EQ(test::rims(offset), 1);
        }
    }
}

// Three of four facets; at the inner corner the border turns the other way.
TEST(OffsetMesh, GoesRoundAReentrantCorner)
{
    for (const double slope : {0.0, 0.4, -0.4}) {
        auto part = test::pyramid(10, slope);
        part.pop_back();
        EXPECT_EQ(test::rims(offset_mesh(part, Cutter::ball(2), {.grid_lines = 4})), 1);
    }
}

TEST(OffsetMesh, HasARimForEachBorder)
{
    // Half of a torus, closed around its ring.
    const Surface ring = nurbs_surface(
        test::torus(40, 15, {0, 2 * std::numbers::pi, 0.3, std::numbers::pi - 0.3, 4}));
    const std::vector part{ring};
    const OffsetMesh offset = offset_mesh(part, Cutter::ball(5), {.grid_lines = 40});
    EXPECT_EQ(test::rims(offset), 2);
    for (const Vec3& point : offset.mesh.points()) {
        const double far = std::hypot(point.x(), point.y()) - 40;
        EXPECT_NEAR(std::hypot(far, point.z()), 20, 5.1);
    }
    // Two parts that do not touch.
    std::vector two{test::plane(10, 10)};
    two.push_back(test::facet({{20, 30}, {0, 10}}, [](double, double) { return 3.0; }));
    EXPECT_EQ(test::rims(offset_mesh(two, Cutter::ball(2), {.grid_lines = 3})), 2);
}

// A triangle: one side of the patch is a point.
TEST(OffsetMesh, ClosesACollapsedSide)
{
    const std::vector<Vec3> net{{0, 0, 0}, {0, 0, 0}, {10, -5, 3}, {10, 5, 3}};
    const std::vector part{Surface{{0, 1}, {0, 1}, {BezierPatch{1, 1, net}}}};
    for (const Cutter& cutter : {Cutter::ball(2), Cutter{2, 1}}) {
        const OffsetMesh offset = offset_mesh(part, cutter, {.grid_lines = 5});
        EXPECT_EQ(test::rims(offset), 1);
        EXPECT_LT(offset.surface_triangles, 32U);
    }
}

// Inner borders become grid lines where the surface is not continuously differentiable.
TEST(OffsetMesh, TakesKinksAsGridLines)
{
    const std::vector smooth{test::plane(30, 20, {3, 2})};
    EXPECT_EQ(offset_mesh(smooth, Cutter::ball(2), {.grid_lines = 5, .boundary = paper})
                  .mesh.points()
                  .size(),
              25U);
    // A plane whose parametrisation changes its speed at x = 10.
    const auto piece = [](double low, double high) {
        const std::vector<Vec3> net{
            {low, 0, 0}, {high, 0, 0}, {low, 20, 0}, {high, 20, 0}};
        return BezierPatch{1, 1, net};
    };
    const std::vector kinked{Surface{{0, 1, 2}, {0, 1}, {piece(0, 10), piece(10, 40)}}};
    const OffsetMesh offset =
        offset_mesh(kinked, Cutter::ball(2), {.grid_lines = 4, .boundary = paper});
    EXPECT_EQ(offset.mesh.points().size(), 20U);
    EXPECT_EQ(offset.mesh.points()[2].x(), 10);
}

// Over an isolated crest with radii 30 and 20 a bull-nose cutter rests on the top, and
// its reference point is at height r. The mesh is too low there by an error of order 1.5.
TEST(OffsetMesh, OverALevelCrestIsTooLowByOrderOneAndAHalf)
{
    const std::vector part{
        test::graph(test::monomial(2, 0, -1.0 / 60) + test::monomial(0, 2, -1.0 / 40),
                    {{-12.3, 11.7}, {-11.9, 12.1}})};
    const DrivePlanes planes = planes_over(part, 0, 97);
    std::vector<double> errors;
    for (const int lines : {21, 41, 81, 161}) {
        const OffsetMesh offset =
            offset_mesh(part, Cutter{10, 3}, {.grid_lines = lines, .boundary = paper});
        const auto sections = slice(offset.mesh, planes);
        double lowest = 3;
        for (std::size_t k = 0; k < sections.size(); ++k)
            for (const SectionCurve& curve : sections[k].curves)
                for (const SectionPoint& point : curve.points) {
                    EXPECT_LE(point.y(), 3 + 1e-12);
                    // The middle of the bottom, of radius 7, is over the top.
                    if (std::hypot(point.x(), planes.positions[k]) < 6.99)
                        lowest = std::min(lowest, point.y());
                }
        errors.push_back(3 - lowest);
    }
    for (std::size_t k = 1; k < errors.size(); ++k)
        EXPECT_NEAR(std::log2(errors[k - 1] / errors[k]), 1.5, 0.25);
}

TEST(OffsetMesh, DoesNotDependOnThreads)
{
    const auto part = test::pyramid(10, -0.4);
    std::vector<OffsetMesh> offsets;
    for (const int threads : {1, 4}) {
        set_thread_count(threads);
        offsets.push_back(offset_mesh(part, Cutter{2, 0.5}, {.grid_lines = 50}));
    }
    EXPECT_TRUE(std::ranges::equal(offsets[0].mesh.points(), offsets[1].mesh.points()));
    EXPECT_TRUE(
        std::ranges::equal(offsets[0].mesh.triangles(), offsets[1].mesh.triangles()));
}

TEST(OffsetMesh, RefusesSurfacesUnreachableFromAbove)
{
    // x = 3 u^2 - u^3 - u reverses near u = 0, and the normal points down there.
    const std::vector part{test::polynomial_surface(
        {test::monomial(2, 0, 3) + test::monomial(1, 0, -1) + test::monomial(3, 0, -1),
         test::monomial(0, 1, 1), test::monomial(1, 0, 1)},
        {{0, 1}, {0, 1}})};
    try {
        offset_mesh(part, Cutter::ball(1));
        FAIL() << "an overhang is refused";
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string{error.what()}.find("u = "), std::string::npos);
    }
    const std::vector upright{test::parallelogram({1, 0, 0}, {0, 0, 1})};
    EXPECT_THROW(offset_mesh(upright, Cutter::ball(1)), GeometryError);
}

TEST(OffsetMesh, RefusesUnsupportedInput)
{
    const std::vector part{test::plane(1, 1)};
    const Cutter ball = Cutter::ball(1);
    EXPECT_THROW(offset_mesh({}, ball), DomainError);
    EXPECT_THROW(offset_mesh(part, ball, {.grid_lines = 1}), DomainError);
    EXPECT_THROW(offset_mesh(part, ball, {.allowance = -1}), DomainError);
    EXPECT_THROW(offset_mesh(part, ball, {.arc_tolerance = 0}), DomainError);
    EXPECT_THROW(offset_mesh(part, ball, {.grid_lines = 2'000'000'000}), LimitError);
    // at each corner the normal takes all directions of a quarter of a sphere
    EXPECT_THROW(offset_mesh(part, ball, {.grid_lines = 3, .allowance = 1e6}),
                 LimitError);
}

}  // namespace
}  // namespace endmill
