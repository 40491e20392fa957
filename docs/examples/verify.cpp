// SPDX-License-Identifier: GPL-3.0-or-later
// Simulates the cut of a path and prints the verdict.
//
//   verify [SURFACE [TOOLPATH]]; without a path it plans a coarse one

#include <exception>
#include <iostream>

#include "endmill/files.h"
#include "endmill/planning.h"
#include "endmill/verification.h"

int main(int argc, char** argv)
try {
    using namespace endmill;
    const Part part =
        read_part(argc > 1 ? argv[1] : "datasets/surfaces/saddle.json").part;
    const Cutter cutter = Cutter::ball(/*radius=*/10);
    const ToolPath path = argc > 2
                              ? read_program(argv[2]).path
                              : plan_iso_parametric(std::get<0>(part), BallCutter{10},
                                                    {.chord_tolerance = 1})
                                    .path;

    VerificationTask task{.path = &path,
                          .cutter = cutter,
                          .judged = JudgedPart{&part, {.tolerance = 1, .scallop = 3}},
                          .stock = default_block(&part, path, cutter)};
    task.resolution = 0.5;  // mm, as the limits
    const Verification found = verify_path(task);

    const Deviation& deviation = found.on_part->deviation;
    std::cout << verdict_name(found.verdict) << ": gouge " << deviation.max_gouge_mm
              << " mm, remaining stock " << deviation.max_scallop_mm << " mm\n";
    return found.verdict == Verdict::Clean ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "verify: " << error.what() << '\n';
    return 2;
}
