// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/io/read_limits.h"

namespace endmill {

/// Reads directions: columns `azimuth_deg` and `polar_deg`, in any order, a row a direction;
/// the azimuth counts counter-clockwise about +z from +x, the polar angle from +z.
/// \param file the name for messages.
/// \return unit vectors, to 1e-15.
/// \throws FormatError E_CSV with the line for an unknown column, one that is missing or named
///         twice; a row with another number of cells; what is no finite number; a polar angle
///         that is not from 0 to 180; no row.
/// \throws LimitError if the data need more memory than the limit.
std::vector<Vec3> parse_directions(std::string_view text, const std::string& file,
                                   const ReadLimits& limits = {});

/// The same from a file. \throws FormatError and LimitError also as `read_file`.
std::vector<Vec3> read_directions(const std::filesystem::path& path,
                                  const ReadLimits& limits = {});

}  // namespace endmill
