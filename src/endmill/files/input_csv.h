// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/read_file.h"
#include "endmill/offset/section_curve.h"
#include "endmill/process/tool_life.h"

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

/// Reads recommended cutting speeds: columns `phi_over_pi` and `v_m_per_min`, in any order,
/// a row a datum.
/// \param file the name for messages.
/// \throws FormatError E_CSV with the line for an unknown column, one that is missing or
///         named twice; a row with another number of cells; what is no number where one
///         belongs, NaN and infinity included; an angle that is not above 0 and at most 1; a
///         speed that is not above 0; unless two rows have different angles.
/// \throws LimitError if the data need more memory than the limit.
std::vector<CuttingSpeedDatum> parse_cutting_speeds(std::string_view text,
                                                    const std::string& file,
                                                    const ReadLimits& limits = {});

/// The same from a file. \throws FormatError and LimitError also as `read_file`.
std::vector<CuttingSpeedDatum> read_cutting_speeds(const std::filesystem::path& path,
                                                   const ReadLimits& limits = {});

}  // namespace endmill
