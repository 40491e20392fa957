// SPDX-License-Identifier: GPL-3.0-or-later
// The only rank of `endmill`, and how `endmill` becomes `endmill-mpi`.

#include "cli/program_ranks.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include "cli/console.h"
#include "cli/mpi_launch.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

// The commands that divide their work among ranks.
constexpr std::array<std::string_view, 3> divided_commands{"setup", "sweep", "trim"};

// One rank reports the error for all.
[[noreturn]] void refuse(int rank, const std::string& reason)
{
    if (rank > 0)
        _exit(static_cast<int>(ExitCode::Usage));
    throw DomainError{"mpirun: " + reason +
                      "; install openmpi-bin, libopenmpi-dev and libboost-mpi-dev "
                      "(scripts/setup.sh mpi) and build endmill again"};
}

}  // namespace

void begin_ranks(std::span<char*> arguments)
{
    const MpiLaunch launch = mpi_launch();
    if (launch.count < 2 || arguments.size() < 2 ||
        std::ranges::find(divided_commands, arguments[1]) == divided_commands.end())
        return;
    const std::filesystem::path program = mpi_program();
    if (program.empty())
        refuse(launch.rank, "found no program endmill-mpi beside endmill");
    std::vector<char*> words{arguments.begin(), arguments.end()};
    words.push_back(nullptr);
    execv(program.c_str(), words.data());
    refuse(launch.rank, "cannot start " + program.string() + ": " + std::strerror(errno));
}

Ranks& program_ranks()
{
    static OneRank ranks;
    return ranks;
}

void check_ranks() {}

ExitCode end_ranks(ExitCode exit)
{
    return exit;
}

ExitCode end_ranks_by_exception(bool json_errors) noexcept
{
    return report_current_exception(json_errors);
}

}  // namespace endmill
