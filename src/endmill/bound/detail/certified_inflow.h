// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/bound/detail/enclosure_grid.h"

namespace endmill {

/// A box of contacts in one patch.
struct ContactBox {
    ContactPlace middle;  ///< of the box
    ParameterBox box;     ///< parameters
};

/// What is certain about all contacts of a box.
struct CertifiedInflow {
    /// Whether there is a bound.
    enum class Kind {
        Bounded,    ///< the inflow at all contacts is at most `inflow`
        NoContact,  ///< the ball touches at none of these places
        Unknown     ///< the covered sets could not be enclosed
    };
    Kind kind;
    double inflow = 0;  ///< upper bound of the inflow over all contacts and directions
    double disc = 0;    ///< upper bound of the integral of g over a covered set, mm
    bool is_wide_in_u = true;  ///< whether the box is better divided in u than in v
    std::vector<std::uint32_t>
        cells;                ///< nodes of cells that the boundaries may meet, or,
                              ///< if unknown, that the sets may meet
    std::string_view reason;  ///< why it is unknown
};

/// Encloses the covered sets of all contacts of a box, and so bounds their inflow. The proof
/// is in docs/methods/path-length-bound.md, section 7.
/// \param part surfaces and sides.
/// \param problem the tool.
/// \param grid of the density.
/// \param density g at the nodes, 1/mm.
/// \param enclosures of the raised surfaces with the same density.
/// \param contacts the box.
CertifiedInflow certified_inflow(const BoundedPart& part, const BoundProblem& problem,
                                 const DensityGrid& grid, std::span<const double> density,
                                 const EnclosureGrid& enclosures,
                                 const ContactBox& contacts);

}  // namespace endmill
