// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "endmill/files/vtk.h"
#include "fuzz_program.h"

// A stock that is read is valid and is written as the same bytes, or the reader throws a
// documented error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    try {
        const KeptStock kept = parse_stock(content, "f.vti", {.max_memory_gib = 0.25});
        const HeightStock& stock = kept.heights;
        const StockGrid& grid = stock.grid();
        program_must(grid.pitch > 0 && grid.columns > 0 && grid.rows > 0);
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column)
                program_must(std::isfinite(stock.height(column, row)) &&
                             stock.height(column, row) >= grid.bottom_z);
        program_must(stock_vti(stock, kept.history) == content);
    } catch (const FormatError& error) {
        program_must(error.file() == "f.vti" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
