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

/// The cones that setups are searched for.
struct SetupVisibility {
    StoredVisibility file;           ///< with what it was computed for
    std::vector<std::size_t> empty;  ///< facets that nothing reaches
    double seconds = 0;              ///< wall time

    const VisibilityMap& map() const { return file.visibility.map; }  ///< a column a cell
};

/// What is found for one machine.
struct SetupAnswer {
    const SetupMachine* machine;  ///< of the input, which outlives it
    PartSetup best;
    double seconds = 0;                                   ///< wall time of the search
    std::optional<Eigen::Matrix3d> part_to_machine = {};  ///< none without a pose
    std::optional<SetupCover> setups = {};                ///< with --max-setups above 1
    std::optional<SetupTravel> travel = {};  ///< none without a feasible pose or machine

    /// The pose that is told: the best within the limits, or the unconstrained one.
    const std::optional<FittedPose>& told() const { return best.shown(); }
    bool is_out_of_reach = false;  ///< a facet has no cell within the limits at that pose

    /// Whether the linear axes go far enough; nothing where they are not limited, or there is
    /// no pose.
    std::optional<bool> is_travel_ok() const;

    /// (w + floor)(h + floor) of the pose that is told, with h = 0 of four axes and w = 0 of
    /// three; nothing without a pose.
    std::optional<double> floored_area_deg2(double floor_deg) const;

    bool is_yes() const;  ///< machinable, and within the travel where that is limited
};

/// The visibility of the part: of --from-visibility, or computed, with progress.
/// \throws FormatError, LimitError as `read_visibility`; DomainError if the file is for another
///         tool.
SetupVisibility visibility_for(const SetupInput& input,
                               const SetupCommandOptions& options);

/// The best setup of the part on the machine.
SetupAnswer answer_for(const SetupMachine& machine, const SetupInput& input,
                       const SetupVisibility& visibility,
                       const SetupCommandOptions& options);

/// Which of two answers comes first: that of the lower `setup_rank`, then of the lower name.
bool ranks_before(const SetupAnswer& one, const SetupAnswer& other,
                  const SetupCommandOptions& options);

}  // namespace endmill
