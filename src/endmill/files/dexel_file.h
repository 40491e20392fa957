// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "endmill/files/read_file.h"
#include "endmill/stock/stock_history.h"

/// \file
/// Files of dexels (`stock.dexels`): the stock that a path with a turning axis left, and the
/// moves that made it. The layout is described in docs/file-formats.md.

namespace endmill {

/// Approximate memory in bytes per ray for the content of a file: two counts and two
/// intervals in each of two copies.
inline constexpr double dexel_file_bytes_per_ray = 48;

/// Returns the content of a file of dexels, which `read_dexels` reads back.
/// \pre `history` is that of `dexels`, over the same block.
std::string dexel_file(const DexelStock& dexels, const TurningHistory& history);

/// Reads a file that `dexel_file` wrote. Dexels and moves are the same to the last bit.
/// \throws FormatError E_FORMAT for content of another kind; E_DEXELS for another version or
///         structure, and for a file of another length, before memory is allocated; E_NONFINITE for a number
///         that is not finite; E_RANGE for a coordinate beyond the limit and for numbers
///         that are not a block, a cutter, a machine, a tool axis or dexels; also as
///         `read_file`.
/// \throws LimitError if it needs more memory than the limit.
KeptDexels read_dexels(const std::filesystem::path& path, const ReadLimits& limits = {});

/// Parses the content of a file as `read_dexels` does.
/// \param path used in messages.
KeptDexels parse_dexels(std::string_view content, const std::filesystem::path& path,
                        const ReadLimits& limits = {});

}  // namespace endmill
