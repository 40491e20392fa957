// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/orientation/detail/contact_cones.h"
#include "endmill/orientation/detail/oriented_part.h"
#include "endmill/orientation/detail/tool_clearance.h"

namespace endmill {

/// The rows of a pass.
struct PassRows {
    std::size_t surface;         ///< number of the surface, from 0; 0 on a mesh
    PassLine line;               ///< where the pass runs
    std::vector<PassPose> rows;  ///< in the order of cutting
};

/// The tool and the part of a field.
struct FieldTask {
    std::span<const OrientedPart* const> parts;  ///< the surfaces, or the mesh
    const ToolClearance& clearance;              ///< of the whole part
    const Cutter& cutter;                        ///< of the tool
    const OrientedOptions& options;              ///< of the path
    const ContactCones* cones =
        nullptr;  ///< of the whole part; null: visibility is no rule
};

/// Gives the rows of all passes the axes of a field over the whole path, and inserts rows until
/// the motion between them keeps its tolerances and is clear of the part halfway.
/// \param passes in the order of cutting, with the inclinations that are wanted.
/// \return the least gap between cutter and part at all rows, in mm, at most the radius.
/// \throws GeometryError as axis_field, and if no axis is allowed between two rows.
double turn_by_field(const FieldTask& task, std::vector<PassRows>& passes);

}  // namespace endmill
