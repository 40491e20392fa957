// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace endmill {

/// What a milling machine bears and reaches, as the cut sees it. A limit that is not given
/// does not bind.
struct MachineLimits {
    std::optional<double> max_rpm = {};                ///< of the spindle, above 0
    std::optional<double> max_power_w = {};            ///< of the spindle, above 0
    std::optional<double> max_torque_n_m = {};         ///< of the spindle, above 0
    std::optional<double> max_feed_mm_per_min = {};    ///< of the feed drives, above 0
    std::optional<double> acceleration_m_per_s2 = {};  ///< along the path, above 0

    /// Whether both say the same.
    friend bool operator==(const MachineLimits&, const MachineLimits&) = default;
};

/// \throws DomainError unless every number is finite and above 0.
void require_sound(const MachineLimits& machine);

}  // namespace endmill
