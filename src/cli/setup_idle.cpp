// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_idle.h"

#include <array>
#include <string>

#include "cli/idle_options.h"

namespace endmill {
namespace {

// Options of the mesh, of its visibility, or of the search over facets.
constexpr std::array part_only_options{"--units",
                                       "--up",
                                       "--chord-tolerance",
                                       "--clamp",
                                       "--sphere",
                                       "--visibility",
                                       "--incidence-deg",
                                       "--tool",
                                       "--write-bsm-csv",
                                       "--floor-deg",
                                       "--arc-tolerance-deg",
                                       "--max-setups",
                                       "--from-visibility",
                                       "--within-travel",
                                       "--skip-facets"};

// Options of the mesh, or of a search over facets or given directions. A path is run by one
// search, and --clamp and --tool place part and tool in it.
constexpr std::array no_path_options{"--units",
                                     "--up",
                                     "--chord-tolerance",
                                     "--sphere",
                                     "--visibility",
                                     "--incidence-deg",
                                     "--write-bsm-csv",
                                     "--mode",
                                     "--objective",
                                     "--gap",
                                     "--max-nodes",
                                     "--floor-deg",
                                     "--arc-tolerance-deg",
                                     "--max-setups",
                                     "--from-visibility",
                                     "--within-travel",
                                     "--skip-facets"};

constexpr std::array set_only_options{"--objective", "--gap", "--max-nodes"};

// With fewer than five axes there is one search. The mode `set` changes what is reported:
// with four axes its objective, with three the least number of setups.
bool is_mode_idle(const MachineConfiguration& configuration,
                  const SetupCommandOptions& options)
{
    if (!configuration.is_valid() || configuration.axes() == 5)
        return false;
    return options.mode != SetupMode::WholeCones ||
           (configuration.axes() == 3 && options.max_setups == 1);
}

}  // namespace

void refuse_idle_setup_options(const SetupCommandOptions& options)
{
    const CommonOptions& common = options.common;
    if (!options.points.empty())
        refuse_idle_options(common, part_only_options, "--points",
                            "a PART: directions have neither facets nor a mesh");
    if (!options.toolpath.empty()) {
        refuse_idle_options(common, no_path_options, "--path",
                            "a PART: the tool axes of a path are given");
        refuse_idle_options(common, std::array{"--family"}, "--path",
                            "--machine: a family has no linear axes");
    }
    if (options.mode != SetupMode::WholeCones)
        refuse_idle_options(common, set_only_options,
                            "--mode " + std::string{setup_mode_word(options.mode)},
                            "--mode set, the only search with a bound");
    if (options.family)
        refuse_idle_options(common, std::array{"--clamp", "--within-travel"}, "--family",
                            "--machine: a family has no linear axes");
}

void refuse_options_idle_on(std::span<const SearchedMachine> machines,
                            const SetupCommandOptions& options)
{
    const MachineConfiguration& first = machines.front().machine.configuration;
    if (machines.size() > 1 || !first.is_valid())
        return;
    const std::string machine =
        machines.front().is_family ? "--family" : "--machine " + first.word;
    if (machines.front().machine.linear == LinearLimits{})
        refuse_idle_options(options.common, std::array{"--within-travel"}, machine,
                            "a machine file with x_mm, y_mm or z_mm: this machine has no "
                            "limits of its linear axes");
    if (first.axes() != 4)
        refuse_idle_options(options.common, std::array{"--arc-tolerance-deg"}, machine,
                            "a machine with one rotary axis");
    if (first.axes() != 5)
        refuse_idle_options(options.common, set_only_options, machine,
                            "a machine with two rotary axes");
    if (is_mode_idle(first, options))
        refuse_idle_options(options.common, std::array{"--mode"}, machine,
                            "a machine with two rotary axes");
}

std::optional<SetupMode> effective_mode(std::span<const SearchedMachine> machines,
                                        const SetupCommandOptions& options)
{
    const bool is_idle = machines.size() == 1 &&
                         is_mode_idle(machines.front().machine.configuration, options);
    return is_idle ? std::nullopt : std::optional{options.mode};
}

}  // namespace endmill
