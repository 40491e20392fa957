// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/tool_life.h"
#include "support/named_cells.h"

namespace endmill {

/// The data of figure 4 as they are printed, and what it costs to change a tool.
struct PrintedSpeeds {
    std::vector<CuttingSpeedDatum> data;  ///< phi/pi and V
    std::vector<double> phi_deg;          ///< the printed angles, degrees
    std::vector<double> ln_phi_over_pi;   ///< the printed logarithms
    std::vector<double> ln_v;             ///< the printed logarithms
    ToolCosts costs;
};

/// Columns of the result.
std::vector<std::string> tool_life_columns();

/// Rows "datum 1" to "datum 4". phi_deg is computed from the width of cut a_e of a cutter
/// of diameter D, cos phi = 1 - 2 a_e / D; phi_over_pi and ln_phi_over_pi from the
/// printed angle.
/// \param widths a_e / D of each datum. \param printed_pi the pi of the print.
void add_data(CsvTable& result, const PrintedSpeeds& printed,
              const std::vector<double>& widths, double printed_pi);

/// One row for a line: alpha, t0_min, cb, v1_m_per_min, and its largest difference from
/// the data in percent.
void add_line(CsvTable& result, const std::string& row, const PrintedSpeeds& printed,
              const SpeedLine& line);

/// Eq. (5) with the constant `cb` held fixed. v_tg_m_per_min takes the life of least cost
/// as T_g = phi/pi T0, as eq. (5) prints it: one speed for every angle. v_t0_m_per_min
/// takes it as T0, as figure 4 prints it.
void add_printed_eq_5(CsvTable& result, const PrintedSpeeds& printed, double cb,
                      double alpha);

/// Economic speed at a half turn when the tool costs twice as much: with C_b = V1
/// T0^alpha, which follows the costs as in figure 4, and with C_b held fixed.
void add_costs(CsvTable& result, const ToolCosts& costs, double cb, double alpha);

}  // namespace endmill
