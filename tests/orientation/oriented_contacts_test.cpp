// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/oriented_contacts.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/cutter/cutting_body.h"
#include "test_meshes.h"

namespace endmill {
namespace {

// A cap of a sphere of radius 30 over [-8, 8]^2.
TriangleMesh cap(int cells = 32)
{
    return test::grid_mesh(cells, cells, [&](int i, int j) {
        const double x = 16.0 * i / cells - 8;
        const double y = 16.0 * j / cells - 8;
        return Vec3{x, y, std::sqrt(900 - x * x - y * y) - 30};
    });
}

// Contacts on the sphere along the meridian y = 0.
ContactCurve meridian()
{
    ContactCurve curve;
    for (const double x : {-6.0, -2.0, 3.0, 7.0}) {
        const Vec3 normal = Vec3{x, 0, std::sqrt(900 - x * x)} / 30;
        curve.push_back({30 * normal - Vec3{0, 0, 30}, normal});
    }
    return curve;
}

PathPoint point_of(Move move, bool has_contact)
{
    PathPoint point{0, 0, move, 0, {Vec3::Zero(), Vec3::UnitZ()}};
    if (has_contact)
        point.known_contact = SurfaceContact{0, 0, {Vec3::Zero(), Vec3::UnitZ()}};
    return point;
}

TEST(ContactCurves, AreTheCutsBetweenLinks)
{
    ToolPath path;
    path.points = {point_of(Move::Plunge, true),  point_of(Move::Cut, true),
                   point_of(Move::Cut, true),     point_of(Move::Link, true),
                   point_of(Move::Cut, true),     point_of(Move::Retract, false),
                   point_of(Move::Rapid, false),  point_of(Move::Plunge, true),
                   point_of(Move::Retract, false)};
    const auto curves = contact_curves(path);
    ASSERT_EQ(curves.size(), 3U);
    EXPECT_EQ(curves[0].size(), 3U);
    EXPECT_EQ(curves[1].size(), 2U);
    EXPECT_EQ(curves[2].size(), 1U);
}

// The centre of a ball stays on the chords of the centres at the contacts.
TEST(OrientedContacts, MoveTheCentreOfABallStraight)
{
    const TriangleMesh mesh = cap();
    const MeshShape shape{mesh};
    const OrientedOptions options;
    const Cutter ball = Cutter::ball(4);
    const std::vector<ContactCurve> curves{meridian()};
    const OrientedContacts part{shape, curves, 0.05, ball, options};
    ASSERT_EQ(part.passes().size(), 1U);
    const PassLine line = part.passes().front();
    const auto centre = [](const CutterContact& at) {
        return Vec3{at.point + 4 * at.normal};
    };
    const auto& contacts = curves.front();
    double along = 0;
    for (std::size_t k = 1; k < contacts.size(); ++k) {
        const Vec3 from = centre(contacts[k - 1]);
        const Vec3 to = centre(contacts[k]);
        const double way = (to - from).norm();
        for (const double share : {0.0, 0.3, 1.0}) {
            const PassPlace at = part.place(along + share * way, line);
            EXPECT_NEAR((centre(at.at.contact) - (from + share * (to - from))).norm(), 0,
                        1e-9);
            EXPECT_NEAR(at.feed.dot(at.at.contact.normal), 0, 1e-12);
            EXPECT_GT(at.feed.x(), 0.9);
            EXPECT_EQ(at.at.u, at.at.contact.point.x());
            // a sphere
            EXPECT_NEAR(at.curvature.along, 1.0 / 30, 2e-3);
            EXPECT_NEAR(at.curvature.across, 1.0 / 30, 2e-3);
            EXPECT_NEAR(at.curvature.mixed, 0, 2e-3);
        }
        along += way;
    }
}

// The contacts of another cutter are on the mesh, and the normal turns evenly.
TEST(OrientedContacts, KeepOtherCuttersOnTheMesh)
{
    const TriangleMesh mesh = cap();
    const MeshShape shape{mesh};
    const OrientedOptions options;
    const Cutter bull{4, 1};
    const std::vector<ContactCurve> curves{meridian()};
    const OrientedContacts part{shape, curves, 0.05, bull, options};
    const PassLine line = part.passes().front();
    const double length = part.rows(line).back().place.along;
    for (double along = 0; along <= length; along += length / 13) {
        const CutterContact at = part.place(along, line).at.contact;
        // the chord error of cells of 0.5 mm is 0.5^2 / (4 * 30)
        EXPECT_NEAR((at.point + Vec3{0, 0, 30}).norm(), 30, 2.2e-3);
        EXPECT_NEAR((at.normal - (at.point + Vec3{0, 0, 30}).normalized()).norm(), 0,
                    5e-3);
    }
}

// The strips of the ball are nowhere wider than those of the cutter, and a cutter with a corner
// radius needs fewer passes than a ball.
TEST(OrientedContacts, AreLaidForTheStripsOfTheCutter)
{
    const TriangleMesh mesh = cap();
    const MeshShape shape{mesh};
    const ToolClearance clearance{mesh};
    OrientedOptions options;
    options.inclination.lead = Angle::degrees(5);
    options.safe_height = 10;
    options.mesh_passes.strategy = Strategy::Planar;
    options.mesh_passes.direction = Angle::degrees(0);
    const Cutter ball = Cutter::ball(4);
    const Cutter bull{4, 1};
    const LaidContacts laid_for_ball =
        oriented_contacts({shape, clearance, ball, options});
    const LaidContacts laid_for_bull =
        oriented_contacts({shape, clearance, bull, options});
    EXPECT_LT(static_cast<double>(laid_for_bull.passes),
              0.75 * static_cast<double>(laid_for_ball.passes));
    const OrientedContacts& of_bull = laid_for_bull.part;
    for (const PassLine& line : of_bull.passes())
        for (const PassPose& row : of_bull.rows(line))
            EXPECT_GE(row.strip_mm, 0.9 * of_bull.ruled(row.place, line).needed_strip_mm);
}

}  // namespace
}  // namespace endmill
