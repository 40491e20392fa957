// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/azimuth_window.h"
#include "endmill/setup/detail/cone_set.h"
#include "endmill/setup/detail/coverage_table.h"
#include "endmill/setup/setup_objective.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// What a search over axes is about. The cones and centres outlive it.
struct ConeFitting {
    const ConeSet* cones;
    std::span<const Vec3> centres;  ///< of cones->cells()
    PoseMeasure measure;
    RangeLimits limits;

    /// Sets narrower than this, rad, are sought along great circles: see axis_node.h.
    double thin_width = 0;
};

/// A set of tool directions that meets all cones. C,A: cells in the window up to polar angle
/// m0, and opposite to it up to m1 <= m0; A,B: in the window, at latitudes -m1 to m0.
struct AxisFit {
    Vec3 axis;  ///< unit: C in C,A, R1 in A,B
    AzimuthWindow window;
    PoseRanges ranges;
    double objective = 0;
};

/// Which sets about an axis matter.
struct FitRequest {
    double below;      ///< those of a smaller objective
    double slack = 0;  ///< a set may be missed that is better by this share only
    std::array<double, 2> low = {0, 0};   ///< with m0, m1 from here, rad
    std::array<double, 2> high = {4, 4};  ///< to here, rad
};

/// Finds the best set about a given axis. Keeps its memory between calls; one a thread.
class AxisFitter {
public:
    explicit AxisFitter(const ConeFitting& fitting);

    /// The set of least objective about `axis` of those asked for and within the limits, if
    /// there is one. Exact but for rounding (1e-14 relative), but where a cell is so near to
    /// the axis that its azimuth is not known better.
    std::optional<AxisFit> best(const Vec3& axis, const FitRequest& request);

    const ConeFitting& fitting() const { return fitting_; }  ///< as given

private:
    /// Ranks of levels, first and last of each side.
    struct RankBox {
        std::array<std::size_t, 2> first;
        std::array<std::size_t, 2> last;
        double bound = 0;
    };

    struct Later;

    void list_levels(const FitRequest& request);
    double low(const RankBox& box, std::size_t side) const;
    double high(const RankBox& box, std::size_t side) const;
    bool is_needless(const RankBox& box) const;
    void take(const AzimuthWindow& window, const PoseRanges& ranges, double objective);
    void look_at(RankBox box);
    void split(const RankBox& box);

    ConeFitting fitting_;
    WindowSweep sweep_;
    CoverageTable table_;
    AxisView view_;
    std::array<std::vector<double>, 2> levels_;  ///< that cells have, and 0; ascending
    std::vector<RankBox> heap_;
    double below_ = 0;  ///< the objective to fall short of
    double slack_ = 0;  ///< of the request
    std::optional<AxisFit> found_;
};

/// Steps of a descent.
struct Descent {
    double from;  ///< first length, rad
    double to =
        1e-7;  ///< last length, rad; less changes no angle that a machine could tell
    int directions =
        12;  ///< tried at each length before it is halved: valleys are narrow
};

/// Improves a fit by trying axes around it at ever smaller steps: a local minimum, or nearly.
/// Levels may move by a few steps at a time.
AxisFit descend(AxisFitter& fitter, AxisFit fit, const Descent& descent);

/// The fit as a pose on a machine with these limits, in words with R2 = C x R1 (A,B: a then b).
/// The part is turned so that the limits hold, else so that the larger phi (C,A) or theta
/// (A,B) is positive; C divides the window of R1 as 0 divides the limits.
FittedPose fitted_pose(const AxisFit& fit, RotaryFamily family,
                       const RotaryLimits& limits);

}  // namespace endmill
