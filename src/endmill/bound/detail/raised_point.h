// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/bound/detail/contact_frame.h"

namespace endmill {

/// A surface point raised by the scallop height along its normal, with first derivatives.
struct RaisedJet {
    Vec3 point;   ///< y = q + h N, mm
    Vec3 du;      ///< of y, mm per unit of u
    Vec3 dv;      ///< of y, mm per unit of v
    double area;  ///< |q_u x q_v|, mm^2 per unit of u and unit of v; 0 without a normal
    Vec3 surface_du;  ///< of q
    Vec3 surface_dv;  ///< of q
};

/// The raised point at parameters of a surface of `part`.
/// \param part surfaces and sides.
/// \param surface number of the surface.
/// \param at parameters; at a border of patches those of the patch above it.
/// \param height h in mm.
RaisedJet raised_jet(const BoundedPart& part, std::size_t surface, const SurfacePoint& at,
                     double height);

/// The raised point and the area element alone, without second derivatives.
struct RaisedPlace {
    Vec3 point;   ///< y, mm; the surface point itself where there is no normal
    double area;  ///< as in RaisedJet
};

/// As `raised_jet`, faster.
RaisedPlace raised_place(const BoundedPart& part, std::size_t surface,
                         const SurfacePoint& at, double height);

}  // namespace endmill
