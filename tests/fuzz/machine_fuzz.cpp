// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"
#include "endmill/machine/feasible_directions.h"
#include "fuzz_program.h"

// A machine that is read is valid, or the reader throws a documented error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    try {
        const MachineDescription machine =
            parse_machine(content, "f.json", {.max_memory_gib = 0.25});
        require_sound(machine.limits);
        for (const AxisTravel& travel : machine.travels)
            program_must(std::isfinite(travel.from) && travel.from <= travel.to);
        const Machine moving = moving_machine(machine);
        if (moving.configuration.is_valid()) {
            const double area =
                feasible_directions(moving.configuration, moving.rotary).solid_angle();
            program_must(area >= 0 && area < 12.6);
        }
        program_must(is_fit_for_a_terminal(machine.name + machine.source));
    } catch (const FormatError& error) {
        program_must(error.file() == "f.json" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
