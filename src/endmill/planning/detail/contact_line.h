// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"
#include "endmill/planning/detail/pass_march.h"
#include "endmill/surface/detail/iso_line.h"

namespace endmill {

/// The contacts of a ball along the line v = constant of a surface.
class ContactLine {
public:
    /// \param marched outlives this. \param direction tells an error's place.
    ContactLine(const MarchedSurface& marched, double v, Parameter direction);

    double v() const { return line_.v(); }              ///< the constant parameter
    Interval range() const { return line_.range(); }    ///< of u
    bool is_point() const { return line_.is_point(); }  ///< a pole

    Vec3 point(double u) const { return line_.point(u); }  ///< of the surface, mm

    /// The contact at u; on a collapsed edge with the limit of the normal.
    /// \throws GeometryError, with the place, where there is no normal.
    SurfaceContact at(double u) const;

private:
    const MarchedSurface* marched_;
    Parameter direction_;
    IsoLine line_;
};

/// Whether neither partial vanishes beside the other, by 1e-8, nor are they parallel: else
/// a normal can only be had as `limit_normal`.
bool has_plain_normal(const SurfaceTangents& tangents);

/// The contact at any place of the surface, as ContactLine::at.
SurfaceContact contact_at(const MarchedSurface& marched, const SurfacePoint& at,
                          Parameter direction);

/// The ball's centre when it touches `contact`, in mm.
inline Vec3 ball_centre(const SurfaceContact& contact, const BallCutter& cutter)
{
    return contact.contact.point + cutter.radius() * contact.contact.normal;
}

}  // namespace endmill
