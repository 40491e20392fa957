// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Tool life: fit of the economic cutting speed, life of least cost, spindle speed.

#include <span>

namespace endmill {

/// A recommended cutting speed for an engaged angle phi.
struct CuttingSpeedDatum {
    double phi_over_pi;  ///< engaged angle over pi, above 0, at most 1
    double v_m_per_min;  ///< m/min, above 0

    /// Whether both data are equal.
    friend bool operator==(const CuttingSpeedDatum&, const CuttingSpeedDatum&) = default;
};

/// Economic cutting speed as a function of the engaged angle: V = V1 (phi/pi)^(-alpha).
struct SpeedLine {
    double alpha;         ///< exponent, also that of the tool life; between 0 and 1
    double v1_m_per_min;  ///< m/min, V1: speed at an engaged angle of pi, above 0
};

/// Checks the ranges that SpeedLine states.
/// \throws DomainError if a number is outside its range or not finite.
void require_sound(const SpeedLine& line);

/// Least-squares line of ln V on ln(phi/pi).
/// Source: [ParkMaeng, fig. 4]; docs/methods/ball-end-milling.md, section 5.
/// \throws DomainError unless there are two different angles and all data are in their
///         ranges.
/// \throws GeometryError unless the fitted alpha is between 0 and 1.
/// Relative error below 1e-13 where the angles span a factor of 2.
SpeedLine fitted_speed_line(std::span<const CuttingSpeedDatum> data);

/// Least-squares line with a given slope: V1 = exp(mean ln V + alpha mean ln(phi/pi)).
/// \throws DomainError unless there is a datum, all data are in their ranges, and
///         0 < alpha < 1.
/// \throws GeometryError if V1 underflows to 0.
SpeedLine fitted_speed_line(std::span<const CuttingSpeedDatum> data, double alpha);

/// Costs of a worn tool, in any single currency.
struct ToolCosts {
    double change_min;       ///< min, t_ct: time of a tool change, at least 0
    double tool;             ///< C_t: cost of a tool or of its regrinding, at least 0
    double machine_per_min;  ///< M: cost of machine and operator per minute, above 0
};

/// Tool life T0 of least cost per part, in min: (1/alpha - 1)(t_ct + C_t/M).
/// Source: [ParkMaeng, eq. (5)], corrected as in docs/methods/ball-end-milling.md,
/// section 5.
/// \throws DomainError unless 0 < alpha < 1, the costs are in their ranges, and a tool
///         change costs time or money.
double economic_tool_life(double alpha, const ToolCosts& costs);

/// Constant C_b of the tool-life equation V (phi/pi T0)^alpha = C_b, for which `line` is
/// the economic speed at the given tool life: V1 T0^alpha, in m/min min^alpha.
/// Source: [ParkMaeng, eq. (4)], fig. 4; docs/methods/ball-end-milling.md, section 5.
/// \throws DomainError unless 0 < alpha < 1, 0 < V1 and 0 < tool life.
double tool_life_constant(const SpeedLine& line, double tool_life_min);

/// Economic cutting speed V in m/min.
/// \throws DomainError unless 0 < phi_over_pi <= 1 and the line is sound.
double economic_speed(const SpeedLine& line, double phi_over_pi);

/// Spindle speed in rpm at which the widest circle of a cutter has a given cutting speed.
/// Source: [ParkMaeng, eq. (18)]: n = 1000 V / (2 pi r0), with the factor 1000 that is
/// missing in print.
/// \param v_m_per_min V in m/min, above 0.
/// \param radius_mm r0 in mm, above 0.
/// \throws DomainError unless both are above 0 and finite.
double spindle_speed_rpm(double v_m_per_min, double radius_mm);

}  // namespace endmill
