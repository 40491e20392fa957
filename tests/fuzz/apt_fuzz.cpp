// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/apt.h"
#include "fuzz_program.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const auto parse = [](std::string_view text, const std::string& file,
                          const GcodeReadOptions& options) {
        return parse_apt(text, file, {options.max_extent_mm, options.most_points, true});
    };
    return fuzz_program(bytes, size, parse);
}
