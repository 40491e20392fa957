// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/pose_search.h"

#include <map>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "direction_sets.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/setup/detail/rectangle_fit.h"
#include "endmill/setup/detail/sector_fit.h"
#include "endmill/setup/detail/setup_order.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"
#include "teapot.h"

namespace endmill {
namespace {

using std::numbers::pi;

using test::degree;
using test::direction;
using test::square_degrees;
using test::up;

struct Part {
    std::vector<Vec3> centres;
    VisibilityMap map;
};

const Part& teapot(const std::string& grid, double incidence_deg = 90)
{
    static std::map<std::string, Part> parts;
    const std::string key = grid + " " + std::to_string(incidence_deg);
    if (!parts.contains(key)) {
        const std::vector<Vec3> centres = sphere_grid(grid).centres;
        VisibilityOptions options;
        options.incidence = Angle::degrees(incidence_deg);
        parts[key] = {centres, part_visibility(test::teapot(), centres, options).map};
    }
    return parts[key];
}

PoseSearchResult search(const Part& part, RotaryFamily family, SetupMode mode,
                        const RotaryLimits& limits = {})
{
    return pose_search(part.map, part.centres, {family, mode, limits});
}

// Cones of the facets of a convex part: caps of half angle `open_deg` about their
// normals.
Part part_of_caps(const std::string& grid, const std::vector<Vec3>& normals,
                  double open_deg)
{
    const std::vector<Vec3> centres = sphere_grid(grid).centres;
    Part part{centres, VisibilityMap{normals.size(), centres.size()}};
    for (std::size_t cell = 0; cell < centres.size(); ++cell) {
        for (std::size_t j = 0; j < normals.size(); ++j) {
            if (normals[j].dot(centres[cell]) > std::cos(open_deg * degree))
                part.map.column(cell)[j / 64] |= std::uint64_t{1} << (j % 64);
        }
    }
    return part;
}

struct TeapotRow {
    std::string grid;
    double sector;        // C,A
    double wide_sector;   // C,A, corrected
    double literal;       // A,B
    double literal_true;  // area of the same pose with all directions
    double paper;         // A,B
    double corrected;     // A,B
};

class TeapotOnAGrid : public testing::TestWithParam<TeapotRow> {};

TEST_P(TeapotOnAGrid, HasTheAreasOfTheTable)
{
    const TeapotRow& row = GetParam();
    const Part& part = teapot(row.grid);
    const auto least = [&](RotaryFamily family, SetupMode mode) {
        return search(part, family, mode).least;
    };
    // The table has two decimals.
    for (const SetupMode mode : {SetupMode::PaperLiteral, SetupMode::Paper}) {
        const auto found = least(RotaryFamily::CA, mode);
        EXPECT_NEAR(square_degrees(found->area), row.sector, 0.006);
        EXPECT_GT(found->pose.tool_axis.x(), 0);
    }
    EXPECT_NEAR(square_degrees(least(RotaryFamily::CA, SetupMode::Corrected)->area),
                row.wide_sector, 0.006);
    const auto literal = least(RotaryFamily::AB, SetupMode::PaperLiteral);
    EXPECT_NEAR(square_degrees(literal->area), row.literal, 0.006);
    std::vector<Vec3> nearest;
    for (const std::size_t cell : nearest_cells(part.map, part.centres, literal->cell))
        nearest.push_back(part.centres[cell]);
    EXPECT_NEAR(square_degrees(rectangle_about(literal->pose.tool_axis,
                                               literal->pose.r1_axis, nearest)
                                   .area()),
                row.literal_true, 0.006);
    EXPECT_NEAR(square_degrees(least(RotaryFamily::AB, SetupMode::Paper)->area),
                row.paper, 0.006);
    EXPECT_NEAR(square_degrees(least(RotaryFamily::AB, SetupMode::Corrected)->area),
                row.corrected, 0.006);
}

INSTANTIATE_TEST_SUITE_P(OfTheTable, TeapotOnAGrid,
                         testing::Values(TeapotRow{"hex:10", 18988.30, 18988.30, 8760.23,
                                                   9223.92, 9161.98, 9151.83},
                                         TeapotRow{"cube:10", 20584.10, 20584.10, 7898.23,
                                                   8827.54, 8827.54, 8779.61},
                                         TeapotRow{"latlong:40x16", 19972.49, 19972.49,
                                                   9105.98, 10175.43, 9657.21, 9601.51},
                                         TeapotRow{"latlong:30x21", 19361.72, 18803.63,
                                                   9292.94, 11487.51, 10527.65, 9674.03},
                                         TeapotRow{"ico:3", 19770.26, 19770.26, 9526.26,
                                                   25157.47, 9952.07, 8533.93}));

// Fits each pose on its own, without bounds.
PoseSearchResult pose_by_pose(const Part& part, const PoseFitOptions& options)
{
    BestCandidate<FittedPose> least;
    BestCandidate<FittedPose> feasible;
    for (std::size_t pose = 0; pose < part.centres.size(); ++pose) {
        std::vector<Vec3> nearest;
        for (const std::size_t cell : nearest_cells(part.map, part.centres, pose))
            nearest.push_back(part.centres[cell]);
        PoseSearchResult found = pose_fit(part.centres[pose], nearest, options);
        for (auto* fit : {&found.least, &found.feasible})
            if (*fit)
                (*fit)->cell = pose;
        if (found.least)
            least.offer(*found.least, score_of(*found.least));
        if (found.feasible)
            feasible.offer(*found.feasible, score_of(*found.feasible));
    }
    PoseSearchResult result;
    result.least = least.best();
    result.feasible = feasible.best();
    return result;
}

void expect_same_pose(const std::optional<FittedPose>& found,
                      const std::optional<FittedPose>& expected)
{
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (found) {
        EXPECT_EQ(found->cell, expected->cell);
        EXPECT_EQ(found->area, expected->area);
        EXPECT_EQ(found->pose.r1_axis, expected->pose.r1_axis);
        EXPECT_EQ(found->pose.r2_axis, expected->pose.r2_axis);
    }
}

void expect_that_of_single_poses(const Part& part, const PoseFitOptions& options)
{
    const PoseSearchResult expected = pose_by_pose(part, options);
    for (const int threads : {1, 3, 8, 8, 8}) {
        set_thread_count(threads);
        const PoseSearchResult found = pose_search(part.map, part.centres, options);
        expect_same_pose(found.least, expected.least);
        if (!found.feasible || found.feasible->cell != found.least->cell)
            expect_same_pose(found.feasible, expected.feasible);
    }
}

// Parts as symmetric as the grid. Their best poses are equal up to rounding.
TEST(PoseSearch, AgreesWithPosesFittedOneByOneOnAnyNumberOfThreads)
{
    std::vector<Vec3> normals = test::ring(6, 70);
    normals.push_back(up);
    const std::vector<Vec3> low = test::ring(3, 110);
    std::vector<Vec3> all_round = test::ring(6, 40);
    all_round.insert(all_round.end(), low.begin(), low.end());
    for (const auto& facets : {normals, all_round}) {
        const Part part = part_of_caps("hex:4", facets, 30);
        for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB})
            for (const double reach : {pi, 1.2, 0.6})
                expect_that_of_single_poses(
                    part,
                    {family, SetupMode::Corrected, {{-reach, reach}, {-reach, pi}}});
    }
    set_thread_count(4);
}

