// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/setup/detail/cone_set.h"
#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The minimal cones of a part: those that contain no other cone. They are numbered by
/// size, smallest first.
class MinimalCones {
public:
    /// For the time see `least_cones`. Empty cones are left out.
    /// \param map cones over the cells of `grid`.
    MinimalCones(const SphereGrid& grid, const VisibilityMap& map);

    std::size_t size() const { return minimal_.size(); }  ///< number of cones

    /// Cells that lie in at least one cone, ascending.
    std::span<const std::size_t> cells() const { return cells_; }

    /// The cones with these numbers, over all of cells().
    ConeSet selected(std::span<const std::size_t> numbers) const;

    /// Adds the cone with this number to a set made by `selected`.
    void add(ConeSet& set, std::size_t number) const { set.add(all_, minimal_[number]); }

    /// Numbers of the cones that hold none of these cells, ascending. If some of them are
    /// farther than one and a half cells from these cells, only those. Distant cones
    /// change a range most.
    /// \param reached indices into cells(). \return nothing if all cones are met.
    std::vector<std::size_t> missed(std::span<const std::uint32_t> reached) const;

private:
    // Clears the bits of the cones that hold one of these cells, indices into cells_.
    void clear_met(std::span<std::uint64_t> cones,
                   std::span<const std::uint32_t> cells) const;

    DistinctCones all_;
    std::vector<std::size_t> minimal_;  // numbers of the minimal cones in all_
    VisibilityMap columns_;             // the minimal cones as columns of bits
    // A column with the bits of all minimal cones: those missed before any cell is reached.
    std::vector<std::uint64_t> all_missed_;
    std::vector<std::size_t> cells_;
    // By index of a cell: those of the cells within one and a half cells of it.
    std::vector<std::vector<std::uint32_t>> nearby_;
};

}  // namespace endmill
