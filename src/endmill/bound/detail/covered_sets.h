// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/bound/detail/raised_cells.h"

namespace endmill {

/// The boundary of the covered set D(x) of any contact on a part, by rays where D(x) has
/// one component on one surface, and by marching triangles elsewhere.
class CoveredSets {
public:
    /// \param part its surfaces must outlive this.
    /// \param problem must outlive this.
    CoveredSets(const BoundedPart& part, const BoundProblem& problem);

    /// The covered set of one contact.
    struct Set {
        ContactFrame frame;                  ///< of the contact
        std::vector<BoundaryFlow> boundary;  ///< all components inside the part
        std::vector<CoveredPiece> pieces;    ///< empty unless asked for
    };

    /// Whether `set_at` returns the pieces of the area too.
    enum class Want {
        Boundary,          ///< the boundary alone
        BoundaryAndPieces  ///< both
    };

    /// The covered set of a contact.
    /// \return nothing where the ball cannot touch.
    std::optional<Set> set_at(const ContactPlace& place, Want want) const;

private:
    BoundedPart part_;
    const BoundProblem& problem_;
    RaisedCells cells_;
};

}  // namespace endmill
