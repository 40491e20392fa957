// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 3 and 4 of Kang & Suh: the axes of five-axis machines, and four of the
// machines.
//
//   five-axis-setup-figure-3-4 OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns and verdicts: README.md beside this.

#include <cstdint>

#include "endmill/core/angle.h"
#include "endmill/figures/setup_figures.h"
#include "endmill/machine/kinematics.h"
#include "support/experiment.h"
#include "support/setup_cells.h"

using namespace endmill;

namespace {

// For each axis: what it turns, its number among the rotary axes, and the tool direction
// in the part's frame when this axis alone is at `position`; then the tool direction with
// both axes at `position`.
void add_machine(CsvTable& table, const std::string& row, const Machine& machine,
                 double position)
{
    const auto tool_at = [&](const RotaryPositions& rotary) {
        return tool_location(machine, {.rotary = rotary}, 0).axis;
    };
    const auto& axes = machine.configuration.rotary;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        RotaryPositions alone{0, 0};
        alone.at(k) = position;
        const Vec3 tool = tool_at(alone);
        table.add_row({row + " " + axes[k].letter, static_cast<std::int64_t>(k + 1),
                       axes[k].side == MachineSide::Table ? "part" : "tool", tool.x(),
                       tool.y(), tool.z()});
    }
    const Vec3 tool = tool_at({position, position});
    table.add_row({row + " both", {}, {}, tool.x(), tool.y(), tool.z()});
}

bool is_part(const MachineConfiguration& machine, std::size_t axis)
{
    return machine.rotary.at(axis).side == MachineSide::Table;
}

std::string what_turns(const MachineConfiguration& machine)
{
    if (is_part(machine, 0) != is_part(machine, 1))
        return "the table and the spindle turn";
    return is_part(machine, 0) ? "the table turns and tilts"
                               : "the spindle turns and tilts";
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-setup/figure-3-4", [](Experiment& run) {
        CsvTable table{{"row", "number", "turns", "tool_x", "tool_y", "tool_z"}};
        const double position = Angle::degrees(run.number("position_deg")).radians();
        const auto words = run.texts("machines");
        const auto names = run.texts("names");
        const auto printed = run.texts("printed_types");
        for (std::size_t k = 0; k < words.size(); ++k) {
            const Machine machine{.configuration = configuration_from_word(words[k])};
            add_machine(table, names.at(k) + " " + words[k], machine, position);
            const bool is_ca = machine.configuration.family == RotaryFamily::CA;
            run.write("machine-" + names[k] + ".svg",
                      machine_svg(machine.configuration,
                                  "Figure 4 (" + names[k] + "): " + words[k],
                                  {what_turns(machine.configuration) + ": family " +
                                       (is_ca ? "C,A" : "A,B"),
                                   "label in section 3.1: " + printed.at(k) +
                                       (printed[k] == type_name(machine.configuration)
                                            ? ""
                                            : " (a misprint)")}));
        }
        run.write("axes.svg", machine_axes_svg("Figure 3: linear and rotary axes"));
        run.write_result(table);
    });
}
