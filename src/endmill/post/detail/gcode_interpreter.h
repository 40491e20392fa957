// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/program.h"

namespace endmill {

/// A line of a program that moves the tool.
struct GcodeMove {
    std::size_t line;             ///< line number, from 1
    std::size_t first;            ///< index of its first point in the path
    std::size_t end;              ///< index after its last point
    GcodeModes modes;             ///< modes in force, including the codes of the line
    std::optional<Arc> arc = {};  ///< the arc, if the line describes one
};

/// The lines that make the points of the path, in order. Lines without a point are left
/// out. Parameters and errors are those of `parse_gcode`.
std::vector<GcodeMove> gcode_moves(std::string_view text, const std::string& file,
                                   const GcodeReadOptions& options = {});

/// The same one by one, without keeping them or the path.
/// \param visit receives the moves in order.
/// \return the number of points of the path.
/// \throws whatever `visit` throws.
std::size_t for_each_gcode_move(std::string_view text, const std::string& file,
                                const GcodeReadOptions& options,
                                const std::function<void(const GcodeMove&)>& visit);

/// Runs the program: the implementation of `parse_gcode`, with its parameters and errors.
Program interpreted_gcode(std::string_view text, const std::string& file,
                          const GcodeReadOptions& options);

}  // namespace endmill
