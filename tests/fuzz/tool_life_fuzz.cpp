// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/input_csv.h"
#include "fuzz_program.h"

// A line is fitted to speeds that are read and its numbers are valid, or the fit refuses
// data that do not decrease, or the reader throws a documented error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    try {
        const auto data =
            parse_cutting_speeds(content, "f.csv", {.max_memory_gib = 0.25});
        require_sound(fitted_speed_line(data));
    } catch (const FormatError& error) {
        program_must(error.file() == "f.csv" && is_fit_for_a_terminal(error.what()));
    } catch (const GeometryError& error) {
        program_must(is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
