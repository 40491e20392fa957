// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/trim_summary.h"
#include "endmill/files/output_folder.h"
#include "endmill/trimming/trimming_methods.h"

namespace endmill {

/// Trims the sections by `method`, and measures what is left.
/// \throws DomainError, GeometryError as the method and link_sections do.
TrimResult trim_by(const TrimmingMethod& method, const TrimInput& input,
                   const TrimOptions& options);

/// Writes what one method left into `folder` under `prefix`: trimmed.csv, loops.csv,
/// summary.json, for a part toolpath.csv, and pictures if a plane is asked for.
/// \return the summary.
Json write_trimmed(const TrimResult& result, const TrimInput& input,
                   const TrimOptions& options, OutputFolder& folder,
                   const std::string& prefix);

/// Writes sections.csv, and makes room for the files of this run: those of an earlier one
/// are removed unless they are written anew.
void write_sections(const TrimInput& input, OutputFolder& folder);

}  // namespace endmill
