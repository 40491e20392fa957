// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/axis_field.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;

JudgedAxis all_allowed(std::size_t, const Vec3&, const Inclination&)
{
    return {};
}

LeanRange range(double from_deg, double to_deg)
{
    return {Angle::degrees(from_deg), Angle::degrees(to_deg)};
}

// Contacts on a sphere of radius 40 along a great circle through its top, from -half to half.
std::vector<FieldContact> arch(double half_deg, int count)
{
    std::vector<FieldContact> contacts;
    for (int k = 0; k < count; ++k) {
        const double at = half_deg * degree * (2.0 * k / (count - 1) - 1);
        const Vec3 normal{std::sin(at), 0, std::cos(at)};
        contacts.push_back({{40 * normal, normal},
                            {std::cos(at), 0, -std::sin(at)},
                            40 * (at + half_deg * degree),
                            k == 0,
                            {}});
    }
    return contacts;
}

double travel_deg(const std::vector<Vec3>& axes)
{
    double sum = 0;
    for (std::size_t k = 1; k < axes.size(); ++k)
        sum += angle_between(axes[k - 1], axes[k]);
    return sum / degree;
}

TEST(InclinationOf, InvertsInclinedAxis)
{
    const Vec3 normal = Vec3{1, -2, 3}.normalized();
    const Vec3 feed = normal.unitOrthogonal();
    for (const double lead : {-80.0, -3.0, 0.0, 20.0, 88.0})
        for (const double tilt : {-88.0, 0.0, 35.0}) {
            const Inclination found = inclination_of(
                inclined_axis(normal, feed, {Angle::degrees(lead), Angle::degrees(tilt)}),
                normal, feed);
            EXPECT_NEAR(found.lead.degrees(), lead, 1e-10);
            EXPECT_NEAR(found.tilt.degrees(), tilt, 1e-10);
        }
}

// The candidates of two contacts whose frames differ are the same directions where their ranges
// overlap, and every direction of the ranges has one near it.
TEST(AxisCandidates, AreAGridInSpaceOfAboutEightyOneDirections)
{
    AxisFieldOptions options;
    FieldContact upright = arch(10, 3)[1];
    FieldContact turned = arch(10, 3)[2];
    upright.wanted.lead = turned.wanted.lead = Angle::degrees(50);  // out of the range
    const auto first = axis_candidates(upright, options);
    const auto second = axis_candidates(turned, options);
    EXPECT_NEAR(static_cast<double>(first.size()), 81, 12);
    std::size_t common = 0;
    for (const Vec3& axis : first) {
        EXPECT_TRUE(is_within(
            options, inclination_of(axis, upright.contact.normal, upright.feed)));
        for (const Vec3& other : second)
            common += axis == other ? 1 : 0;
    }
    EXPECT_GT(common, first.size() / 2);
    for (double lead = -28; lead < 29; lead += 4)
        for (double tilt = -28; tilt < 29; tilt += 4) {
            const Vec3 axis = inclined_axis(upright.contact.normal, upright.feed,
                                            {Angle::degrees(lead), Angle::degrees(tilt)});
            double nearest = std::numeric_limits<double>::infinity();
            for (const Vec3& candidate : first)
                nearest = std::min(nearest, angle_between(axis, candidate));
            EXPECT_LT(nearest, 7 * degree);
        }
}

TEST(AxisCandidates, OfANarrowRangeAreInclinations)
{
    AxisFieldOptions options;
    options.lead = range(10, 10);
    options.tilt = range(-8, 8);
    const FieldContact contact = arch(10, 3)[2];
    const auto found = axis_candidates(contact, options);
    ASSERT_EQ(found.size(), 9U);
    for (std::size_t k = 0; k < 9; ++k) {
        const Inclination at =
            inclination_of(found[k], contact.contact.normal, contact.feed);
        EXPECT_NEAR(at.lead.degrees(), 10, 1e-10);
        EXPECT_NEAR(at.tilt.degrees(), -8 + 2 * static_cast<double>(k), 1e-10);
    }
}

