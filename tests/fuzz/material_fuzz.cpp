// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"
#include "fuzz_program.h"

// A material that is read is valid, or the reader throws a documented error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    try {
        const CuttingMaterial material =
            parse_material(content, "f.json", {.max_memory_gib = 0.25});
        require_sound(material);
        program_must(is_fit_for_a_terminal(material.name + material.source));
    } catch (const FormatError& error) {
        program_must(error.file() == "f.json" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
