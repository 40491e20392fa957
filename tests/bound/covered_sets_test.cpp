// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/covered_sets.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/bound/detail/raised_point.h"
#include "random.h"

namespace endmill {
namespace {

// The least excess of some tools over a raised point; below 0 it is covered.
double least_excess(const std::vector<ToolReach>& tools, const Vec3& point)
{
    double least = tools.front().excess(point);
    for (const ToolReach& tool : tools)
        least = std::min(least, tool.excess(point));
    return least;
}

// The share of a square in which a function is below 0, linear along u on every one of
// some lines, which are linear between two sides.
double share_below(const std::array<double, 4>& corners)
{
    constexpr int lines = 8;
    double share = 0;
    for (int k = 0; k < lines; ++k) {
        const double v = (k + 0.5) / lines;
        const double a = std::lerp(corners[0], corners[2], v);
        const double b = std::lerp(corners[1], corners[3], v);
        if (a <= 0 && b <= 0)
            share += 1;
        else if (a <= 0 || b <= 0)
            share += std::min(a, b) / (std::min(a, b) - std::max(a, b));
    }
    return share / lines;
}

// Area that some tools cover within a rectangle of parameters, by a fine grid.
double covered_area(const test::SidedSurfaces& part, const std::vector<ToolReach>& tools,
                    Interval u, Interval v)
{
    constexpr int steps = 260;
    std::vector<double> excess;
    std::vector<double> element;
    for (int b = 0; b <= steps; ++b)
        for (int a = 0; a <= steps; ++a) {
            const RaisedPlace place =
                raised_place(part.part(), 0,
                             {std::lerp(u.low, u.high, a / double{steps}),
                              std::lerp(v.low, v.high, b / double{steps})},
                             0.5);
            excess.push_back(least_excess(tools, place.point));
            element.push_back(place.area);
        }
    double area = 0;
    for (int b = 0; b < steps; ++b)
        for (int a = 0; a < steps; ++a) {
            const std::size_t k = static_cast<std::size_t>(b) * (steps + 1) + a;
            const std::size_t up = k + steps + 1;
            area += share_below({excess[k], excess[k + 1], excess[up], excess[up + 1]}) *
                    (element[k] + element[k + 1] + element[up] + element[up + 1]) / 4;
        }
    return area * u.length() * v.length() / (steps * steps);
}

// Section V12: the area that a move of 0.1 mm covers newly.
void expect_new_area(const std::string& name, unsigned seed)
{
    const test::SidedSurfaces part = test::dataset(name);
    const BoundedPart bounded = part.part();
    const BoundProblem problem = test::usual_problem();
    const CoveredSets sets{bounded, problem};
    const Interval range_u = part.surfaces[0].range(Parameter::U);
    const Interval range_v = part.surfaces[0].range(Parameter::V);
    test::Random random{seed};
    for (int k = 0; k < 10; ++k) {
        const SurfacePoint at{random.uniform(std::lerp(range_u.low, range_u.high, 0.15),
                                             std::lerp(range_u.low, range_u.high, 0.85)),
                              random.uniform(std::lerp(range_v.low, range_v.high, 0.2),
                                             std::lerp(range_v.low, range_v.high, 0.8))};
        const auto set =
            sets.set_at(contact_place(bounded, 0, at), CoveredSets::Want::Boundary);
        ASSERT_TRUE(set);
        const ContactFrame& frame = set->frame;
        const double angle = random.uniform(0, 6.28);
        const Eigen::Vector2d along{std::cos(angle), std::sin(angle)};
        double inflow = 0;
        for (const BoundaryFlow& piece : set->boundary)
            inflow += std::max(0.0, piece.flow.dot(along));
        // Half a move of 0.05 mm in the parameters, and the rectangle around.
        const double first = 0.05 * along.x() / frame.half_axis_1;
        const double second = 0.05 * along.y() / frame.half_axis_2;
        const double du = first * frame.along_1.a + second * frame.along_2.a;
        const double dv = first * frame.along_1.b + second * frame.along_2.b;
        const auto tool = [&](double sign) {
            const ContactFrame end = *contact_frame(
                bounded, problem,
                contact_place(bounded, 0, {at.u + sign * du, at.v + sign * dv}));
            return ToolReach{problem, end.centre};
        };
        Interval u{at.u, at.u};
        Interval v{at.v, at.v};
        for (const BoundaryFlow& piece : set->boundary) {
            u = {std::min(u.low, piece.at.u), std::max(u.high, piece.at.u)};
            v = {std::min(v.low, piece.at.v), std::max(v.high, piece.at.v)};
        }
        u = {u.low - 0.1 * u.length(), u.high + 0.1 * u.length()};
        v = {v.low - 0.1 * v.length(), v.high + 0.1 * v.length()};
        const double before = covered_area(part, {tool(-1)}, u, v);
        const double both = covered_area(part, {tool(-1), tool(1)}, u, v);
        EXPECT_NEAR((both - before) / 0.1, inflow, 0.007 * inflow)
            << name << " " << at.u << " " << at.v;
    }
}

TEST(CoveredSets, HaveTheInflowOfTheNewlyCoveredAreaOnTheNet)
{
    expect_new_area("net_rot24_7D", 1);
}

TEST(CoveredSets, HaveTheInflowOfTheNewlyCoveredAreaOnTheSaddle)
{
    expect_new_area("saddle", 2);
}

TEST(CoveredSets, HavePiecesOnlyWhereAskedFor)
{
    const test::SidedSurfaces part = test::dataset("saddle");
    const BoundProblem problem = test::usual_problem();
    const CoveredSets sets{part.part(), problem};
    const ContactPlace place = contact_place(part.part(), 0, {1.2, 1.7});
    EXPECT_TRUE(sets.set_at(place, CoveredSets::Want::Boundary)->pieces.empty());
    EXPECT_FALSE(
        sets.set_at(place, CoveredSets::Want::BoundaryAndPieces)->pieces.empty());
}

}  // namespace
}  // namespace endmill
