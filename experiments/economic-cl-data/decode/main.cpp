// SPDX-License-Identifier: GPL-3.0-or-later
// Interprets the printed tables as whole numbers of equal passes and equal points, and
// counts how often rows without such a structure have an interpretation too.
//
//   economic-cl-data-decode OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns: README.md beside this.

#include "economic-cl-data/decode/tables.h"
#include "support/experiment.h"
#include "support/printed_tables.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "economic-cl-data/decode", [](Experiment& run) {
        const DecodingRules rules{run.number("tolerance_mm"), run.number("chord_spread"),
                                  run.number("longest_chord")};
        const NullTestPlan null{run.numbers("null_tolerances_mm"),
                                static_cast<int>(run.number("null_triples")),
                                static_cast<std::uint32_t>(run.number("null_seed"))};
        run.write_result(decoding_csv(printed_tables(), rules, null));
    });
}
