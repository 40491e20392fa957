// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/path/tool_path.h"
#include "endmill/trimming/trimming.h"

/// \file
/// Joins passes on surfaces, and trimmed curves in drive planes, to one tool path.
/// A link is a straight move at cutting feed, an arch of three of them, or a retract, a rapid
/// at the safe height and a plunge.

namespace endmill {

/// Contacts along one line of the surface, with rising parameter.
using Pass = std::vector<SurfaceContact>;

/// The direction in which neighbouring passes are cut.
enum class PassOrder {
    ZigZag,  ///< every second pass backwards; links are straight moves at cutting feed
    OneWay,  ///< all passes forwards; the cutter is lifted after each pass
};

/// The link between two pieces if the straight move is not clear.
enum class BarredLink {
    Lifted,  ///< a retract, a rapid at the safe height and a plunge
    /// An arch at cutting feed: up, across at a lower height than the safe one, and down. It is
    /// lifted if no arch is clear, or if the arch would be longer than retract and plunge.
    Arched,
};

/// Options for joining passes.
struct LinkOptions {
    PassOrder order = PassOrder::ZigZag;     ///< direction of neighbouring passes
    Vec3 axis = Vec3::UnitZ();               ///< unit, from the tip to the spindle
    double safe_height = 0;                  ///< mm along the axis, of the lifted tip
    BarredLink barred = BarredLink::Lifted;  ///< of link_pieces
};

/// Joins `passes` to one path. A plunge reaches the first point.
/// Source: [KimChoi, fig. 12, fig. 13] show the zigzag.
/// \param passes  in the order in which they are cut, each with rising parameter.
/// \param cutter  the ball.
/// \param options order, axis and safe height.
/// \throws GeometryError if the ball cannot touch a contact (N . axis <= 0), or if the
///         path rises above the safe height of a lift.
ToolPath link_passes(std::span<const Pass> passes, const BallCutter& cutter,
                     const LinkOptions& options);

/// Passes that are handed over one by one.
struct PassSource {
    std::size_t passes;    ///< number of passes
    std::size_t contacts;  ///< number of all their contacts
    /// Returns the next pass. It is called once for each pass, and the pass before may be
    /// freed then.
    std::function<std::span<const SurfaceContact>()> next;
};

/// Joins the passes of `source` to one path, as `link_passes`.
ToolPath link_passes_one_by_one(const PassSource& source, const BallCutter& cutter,
                                const LinkOptions& options);

/// Contacts of a pass that are cut without interruption, in the order of cutting.
struct PassPiece {
    int pass;       ///< number of the pass, from 0, rising from piece to piece
    Pass contacts;  ///< at least one
};

/// A path, and the number of its lifted links.
struct LinkedPath {
    ToolPath path;             ///< all pieces and the links between them
    std::size_t lifted_links;  ///< links that are lifted because they are not clear
    std::size_t arched_links;  ///< links that are arched for that reason
};

/// Joins `pieces` in their order to one path. A link is a straight move at cutting feed
/// if `is_clear` allows it, otherwise it is as `options.barred` demands. An arch raises both
/// ends of the straight move by the same height: an eighth, a quarter or half of the way to the
/// safe height, the least of them that is clear. One-way passes are always lifted from one
/// pass to the next; these lifts are not counted.
/// \param pieces   in the order in which they are cut.
/// \param cutter   the ball.
/// \param options  order, axis and safe height.
/// \param is_clear whether the straight move between two centres of the ball, in mm, is free
///        of gouges. A raised move must be clear if a lower one is.
/// \throws GeometryError as link_passes.
LinkedPath link_pieces(
    std::span<const PassPiece> pieces, const BallCutter& cutter,
    const LinkOptions& options,
    const std::function<bool(const Vec3& from, const Vec3& to)>& is_clear);

/// Joins the paths over the surfaces of a part in their order by lifted links. Pass
/// numbers continue from path to path, and the `patch` of each point becomes the number
/// of its path. A path without points is skipped.
/// \param paths   one for each surface.
/// \param options axis and safe height.
/// \throws GeometryError if a path that is lifted rises above the safe height.
ToolPath join_paths(std::span<const ToolPath> paths, const LinkOptions& options);

/// The trimmed curves in one drive plane.
struct PlaneCurves {
    double across;                         ///< t of the plane, mm
    std::span<const TrimmedCurve> curves;  ///< of reference points
};

/// Joins trimmed curves to one path of cutter tips. Each curve is a pass: a plunge
/// reaches it, a retract leaves it, and a rapid at the safe height leads to the next one.
/// With `ZigZag`, the curves of every second plane are cut backwards, the last curve
/// first. Passes are numbered from 0; the lift that leads to a pass has the number of
/// that pass. A curve of one point becomes a plunge without a cut.
/// Source: docs/methods/interference.md, section 1.
/// \param planes  in the order in which they are cut.
/// \param frame   position of the drive planes in space.
/// \param cutter  its corner radius leads from reference points to tips.
/// \param options order and safe height; the axis must be +z.
/// \throws DomainError if the axis is not +z.
/// \throws GeometryError if a tip lies above the safe height.
ToolPath link_sections(std::span<const PlaneCurves> planes, const DriveFrame& frame,
                       const Cutter& cutter, const LinkOptions& options);

/// The same for trimmed sections, one for each of `planes`.
/// \param trimmed sections of reference points, in the order of the planes.
/// \param planes  the planes that cut them.
/// \param cutter, options as above.
/// \throws DomainError, GeometryError as above, or unless there are as many sections as
///         planes.
ToolPath link_sections(std::span<const Trimmed> trimmed, const DrivePlanes& planes,
                       const Cutter& cutter, const LinkOptions& options);

}  // namespace endmill
