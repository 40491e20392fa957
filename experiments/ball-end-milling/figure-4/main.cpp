// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 4 of Park & Maeng: the tool-life equation, fitted again to the printed data and
// also computed from the printed exponent.
//
//   ball-end-milling-figure-4 OUTPUT_FOLDER
//
// Deterministic, under 0.1 s. Columns and verdicts: README.md beside this.

#include <cmath>

#include "endmill/core/text.h"
#include "endmill/files/input_csv.h"
#include "endmill/process/tool_life.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

// Engaged angle for the width of cut a_e of a cutter of diameter D: cos phi = 1 - 2 a_e /
// D.
void add_data(CsvTable& result, const std::vector<CuttingSpeedDatum>& data,
              const std::vector<double>& widths, double printed_pi)
{
    for (std::size_t i = 0; i < data.size(); ++i) {
        const double phi_over_pi = std::acos(1 - 2 * widths.at(i)) / printed_pi;
        add_named(result, "datum " + std::to_string(i + 1),
                  {{"v_m_per_min", data[i].v_m_per_min},
                   {"width_over_diameter", widths[i]},
                   {"phi_deg", 180 * phi_over_pi},
                   {"phi_over_pi", phi_over_pi},
                   {"ln_phi_over_pi", std::log(phi_over_pi)}});
    }
}

void add_line(CsvTable& result, const std::string& row, const SpeedLine& line,
              const ToolCosts& costs)
{
    const double life = economic_tool_life(line.alpha, costs);
    add_named(result, row,
              {{"alpha", line.alpha},
               {"t0_min", life},
               {"cb", tool_life_constant(line, life)},
               {"v1_m_per_min", line.v1_m_per_min}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-4", [](Experiment& run) {
        const auto data = read_cutting_speeds(run.text("data"));
        const ToolCosts costs{run.number("tool_change_min"), run.number("tool_cost"),
                              run.number("machine_cost_per_min")};
        CsvTable result{{"row", "v_m_per_min", "width_over_diameter", "phi_deg",
                         "phi_over_pi", "ln_phi_over_pi", "alpha", "t0_min", "cb",
                         "v1_m_per_min"}};
        add_data(result, data, run.numbers("widths_over_diameter"),
                 run.number("printed_pi"));
        add_line(result, "refit", fitted_speed_line(data), costs);
        add_line(result, "printed exponent",
                 fitted_speed_line(data, run.number("printed_alpha")), costs);
        run.write_result(result);
        CsvTable curve{{"row", "phi_over_pi", "v_m_per_min", "what"}};
        const SpeedLine line = fitted_speed_line(data);
        for (int i = 2; i <= 20; ++i)
            curve.add_row({std::to_string(i), 0.05 * i, economic_speed(line, 0.05 * i),
                           "line of least squares"});
        for (const CuttingSpeedDatum& datum : data)
            curve.add_row({"datum", datum.phi_over_pi, datum.v_m_per_min, "data"});
        run.write("speeds.csv", curve.text());
    });
}
