// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/whole_cone_search.h"

#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/visibility.h"
#include "teapot.h"

namespace endmill {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;

/// Cones of a convex part: caps about the normals of its faces.
VisibilityMap caps(const SphereGrid& grid, std::span<const Vec3> normals, double angle)
{
    VisibilityMap map{normals.size(), grid.centres.size()};
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (std::size_t facet = 0; facet < map.facets(); ++facet)
            if (normals[facet].dot(grid.centres[cell]) > std::cos(angle))
                map.column(cell)[facet / 64] |= std::uint64_t{1} << facet % 64;
    return map;
}

std::vector<Vec3> cube_without_bottom()
{
    return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
}

std::vector<Vec3> prism_with_top()
{
    std::vector<Vec3> normals{{0, 0, 1}};
    for (int k = 0; k < 6; ++k)
        normals.emplace_back(std::cos(60 * degree * k), std::sin(60 * degree * k), 0);
    return normals;
}

Vec3 random_direction(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    return Vec3{normal(random), normal(random), normal(random)}.normalized();
}

/// Cones that are random sets of cells of a hemisphere: neither caps nor connected.
VisibilityMap random_map(const SphereGrid& grid, std::size_t facets, std::mt19937& random)
{
    VisibilityMap map{facets, grid.centres.size()};
    std::uniform_real_distribution<double> share{0.1, 0.9};
    for (std::size_t facet = 0; facet < facets; ++facet) {
        const Vec3 normal = random_direction(random);
        const Vec3 wall = random_direction(random);
        std::bernoulli_distribution is_open{share(random)};
        for (std::size_t cell = 0; cell < map.cells(); ++cell) {
            const Vec3& towards = grid.centres[cell];
            if (normal.dot(towards) > 1e-6 &&
                (wall.dot(towards) > 0.3 || is_open(random)))
                map.column(cell)[0] |= std::uint64_t{1} << facet;
        }
    }
    return map;
}

/// phi and theta of a direction from the formulas of the pose; in C,A both solutions.
std::vector<std::array<double, 2>> turns(const FittedPose& fitted, RotaryFamily family,
                                         const Vec3& v)
{
    const SetupPose& pose = fitted.pose;
    const double along = v.dot(pose.tool_axis);
    if (family == RotaryFamily::AB)
        return {{std::atan2(v.dot(pose.r1_axis.cross(pose.tool_axis)), along),
                 std::asin(std::clamp(v.dot(pose.r1_axis), -1.0, 1.0))}};
    const Vec3 home = pose.r2_axis.cross(pose.tool_axis);
    const double polar = std::atan2(v.cross(pose.tool_axis).norm(), along);
    const double azimuth = std::atan2(v.dot(pose.tool_axis.cross(home)), v.dot(home));
    return {{polar, azimuth}, {-polar, azimuth - pi}, {-polar, azimuth + pi}};
}

/// Distance of an angle from a range, up to whole turns, rad.
double beyond(const RotaryRange& range, double angle)
{
    double least = 100;
    for (int k = -1; k <= 1; ++k) {
        const double turned = angle + 2 * pi * k;
        least = std::min(least, std::max({range.from - turned, turned - range.to, 0.0}));
    }
    return least;
}

/// The largest distance, over all facets, of the best cell of a facet from the pose's
/// ranges, rad.
double worst_miss(const SphereGrid& grid, const VisibilityMap& map,
                  const FittedPose& fitted, RotaryFamily family)
{
    double worst = 0;
    for (std::size_t facet = 0; facet < map.facets(); ++facet) {
        double best = 100;
        for (std::size_t cell = 0; cell < map.cells(); ++cell) {
            if (!map.is_accessible(facet, cell))
                continue;
            const bool is_pole =
                (grid.centres[cell] - fitted.pose.tool_axis).norm() < 1e-9 ||
                std::abs(grid.centres[cell].dot(fitted.pose.r1_axis)) > 1 - 1e-15;
            for (const auto& [phi, theta] : turns(fitted, family, grid.centres[cell])) {
                const bool is_ca = family == RotaryFamily::CA;
                const double free =
                    is_ca ? beyond(fitted.phi, phi) : beyond(fitted.theta, theta);
                const double turn =
                    is_ca ? beyond(fitted.theta, theta) : beyond(fitted.phi, phi);
                best = std::min(best, is_pole ? free : std::max(free, turn));
            }
        }
        worst = std::max(worst, best == 100 ? 0 : best);  // empty cones do not count
    }
    return worst;
}

/// The objective of the least window about a random axis up to random levels. All windows
/// that begin at a cell are tried. Infinite if none meets all cones.
double random_objective(const SphereGrid& grid, const VisibilityMap& map,
                        const PoseMeasure& measure, std::mt19937& random)
{
    const Vec3 axis = random_direction(random);
    const Vec3 zero = axis.unitOrthogonal();
    const bool is_ca = measure.family == RotaryFamily::CA;
    std::uniform_real_distribution<double> level{0, is_ca ? pi : pi / 2};
    const std::array<double, 2> upto{level(random), level(random)};
    std::vector<std::pair<double, std::size_t>> counting;
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        const Vec3& v = grid.centres[cell];
        const double azimuth = std::atan2(v.dot(axis.cross(zero)), v.dot(zero));
        const double polar = std::acos(v.dot(axis));
        if (is_ca && polar <= upto[0])
            counting.emplace_back(azimuth, cell);
        if (is_ca && polar <= upto[1])
            counting.emplace_back(azimuth + pi, cell);
        if (!is_ca && pi / 2 - polar <= upto[0] && polar - pi / 2 <= upto[1])
            counting.emplace_back(azimuth, cell);
    }
    std::uint64_t all = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        all |= map.column(cell)[0];
    double width = 100;
    for (const auto& [begin, first] : counting) {
        std::vector<std::pair<double, std::size_t>> after;
        for (const auto& [azimuth, cell] : counting) {
            const double turn = std::fmod(azimuth - begin + 4 * pi, 2 * pi);
            after.emplace_back(azimuth == begin ? 0 : turn, cell);
        }
        std::sort(after.begin(), after.end());
        std::uint64_t met = 0;
        for (const auto& [turn, cell] : after) {
            met |= map.column(cell)[0];
            if (met == all) {
                width = std::min(width, turn);
                break;
            }
        }
    }
    return width < 100 ? measure({width, upto[0], upto[1]})
                       : std::numeric_limits<double>::infinity();
}