TEST(PoseSearch, HasTheRangesOfTheTableOnTheTeapot)
{
    const Part& part = teapot("hex:10");
    const auto sector = search(part, RotaryFamily::CA, SetupMode::Paper).least;
    EXPECT_NEAR(sector->phi.to / degree, 67.48, 0.006);
    EXPECT_NEAR(-sector->phi.from / degree, 57.08, 0.006);
    EXPECT_NEAR((sector->theta.to - sector->theta.from) / degree, 152.44, 0.006);
    const PoseSearchResult found = search(part, RotaryFamily::AB, SetupMode::Paper);
    EXPECT_EQ(found.poses_tried, 1200U);
    EXPECT_EQ(found.poses_skipped, 380U);
    EXPECT_EQ(found.status, SetupStatus::Ok);
    EXPECT_NEAR(found.least->phi.to / degree, 73.95, 0.006);
    EXPECT_NEAR(-found.least->phi.from / degree, 63.47, 0.006);
    EXPECT_NEAR(-found.least->theta.from / degree, 39.22, 0.006);
    EXPECT_NEAR(found.least->theta.to / degree, 27.46, 0.006);
}

TEST(PoseSearch, HasTheAreasOfTheTableAtSmallerIncidence)
{
    const Part& steep = teapot("hex:10", 80);
    EXPECT_NEAR(
        square_degrees(search(steep, RotaryFamily::CA, SetupMode::Paper).least->area),
        24023.46, 0.006);
    const PoseSearchResult paper = search(steep, RotaryFamily::AB, SetupMode::Paper);
    EXPECT_NEAR(square_degrees(paper.least->area), 12816.08, 0.006);
    EXPECT_EQ(paper.poses_skipped, 935U);
    EXPECT_NEAR(
        square_degrees(search(steep, RotaryFamily::AB, SetupMode::Corrected).least->area),
        12107.99, 0.006);

    const Part& steeper = teapot("hex:10", 60);
    EXPECT_NEAR(
        square_degrees(search(steeper, RotaryFamily::CA, SetupMode::Paper).least->area),
        31452.16, 0.006);
    const PoseSearchResult none = search(steeper, RotaryFamily::AB, SetupMode::Paper);
    EXPECT_EQ(none.poses_skipped, 1200U);
    EXPECT_EQ(none.status, SetupStatus::NoOpenHemisphere);
    EXPECT_FALSE(none.least);
    const auto corrected = search(steeper, RotaryFamily::AB, SetupMode::Corrected).least;
    EXPECT_NEAR(square_degrees(corrected->area), 21156.10, 0.006);
    EXPECT_NEAR((corrected->phi.to - corrected->phi.from) / degree, 211.58, 0.006);
    EXPECT_NEAR((corrected->theta.to - corrected->theta.from) / degree, 99.99, 0.006);
}

