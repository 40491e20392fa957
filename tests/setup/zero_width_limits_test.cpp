// SPDX-License-Identifier: GPL-3.0-or-later

// Rotary limits of zero width leave arcs of great circles. Such an arc, if it is longer
// than a point, lies on a circle through two cells. The expected results come from all of
// these circles.

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/setup/detail/arc_search.h"
#include "endmill/setup/detail/many_cones_search.h"
#include "endmill/visibility/sphere_grid.h"
#include "random_maps.h"

namespace endmill {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;

/// Caps of 20 to 40 degrees about directions up to 15 degrees off a great circle. Their
/// azimuths along the circle span 140 degrees.
VisibilityMap caps_along_a_circle(const SphereGrid& grid, std::size_t facets,
                                  test::Random& random)
{
    VisibilityMap map{facets, grid.centres.size()};
    const Vec3 normal = test::random_direction(random);
    const Vec3 zero = normal.unitOrthogonal();
    for (std::size_t facet = 0; facet < facets; ++facet) {
        const double azimuth = random.uniform(0, 80) * degree;
        const double latitude = random.uniform(-20, 20) * degree;
        const Vec3 along =
            std::cos(azimuth) * zero + std::sin(azimuth) * normal.cross(zero);
        const Vec3 axis = std::cos(latitude) * along + std::sin(latitude) * normal;
        const double least = std::cos(random.uniform(30, 45) * degree);
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            if (axis.dot(grid.centres[cell]) > least)
                test::make_accessible(map, facet, cell);
    }
    return map;
}

/// Length of the shortest arc that meets all cones, over the circles through two cells;
/// infinity if there is none.
double shortest_of_all(const SphereGrid& grid, const VisibilityMap& map)
{
    double shortest = std::numeric_limits<double>::infinity();
    std::vector<Vec3> normals;
    for (std::size_t a = 0; a < grid.centres.size(); ++a)
        for (std::size_t b = a + 1; b < grid.centres.size(); ++b) {
            const Vec3 product = grid.centres[a].cross(grid.centres[b]);
            if (product.norm() > 1e-6)
                normals.push_back(product.normalized());
        }
    const RotaryRange any{-pi, pi};
    const auto best =
        arc_search(map, grid.centres, normals, any, Angle::radians(0)).least;
    if (best)
        shortest = best->phi.to - best->phi.from;
    return shortest;
}

struct Machine {
    RotaryFamily family;
    bool has_first;  ///< R1 of A,B and C of C,A turn, or the other rotary axis
};

RotaryLimits arc_limits(const Machine& machine, const RotaryRange& range)
{
    const bool is_phi = machine.has_first == (machine.family == RotaryFamily::AB);
    return is_phi ? RotaryLimits{range, {0, 0}} : RotaryLimits{{0, 0}, range};
}

class ZeroWidthLimits : public testing::TestWithParam<Machine> {};

TEST_P(ZeroWidthLimits, LeadToTheShortestArcThroughCells)
{
    const SphereGrid grid = sphere_grid("hex:4");
    WholeConeSearchOptions options;
    options.family = GetParam().family;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        test::Random random{seed};
        const VisibilityMap map = caps_along_a_circle(grid, 24, random);
        const double shortest = shortest_of_all(grid, map);
        const double least = options.floor_rad * (options.floor_rad + shortest);
        // A wide range, one that the arc just fits into, and one that is too narrow.
        // `arc_search` takes cells up to 1e-9 rad off the circle, so that its arcs may be
        // 1e-7 rad too short.
        for (const double room : {pi, shortest + 1e-6, 0.99 * shortest})
            for (const std::size_t few : {std::size_t(8), std::size_t(512)}) {
                options.limits = arc_limits(GetParam(), {-0.35 * room, 0.65 * room});
                const auto found = many_cones_search(grid, map, options, few);
                if (room < shortest) {
                    EXPECT_EQ(found.machinable, Answer::No);
                    continue;
                }
                EXPECT_EQ(found.machinable, Answer::Yes);
                EXPECT_EQ(found.unresolved, 0U);
                EXPECT_LE(found.lower_bound, least * (1 + 1e-7));
                EXPECT_LE(found.objective,
                          (1 + options.gap) * found.lower_bound * (1 + 1e-12));
                EXPECT_GE(found.objective, least * (1 - 1e-6));
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Machines, ZeroWidthLimits,
                         testing::Values(Machine{RotaryFamily::AB, true},
                                         Machine{RotaryFamily::AB, false},
                                         Machine{RotaryFamily::CA, false}));

}  // namespace
}  // namespace endmill
