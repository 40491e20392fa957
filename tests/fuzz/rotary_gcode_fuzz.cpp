// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/configuration.h"
#include "endmill/post/gcode_reader.h"
#include "fuzz_program.h"

// A program with rotary words, read for a machine that the first byte chooses. The poses are
// finite, and the positions of the machine give them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    if (size == 0)
        return 0;
    RotaryReading rotary;
    const std::vector<std::string> words = rotary_words();
    Machine& machine = rotary.setup.machine;
    machine.configuration =
        configuration_from_word(whole_word(words[*bytes % words.size()]));
    machine.table_offset = {1, 2, 3};
    machine.pivot = 100;
    rotary.frame = (*bytes & 32U) != 0 ? Interpolation::Tcp : Interpolation::Joint;
    rotary.wraps[0] = static_cast<RotaryWrap>((*bytes >> 6U) % 3);
    return fuzz_program(
        bytes + 1, size - 1,
        [&](std::string_view text, const std::string& file, GcodeReadOptions options) {
            options.rotary = rotary;
            Program program = parse_gcode(text, file, options);
            const MachineMotion& moved = *program.path.machine;
            program_must(moved.positions.size() == program.path.points.size());
            for (std::size_t i = 0; i < moved.positions.size(); ++i) {
                const CutterLocation at = tool_location(moved.setup, moved.positions[i]);
                const Vec3& tip = program.path.points[i].location.tip;
                program_must((at.tip - tip).norm() <= 1e-8);
            }
            return program;
        });
}
