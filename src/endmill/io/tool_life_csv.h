// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/io/read_limits.h"
#include "endmill/process/tool_life.h"

namespace endmill {

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
