// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "endmill/files/csv.h"
#include "support/candidate_charts.h"

namespace endmill {

/// The candidate of least area, the first of equal ones. \pre there is one.
template <class Candidate>
const Candidate& least_area(const std::vector<Candidate>& candidates)
{
    return *std::ranges::min_element(
        candidates, {}, [](const Candidate& candidate) { return candidate.area(); });
}

/// Every sector, by `from_deg`: `from_deg`, `width_deg`, `polar_deg`, `opposite_polar_deg`,
/// `area_deg2`.
CsvTable sector_table(std::span<const SectorCandidate> sectors);

/// Every rectangle: `kind` "meridian through an edge" or "parallel through an edge"; then
/// `r1_azimuth_deg`, within [0, 180), the ends of both ranges and `area_deg2`; of each kind by
/// `r1_azimuth_deg`.
CsvTable rectangle_table(const Vec3& tool_axis,
                         std::vector<RectangleCandidate> rectangles);

/// For each kind of candidate how many there are, and the areas of the least and the largest;
/// for each hull its vertices. The first `paper_count` sectors are the paper's. Columns `row`, `count`, `least_area_deg2`, `largest_area_deg2`.
CsvTable candidate_summary(const DirectionSet& ca,
                           std::span<const SectorCandidate> sectors,
                           std::size_t paper_count, const DirectionSet& ab,
                           const std::vector<RectangleCandidate>& rectangles);

}  // namespace endmill
