// SPDX-License-Identifier: GPL-3.0-or-later
// consumer SURFACE: prints the number of CL points along u for a ball of 15 mm diameter.

#include <exception>
#include <iostream>

#include "endmill/files/surface_file.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/iso_parametric.h"

int main(int argc, char** argv)
try {
    const endmill::SurfaceFile part =
        endmill::read_surface(argc > 1 ? argv[1] : "surface.json");
    const endmill::BallCutter ball{/*radius=*/7.5};
    const auto plan =
        plan_iso_parametric(part.surfaces, ball,
                            {.direction = endmill::Parameter::U, .chord_tolerance = 0.5});
    std::cout << path_economy(plan.path).ncl << '\n';
    return 0;
} catch (const std::exception& error) {
    std::cerr << "consumer: " << error.what() << '\n';
    return 1;
}
