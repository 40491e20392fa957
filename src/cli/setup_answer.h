// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cli/setup_input.h"
#include "endmill/files/visibility_file.h"
#include "endmill/setup/setup.h"
#include "endmill/setup/setup_travel.h"
#include "endmill/setup/several_setups.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The visibility cones of the facets, for which setups are searched.
struct SetupVisibility {
    StoredVisibility file;  ///< the visibility and the part, grid and tool it belongs to
    std::vector<std::size_t> empty;  ///< facets that no direction reaches
    double seconds = 0;              ///< wall time

    const VisibilityMap& map() const
    {
        return file.visibility.map;
    }  ///< one column for each cell
};

/// The result for one machine.
struct SetupAnswer {
    const SetupMachine* machine;  ///< points into the input, which outlives the answer
    PartSetup best;
    double seconds = 0;                                   ///< wall time of the search
    std::optional<Eigen::Matrix3d> part_to_machine = {};  ///< none without a pose
    std::optional<SetupCover> setups = {};                ///< with --max-setups above 1
    std::optional<SetupTravel> travel = {};  ///< none without a feasible pose or machine

    /// The reported pose: the best one within the limits, or else the unconstrained one.
    const std::optional<FittedPose>& told() const { return best.shown(); }
    bool is_out_of_reach = false;  ///< at the pose a facet has no cell within the limits

    /// Whether the travel of the linear axes suffices. Empty if they have no limits or
    /// there is no pose.
    std::optional<bool> is_travel_ok() const;

    /// The floored area (w + floor)(h + floor) of the reported pose. h is 0 with four
    /// axes; w and h are 0 with three. Empty without a pose.
    std::optional<double> floored_area_deg2(double floor_deg) const;

    bool is_yes() const;  ///< machinable, and within the travel if it has limits
};

/// The visibility of the part, read from --from-visibility or computed. It shows
/// progress.
/// \throws FormatError, LimitError as `read_visibility`; DomainError if the file
///         belongs to another tool.
SetupVisibility visibility_for(const SetupInput& input,
                               const SetupCommandOptions& options);

/// The best setup of the part on the machine.
SetupAnswer answer_for(const SetupMachine& machine, const SetupInput& input,
                       const SetupVisibility& visibility,
                       const SetupCommandOptions& options);

/// Whether `one` precedes `other`, by `setup_rank` and then by the name of the file.
bool ranks_before(const SetupAnswer& one, const SetupAnswer& other,
                  const SetupCommandOptions& options);

}  // namespace endmill
