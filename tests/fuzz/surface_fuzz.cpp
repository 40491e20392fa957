// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "endmill/core/error.h"
#include "endmill/files/surface_file.h"

// A surface that is written and read again is the same, or the reader throws a documented
// error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    try {
        const SurfaceFile file = parse_surface(text, "f.json", {.max_memory_gib = 0.25});
        const std::string written = surface_json(file);
        if (surface_json(parse_surface(written, "f.json")) != written)
            std::abort();
    } catch (const FormatError& error) {
        if (std::string{error.what()}.find_first_of("\n\x1b") != std::string::npos)
            std::abort();
    } catch (const LimitError&) {
    }
    return 0;
}
