// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_path_reader.h"
#include "endmill/files/path_file.h"
#include "fuzz_program.h"

// A path that is read, written and read again is the same path.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    try {
        const std::string written = tool_path_csv(parse_tool_path(text, "f.csv").path);
        program_must(tool_path_csv(parse_tool_path(written, "g.csv").path) == written);
    } catch (const FormatError& error) {
        program_must(error.file() == "f.csv" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
