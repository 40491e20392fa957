// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "endmill/core/error.h"
#include "endmill/files/surface_file.h"

static bool has_finite_points(const endmill::BezierPatch& patch)
{
    for (int j = 0; j <= patch.degree(endmill::Parameter::V); ++j)
        for (int i = 0; i <= patch.degree(endmill::Parameter::U); ++i)
            if (!patch.control_point(i, j).allFinite())
                return false;
    return true;
}

// A surface has finite control points, or the reader throws a documented error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    try {
        const SurfaceFile file = parse_surface(text, "f.json", {.max_memory_gib = 0.25});
        for (const Surface& surface : file.surfaces)
            for (int j = 0; j < surface.patches(Parameter::V); ++j)
                for (int i = 0; i < surface.patches(Parameter::U); ++i)
                    if (!has_finite_points(surface.patch(i, j)))
                        std::abort();
    } catch (const FormatError& error) {
        if (std::string{error.what()}.find_first_of("\n\x1b") != std::string::npos)
            std::abort();
    } catch (const LimitError&) {
    }
    return 0;
}
