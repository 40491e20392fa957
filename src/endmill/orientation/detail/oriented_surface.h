// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/machine/tool_motion.h"
#include "endmill/orientation/detail/axis_rules.h"
#include "endmill/orientation/inclination.h"
#include "endmill/orientation/oriented_options.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// A parameter line along which a pass runs.
struct PassLine {
    double across;           ///< the parameter that does not change
    bool is_forward = true;  ///< towards larger parameters
    double covered = 0;  ///< farthest parameter from `across` that its strip must cover
};

/// A contact of a pass.
struct PassPlace {
    SurfaceContact at;                ///< parameters, point and normal
    Vec3 feed = Vec3::Zero();         ///< unit, tangent to the part
    ContactCurvature curvature = {};  ///< along the feed and across
    double across = 0;                ///< mm per unit of the parameter across the feed
};

/// A contact with the pose of the tool.
struct PassPose {
    PassPlace place;          ///< the contact
    CutterLocation location;  ///< tip and axis
    Inclination inclination;  ///< of the axis
    double strip_mm = 0;      ///< width of the strip
};

/// The distance in mm between the contacts of two poses.
double contact_way(const PassPose& from, const PassPose& to);

/// The passes along the parameter lines of one surface.
class OrientedSurface {
public:
    /// \param surface must outlive the object, as cutter and options.
    /// \param side from tool_side_signs. \param number of the surface, from 0.
    OrientedSurface(const Surface& surface, double side, std::size_t number,
                    const Cutter& cutter, const OrientedOptions& options);

    /// The lines of all passes.
    /// \throws GeometryError if the cutter does not fit somewhere.
    std::vector<PassLine> passes() const;

    /// The place of a pass at a parameter along it.
    PassPlace place(double along, const PassLine& line) const;

    /// The inclination by modes Fixed and Lead; that which mode Field wants.
    /// \throws GeometryError if the cutter does not fit.
    Inclination inclination_at(const PassPlace& place) const;

    /// The pose at a place with an inclination.
    /// \throws GeometryError if the cutter does not fit.
    PassPose posed(const PassPlace& place, const Inclination& inclination) const;

    /// The pose at a place with an axis.
    /// \throws GeometryError if the cutter does not fit.
    PassPose posed(const PassPlace& place, const Vec3& axis) const;

    /// What the rules of a field need at a place of a pass.
    RuledContact ruled(const PassPlace& place, const PassLine& line) const;

    /// The least lead of a field that keeps the heel of a cutter that is no ball off the part.
    Angle rear_lead() const;

    /// The pose between two rows of a pass, and whether the motion between two rows is right,
    /// apart from the contacts.
    struct Between {
        std::function<PassPose(const PassPose& from, const PassPose& to)> pose;
        std::function<bool(const ToolMotion& motion)> is_right;
    };

    /// The poses of a pass by `inclination_at`, as many as the tolerances need. For mode Field
    /// they are twice as close.
    std::vector<PassPose> rows(const PassLine& line) const;

    /// The rows with others between them, as many as the tolerances need.
    std::vector<PassPose> with_rows_between(const std::vector<PassPose>& rows,
                                            const PassLine& line,
                                            const Between& between) const;

    /// The place halfway between two rows.
    PassPlace place_between(const PassPose& from, const PassPose& to,
                            const PassLine& line) const;

private:
    // Limits of the motion between two rows.
    struct RowLimits {
        double way;          // mm
        double turn_cosine;  // of the greatest turn
    };

    Parameter across() const
    {
        return options_.along == Parameter::U ? Parameter::V : Parameter::U;
    }
    double along_of(const PassPose& pose) const
    {
        return options_.along == Parameter::U ? pose.place.at.u : pose.place.at.v;
    }
    RowLimits row_limits(double share) const;
    std::vector<double> examined() const;
    double reach(double across, const std::vector<double>& places) const;
    PassPose pose(double along, const PassLine& line) const;
    [[noreturn]] void throw_gouge(const PassPlace& place) const;
    std::vector<PassPose> filled(const std::vector<PassPose>& rows, const PassLine& line,
                                 const RowLimits& limits, const Between& between) const;
    bool is_fine(const PassPose& from, const PassPose& to, const PassLine& line,
                 const RowLimits& limits) const;

    const Surface& surface_;
    double side_;
    std::size_t number_;
    const Cutter& cutter_;
    const OrientedOptions& options_;
    double concave_radius_;  // mm, least one; infinity for a convex surface
};

}  // namespace endmill