TEST(PoseSearch, HasTheGroupsOfTheTableOnTheTeapot)
{
    for (const auto& [incidence, first_group, cells] :
         {std::tuple{90, 0.429, 79.6}, std::tuple{80, 0.359, 91.8},
          std::tuple{60, 0.219, 116.4}}) {
        const Part& part = teapot("hex:10", incidence);
        double accessible = 0;
        double found = 0;
        for (std::size_t pose = 0; pose < 1200; ++pose) {
            found +=
                static_cast<double>(nearest_cells(part.map, part.centres, pose).size());
            for (std::size_t facet = 0; facet < 288; ++facet)
                accessible += part.map.is_accessible(facet, pose) ? 1 : 0;
        }
        EXPECT_NEAR(accessible / 1200 / 288, first_group, 6e-4);
        EXPECT_NEAR(found / 1200, cells, 0.1);
    }
}

// The grid has both symmetries. If the bits of every facet move to the mirrored or turned
// cell, all areas stay the same.
TEST(PoseSearch, IsTheSameForATeapotMirroredOrTurned)
{
    const Part& part = teapot("hex:10");
    const Eigen::Matrix3d mirror = Vec3{1, -1, 1}.asDiagonal();
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd{60 * degree, Vec3::UnitZ()}.toRotationMatrix();
    for (const Eigen::Matrix3d& move : {mirror, turn}) {
        Part moved{part.centres, VisibilityMap{288, 1200}};
        for (std::size_t cell = 0; cell < 1200; ++cell) {
            std::size_t image = 0;
            for (std::size_t k = 0; k < 1200; ++k) {
                if (part.centres[k].dot(move * part.centres[cell]) >
                    part.centres[image].dot(move * part.centres[cell]))
                    image = k;
            }
            const auto from = part.map.column(cell);
            std::copy(from.begin(), from.end(), moved.map.column(image).begin());
        }
        for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
            for (const SetupMode mode :
                 {SetupMode::PaperLiteral, SetupMode::Paper, SetupMode::Corrected}) {
                const double area = search(part, family, mode).least->area;
                EXPECT_NEAR(search(moved, family, mode).least->area, area, 1e-7 * area);
            }
        }
    }
}

