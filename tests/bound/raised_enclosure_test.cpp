// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/raised_enclosure.h"

#include <random>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/bound/detail/raised_point.h"

namespace endmill {
namespace {

constexpr double height = 0.5;

// Every enclosure on small boxes contains the values at random places, on polynomial and
// rational patches; second derivatives are compared with differences.
TEST(RaisedEnclosure, ContainsTheRaisedSurfaceAtRandomPlaces)
{
    std::mt19937_64 engine{1};
    std::uniform_real_distribution<double> share{0, 1};
    for (const char* const name : {"saddle", "gaussian-bump", "torus", "net_rot24_7D"}) {
        const test::SidedSurfaces part = test::dataset(name);
        const Surface& surface = part.surfaces[0];
        const Interval u = surface.range(Parameter::U);
        const Interval v = surface.range(Parameter::V);
        for (int k = 0; k < 200; ++k) {
            const double half_u = 2e-3 * u.length();
            const double half_v = 2e-3 * v.length();
            const SurfacePoint at{std::lerp(u.low, u.high, share(engine)),
                                  std::lerp(v.low, v.high, share(engine))};
            const ContactPlace place = contact_place(part.part(), 0, at);
            const ParameterBox box{{at.u - half_u, at.u + half_u},
                                   {at.v - half_v, at.v + half_v}};
            const auto found = raised_enclosure(part.part(), place, box, height);
            ASSERT_TRUE(found);
            const auto jet_at = [&](double s, double t) {
                const SurfacePoint q{at.u + s * half_u, at.v + t * half_v};
                return contact_place(part.part(), 0, q).i == place.i &&
                               contact_place(part.part(), 0, q).j == place.j
                           ? std::optional{raised_jet(part.part(), 0, q, height)}
                           : std::nullopt;
            };
            const double s = 1.98 * share(engine) - 0.99;
            const double t = 1.98 * share(engine) - 0.99;
            constexpr double e = 1e-3;
            const auto here = jet_at(s, t);
            const auto next = jet_at(s + e, t);
            if (!here || !next)
                continue;
            for (int c = 0; c < 3; ++c) {
                const auto holds = [](const Interval& range, double value,
                                      double margin) {
                    const double far = margin * (1 + std::abs(value));
                    return range.low - far <= value && value <= range.high + far;
                };
                EXPECT_TRUE(holds(found->point[c], here->point[c], 1e-10));
                EXPECT_TRUE(holds(found->tangents[0][c], here->du[c], 1e-10));
                EXPECT_TRUE(holds(found->tangents[1][c], here->dv[c], 1e-10));
                EXPECT_TRUE(holds(found->surface[1][c], here->surface_dv[c], 1e-10));
                EXPECT_TRUE(holds(found->seconds[0][c],
                                  (next->du[c] - here->du[c]) / (e * half_u), 1e-5));
                EXPECT_TRUE(holds(found->seconds[1][c],
                                  (next->dv[c] - here->dv[c]) / (e * half_u), 1e-5));
                EXPECT_TRUE(holds(found->normal[0][c],
                                  (here->du[c] - here->surface_du[c]) * part.sides[0] /
                                      height * part.sides[0],
                                  1e-9));
            }
            EXPECT_LE(found->area.low, here->area * (1 + 1e-12));
            EXPECT_GE(found->area.high, here->area * (1 - 1e-12));
        }
    }
}

TEST(RaisedEnclosure, IsNothingAtACollapsedEdge)
{
    const std::vector<Vec3> net{{0, 0, 0}, {0, 0, 0}, {0, 10, 0}, {10, 10, 0}};
    const std::vector<Surface> surfaces{
        Surface{{0, 1}, {0, 1}, {BezierPatch{1, 1, net}}, ToolSide::DuCrossDv}};
    const std::vector<double> sides{1};
    const BoundedPart part{surfaces, sides};
    EXPECT_FALSE(
        raised_enclosure(part, {0, 0, 0, {0.5, 0}}, {{0.4, 0.6}, {0, 0.1}}, height));
    EXPECT_TRUE(
        raised_enclosure(part, {0, 0, 0, {0.5, 0.5}}, {{0.4, 0.6}, {0.4, 0.6}}, height));
}

}  // namespace
}  // namespace endmill
