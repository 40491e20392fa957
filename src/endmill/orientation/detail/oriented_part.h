// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/machine/tool_motion.h"
#include "endmill/orientation/detail/axis_rules.h"
#include "endmill/orientation/inclination.h"
#include "endmill/orientation/oriented_options.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// A line on the part along which a pass runs: a parameter line of a surface, or a curve of
/// contacts on a mesh.
struct PassLine {
    double across;  ///< the parameter that does not change, or number of the curve
    bool is_forward = true;  ///< towards larger parameters
    double covered = 0;  ///< farthest parameter from `across` that its strip must cover
};

/// A contact of a pass.
struct PassPlace {
    SurfaceContact at;         ///< parameters, or x and y on a mesh; point and normal
    Vec3 feed = Vec3::Zero();  ///< unit, tangent to the part
    ContactCurvature curvature = {};  ///< along the feed and across
    double across = 0;                ///< mm per unit of the parameter across the feed
    double along = 0;                 ///< the parameter along the pass
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

/// The passes on one part, a surface or a mesh. Where they run is up to the kind of part; the
/// poses on them are the same for all.
class OrientedPart {
public:
    virtual ~OrientedPart() = default;

    /// The lines of all passes.
    /// \throws GeometryError if the cutter does not fit somewhere.
    virtual std::vector<PassLine> passes() const = 0;

    /// The place of a pass at a parameter along it.
    virtual PassPlace place(double along, const PassLine& line) const = 0;

    /// The inclination by modes Fixed and Lead; that which mode Field wants.
    /// \return nothing if the cutter does not fit with any lead.
    std::optional<Inclination> fitting_inclination(const PassPlace& place) const;

    /// The same.
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

    /// The name of a place in messages.
    virtual std::string name_of(const PassPlace& place) const = 0;

protected:
    /// \param cutter, options must outlive the object.
    /// \param concave_radius least radius of curvature in mm where the part is concave;
    ///        infinity for a convex part.
    OrientedPart(const Cutter& cutter, const OrientedOptions& options,
                 double concave_radius)
        : cutter_{cutter},
          options_{options},
          concave_radius_{concave_radius}
    {
    }
    OrientedPart(const OrientedPart&) = default;

    const Cutter& cutter() const { return cutter_; }
    const OrientedOptions& options() const { return options_; }

    /// The pose by `inclination_at`.
    PassPose pose(double along, const PassLine& line) const;

private:
    // Parameters along a line at which every pass has a row, rising.
    virtual std::vector<double> fixed_rows(const PassLine& line) const = 0;
    // Width in mm of the strip that a pass needs at a place.
    virtual double needed_strip(const PassPlace& place, const PassLine& line) const = 0;

    // Limits of the motion between two rows.
    struct RowLimits {
        double way;          // mm
        double turn_cosine;  // of the greatest turn
    };

    RowLimits row_limits(double share) const;
    [[noreturn]] void throw_gouge(const PassPlace& place) const;
    std::vector<PassPose> filled(const std::vector<PassPose>& rows, const PassLine& line,
                                 const RowLimits& limits, const Between& between) const;
    bool is_fine(const PassPose& from, const PassPose& to, const PassLine& line,
                 const RowLimits& limits) const;

    const Cutter& cutter_;
    const OrientedOptions& options_;
    double concave_radius_;  // mm
};

}  // namespace endmill
