// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "endmill/cutter/tool.h"
#include "endmill/files/read_file.h"
#include "endmill/process/milling_data.h"

/// \file
/// Readers of the files that describe a cut: the tool ("endmill-tool/1") and the material
/// of the workpiece ("endmill-material/1").

namespace endmill {

/// Reads a file of format "endmill-tool/1". The key `cutter` is a cutter word as on the
/// command line. Optional keys: `name`, `source`, `flutes`, `helix_deg`, `length_mm`,
/// `limits` {`cutting_force_n`, `thrust_n`, `torque_n_m`}, and `shank` and `holder`,
/// lists of cylinders {`diameter_mm`, `from_mm`, `to_mm`} whose heights count from the
/// tip.
/// \throws FormatError as `JsonDocument` and, with the JSON pointer, for an unknown key
///         or a value out of its range; E_FORMAT for another format; also as `read_file`.
Tool read_tool(const std::filesystem::path& path, const ReadLimits& limits = {});

/// Parses the content of a tool file as `read_tool` does.
/// \param path used in messages and for the default name.
Tool parse_tool(std::string_view content, const std::filesystem::path& path,
                const ReadLimits& limits = {});

/// Reads a file of format "endmill-material/1". Required keys:
/// `specific_resistance_n_per_mm2`, `edge_thickness_mm`, `r1` to `r4`, `alpha`,
/// `v1_m_per_min`. Optional keys: `name` (default: the file's stem), `source`,
/// `max_feed_per_tooth_mm`, `min_feed_per_tooth_mm`.
/// \throws FormatError as `JsonDocument` and, with the JSON pointer, for an unknown or
///         missing key; E_MATERIAL for a value out of its range and for a largest feed
///         per tooth below the least; E_FORMAT for another format; also as `read_file`.
CuttingMaterial read_material(const std::filesystem::path& path,
                              const ReadLimits& limits = {});

/// Parses the content of a material file as `read_material` does.
/// \param path used in messages and for the default name.
CuttingMaterial parse_material(std::string_view content,
                               const std::filesystem::path& path,
                               const ReadLimits& limits = {});

}  // namespace endmill
