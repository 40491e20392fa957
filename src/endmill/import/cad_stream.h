// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "endmill/files/read_file.h"
#include "endmill/import/cad_part.h"

/// \file
/// The answer of the program `endmill-cad`. README.md of this module describes it.

namespace endmill {

/// Reads an answer and checks all of it: counts against its length
/// before memory is allocated, indices, coordinates, knots and weights. A spline that would
/// be no valid surface file is left out, with a note.
/// \param bytes the whole answer.
/// \param path  of the CAD file, for messages.
/// \throws FormatError E_CAD if the answer is damaged; E_RANGE for a coordinate beyond the
///         limit. \throws LimitError if it needs more memory than the limit.
CadPart parse_cad_stream(std::string_view bytes, const std::filesystem::path& path,
                         const ReadLimits& limits = {});

}  // namespace endmill
