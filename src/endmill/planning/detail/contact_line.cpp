// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/contact_line.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Length of a partial, as a share of the other one, below which its rounding errors
// dominate its direction. The limit of the normal is used then.
constexpr double vanishing_share = 1e-8;

// The contact at `at`, with the normal from the partials where they determine it,
// otherwise with the limit from the second derivatives. `jet` returns them; it is called
// only then.
template <class WholeJet>
SurfaceContact contact_of(const MarchedSurface& marched, const SurfacePoint& at,
                          const SurfaceTangents& tangents, Parameter direction,
                          const WholeJet& jet)
{
    if (has_plain_normal(tangents)) {
        const Vec3 normal = tangents.du.cross(tangents.dv).normalized();
        return {at.u, at.v, {tangents.point, marched.side * normal}};
    }
    const auto inward = [&](Parameter along, double parameter) {
        return parameter < marched.surface.range(along).high ? 1 : -1;
    };
    const auto normal =
        limit_normal(jet(), {inward(Parameter::U, at.u), inward(Parameter::V, at.v)});
    if (!normal)
        throw GeometryError{"the surface has no normal at " +
                            place_text(in_surface_order(at, direction), tangents.point)};
    return {at.u, at.v, {tangents.point, marched.side * *normal}};
}

}  // namespace

bool has_plain_normal(const SurfaceTangents& tangents)
{
    const double du2 = tangents.du.squaredNorm();
    const double dv2 = tangents.dv.squaredNorm();
    return std::min(du2, dv2) > vanishing_share * vanishing_share * std::max(du2, dv2) &&
           !is_singular(tangents);
}

ContactLine::ContactLine(const MarchedSurface& marched, double v, Parameter direction)
    : marched_{&marched},
      direction_{direction},
      line_{marched.surface, v}
{
}

SurfaceContact ContactLine::at(double u) const
{
    const SurfaceJet jet = line_.jet(u);
    return contact_of(*marched_, {u, line_.v()}, {jet.point, jet.du, jet.dv}, direction_,
                      [&] { return jet; });
}

SurfaceContact contact_at(const MarchedSurface& marched, const SurfacePoint& at,
                          Parameter direction)
{
    return contact_of(marched, at, marched.surface.tangents(at.u, at.v), direction,
                      [&] { return marched.surface.jet(at.u, at.v); });
}

SurfaceContact offset_contact(SurfaceContact contact, double offset)
{
    if (offset != 0)
        contact.contact.point += offset * contact.contact.normal;
    return contact;
}

}  // namespace endmill
