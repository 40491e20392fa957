// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/interference/section_curve.h"
#include "endmill/io/read_limits.h"

namespace endmill {

/// Reads curves of one plane: columns s_mm and z_mm, and optionally `curve`, a whole number
/// whose rows stand together; without it all rows are one curve. Consecutive equal points
/// are merged. A curve whose last point equals its first is closed. Each is turned and
/// begins as SectionCurve says, and they are in the order of their smallest s, then z.
/// \param file the name for messages.
/// \throws FormatError E_CSV with the line for an unknown column, one that is missing or
///         named twice; a row with another number of cells; what is no number where one
///         belongs, NaN and infinity included; a curve that comes again after another; a
///         curve without two different points; if there is no row. E_RANGE for a length
///         beyond the limit.
/// \throws LimitError if the curves need more memory than the limit.
std::vector<SectionCurve> parse_polylines(std::string_view text, const std::string& file,
                                          const ReadLimits& limits = {});

/// The same from a file. \throws FormatError and LimitError also as `read_file`.
std::vector<SectionCurve> read_polylines(const std::filesystem::path& path,
                                         const ReadLimits& limits = {});

}  // namespace endmill
