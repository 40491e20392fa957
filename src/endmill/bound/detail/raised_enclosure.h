// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "endmill/bound/detail/contact_frame.h"
#include "endmill/bound/detail/interval_series.h"

namespace endmill {

/// A box of parameters.
struct ParameterBox {
    Interval u;  ///< parameters
    Interval v;  ///< parameters
};

/// Enclosures of a vector.
using IntervalVector = std::array<Interval, 3>;

/// Enclosures of a raised surface over a box of its parameters. Derivatives are in mm per
/// unit of the parameters; second ones are in the order uu, uv, vv.
struct RaisedEnclosure {
    IntervalVector point;                          ///< y = q + h N, mm
    std::array<IntervalVector, 2> tangents;        ///< of y
    std::array<IntervalVector, 3> seconds;         ///< of y
    std::array<IntervalVector, 2> surface;         ///< first derivatives of q
    std::array<IntervalVector, 3> surface_second;  ///< second derivatives of q
    std::array<IntervalVector, 2> normal;          ///< first derivatives of N
    Interval area;                                 ///< |q_u x q_v|
    std::array<Interval, 2> area_slope;            ///< its derivatives
};

/// The enclosures over a box of one patch, whose polynomial is extrapolated beyond it. They
/// come from the Taylor expansion of the patch about the middle of the box, which is finite
/// for polynomials, by interval arithmetic.
/// \param part surfaces and sides.
/// \param place the surface, and the patch (i, j); `at` is ignored.
/// \param box of global parameters.
/// \param height h in mm.
/// \return nothing where the box may contain a place without a normal.
std::optional<RaisedEnclosure> raised_enclosure(const BoundedPart& part,
                                                const ContactPlace& place,
                                                const ParameterBox& box, double height);

}  // namespace endmill