// All ways through random allowed sets, against the cost of the shortest one.
TEST(AxisField, IsTheShortestOfAllWaysThroughSmallGraphs)
{
    AxisFieldOptions options;
    options.lead = range(-8, 8);
    options.tilt = range(0, 0);  // nine inclinations
    options.layer_turn = Angle::degrees(0);
    options.greatest_turn = Angle::degrees(9);
    options.lean_weight = 0.05;
    options.smoothing_rounds = 0;
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        const auto contacts = arch(6, 5);
        std::mt19937 random{seed};
        std::vector<std::vector<Vec3>> allowed(contacts.size());
        std::vector<std::vector<double>> lost(contacts.size());
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            auto candidates = axis_candidates(contacts[k], options);
            candidates.erase(candidates.begin());  // the wanted one is in the grid too
            for (const Vec3& axis : candidates)
                if (random() % 3 != 0) {
                    allowed[k].push_back(axis);
                    lost[k].push_back(static_cast<double>(random() % 100) / 100);
                }
        }
        const auto number = [&](std::size_t contact, const Vec3& axis) {
            for (std::size_t k = 0; k < allowed[contact].size(); ++k)
                if ((allowed[contact][k] - axis).norm() < 1e-9)
                    return k;
            return std::size_t{99};
        };
        const AxisJudge judge = [&](std::size_t contact, const Vec3& axis,
                                    const Inclination&) -> JudgedAxis {
            const std::size_t k = number(contact, axis);
            if (k == 99)
                return {.broken = AxisRule::Cutter};
            return {.lost_width = lost[contact][k]};
        };
        double least = std::numeric_limits<double>::infinity();
        std::vector<Vec3> way(contacts.size());
        const std::function<void(std::size_t, double)> go = [&](std::size_t k,
                                                                double cost) {
            if (k == contacts.size()) {
                least = std::min(least, cost);
                return;
            }
            for (std::size_t j = 0; j < allowed[k].size(); ++j) {
                way[k] = allowed[k][j];
                const double turn =
                    k == 0 ? 0 : angle_between(way[k - 1], way[k]) / degree;
                if (turn > 9)
                    continue;
                const double lead =
                    inclination_of(way[k], contacts[k].contact.normal, contacts[k].feed)
                        .lead.degrees();
                go(k + 1,
                   cost + turn + 0.05 * lead * lead + options.width_weight * lost[k][j]);
            }
        };
        go(0, 0);
        if (std::isinf(least)) {
            EXPECT_THROW(axis_field(contacts, judge, options), GeometryError);
            continue;
        }
        const AxisField field = axis_field(contacts, judge, options);
        EXPECT_NEAR(field.path_cost, least, 1e-9) << seed;
        for (std::size_t k = 0; k < contacts.size(); ++k)
            EXPECT_NE(number(k, field.axes[k]), 99U);
    }
}

// Check: on an arch of 50 degrees an axis may stand still within leads of 30 degrees. The lead of
// the contact would turn by 50 degrees.
TEST(AxisField, StandsStillWhereTheRangesAllowIt)
{
    AxisFieldOptions options;
    options.lean_weight = 0;
    const auto contacts = arch(25, 200);
    const AxisField field = axis_field(contacts, all_allowed, options);
    EXPECT_LT(travel_deg(field.axes), 1e-6);
    EXPECT_LT(field.layers, contacts.size() / 2);
    // over a larger arch it turns by no more than what the ranges lack, and a step of the grid
    const auto large = arch(50, 400);
    const double travel = travel_deg(axis_field(large, all_allowed, options).axes);
    EXPECT_GE(travel, 100 - 60 - 1e-9);
    EXPECT_LE(travel, 100 - 60 + 8);
}

// A wall at y = 0 on the left of the feed: the axis must tilt away from it by 10 degrees on the
// middle third.
TEST(AxisField, TiltsAwayFromAWallAndSmoothingStaysAllowed)
{
    auto contacts = arch(10, 301);
    for (std::size_t k = 150; k < contacts.size(); ++k)
        contacts[k].way_mm += 3;  // a longer way between two rows
    const AxisJudge judge = [&](std::size_t contact, const Vec3&,
                                const Inclination& inclination) -> JudgedAxis {
        if (contact >= 100 && contact < 200 && inclination.tilt.degrees() > -10)
            return {.broken = AxisRule::Shank};
        return {};
    };
    AxisFieldOptions options;
    options.lean_weight = 1;  // else the axis would tilt everywhere
    options.smoothing_rounds = 0;
    const AxisField rough = axis_field(contacts, judge, options);
    options.smoothing_rounds = 20;
    const AxisField smooth = axis_field(contacts, judge, options);
    EXPECT_GT(smooth.rounds, 1);
    EXPECT_DOUBLE_EQ(smooth.rough_bend, rough.rough_bend);
    EXPECT_LT(smooth.smooth_bend, 0.8 * rough.rough_bend);
    const auto bend = [&](const std::vector<Vec3>& axes) {
        double sum = 0;
        for (std::size_t k = 1; k < axes.size(); ++k)
            sum += (axes[k] - axes[k - 1]).squaredNorm() /
                   (contacts[k].way_mm - contacts[k - 1].way_mm);
        return sum;
    };
    EXPECT_NEAR(bend(rough.axes), rough.rough_bend, 1e-12);
    EXPECT_NEAR(bend(smooth.axes), smooth.smooth_bend, 1e-12);
    for (const AxisField& field : {rough, smooth})
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            const Inclination at = inclination_of(
                field.axes[k], contacts[k].contact.normal, contacts[k].feed);
            EXPECT_TRUE(is_within(options, at));
            EXPECT_FALSE(judge(k, field.axes[k], at).broken);
        }
}

