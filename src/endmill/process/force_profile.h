// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/process/cutting_force.h"
#include "endmill/process/helical_edge.h"

namespace endmill {

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
