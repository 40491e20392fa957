// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// A machine program or CL data as it was read.
struct Program {
    ToolPath path;                     ///< tips, with conditions where it gives any
    std::optional<Cutter> cutter;      ///< if the program names one, as APT does
    std::vector<std::string> remarks;  ///< for a person: units, motion left out
    double position_error_mm = 0;      ///< of a coordinate: the rounding of its text
};

/// Metres of punched tape that a character takes: tape has ten of them an inch.
inline constexpr double tape_metres_per_character = 0.00254;

/// The least and the greatest of some numbers; both none if there are none.
struct NumberRange {
    std::optional<double> least;
    std::optional<double> greatest;

    /// Widens the range so that it holds `number`. \pre it is not NaN.
    void add(double number)
    {
        least = std::min(number, least.value_or(number));
        greatest = std::max(number, greatest.value_or(number));
    }
};

/// A program as it is written to a file, and what was done to the path for it.
struct WrittenProgram {
    std::string text;
    std::size_t lines = 0;
    std::size_t repeated_points = 0;   ///< left out: rounded, equal to the one before
    std::size_t slanted_rapids = 0;    ///< rapids that change height and place at once
    double max_rounding_error_mm = 0;  ///< of a coordinate of the path
    double safe_height_mm = 0;         ///< of G-code
    NumberRange feed_mm_per_min;       ///< before rounding
    NumberRange spindle_rpm;           ///< ditto

    /// The tape that the text would take, line ends included.
    double tape_length_m() const
    {
        return tape_metres_per_character * static_cast<double>(text.size());
    }
};

}  // namespace endmill
