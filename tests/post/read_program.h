// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/post/gcode_reader.h"

namespace endmill {

/// A program around `blocks`: lines 1 and 2 before them, one line after them.
inline std::string program_of(const std::string& blocks)
{
    return "G21 G90 G94\nG0 X0 Y0 Z0\n" + blocks + "\nM2\n";
}

inline Program read_gcode(const std::string& text, const GcodeReadOptions& options = {})
{
    return parse_gcode(text, "f.ngc", options);
}

/// "CODE message" of the error that `read` throws, or "accepted".
template <class Read>
std::string refusal_of(const Read& read)
{
    try {
        read();
        return "accepted";
    } catch (const Error& error) {
        return error.code() + ' ' + error.what();
    }
}

inline std::string gcode_refusal(const std::string& text,
                                 const GcodeReadOptions& options = {})
{
    return refusal_of([&] { read_gcode(text, options); });
}

inline std::vector<Vec3> tips(const Program& program)
{
    std::vector<Vec3> found;
    for (const PathPoint& point : program.path.points)
        found.push_back(point.location.tip);
    return found;
}

inline std::vector<Move> moves(const Program& program)
{
    std::vector<Move> found;
    for (const PathPoint& point : program.path.points)
        found.push_back(point.move);
    return found;
}

inline std::vector<std::optional<double>> feeds(const Program& program)
{
    std::vector<std::optional<double>> found;
    for (const PathPoint& point : program.path.points)
        found.push_back(point.conditions.feed_mm_per_min);
    return found;
}

}  // namespace endmill
