// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/words/word_motions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <Eigen/QR>

#include "endmill/machine/feasible_directions.h"
#include "endmill/machine/kinematics.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

constexpr RotaryPositions general{0.3, 0.4};  // rad, at no singular position
constexpr double step = 1e-4;                 // rad, of the central differences
constexpr double rounding = 1e-12;
// The error of a central difference is about step^2, that of a real derivative about 1.
constexpr double rank_threshold = 1e-6;

Vec3 tool_axis(const MachineConfiguration& machine, const RotaryPositions& rotary,
               const Vec3& xyz = {0, 0, 0})
{
    return tool_location({.configuration = machine}, {.rotary = rotary, .xyz = xyz}, 0)
        .axis;
}

bool differs(const std::string& letters)
{
    constexpr std::array<std::array<double, 3>, 3> places{
        {{12, -7, 31}, {-150, 80, 4}, {0.5, 220, -60}}};  // mm
    std::string rotary = letters;
    std::erase_if(rotary, [](char letter) { return letter >= 'x' && letter <= 'z'; });
    const Vec3 expected = tool_axis(configuration_from_word(whole_word(rotary)), general);
    const auto machine = configuration_from_word("W/" + letters + "/T");
    return std::ranges::any_of(places, [&](const auto& place) {
        const Vec3 found = tool_axis(machine, general, {place[0], place[1], place[2]});
        return (found - expected).norm() > rounding;
    });
}

std::string axis_name(const MachineConfiguration& machine, std::size_t axis)
{
    return {static_cast<char>(std::toupper(machine.rotary.at(axis).letter))};
}

CsvCell family_name(const MachineConfiguration& machine)
{
    if (!machine.family)
        return std::monostate{};
    return std::string{machine.family == RotaryFamily::CA ? "CA" : "AB"};
}

CsvCell side_name(const MachineConfiguration& machine, std::size_t axis)
{
    return std::string{machine.rotary.at(axis).side == MachineSide::Table ? "part"
                                                                          : "tool"};
}

}  // namespace

double motion_sr(const MachineConfiguration& machine, const RotaryLimits& limits)
{
    return machine.is_valid() ? feasible_directions(machine, limits).solid_angle() : 0;
}

NamedCells machine_cells(const MachineConfiguration& machine, const RotaryLimits& limits)
{
    return {{"valid", endmill::word(machine.is_valid())},
            {"family", family_name(machine)},
            {"r1", axis_name(machine, 0)},
            {"r2", axis_name(machine, 1)},
            {"side_r1", side_name(machine, 0)},
            {"side_r2", side_name(machine, 1)},
            {"type", type_name(machine)},
            {"rank", static_cast<std::int64_t>(measured_rank(machine))},
            {"largest_x", largest_x(machine)},
            {"solid_angle_sr", motion_sr(machine, limits)}};
}

std::size_t distinct_areas(std::vector<double> areas)
{
    constexpr double equal = 1e-9;
    std::erase(areas, 0);
    std::ranges::sort(areas);
    const auto repeated = std::ranges::unique(
        areas, [](double a, double b) { return std::abs(a - b) < equal * b; });
    return areas.size() - repeated.size();
}

int measured_rank(const MachineConfiguration& machine)
{
    Eigen::Matrix<double, 3, 2> derivative;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        RotaryPositions after = general;
        RotaryPositions before = general;
        after.at(axis) += step;
        before.at(axis) -= step;
        derivative.col(static_cast<Eigen::Index>(axis)) =
            (tool_axis(machine, after) - tool_axis(machine, before)) / (2 * step);
    }
    Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 3, 2>> decomposition{derivative};
    decomposition.setThreshold(rank_threshold);
    return static_cast<int>(decomposition.rank());
}

double largest_x(const MachineConfiguration& machine)
{
    constexpr int steps = 36;
    double largest = 0;
    for (int k = 0; k < steps; ++k)
        for (int l = 0; l < steps; ++l) {
            const RotaryPositions turned{2 * std::numbers::pi * k / steps,
                                         2 * std::numbers::pi * l / steps};
            largest = std::max(largest, std::abs(tool_axis(machine, turned).x()));
        }
    return largest;
}

std::size_t words_that_differ()
{
    std::size_t count = 0;
    for (const char* pair : {"ab", "ac", "bc"}) {
        std::string letters = std::string{"Bxyz"} + pair;
        std::ranges::sort(letters);
        do
            count += differs(letters) ? 1 : 0;
        while (std::ranges::next_permutation(letters).found);
    }
    return count;
}

}  // namespace endmill
