// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/machine/kinematics.h"
#include "endmill/path/tool_path.h"
#include "random.h"

// Machines and paths of five axes for tests.
namespace endmill::test {

inline double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

/// The machine of a rotary word such as "caB", without limits.
inline PartOnMachine part_on(const std::string& word)
{
    PartOnMachine setup;
    setup.machine.configuration = configuration_from_word(whole_word(word));
    setup.machine.rotary = widest_limits(setup.machine.configuration);
    return setup;
}

/// The rotary words with two degrees of freedom.
inline std::vector<std::string> valid_words()
{
    std::vector<std::string> words = rotary_words();
    std::erase_if(words, [](const std::string& word) {
        return !configuration_from_word(whole_word(word)).is_valid();
    });
    return words;
}

inline Vec3 random_vector(Random& random, double most)
{
    return {random.uniform(-most, most), random.uniform(-most, most),
            random.uniform(-most, most)};
}

/// A random machine with all offsets, a tool and a turned part.
inline PartOnMachine random_part_on_machine(Random& random, bool has_axis_offset)
{
    const std::vector<std::string> words = valid_words();
    PartOnMachine setup = part_on(words[random.engine()() % words.size()]);
    Machine& machine = setup.machine;
    machine.pivot = random.uniform(0, 100);
    machine.table_offset = random_vector(random, 60);
    const auto& rotary = machine.configuration.rotary;
    if (has_axis_offset && rotary[0].side == rotary[1].side)
        machine.axis_offset = random_vector(random, 20);
    setup.tool_length = random.uniform(20, 150);
    setup.clamp = random_vector(random, 40);
    setup.part_to_machine =
        Eigen::AngleAxisd{random.uniform(-3, 3), Vec3{1, 2, -1}.normalized()}
            .toRotationMatrix();
    return setup;
}

inline AxisPositions random_positions(Random& random, double most_turn)
{
    return {
        {random.uniform(-most_turn, most_turn), random.uniform(-most_turn, most_turn)},
        random_vector(random, 100)};
}

/// Positions that move evenly, at parameter u.
inline AxisPositions between(const AxisPositions& from, const AxisPositions& to, double u)
{
    AxisPositions at{.xyz = (1 - u) * from.xyz + u * to.xyz};
    for (std::size_t k = 0; k < 2; ++k)
        at.rotary[k] = (1 - u) * from.rotary[k] + u * to.rotary[k];
    return at;
}

/// The direction with these turns, for C,A: tilt phi and turn theta of C.
inline Vec3 direction(const PartOnMachine& setup, double phi_deg, double theta_deg)
{
    return setup.part_to_machine.transpose() *
           turned_tool_axis(machine_frame(setup.machine.configuration),
                            {rad(phi_deg), rad(theta_deg)});
}

/// A path of cuts through poses, at 600 mm/min.
inline ToolPath path_through(const std::vector<CutterLocation>& poses)
{
    ToolPath path;
    for (std::size_t i = 0; i < poses.size(); ++i)
        path.points.push_back({.pass = 0,
                               .point = static_cast<int>(i),
                               .move = Move::Cut,
                               .location = poses[i],
                               .conditions = {.feed_mm_per_min = 600}});
    return path;
}

/// A closed ring on a cone: the axis leans outward by `lean_deg`, round the z axis.
inline ToolPath cone_path(double radius, double lean_deg, int points)
{
    std::vector<CutterLocation> poses;
    for (int k = 0; k <= points; ++k) {
        const double a = 2 * std::numbers::pi * k / points;
        const double lean = rad(lean_deg);
        poses.push_back({{radius * std::cos(a), radius * std::sin(a), 10},
                         {std::sin(lean) * std::cos(a), std::sin(lean) * std::sin(a),
                          std::cos(lean)}});
    }
    return path_through(poses);
}

}  // namespace endmill::test
