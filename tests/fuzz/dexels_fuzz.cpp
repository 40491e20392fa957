// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/dexel_file.h"
#include "fuzz_program.h"

// Dexels that are read are written as the same bytes, or the reader throws a documented
// error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    try {
        const KeptDexels kept =
            parse_dexels(content, "f.dexels", {.max_memory_gib = 0.25});
        program_must(kept.dexels.pitch() > 0);
        program_must(dexel_file(kept.dexels, kept.history) == content);
    } catch (const FormatError& error) {
        program_must(error.file() == "f.dexels" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
