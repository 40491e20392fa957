// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/vtk.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/file_format.h"
#include "endmill/files/detail/history_arrays.h"
#include "endmill/files/read_file.h"

// A stock file is read only if this library wrote it. That makes the reader short and
// strict:
//
// 1. The grid and the counts of the history are taken from the head without much
//    checking.
// 2. `head_of` writes the head for these numbers again. The file must begin with exactly
//    these bytes, so every other deviation from the format is refused at once.
// 3. The length of the file must be the length that the numbers require. Only then is
//    memory allocated.
// 4. Heights and history are read and checked number by number.

namespace endmill {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the file declares LittleEndian and holds the numbers as memory does");

using Size = std::uint64_t;  // number of bytes, in front of each array

constexpr std::string_view tail = "\n </AppendedData>\n</VTKFile>\n";
constexpr std::string_view extent_key = "WholeExtent=\"0 ";
constexpr std::string_view origin_key = "Origin=\"";
constexpr std::string_view spacing_key = "Spacing=\"";
// Longer than any head that `head_of` writes.
constexpr std::size_t longest_head = 3000;
// More than any file holds; their size in bytes still fits into 64 bits.
constexpr std::int64_t most_tips = std::int64_t{1} << 40;

// Number of cells of a grid.
std::size_t cells_of(const StockGrid& grid)
{
    return static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
}

// Size of the arrays of the bottom and the heights, which come first.
std::size_t bytes_before_history(const StockGrid& grid)
{
    return 2 * sizeof(Size) + sizeof(double) + cells_of(grid) * sizeof(double);
}

// The XML before the arrays. The bottom is also the z of the origin, so that the head
// states it.
std::string head_of(const StockGrid& grid, const std::optional<HistoryCounts>& history)
{
    const std::string extent =
        "0 " + std::to_string(grid.columns) + " 0 " + std::to_string(grid.rows) + " 0 0";
    const std::string pitch = to_text(grid.pitch);
    std::string head =
        "<?xml version=\"1.0\"?>\n"
        "<!-- Stock of a removal: heights in mm at the centres of the cells. -->\n"
        "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n";
    head += " <ImageData WholeExtent=\"" + extent + "\" Origin=\"" + to_text(grid.low_x) +
            " " + to_text(grid.low_y) + " " + to_text(grid.bottom_z) + "\" Spacing=\"" +
            pitch + " " + pitch + " " + pitch + "\">\n";
    head +=
        "  <FieldData>\n"
        "   <DataArray type=\"Float64\" Name=\"bottom_z_mm\" NumberOfTuples=\"1\" "
        "format=\"appended\" offset=\"0\"/>\n";
    if (history)
        head += history_elements(*history, bytes_before_history(grid));
    head += "  </FieldData>\n";
    head += "  <Piece Extent=\"" + extent + "\">\n";
    head +=
        "   <CellData Scalars=\"height_mm\">\n"
        "    <DataArray type=\"Float64\" Name=\"height_mm\" NumberOfComponents=\"1\" "
        "format=\"appended\" offset=\"16\"/>\n"
        "   </CellData>\n  </Piece>\n </ImageData>\n <AppendedData encoding=\"raw\">\n_";
    return head;
}

template <typename Value>
void append_bytes(std::string& file, const Value& value)
{
    const auto* bytes = reinterpret_cast<const char*>(&value);
    file.append(bytes, sizeof value);
}

template <typename Value>
Value value_at(std::string_view content, std::size_t at)
{
    Value value;
    std::memcpy(&value, content.data() + at, sizeof value);
    return value;
}

// Reads the words of an XML attribute in order.
class Attribute {
public:
    // Finds the attribute whose name and opening quote are `key`. If there is none, all
    // its words are empty.
    Attribute(std::string_view head, std::string_view key)
    {
        const std::size_t begin = head.find(key);
        if (begin == std::string_view::npos)
            return;
        rest_ = head.substr(begin + key.size());
        rest_ = rest_.substr(0, rest_.find('"'));
    }

    // The next word; empty at the end.
    std::string_view word()
    {
        const std::size_t end = std::min(rest_.find(' '), rest_.size());
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        return word;
    }

    double number() { return number_from_text(word()).value_or(std::nan("")); }

