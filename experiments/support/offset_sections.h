// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/offset/offset_mesh.h"
#include "endmill/trimming/trimming_methods.h"

namespace endmill {

/// The offset of a surface of the datasets and its sections.
struct SectionPlan {
    std::string surface;  ///< name of the file in datasets/surfaces
    Cutter cutter;
    double direction_deg = 0;  ///< direction of the feed, from +x
    int grid_lines = 200;      ///< contacts along each parameter
    int planes = 100;  ///< number of planes over the part, placed as by `drive_planes`
    BoundaryContact boundary = BoundaryContact::None;  ///< as in the paper
};

/// An offset and its sections.
struct OffsetSections {
    OffsetMesh offset;
    DrivePlanes planes;
    std::vector<PlaneSection> sections;  ///< one for each plane
};

/// Computes the offset and its sections.
/// \throws FormatError if there is no such surface; GeometryError and DomainError as
/// `offset_mesh` and `drive_planes`.
OffsetSections offset_sections(const SectionPlan& plan);

/// `count` drive planes over the surface of `plan`, for other numbers of planes.
DrivePlanes planes_over(const SectionPlan& plan, int count);

/// The curves of one plane in space, mm.
using PlaneLines = std::vector<std::vector<Vec3>>;

/// The curves of `sections` in space, one list for each plane.
std::vector<PlaneLines> untrimmed_lines(const DrivePlanes& planes,
                                        const std::vector<PlaneSection>& sections);

/// The sections, trimmed and clipped to the part, in space; one list for each plane.
std::vector<PlaneLines> trimmed_lines(const OffsetSections& sections,
                                      const TrimmingMethod& method,
                                      const TrimmingOptions& options);
/// The same for a name in `trimming_methods`. \throws DomainError if there is none.
std::vector<PlaneLines> trimmed_lines(const OffsetSections& sections,
                                      const std::string& method,
                                      const TrimmingOptions& options);

/// The lines of every n-th plane, so that the lines of a picture are distinct.
PlaneLines every_nth(const std::vector<PlaneLines>& planes, std::size_t n);

}  // namespace endmill
