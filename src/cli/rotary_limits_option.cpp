// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/rotary_limits_option.h"

#include <set>
#include <vector>

#include "cli/named_texts.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/machine/axis_limits.h"

namespace endmill {
namespace {

constexpr const char* limits_example = "phi=-30:110,theta=-180:180";

// A name for which limits may be given.
struct LimitName {
    std::string name;
    std::size_t axis;  // from the part to the tool
    MachineSide side;  // Head for phi and theta, which are not mirrored
};

std::vector<LimitName> limit_names(const MachineConfiguration& configuration)
{
    std::vector<LimitName> names;
    RotaryLimits any;
    for (std::size_t k = 0; k < configuration.rotary.size(); ++k) {
        const bool is_phi = &turns_of(any, configuration, k) == &any.phi;
        names.push_back({is_phi ? "phi" : "theta", k, MachineSide::Head});
        const RotaryAxis& axis = configuration.rotary[k];
        names.push_back({{axis.letter}, k, axis.side});
    }
    return names;
}

[[noreturn]] void refuse_limits(const NamedText& item, const std::string& expected)
{
    throw DomainError{"--limits: found \"" + printable(item.name + "=" + item.text) +
                      "\"; expected " + expected};
}

const LimitName& named_axis(const NamedText& item, const std::vector<LimitName>& names)
{
    std::string known;
    for (const LimitName& name : names) {
        if (name.name == item.name)
            return name;
        known += (known.empty() ? "" : ", ") + name.name;
    }
    refuse_limits(item, names.empty() ? "no limits: there is no rotary axis"
                                      : "limits of " + known);
}

RotaryRange range_of(const NamedText& item, const LimitName& axis)
{
    const std::vector<std::string> ends = parts_of(item.text, ':');
    const auto from = number_from_text(ends.front());
    const auto to = number_from_text(ends.back());
    if (ends.size() != 2 || !from || !to)
        refuse_limits(item, "LO:HI in degrees, as in " + std::string{limits_example});
    if (const auto expected = expected_rotary_range(axis.axis, *from, *to))
        refuse_limits(item, *expected);
    return mirrored(axis.side, RotaryRange{Angle::degrees(*from).radians(),
                                           Angle::degrees(*to).radians()});
}

RotaryLimits limits_in(const std::string& text, const MachineConfiguration& configuration,
                       const std::vector<LimitName>& names, RotaryLimits limits)
{
    std::set<std::size_t> given;
    for (const NamedText& item : named_texts("--limits", text, limits_example)) {
        const LimitName& axis = named_axis(item, names);
        if (!given.insert(axis.axis).second)
            refuse_limits(item, "limits of each axis at most once");
        turns_of(limits, configuration, axis.axis) = range_of(item, axis);
    }
    return limits;
}

}  // namespace

Machine limited_machine(Machine machine, const std::string& text)
{
    const std::vector<LimitName> names = limit_names(machine.configuration);
    machine.rotary = limits_in(text, machine.configuration, names, machine.rotary);
    for (const NamedText& item : named_texts("--limits", text, limits_example))
        machine.wide_positions[named_axis(item, names).axis] = std::nullopt;
    return machine;
}

RotaryLimits limits_for_family(const std::string& text, RotaryFamily family)
{
    const MachineConfiguration any =
        configuration_from_word(family == RotaryFamily::CA ? "W/Bcaxyz/T" : "W/Babxyz/T");
    std::vector<LimitName> names = limit_names(any);
    std::erase_if(names, [](const LimitName& name) { return name.name.size() == 1; });
    return limits_in(text, any, names, {});
}

}  // namespace endmill
