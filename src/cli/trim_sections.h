// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/trim_options.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/offset_mesh.h"
#include "endmill/offset/slicer.h"
#include "endmill/surface/part.h"
#include "endmill/trimming/cut_out.h"

namespace endmill {

/// The sections to trim and their origin.
struct TrimInput {
    std::string file;  ///< as given
    std::string name;
    std::string source;
    std::vector<std::string> remarks;  ///< on the part's file
    std::unique_ptr<const Part> part;  ///< empty for curves; `drop_cutter` refers to it
    std::optional<OffsetMesh> offset;  ///< of surfaces
    std::optional<DropCutter> drop_cutter;        ///< on a mesh
    std::optional<DrivePlanes> planes;            ///< none for curves
    std::vector<PlaneSection> sections;           ///< one a plane
    std::vector<std::optional<Interval>> ranges;  ///< of s on the path; empty: no limits
    double highest = 0;                           ///< z of the part, mm
    double offset_ms = 0;                         ///< wall time of the offset
    double slice_ms = 0;                          ///< wall time of slicing
};

/// Reads the part or the curves. Offsets and slices a part.
/// \throws FormatError, LimitError, DomainError, GeometryError as the readers,
///         offset_mesh and drive_planes.
TrimInput read_trim_input(const TrimOptions& options);

/// Height in mm at which the cutter moves freely.
double safe_height(const TrimInput& input, const TrimOptions& options);

/// The distance between neighbouring planes in mm; empty if there is only one plane.
std::optional<double> pick_feed(const DrivePlanes& planes);

/// The scallop height in mm on level ground between passes that are `pitch` mm apart.
/// This is the inverse of --scallop. Empty if the passes leave uncut ground between
/// them.
std::optional<double> level_scallop(double pitch, const Cutter& cutter);

/// A test whether a point of plane `plane` is a contact on a concave crease.
CreaseTest crease_test(const TrimInput& input, std::size_t plane);

}  // namespace endmill
