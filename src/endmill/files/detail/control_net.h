// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/detail/strict_json.h"

/// \file
/// Arrays of numbers in surface files: control nets, grid lines, heights and weights.

namespace endmill {

/// Unit of the lengths in a file, and the limit on them.
struct LengthRule {
    double mm_per_unit;    ///< mm per length unit of the file
    double max_extent_mm;  ///< largest absolute value after conversion, in mm
};

/// Required number of rows or columns of an array.
struct ExpectedCount {
    std::size_t count;   ///< number of rows or columns
    std::string reason;  ///< for messages, such as "3 patches_u + 1"
};

/// A rectangular array of control points, u running fastest.
struct ControlNet {
    std::size_t columns;       ///< points along u
    std::size_t rows;          ///< points along v
    std::vector<Vec3> points;  ///< mm, row by row
};

/// Reads a control net from an array of rows of points.
/// \param columns required number of columns; nothing: that of the first row.
/// \param rows    required number of rows; nothing: any.
/// \throws FormatError E_SURFACE for a wrong count and for a net whose points are all
///         equal, E_RANGE for a coordinate beyond the limit, E_JSON for a wrong type.
ControlNet read_net(const JsonValue& value, const LengthRule& rule,
                    const std::optional<ExpectedCount>& columns,
                    const std::optional<ExpectedCount>& rows);

/// Reads an array of lengths and converts them to mm.
/// \throws FormatError E_RANGE, E_JSON as `read_net`.
std::vector<double> read_lengths(const JsonValue& value, const LengthRule& rule);

/// Reads an array of rows of lengths and converts them to mm. The result is row by row.
/// \throws FormatError as `read_net`.
std::vector<double> read_length_rows(const JsonValue& value, const LengthRule& rule,
                                     const ExpectedCount& columns,
                                     const ExpectedCount& rows);

/// Reads an array of rows of weights. The result is row by row, scaled by one power of
/// two so that the largest weight lies in 1 … 2.
/// \throws FormatError E_SURFACE for a weight that is not positive, weights that differ
///         by more than a factor of 10 000, or a wrong count; E_JSON for a wrong type.
std::vector<double> read_weights(const JsonValue& value, const ExpectedCount& columns,
                                 const ExpectedCount& rows);

}  // namespace endmill
