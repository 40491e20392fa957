// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    return endmill::fuzz_mesh(bytes, size, "f.stl");
}
