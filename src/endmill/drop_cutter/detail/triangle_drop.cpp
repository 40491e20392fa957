// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/triangle_drop.h"

#include "endmill/core/detail/exact_arithmetic.h"
#include "endmill/core/tolerance.h"
#include "endmill/drop_cutter/detail/triangle_lowering.h"

namespace endmill {
namespace {

template <typename Real>
std::array<AxisPlace<Real>, 3> around_axis(const std::array<Vec3, 3>& corners, double x,
                                           double y)
{
    std::array<AxisPlace<Real>, 3> places;
    for (int k = 0; k < 3; ++k)
        places[k] = {Real{corners[k].x()} - Real{x}, Real{corners[k].y()} - Real{y},
                     Real{corners[k].z()}};
    return places;
}

// The contact computed with twice the digits. It is rarely needed and kept out of line.
[[gnu::noinline]] TriangleContact careful_contact(const Cutter& cutter,
                                                  const std::array<Vec3, 3>& corners,
                                                  double x, double y, double least)
{
    const DoubleDouble R{cutter.radius()};
    const DoubleDouble r{cutter.corner_radius()};
    const CutterShape<DoubleDouble> shape{R, r, R - r};
    TriangleLowering<DoubleDouble> lowering{shape, least};
    lowering.lower_onto(around_axis<DoubleDouble>(corners, x, y));
    return lowering.contact(x, y);
}

}  // namespace

TriangleDrop::TriangleDrop(const Cutter& cutter) : cutter_{cutter} {}

TriangleContact TriangleDrop::operator()(const std::array<Vec3, 3>& corners, double x,
                                         double y, double least) const
{
    if (cutter_.is_ball()) {
        const auto highest = highest_corner(corners, x, y, cutter_.radius());
        if (highest && highest->bound + tip_accuracy < least)
            return {};
        if (highest && !(highest->bound > highest->tip_z))
            return {highest->tip_z, corners[highest->corner], TouchKind::Vertex};
    }
    const CutterShape<double> shape{cutter_.radius(), cutter_.corner_radius(),
                                    cutter_.flat_radius()};
    TriangleLowering<double> lowering{shape, least};
    lowering.lower_onto(around_axis<double>(corners, x, y));
    if (lowering.is_doubtful())
        return careful_contact(cutter_, corners, x, y, least);
    return lowering.contact(x, y);
}

}  // namespace endmill
