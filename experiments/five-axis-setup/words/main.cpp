// SPDX-License-Identifier: GPL-3.0-or-later
// The 18 words of Kang & Suh, the count of Sakamoto & Inasaki that they quote, and the four
// machines of figure 4.
//
//   five-axis-setup-words OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns and verdicts: README.md beside this.

#include <cstdint>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/machine/configuration.h"
#include "five-axis-setup/words/word_motions.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

void add_count(CsvTable& result, const std::string& row, std::size_t count)
{
    add_named(result, row, {{"count", static_cast<std::int64_t>(count)}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/words", [](Experiment& run) {
        CsvTable result{{"row", "count", "valid", "family", "r1", "r2", "side_r1",
                         "side_r2", "type", "rank", "largest_x", "solid_angle_sr",
                         "directions_differ"}};
        const WordCounts counts = count_words();
        add_named(
            result, "words of five axes and the bed",
            {{"count", static_cast<std::int64_t>(counts.words)},
             {"directions_differ", static_cast<std::int64_t>(words_that_differ())}});
        add_count(result, "relative motions", counts.relative_motions);
        add_count(result, "words of two rotary axes and the bed", counts.rotary_words);
        add_count(result, "five-axis machines", counts.valid);
        const double reach = Angle::degrees(run.number("reach_deg")).radians();
        const RotaryLimits limits{{-reach, reach}, {-reach, reach}};
        std::vector<double> areas;
        for (const std::string& word : rotary_words()) {
            const MachineConfiguration machine =
                configuration_from_word(whole_word(word));
            add_named(result, word, machine_cells(machine, limits));
            areas.push_back(motion_sr(machine, limits));
        }
        for (const std::string& word : run.texts("machines_of_figure_4"))
            add_named(result, word, machine_cells(configuration_from_word(word), limits));
        add_count(result, "shapes on the sphere", distinct_areas(areas));
        run.write_result(result);
    });
}
