// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/part_samples.h"

#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/surface/nurbs.h"
#include "endmill/surface/tool_side.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using std::numbers::pi;

struct Sampled {
    std::vector<Surface> surfaces;
    std::vector<double> sides;
    PartSamples samples;

    Sampled(std::vector<Surface> all, double spacing)
        : surfaces{std::move(all)},
          sides{tool_side_signs(surfaces, Vec3::UnitZ())},
          samples{surfaces, sides, spacing, 1'000'000}
    {
    }
};

double area(const PartSamples& samples)
{
    double sum = 0;
    for (const Triangle& triangle : samples.triangles()) {
        const Vec3& a = samples.point(triangle[0]);
        sum += (samples.point(triangle[1]) - a)
                   .cross(samples.point(triangle[2]) - a)
                   .norm() /
               2;
    }
    return sum;
}

double border_length(const PartSamples& samples)
{
    double sum = 0;
    for (const auto& [a, b] : samples.border())
        sum += (samples.point(a) - samples.point(b)).norm();
    return sum;
}

TEST(PartSamples, CoverAPlane)
{
    const Sampled plane{{test::plane(20, 10, {2, 1})}, 1};
    EXPECT_NEAR(area(plane.samples), 200, 1e-9);
    EXPECT_NEAR(border_length(plane.samples), 60, 1e-9);
    for (std::size_t i = 0; i < plane.samples.size(); ++i) {
        EXPECT_NEAR((plane.samples.normal(i) - Vec3::UnitZ()).norm(), 0, 1e-12);
        for (const std::int32_t neighbour : plane.samples.neighbours(i))
            EXPECT_LE((plane.samples.point(i) - plane.samples.point(neighbour)).norm(),
                      1 + 1e-12);
    }
}

TEST(PartSamples, AreDenseOnSteepPlaces)
{
    const Sampled saddle{{test::saddle(15, 20)}, 0.7};
    for (const Triangle& triangle : saddle.samples.triangles())
        for (int k = 0; k < 3; ++k)
            EXPECT_LE((saddle.samples.point(triangle[k]) -
                       saddle.samples.point(triangle[(k + 1) % 3]))
                          .norm(),
                      0.7 + 1e-12);
}

TEST(PartSamples, JoinTheSeamOfAClosedSurface)
{
    const Sampled ring{{nurbs_surface(test::torus(20, 5, {0, 2 * pi, 0.2, pi - 0.2, 4}))},
                       0.8};
    // only the two circles at the ends of the inner angle remain
    const double expected = 2 * pi * (2 * 20 + 5 * std::cos(0.2) - 5 * std::cos(0.2));
    EXPECT_NEAR(border_length(ring.samples), expected, 0.01 * expected);
    std::size_t twins = 0;
    for (std::size_t i = 0; i < ring.samples.size(); ++i)
        twins += ring.samples.representative(i) != static_cast<std::int32_t>(i) ? 1 : 0;
    EXPECT_GT(twins, 10u);
}

TEST(PartSamples, ContactsLieOnTheSurface)
{
    const Sampled saddle{{test::saddle(15, 20)}, 1};
    const Triangle& triangle = saddle.samples.triangles()[7];
    const PassContact contact = saddle.samples.contact({triangle[0], triangle[1], 0.3});
    const Vec3& p = contact.at.contact.point;
    EXPECT_NEAR(saddle.surfaces[0].tangents(contact.at.u, contact.at.v).point.z(), p.z(),
                1e-12);
    EXPECT_NEAR(contact.at.contact.normal.norm(), 1, 1e-12);
}

TEST(PartSamples, AreLimited)
{
    const std::vector<Surface> surfaces{test::plane(20, 10)};
    const std::vector<double> sides{1};
    EXPECT_THROW((PartSamples{surfaces, sides, 0.1, 1000}), LimitError);
}

}  // namespace
}  // namespace endmill
