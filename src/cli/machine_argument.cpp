// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/machine_argument.h"

#include <filesystem>
#include <system_error>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/machining_data.h"

namespace endmill {
namespace {

bool is_machine_file(const std::string& text)
{
    std::error_code ignored;  // a path that cannot be examined counts as a word
    return text.ends_with(".json") || std::filesystem::exists(text, ignored);
}

}  // namespace

MachineArgument machine_argument(const std::string& text, const ReadLimits& limits)
{
    if (is_machine_file(text))
        return {moving_machine(read_machine(text, limits)), text};
    if (const auto fault = configuration_fault(text))
        throw DomainError{"found \"" + printable(text) + "\": " + *fault +
                          "; expected a word such as W/caxyBz/T, from workpiece to tool "
                          "with B the bed, or a machine file (.json)"};
    Machine machine{.configuration = configuration_from_word(text)};
    machine.rotary = widest_limits(machine.configuration);
    return {machine, {}};
}

}  // namespace endmill
