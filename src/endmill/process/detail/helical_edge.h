// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/process/detail/engaged_region.h"

namespace endmill {

/// A range of heights of an edge above the tip, in radii of the ball.
struct EdgeRange {
    double from;  ///< lower end
    double to;    ///< upper end, above `from`
};

/// Largest number of windings of an edge about the axis within the cut. Engaged ranges
/// are computed one by one, so their number needs a bound.
inline constexpr double most_windings = 1000;

/// A helical edge of a ball-end mill in its engagement. At the height z above the tip, in
/// radii of the ball, the azimuth of the edge is that of the tip minus z tan(helix). The
/// sense of the helix is explained at MillingTool::helix.
///
/// The edge enters and leaves the engaged region where it crosses the borders of the
/// region.
/// 1. For each point of a border there is an azimuth of the tip at which the edge passes
///    this point. Every border is split once, at the few local extrema of this azimuth.
///    On each part (a "run") the azimuth is monotonic.
/// 2. For a given azimuth of the tip, each run that contains this azimuth has one
///    crossing, which is one bracketed root.
/// 3. Between neighbouring crossings the edge is engaged if the middle of the range is.
/// Source: [ParkMaeng, appendix A]; derived in paper/notes/ball-engagement.md, section 5.
class HelicalEdge {
public:
    /// \param engagement the cut.
    /// \param helix rad, below pi/2 in magnitude.
    /// \throws DomainError unless `engagement` is sound and the helix is in its range, or
    ///         if the edge winds more than `most_windings` times about the axis below the
    ///         stock's top.
    HelicalEdge(const BallEngagement& engagement, double helix);

    /// The heights at which the edge cuts while its tip is at the azimuth `turn` (rad,
    /// any value). Ascending and disjoint; two ranges may share the end of the ball at 1.
    /// Accurate to 1e-12 where the edge crosses a border, and to 1e-6 where it nearly
    /// touches one.
    std::vector<EdgeRange> engaged(double turn) const;

    /// The azimuths of the tip, 0 <= turn < 2 pi, ascending, at which the number of
    /// engaged ranges may change: the edge touches a border or passes a corner of the
    /// region.
    const std::vector<double>& events() const { return events_; }

    double tangent() const { return tangent_; }  ///< tan(helix)

private:
    // A part of a border on which the azimuth at the tip is monotonic.
    struct Run {
        BorderKind kind;
        bool is_at_stock;  // y > 0
        double from;       // p
        double to;         // p
        double turn_from;  // azimuth at the tip, rad
        double turn_to;    // azimuth at the tip, rad
    };

    double azimuth(const Run& run, const Vec3& at) const;
    double turn_at(const Run& run, double p) const;
    double turn_rate(const Run& run, double p) const;
    double crossing(const Run& run, double turn) const;
    void add_runs(const BorderArc& arc);
    void add_monotonic(Run run);
    void add_event(double turn);
    void add_ball(double turn, std::vector<EdgeRange>& ranges) const;
    void add_shank(double turn, std::vector<EdgeRange>& ranges) const;

    bool is_air_;
    EngagedRegion region_;
    double tangent_;
    double shank_top_;    // height of the stock's top, at least 1
    double shank_angle_;  // the shank cuts at azimuths from 0 to this angle
    std::vector<Run> runs_;
    std::vector<double> events_;
};

}  // namespace endmill