TEST(PoseSearch, DoesNotDependOnTheNumberOfThreads)
{
    const Part& part = teapot("hex:10", 80);
    const RotaryLimits limits{{-90 * degree, 100 * degree}, {-60 * degree, 60 * degree}};
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        for (const SetupMode mode : {SetupMode::Paper, SetupMode::Corrected}) {
            set_thread_count(1);
            const PoseSearchResult one = search(part, family, mode, limits);
            set_thread_count(8);
            const PoseSearchResult eight = search(part, family, mode, limits);
            const auto expect_same = [](const auto& a, const auto& b) {
                ASSERT_EQ(a.has_value(), b.has_value());
                if (!a)
                    return;
                EXPECT_EQ(a->cell, b->cell);
                EXPECT_EQ(a->area, b->area);
                EXPECT_EQ(a->phi, b->phi);
                EXPECT_EQ(a->theta, b->theta);
                EXPECT_EQ(a->pose.r1_axis, b->pose.r1_axis);
            };
            expect_same(one.least, eight.least);
            expect_same(one.feasible, eight.feasible);
            EXPECT_EQ(one.poses_skipped, eight.poses_skipped);
        }
    }
}

TEST(PoseSearch, FindsTheTeapotMachinableOnTheMachinesOfTheTable)
{
    const Part& part = teapot("hex:10");
    const auto is_machinable = [&](RotaryFamily family, double phi, double small_phi,
                                   double theta, double small_theta) {
        return search(part, family, SetupMode::Corrected,
                      {{-small_phi * degree, phi * degree},
                       {-small_theta * degree, theta * degree}})
            .feasible.has_value();
    };
    EXPECT_TRUE(is_machinable(RotaryFamily::CA, 70, 70, 76.25, 76.25));
    EXPECT_TRUE(is_machinable(RotaryFamily::AB, 75, 65, 30, 40));
    EXPECT_FALSE(is_machinable(RotaryFamily::AB, 30, 30, 30, 30));
    EXPECT_FALSE(is_machinable(RotaryFamily::CA, 40, 40, 60, 60));
}

// The five upper faces of a cube. From +Z the sides are reached by a tilt of 10 degrees.
TEST(PoseSearch, HasTheRingOfACubeAtItsPole)
{
    const std::vector<Vec3> normals{Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitX(),
                                    -Vec3::UnitY(), up};
    const std::vector<Vec3> ring = test::ring(4, 10);
    EXPECT_NEAR(
        square_degrees(
            pose_fit(up, ring, {RotaryFamily::CA, SetupMode::Paper, {}}).least->area),
        1800, 1e-6);
    EXPECT_NEAR(
        square_degrees(
            pose_fit(up, ring, {RotaryFamily::AB, SetupMode::Paper, {}}).least->area),
        200.505460, 1e-5);
    // On a grid each nearest cell is farther than the cap by at most the cover radius.
    const Part cube = part_of_caps("hex:10", normals, 80);
    const auto found = search(cube, RotaryFamily::AB, SetupMode::Corrected).least;
    EXPECT_LT(square_degrees(found->area),
              square_degrees(pose_fit(up, test::ring(4, 10 + 5.58),
                                      {RotaryFamily::AB, SetupMode::Paper, {}})
                                 .least->area));
}

