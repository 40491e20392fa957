// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_machine.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/data_folder.h"
#include "cli/machine_argument.h"
#include "cli/rotary_limits_option.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

SearchedMachine family_machine(const SetupCommandOptions& options)
{
    const bool is_ca = *options.family == RotaryFamily::CA;
    SearchedMachine found{is_ca ? "CA" : "AB", {}, true, {}};
    found.machine.configuration = configuration_of_family(*options.family);
    if (!options.limits.empty())
        found.machine.rotary = limits_for_family(options.limits, *options.family);
    return found;
}

SearchedMachine one_machine(const std::string& text, const SetupCommandOptions& options)
{
    const MachineArgument read = machine_argument(text, options.common.limits);
    SearchedMachine found{read.machine.configuration.word, read.file, false,
                          read.machine};
    if (!options.limits.empty())
        found.machine = limited_machine(found.machine, options.limits);
    return found;
}

// All machine files of a folder, sorted by name.
std::vector<SearchedMachine> machines_of_folder(const std::filesystem::path& folder,
                                                const SetupCommandOptions& options)
{
    if (!options.limits.empty())
        throw DomainError{"--limits: found with several machines; expected one machine"};
    std::vector<std::string> files;
    std::error_code failed;
    for (std::filesystem::directory_iterator entry{folder, failed}, end;
         !failed && entry != end; entry.increment(failed))
        if (entry->path().extension() == ".json")
            files.push_back(entry->path().string());
    if (failed)
        throw FormatError{
            "E_OPEN",
            {printable(folder.string()), "", "cannot open: " + failed.message(), ""}};
    std::ranges::sort(files);
    std::vector<SearchedMachine> machines;
    machines.reserve(files.size());
    for (const std::string& file : files)
        machines.push_back(one_machine(file, options));
    if (machines.empty())
        throw FormatError{"E_MACHINE",
                          {printable(folder.string()), "", "no file in it ends in .json",
                           "machine files (endmill-machine/1)"}};
    return machines;
}

}  // namespace

std::vector<SearchedMachine> setup_machines(const SetupCommandOptions& options)
{
    if (options.machine.empty() == !options.family)
        throw DomainError{
            "expected --machine (a word, a file, a folder or all), or --family CA or AB, "
            "and not both"};
    if (options.family)
        return {family_machine(options)};
    if (options.machine == "all")
        return machines_of_folder(data_folder("--machine all", "machines"), options);
    std::error_code ignored;
    if (std::filesystem::is_directory(options.machine, ignored))
        return machines_of_folder(options.machine, options);
    return {one_machine(options.machine, options)};
}

}  // namespace endmill
