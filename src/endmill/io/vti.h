// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/io/read_limits.h"
#include "endmill/simulation/stock_history.h"

namespace endmill {

/// The stock as a VTK XML ImageData file (.vti), lengths in mm, for ParaView and VTK and
/// to be read back.
///
/// The cells of the image are those of the stock; cell data `height_mm` are its heights,
/// x running fastest; field data `bottom_z_mm` is the bottom, and others are its history
/// (`history_elements`), if it is known: without it the file is that of programs which
/// kept none. Numbers are stored in binary, exactly, those of the grid as the shortest text
/// that reads back to the same.
std::string stock_vti(const HeightStock& stock,
                      const std::optional<StockHistory>& history = {});

/// The stock in a file that `stock_vti` wrote: the same to the last bit. The head of the
/// file must be what `stock_vti` writes for its numbers, byte for byte, and the file as
/// long as these say.
/// \throws FormatError E_VTI for a head that is another, or a history that is none, or of
///         another block than the heights; E_VTI_SIZE for a file of another length, before
///         any memory is taken for it; E_NONFINITE for a number that is none; E_RANGE for a
///         coordinate beyond the limit, a height below the bottom, or a pitch that is not
///         positive; and as `read_file`.
/// \throws LimitError if it needs more memory than the limit.
KeptStock read_stock(const std::filesystem::path& path, const ReadLimits& limits = {});

/// The same from what the file holds; `path` is named in messages.
KeptStock parse_stock(std::string_view content, const std::filesystem::path& path,
                      const ReadLimits& limits = {});

}  // namespace endmill
