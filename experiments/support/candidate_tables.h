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

/// The solid angle in sr of the directions that the ranges of a candidate reach, overlaps
/// counted once. Source: [KangSuh, section 3].
double solid_angle(const SectorCandidate& sector);
double solid_angle(const RectangleCandidate& rectangle);  ///< see above

/// For each kind of candidate: `count`; the least and the largest area, `least_area_deg2`
/// and `largest_area_deg2`, and their ratio, `largest_over_least`; `solid_angle_over_least`,
/// the solid angle of the candidate of least area over the least solid angle;
/// `share_of_pairs`, for meridians through an edge their number over that of all pairs of
/// directions. For each set of directions and each hull `count`, the number of its
/// directions or vertices.
/// \param paper_count number of sectors, from the first, that the paper's algorithm
/// tries.
CsvTable candidate_summary(const DirectionSet& ca,
                           std::span<const SectorCandidate> sectors,
                           std::size_t paper_count, const DirectionSet& ab,
                           const std::vector<RectangleCandidate>& rectangles);

}  // namespace endmill
