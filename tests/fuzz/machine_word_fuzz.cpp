// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/error.h"
#include "endmill/machine/configuration.h"
#include "fuzz_program.h"

// A configuration that is read has the same word; another word is refused with its fault.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view word{reinterpret_cast<const char*>(bytes), size};
    const auto fault = configuration_fault(word);
    program_must(!fault || (!fault->empty() && is_fit_for_a_terminal(*fault)));
    try {
        const MachineConfiguration machine = configuration_from_word(word);
        program_must(!fault && machine.word == word && machine.rotary.size() <= 2);
        program_must(machine.rank >= 0 && machine.rank <= machine.axes() - 3);
        program_must(machine.is_valid() == why_not_valid(machine).empty());
    } catch (const DomainError&) {
        program_must(fault.has_value());
    }
    return 0;
}
