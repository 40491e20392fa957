// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/removable_path.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "tip_path.h"

namespace endmill {
namespace {

TEST(RequireRemovable, AcceptsThreeAxisPathsOnly)
{
    ToolPath path = test::tip_path({{0, 0, 0}, {1, 2, 3}});
    EXPECT_NO_THROW(require_removable(path));
    EXPECT_NO_THROW(require_removable({}));
    path.points[1].location.axis = -Vec3::UnitZ();
    EXPECT_THROW(require_removable(path), GeometryError);
    path.points[1].location.axis.setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_THROW(require_removable(path), GeometryError);
}

TEST(RequireRemovable, RefusesTipsBeyondTheExtent)
{
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_THROW(require_removable(test::tip_path({{0, infinite, 0}})), DomainError);
    EXPECT_THROW(require_removable(test::tip_path({{0, 0, -2e9}})), DomainError);
}

TEST(CutsAtStart, IsTrueIfTheCutterArrivesAtFeed)
{
    EXPECT_TRUE(cuts_at_start(test::tip_path({{0, 0, 0}}, Move::Plunge)));
    EXPECT_TRUE(cuts_at_start(test::tip_path({{0, 0, 0}}, Move::Cut)));
    for (const Move move : {Move::Link, Move::Rapid, Move::Retract})
        EXPECT_FALSE(cuts_at_start(test::tip_path({{0, 0, 0}}, move)));
}

}  // namespace
}  // namespace endmill