// The bottoms of two long V-grooves along `along`, tilted about it from `above` by +-tilt
// degrees, with a half angle of `half` degrees. Their cones are wedges of directions.
Part two_grooves(const std::vector<Vec3>& centres, const Vec3& along, const Vec3& above,
                 double tilt, double half)
{
    Part part{centres, VisibilityMap{2, centres.size()}};
    for (std::size_t cell = 0; cell < centres.size(); ++cell) {
        const double turn =
            std::atan2(centres[cell].dot(along.cross(above)), centres[cell].dot(above)) /
            degree;
        for (std::size_t groove = 0; groove < 2; ++groove) {
            if (std::abs(turn - (groove == 0 ? tilt : -tilt)) < half)
                part.map.column(cell)[0] |= std::uint64_t{1} << groove;
        }
    }
    return part;
}

// In every mode and family, the tool turns about `axis` by `turn` and about no other
// axis.
void expect_one_turn(const Part& part, double turn, const Vec3& axis)
{
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        for (const SetupMode mode :
             {SetupMode::PaperLiteral, SetupMode::Paper, SetupMode::Corrected}) {
            const PoseSearchResult found = search(part, family, mode);
            ASSERT_TRUE(found.feasible);
            const FittedPose& fitted = *found.feasible;
            EXPECT_EQ(found.status, SetupStatus::FourAxis);
            EXPECT_NEAR(fitted.phi.to - fitted.phi.from, turn, 1e-9);
            EXPECT_NEAR(fitted.theta.to - fitted.theta.from, 0, 1e-9);
            const Vec3& turned_about =
                family == RotaryFamily::CA ? fitted.pose.r2_axis : fitted.pose.r1_axis;
            EXPECT_NEAR(std::abs(turned_about.dot(axis)), 1, 1e-9);
        }
    }
}

// The only directions lie across the grooves, at odd multiples of half a degree. The tool
// turns by 2 (tilt - half), and by half a degree more at both ends.
TEST(PoseSearch, TurnsFromGrooveToGrooveAboutTheirDirection)
{
    const Vec3 along = Vec3{1, 9, 3}.normalized();
    const Vec3 above = along.unitOrthogonal();
    std::vector<Vec3> centres;
    for (int k = 0; k < 360; ++k)
        centres.push_back(Eigen::AngleAxisd{(k + 0.5) * degree, along} * above);
    for (const auto& [tilt, half] : {std::pair{40, 15}, {30, 25}, {70, 10}})
        expect_one_turn(two_grooves(centres, along, above, tilt, half),
                        (2 * (tilt - half) + 1) * degree, along);
}

// On a grid the nearest two directions of both grooves lie off that plane. With the tool
// along one of them, the other is the only direction to reach.
TEST(PoseSearch, TurnsFromGrooveToGrooveByTheLeastAngleOfTwoCells)
{
    const Vec3 along = Vec3{1, 9, 3}.normalized();
    const std::vector<Vec3> centres = sphere_grid("hex:10").centres;
    const Part part = two_grooves(centres, along, along.unitOrthogonal(), 40, 15);
    double least = 10;
    Vec3 axis;
    for (std::size_t a = 0; a < centres.size(); ++a) {
        for (std::size_t b = 0; b < centres.size(); ++b) {
            const double angle = 2 * std::asin((centres[a] - centres[b]).norm() / 2);
            if (part.map.is_accessible(0, a) && part.map.is_accessible(1, b) &&
                angle < least) {
                least = angle;
                axis = centres[a].cross(centres[b]).normalized();
            }
        }
    }
    expect_one_turn(part, least, axis);
}

TEST(PoseSearch, NeedsNoTurnForAPlanarPatch)
{
    const Part plate = part_of_caps("hex:4", {up, up}, 60);
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        for (const SetupMode mode :
             {SetupMode::PaperLiteral, SetupMode::Paper, SetupMode::Corrected}) {
            const PoseSearchResult found = search(plate, family, mode);
            EXPECT_EQ(found.status, SetupStatus::ThreeAxis);
            EXPECT_EQ(found.feasible->area, 0);
            EXPECT_GT(found.feasible->pose.tool_axis.z(), 0.5);
            const SetupPose& pose = found.feasible->pose;
            EXPECT_NEAR(pose.r2_axis.norm(), 1, 1e-12);
            EXPECT_NEAR(pose.r2_axis.dot(pose.tool_axis), 0, 1e-12);
        }
    }
}

