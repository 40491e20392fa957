// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/rotary_options.h"

#include <array>
#include <cctype>
#include <cstddef>

#include "cli/arguments.h"
#include "cli/idle_options.h"
#include "cli/machine_argument.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/path_file.h"

namespace endmill {
namespace {

constexpr std::array frames{Choice<Interpolation>{"joint", Interpolation::Joint},
                            Choice<Interpolation>{"part", Interpolation::Tcp}};
constexpr std::array wraps{Choice<RotaryWrap>{"shortest", RotaryWrap::Shortest},
                           Choice<RotaryWrap>{"signed", RotaryWrap::Signed}};
constexpr const char* wrapped_example = "c:shortest or a:signed,c:signed";

[[noreturn]] void refuse_wrapped(const std::string& text)
{
    throw DomainError{"--wrapped: found \"" + printable(text) + "\"; expected " +
                      wrapped_example + ", with rotary axes of the machine"};
}

// The index of a rotary axis by its letter; nothing if the machine lacks it.
std::optional<std::size_t> axis_named(const Machine& machine, const std::string& name)
{
    const auto& rotary = machine.configuration.rotary;
    for (std::size_t k = 0; k < rotary.size(); ++k)
        if (name.size() == 1 &&
            std::tolower(static_cast<unsigned char>(name.front())) == rotary[k].letter)
            return k;
    return std::nullopt;
}

std::array<RotaryWrap, 2> wraps_in(const std::string& text, const Machine& machine)
{
    std::array<RotaryWrap, 2> rules{};
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string item = text.substr(begin, end - begin);
        begin = end + 1;
        const std::size_t colon = std::min(item.find(':'), item.size() - 1);
        const auto axis = axis_named(machine, item.substr(0, colon));
        const std::string word = item.substr(colon + 1);
        bool is_known = false;
        for (const auto& [name, rule] : wraps)
            if (axis && word == name) {
                rules[*axis] = rule;
                is_known = true;
            }
        if (!is_known)
            refuse_wrapped(item);
    }
    return rules;
}

void add_machine(CLI::App& command, RotaryOptions& options)
{
    command
        .add_option(
            "--machine", options.machine,
            "machine with rotary axes: a file (endmill-machine/1), or a word such "
            "as W/caxyBz/T")
        ->type_name("MACHINE");
}

void add_setup_summary(CLI::App& command, RotaryOptions& options)
{
    command
        .add_option("--setup", options.setup,
                    "--machine: summary.json of endmill setup, for the rotation of the "
                    "part and its place")
        ->type_name("SUMMARY");
}

void add_clamp(CLI::App& command, RotaryOptions& options)
{
    command
        .add_option_function<std::string>(
            "--clamp",
            [&options](const std::string& text) {
                options.clamp = vector_argument("--clamp", text);
            },
            "--machine: where the part's origin is clamped, in mm (default 0,0,0, or "
            "that "
            "of --setup)")
        ->type_name("X,Y,Z");
}

}  // namespace

void add_clamped_machine_options(CLI::App& command, RotaryOptions& options)
{
    add_machine(command, options);
    add_clamp(command, options);
}

void add_rotary_options(CLI::App& command, RotaryOptions& options)
{
    add_machine(command, options);
    add_choice<Interpolation>(
        command, "--frame", options.frame, frames,
        "--machine: X, Y, Z are positions of the axes (joint), or tips in the part for a "
        "control that knows its kinematics (part)");
    add_setup_summary(command, options);
    add_clamp(command, options);
    command
        .add_option("--wrapped", options.wrapped,
                    "--machine: rotary words of a program that are wrapped, such as "
                    "c:shortest or c:signed (default: they count full rotations)")
        ->type_name("AXIS:RULE");
}

void refuse_idle_rotary_options(const RotaryOptions& rotary, const CommonOptions& options)
{
    if (rotary.machine.empty())
        refuse_idle_options(options,
                            std::array{"--frame", "--setup", "--clamp", "--wrapped"},
                            "no --machine", "--machine");
}

std::optional<PartOnMachine> part_on_machine(const RotaryOptions& rotary,
                                             double tool_length,
                                             const CommonOptions& options)
{
    if (rotary.machine.empty())
        return std::nullopt;
    PartOnMachine setup{
        .machine = machine_argument(rotary.machine, options.limits).machine,
        .tool_length = tool_length};
    if (!rotary.setup.empty()) {
        const ClampedPart pose = read_clamped_part(rotary.setup, options.limits);
        setup.part_to_machine = pose.part_to_machine;
        setup.clamp = pose.clamp;
    }
    if (rotary.clamp) {
        const double most = rotary.clamp->cwiseAbs().maxCoeff();
        if (!(most <= options.limits.max_extent_mm))
            throw DomainError{"--clamp: found a coordinate of " + to_text(most) +
                              " mm; expected at most " +
                              to_text(options.limits.max_extent_mm) +
                              " mm (--max-extent)"};
        setup.clamp = *rotary.clamp;
    }
    return setup;
}

RotaryReading rotary_reading(const RotaryOptions& rotary, const PartOnMachine& setup,
                             double cutter_radius)
{
    if (!rotary.frame)
        throw DomainError{
            "--machine: the program has coordinates whose frame is not known; expected "
            "--frame joint or --frame part"};
    return {.setup = setup,
            .frame = *rotary.frame,
            .wraps = wraps_in(rotary.wrapped, setup.machine),
            .cutter_radius = cutter_radius};
}

}  // namespace endmill
