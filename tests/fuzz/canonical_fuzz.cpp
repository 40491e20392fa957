// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_reader.h"
#include "fuzz_program.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    return endmill::fuzz_program(bytes, size, endmill::parse_canonical);
}
