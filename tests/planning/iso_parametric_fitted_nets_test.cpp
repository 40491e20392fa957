// SPDX-License-Identifier: GPL-3.0-or-later The nets fitted to the paper's tables. Three
// independent programs agree on their 108 cells and on further results of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "endmill/planning/economy.h"
#include "endmill/planning/iso_parametric.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/largest_cutter.h"
#include "random.h"

namespace endmill {
namespace {

const std::string folder = ENDMILL_SOURCE_DIR "/datasets/surfaces/";

Surface fitted_net(const std::string& name)
{
    std::ifstream file{folder + name + ".json"};
    const nlohmann::json json = nlohmann::json::parse(file);
    std::vector<Vec3> net;
    for (const auto& row : json.at("control_points"))
        for (const auto& point : row)
            net.emplace_back(point.at(0), point.at(1), point.at(2));
    return composite_bezier(json.at("patches_u"), json.at("patches_v"), net);
}

struct Cell {
    std::string net;
    Parameter direction;
    double tolerance_mm;
    double diameter_mm;
    std::size_t ncl;
    std::size_t passes;
    double tcd_mm;
};

std::vector<Cell> cells()
{
    std::ifstream file{folder + "fitted-nets-cells.csv"};
    std::string line;
    std::getline(file, line);
    std::vector<Cell> cells;
    while (std::getline(file, line)) {
        std::istringstream row{line};
        std::array<std::string, 7> fields;
        for (std::string& field : fields)
            std::getline(row, field, ',');
        cells.push_back({fields[0], fields[1] == "u" ? Parameter::U : Parameter::V,
                         std::stod(fields[2]), std::stod(fields[3]),
                         std::stoul(fields[4]), std::stoul(fields[5]),
                         std::stod(fields[6])});
    }
    return cells;
}

IsoParametricOptions options_of(const Cell& cell)
{
    IsoParametricOptions options;
    options.direction = cell.direction;
    options.chord_tolerance = cell.tolerance_mm;
    options.scallop_height = cell.tolerance_mm;
    return options;
}

PathEconomy economy_of(const Surface& surface, double diameter_mm,
                       const IsoParametricOptions& options)
{
    return path_economy(
        plan_iso_parametric(surface, BallCutter{diameter_mm / 2}, options).path);
}

double tcd(const PathEconomy& economy)
{
    return economy.cut.contact_mm + economy.link.contact_mm;
}

TEST(FittedNets, HaveTheirCellsPointByPoint)
{
    std::map<std::string, Surface> nets;
    const std::vector<Cell> all = cells();
    ASSERT_EQ(all.size(), 108U) << "6 nets, 2 directions, 3 tolerances, 3 cutters";
    for (const Cell& cell : all) {
        const Surface& surface =
            nets.try_emplace(cell.net, fitted_net(cell.net)).first->second;
        const PathEconomy economy =
            economy_of(surface, cell.diameter_mm, options_of(cell));
        EXPECT_EQ(economy.ncl, cell.ncl) << cell.net;
        EXPECT_EQ(economy.passes, cell.passes) << cell.net;
        EXPECT_LT(test::relative_error(tcd(economy), cell.tcd_mm), 1e-6) << cell.net;
    }
}

TEST(FittedNets, DefaultExampleHasTheTravelOfItsTipsAndItsLinks)
{
    const Surface surface = fitted_net("net_rot24_7D");
    struct {
        Parameter direction;
        double tip_mm, link_mm;
    } const rows[] = {{Parameter::U, 21850.4, 269.1}, {Parameter::V, 19303.3, 503.7}};
    for (const auto& [direction, tip_mm, link_mm] : rows) {
        const PathEconomy economy =
            economy_of(surface, 15, options_of({"", direction, 0.5, 15, 0, 0, 0}));
        EXPECT_NEAR(economy.cut.tip_mm + economy.link.tip_mm, tip_mm, 0.05);
        EXPECT_NEAR(economy.link.contact_mm, link_mm, 0.05);
    }
}

TEST(FittedNets, AreSmoothAndHaveTheirLimits)
{
    struct {
        const char* name;
        double radius_mm;
    } const nets[] = {{"net_rot24_7D", 10.009374}, {"net_full48_41D", 10.2832},
                      {"net_symU24_7D", 12.2265},  {"net_rot24_1A", 10.2177},
                      {"net_symV24_1A", 13.4334},  {"net_sym12_1A", 12.8664}};
    for (const auto& [name, radius_mm] : nets) {
        const Surface surface = fitted_net(name);
        EXPECT_EQ(continuity(surface).continuity, Continuity::G1) << name;
        const auto limit = largest_cutter_by_curvature(surface, 1);
        ASSERT_TRUE(limit);
        EXPECT_NEAR(limit->radius_mm, radius_mm, 1e-4) << name;
    }
}

TEST(FittedNets, LargestCutterOfTheDefaultExampleStandsAtItsPlaceOrTheMirroredOne)
{
    const auto limit = largest_cutter(fitted_net("net_rot24_7D"), 1);
    ASSERT_TRUE(limit);
    EXPECT_NEAR(limit->radius_mm, 10.009374, 1e-6);
    const bool is_mirrored = limit->at.u < 1.5;
    EXPECT_NEAR(is_mirrored ? 3 - limit->at.u : limit->at.u, 2.1310, 1e-4);
    EXPECT_NEAR(is_mirrored ? 2 - limit->at.v : limit->at.v, 1.6198, 1e-4);
}

// Mean change in percent of the points and of the travel, along u and along v, over the
// nine cells.
struct Change {
    double ncl_u, ncl_v, tcd_u, tcd_v;
};

Change mean_change(const std::function<void(IsoParametricOptions&)>& policy)
{
    static const Surface surface = fitted_net("net_rot24_7D");
    Change change{0, 0, 0, 0};
    for (const Cell& cell : cells()) {
        if (cell.net != "net_rot24_7D")
            continue;
        IsoParametricOptions options = options_of(cell);
        policy(options);
        const PathEconomy economy = economy_of(surface, cell.diameter_mm, options);
        const bool along_u = cell.direction == Parameter::U;
        (along_u ? change.ncl_u : change.ncl_v) +=
            100 * (double(economy.ncl) / double(cell.ncl) - 1) / 9;
        (along_u ? change.tcd_u : change.tcd_v) +=
            100 * (tcd(economy) / cell.tcd_mm - 1) / 9;
    }
    return change;
}

// The table of an independent program, rounded to `digit` percent.
TEST(FittedNets, PoliciesChangeThePathsAsAnIndependentProgramFound)
{
    using Options = IsoParametricOptions;
    struct {
        const char* name;
        std::function<void(Options&)> policy;
        Change expected;
        double digit;
    } const rows[] = {
        {"stop at borders",
         [](Options& o) { o.patch_borders = PatchBorders::Stop; },
         {7.9, 6.2, 1.1, 0.2},
         0.1},
        {"end free",
         [](Options& o) { o.end_point = EndPoint::Free; },
         {-5.8, -14.3, -5.0, -13.5},
         0.1},
        {"last none",
         [](Options& o) { o.last_path = LastPath::None; },
         {-0.9, -1.0, -2.3, -1.3},
         0.1},
        {"last half",
         [](Options& o) { o.last_path = LastPath::Half; },
         {-0.5, -0.7, -1.2, -0.9},
         0.1},
        {"first",
         [](Options& o) { o.governing = Governing::First; },
         {-44, -29, -46, -27},
         1},
        {"mean",
         [](Options& o) { o.governing = Governing::Mean; },
         {-45, -38, -46, -36},
         1},
        {"max",
         [](Options& o) { o.governing = Governing::Max; },
         {-64, -53, -64, -51},
         1},
        {"normal",
         [](Options& o) { o.step_curvature = StepCurvature::Normal; },
         {-26, -15, -6, -3},
         2},
        {"alternate",
         [](Options& o) { o.march = March::Alternate; },
         {0.9, 0.0, -0.3, -0.2},
         0.1},
        {"h / 2", [](Options& o) { o.scallop_height /= 2; }, {39, 39, 38, 37}, 1}};
    for (const auto& [name, policy, expected, digit] : rows) {
        const Change change = mean_change(policy);
        EXPECT_NEAR(change.ncl_u, expected.ncl_u, 0.51 * digit) << name;
        EXPECT_NEAR(change.ncl_v, expected.ncl_v, 0.51 * digit) << name;
        EXPECT_NEAR(change.tcd_u, expected.tcd_u, 0.51 * digit) << name;
        EXPECT_NEAR(change.tcd_v, expected.tcd_v, 0.51 * digit) << name;
    }
}

struct Ball {
    Vec3 contact;
    Vec3 centre;
};

Ball ball_at(const Surface& surface, const SurfacePoint& at, double radius)
{
    const SurfaceTangents tangents = surface.tangents(at.u, at.v);
    return {tangents.point, tangents.point + radius * unit_normal(tangents)};
}

// Height above the surface of the point where the two balls meet, in the plane of their
// centres and contacts.
double cusp_height(const Surface& surface, const GoverningPoint& pair, double radius)
{
    const Ball one = ball_at(surface, pair.at, radius);
    const Ball other = ball_at(surface, pair.partner, radius);
    const Vec3 across = other.centre - one.centre;
    Vec3 down = one.contact + other.contact - one.centre - other.centre;
    down -= down.dot(across) / across.squaredNorm() * across;
    const Vec3 cusp =
        (one.centre + other.centre) / 2 +
        std::sqrt(radius * radius - across.squaredNorm() / 4) * down.normalized();
    double u = (pair.at.u + pair.partner.u) / 2;
    double v = (pair.at.v + pair.partner.v) / 2;
    for (int step = 0; step < 20;
         ++step) {  // Gauss and Newton's foot of the perpendicular
        const SurfaceTangents tangents = surface.tangents(u, v);
        Eigen::Matrix<double, 3, 2> partials;
        partials << tangents.du, tangents.dv;
        const Eigen::Vector2d move = (partials.transpose() * partials).inverse() *
                                     (partials.transpose() * (cusp - tangents.point));
        u += move[0];
        v += move[1];
    }
    return (surface.tangents(u, v).point - cusp).norm();
}

TEST(FittedNets, GoverningPointsLeaveTheRequestedScallop)
{
    const Surface surface = fitted_net("net_rot24_7D");
    for (const Cell& cell : cells()) {
        if (cell.net != "net_rot24_7D")
            continue;
        const double radius = cell.diameter_mm / 2;
        const IsoParametricPlan plan =
            plan_iso_parametric(surface, BallCutter{radius}, options_of(cell));
        std::vector<double> shares;
        for (const auto& pair : plan.governing)
            if (pair)
                shares.push_back(cusp_height(surface, *pair, radius) / cell.tolerance_mm);
        std::ranges::sort(shares);
        EXPECT_NEAR(shares[shares.size() / 2], 1, 0.01) << "the median";
        EXPECT_GT(shares.front(), 0.88);
        EXPECT_LT(shares.back(), 1.12);
    }
}

}  // namespace
}  // namespace endmill
