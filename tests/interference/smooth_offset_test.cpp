// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/smooth_offset.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

const DriveFrame along_x{Angle::degrees(0)};

std::vector<Surface> bowl()
{
    const test::Polynomial height =
        test::monomial(2, 0, 0.02) + test::monomial(0, 2, 0.01) +
        test::monomial(1, 1, 0.013) + test::monomial(1, 0, 0.2);
    return {test::graph(height, {{-10, 11}, {-9, 12}}, {2, 1})};
}

// How many triangles of the mesh lead back, from each end of their first edge, to where
// that vertex was sampled: a vertex lies on the smooth offset, so that the height over its
// own place is its own.
struct Recovered {
    int found = 0;
    int none = 0;
    double greatest_error = 0;
};

Recovered recovered(const OffsetMesh& offset, const std::vector<Surface>& part, int grid,
                    std::size_t first, std::size_t last)
{
    const SmoothOffset smooth{offset, part, grid};
    Recovered result;
    for (std::size_t t = first; t < last; t += 7) {
        const auto& [a, b, c] = offset.mesh.triangles()[t];
        for (const double share : {0.0, 1.0}) {
            const Vec3& vertex =
                offset.mesh.points()[static_cast<std::size_t>(share == 0 ? a : b)];
            const auto start = smooth.start({a, b}, share, c);
            const auto z = start
                               ? height_on_sheet(*start, along_x, vertex.x(), vertex.y())
                               : std::nullopt;
            if (!z) {
                ++result.none;
                continue;
            }
            ++result.found;
            result.greatest_error =
                std::max(result.greatest_error, std::abs(*z - vertex.z()));
        }
    }
    return result;
}

TEST(SmoothOffset, LeadsBackToTheVerticesOfItsSheets)
{
    const std::vector<Surface> part = bowl();
    for (const Cutter& cutter : {Cutter::ball(4), Cutter{4, 1}, Cutter::flat(4)}) {
        const OffsetMesh offset = offset_mesh(part, cutter, {.grid_lines = 15});
        const Recovered result = recovered(offset, part, 15, 0, offset.sheet_triangles);
        EXPECT_GT(result.found, 20 * (result.none + 1) / 2);
        EXPECT_LT(result.greatest_error, 1e-7);
    }
}

TEST(SmoothOffset, LeadsBackToTheVerticesOfItsStrips)
{
    const std::vector<Surface> part = bowl();
    const OffsetMesh offset = offset_mesh(part, Cutter::ball(4), {.grid_lines = 15});
    const Recovered result =
        recovered(offset, part, 15, offset.own_triangles, offset.mesh.triangles().size());
    // None over corners, where most of the triangles are, nor at the upright rim.
    EXPECT_GT(result.found, 1000);
    EXPECT_LT(result.greatest_error, 1e-7);
}

TEST(SmoothOffset, TurnsAboutCreases)
{
    const std::vector<Surface> part{test::valley(10, 20, -0.5)};  // a ridge
    const OffsetMesh offset = offset_mesh(part, Cutter::ball(4), {.grid_lines = 12});
    ASSERT_GT(offset.own_triangles, offset.sheet_triangles);
    const Recovered result =
        recovered(offset, part, 12, offset.sheet_triangles, offset.own_triangles);
    EXPECT_GT(result.found, 0);
    EXPECT_LT(result.greatest_error, 1e-7);
}

}  // namespace
}  // namespace endmill