    // A whole number; 0 for another word, which makes a grid without cells that is
    // refused.
    int count()
    {
        const std::string_view text = word();
        int value = 0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        return value;
    }

private:
    std::string_view rest_;
};

// The grid in the head; missing numbers become 0 or NaN. The reading need not be strict,
// because the head is compared byte for byte with the head of this grid afterwards.
StockGrid named_grid(std::string_view head)
{
    Attribute extent{head, extent_key};
    const int columns = extent.count();
    extent.word();
    const int rows = extent.count();
    Attribute origin{head, origin_key};
    const double x = origin.number();
    const double y = origin.number();
    const double z = origin.number();
    const double pitch = Attribute{head, spacing_key}.number();
    return {.low_x = x,
            .low_y = y,
            .pitch = pitch,
            .columns = columns,
            .rows = rows,
            .bottom_z = z};
}

// Reads and checks one file.
class StockReader {
public:
    StockReader(std::string_view content, std::string file, const ReadLimits& limits)
        : content_{content},
          file_{std::move(file)},
          limits_{limits}
    {
    }

    // Reads the whole file in the order of the steps above.
    KeptStock stock() const
    {
        const StockGrid grid = checked_grid();
        const auto counts = named_history(content_.substr(0, longest_head));
        if (counts &&
            (counts->runs < 1 || counts->tips < counts->runs || counts->tips > most_tips))
            throw complaint("E_VTI", "", "a history without runs or tips",
                            "a run, and a tip for each");
        const std::string head = head_of(grid, counts);
        if (!content_.starts_with(head))
            throw complaint("E_VTI", "", "a head that endmill does not write",
                            "a stock.vti of endmill");
        check_size(grid, head.size(), counts);
        std::size_t at = head.size();
        check(value_at<Size>(content_, at) == sizeof(double) &&
                  value_at<double>(content_, at + sizeof(Size)) == grid.bottom_z,
              at, "a bottom that differs from the z of the origin");
        at += sizeof(Size) + sizeof(double);
        check(value_at<Size>(content_, at) == cells_of(grid) * sizeof(double), at,
              "a number of heights that differs from the number of cells");
        at += sizeof(Size);
        KeptStock stock{stock_of_heights(grid, heights(grid, at))};
        if (counts)
            stock.history = history_of(stock.heights,
                                       head.size() + bytes_before_history(grid), *counts);
        return stock;
    }

private:
    // An error at a place; the place is empty if the whole file is meant.
    FormatError complaint(const std::string& code, const std::string& place,
                          const std::string& found, const std::string& expected) const
    {
        return {code, {file_, place, found, expected}};
    }

    // Throws an error at byte `at` unless `holds`.
    void check(bool holds, std::size_t at, const std::string& found) const
    {
        if (!holds)
            throw complaint("E_VTI", "@" + std::to_string(at), found,
                            "the bytes that endmill writes there");
    }

    // The history, after a check that its block is the block of the heights.
    StockHistory history_of(const HeightStock& heights, std::size_t at,
                            const HistoryCounts& counts) const
    {
        StockHistory history = parse_history(content_, at, counts, file_, limits_);
        const StockGrid& grid = heights.grid();
        const Vec3 size = history.block.high - history.block.low;
        // The first condition keeps the number of cells of the block within an int.
        const bool is_same = size.head<2>().maxCoeff() / grid.pitch < 2e9 &&
                             grid_over(history.block, grid.pitch) == grid;
        const auto range = height_range(heights);
        check(is_same && !(range && range->high > history.block.high.z()), at,
              "a history whose block is not that of the heights");
        return history;
    }

    // The grid of the head, after a check that the content is VTK and the grid is valid.
    StockGrid checked_grid() const
    {
        const auto format = recognized_format(content_);
        if (!format || (*format != "VTK" && *format != "XML"))
            throw complaint("E_FORMAT", "",
                            format ? "content looks like " + std::string{*format}
                                   : "content is not VTK",
                            "a stock.vti of endmill");
        const StockGrid grid = named_grid(content_.substr(0, longest_head));
        if (grid.columns < 1 || grid.rows < 1)
            throw complaint("E_VTI", "", "no cells in WholeExtent", "a count above 0");
        if (!std::isfinite(grid.low_x) || !std::isfinite(grid.low_y) ||
            !std::isfinite(grid.bottom_z) || !std::isfinite(grid.pitch))
            throw complaint("E_VTI", "", "an Origin or Spacing without its numbers",
                            "three numbers each");
        if (!(grid.pitch > 0))
            throw complaint("E_RANGE", "", "a Spacing of " + to_text(grid.pitch),
                            "one above 0");
        const double far_x = grid.x(grid.columns);
        const double far_y = grid.y(grid.rows);
        for (const double corner : {grid.low_x, grid.low_y, grid.bottom_z, far_x, far_y})
            if (!(std::abs(corner) <= limits_.max_extent_mm))
                throw complaint("E_RANGE", "",
                                "a coordinate of " + to_text(corner) + " mm",
                                "at most " + to_text(limits_.max_extent_mm) + " mm");
        return grid;
    }

