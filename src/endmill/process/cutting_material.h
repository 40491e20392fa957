// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace endmill {

/// What a work material asks of the cutter: forces by chip and edge, and the speed that it
/// is cut at. Tangential force of an element of the edge of depth dz under a chip of
/// thickness t: K (t + h*) dz; radial K (r1 t + r2 h*) dz; axial K (r3 t + r4 h*) dz.
/// Source: [ParkMaeng, eq. (1), (4)] as corrected in spec of ball-end milling, section 2;
/// in the notation of K_tc, K_te, ...: K = K_tc, h* = K_te/K_tc, r1 = K_rc/K_tc,
/// r2 = K_re/K_te, r3 = K_ac/K_tc, r4 = K_ae/K_te.
struct CuttingMaterial {
    double specific_resistance_n_per_mm2;  ///< K, above 0
    double edge_thickness_mm;              ///< h*, from 0
    double r1;            ///< radial over tangential force of the chip, from 0
    double r2;            ///< radial over tangential force of the edge, from 0
    double r3;            ///< axial over tangential force of the chip, from 0
    double r4;            ///< axial over tangential force of the edge, from 0
    double alpha;         ///< exponent of the tool life, between 0 and 1
    double v1_m_per_min;  ///< economic speed of a full half turn of engagement, above 0
    std::optional<double> max_feed_per_tooth_mm = {};  ///< the cap, above 0
    std::optional<double> min_feed_per_tooth_mm = {};  ///< above 0, at most the cap
    std::string name = {};
    std::string source = {};  ///< origin of the numbers
};

/// \throws DomainError unless every number is finite and as said above.
void require_sound(const CuttingMaterial& material);

}  // namespace endmill