/// A row of the table of arcs between two cells that together reach every face.
struct Arc {
    const char* grid;
    RotaryFamily family;
    bool is_cube;  ///< with incidence 75 degrees; else the prism, with 78
    double least_deg2;
    double gap;
};

class ConvexParts : public testing::TestWithParam<Arc> {};

TEST_P(ConvexParts, NeedTheShortestArcBetweenTwoDirections)
{
    const SphereGrid grid = sphere_grid(GetParam().grid);
    WholeConeSearchOptions options;
    options.gap = GetParam().gap;
    options.family = GetParam().family;
    const VisibilityMap map = GetParam().is_cube
                                  ? caps(grid, cube_without_bottom(), 75 * degree)
                                  : caps(grid, prism_with_top(), 78 * degree);
    const WholeConeSearchResult result = whole_cone_search(grid, map, options);
    EXPECT_NEAR(result.objective / (degree * degree), GetParam().least_deg2, 1e-3);
    EXPECT_GE(result.lower_bound * (1 + options.gap), result.objective * (1 - 1e-12));
    EXPECT_EQ(result.unresolved, 0U);
}

// On ico:4 only one of four parts, because they take long; the experiment `convex-parts`
// has all.
INSTANTIATE_TEST_SUITE_P(
    Grids, ConvexParts,
    testing::Values(Arc{"hex:10", RotaryFamily::AB, true, 385.806, 0.005},
                    Arc{"hex:10", RotaryFamily::AB, false, 419.869, 0.005},
                    Arc{"cube:10", RotaryFamily::CA, true, 372.060, 0.01},
                    Arc{"cube:10", RotaryFamily::CA, false, 359.636, 0.01},
                    Arc{"ico:4", RotaryFamily::AB, true, 306.732, 0.01}));

/// The bottoms of two long V-grooves along `along`, tilted about it by +-40 degrees, with
/// a half angle of 15 degrees. Their cones are wedges of directions within 60 degrees of
/// the bottom's normal.
VisibilityMap two_grooves(const SphereGrid& grid, const Vec3& along, const Vec3& above)
{
    VisibilityMap map{2, grid.centres.size()};
    const Vec3 across = along.cross(above);
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        const Vec3& v = grid.centres[cell];
        const double turn = std::atan2(v.dot(across), v.dot(above)) / degree;
        for (std::size_t groove = 0; groove < 2; ++groove) {
            const double tilt = groove == 0 ? 40 : -40;
            const Vec3 normal =
                std::cos(tilt * degree) * above + std::sin(tilt * degree) * across;
            if (std::abs(turn - tilt) < 15 && v.dot(normal) > 0.5)
                map.column(cell)[0] |= std::uint64_t{1} << groove;
        }
    }
    return map;
}

