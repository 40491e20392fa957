// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// Levels of a patch: it is divided into 2^u by 2^v cells.
struct PatchLevels {
    int u;  ///< along u
    int v;  ///< along v
};

/// How finely the patches of a surface, and the sides between them, are sampled. A side
/// has as many parts as the finer one of the patches that share it.
class SamplingLevels {
public:
    /// Chooses for each patch the levels, at most 20, with the fewest cells whose chord
    /// error is within `chord_tolerance` mm according to `bend_bounds`.
    /// \throws LimitError if level 20 is not enough.
    SamplingLevels(const Surface& surface, double chord_tolerance);

    /// Levels of the patch in column i and row j.
    const PatchLevels& patch(int i, int j) const { return patches_[j * columns_ + i]; }

    /// Level of the side along `along` that starts at the corner (i, j) of the patches.
    int side(Parameter along, int i, int j) const;

    /// Raises the level of that side to at least `level`.
    void raise_side(Parameter along, int i, int j, int level);

    /// Approximate number of triangles, never too small.
    double triangles() const;

    /// Bound of the chord error in mm over all patches.
    double chord_error_mm() const { return chord_error_mm_; }

private:
    int& side_level(Parameter along, int i, int j);

    int columns_;
    int rows_;
    std::vector<PatchLevels> patches_;
    std::vector<int> along_u_;  // sides at [j * columns + i], in rows + 1 rows
    std::vector<int> along_v_;  // sides at [j * (columns + 1) + i]
    double chord_error_mm_ = 0;
};

/// Raises the levels of sides that meet, within one surface or between two, to the higher
/// one.
/// \return whether any sides meet.
bool match_meeting_sides(std::span<const Surface> surfaces,
                         std::span<SamplingLevels> levels);

/// The surface, divided along the lines u or v = constant on which it has a gap.
std::vector<Surface> parted_at_gaps(const Surface& surface);

/// Greatest distance in mm between 4 by 4 places of a cell and its two triangles, at
/// equal parameters. The diagonal of the cell runs from `low` to `high`.
double grid_cell_error(const Surface& surface, const SurfacePoint& low,
                       const SurfacePoint& high);

}  // namespace endmill
