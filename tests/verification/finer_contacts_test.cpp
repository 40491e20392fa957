// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/finer_contacts.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tip_path.h"

namespace endmill {
namespace {

constexpr double pitch = 0.5;
const Block block{{-10, -10, -10}, {10, 10, 0}};

// Two flat grooves leave a ridge along x, `width` wide. Then a rapid moves along the
// ridge, 1 below its top.
ToolPath over_ridge(double width, double y)
{
    ToolPath path = test::tip_path({{-20, y - 3 - width / 2, -2},
                                    {20, y - 3 - width / 2, -2},
                                    {20, y + 3 + width / 2, -2},
                                    {-20, y + 3 + width / 2, -2},
                                    {-20, y, -1},
                                    {20, y, -1}});
    path.points[5].move = Move::Rapid;
    return path;
}

StockContacts contacts(const ToolPath& path, const std::vector<ToolCylinder>& body,
                       double most_bytes = 1e9)
{
    HeightStock stock = block_stock(block, pitch);
    const StockGrid grid = stock.grid();
    const Cutter cutter = Cutter::flat(3);
    const Removal removal = remove_along(stock, path, cutter, {body});
    return finer_contacts(removal, block, grid, {path, cutter, body, most_bytes});
}

// The centres of cells lie at y = ±0.25. Only finer cells detect a ridge between them.
TEST(FinerContacts, FindContactsWiderThanTheStatedBound)
{
    const double finest = std::numbers::sqrt2 * pitch / 9;
    for (const double width : {0.45, 0.3, 0.1}) {
        HeightStock stock = block_stock(block, pitch);
        EXPECT_EQ(
            remove_along(stock, over_ridge(width, 0), Cutter::flat(3)).rapid_cuts.count,
            0U);
        const StockContacts found = contacts(over_ridge(width, 0), {});
        EXPECT_NEAR(found.width_mm, finest, 1e-12);
        EXPECT_EQ(found.rapid_cuts.count, 1U) << width;
        EXPECT_EQ(found.rapid_cuts.first, 5U);
        EXPECT_NEAR(found.rapid_cuts.deepest, 1, 1e-12);
    }
}

TEST(FinerContacts, ReportTheWidthOfContactsTheyMayMiss)
{
    const StockContacts found = contacts(over_ridge(0.3, 0), {}, 0);
    EXPECT_EQ(found.rapid_cuts.count, 0U);
    EXPECT_NEAR(found.width_mm, std::numbers::sqrt2 * pitch, 1e-12);
}

// The shank clears the stock in two passes beside the ridge, and cuts into the ridge in a
// third, deeper pass.
TEST(FinerContacts, FindAShankInARidge)
{
    const ToolPath path = test::tip_path({{-20, -7, -2},
                                          {20, -7, -2},
                                          {20, -3.15, -2},
                                          {-20, -3.15, -2},
                                          {-20, 3.15, -2},
                                          {20, 3.15, -2},
                                          {20, -3.15, -3},
                                          {-20, -3.15, -3}});
    const std::vector<ToolCylinder> shank{{.diameter = 7, .from = 2.5, .to = 20}};
    EXPECT_EQ(contacts(path, shank, 0).collisions.count, 0U);
    const StockContacts found = contacts(path, shank);
    EXPECT_EQ(found.collisions.count, 1U);
    EXPECT_EQ(found.collisions.first, 7U);
    EXPECT_NEAR(found.collisions.deepest, 0.5, 1e-12);
}

// The cutter leaves and returns through material that it has already removed.
TEST(FinerContacts, AreNoneInRemovedMaterial)
{
    ToolPath path = test::tip_path({{-7.03, 0.11, -2},
                                    {5.07, 3.2, -3},
                                    {5.07, 3.2, 4},
                                    {-7.03, 0.11, 4},
                                    {-7.03, 0.11, -2},
                                    {5.07, 3.2, -3}});
    for (const std::size_t k : {2, 3})
        path.points[k].move = Move::Rapid;
    EXPECT_EQ(contacts(path, {}).width_mm, 0);
    for (const std::size_t k : {4, 5})
        path.points[k].move = Move::Rapid;
    const StockContacts found = contacts(path, {{{.diameter = 6, .from = 4, .to = 50}}});
    EXPECT_EQ(found.rapid_cuts.count, 0U);
    EXPECT_EQ(found.collisions.count, 0U);
    EXPECT_GT(found.width_mm, 0);
}

// The path lies on a lattice of cells, so that many centres lie on the rim.
TEST(FinerContacts, AreNoneOnTheRim)
{
    for (const double x : {0.0, 0.25, 0.5}) {
        ToolPath path = test::tip_path(
            {{x, x, 4}, {x, x, -3}, {x + 4, x, -3}, {x, x, -3}, {x, x + 0.5, 4}});
        path.points[0].move = path.points[3].move = path.points[4].move = Move::Rapid;
        path.points[4].location.tip.y() = x;
        EXPECT_EQ(contacts(path, {}).rapid_cuts.count, 0U);
    }
}

// A cutter beside the block touches nothing.
TEST(FinerContacts, OfAPathBesideTheBlockAreNone)
{
    ToolPath path = test::tip_path({{30, 0, -2}, {30, 5, -2}}, Move::Rapid);
    EXPECT_EQ(contacts(path, {}).width_mm, 0);
    EXPECT_EQ(contacts({}, {}).width_mm, 0);
}

}  // namespace
}  // namespace endmill
