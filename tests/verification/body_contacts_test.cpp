// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/body_contacts.h"

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace endmill {
namespace {

// The cylinder's lower ends are 1 above, at, and 2 below a floor at z = 0.
class OverAFloor : public testing::Test {
protected:
    static StraightSweep plunge(double z)
    {
        return {Cutter::flat(3), {5, 5, z + 1}, {5, 5, z}};
    }

    // Runs a pass for each chord error.
    PartCollisions after(std::initializer_list<double> chord_errors)
    {
        for (const double chord_error : chord_errors) {
            const std::vector<StraightSweep> open = moves_.open_sweeps();
            const SweepTree tree{open};
            moves_.begin_pass();
            find_contacts({floor_, chord_error, {3, 10}, tree}, moves_);
            moves_.end_pass(chord_error);
        }
        return moves_.found(7);
    }

    const TriangleMesh floor_ = test::flat_mesh(10, 10);
    const std::vector<StraightSweep> sweeps_{plunge(-9), plunge(-10), plunge(-12)};
    BodyMoves moves_{sweeps_};
};

TEST_F(OverAFloor, ContactsAreUndecidedAtFirst)
{
    EXPECT_TRUE(moves_.has_open());
    EXPECT_EQ(moves_.open_sweeps().size(), 3U);
    EXPECT_GT(moves_.found(0).bound_mm, 1e9);
}

TEST_F(OverAFloor, AMeshDecidesAllContacts)
{
    const PartCollisions found = after({0});
    EXPECT_FALSE(moves_.has_open());
    EXPECT_EQ(found.moves.count, 1U);
    EXPECT_EQ(found.moves.first, 9U);
    EXPECT_NEAR(found.moves.deepest, 2, 1e-12);
    EXPECT_EQ(found.bound_mm, part_contact_slack);
}

// Within the chord error only the move that touches the floor stays open.
TEST_F(OverAFloor, ContactsWithinTheTriangleErrorStayUndecided)
{
    const PartCollisions found = after({0.015});
    EXPECT_EQ(moves_.open_sweeps().size(), 1U);
    EXPECT_EQ(found.moves.count, 1U);
    EXPECT_NEAR(found.bound_mm, 0.015, 1e-12);
    EXPECT_EQ(after({part_contact_slack / 2}).bound_mm, part_contact_slack);
    EXPECT_FALSE(moves_.has_open());
}

}  // namespace
}  // namespace endmill
