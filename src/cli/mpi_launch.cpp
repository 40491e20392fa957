// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mpi_launch.h"

#include <array>
#include <cstdlib>
#include <optional>
#include <system_error>

#include <unistd.h>

#include "cli/data_folder.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// The variables of a launcher.
struct Launcher {
    const char* count;
    const char* rank;
};

constexpr std::array launchers{
    Launcher{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
    Launcher{"PMI_SIZE", "PMI_RANK"},
    Launcher{"SLURM_STEP_NUM_TASKS", "PMIX_RANK"},
};

std::optional<int> number_of(const char* variable)
{
    const char* const text = std::getenv(variable);
    const std::optional<double> number = text ? number_from_text(text) : std::nullopt;
    if (!number || !(0 <= *number && *number <= 1e9))
        return std::nullopt;
    return static_cast<int>(*number);
}

}  // namespace

MpiLaunch mpi_launch()
{
    for (const Launcher& launcher : launchers) {
        const std::optional<int> count = number_of(launcher.count);
        const std::optional<int> rank = number_of(launcher.rank);
        if (count && rank && *count > 0)
            return {*count, *rank};
    }
    return {};
}

void forget_mpi_launch()
{
    for (const Launcher& launcher : launchers) {
        unsetenv(launcher.count);
        unsetenv(launcher.rank);
    }
}

std::filesystem::path mpi_program()
{
    const std::filesystem::path program = program_folder() / "endmill-mpi";
    return access(program.c_str(), X_OK) == 0 ? program : std::filesystem::path{};
}

}  // namespace endmill