    // Counted in doubles: the numbers of cells are not to be trusted yet.
    void check_size(const StockGrid& grid, std::size_t head,
                    const std::optional<HistoryCounts>& counts) const
    {
        const double history = counts ? history_bytes(*counts) : 0;
        const double cells = static_cast<double>(grid.columns) * grid.rows;
        const double expected =
            static_cast<double>(head + tail.size() + 2 * sizeof(Size) + sizeof(double)) +
            cells * sizeof(double) + history;
        if (static_cast<double>(content_.size()) != expected || !content_.ends_with(tail))
            throw complaint("E_VTI_SIZE", "",
                            "the head says " + std::to_string(grid.columns) + " x " +
                                std::to_string(grid.rows) + " cells, the file has " +
                                std::to_string(content_.size()) + " bytes",
                            to_text(expected) + " bytes");
        // Memory for the file, the heights, and the stock, whose last tiles are partly
        // empty.
        constexpr double most_beyond = HeightStock::tile_side - 1;
        const double tiled = (grid.columns + most_beyond) * (grid.rows + most_beyond);
        require_memory(file_,
                       static_cast<double>(content_.size()) +
                           (cells + tiled) * sizeof(double) + history,
                       limits_);
    }

    // The heights, each checked against the bottom and the limit.
    std::vector<double> heights(const StockGrid& grid, std::size_t at) const
    {
        std::vector<double> values(cells_of(grid));
        std::memcpy(values.data(), content_.data() + at, values.size() * sizeof(double));
        for (std::size_t k = 0; k < values.size(); ++k)
            check_height(values[k], grid, at + k * sizeof(double));
        return values;
    }

    // Checks one height.
    void check_height(double z, const StockGrid& grid, std::size_t at) const
    {
        if (!std::isfinite(z))
            throw complaint("E_NONFINITE", "@" + std::to_string(at),
                            "a height that is not finite", "a number of mm");
        if (z < grid.bottom_z || z > limits_.max_extent_mm)
            throw complaint("E_RANGE", "@" + std::to_string(at),
                            "a height of " + to_text(z) + " mm",
                            "one from the bottom, " + to_text(grid.bottom_z) +
                                " mm, to " + to_text(limits_.max_extent_mm) + " mm");
    }

    std::string_view content_;
    std::string file_;
    ReadLimits limits_;
};

}  // namespace

std::string stock_vti(const HeightStock& stock,
                      const std::optional<StockHistory>& history)
{
    const StockGrid& grid = stock.grid();
    std::optional<HistoryCounts> counts;
    if (history)
        counts = counts_of(*history);
    const std::string head = head_of(grid, counts);
    std::string file;
    file.reserve(head.size() + tail.size() + bytes_before_history(grid) +
                 (counts ? static_cast<std::size_t>(history_bytes(*counts)) : 0));
    file += head;
    append_bytes(file, Size{sizeof(double)});
    // The text in the head has no negative zero, so the array must not have one either.
    append_bytes(file, grid.bottom_z == 0 ? 0.0 : grid.bottom_z);
    append_bytes(file, Size{cells_of(grid) * sizeof(double)});
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            append_bytes(file, stock.height(column, row));
    if (history)
        append_history(file, *history);
    file += tail;
    return file;
}

KeptStock read_stock(const std::filesystem::path& path, const ReadLimits& limits)
{
    return parse_stock(read_file(path, limits), path, limits);
}

KeptStock parse_stock(std::string_view content, const std::filesystem::path& path,
                      const ReadLimits& limits)
{
    return StockReader{content, shown_path(path), limits}.stock();
}

}  // namespace endmill
