// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/offset/offset_mesh.h"

namespace endmill {

/// How a surface of the datasets is offset and sliced.
struct SectionPlan {
    std::string surface;  ///< its name there
    Cutter cutter;
    double direction_deg = 0;  ///< of the feed, from +x
    int grid_lines = 200;      ///< along each parameter
    int planes = 100;          ///< by the rule of `drive_planes`, over the whole part
    BoundaryContact boundary = BoundaryContact::None;  ///< the paper's form
};

/// An offset and its sections.
struct OffsetSections {
    OffsetMesh offset;
    DrivePlanes planes;
    std::vector<PlaneSection> sections;  ///< one a plane
};

/// The offset and the sections that `plan` asks for.
/// \throws FormatError if there is no such surface; GeometryError and DomainError as
/// `offset_mesh` and `drive_planes`.
OffsetSections offset_sections(const SectionPlan& plan);

/// `count` planes over the extent of the surface of `plan`, for other numbers of planes.
DrivePlanes planes_over(const SectionPlan& plan, int count);

}  // namespace endmill
