// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "cli/trim_options.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/offset_mesh.h"
#include "endmill/offset/slicer.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Surfaces and the offset that is sliced.
struct OffsetPart {
    std::vector<Surface> surfaces;
    OffsetMesh offset;
    double offset_ms;                             ///< wall time of the offset
    std::vector<std::optional<Interval>> ranges;  ///< of s on the path, one a plane
};

/// A mesh on which the cutter is dropped.
struct DroppedPart {
    std::unique_ptr<const TriangleMesh> mesh;  ///< `drop_cutter` refers to it
    DropCutter drop_cutter;                    ///< of the cutter with the allowance
    std::size_t added_planes = 0;              ///< for --scallop, on slopes and at walls
};

/// A part and the planes that cut it.
struct CutPart {
    DrivePlanes planes;
    std::variant<OffsetPart, DroppedPart> shape;
    double highest;   ///< z of the part, mm
    double slice_ms;  ///< wall time of slicing
};

/// Profiles of a file whose offsets are trimmed.
struct OffsetCurves {
    std::vector<SectionCurve> profiles;           ///< as read
    std::vector<std::optional<Interval>> ranges;  ///< of s on the path, of the one plane
};

/// The sections to trim and their origin.
struct TrimInput {
    std::string file;  ///< as given
    std::string name;
    std::string source;
    std::vector<std::string> remarks;    ///< on the part's file
    std::vector<PlaneSection> sections;  ///< one a plane
    std::optional<CutPart> part;         ///< nothing for curves of a file
    std::optional<OffsetCurves> curves;  ///< only with --offset

    /// The surfaces that were offset; null for a mesh and for curves.
    const OffsetPart* offset_part() const
    {
        return part ? std::get_if<OffsetPart>(&part->shape) : nullptr;
    }
    /// The ranges of s of `offset_part` or `curves`; without them none, which leaves s
    /// unlimited.
    std::span<const std::optional<Interval>> ranges() const;

    /// The mesh that needs no trimming; null for surfaces and for curves.
    const DroppedPart* dropped_part() const
    {
        return part ? std::get_if<DroppedPart>(&part->shape) : nullptr;
    }
};

/// Reads the part or the curves. Offsets and slices a part.
/// \throws FormatError, LimitError, DomainError, GeometryError as the readers,
///         offset_mesh and drive_planes.
TrimInput read_trim_input(const TrimOptions& options);

/// Height in mm at which the cutter moves freely.
double safe_height(const CutPart& part, const TrimOptions& options);

/// The largest distance between neighbouring planes in mm; empty if there is only one plane.
std::optional<double> pick_feed(const DrivePlanes& planes);

}  // namespace endmill
