// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/azimuth_window.h"
#include "endmill/setup/detail/cone_set.h"
#include "endmill/setup/detail/coverage_table.h"
#include "endmill/setup/detail/range_limits.h"
#include "endmill/setup/setup_pose.h"

/// \file
/// The best range of tool directions about a given axis, over whole cones.
///
/// A range of tool directions about an axis (C in C,A, R1 in A,B) is a window of azimuths
/// of width w together with two levels m0 and m1. C,A: the directions in the window up to
/// the polar angle m0, and those opposite to the window up to m1. A,B: the directions in
/// the window with latitudes from -m1 to m0.

namespace endmill {

/// The problem of a search over axes. Cones and centres must outlive the search.
struct ConeFitting {
    const ConeSet* cones;           ///< to be met
    std::span<const Vec3> centres;  ///< unit, one for each of cones->cells()
    PoseMeasure measure;            ///< what is minimised
    RangeLimits limits;             ///< of w, m0 and m1

    /// rad; sets with a narrower window are searched for along great circles, see
    /// axis_node.h.
    double thin_width = 0;
};

/// A range of tool directions that meets all cones. In C,A m1 <= m0.
struct AxisFit {
    Vec3 axis;             ///< unit: C in C,A, R1 in A,B
    AzimuthWindow window;  ///< azimuths about the axis, from `azimuth_zero` on
    PoseRanges ranges;     ///< w, m0 and m1
    double objective = 0;  ///< rad^2 or rad
};

/// Adds cones that hold none of some cells to the cones of a problem.
/// \param cells indices of centres. \return true if a cone was added.
using GrowCones = std::function<bool(std::span<const std::uint32_t> cells)>;

/// Which ranges about an axis are asked for.
struct FitRequest {
    double below;  ///< only those with a smaller objective
    /// Relative: a range that is better by less than this may be missed.
    double slack = 0;
    std::array<double, 2> low = {0, 0};   ///< lower bounds of m0 and m1, rad
    std::array<double, 2> high = {4, 4};  ///< upper bounds of m0 and m1, rad
};

/// Finds the best range about a given axis. Keeps its memory between calls; one for each
/// thread.
class AxisFitter {
public:
    /// \param fitting the problem; its cones and centres must outlive the fitter.
    /// \param grow if set, it is called with the cells of each range that is better than
    ///        those found before. The range counts if no cone is added.
    explicit AxisFitter(const ConeFitting& fitting, GrowCones grow = {});

    /// The range of least objective about `axis` among those asked for and within the
    /// limits. The objective is exact up to rounding (1e-14 relative), except for cells
    /// so close to the axis that their azimuth is known less accurately.
    /// \return nothing if there is no such range.
    std::optional<AxisFit> best(const Vec3& axis, const FitRequest& request);

    const ConeFitting& fitting() const { return fitting_; }  ///< the problem, as given

private:
    /// A box of pairs of levels: indices of the first and the last level of each side.
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

    std::optional<AzimuthWindow> least_window(const PoseRanges& most, double cap);

    ConeFitting fitting_;
    GrowCones grow_;
    WindowSweep sweep_;
    CoverageTable table_;
    AxisView view_;
    /// Levels of cells, and the lowest; ascending.
    std::array<std::vector<double>, 2> levels_;
    std::vector<RankBox> heap_;  ///< least bound first
    double below_ = 0;           ///< only a smaller objective counts
    double slack_ = 0;           ///< of the request
    std::optional<AxisFit> found_;
};

/// The problem of arcs of great circles that meet all cones, as one of ranges in A,B: R1
/// is the normal of the circle, the window is the arc, and `reach` (rad) limits the
/// latitudes. The length of the arc is not limited.
ConeFitting arc_fitting(const ConeFitting& fitting, double reach);

/// The axis on the circle of an arc about which the arc is a window of width 0, and its
/// levels suit the limits best: they are as equal as the limits allow.
/// \param arc found for `arc_fitting`. \param fitting the problem of ranges.
Vec3 axis_on_arc(const AxisFit& arc, const ConeFitting& fitting);

/// Step lengths of a descent.
struct Descent {
    double from;       ///< first length, rad
    double to = 1e-7;  ///< last length, rad; machines do not resolve smaller angles
    /// Tried at each length before it is halved: valleys are narrow.
    int directions = 12;
};

/// Finds the best range about an axis among those asked for, as AxisFitter::best.
using FitAbout =
    std::function<std::optional<AxisFit>(const Vec3& axis, const FitRequest& request)>;

/// Improves a fit by moving its axis, with step lengths that are halved when no step
/// helps. The result is close to a local minimum. Levels may change by three steps at a
/// time.
AxisFit descend(const FitAbout& best, AxisFit fit, const Descent& descent);

/// The same with `fitter.best`.
AxisFit descend(AxisFitter& fitter, const AxisFit& fit, const Descent& descent);

/// Converts a fit to a pose on a machine, in words with R2 = C x R1 (A,B: a, then b).
///
/// The part is turned so that the limits hold; if that does not decide, so that the
/// larger end of phi (C,A) or theta (A,B) is positive. Zero divides the window in the
/// ratio in which it divides the limits.
FittedPose fitted_pose(const AxisFit& fit, RotaryFamily family,
                       const RotaryLimits& limits);

}  // namespace endmill
