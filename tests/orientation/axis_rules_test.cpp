// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/axis_rules.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

// Level ground at z = 0, and a wall at y = 4 that is 30 mm high.
const TriangleMesh& floor_and_wall()
{
    static const TriangleMesh mesh{
        {{-50, -50, 0}, {50, -50, 0}, {50, 4, 0}, {-50, 4, 0}, {50, 4, 30}, {-50, 4, 30}},
        {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}}};
    return mesh;
}

class RulesBesideAWall : public testing::Test {
protected:
    // The broken rule at a contact at `y` mm with feed +x.
    static std::optional<AxisRule> broken(const RuledTool& tool, double y,
                                          double lead_deg, double tilt_deg,
                                          double needed = 0)
    {
        const ToolClearance clearance{floor_and_wall()};
        const AxisRules rules{tool, clearance};
        const CutterContact contact{{0, y, 0}, Vec3::UnitZ()};
        const Inclination inclination{Angle::degrees(lead_deg), Angle::degrees(tilt_deg)};
        const Vec3 axis = inclined_axis(contact.normal, Vec3::UnitX(), inclination);
        return rules.judge({contact, {}, needed, 1}, axis, inclination).broken;
    }
};

// A ball of radius 2 whose centre is at y = 0 must tilt by no more than atan(2 / 28) to the wall:
// its shaft reaches it at the height of the wall's top. Holders reach farther.
TEST_F(RulesBesideAWall, CutterAndHolderKeepOffTheWall)
{
    RuledTool tool{Cutter::ball(2)};
    tool.deepest_gouge = 1e-3;
    // the shaft of radius 2 about (0, 2) + s (sin, cos): at z = 30 it is at y = 4
    const auto farthest = [](double tilt) {
        return 28 * std::tan(tilt) + 2 / std::cos(tilt);
    };
    double least = 0;
    double most = 20;
    for (int k = 0; k < 60; ++k) {
        const double middle = (least + most) / 2;
        (farthest(middle * std::numbers::pi / 180) < 4 ? least : most) = middle;
    }
    EXPECT_FALSE(broken(tool, 0, 0, least - 0.05));
    EXPECT_EQ(broken(tool, 0, 0, least + 0.05), AxisRule::Cutter);
    EXPECT_FALSE(broken(tool, 0, 20, -30));
    tool.body = {{12, 10, 60}};
    EXPECT_EQ(broken(tool, 0, 0, 0), AxisRule::Shank);
    EXPECT_FALSE(broken(tool, 0, 0, -30));
}

TEST_F(RulesBesideAWall, StripLeadAndCurvatureAreRules)
{
    RuledTool tool{Cutter{2, 0.5}};
    tool.deepest_gouge = 1e-3;
    tool.rear_lead = Angle::degrees(3);
    EXPECT_EQ(broken(tool, -20, 2, 0), AxisRule::RearLead);
    EXPECT_FALSE(broken(tool, -20, 4, 0));
    const double width = *strip_width(tool.cutter, {}, {Angle::degrees(4)}, 0.05);
    EXPECT_EQ(broken(tool, -20, 4, 0, 1.01 * width), AxisRule::Strip);
    EXPECT_FALSE(broken(tool, -20, 4, 0, 0.99 * width));
    // without a lean the flat bottom leaves nothing: D is not positive
    EXPECT_EQ(broken(tool, -20, 0, 0), AxisRule::Curvature);
}

// Visibility is eroded by a cell: an axis near a cell behind the wall is refused, though a thin cutter
// would be clear. The cells are tested one by one.
TEST_F(RulesBesideAWall, VisibilityIsARuleOfPreparedContacts)
{
    RuledTool tool{Cutter::ball(0.5)};
    tool.deepest_gouge = 1e-3;
    tool.greatest_lean = Angle::degrees(45);
    const TriangleMesh part = floor_and_wall();
    const ToolClearance clearance{part};
    const ContactCones cones{part, 1e-3};
    const AxisRules rules{tool, clearance, &cones};
    const CutterContact contact{{0, -4, 0}, Vec3::UnitZ()};
    RuledContact at{contact, {}, 0, 1};
    const auto broken = [&](const Inclination& inclination) {
        return rules
            .judge(at, inclined_axis(contact.normal, Vec3::UnitX(), inclination),
                   inclination)
            .broken;
    };
    // the top of the wall is 8 mm beside the contact and 30 mm above
    const double top = std::atan2(8, 30);
    const SphereGrid grid = sphere_grid("hex:10");
    const auto is_near_a_hidden_cell = [&](const Vec3& axis) {
        return std::ranges::any_of(grid.centres, [&](const Vec3& centre) {
            return centre.z() > 0 && std::atan2(centre.y(), centre.z()) > top &&
                   centre.dot(axis) > std::cos(cones.cell_radius());
        });
    };
    const double spare = 2;  // degrees, for the radius of the shaft
    int refused = 0;
    int allowed = 0;
    const double most_tilt = Angle::radians(top).degrees() - spare;
    for (double lead = -30; lead <= 30; lead += 5)
        for (double tilt = most_tilt; tilt > -30; tilt -= 1) {
            const Inclination inclination{Angle::degrees(lead), Angle::degrees(tilt)};
            at.hidden.reset();
            EXPECT_FALSE(broken(inclination));
            rules.prepare(at);
            if (is_near_a_hidden_cell(
                    inclined_axis(contact.normal, Vec3::UnitX(), inclination))) {
                EXPECT_EQ(broken(inclination), AxisRule::Visibility);
                ++refused;
            } else {
                EXPECT_FALSE(broken(inclination));
                ++allowed;
            }
        }
    EXPECT_GT(refused, 0);
    EXPECT_GT(allowed, 300);
}

TEST_F(RulesBesideAWall, MachineReachesSomeDirections)
{
    PartOnMachine setup;
    setup.machine.configuration = configuration_from_word("W/caxyBz/T");
    setup.machine.rotary = widest_limits(setup.machine.configuration);
    const double limit = 15 * std::numbers::pi / 180;
    setup.machine.rotary.phi = {-limit, limit};
    RuledTool tool{Cutter::ball(2)};
    tool.deepest_gouge = 1e-3;
    tool.machine = &setup;
    EXPECT_FALSE(broken(tool, -20, 14, 0));
    EXPECT_EQ(broken(tool, -20, 16, 0), AxisRule::Machine);
}

TEST(AxisRules, GapAndClearanceOfALocation)
{
    const ToolClearance clearance{floor_and_wall()};
    RuledTool tool{Cutter::ball(2)};
    tool.deepest_gouge = 0.01;
    tool.body = {{12, 10, 60}};
    const AxisRules rules{tool, clearance};
    EXPECT_NEAR(rules.cutter_gap({{0, -20, 0.5}, Vec3::UnitZ()}, 9), 0.5, 1e-3);
    EXPECT_EQ(rules.cutter_gap({{0, -20, 0.5}, Vec3::UnitZ()}, 0.1), 0.1);
    EXPECT_TRUE(rules.is_clear({{0, -20, -0.005}, Vec3::UnitZ()}));
    EXPECT_FALSE(rules.is_clear({{0, -20, -0.015}, Vec3::UnitZ()}));
    EXPECT_FALSE(rules.is_clear({{0, -1, 1}, Vec3::UnitZ()}));
}

}  // namespace
}  // namespace endmill
