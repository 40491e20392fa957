// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/first_fits.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/visibility/sphere_grid.h"

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Every cone is a single cell; the cells are those nearest to an arc of a great circle.
struct OneArc {
    OneArc()
    {
        const SphereGrid grid = sphere_grid("hex:4");
        std::vector<std::size_t> near;
        for (std::size_t cell = 0; cell < grid.centres.size(); ++cell)
            if (std::abs(grid.centres[cell].x()) < 1e-12 && grid.centres[cell].z() > 0)
                near.push_back(cell);
        VisibilityMap map{near.size(), grid.centres.size()};
        for (std::size_t k = 0; k < near.size(); ++k)
            map.column(near[k])[0] |= std::uint64_t{1} << k;
        cones.emplace(map);
        for (const std::size_t cell : cones->cells())
            centres.push_back(grid.centres[cell]);
    }

    ConeFitting fitting(RotaryFamily family) const
    {
        return {&*cones, centres, {family}, RangeLimits{family, {}}};
    }

    std::optional<ConeSet> cones;
    std::vector<Vec3> centres;
};

TEST(FirstFits, FindTheGreatCircleOfTheCells)
{
    const OneArc arc;
    ASSERT_GT(arc.centres.size(), 3U);
    const auto normals = short_arcs(arc.fitting(RotaryFamily::AB));
    ASSERT_FALSE(normals.empty());
    EXPECT_LT(normals.front().cross(Vec3::UnitX()).norm(), 1e-6);
    double longest = 0;
    for (const Vec3& a : arc.centres)
        for (const Vec3& b : arc.centres)
            longest = std::max(longest, std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        const ConeFitting fitting = arc.fitting(family);
        const auto fit = first_fit(fitting, {});
        ASSERT_TRUE(fit);
        const double floor = fitting.measure.floor_rad;
        EXPECT_NEAR(fit->objective, floor * (floor + longest), 1e-6);
    }
}

TEST(FirstFits, KeepFitsCloseToTheBestInOrder)
{
    const OneArc arc;
    const ConeFitting fitting = arc.fitting(RotaryFamily::AB);
    const std::vector<Vec3> axes{Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitX(),
                                 Vec3{1, 0.001, 0}.normalized()};
    const auto fits = fits_about(fitting, axes, infinity);
    ASSERT_GE(fits.size(), 2U);
    for (std::size_t k = 1; k < fits.size(); ++k) {
        EXPECT_LE(fits[k - 1].objective, fits[k].objective);
        EXPECT_LE(fits[k].objective, 1.2 * fits[0].objective);
    }
    EXPECT_TRUE(fits_about(fitting, axes, fits[0].objective / 2).empty());
}

TEST(FirstFits, AreEmptyIfTheLimitsAllowNone)
{
    const OneArc arc;
    ConeFitting fitting = arc.fitting(RotaryFamily::CA);
    fitting.limits = RangeLimits{RotaryFamily::CA, {{-1 * degree, 1 * degree}, {-1, 1}}};
    EXPECT_FALSE(first_fit(fitting, {}));
}

}  // namespace
}  // namespace endmill