/// Least angle between a direction of facet 0 and a direction of facet 1.
double least_angle(const SphereGrid& grid, const VisibilityMap& map)
{
    double least = pi;
    for (std::size_t a = 0; a < map.cells(); ++a)
        for (std::size_t b = 0; b < map.cells(); ++b)
            if (map.is_accessible(0, a) && map.is_accessible(1, b))
                least = std::min(
                    least, 2 * std::asin((grid.centres[a] - grid.centres[b]).norm() / 2));
    return least;
}

// A range that contains two directions at the angle d has w + h >= d, because a turn of
// at most h about one axis and a turn of at most w about the other axis lead from one to
// the other. So the floored area is at least floor (floor + d), and the great arc between
// the nearest two directions reaches this value. For whole wedges d is 2 asin(sin 25 cos
// 60 / cos 15), between the ends of the wedges; this is less than the angle 2 (40 - 15)
// about the axis of the grooves.
TEST(WholeConeSearch, TurnsFromGrooveToGrooveAlongTheShortestArc)
{
    const SphereGrid grid = sphere_grid("hex:10");
    const Vec3 along =
        Vec3{1, 9, 3}.normalized();  // not in a plane of symmetry of the grid
    const VisibilityMap map = two_grooves(grid, along, along.unitOrthogonal());
    const double angle = least_angle(grid, map);
    EXPECT_GT(angle, 2 * std::asin(std::sin(25 * degree) * 0.5 / std::cos(15 * degree)));
    EXPECT_LT(angle, 50 * degree);
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        WholeConeSearchOptions options;
        options.family = family;
        options.gap = 0.01;
        const WholeConeSearchResult result = whole_cone_search(grid, map, options);
        const double least = options.floor_rad * (options.floor_rad + angle);
        EXPECT_LE(result.lower_bound, least * (1 + 1e-12));
        EXPECT_GE(result.lower_bound * (1 + options.gap), least * (1 - 1e-12));
        EXPECT_NEAR(result.objective, least, 1e-6 * least);
        EXPECT_LT(worst_miss(grid, map, *result.pose, family), 1e-9);
    }
}

/// A row of the table of the teapot's least floored areas on hex:10.
struct TeapotRow {
    RotaryFamily family;
    double incidence_deg;
    double best_deg2;   ///< the best pose of the table
    double bound_deg2;  ///< its certified lower bound
};

class TeapotOfTheTable : public testing::TestWithParam<TeapotRow> {};

