// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cli/setup_input.h"
#include "endmill/files/visibility_file.h"
#include "endmill/setup/setup.h"
#include "endmill/setup/several_setups.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The visibility cones of the facets, for which setups are searched.
struct SetupVisibility {
    StoredVisibility file;  ///< the visibility and the part, grid and tool it belongs to
    /// The cones without those of facets that need not be accessible, if there are any.
    std::optional<PartVisibility> without_skipped = {};
    std::vector<std::size_t> empty;  ///< facets that no direction reaches
    double seconds = 0;              ///< wall time

    /// The cones for which setups are searched.
    const PartVisibility& searched() const
    {
        return without_skipped ? *without_skipped : file.visibility;
    }
    const VisibilityMap& map() const
    {
        return searched().map;
    }  ///< one column for each cell
};

/// A facet that no direction reaches.
struct HiddenFacet {
    std::size_t facet;              ///< number of the facet
    std::optional<std::size_t> by;  ///< facet that hides it along its normal, if any
};

/// Why one setup does not reach the whole part.
struct MissedFacets {
    std::vector<std::size_t> facets;  ///< those that the best single setup misses
    double area_share;  ///< of these facets in the area of the part, 0 … 1
    std::vector<HiddenFacet> hidden;  ///< the first ones that no direction reaches
};

/// The result for one machine.
struct SetupAnswer {
    const SearchedMachine* machine;  ///< points into the input, which outlives the answer
    MachineSetup setup;              ///< of the part on this machine
    std::optional<SetupCover> setups = {};    ///< with --max-setups above 1
    std::optional<MissedFacets> missed = {};  ///< as `missed_facets`
    double seconds = 0;                       ///< wall time of the search

    /// The reported pose: the best one within the limits, or else the unconstrained one.
    const std::optional<FittedPose>& reported() const { return setup.best.shown(); }
};

/// The visibility of the part, read from --from-visibility or computed. It shows
/// progress.
/// \throws FormatError, LimitError as `read_visibility`; DomainError if the file
///         belongs to another tool.
SetupVisibility visibility_for(const SetupInput& input,
                               const SetupCommandOptions& options);

/// The best setup of the part on the machine.
SetupAnswer answer_for(const SearchedMachine& machine, const SetupInput& input,
                       const SetupVisibility& visibility,
                       const SetupCommandOptions& options);

/// The facets that the best single setup within the limits misses. This setup is the
/// first one of `greedy_setups`, which tries the centres of cells as tool axes.
/// \return nothing unless the answer is no and the machine is valid.
std::optional<MissedFacets> missed_facets(const SetupAnswer& answer,
                                          const SetupInput& input,
                                          const SetupVisibility& visibility,
                                          const SetupCommandOptions& options);

}  // namespace endmill
