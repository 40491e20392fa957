// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/process/ball_engagement.h"
#include "endmill/process/cutting_force.h"

namespace endmill {

/// A range of heights above the tip.
struct EdgeStretch {
    double from;  ///< in radii of the ball
    double to;    ///< ditto, above `from`
};

/// About the axis: their engaged stretches are counted one by one.
inline constexpr double most_windings = 1000;

/// A helical edge of a ball-end cutter in its engagement: at the height z, in radii from the
/// tip, its azimuth trails that at the tip by z tan(helix).
///
/// **Sense of the helix.** Azimuths grow from the stock's side towards the feed. When milling up
/// a spindle that turns clockwise seen from above (M03) turns that way, and a positive helix is
/// that of a right-hand cutter. When milling down the frame is mirrored, the spindle turns
/// against the azimuth, and an edge of a right-hand cutter leads by z tan(helix) where a
/// positive helix lets it trail: then a positive helix is that of a left-hand cutter, and a
/// right-hand cutter is told by the negative one. The paper is silent; the spec of ball-end
/// milling, section 4, does not mirror the helix, and its numbers follow that. Means over a turn do
/// not depend on the helix; in a slot its sense changes no peak.
///
/// The edge is in or out of the engaged region between its crossings with the borders. Along
/// a border the azimuth at the tip for which the edge goes through a point is monotonic but
/// for a few turning points, found once; so each crossing is one bracketed root.
/// Source: [ParkMaeng, appendix A]; derived in paper/notes/ball-engagement.md, section 5.
class HelicalEdge {
public:
    /// \param helix rad, within a right angle either way.
    /// \throws DomainError unless `engagement` is sound and the helix is as said; if the edge
    ///         winds more than `most_windings` times about the axis below the stock's top.
    HelicalEdge(const BallEngagement& engagement, double helix);

    /// The heights at which the edge cuts when it stands at the azimuth `turn` (rad, any) at
    /// the tip; rising, and apart but where the ball ends, at 1. Ends are good to 1e-12 where
    /// the edge crosses the border, and to 1e-6 where it all but touches it.
    std::vector<EdgeStretch> engaged(double turn) const;

    /// The azimuths at the tip, 0 <= turn < 2 pi, rising, at which `engaged` has a corner:
    /// where the edge touches a border or goes through a corner of the region.
    const std::vector<double>& events() const { return events_; }

    double tangent() const { return tangent_; }  ///< of the helix

private:
    // A stretch of a border along which the azimuth at the tip runs one way.
    struct Run {
        BorderKind kind;
        bool is_at_stock;  // y > 0
        double from;       // p
        double to;
        double turn_from;  // azimuth at the tip
        double turn_to;
    };

    double azimuth(const Run& run, const Vec3& at) const;
    double turn_at(const Run& run, double p) const;
    double turn_rate(const Run& run, double p) const;
    double crossing(const Run& run, double turn) const;
    void add_runs(const BorderArc& arc);
    void add_monotonic(Run run);
    void add_event(double turn);
    void add_ball(double turn, std::vector<EdgeStretch>& ranges) const;
    void add_shank(double turn, std::vector<EdgeStretch>& ranges) const;

    bool is_air_;
    EngagedRegion region_;
    double tangent_;
    double shank_top_;    // height of the stock's top, at least 1
    double shank_angle_;  // engaged azimuths of the shank: 0 to this
    std::vector<Run> runs_;
    std::vector<double> events_;
};

/// How the cutter's axis stands beside the spindle's.
struct Runout {
    double offset_mm = 0;  ///< distance, from 0
    double angle = 0;      ///< rad: its azimuth when flute 0 stands at azimuth 0
};

/// A cut whose force is asked for at every turn.
struct MillingCut {
    BallEngagement engagement;
    ChipModel chip = ChipModel::Paper;
    CuttingMaterial material;
    MillingTool tool;
    double feed_per_tooth_mm;  ///< from 0
    Milling milling = Milling::Down;
    Runout runout = {};
};

/// Force and torque of a ball-end cutter with helical flutes while it turns.
///
/// Azimuths and helix are those of HelicalEdge: when milling down, the frame is mirrored, a
/// right-hand cutter under M03 is told by a negative helix, and it turns towards falling
/// azimuths.
///
/// Flutes are counted in cutting order: flute j stands 2 pi j / m behind flute 0. Its chip is
/// f |sin u| thick, or as the exact chip says, and by runout e thicker by
/// e [cos(2 pi j / m - a) - cos(2 pi (j - 1) / m - a)], what it reaches beyond the flute before
/// it. Where that leaves no chip, the flute bears nothing: it does not touch. So while every
/// chip is above 0 the mean over a turn is `mean_force`, for any helix.
/// Source: [ParkMaeng, appendices A and B], misprints corrected; runout is ours:
/// paper/notes/ball-engagement.md, section 5.
class ForceProfile {
public:
    /// \throws DomainError unless all parts of `cut` are as said; as HelicalEdge.
    explicit ForceProfile(const MillingCut& cut);

    /// Force and torque on the work, in the frame of `mean_force`, when flute 0 stands at the
    /// azimuth `turn` (rad, any) at the tip. Relative error below 1e-9 of the largest force.
    CuttingForce at(double turn) const;

    /// Where flute 0 may have a corner in its force: see HelicalEdge.
    const HelicalEdge& edge() const { return edge_; }

private:
    // Tangential, radial and axial force per height, over K; and the place.
    struct EdgeLoad {
        double tangential_mm;
        double radial_mm;
        double axial_mm;
    };
    struct Sums;

    double thickness(double azimuth, double height, double beyond) const;
    EdgeLoad load(double thickness_mm) const;
    void add_part(const EdgeStretch& part, double azimuth, double beyond,
                  Sums& sums) const;
    void add_stretch(const EdgeStretch& stretch, double azimuth, double beyond,
                     Sums& sums) const;

    MillingCut cut_;
    HelicalEdge edge_;
    double cos_lambda_;
    double sin_lambda_;
};

}  // namespace endmill
