// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "endmill/cutter/cutter.h"
#include "endmill/io/mesh_file.h"
#include "endmill/io/read_limits.h"

namespace endmill {

/// The part that a path was made for.
struct PartReference {
    std::filesystem::path file;         ///< from where the summary stands
    LengthUnit units = LengthUnit::Mm;  ///< of a mesh
    UpAxis up = UpAxis::Z;              ///< likewise
};

/// What the summary.json beside a tool path says that the path itself does not. What it
/// does not say, or says is null, is none.
struct PathSummary {
    std::optional<std::string> name;
    std::optional<PartReference> part;
    std::optional<Cutter> cutter;
    std::optional<double> chord_tolerance_mm;
    std::optional<double> inner_tolerance_mm;  ///< gouge
    std::optional<double> outer_tolerance_mm;  ///< material left, beside the scallop
    std::optional<double> scallop_mm;
    std::optional<double> feed_mm_per_min;
    std::optional<double> spindle_rpm;

    /// The narrowest of the tolerances that the path was planned to.
    std::optional<double> tolerance_mm() const;
};

/// Reads the summary.json in the folder of `tool_path`.
/// \return nothing if there is none.
/// \throws FormatError, LimitError as `read_file` and `JsonDocument`; FormatError E_JSON
///         for a cutter that is no word of one, a number that is not above 0, or another
///         type. Keys that are not read may hold anything.
std::optional<PathSummary> read_path_summary(const std::filesystem::path& tool_path,
                                             const ReadLimits& limits = {});

}  // namespace endmill
