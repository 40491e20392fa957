// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/process/feed_plan.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Where the geometry of a cut comes from.
enum class CutSource {
    Auto,     ///< contact where it is known, else the passes
    Contact,  ///< the part's normal where the ball touches it
    Passes    ///< the path alone: the earlier pass beside the move
};

/// What a path alone does not tell of its cuts.
struct SegmentCutOptions {
    double radius;     ///< of the ball, mm, above 0
    double stock_top;  ///< height of the stock's horizontal top, mm
    PreviousPass first_pass =
        PreviousPass::None;  ///< None or Edge: no pass lies beside it
    CutSource source = CutSource::Auto;
    std::span<const Surface> part = {};  ///< what the path was made for; none: not known
    double contact_tolerance =
        0.05;  ///< mm, by which the ball may miss the part; above 0
};

/// The cuts of a path.
struct SegmentCuts {
    std::vector<SegmentCut> cuts;     ///< one a cut move, in order
    std::vector<std::size_t> points;  ///< of the path, to which the moves lead
    std::size_t by_contact = 0;       ///< cuts whose geometry comes from a contact
    std::size_t by_passes = 0;        ///< the others
    std::size_t zero_length = 0;      ///< moves to cut points that go nowhere, left out
};

/// How a ball-end mill stands in the stock on every cut move of `path`, at its middle. Moves
/// that go nowhere, and those straight up or down, are left out: they are none of the model.
///
/// The pick feed is that to the nearest earlier pass beside the move (`PassIndex`, within the
/// ball's diameter); where there is none, the move belongs to a first pass. By the passes, its
/// length and slope are those of the line between the centres: exact for parallel passes on
/// planes; along a cylinder the length is exact, the slope off by half the angle between the
/// passes. By contact, mu and lambda are those of eq. (10), (11) with the part's normal, and,
/// if the part is given, f_p = d (1 + r0 k) with the distance d of the contacts across the
/// feed and the normal curvature k of the part across it; else as by the passes.
/// Contacts are found by projection of the ball's centre if the part is given, or else are
/// between those that the path tells of both ends of the move, of which the normals are
/// enough. Where there is none, or the ball would not fit the part, the passes are used by
/// CutSource::Auto.
/// Source: [ParkMaeng, eq. (8) to (14)]; spec of ball-end milling, sections 6 and 12.
///
/// \throws DomainError unless the options are as said.
/// \throws GeometryError unless the axis is +z everywhere; if a cut point misses the part by
///         more than the tolerance, with the largest distance and its place; if a contact
///         that the path tells is another ball's; with CutSource::Contact if a move has none.
/// The same with any number of threads. About n log(n) in the moves.
SegmentCuts segment_cuts(const ToolPath& path, const SegmentCutOptions& options);

}  // namespace endmill