TEST(AxisField, TurnsTheAxesOfAMachineLittle)
{
    PartOnMachine setup;
    setup.machine.configuration = configuration_from_word("W/caxyBz/T");
    setup.machine.rotary = widest_limits(setup.machine.configuration);
    AxisFieldOptions options;
    options.machine = &setup;
    // near the pole, where a small turn of the axis is a large one of C
    auto contacts = arch(12, 61);
    for (FieldContact& contact : contacts)
        contact.wanted.tilt = Angle::degrees(2);
    const auto turns = [&](const std::vector<Vec3>& axes) {
        double sum = 0;
        const RotaryFrame frame = machine_frame(setup.machine.configuration);
        for (std::size_t k = 1; k < axes.size(); ++k) {
            const RotaryAngles from = rotary_angles(frame, axes[k - 1]);
            double least = std::numeric_limits<double>::infinity();
            const RotaryAngles to = rotary_angles(frame, axes[k]);
            for (const RotaryAngles& at : {to, other_rotary_angles(frame.family, to)})
                least =
                    std::min(least, std::abs(at.phi - from.phi) +
                                        std::abs(std::remainder(at.theta - from.theta,
                                                                2 * std::numbers::pi)));
            sum += least;
        }
        return sum / degree;
    };
    std::vector<Vec3> wanted;
    wanted.reserve(contacts.size());
    for (const FieldContact& contact : contacts)
        wanted.push_back(
            inclined_axis(contact.contact.normal, contact.feed, contact.wanted));
    const AxisField field = axis_field(contacts, all_allowed, options);
    EXPECT_LT(turns(field.axes), 0.2 * turns(wanted));
    EXPECT_LE(field.smooth_bend, field.rough_bend);
}

TEST(AxisField, IsTheSameWithAnyNumberOfThreads)
{
    const auto contacts = arch(60, 500);
    const AxisJudge judge = [](std::size_t contact, const Vec3&,
                               const Inclination& inclination) -> JudgedAxis {
        if (contact % 50 < 20 && inclination.tilt.degrees() < 5)
            return {.broken = AxisRule::Cutter};
        return {};
    };
    std::vector<Vec3> first;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        const AxisField field = axis_field(contacts, judge, {});
        if (first.empty())
            first = field.axes;
        EXPECT_EQ(field.axes, first);
    }
}

TEST(AxisField, NamesTheContactAndTheRuleThatLeaveNoAxis)
{
    const auto contacts = arch(10, 40);
    const AxisJudge judge = [](std::size_t contact, const Vec3&,
                               const Inclination& inclination) -> JudgedAxis {
        if (contact < 12 || contact > 20)
            return {};
        return {.broken =
                    inclination.lead.degrees() > 0 ? AxisRule::Strip : AxisRule::Cutter};
    };
    try {
        axis_field(contacts, judge, {});
        FAIL();
    } catch (const GeometryError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("no tool axis is allowed at contact 12, ("),
                  std::string::npos)
            << message;
        EXPECT_NE(message.find("the gap of the cutter removes the last one"),
                  std::string::npos)
            << message;
    }
}

TEST(AxisField, RefusesATurnThatIsTooLargeWithinAPassOnly)
{
    std::vector<FieldContact> contacts = arch(40, 2);
    AxisFieldOptions options;
    options.lead = range(-5, 5);
    EXPECT_THROW(axis_field(contacts, all_allowed, options), GeometryError);
    contacts[1].starts_pass = true;
    EXPECT_EQ(axis_field(contacts, all_allowed, options).axes.size(), 2U);
}

TEST(AxisField, RefusesOptionsOutOfRange)
{
    const auto contacts = arch(10, 4);
    const auto refused = [&](const LeanRange& lead, const LeanRange& tilt) {
        AxisFieldOptions options;
        options.lead = lead;
        options.tilt = tilt;
        EXPECT_THROW(axis_field(contacts, all_allowed, options), DomainError);
    };
    refused(range(5, -5), {});
    refused({}, range(5, -5));
    refused(range(-89, 5), {});
    refused({}, range(0, 89));
    auto unsound = contacts;
    unsound[2].way_mm = -1;
    EXPECT_THROW(axis_field(unsound, all_allowed, {}), DomainError);
    unsound = contacts;
    unsound[1].feed = unsound[1].contact.normal;
    EXPECT_THROW(axis_field(unsound, all_allowed, {}), DomainError);
    EXPECT_TRUE(axis_field({}, all_allowed, {}).axes.empty());
}

}  // namespace
}  // namespace endmill
