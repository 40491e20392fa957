// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/deviation/deviation.h"
#include "endmill/files/read_file.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/stock_history.h"

namespace endmill {

/// The tool path as a VTK XML PolyData file (.vtp), lengths in mm, for ParaView and VTK.
///
/// Points are the tips. A polyline for each run of moves of one kind in one pass, from
/// the point where the run begins; its cell data are `pass` and `move` (0 cut, 1 link,
/// 2 rapid, 3 plunge, 4 retract). Point data are `axis`, `has_contact` (1 or 0),
/// `contact`, `normal`, `u` and `v`; without a contact they repeat the tip and the
/// axis, and u and v are 0. Numbers are stored in binary, exactly.
/// \throws DomainError if a number is not finite.
std::string tool_path_vtp(const ToolPath& path);

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

/// Points of a deviation's file, unless the caller says otherwise: 22 MB.
inline constexpr std::size_t usual_deviation_points = 500'000;

/// The deviation of a part as a VTK XML PolyData file (.vtp), lengths in mm, for ParaView
/// and VTK.
///
/// Points are the middles of the part's cells, in their order, each a vertex of its own;
/// point data are `left_mm`, along the normal, negative where too much is gone, and
/// `normal`. All are Float32, as the deviation is. Cells without area are left out: they
/// have no normal. If there are more than `most_points`, of every so many cells in a row
/// there stand only the one with the most and the one with the least left, so that
/// neither the deepest gouge nor the highest rest is lost.
///
/// \param charts those that were measured. \param most_points at least 2.
/// \throws DomainError if `most_points` is less, the deviation is not one of `charts`, or
///         a number is not finite.
std::string deviation_vtp(const PartCharts& charts, const Deviation& deviation,
                          std::size_t most_points = usual_deviation_points);

}  // namespace endmill
