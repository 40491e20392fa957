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

/// \file
/// VTK XML files for ParaView and VTK: tool paths, stocks and deviations. Lengths are in
/// mm. A stock file can also be read back.
///
/// Implemented in `vtp.cpp` (tool paths), `vti.cpp` (stocks) and `deviation_vtp.cpp`.

namespace endmill {

/// The tool path as a VTK XML PolyData file (.vtp).
///
/// Points are the tips. Each run of moves of one kind in one pass is a polyline that
/// starts at the point before its first move; its cell data are `pass`, `piece` and `move`
/// (0 cut, 1 link, 2 rapid, 3 plunge, 4 retract). A piece is a run of cuts, numbered from 0;
/// other moves have the number of the piece that follows. Point data are `axis`, `has_contact` (1 or 0),
/// `contact`, `normal`, `u` and `v`. A point without contact repeats its tip and axis,
/// and its u and v are 0. Numbers are stored in binary and exactly.
/// \throws DomainError if a number is not finite.
std::string tool_path_vtp(const ToolPath& path);

/// The stock as a VTK XML ImageData file (.vti), which `read_stock` reads back.
///
/// The cells of the image are the cells of the stock. Cell data `height_mm` are its
/// heights, x running fastest; field data are the bottom, `bottom_z_mm`, and the arrays
/// of the history, if there is one: `block_mm`, `run_cutters_mm`, `run_tips` and
/// `tips_mm`. Numbers are stored in binary and exactly; those of the grid as the shortest
/// text that reads back to the same double.
std::string stock_vti(const HeightStock& stock,
                      const std::optional<StockHistory>& history = {});

/// Reads a file that `stock_vti` wrote; the stock is the same to the last bit. The head
/// of the file must equal, byte for byte, the head that `stock_vti` writes for its
/// numbers, and the file must have the length that these numbers require.
/// \throws FormatError E_VTI for another head, an invalid history, or a history of
///         another block than the heights; E_VTI_SIZE for a file of another length,
///         before any memory is allocated; E_NONFINITE for a number that is not finite;
///         E_RANGE for a coordinate beyond the limit, a height below the bottom, or a
///         pitch that is not positive; also as `read_file`.
/// \throws LimitError if it needs more memory than the limit.
KeptStock read_stock(const std::filesystem::path& path, const ReadLimits& limits = {});

/// Parses the content of a stock file as `read_stock` does.
/// \param path used in messages.
KeptStock parse_stock(std::string_view content, const std::filesystem::path& path,
                      const ReadLimits& limits = {});

/// Default number of points in a deviation file. Such a file has 22 MB.
inline constexpr std::size_t usual_deviation_points = 500'000;

/// The deviation of a part as a VTK XML PolyData file (.vtp).
///
/// Points are the centres of the part's cells, in order, each with a vertex cell. Point
/// data are `left_mm` (remaining stock along the normal; negative in a gouge) and
/// `normal`. All numbers are Float32, as the deviation is. Cells without area have no
/// normal and are left out. If there are more than `most_points`, each run of consecutive
/// cells is represented by its least and its greatest value. The file therefore contains
/// the deepest gouge and the largest remaining stock.
/// \param charts      those that the deviation was measured on.
/// \param most_points largest number of points; at least 2.
/// \throws DomainError if `most_points` is less than 2, the deviation does not belong to
///         `charts`, or a number is not finite.
std::string deviation_vtp(const PartCharts& charts, const Deviation& deviation,
                          std::size_t most_points = usual_deviation_points);

/// The points of a deviation file.
struct DeviationPoints {
    std::vector<float> point_mm;  ///< x, y, z of each point
    std::vector<float> left_mm;   ///< remaining stock; negative in a gouge
};

/// Reads the points and values of a file that `deviation_vtp` wrote.
/// \throws FormatError E_VTP for another head, and E_NONFINITE for a number that is not finite;
///         E_VTP_SIZE for a file of another length than its head requires; also as `read_file`.
/// \throws LimitError if it needs more memory than the limit.
DeviationPoints read_deviation_points(const std::filesystem::path& path,
                                      const ReadLimits& limits = {});

/// Parses the content of a deviation file as `read_deviation_points` does.
/// \param file name of the file for messages.
DeviationPoints parse_deviation_points(std::string_view content, const std::string& file,
                                       const ReadLimits& limits = {});

}  // namespace endmill
