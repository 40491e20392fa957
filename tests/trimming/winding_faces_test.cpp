// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/winding_faces.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

using Kept = std::vector<bool>;

void add_edge(std::vector<FaceStep>& steps, int from, int to, int fall)
{
    steps.push_back({from, to, fall});
    steps.push_back({to, from, -fall});
}

// The outside, a ring of material, and free space inside it: three nested faces.
std::vector<FaceStep> nested()
{
    std::vector<FaceStep> steps;
    add_edge(steps, 0, 1, 1);
    add_edge(steps, 1, 2, -1);
    return steps;
}

TEST(WindingFaces, AreKeptByTheirIndex)
{
    EXPECT_EQ(kept_faces(nested(), {3, 0, 0, false}), (Kept{true, false, true}));
    EXPECT_EQ(kept_faces(nested(), {3, 0, -1, false}), (Kept{false, false, false}));
    EXPECT_EQ(kept_faces(nested(), {3, 0, 1, false}), (Kept{true, true, true}));
}

TEST(WindingFaces, MustBeJoinedToTheOuterOneWhereCurvesAreOpen)
{
    EXPECT_EQ(kept_faces(nested(), {3, 0, 0, true}), (Kept{true, false, false}));
    std::vector<FaceStep> with_a_way = nested();
    add_edge(with_a_way, 0, 2, 0);
    EXPECT_EQ(kept_faces(with_a_way, {3, 0, 0, true}), (Kept{true, false, true}));
}

TEST(WindingFaces, MayBeTheOuterOneAlone)
{
    EXPECT_EQ(kept_faces({}, {1, 0, 0, true}), Kept{true});
    EXPECT_EQ(kept_faces({}, {1, 0, -1, false}), Kept{false});
}

}  // namespace
}  // namespace endmill
