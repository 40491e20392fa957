// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Geometry of the cuts of a path: the slopes, pick feed and depth of every cutting move.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/process/ball_engagement.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Geometry of the cut of a ball-end mill on one straight cutting move, taken at the
/// middle of the move. Values that are unknown, or meaningless for a first pass, are
/// std::nullopt.
/// Source: [ParkMaeng, eq. (8) to (14)]; docs/methods/ball-end-milling.md, sections
/// 1, 3 and 6.
struct SegmentCut {
    int pass = 0;          ///< number of the pass in the path
    int point = 0;         ///< number within its pass of the point at the move's end
    double length_mm = 0;  ///< mm, length of the move of the ball centre, above 0
    std::optional<double> mu = {};  ///< rad, slope of the pick feed, about the feed
    double lambda = 0;              ///< rad, slope of the feed, positive uphill
    std::optional<double> pick_feed_mm = {};  ///< mm, f_p: path interval of ball centres
    std::optional<double> pick_feed_horizontal_mm = {};  ///< mm, f_p cos(mu)
    /// mm, l, height of the stock's top above the tip; <= 0: in air.
    double depth_mm = 0;
    PreviousPass previous = PreviousPass::Beside;  ///< Beside needs mu and the pick feed
    Milling milling = Milling::Down;               ///< side of the feed with the stock
    /// Earlier passes lie on both sides. The nearer one counts.
    bool has_two_neighbours = false;
};

/// Source of the geometry of a cut.
enum class CutSource {
    Auto,     ///< the contact where it is known, else the passes
    Contact,  ///< the normal of the part where the ball touches it
    Passes    ///< the path alone: the earlier pass beside the move
};

/// Data that `segment_cuts` needs beside the path.
struct SegmentCutOptions {
    double radius;     ///< mm, radius of the ball, above 0
    double stock_top;  ///< mm, height of the stock's horizontal top
    /// None or Edge: engagement of the moves that have no earlier neighbour.
    PreviousPass first_pass = PreviousPass::None;
    CutSource source = CutSource::Auto;  ///< source of mu and the pick feed
    std::span<const Surface> part = {};  ///< part for which the path was made, if known
    /// mm, largest distance between the ball and the part at a contact, above 0.
    double contact_tolerance = 0.05;
};

/// The cuts of a path.
struct SegmentCuts {
    std::vector<SegmentCut> cuts;     ///< one per cutting move, in order
    std::vector<std::size_t> points;  ///< index in the path of each move's end point
    std::size_t by_contact = 0;   ///< number of cuts whose geometry comes from a contact
    std::size_t by_passes = 0;    ///< number of the other cuts
    std::size_t zero_length = 0;  ///< number of moves of length 0, which are left out
};

/// Geometry of every cutting move of `path`. Moves of length 0 and vertical moves are
/// left out, because the model does not describe them.
///
/// The pick feed leads to the nearest earlier pass beside the move, within the diameter
/// of the ball. A move without such a neighbour belongs to a first pass.
/// - By the passes, length and slope of the pick feed are those of the line between the
///   ball centres. They are exact for parallel passes on planes. Along a cylinder the
///   length is exact; the error of the slope is half the angle between the passes.
/// - By contact, mu and lambda follow from eq. (10) and (11) with the normal of the part.
///   If the part is given, f_p = d (1 + r0 k), where d is the distance of the contacts
///   across the feed and k is the normal curvature of the part across the feed. Otherwise
///   f_p is the distance of the ball centres.
/// - Contacts are projections of the ball centre on the part if it is given. Otherwise
///   they are the means of the normals that the path states at both ends of a move.
///   `Auto` uses the passes where there is no contact or the ball does not fit
///   the part.
/// Source: [ParkMaeng, eq. (8) to (14)]; docs/methods/ball-end-milling.md, sections 6
/// and 12.
///
/// \param path the path; its conditions are not used.
/// \param options cutter, stock and part.
/// \throws DomainError if an option is outside its range.
/// \throws GeometryError unless the axis is +z everywhere; if the ball misses the part by
///         more than the tolerance at an end of a cut (the message states the largest
///         distance and its place); if a contact of the path belongs to another ball; or,
///         with the source `Contact`, if a move has no contact.
/// The result does not depend on the number of threads. Time is about n log(n) in the
/// moves.
SegmentCuts segment_cuts(const ToolPath& path, const SegmentCutOptions& options);

/// Slope and depth of the straight move between two tips.
struct MoveSlope {
    double lambda;    ///< rad, as SegmentCut::lambda
    double depth_mm;  ///< mm, as SegmentCut::depth_mm
};

/// Slope and depth of the move between the tips `from` and `to` under a stock whose top is
/// at the height `stock_top`, all in mm. \pre The tips differ.
MoveSlope move_slope(const Vec3& from, const Vec3& to, double stock_top);

/// Finds the cuts of a path in blocks, for a path of millions of moves, whose cuts take more
/// memory than the path itself. The blocks together are the result of `segment_cuts`.
class SegmentCutFinder {
public:
    /// \param path must outlive the finder; its conditions are not used and may change.
    /// \param options cutter, stock and part; the surfaces must outlive the finder.
    /// \throws DomainError, GeometryError as `segment_cuts`.
    SegmentCutFinder(const ToolPath& path, const SegmentCutOptions& options);
    ~SegmentCutFinder();                                 ///< releases the index
    SegmentCutFinder(const SegmentCutFinder&) = delete;  ///< not copied
    SegmentCutFinder& operator=(const SegmentCutFinder&) = delete;  ///< not copied

    std::size_t size() const;                     ///< number of cuts
    std::size_t zero_length() const;              ///< number of moves of length 0
    std::size_t point(std::size_t number) const;  ///< end point in the path of a cut
    bool has_depth() const;  ///< whether a cut lies below the top of the stock

    /// The cuts with the numbers from `first` to `first + count - 1`, with `zero_length` 0.
    /// \pre These numbers are below `size()`.
    /// \throws GeometryError as `segment_cuts` if a move has no contact.
    SegmentCuts cuts(std::size_t first, std::size_t count) const;

private:
    class Implementation;
    std::unique_ptr<const Implementation> implementation_;
};

}  // namespace endmill
