// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/detail/marched_surface.h"
#include "endmill/surface/detail/iso_line.h"

namespace endmill {

/// The contacts of a ball along the line v = constant of a surface.
class ContactLine {
public:
    /// \param marched   the surface; must outlive the line.
    /// \param v         the constant parameter.
    /// \param direction for the parameters in an error message, see in_surface_order.
    ContactLine(const MarchedSurface& marched, double v, Parameter direction);

    double v() const { return line_.v(); }              ///< the constant parameter
    Interval range() const { return line_.range(); }    ///< of u
    bool is_point() const { return line_.is_point(); }  ///< whether the line is a pole

    Vec3 point(double u) const { return line_.point(u); }  ///< of the surface, mm

    /// The contact at u. On a collapsed edge its normal is the limit from inside the
    /// surface.
    /// \throws GeometryError with the place where there is no normal.
    SurfaceContact at(double u) const;

private:
    const MarchedSurface* marched_;
    Parameter direction_;
    IsoLine line_;
};

/// Whether the partials determine a normal: neither is shorter than 1e-8 of the other,
/// and they are not parallel. Otherwise the normal has to be computed by `limit_normal`.
bool has_plain_normal(const SurfaceTangents& tangents);

/// The contact at any place of the surface, see ContactLine::at.
/// \param marched   the surface.
/// \param at        parameters.
/// \param direction for the parameters in an error message.
/// \throws GeometryError with the place where there is no normal.
SurfaceContact contact_at(const MarchedSurface& marched, const SurfacePoint& at,
                          Parameter direction);

/// A contact moved along its normal by `offset` mm, of either sign. Its point then lies
/// off the surface; its parameters stay.
SurfaceContact offset_contact(SurfaceContact contact, double offset);

/// Centre of the ball in mm when the ball touches `contact`.
inline Vec3 ball_centre(const SurfaceContact& contact, const BallCutter& cutter)
{
    return contact.contact.point + cutter.radius() * contact.contact.normal;
}

}  // namespace endmill
