// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "economic-cl-data/other-surfaces/surface_study.h"
#include "endmill/files/csv.h"

namespace endmill {

/// A surface with its study.
struct NamedStudy {
    std::string name;
    double ball_mm;  ///< diameter of the middle ball
    SurfaceStudy study;
};

/// The empty table of the studies.
CsvTable study_table();

/// Adds the row of one surface.
void add_study(CsvTable& table, const NamedStudy& named);

/// Adds the rows that count surfaces of `studies` with a property.
void add_counts(CsvTable& table, const std::vector<NamedStudy>& studies);

/// Adds the printed travel of the paper's example, as a multiple of the travel over a plane of the same
/// width and depth with the same ball and tolerances.
void add_travel_against_plane(CsvTable& table, const Surface& plane);

}  // namespace endmill
