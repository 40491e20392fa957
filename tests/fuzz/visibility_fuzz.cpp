// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>

#include "endmill/files/visibility_file.h"
#include "fuzz_program.h"

// A map that is read is written as the same bytes, or the reader throws a documented
// error. The checksum is also corrected, because a fuzzer would never find it.
namespace {

void read_and_write(std::string_view content)
{
    using namespace endmill;
    try {
        const StoredVisibility stored =
            parse_visibility(content, "f.bsm", {.max_memory_gib = 0.25});
        std::string written;
        write_visibility(stored, [&](std::string_view piece) { written += piece; });
        program_must(written == content);
    } catch (const FormatError& error) {
        program_must(error.file() == "f.bsm" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    std::string content{reinterpret_cast<const char*>(bytes), size};
    read_and_write(content);
    if (size >= 8 && size % 8 == 0) {
        const std::uint64_t sum = endmill::visibility_checksum(
            std::string_view{content}.substr(0, size - sizeof(std::uint64_t)));
        std::memcpy(content.data() + size - sizeof sum, &sum, sizeof sum);
        read_and_write(content);
    }
    return 0;
}
