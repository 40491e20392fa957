// SPDX-License-Identifier: GPL-3.0-or-later
// The 18 words of Kang & Suh, the count of Sakamoto & Inasaki that they quote, and the four
// machines of figure 4.
//
//   five-axis-setup-words OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns and verdicts: README.md beside this.

#include <cctype>
#include <cstdint>

#include "endmill/core/angle.h"
#include "endmill/machine/configuration.h"
#include "endmill/machine/feasible_directions.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

std::string axis_name(const MachineConfiguration& machine, std::size_t axis)
{
    return {static_cast<char>(std::toupper(machine.rotary.at(axis).letter))};
}

CsvCell family_name(const MachineConfiguration& machine)
{
    if (!machine.family)
        return std::monostate{};
    return std::string{machine.family == RotaryFamily::CA ? "CA" : "AB"};
}

CsvCell side_name(const MachineConfiguration& machine, std::size_t axis)
{
    return std::string{machine.rotary.at(axis).side == MachineSide::Table ? "part"
                                                                          : "tool"};
}

void add_machine(CsvTable& result, const std::string& row, const std::string& word,
                 const RotaryLimits& limits)
{
    const MachineConfiguration machine = configuration_from_word(word);
    const double area =
        machine.is_valid() ? feasible_directions(machine, limits).solid_angle() : 0;
    add_named(result, row,
              {{"valid", endmill::word(machine.is_valid())},
               {"family", family_name(machine)},
               {"r1", axis_name(machine, 0)},
               {"r2", axis_name(machine, 1)},
               {"side_r1", side_name(machine, 0)},
               {"side_r2", side_name(machine, 1)},
               {"rank", std::int64_t{machine.rank}},
               {"solid_angle_sr", area}});
}

void add_count(CsvTable& result, const std::string& row, std::size_t count)
{
    add_named(result, row, {{"count", static_cast<std::int64_t>(count)}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/words", [](Experiment& run) {
        CsvTable result{{"row", "count", "valid", "family", "r1", "r2", "side_r1",
                         "side_r2", "rank", "solid_angle_sr"}};
        const WordCounts counts = count_words();
        add_count(result, "words of five axes and the bed", counts.words);
        add_count(result, "relative motions", counts.relative_motions);
        add_count(result, "words of two rotary axes and the bed", counts.rotary_words);
        add_count(result, "five-axis machines", counts.valid);
        add_count(result, "shapes on the sphere", counts.families);
        const double reach = Angle::degrees(run.number("reach_deg")).radians();
        const RotaryLimits limits{{-reach, reach}, {-reach, reach}};
        for (const std::string& word : rotary_words())
            add_machine(result, word, whole_word(word), limits);
        for (const std::string& word : run.texts("machines_of_figure_4"))
            add_machine(result, word, word, limits);
        run.write_result(result);
    });
}