// Poses and bounds of this search and of the table must agree: no pose is below a bound.
TEST_P(TeapotOfTheTable, AgreesWithThePosesAndBoundsOfTheTable)
{
    const TeapotRow& row = GetParam();
    const SphereGrid grid = sphere_grid("hex:10");
    VisibilityOptions visibility;
    visibility.incidence = Angle::degrees(row.incidence_deg);
    const VisibilityMap map =
        part_visibility(test::teapot(), grid.centres, visibility).map;
    WholeConeSearchOptions options;
    options.family = row.family;
    const WholeConeSearchResult result = whole_cone_search(grid, map, options);
    const double printed = 1e-5;  // relative rounding of the table's two decimals
    const double objective = result.objective / (degree * degree);
    const double bound = result.lower_bound / (degree * degree);
    EXPECT_LE(bound, row.best_deg2 * (1 + printed));
    EXPECT_GE(objective, row.bound_deg2 * (1 - printed));
    EXPECT_LE(objective, (1 + options.gap) * row.bound_deg2);
    EXPECT_GE(bound * (1 + options.gap), objective * (1 - 1e-12));
    EXPECT_LT(worst_miss(grid, map, *result.pose, row.family), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Section84, TeapotOfTheTable,
    testing::Values(TeapotRow{RotaryFamily::AB, 90, 931.92, 929.24},
                    TeapotRow{RotaryFamily::AB, 80, 1069.08, 1067.24},
                    TeapotRow{RotaryFamily::AB, 60, 6801.98, 6795.17},
                    TeapotRow{RotaryFamily::CA, 90, 934.63, 931.92},
                    TeapotRow{RotaryFamily::CA, 80, 1075.69, 1071.28},
                    TeapotRow{RotaryFamily::CA, 60, 7530.99, 7500.97}));

struct Aim {
    RotaryFamily family;
    SetupObjective objective;
};

class RandomParts : public testing::TestWithParam<Aim> {};

TEST_P(RandomParts, AreReachedCompletelyAndNoPoseIsBelowTheBound)
{
    const SphereGrid grid = sphere_grid("hex:4");
    std::mt19937 random{7};
    WholeConeSearchOptions options;
    options.family = GetParam().family;
    options.objective = GetParam().objective;
    const PoseMeasure measure{options.family, options.objective, options.floor_rad};
    for (std::size_t facets = 2; facets <= 20; facets += 6) {
        const VisibilityMap map = random_map(grid, facets, random);
        const WholeConeSearchResult result = whole_cone_search(grid, map, options);
        ASSERT_TRUE(result.pose);
        EXPECT_EQ(result.machinable, Answer::Yes);
        EXPECT_LT(worst_miss(grid, map, *result.pose, options.family), 1e-9);
        EXPECT_NEAR(result.pose->area, result.ranges.width * result.ranges.height(),
                    1e-12);
        EXPECT_DOUBLE_EQ(result.objective, measure(result.ranges));
        EXPECT_LE(result.lower_bound, result.objective);
        EXPECT_GE(result.lower_bound * (1 + options.gap),
                  result.objective * (1 - 1e-12) - 1e-9);
        for (int k = 0; k < 200; ++k)
            EXPECT_GE(random_objective(grid, map, measure, random), result.lower_bound);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Aims, RandomParts,
    testing::Values(Aim{RotaryFamily::CA, SetupObjective::FlooredArea},
                    Aim{RotaryFamily::CA, SetupObjective::TotalRange},
                    Aim{RotaryFamily::CA, SetupObjective::Tilt},
                    Aim{RotaryFamily::AB, SetupObjective::FlooredArea},
                    Aim{RotaryFamily::AB, SetupObjective::TotalRange},
                    Aim{RotaryFamily::AB, SetupObjective::Tilt}));

TEST(WholeConeSearch, ProvesThatOppositeWallsExceedTheTilt)
{
    const SphereGrid grid = sphere_grid("hex:4");
    // Caps of 30 degrees about x and -x. Their nearest cells are at least 120 degrees
    // apart, so that one of the caps is 60 degrees or more from any tool axis.
    const std::vector<Vec3> walls{{1, 0, 0}, {-1, 0, 0}};
    const VisibilityMap map = caps(grid, walls, 30 * degree);
    WholeConeSearchOptions options;
    options.limits.phi = {-59 * degree, 59 * degree};
    const auto short_tilt = whole_cone_search(grid, map, options);
    EXPECT_EQ(short_tilt.machinable, Answer::No);
    EXPECT_FALSE(short_tilt.pose);

    options.limits.phi = {-80 * degree, 80 * degree};
    const auto enough = whole_cone_search(grid, map, options);
    ASSERT_EQ(enough.machinable, Answer::Yes);
    EXPECT_LT(worst_miss(grid, map, *enough.pose, options.family), 1e-9);
    EXPECT_LE(enough.pose->phi.to, 80 * degree + 1e-9);
    EXPECT_GE(enough.pose->phi.from, -80 * degree - 1e-9);

    options.max_nodes = 0;
    options.limits.phi = {-59 * degree, 59 * degree};
    EXPECT_EQ(whole_cone_search(grid, map, options).machinable, Answer::Undecided);
}

TEST(WholeConeSearch, TurnsThePartIntoOneSidedLimits)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const std::vector<Vec3> walls{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    const VisibilityMap map = caps(grid, walls, 40 * degree);
    WholeConeSearchOptions options;
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        options.family = family;
        options.limits.phi = {-100 * degree, 5 * degree};
        options.limits.theta = {-10 * degree, 90 * degree};
        const auto result = whole_cone_search(grid, map, options);
        ASSERT_EQ(result.machinable, Answer::Yes);
        const FittedPose& fitted = *result.pose;
        EXPECT_LT(worst_miss(grid, map, fitted, family), 1e-9);
        EXPECT_GE(fitted.phi.from, options.limits.phi.from - 1e-9);
        EXPECT_LE(fitted.phi.to, options.limits.phi.to + 1e-9);
        EXPECT_GE(fitted.theta.from, options.limits.theta.from - 1e-9);
        EXPECT_LE(fitted.theta.to, options.limits.theta.to + 1e-9);
        EXPECT_NEAR(fitted.pose.tool_axis.dot(fitted.pose.r2_axis), 0, 1e-15);
    }
}

TEST(WholeConeSearch, IsNeverWorseThanAGivenPose)
{
    const SphereGrid grid = sphere_grid("hex:4");
    std::mt19937 random{3};
    const VisibilityMap map = random_map(grid, 12, random);
    WholeConeSearchOptions options;
    const auto best = whole_cone_search(grid, map, options);
    options.max_nodes = 0;
    const std::vector<SetupPose> starts{best.pose->pose};
    options.starts = starts;
    EXPECT_LE(whole_cone_search(grid, map, options).objective,
              best.objective * (1 + 1e-12));
}

TEST(WholeConeSearch, IsTheSameForAnyNumberOfThreads)
{
    const SphereGrid grid = sphere_grid("hex:4");
    std::mt19937 random{5};
    const VisibilityMap map = random_map(grid, 15, random);
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        WholeConeSearchOptions options;
        options.family = family;
        set_thread_count(1);
        const auto alone = whole_cone_search(grid, map, options);
        set_thread_count(8);
        const auto together = whole_cone_search(grid, map, options);
        EXPECT_EQ(alone.objective, together.objective);
        EXPECT_EQ(alone.lower_bound, together.lower_bound);
        EXPECT_EQ(alone.nodes, together.nodes);
        EXPECT_EQ(alone.pose->pose.tool_axis, together.pose->pose.tool_axis);
        EXPECT_EQ(alone.pose->pose.r2_axis, together.pose->pose.r2_axis);
    }
    set_thread_count(int(std::max(std::thread::hardware_concurrency(), 1U)));
}

