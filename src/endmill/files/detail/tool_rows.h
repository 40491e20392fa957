// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/cutter/cutter.h"

namespace endmill {

/// A row of a tool table of LinuxCNC that describes a cutter.
struct ToolRow {
    int number;        ///< after the letter T
    Cutter cutter;     ///< of the comment, or else a flat end mill of diameter D
    std::size_t line;  ///< of the file, from 1
    std::string name;  ///< the comment
};

/// Parses a tool table of LinuxCNC (.tbl).
/// \param file name of the file for messages.
/// \param unit_mm length of the unit of D, in mm; nothing: a row may not need it.
/// \param most_mm largest diameter.
/// \throws FormatError E_TOOLS with the line for an unknown or wrong word, a row without
///         T, and a comment that contradicts D; DomainError if D needs a unit.
std::vector<ToolRow> tool_rows(std::string_view text, const std::string& file,
                               const std::optional<double>& unit_mm, double most_mm);

}  // namespace endmill
