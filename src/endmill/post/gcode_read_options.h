// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/post/text_lines.h"

namespace endmill {

/// How a machine program is read, and what is accepted before the reader gives up.
struct GcodeReadOptions {
    double arc_tolerance_mm = 0.001;  ///< largest distance of an arc's chords from it
    bool block_delete = false;        ///< whether blocks that begin with / are left out
    double programmed_point_height_mm = 0;  ///< above the tip: the corner radius, if the
                                            ///< centre is programmed
    double max_extent_mm = 1e6;             ///< largest magnitude of a coordinate
    std::size_t most_points = 10'000'000;   ///< of the path; see `points_within`
};

/// How many points a program may have that is read in `memory_gib` GiB.
/// \pre memory_gib >= 0
std::size_t points_within(double memory_gib);

/// \throws DomainError unless the tolerance and the extent are positive and the height of
///         the programmed point is at least 0, all of them finite.
void check_options(const GcodeReadOptions& options);

/// \throws FormatError E_RANGE at the line where `lines` stands if |coordinate| is beyond
///         the largest extent.
void check_extent(double coordinate_mm, const GcodeReadOptions& options,
                  const TextLines& lines);

}  // namespace endmill