TEST(WholeConeSearch, ReportsProgressAndTheBoundAtTheEnd)
{
    const SphereGrid grid = sphere_grid("hex:4");
    std::mt19937 random{5};
    const VisibilityMap map = random_map(grid, 15, random);
    std::vector<WholeConeSearchProgress> told;
    WholeConeSearchOptions options;
    const auto silent = whole_cone_search(grid, map, options);
    options.progress = [&](const WholeConeSearchProgress& now) { told.push_back(now); };
    const auto result = whole_cone_search(grid, map, options);
    EXPECT_EQ(result.objective, silent.objective);
    EXPECT_EQ(result.lower_bound, silent.lower_bound);
    ASSERT_FALSE(told.empty());
    for (std::size_t k = 1; k < told.size(); ++k) {
        EXPECT_GT(told[k].nodes, told[k - 1].nodes);
        EXPECT_LE(*told[k].objective, *told[k - 1].objective);
    }
    for (const WholeConeSearchProgress& now : told)
        EXPECT_LE(now.lower_bound, *now.objective);
    EXPECT_EQ(told.back().nodes, result.nodes);
    EXPECT_EQ(told.back().lower_bound, result.lower_bound);
    options.progress = [](const WholeConeSearchProgress&) { throw LimitError{"enough"}; };
    EXPECT_THROW(whole_cone_search(grid, map, options), LimitError);
}

TEST(WholeConeSearch, NeedsNoRangeIfOneDirectionReachesAll)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const std::vector<Vec3> tops{{0, 0, 1}, {0.1, 0, 1}, {0, -0.1, 1}};
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        WholeConeSearchOptions options;
        options.family = family;
        const auto result =
            whole_cone_search(grid, caps(grid, tops, 60 * degree), options);
        EXPECT_NEAR(result.objective, options.floor_rad * options.floor_rad, 1e-9);
        EXPECT_LT(result.ranges.width + result.ranges.height(), 1e-6);
    }
}

TEST(WholeConeSearch, FindsAPoseWithoutCones)
{
    const SphereGrid grid = sphere_grid("hex:2");
    const auto result =
        whole_cone_search(grid, VisibilityMap{3, grid.centres.size()}, {});
    EXPECT_EQ(result.machinable, Answer::Yes);
    EXPECT_EQ(result.pose->area, 0);
}

TEST(WholeConeSearch, RefusesArgumentsOutsideItsDomain)
{
    const SphereGrid grid = sphere_grid("hex:2");
    EXPECT_THROW(whole_cone_search(grid, VisibilityMap{3, 7}, {}), DomainError);
    const VisibilityMap map{3, grid.centres.size()};
    WholeConeSearchOptions options;
    options.gap = 0;
    EXPECT_THROW(whole_cone_search(grid, map, options), DomainError);
    options.gap = 0.05;
    options.floor_rad = 0;
    EXPECT_THROW(whole_cone_search(grid, map, options), DomainError);
}

}  // namespace
}  // namespace endmill
