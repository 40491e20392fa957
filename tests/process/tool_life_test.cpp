// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/tool_life.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

using test::relative_error;

// Data of [ParkMaeng, fig. 4].
const std::vector<CuttingSpeedDatum> printed_data{
    {0.1168859, 64}, {0.2048328, 49}, {0.3333334, 43}, {0.5000001, 37}};
constexpr double printed_alpha = 0.3680141;
constexpr ToolCosts printed_costs{
    .change_min = 40, .tool = 20000, .machine_per_min = 200};

// Least squares by the normal equations in long double, without subtracting the means.
long double normal_equations_slope(const std::vector<CuttingSpeedDatum>& data)
{
    long double n = 0;
    long double x = 0;
    long double y = 0;
    long double xx = 0;
    long double xy = 0;
    for (const CuttingSpeedDatum& datum : data) {
        const long double u = std::log(static_cast<long double>(datum.phi_over_pi));
        const long double v = std::log(static_cast<long double>(datum.v_m_per_min));
        n += 1;
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

TEST(ToolLife, FitsThePrintedData)
{
    const SpeedLine line = fitted_speed_line(printed_data);
    EXPECT_NEAR(line.alpha, 0.368012948365, 1e-10);
    EXPECT_NEAR(line.v1_m_per_min, 28.4313029690, 1e-9);
    EXPECT_NEAR(std::log(line.v1_m_per_min), 3.34749075539, 1e-11);
    EXPECT_LT(relative_error(line.alpha, printed_alpha), 1e-5);
    EXPECT_NEAR(line.alpha, static_cast<double>(-normal_equations_slope(printed_data)),
                1e-14);
}

TEST(ToolLife, GivesTheAngleOfEachPrintedWidthOfCut)
{
    const double widths[] = {1.0 / 30, 1.0 / 10, 1.0 / 4, 1.0 / 2};
    for (std::size_t i = 0; i < printed_data.size(); ++i)
        EXPECT_NEAR(std::acos(1 - 2 * widths[i]) / std::numbers::pi,
                    printed_data[i].phi_over_pi, 1.1e-7);
}

TEST(ToolLife, WithThePrintedExponentGivesThePrintedConstants)
{
    const SpeedLine line = fitted_speed_line(printed_data, printed_alpha);
    const double life = economic_tool_life(printed_alpha, printed_costs);
    EXPECT_NEAR(life, 240.420207, 1e-6);
    EXPECT_LT(relative_error(life, 240.4202), 1e-5);
    EXPECT_NEAR(line.v1_m_per_min, 28.4312578, 1e-7);
    const double constant = tool_life_constant(line, life);
    EXPECT_NEAR(constant, 213.809481, 1e-6);
    EXPECT_LT(relative_error(constant, 213.8094), 1e-5);
}

TEST(ToolLife, WithTheFittedExponentDiffersFromThePrint)
{
    const SpeedLine line = fitted_speed_line(printed_data);
    const double life = economic_tool_life(line.alpha, printed_costs);
    EXPECT_NEAR(life, 240.421397, 1e-6);
    EXPECT_NEAR(tool_life_constant(line, life), 213.808861, 1e-6);
}

// Cost per part of machine and worn tools, for a volume cut at the speed V. It is least
// at the economic life. The life at V is (C/V)^(1/alpha).
TEST(ToolLife, IsTheCheapest)
{
    for (const double alpha : {0.12, printed_alpha, 0.7}) {
        const double best = economic_tool_life(alpha, printed_costs);
        const auto cost = [&](double life) {
            const double time = std::pow(life, alpha);  // proportional to 1/V
            return time * printed_costs.machine_per_min *
                   (1 + (printed_costs.change_min +
                         printed_costs.tool / printed_costs.machine_per_min) /
                            life);
        };
        for (const double factor : {0.9, 0.999, 1.001, 1.1})
            EXPECT_GT(cost(factor * best), cost(best));
    }
}

TEST(ToolLife, ExactDataOnALineAreFittedExactly)
{
    test::Random random{3};
    for (int i = 0; i < 200; ++i) {
        const double alpha = random.uniform(0.05, 0.95);
        const double v1 = random.log_uniform(1, 1000);
        std::vector<CuttingSpeedDatum> data;
        for (const double phi :
             {random.uniform(0.05, 0.2), random.uniform(0.2, 0.45), 0.9})
            data.push_back({phi, v1 * std::pow(phi, -alpha)});
        const SpeedLine line = fitted_speed_line(data);
        EXPECT_LT(std::abs(line.alpha - alpha), 1e-13);
        EXPECT_LT(relative_error(line.v1_m_per_min, v1), 1e-13);
        for (const CuttingSpeedDatum& datum : data)
            EXPECT_LT(relative_error(economic_speed(line, datum.phi_over_pi),
                                     datum.v_m_per_min),
                      1e-13);
    }
}

// C_b and T0 cancel: at the economic life the tool-life equation gives the speed of the
// line.
TEST(ToolLife, CostsDoNotChangeTheEconomicSpeed)
{
    const SpeedLine line = fitted_speed_line(printed_data);
    for (const double tool : {1.0, 20000.0, 1e6}) {
        const double life = economic_tool_life(
            line.alpha, {.change_min = 40, .tool = tool, .machine_per_min = 200});
        const double constant = tool_life_constant(line, life);
        for (const double phi : {0.1, 0.5, 1.0})
            EXPECT_NEAR(constant / std::pow(phi * life, line.alpha),
                        economic_speed(line, phi), 1e-12);
    }
}

TEST(ToolLife, ASpindleRunsTheRimAtTheSpeed)
{
    const double rpm = spindle_speed_rpm(28.4313, 5);
    EXPECT_NEAR(rpm, 904.996386706, 1e-9 * 905);
    EXPECT_NEAR(rpm * 2 * std::numbers::pi * 0.005, 28.4313, 1e-13);
}

TEST(ToolLife, RefusesDataThatFixNoLine)
{
    EXPECT_THROW(fitted_speed_line({}), DomainError);
    EXPECT_THROW(fitted_speed_line(std::vector<CuttingSpeedDatum>{{0.5, 40}}),
                 DomainError);
    EXPECT_THROW(fitted_speed_line(std::vector<CuttingSpeedDatum>{{0.5, 40}, {0.5, 30}}),
                 DomainError);
    EXPECT_NO_THROW(fitted_speed_line(std::vector<CuttingSpeedDatum>{{0.5, 40}}, 0.4));
    EXPECT_THROW(fitted_speed_line({}, 0.4), DomainError);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const CuttingSpeedDatum wrong :
         {CuttingSpeedDatum{0, 40},
          {-0.1, 40},
          {1.1, 40},
          {nan, 40},
          {0.3, 0},
          {0.3, -1},
          {0.3, nan},
          {0.3, std::numeric_limits<double>::infinity()}}) {
        const std::vector<CuttingSpeedDatum> data{{0.5, 40}, wrong};
        EXPECT_THROW(fitted_speed_line(data), DomainError);
        EXPECT_THROW(fitted_speed_line(data, 0.4), DomainError);
    }
}

TEST(ToolLife, RefusesASpeedThatRisesOrFallsTooSteeply)
{
    using Data = std::vector<CuttingSpeedDatum>;
    EXPECT_THROW(fitted_speed_line(Data{{0.2, 30}, {0.5, 40}}), GeometryError);
    EXPECT_THROW(fitted_speed_line(Data{{0.2, 30}, {0.5, 30}}), GeometryError);
    EXPECT_THROW(fitted_speed_line(Data{{0.25, 80}, {0.5, 40 - 1e-9}}), GeometryError);
}

TEST(ToolLife, RefusesASpeedTooSmallForANumber)
{
    const std::vector<CuttingSpeedDatum> data{{1e-300, 1e-300}, {2e-300, 0.6e-300}};
    EXPECT_THROW(fitted_speed_line(data), GeometryError);
}

TEST(ToolLife, RefusesNumbersOutOfTheirDomain)
{
    for (const double alpha : {0.0, 1.0, -0.1, 1.5}) {
        EXPECT_THROW(fitted_speed_line(printed_data, alpha), DomainError);
        EXPECT_THROW(economic_tool_life(alpha, printed_costs), DomainError);
        EXPECT_THROW(economic_speed({alpha, 30}, 0.5), DomainError);
        EXPECT_THROW(tool_life_constant({alpha, 30}, 100), DomainError);
    }
    EXPECT_THROW(economic_tool_life(0.4, {-1, 1, 1}), DomainError);
    EXPECT_THROW(economic_tool_life(0.4, {1, -1, 1}), DomainError);
    EXPECT_THROW(economic_tool_life(0.4, {1, 1, 0}), DomainError);
    EXPECT_THROW(economic_tool_life(0.4, {0, 0, 1}), DomainError);
    EXPECT_THROW(economic_speed({0.4, 30}, 0), DomainError);
    EXPECT_THROW(economic_speed({0.4, 30}, 1.01), DomainError);
    EXPECT_THROW(economic_speed({0.4, 0}, 0.5), DomainError);
    EXPECT_THROW(tool_life_constant({0.4, 30}, 0), DomainError);
    EXPECT_THROW(spindle_speed_rpm(0, 5), DomainError);
    EXPECT_THROW(spindle_speed_rpm(30, 0), DomainError);
}

}  // namespace
}  // namespace endmill
