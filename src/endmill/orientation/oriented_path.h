// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/orientation/oriented_options.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"
#include "endmill/surface/surface.h"
#include "endmill/verification/verification_result.h"

/// \file
/// Five-axis paths: passes along the parameter lines of a part, with a tool that leans
/// against its normals.

namespace endmill {

/// The least and the greatest of the angles of all contacts.
struct AngleExtent {
    Angle least = Angle::radians(0);     ///< of all contacts
    Angle greatest = Angle::radians(0);  ///< of all contacts
};

/// A path whose axis turns.
struct OrientedPath {
    ToolPath
        path;  ///< contacts are known at all cuts but those beyond the ends of passes
    std::size_t passes = 0;     ///< number of passes; on a mesh as its strategy laid them
    double cut_contact_mm = 0;  ///< length of the cuts by contacts
    AngleExtent lead;           ///< leads of all contacts
    AngleExtent tilt;           ///< tilts of all contacts
    double narrowest_strip_mm = 0;  ///< least width of a strip
    double widest_strip_mm = 0;     ///< greatest width of a strip
    /// Sum of the turns of the axis in the part, on all moves.
    Angle rotary_travel = Angle::radians(0);
    double most_turn_deg_per_mm = 0;  ///< on cuts, by the way of the contact
    /// Mode Field: least gap between cutter and part at all rows of passes, mm; negative
    /// for a gouge. It is accurate to a quarter of the inner tolerance.
    std::optional<double> least_gap_mm = {};
};

/// Plans passes along parameter lines. Neighbouring passes are as far apart as their strips
/// allow, by the curvatures of part and cutter at the narrowest place. On a pass, rows are
/// inserted until the cutter between two of them neither gouges the contact by more than half
/// the inner tolerance nor leaves more there than a twentieth of the scallop height, at most
/// the inner tolerance. A leaning cutter that is no ball runs on beyond the end of a pass until
/// its rim has left the part beside the pass too; a tilted one also begins before the pass.
/// Between passes the tool is lifted along its axis: by a small clearance
/// if the next pass is near, else to the safe height, where it turns.
///
/// In mode Field an axis is allowed if its strip is as wide as the distance of the passes
/// needs, the cutter gouges no place of the part by more than 3/4 of the inner tolerance, and
/// shank and holder are a quarter of it away. Halfway between two rows the cutter gouges by no
/// more than the inner tolerance, and shank and holder are clear of the part.
///
/// Nothing here proves that the path is clean; see plan_judged_oriented.
/// Source: docs/methods/five-axis-planning.md.
/// \param surfaces of the part. Their tool sides face +z on average, single places may face
///        any way.
/// \throws GeometryError if the cutter does not fit somewhere with this inclination, with the
///         place and the least lead that would do; if a surface has no normal at a contact, or
///         a lifted tool leans by more than 80 degrees. In mode Field also as axis_field.
/// \throws LimitError for a path of more points than allowed.
/// \throws DomainError for options out of range.
OrientedPath plan_oriented(std::span<const Surface> surfaces, const Cutter& cutter,
                           const OrientedOptions& options);

/// Plans passes on a mesh. A strategy lays them for a ball of the cutter's radius along +z; the
/// tool leans against the normals of the smooth part that the mesh approximates. For another
/// cutter than a ball the strategy has a greater scallop height, for which the strips of the ball
/// are nowhere wider than those of the cutter, and the passes are continued by half a strip.
/// Facets that the ball cannot reach along +z are not cut. Rows, links and the rules of mode
/// Field are as above; near links are also tested against the mesh.
///
/// Nothing here proves that the path is clean; see plan_judged_oriented.
/// Source: docs/methods/five-axis-planning.md, section 4.
/// \param mesh without triangles that have no area.
/// \throws GeometryError as above and as covering_by_strategy, and if two neighbouring
///         triangles face opposite sides.
/// \throws LimitError as above and as covering_by_strategy.
/// \throws DomainError for options out of range.
OrientedPath plan_oriented(const TriangleMesh& mesh, const Cutter& cutter,
                           const OrientedOptions& options);

/// An oriented path and its simulated cut.
struct JudgedOrientedPath {
    OrientedPath plan;          ///< the path
    Verification verification;  ///< its simulated cut
};

/// Plans an oriented path on surfaces or a mesh and verifies it. Stock on the skipped facets of a
/// mesh is not judged. If it is not clean, it is planned again: for less
/// scallop height if more remains than allowed, with closer rows if it gouges. After eight
/// trials the last one is returned; before, if the greatest remaining stock of a mesh does not
/// fall, because the tool does not reach its place.
/// \throws as plan_oriented and verify_path.
/// \throws GeometryError if a cutter that is no ball gouges a mesh by more than the inner
///         tolerance in a pose of mode Fixed or Lead, for example because the mesh is coarse.
JudgedOrientedPath plan_judged_oriented(const Part& part, const Cutter& cutter,
                                        const OrientedOptions& options);

}  // namespace endmill
