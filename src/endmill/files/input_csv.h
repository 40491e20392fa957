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

/// \file
/// Readers of small CSV inputs: directions, curves of one plane, and cutting speeds. Each
/// input has a `parse_...` function for a text in memory and a `read_...` function for a
/// file. Columns may stand in any order; unknown columns are refused.
///
/// Implemented in `directions_csv.cpp`, `polyline_csv.cpp` and `tool_life_csv.cpp`.

namespace endmill {

/// Reads directions from the columns `azimuth_deg` and `polar_deg`, one direction per
/// row. The azimuth counts counter-clockwise about +z from +x, the polar angle from +z.
/// \param file name of the file for messages.
/// \return unit vectors; their length is 1 within 1e-15.
/// \throws FormatError E_CSV with the line for an unknown, missing or repeated column; a
///         row with another number of cells; a cell that is not a finite number; a polar
///         angle outside 0 to 180; a table without rows.
/// \throws LimitError if the data need more memory than the limit.
std::vector<Vec3> parse_directions(std::string_view text, const std::string& file,
                                   const ReadLimits& limits = {});

/// Reads the file and parses it as `parse_directions` does.
/// \throws FormatError, LimitError also as `read_file`.
std::vector<Vec3> read_directions(const std::filesystem::path& path,
                                  const ReadLimits& limits = {});

/// Reads curves of one plane from the columns s_mm and z_mm and the optional column
/// `curve`, a whole number. The rows of a curve stand together; without the column all
/// rows are one curve. Consecutive equal points are merged. A curve is closed if its last
/// point equals its first. Orientation and first point are those of SectionCurve; curves
/// are sorted by their smallest s, then z.
/// \param file name of the file for messages.
/// \throws FormatError E_CSV with the line for an unknown, missing or repeated column; a
///         row with another number of cells; a cell that is not a finite number; rows of
///         one curve that are separated by another curve; a curve without two different
///         points; a table without rows. E_RANGE for a coordinate beyond the limit.
/// \throws LimitError if the curves need more memory than the limit.
std::vector<SectionCurve> parse_polylines(std::string_view text, const std::string& file,
                                          const ReadLimits& limits = {});

/// Reads the file and parses it as `parse_polylines` does.
/// \throws FormatError, LimitError also as `read_file`.
std::vector<SectionCurve> read_polylines(const std::filesystem::path& path,
                                         const ReadLimits& limits = {});

/// Reads curves of several planes. The columns are those of `parse_polylines` and the
/// optional column `plane`, a whole number. The rows of a plane stand together, and curves
/// are numbered in each plane by itself; without the column all curves lie in one plane.
/// \return the curves of each plane, as `parse_polylines` orders them. The planes keep
///     their order in the file.
/// \throws as `parse_polylines`; FormatError E_CSV also for rows of one plane that are
///     separated by another plane.
std::vector<std::vector<SectionCurve>> parse_polyline_planes(
    std::string_view text, const std::string& file, const ReadLimits& limits = {});

/// Reads the file and parses it as `parse_polyline_planes` does.
/// \throws FormatError, LimitError also as `read_file`.
std::vector<std::vector<SectionCurve>> read_polyline_planes(
    const std::filesystem::path& path, const ReadLimits& limits = {});

/// Reads recommended cutting speeds from the columns `phi_over_pi` (engaged angle over
/// pi) and `v_m_per_min` (cutting speed), one recommendation per row.
/// \param file name of the file for messages.
/// \throws FormatError E_CSV with the line for an unknown, missing or repeated column; a
///         row with another number of cells; a cell that is not a finite number; an angle
///         outside 0 < phi / pi <= 1; a speed that is not positive; a table without two
///         different angles.
/// \throws LimitError if the data need more memory than the limit.
std::vector<CuttingSpeedDatum> parse_cutting_speeds(std::string_view text,
                                                    const std::string& file,
                                                    const ReadLimits& limits = {});

/// Reads the file and parses it as `parse_cutting_speeds` does.
/// \throws FormatError, LimitError also as `read_file`.
std::vector<CuttingSpeedDatum> read_cutting_speeds(const std::filesystem::path& path,
                                                   const ReadLimits& limits = {});

}  // namespace endmill
