// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/axis_node.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool holds(const AxisNode& node, const Vec3& point)
{
    const auto& [a, b, c] = node.corners;
    const double turn = a.cross(b).dot(c) > 0 ? 1 : -1;
    return turn * a.cross(b).dot(point) >= -1e-12 &&
           turn * b.cross(c).dot(point) >= -1e-12 &&
           turn * c.cross(a).dot(point) >= -1e-12;
}

class RandomCones : public testing::Test {
protected:
    RandomCones()
    {
        VisibilityMap map{8, grid_.centres.size()};
        std::bernoulli_distribution is_open{0.2};
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            for (std::size_t facet = 0; facet < map.facets(); ++facet)
                if (is_open(random_))
                    map.column(cell)[0] |= std::uint64_t{1} << facet;
        cones_.emplace(map);
        for (const std::size_t cell : cones_->cells())
            centres_.push_back(grid_.centres[cell]);
    }

    ConeFitting fitting(RotaryFamily family) const
    {
        return {&*cones_, centres_, {family}, RangeLimits{family, {}}, 2 * degree};
    }

    Vec3 direction()
    {
        std::normal_distribution<double> normal;
        return Vec3{normal(random_), normal(random_), normal(random_)}.normalized();
    }

    std::mt19937 random_{6};
    SphereGrid grid_ = sphere_grid("hex:4");
    std::optional<ConeSet> cones_;
    std::vector<Vec3> centres_;
};

TEST_F(RandomCones, HaveRootNodesThatCoverAllAxes)
{
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        const auto roots = root_nodes(fitting(family));
        for (int k = 0; k < 200; ++k) {
            const Vec3 axis = direction();
            std::array<int, 2> found{0, 0};
            for (const AxisNode& node : roots) {
                const bool either =
                    node.kind == NodeKind::Arc || family == RotaryFamily::AB;
                if (holds(node, axis) || (either && holds(node, -axis)))
                    ++found[std::size_t(node.kind)];
                EXPECT_LT(radius(node), 12 * degree);
            }
            EXPECT_GE(found[0], 1);
            EXPECT_GE(found[1], 1);
        }
    }
}

TEST_F(RandomCones, HaveNodesWhosePartsCoverThem)
{
    const AxisNode node = root_nodes(fitting(RotaryFamily::CA)).front();
    std::uniform_real_distribution<double> uniform{0, 1};
    for (int k = 0; k < 100; ++k) {
        const Vec3 inside =
            (uniform(random_) * node.corners[0] + uniform(random_) * node.corners[1] +
             uniform(random_) * node.corners[2])
                .normalized();
        int found = 0;
        for (int number = 0; number < 4; ++number) {
            const AxisNode quarter = part(node, number);
            if (holds(quarter, inside)) {
                ++found;
                EXPECT_LE((inside - centre(quarter)).norm(), radius(quarter) + 1e-12);
            }
        }
        EXPECT_GE(found, 1);
    }
}

TEST_F(RandomCones, HaveBoundsBelowEveryFitInTheNode)
{
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        const ConeFitting fitting = this->fitting(family);
        const auto roots = root_nodes(fitting);
        NodeBounder bounder{fitting};
        AxisFitter fitter{fitting};
        for (int k = 0; k < 60; ++k) {
            const Vec3 axis = direction();
            const auto fit = fitter.best(axis, {infinity});
            ASSERT_TRUE(fit);
            if (fit->ranges.width <= fitting.thin_width)
                continue;  // a node of arcs
            for (AxisNode node : roots) {
                if (node.kind == NodeKind::Arc || !holds(node, axis))
                    continue;
                for (int depth = 0; depth < 4; ++depth) {
                    bounder.bound(node, fit->objective * 1.01);
                    ASSERT_FALSE(node.boxes.empty());
                    EXPECT_LE(node.bound, fit->objective);
                    for (int number = 0; number < 4; ++number) {
                        AxisNode quarter = part(node, number);
                        if (holds(quarter, axis)) {
                            node = std::move(quarter);
                            break;
                        }
                    }
                }
            }
        }
    }
}

TEST_F(RandomCones, HaveArcBoundsBelowEveryThinLune)
{
    // A lune of full height along a circle is compared with the bound of the circle's
    // normal.
    ConeFitting fitting = this->fitting(RotaryFamily::AB);
    fitting.thin_width = 30 * degree;
    AxisFitter fitter{fitting};
    NodeBounder bounder{fitting};
    const auto roots = root_nodes(fitting);
    int thin = 0;
    for (int k = 0; k < 3000 && thin < 20; ++k) {
        const Vec3 axis = direction();
        const auto fit = fitter.best(axis, {infinity});
        if (!fit || fit->ranges.width > fitting.thin_width)
            continue;
        ++thin;
        const double middle = fit->window.begin + fit->window.width / 2;
        const Vec3 zero = azimuth_zero(axis);
        const Vec3 normal =
            -std::sin(middle) * zero + std::cos(middle) * axis.cross(zero);
        for (AxisNode node : roots) {
            if (node.kind == NodeKind::Axis ||
                !(holds(node, normal) || holds(node, -normal)))
                continue;
            bounder.bound(node, fit->objective * 1.01);
            ASSERT_FALSE(node.boxes.empty());
            EXPECT_LE(node.bound, fit->objective);
        }
    }
    EXPECT_GT(thin, 5);
}

TEST(ThinWidth, IsZeroForTiltAndASmallShareOfOtherObjectives)
{
    PoseMeasure measure;
    EXPECT_LE(thin_width(measure, 1), measure.floor_rad / 2);
    measure.objective = SetupObjective::TotalRange;
    EXPECT_LE(thin_width(measure, 1), 0.1);
    EXPECT_LT(thin_width(measure, infinity), 1);
    measure.objective = SetupObjective::Tilt;
    EXPECT_EQ(thin_width(measure, 1), 0);
}

}  // namespace
}  // namespace endmill
