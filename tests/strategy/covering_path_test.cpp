// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covering_path.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/planning/planner_options.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// A plane of 20 x 10 mm, a ball of radius 5 mm and a scallop height of 1 mm. The ball covers
// 3 mm on both sides of a pass.
class PathOverAPlane : public testing::Test {
protected:
    PathOverAPlane()
    {
        options_.scallop_height = 1;
        options_.link.safe_height =
            default_safe_height(std::get<std::vector<Surface>>(plane_), Vec3::UnitZ());
    }

    // A straight pass with a contact for each mm.
    LaidPass pass_at(const PartSamples& samples, double y, double from, double to) const
    {
        LaidPass pass;
        const double steps = std::max(1.0, std::round(to - from));
        for (double k = 0; k <= steps; ++k) {
            const SurfacePoint at{std::lerp(from, to, k / steps) / 20, y / 10};
            pass.contacts.push_back(samples.contact(at, nearest(samples, at)));
        }
        return pass;
    }

    CoveringPath path_of(LaidPasses laid) const
    {
        return covering_path(std::move(laid), part_, ball_, options_);
    }

    PartSamples samples() const { return part_.samples(0.6, 100'000); }

    Part plane_ = std::vector<Surface>{test::plane(20, 10)};
    BallCutter ball_{5};
    CoveredPart part_{plane_, ball_, {0.01, 1}};
    StrategyOptions options_;

private:
    static std::int32_t nearest(const PartSamples& samples, const SurfacePoint& at)
    {
        const Vec3 point{20 * at.u, 10 * at.v, 0};
        std::int32_t best = 0;
        for (std::size_t i = 0; i < samples.size(); ++i)
            if ((samples.point(i) - point).norm() < (samples.point(best) - point).norm())
                best = static_cast<std::int32_t>(i);
        return best;
    }
};

// The greatest distance of a place of the plane from the cuts of a path. The cuts lie on the
// plane, so that it is a distance of a point from a segment there.
double greatest_distance(const ToolPath& path)
{
    const auto distance = [](const Vec3& a, const Vec3& b, const Vec3& point) {
        const Vec3 way = b - a;
        const double share =
            way.squaredNorm() > 0
                ? std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0)
                : 0;
        return (a + share * way - point).norm();
    };
    double greatest = 0;
    for (double x = 0; x <= 20; x += 0.05)
        for (double y = 0; y <= 10; y += 0.05) {
            double least = 100;
            for (std::size_t k = 0; k < path.points.size(); ++k) {
                const Vec3& tip = path.points[k].location.tip;
                if (path.points[k].move == Move::Cut)
                    least = std::min(
                        least, distance(path.points[k - 1].location.tip, tip, {x, y, 0}));
                else if (path.points[k].contact())
                    least = std::min(least, distance(tip, tip, {x, y, 0}));
            }
            greatest = std::max(greatest, least);
        }
    return greatest;
}

TEST_F(PathOverAPlane, KeepsPassesThatCoverIt)
{
    LaidPasses laid{samples(), {}};
    for (const double y : {2.9, 7.1})
        laid.passes.push_back(pass_at(laid.samples, y, 0, 20));
    const CoveringPath path = path_of(std::move(laid));
    EXPECT_TRUE(path.uncovered.empty());
    EXPECT_EQ(path.passes, 2u);
    EXPECT_EQ(path.pieces, 2u) << "4.2 mm apart, 0.7 strips: too far to join";
    EXPECT_LE(greatest_distance(path.path), 3);
    EXPECT_EQ(path.lifted_links, 0u);
}

// Strips of 3 mm beside passes at 2.95 and 9.05 leave 0.1 mm between them. The second pass
// comes nearer at both ends.
TEST_F(PathOverAPlane, BendsPassesTowardsWhatTheyMiss)
{
    LaidPasses laid{samples(), {}};
    laid.passes.push_back(pass_at(laid.samples, 2.95, 0, 20));
    LaidPass bow;
    for (double x = 0; x <= 20; ++x)
        bow.contacts.push_back(
            pass_at(laid.samples, 9.05 - 0.025 * std::abs(x - 10), x, x)
                .contacts.front());
    laid.passes.push_back(bow);
    const CoveringPath path = path_of(std::move(laid));
    EXPECT_TRUE(path.uncovered.empty());
    EXPECT_EQ(path.pieces, 2u);
    EXPECT_LE(greatest_distance(path.path), 3);
}

TEST_F(PathOverAPlane, LeavesOutAShortPassWhereOthersCover)
{
    LaidPasses laid{samples(), {}};
    for (const double y : {2.9, 7.1})
        laid.passes.push_back(pass_at(laid.samples, y, 0, 20));
    laid.passes.push_back(pass_at(laid.samples, 5, 9, 10));
    const CoveringPath path = path_of(std::move(laid));
    EXPECT_TRUE(path.uncovered.empty());
    EXPECT_EQ(path.pieces, 2u);
    EXPECT_LT(path_economy(path.path).cut.contact_mm, 2 * 20 + 0.01);
}

// A pass of one place at a corner that nothing else covers is short and stays.
TEST_F(PathOverAPlane, KeepsAShortPassThatIsNeeded)
{
    LaidPasses laid{samples(), {}};
    laid.passes.push_back(pass_at(laid.samples, 2.9, 0, 20));
    laid.passes.push_back(pass_at(laid.samples, 7.1, 2.9, 20));
    laid.passes.push_back(pass_at(laid.samples, 8, 0.5, 1.5));
    const CoveringPath path = path_of(std::move(laid));
    EXPECT_TRUE(path.uncovered.empty());
    EXPECT_LE(greatest_distance(path.path), 3);
}

// What no bend can cover gets passes of one place each.
TEST_F(PathOverAPlane, AddsPassesWhereBendsDoNotReach)
{
    LaidPasses laid{samples(), {}};
    laid.passes.push_back(pass_at(laid.samples, 2.9, 0, 8));
    const CoveringPath path = path_of(std::move(laid));
    EXPECT_TRUE(path.uncovered.empty());
    EXPECT_EQ(path.uncovered_mm2, 0);
    EXPECT_GT(path_economy(path.path).cut.contact_mm, 8);
    EXPECT_LE(greatest_distance(path.path), 3);
}

}  // namespace
}  // namespace endmill
