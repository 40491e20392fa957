// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"

/// \file
/// How a tool leans at a contact, and what that does to the cut: the width of a strip, and the
/// least lead at which the cutter does not gouge.

namespace endmill {

/// How the tool axis leans against the normal of the part.
struct Inclination {
    Angle lead = Angle::radians(0);  ///< forward, in the direction of the feed
    Angle tilt = Angle::radians(0);  ///< to the left of the feed
};

/// The curvature of the part at a contact, in the directions of the feed f and of b = n x f,
/// where n is the normal. In 1/mm, positive where the part is convex.
struct ContactCurvature {
    double along = 0;   ///< normal curvature along f
    double across = 0;  ///< normal curvature along b
    double mixed = 0;   ///< of f and b
};

/// The tool axis at a contact: the unit vector along n + tan(lead) f + tan(tilt) b.
/// Source: docs/methods/five-axis-planning.md, section 1.
/// \param normal unit, out of the material.
/// \param feed   unit, perpendicular to the normal.
/// \param inclination both angles within -89 and 89 degrees.
Vec3 inclined_axis(const Vec3& normal, const Vec3& feed, const Inclination& inclination);

/// The curvature across the feed, in 1/mm, of what a pass leaves above the part. At the small
/// distance y from the pass this is half the curvature times y^2. With the tensors K of the
/// cutter and S of the part, D = K + S, it is det D / D_ff, or one over the component of the
/// inverse of D across the feed.
/// \return nothing if the cutter gouges the part beside the contact: D is not positive. Nothing
///         too for a flat bottom whose contact circle runs along the feed.
/// Source: docs/methods/five-axis-planning.md, section 2.
std::optional<double> remaining_curvature(const Cutter& cutter,
                                          const ContactCurvature& part,
                                          const Inclination& inclination);

/// The direction of the line beside the contact along which the moving cutter touches: mm along
/// the feed for each mm across, -D_fb / D_ff. A tilt makes one end of this line lag behind the
/// contact and the other one lead.
/// \return nothing as remaining_curvature.
/// Source: docs/methods/five-axis-planning.md, section 2.
std::optional<double> contact_skew(const Cutter& cutter, const ContactCurvature& part,
                                   const Inclination& inclination);

/// The width in mm of the strip that a pass cuts to the scallop height, 2 sqrt(2 h / kappa)
/// with the remaining curvature kappa; at most the diameter. Relative error below 0.01 for
/// strips that are narrow against the radii of curvature.
/// \param scallop_height h in mm, positive.
/// \return nothing as remaining_curvature.
std::optional<double> strip_width(const Cutter& cutter, const ContactCurvature& part,
                                  const Inclination& inclination, double scallop_height);

/// The least lead, without tilt, at which the cutter does not gouge the part beside the
/// contact: sin(lead) = (R - r) k / (1 - r k) with k = -S_bb + S_fb^2 / (1/r + S_ff); 0 if k is
/// not positive.
/// \return nothing if the cutter fits with no lead.
/// Source: docs/methods/five-axis-planning.md, section 3.
std::optional<Angle> least_lead(const Cutter& cutter, const ContactCurvature& part);

/// The lead, without tilt, at which the heel of the cutter does not gouge a part that stays
/// outside the ball of radius rho that touches it from the side of the tool: sin(lead) =
/// (R - r) / (rho - r).
/// \param concave_radius rho in mm, positive; infinity for a convex part.
/// \return nothing if the cutter fits with no lead.
/// Source: docs/methods/five-axis-planning.md, section 3.
std::optional<Angle> heel_lead(const Cutter& cutter, double concave_radius);

}  // namespace endmill
