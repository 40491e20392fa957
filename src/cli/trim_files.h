// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/trim_summary.h"
#include "endmill/files/output_folder.h"
#include "endmill/trimming/trimming_methods.h"

namespace endmill {

/// Trims the sections by `method` and measures the trimmed curves.
/// \throws DomainError, GeometryError as the method and link_sections do.
TrimResult trim_by(const TrimmingMethod& method, const TrimInput& input,
                   const TrimOptions& options);

/// Sections of the part with one plane, or the profiles of a file. Empty if the curves of
/// a file are offsets already.
std::vector<std::vector<SectionPoint>> part_lines(const TrimInput& input,
                                                  std::size_t plane);

/// Writes the result of one method into `folder` under `prefix`: trimmed.csv, loops.csv
/// and summary.json, for a part also toolpath.csv, and pictures if --figure names a
/// plane.
/// \return the summary.
Json write_trimmed(const TrimResult& result, const TrimInput& input,
                   const TrimOptions& options, OutputFolder& folder,
                   const std::string& prefix);

/// Writes sections.csv, and removes the files of an earlier run that this run does not
/// write.
void write_sections(const TrimInput& input, const TrimOptions& options,
                    OutputFolder& folder);

}  // namespace endmill
