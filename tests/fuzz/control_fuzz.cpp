// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"
#include "endmill/post/gcode_writer.h"
#include "fuzz_program.h"

// A control that is read is sound and writes a program, or the reader throws a documented
// error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    try {
        const Control control =
            parse_control(content, "f.json", {.max_memory_gib = 0.25});
        require_sound(control);
        program_must(is_fit_for_a_terminal(control.name + control.source));
        const ToolPath path{{{0, 0, Move::Plunge, 0, {{1, 2, 3}, {0, 0, 1}}},
                             {0, 1, Move::Cut, 0, {{4, 5, 3}, {0, 0, 1}}}}};
        const std::string text =
            gcode(path, {.feed_mm_per_min = 1, .decimals = 0, .control = control}).text;
        program_must(is_fit_for_a_terminal(control.extension));
        program_must(text.find("G1 Z3") != std::string::npos);
    } catch (const FormatError& error) {
        program_must(error.file() == "f.json" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    } catch (const DomainError& error) {  // a block of the file exceeds its longest line
        program_must(std::string_view{error.what()}.find("characters") !=
                     std::string_view::npos);
    }
    return 0;
}
