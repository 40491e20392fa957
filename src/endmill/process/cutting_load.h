// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/process/cutting_material.h"

namespace endmill {

/// What the engaged edges of a cutter add up to, all flutes together, without material and
/// size: the spec's A, B, A_T, B_T, or m R_m times I5, I6, I7, I8. None is negative.
struct EdgeSums {
    double chip = 0;         ///< of the chip term of tangential force, over K f_t r0
    double edge = 0;         ///< of the edge term, over K h* r0
    double chip_torque = 0;  ///< of the chip term of torque, over K f_t r0^2
    double edge_torque = 0;  ///< of the edge term, over K h* r0^2
};

/// The sums, each times `factor`: of m teeth, or a peak R_m above the mean.
EdgeSums scaled(const EdgeSums& sums, double factor);

/// Which form of a limit holds where the paper's differs from the exact one.
enum class LimitForm {
    Paper,  ///< force: the tangential one times sqrt(1 + r1^2), exact if r2 = r1; power
            ///< with 974000 kgf mm rpm/kW
    Exact,  ///< force: the root of the squares; power 2 pi n M / 60
};

/// What turns sums into forces.
struct LoadModel {
    CuttingMaterial material;
    double radius;  ///< r0 of the ball, mm
    LimitForm form = LimitForm::Exact;
};

/// What the cutter bears at one time.
struct CuttingLoads {
    double cutting_force_n = 0;  ///< across the axis
    double thrust_n = 0;         ///< along the axis
    double torque_n_m = 0;       ///< about the axis
};

/// The most that may be borne; what is not given does not bind.
struct LoadLimits {
    std::optional<double> cutting_force_n = {};  ///< N, above 0
    std::optional<double> thrust_n = {};         ///< N, above 0
    std::optional<double> torque_n_m = {};       ///< N m, above 0
};

/// Feed per tooth in mm at which each limit is reached; none where the limit does not bind,
/// 0 where the edges alone exceed it.
struct FeedBounds {
    std::optional<double> cutting_force = {};
    std::optional<double> thrust = {};
    std::optional<double> torque = {};
};

/// The loads at a feed per tooth.
/// Source: [ParkMaeng, eq. (15) to (17)] as corrected in spec of ball-end milling,
/// sections 2 and 6.
/// \pre The model is sound, the sums and the feed are not negative; not checked.
/// Relative error below 1e-15.
CuttingLoads cutting_loads(const LoadModel& model, const EdgeSums& sums,
                           double feed_per_tooth_mm);

/// The feeds at which `cutting_loads` reaches `limits`. Source: as there.
/// \pre As there, and limits are above 0; not checked.
/// Relative error below 1e-13 where the edges alone take less than 99 % of a limit.
FeedBounds feed_bounds(const LoadModel& model, const EdgeSums& sums,
                       const LoadLimits& limits);

/// Power in W that a torque takes at a speed of the spindle. Source: [ParkMaeng, eq. (19)].
/// In the paper's form 1 kW is 974000 kgf mm rpm, 0.025 % above the exact 973757.2551.
double cutting_power_w(LimitForm form, double torque_n_m, double spindle_rpm);

/// r0*, the radius in mm at which the tangential force has the torque that there is; none
/// without force. Source: [ParkMaeng, section 2] as corrected in spec of ball-end milling,
/// section 4: r0 (f_t I7 + h* I8) / (f_t I5 + h* I6).
std::optional<double> equivalent_radius(const LoadModel& model, const EdgeSums& sums,
                                        double feed_per_tooth_mm);

}  // namespace endmill
