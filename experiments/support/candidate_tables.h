// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "endmill/files/csv.h"
#include "support/candidate_charts.h"

namespace endmill {

/// The candidate of least area, the first one of equal candidates. \pre there is one.
template <class Candidate>
const Candidate& least_area(const std::vector<Candidate>& candidates)
{
    return *std::ranges::min_element(
        candidates, {}, [](const Candidate& candidate) { return candidate.area(); });
}

/// All sectors in ascending order of `from_deg`: `from_deg`, `width_deg`, `polar_deg`,
/// `opposite_polar_deg`, `area_deg2`.
CsvTable sector_table(std::span<const SectorCandidate> sectors);

/// All rectangles: `kind` "meridian through an edge" or "parallel through an edge";
/// `r1_azimuth_deg` within [0, 180), the ends of both ranges and `area_deg2`. In
/// ascending order of `r1_azimuth_deg` for each kind.
CsvTable rectangle_table(const Vec3& tool_axis,
                         std::vector<RectangleCandidate> rectangles);

/// For each kind of candidate its number and the least and the largest area; for each
/// hull the number of its vertices. Columns `row`, `count`, `least_area_deg2`,
/// `largest_area_deg2`.
/// \param paper_count number of sectors, from the first, that the paper's algorithm
/// tries.
CsvTable candidate_summary(const DirectionSet& ca,
                           std::span<const SectorCandidate> sectors,
                           std::size_t paper_count, const DirectionSet& ab,
                           const std::vector<RectangleCandidate>& rectangles);

}  // namespace endmill
