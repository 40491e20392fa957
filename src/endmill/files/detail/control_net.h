// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/detail/surface_kinds.h"

namespace endmill {

/// How many rows and columns an array must have, and why, for a message.
struct ExpectedCount {
    std::size_t count;
    std::string reason;  ///< such as "3 patches_u + 1"
};

/// A rectangular array of control points, u running fastest.
struct ControlNet {
    std::size_t columns;
    std::size_t rows;
    std::vector<Vec3> points;  ///< mm
};

/// The net in `value`, an array of rows of points.
/// \param columns,rows if given, what they must be; else all rows are as long as the
/// first.
/// \throws FormatError E_SURFACE for a wrong count or a net that is one point, E_RANGE
/// for a coordinate beyond the limit, E_JSON for a wrong type.
ControlNet read_net(const JsonValue& value, const SurfaceNumbers& numbers,
                    const std::optional<ExpectedCount>& columns,
                    const std::optional<ExpectedCount>& rows);

/// The lengths in `value`, in mm.
/// \throws FormatError E_RANGE, E_JSON as read_net.
std::vector<double> read_lengths(const JsonValue& value, const SurfaceNumbers& numbers);

/// The lengths in the rows of `value`, in mm, the row running slowest.
/// \throws FormatError as read_net.
std::vector<double> read_length_rows(const JsonValue& value,
                                     const SurfaceNumbers& numbers,
                                     const ExpectedCount& columns,
                                     const ExpectedCount& rows);

/// The numbers above zero in the rows of `value`, the row running slowest, scaled by one
/// power of two so that the greatest is in 1 … 2.
/// \throws FormatError E_SURFACE for one that is not above zero, weights that differ by
/// more than a factor of 10 000, or a wrong count.
std::vector<double> read_weights(const JsonValue& value, const ExpectedCount& columns,
                                 const ExpectedCount& rows);

}  // namespace endmill
