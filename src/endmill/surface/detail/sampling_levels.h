// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// A patch is cut into 2^u by 2^v cells.
struct PatchLevels {
    int u;
    int v;
};

/// How finely the patches of a surface, and the sides between them, are sampled. A side
/// has as many parts as the finer of the patches that share it.
class SamplingLevels {
public:
    /// The levels, at most 20 each, with the fewest cells a patch that keep the chord
    /// error within `chord_tolerance` mm by `bend_bounds`.
    /// \throws LimitError if level 20 is not enough.
    SamplingLevels(const Surface& surface, double chord_tolerance);

    /// Levels of the patch in column i and row j.
    const PatchLevels& patch(int i, int j) const { return patches_[j * columns_ + i]; }

    /// Level of the side along `along` from the corner of patches (i, j).
    int side(Parameter along, int i, int j) const;

    /// Raises the level of that side to at least `level`.
    void raise_side(Parameter along, int i, int j, int level);

    /// Rough number of triangles.
    double triangles() const;

    /// The bound on the chord error in mm, over all patches.
    double chord_error_mm() const { return chord_error_mm_; }

private:
    int& side_level(Parameter along, int i, int j);

    int columns_;
    int rows_;
    std::vector<PatchLevels> patches_;
    std::vector<int> along_u_;  // [j * columns + i], rows + 1 of them
    std::vector<int> along_v_;  // [j * (columns + 1) + i]
    double chord_error_mm_ = 0;
};

/// Raises the levels of sides that meet, of one surface or two, to the greater of them.
/// \return whether any meet.
bool match_meeting_sides(std::span<const Surface> surfaces,
                         std::span<SamplingLevels> levels);

/// `surface` cut along the lines u or v = constant on which it has a gap.
std::vector<Surface> parted_at_gaps(const Surface& surface);

/// Greatest distance in mm of 4 by 4 places of the cell from its two triangles, at equal
/// parameters; the diagonal runs from `low` to `high`.
double grid_cell_error(const Surface& surface, const SurfacePoint& low,
                       const SurfacePoint& high);

}  // namespace endmill
