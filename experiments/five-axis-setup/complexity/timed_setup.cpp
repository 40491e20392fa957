// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/complexity/timed_setup.h"

#include "endmill/core/parallel.h"
#include "endmill/setup/pose_search.h"
#include "endmill/setup/setup.h"
#include "support/cpu_time.h"

namespace endmill {
namespace {

void see(const StudiedPart& part)
{
    part_visibility(part.mesh, part.grid.centres);
}

std::function<void(const StudiedPart&)> search(RotaryFamily family, SetupMode mode)
{
    return [=](const StudiedPart& part) {
        pose_search(part.visibility.map, part.grid.centres, {family, mode});
    };
}

void search_whole_cones(const StudiedPart& part)
{
    five_axis_setup(
        part.grid, part.visibility.map,
        {.reach = {.configuration = configuration_of_family(RotaryFamily::AB)},
         .mode = SetupMode::WholeCones});
}

}  // namespace

std::vector<SetupWork> setup_works()
{
    return {{"visibility", see},
            {"paper CA", search(RotaryFamily::CA, SetupMode::Paper)},
            {"paper AB", search(RotaryFamily::AB, SetupMode::Paper)},
            {"corrected AB", search(RotaryFamily::AB, SetupMode::Corrected)},
            {"set AB", search_whole_cones}};
}

double work_s(const SetupWork& work, const StudiedPart& part, double budget_s)
{
    set_thread_count(1);
    return shortest_cpu_s(budget_s, [&] { work.run(part); });
}

}  // namespace endmill
