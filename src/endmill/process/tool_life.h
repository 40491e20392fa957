// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace endmill {

/// A recommended cutting speed.
struct CuttingSpeedDatum {
    double phi_over_pi;  ///< engaged angle over a half turn, above 0, at most 1
    double v_m_per_min;  ///< above 0

    /// Whether both say the same.
    friend bool operator==(const CuttingSpeedDatum&, const CuttingSpeedDatum&) = default;
};

/// The economic cutting speed against the engaged angle: V = V1 (phi/pi)^(-alpha).
struct SpeedLine {
    double alpha;         ///< also the exponent of the tool life, between 0 and 1
    double v1_m_per_min;  ///< at an engaged angle of a half turn, above 0
};

/// \throws DomainError unless both numbers are finite and as said.
void require_sound(const SpeedLine& line);

/// The line of least squares of ln V on ln(phi/pi).
/// Source: [ParkMaeng, fig. 4]; spec of ball-end milling, section 5.
/// \throws DomainError unless there are two different angles and all data are as said;
///         GeometryError unless the slope makes an alpha between 0 and 1.
/// Relative error below 1e-13 where the angles span a factor of 2.
SpeedLine fitted_speed_line(std::span<const CuttingSpeedDatum> data);

/// The same with a given slope: V1 = exp(mean ln V + alpha mean ln(phi/pi)).
/// \throws DomainError unless there is a datum, all are as said, and 0 < alpha < 1;
///         GeometryError if V1 is too small for a number.
SpeedLine fitted_speed_line(std::span<const CuttingSpeedDatum> data, double alpha);

/// What a worn tool costs, in any one currency.
struct ToolCosts {
    double change_min;       ///< t_ct, time to change the tool, min, from 0
    double tool;             ///< C_t, to buy or regrind it, from 0
    double machine_per_min;  ///< M, of machine and operator, above 0
};

/// The tool life T0 of least cost a part, in min: (1/alpha - 1)(t_ct + C_t/M).
/// Source: [ParkMaeng, eq. (5)] as corrected in spec of ball-end milling, section 5.
/// \throws DomainError unless 0 < alpha < 1, the costs are as said, and a change costs
///         anything at all.
double economic_tool_life(double alpha, const ToolCosts& costs);

/// The constant C_b of the tool life equation V (phi/pi T0)^alpha = C_b for which `line`
/// is the economic speed at a life of `tool_life_min`: V1 T0^alpha, in m/min min^alpha.
/// Source: [ParkMaeng, eq. (4)], fig. 4: the program set C_b so.
/// \throws DomainError unless 0 < alpha < 1, 0 < V1 and 0 < tool life.
double tool_life_constant(const SpeedLine& line, double tool_life_min);

/// V in m/min. \throws DomainError unless 0 < phi_over_pi <= 1 and the line is as said.
double economic_speed(const SpeedLine& line, double phi_over_pi);

/// Speed of the spindle in rpm at which the widest circle of a cutter runs at a speed.
/// Source: [ParkMaeng, eq. (18)], n = 1000 V / (2 pi r0), with the 1000 that the print
/// leaves out.
/// \throws DomainError unless both are above 0 and finite. \param radius_mm r0.
double spindle_speed_rpm(double v_m_per_min, double radius_mm);

}  // namespace endmill
