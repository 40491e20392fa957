// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/orientation/inclination.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/linking.h"
#include "endmill/surface/surface.h"
#include "endmill/verification/verification_result.h"

/// \file
/// Five-axis paths: passes along the parameter lines of a part, with a tool that leans
/// against its normals.

namespace endmill {

/// How the tool leans at each contact.
enum class AxisMode {
    Fixed,  ///< by the given lead and tilt
    /// By the least lead at which the cutter does not gouge, but one degree more, and at least
    /// the given one. The tilt is the given one.
    Lead,
};

/// How an oriented path is planned.
struct OrientedOptions {
    AxisMode mode = AxisMode::Lead;        ///< how the tool leans
    Inclination inclination = {};          ///< given lead and tilt
    Parameter along = Parameter::U;        ///< the parameter that changes along a pass
    double scallop_height = 0.05;          ///< mm along the normal, above 0
    double inner_tolerance = 0.01;         ///< mm, greatest depth of a gouge; above 0
    PassOrder order = PassOrder::ZigZag;   ///< direction of neighbouring passes
    double safe_height = 0;                ///< mm, z of lifted tools; above the part
    std::size_t most_points = 40'000'000;  ///< a longer path throws LimitError
    /// If set, it is called with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// A path whose axis turns.
struct OrientedPath {
    ToolPath
        path;  ///< contacts are known at all cuts but those beyond the ends of passes
    std::size_t passes = 0;                   ///< number of passes
    double cut_contact_mm = 0;                ///< length of the cuts by contacts
    Angle least_lead = Angle::radians(0);     ///< of all contacts
    Angle greatest_lead = Angle::radians(0);  ///< of all contacts
    double narrowest_strip_mm = 0;            ///< least width of a strip
};

/// Plans passes along parameter lines. Neighbouring passes are as far apart as their strips
/// allow, by the curvatures of part and cutter at the narrowest place. On a pass, rows are
/// inserted until the cutter between two of them neither gouges the contact by more than half
/// the inner tolerance nor leaves more there than a twentieth of the scallop height, at most
/// the inner tolerance. A leaning cutter that is no ball runs on beyond the end of a pass until
/// its rim has left the part beside the pass too. Between passes the tool is lifted along its axis: by a small clearance
/// if the next pass is near, else to the safe height, where it turns.
///
/// Nothing here proves that the path is clean; see plan_judged_oriented.
/// Source: docs/methods/five-axis-planning.md.
/// \param surfaces of the part. Their tool sides face +z on average, single places may face
///        any way.
/// \throws GeometryError if the cutter does not fit somewhere with this inclination, with the
///         place and the least lead that would do; if a surface has no normal at a contact, or
///         a lifted tool leans by more than 80 degrees.
/// \throws LimitError for a path of more points than allowed.
/// \throws DomainError for options out of range.
OrientedPath plan_oriented(std::span<const Surface> surfaces, const Cutter& cutter,
                           const OrientedOptions& options);

/// An oriented path and its simulated cut.
struct JudgedOrientedPath {
    OrientedPath plan;
    Verification verification;
};

/// Plans an oriented path and verifies it. If it is not clean, it is planned again: for less
/// scallop height if more remains than allowed, with closer rows if it gouges. After four
/// trials the last one is returned.
/// \throws as plan_oriented and verify_path.
JudgedOrientedPath plan_judged_oriented(std::span<const Surface> surfaces,
                                        const Cutter& cutter,
                                        const OrientedOptions& options);

}  // namespace endmill
