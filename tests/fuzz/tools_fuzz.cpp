// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"
#include "fuzz_program.h"

// A tool table that is read has valid tools with ascending numbers, or the reader throws a
// documented error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    for (const std::optional<double> unit_mm : {std::optional<double>{}, {25.4}})
        try {
            const std::vector<NumberedTool> tools =
                parse_tool_table(content, "f.tbl", {{.max_memory_gib = 0.25}, unit_mm});
            program_must(!tools.empty());
            for (std::size_t k = 0; k < tools.size(); ++k) {
                program_must(tools[k].number >= 0);
                program_must(k == 0 || tools[k - 1].number < tools[k].number);
                require_sound(tools[k].tool);
            }
        } catch (const FormatError& error) {
            program_must(error.file() == "f.tbl" && is_fit_for_a_terminal(error.what()));
        } catch (const DomainError& error) {
            program_must(is_fit_for_a_terminal(error.what()));
        } catch (const LimitError&) {
        }
    return 0;
}