// Facets with empty cones are left out. A part of such facets only needs no range.
TEST(PoseSearch, LeavesOutEmptyCones)
{
    const std::vector<Vec3> centres = sphere_grid("hex:2").centres;
    const Part part{centres, VisibilityMap{3, centres.size()}};
    EXPECT_EQ(search(part, RotaryFamily::AB, SetupMode::Paper).status,
              SetupStatus::ThreeAxis);
}

// Random convex parts: the area of `Corrected` is never above that of `Paper`, in both
// families.
TEST(PoseSearch, IsNeverWorseCorrected)
{
    test::Random random{61};
    for (int i = 0; i < 60; ++i) {
        std::vector<Vec3> normals;
        normals.reserve(20);
        for (int k = 0; k < 2 + i % 19; ++k)
            normals.push_back(
                direction({random.uniform(0, 360), random.uniform(0, 120)}));
        const Part part = part_of_caps("hex:4", normals, random.uniform(30, 89));
        for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
            const auto paper = search(part, family, SetupMode::Paper).least;
            const auto corrected = search(part, family, SetupMode::Corrected).least;
            ASSERT_TRUE(corrected);
            if (paper) {
                EXPECT_LE(corrected->area, paper->area * (1 + 1e-7) + 1e-12);
            }
        }
    }
}

TEST(PoseSearch, NeedsACentreOfUnitLengthForEachCell)
{
    const VisibilityMap map{1, 2};
    EXPECT_THROW(pose_search(map, std::vector{up}, {}), DomainError);
    EXPECT_THROW(pose_search(map, std::vector<Vec3>{up, 2 * up}, {}), DomainError);
    EXPECT_THROW(pose_fit(2 * up, {}, {}), DomainError);
}

// A function that finds the same cells in another order of tool axes and facets.
TEST(PoseSearch, IsTheSameWithTheNearestCellsOfSharesOfTheFacets)
{
    const Part& part = teapot("hex:4");
    int calls = 0;
    const auto by_shares = [&](const VisibilityMap& map, std::span<const Vec3> centres,
                               const NearestCellsVisit& visit) {
        ++calls;
        std::vector<std::uint64_t> rows =
            nearest_cell_rows(facet_share(map, 0, 2), centres);
        const auto others = nearest_cell_rows(facet_share(map, 1, 2), centres);
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i] |= others[i];
        for_each_row_of_cells(rows, centres, visit);
    };
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        PoseFitOptions options{family, SetupMode::Corrected, {{-1.4, 1.4}, {-1.3, 1.3}}};
        const PoseSearchResult whole = pose_search(part.map, part.centres, options);
        const auto poses = poses_within_limits(part.map, part.centres, options);
        options.nearest_cells = by_shares;
        const PoseSearchResult found = pose_search(part.map, part.centres, options);
        expect_same_pose(found.least, whole.least);
        expect_same_pose(found.feasible, whole.feasible);
        const auto poses_of_shares = poses_within_limits(part.map, part.centres, options);
        ASSERT_EQ(poses_of_shares.size(), poses.size());
        for (std::size_t i = 0; i < poses.size(); ++i)
            expect_same_pose(poses_of_shares[i], poses[i]);
    }
    EXPECT_EQ(calls, 4);
}

TEST(PoseSearch, ReportsTwoStepsForEachPose)
{
    const Part& part = teapot("hex:4");
    PoseFitOptions options{RotaryFamily::AB, SetupMode::Corrected};
    std::size_t told = 0;
    options.progress = [&](std::size_t done) { EXPECT_EQ(done, ++told); };
    const PoseSearchResult found = pose_search(part.map, part.centres, options);
    EXPECT_EQ(told, 2 * part.centres.size());
    options.progress = {};
    EXPECT_EQ(pose_search(part.map, part.centres, options).least->area,
              found.least->area);
}

}  // namespace
}  // namespace endmill
