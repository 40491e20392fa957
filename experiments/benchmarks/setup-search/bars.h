// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/setup/setup.h"
#include "support/setup_cells.h"

namespace endmill {

/// A search and the longest time that it may take.
struct SearchBar {
    std::string name;  ///< label of the row
    Angle incidence;
    SetupRequest request;
    double at_most_s;
};

/// A machine of the family, without limits.
inline RotaryReach family_reach(const std::string& family)
{
    return {.configuration = configuration_of_family(family_of_word(family))};
}

/// The search over the tool axes at cells, without limits.
inline SearchBar nearest_cells_search(const std::string& family, const std::string& mode,
                                      double incidence_deg, double at_most_s)
{
    const auto incidence = std::to_string(std::lround(incidence_deg));
    return {mode + ", " + family + ", " + incidence,
            Angle::degrees(incidence_deg),
            {.reach = family_reach(family), .mode = mode_of_word(mode)},
            at_most_s};
}

/// The search over whole cones, without limits, until `gap` is proved.
inline SearchBar whole_cones_search(const std::string& family,
                                    const std::string& objective, double gap,
                                    double incidence_deg, double at_most_s)
{
    const auto incidence = std::to_string(std::lround(incidence_deg));
    const auto percent = std::to_string(std::lround(100 * gap));
    return {"set, " + objective + " to " + percent + " %, " + family + ", " + incidence,
            Angle::degrees(incidence_deg),
            {.reach = family_reach(family),
             .mode = SetupMode::WholeCones,
             .whole_cones = {.objective = objective_of_word(objective), .gap = gap}},
            at_most_s};
}

/// The bars for one core of a current server.
inline std::vector<SearchBar> search_bars()
{
    std::vector<SearchBar> all{nearest_cells_search("CA", "paper", 90, 0.08),
                               nearest_cells_search("AB", "paper", 90, 0.03),
                               nearest_cells_search("AB", "corrected", 90, 0.1),
                               nearest_cells_search("AB", "corrected", 80, 0.1),
                               nearest_cells_search("AB", "corrected", 60, 0.35)};
    for (const double incidence : {90, 80, 60})
        for (const std::string family : {"AB", "CA"}) {
            const double coarse_s = family == "AB" ? 1.5 : 5;
            all.push_back(
                whole_cones_search(family, "floored-area", 0.05, incidence, coarse_s));
            all.push_back(whole_cones_search(family, "floored-area", 0.02, incidence, 8));
            all.push_back(whole_cones_search(family, "total-range", 0.02, incidence, 8));
        }
    return all;
}

}  // namespace endmill
