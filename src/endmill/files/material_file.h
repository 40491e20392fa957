// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "endmill/files/read_file.h"
#include "endmill/process/milling_data.h"

namespace endmill {

/// The material in a file of format "endmill-material/1": `specific_resistance_n_per_mm2`,
/// `edge_thickness_mm`, `r1` to `r4`, `alpha`, `v1_m_per_min`, and as far as it says so
/// `name` (else the file's), `source`, `max_feed_per_tooth_mm`, `min_feed_per_tooth_mm`.
/// \throws FormatError as `JsonDocument`, with the JSON pointer, for a key that is unknown or
///         missing; E_MATERIAL for a value out of its range, and for a largest feed per tooth
///         below the least; E_FORMAT for another format; and as `read_file`.
CuttingMaterial read_material(const std::filesystem::path& path,
                              const ReadLimits& limits = {});

/// The same from what the file holds; `path` is named in messages.
CuttingMaterial parse_material(std::string_view content,
                               const std::filesystem::path& path,
                               const ReadLimits& limits = {});

}  // namespace endmill
