// SPDX-License-Identifier: GPL-3.0-or-later
// Plans verified finishing passes on a surface and writes them as a tool path.
//
//   plan [SURFACE]

#include <exception>
#include <fstream>
#include <iostream>

#include "endmill/files.h"
#include "endmill/planning.h"

int main(int argc, char** argv)
try {
    using namespace endmill;
    const SurfaceFile part =
        read_surface(argc > 1 ? argv[1] : "datasets/surfaces/saddle.json");
    const BallCutter ball{/*radius=*/10};

    VerifiedOptions options;
    options.direction = Parameter::U;
    options.tolerances = {/*inner=*/0.05, /*outer=*/0.05};  // mm
    options.scallop_height = 0.05;                          // mm
    const VerifiedPlan plan = plan_verified(part.surfaces, ball, options);

    const PathEconomy economy = path_economy(plan.path);
    std::cout << economy.ncl << " cutter locations, " << economy.cut.contact_mm
              << " mm of cut\n";
    std::ofstream{"toolpath.csv"} << tool_path_csv(plan.path);
    return plan.uncovered.empty() ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "plan: " << error.what() << '\n';
    return 2;
}
